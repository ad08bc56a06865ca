//! The sensors of one map's scenes: places that a rig names become places of the map.

use super::resolve::every;
use crate::{MapCatalog, PlanError};
use endless_dataset::{ModelSpec, MountSpec, Origin, Recipe, SensorSpec};
use endless_road::JunctionPlace;
use endless_world::{
    CameraLook, CameraSite, Carrier, ImageSize, LensModel, ObjectClass, Placement, RecorderClock, RigCamera,
    RigEventCamera, SceneSensor, SensorModel, SensorMount, Stream, TimeOfDay, WayPoint, math,
};

/// Where the sensors of a rig are on one map.
pub(crate) struct RigPlaces {
    places: Vec<SensorPlace>,
}

struct SensorPlace {
    mount: SensorMount,
    /// Of the camera site at which it hangs, radians.
    site_fov_rad: Option<f64>,
}

/// Least height above the ground, metres.
const CLEAR_M: f64 = 0.05;

impl RigPlaces {
    /// On a map with these camera sites.
    ///
    /// # Errors
    /// When the map has no such site or no junction, or a place lies under ground.
    pub(crate) fn new(
        recipe: &Recipe,
        map: &str,
        sites: &[CameraSite],
        catalog: &(impl MapCatalog + ?Sized),
    ) -> Result<Self, PlanError> {
        let asks = recipe.sensor.iter().any(|sensor| names_junction(&sensor.mount));
        let junction = if asks { catalog.largest_junction(map)? } else { None };
        let finder = PlaceFinder { map, sites, junction };
        let places = recipe.sensor.iter().map(|sensor| finder.place(sensor)).collect::<Result<Vec<_>, _>>()?;
        for (sensor, place) in recipe.sensor.iter().zip(&places) {
            let fixed = fixed_places(&place.mount);
            let above: Vec<[f64; 2]> = fixed.iter().map(|[x, y, _]| [*x, *y]).collect();
            for ([x, y, z], ground) in fixed.iter().zip(catalog.ground(map, &above)?) {
                if let Some(ground) = ground.filter(|ground| *z < ground + CLEAR_M) {
                    let problem = format!(
                        "{x:.2}, {y:.2}, {z:.2} m is under ground: write a height above {:.2} m",
                        ground + CLEAR_M
                    );
                    return Err(finder.wrong(sensor, problem));
                }
            }
        }
        Ok(Self { places })
    }
}

/// Whether a place is told from the largest junction.
fn names_junction(mount: &MountSpec) -> bool {
    match mount {
        MountSpec::Junction { .. } => true,
        MountSpec::Pose { from, .. }
        | MountSpec::Orbit { from, .. }
        | MountSpec::WayPoints { from, .. }
        | MountSpec::PanTiltZoom { from, .. } => *from == Origin::Junction,
        MountSpec::Site { .. } | MountSpec::Vehicle { .. } | MountSpec::Pedestrian { .. } => false,
    }
}

/// Places of the world at which a sensor is at some time, metres.
fn fixed_places(mount: &SensorMount) -> Vec<[f64; 3]> {
    match mount {
        SensorMount::Still { at } => vec![at.position],
        SensorMount::Carried { .. } => Vec::new(),
        SensorMount::Way { points } => points.iter().map(|point| point.at.position).collect(),
        SensorMount::Orbit { centre, radius_m, height_m, .. } => {
            let around = |eighth: u32| {
                let (sin, cos) = math::f64::sin_cos(f64::from(eighth) * std::f64::consts::FRAC_PI_4);
                [centre[0] + radius_m * cos, centre[1] + radius_m * sin, centre[2] + height_m]
            };
            (0..8).map(around).collect()
        }
    }
}

/// Finds places on one map.
struct PlaceFinder<'a> {
    map: &'a str,
    sites: &'a [CameraSite],
    junction: Option<JunctionPlace>,
}

impl PlaceFinder<'_> {
    fn wrong(&self, sensor: &SensorSpec, problem: String) -> PlanError {
        PlanError::Rig { sensor: sensor.name.clone(), map: self.map.to_owned(), problem }
    }

    fn place(&self, sensor: &SensorSpec) -> Result<SensorPlace, PlanError> {
        let mut site_fov_rad = None;
        let mount = match &sensor.mount {
            MountSpec::Site { site } => {
                let site = self.site(sensor, site)?;
                site_fov_rad = Some(f64::from(site.horizontal_fov_rad));
                SensorMount::Still { at: placement_of(site) }
            }
            MountSpec::Pose { from, at, yaw, pitch, roll } => {
                let position = self.moved(sensor, *from, *at)?;
                SensorMount::Still { at: placement(position, [*yaw, *pitch, *roll]) }
            }
            MountSpec::Junction { corner, height, yaw, pitch } => {
                let JunctionPlace { centre, corners } = self.junction(sensor)?;
                let [x, y, z] = corners[*corner as usize].to_array();
                let position = [x, y, z + height];
                let towards = looking_at(position, centre.to_array());
                let yaw_rad = yaw.map_or(towards.yaw_rad, f64::to_radians);
                let pitch_rad = pitch.map_or(towards.pitch_rad, f64::to_radians);
                SensorMount::Still { at: Placement { yaw_rad, pitch_rad, ..towards } }
            }
            MountSpec::Vehicle { class, number, at, yaw, pitch, roll } => SensorMount::Carried {
                by: Carrier { class: class.object_class(), number: *number },
                at: placement(*at, [*yaw, *pitch, *roll]),
            },
            MountSpec::Pedestrian { number, at, yaw, pitch, roll } => SensorMount::Carried {
                by: Carrier { class: Some(ObjectClass::Pedestrian), number: *number },
                at: placement(*at, [*yaw, *pitch, *roll]),
            },
            MountSpec::Orbit { from, centre: [x, y], radius, height, period, begin } => SensorMount::Orbit {
                centre: self.moved(sensor, *from, [*x, *y, 0.0])?,
                radius_m: *radius,
                height_m: *height,
                period_s: *period,
                begin_rad: begin.to_radians(),
            },
            MountSpec::WayPoints { from, points } => {
                let point = |point: &endless_dataset::WayPointSpec| {
                    let position = self.moved(sensor, *from, point.at)?;
                    let at = placement(position, [point.yaw, point.pitch, point.roll]);
                    Ok(WayPoint { time_s: point.time, at, horizontal_fov_rad: None })
                };
                SensorMount::Way { points: points.iter().map(point).collect::<Result<_, PlanError>>()? }
            }
            MountSpec::PanTiltZoom { site, from, at, keys } => {
                let position = match (site, at) {
                    (Some(site), _) => {
                        let site = self.site(sensor, site)?;
                        site_fov_rad = Some(f64::from(site.horizontal_fov_rad));
                        site.position.map(f64::from)
                    }
                    (None, at) => self.moved(sensor, *from, at.unwrap_or_default())?,
                };
                let point = |key: &endless_dataset::PanTiltZoomKey| WayPoint {
                    time_s: key.time,
                    at: placement(position, [key.yaw, key.pitch, 0.0]),
                    horizontal_fov_rad: key.fov.map(f64::to_radians),
                };
                SensorMount::Way { points: keys.iter().map(point).collect() }
            }
        };
        Ok(SensorPlace { mount, site_fov_rad })
    }

    fn site(&self, sensor: &SensorSpec, name: &str) -> Result<&CameraSite, PlanError> {
        self.sites.iter().find(|site| site.name == name).ok_or_else(|| {
            let known: Vec<&str> = self.sites.iter().map(|site| site.name.as_str()).collect();
            self.wrong(sensor, format!("there is no camera site '{name}': use one of {}", known.join(", ")))
        })
    }

    fn junction(&self, sensor: &SensorSpec) -> Result<JunctionPlace, PlanError> {
        self.junction.ok_or_else(|| self.wrong(sensor, "the map has no junction: write a place of the map".to_owned()))
    }

    /// A position of the world.
    fn moved(&self, sensor: &SensorSpec, from: Origin, [x, y, z]: [f64; 3]) -> Result<[f64; 3], PlanError> {
        let origin = match from {
            Origin::Map => [0.0; 3],
            Origin::Junction => self.junction(sensor)?.centre.to_array(),
        };
        Ok([origin[0] + x, origin[1] + y, origin[2] + z])
    }
}

fn placement(position: [f64; 3], degrees: [f64; 3]) -> Placement {
    let [yaw_rad, pitch_rad, roll_rad] = degrees.map(f64::to_radians);
    Placement { position, yaw_rad, pitch_rad, roll_rad }
}

/// Where a camera of a site is.
fn placement_of(site: &CameraSite) -> Placement {
    Placement {
        position: site.position.map(f64::from),
        yaw_rad: f64::from(site.yaw_rad),
        pitch_rad: -f64::from(site.down_tilt_rad),
        roll_rad: f64::from(site.roll_rad),
    }
}

/// At a position, towards a point.
fn looking_at(position: [f64; 3], point: [f64; 3]) -> Placement {
    let [x, y, z] = [0, 1, 2].map(|axis| point[axis] - position[axis]);
    let yaw_rad = math::f64::atan2(y, x);
    Placement { position, yaw_rad, pitch_rad: math::f64::atan2(z, (x * x + y * y).sqrt()), roll_rad: 0.0 }
}

/// The sensors of a video on the map of these places.
pub(crate) fn scene_sensors(
    recipe: &Recipe,
    places: &RigPlaces,
    video: u32,
    time_of_day: TimeOfDay,
    clock: RecorderClock,
) -> Vec<SceneSensor> {
    let sensor = |((spec, place), number): ((&SensorSpec, &SensorPlace), u64)| {
        let model = match &spec.model {
            ModelSpec::EventCamera(camera) => {
                let lens = lens_of(camera.fov, camera.lens, camera.image_size().unwrap_or(recipe.size), place);
                SensorModel::EventCamera(RigEventCamera { camera: lens, settings: camera.settings })
            }
            ModelSpec::Lidar(lidar) => SensorModel::Lidar(lidar.settings.clone()),
            ModelSpec::Radar(radar) => SensorModel::Radar(radar.clone()),
            ModelSpec::Imu(imu) => SensorModel::Imu(*imu),
            ModelSpec::Gnss(gnss) => SensorModel::Gnss(*gnss),
            ModelSpec::Collision => SensorModel::Collision,
            ModelSpec::LaneInvasion => SensorModel::LaneInvasion,
            ModelSpec::Camera(camera) => {
                let mut random = Stream::named(recipe.seed, "rig camera look", &[u64::from(video), number]);
                let look = camera.look.unwrap_or(recipe.camera_look);
                SensorModel::Camera(RigCamera {
                    look: CameraLook::new(look, time_of_day, clock, &mut random),
                    ..lens_of(camera.fov, camera.lens, camera.image_size().unwrap_or(recipe.size), place)
                })
            }
        };
        let every = every(spec.rate.unwrap_or(recipe.fps), recipe.fps).expect("the recipe was resolved");
        SceneSensor { name: spec.name.clone(), every, mount: place.mount.clone(), model }
    };
    recipe.sensor.iter().zip(&places.places).zip(0..).map(sensor).collect()
}

/// A camera without effects.
fn lens_of(fov_deg: Option<f64>, lens: Option<LensModel>, size: ImageSize, place: &SensorPlace) -> RigCamera {
    let fov = fov_deg.map(f64::to_radians).or(place.site_fov_rad);
    RigCamera {
        size,
        horizontal_fov_rad: fov.expect("a camera has a field of view of its own or of its site"),
        lens: lens.unwrap_or_default(),
        look: CameraLook::CLEAN,
    }
}
