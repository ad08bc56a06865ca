//! Checks a rig, and fills what follows from the recipe.

use crate::RecipeError;
use endless_dataset::{CameraSpec, EventCameraSpec, Layer, ModelSpec, MountSpec, OptionError, Recipe, SensorSpec};
use endless_world::{ImageSize, LensModel};

/// Most sensors of a rig.
const MOST_SENSORS: usize = 64;
/// Longest name.
const NAME: usize = 64;
/// Furthest from the map's origin, metres.
const FAR_M: f64 = 20_000.0;
/// Furthest from the middle of what carries a sensor, metres.
const FAR_FROM_CARRIER_M: f64 = 20.0;
/// Largest difference of a rate from a divisor of the frames a second, as a share.
const SAME_RATE: f64 = 1e-6;
/// Horizontal field of view where none is given, degrees: a surveillance camera's.
const USUAL_FOV_DEG: f64 = 70.0;

/// What cannot be of a rig.
struct Wrong<'a>(&'a SensorSpec);

impl Wrong<'_> {
    fn value(&self, what: &str, given: impl std::fmt::Display, rule: &str) -> RecipeError {
        RecipeError::Option(OptionError::OutOfRange {
            field: "sensor",
            given: format!("{what} = {given} ({})", self.0.name),
            rule: rule.to_owned(),
        })
    }

    fn within(&self, what: &str, value: f64, least: f64, most: f64) -> Result<(), RecipeError> {
        // NaN is in no range.
        if (least..=most).contains(&value) {
            return Ok(());
        }
        Err(self.value(what, value, &format!("write a number from {least} to {most}")))
    }
}

/// The sensors of a recipe, checked, with what follows from the rest of it.
///
/// # Errors
/// The first thing that cannot be.
pub(crate) fn resolve(recipe: &Recipe) -> Result<Vec<SensorSpec>, RecipeError> {
    let mut sensors: Vec<SensorSpec> = Vec::with_capacity(recipe.sensor.len());
    for sensor in &recipe.sensor {
        let wrong = Wrong(sensor);
        check_name(&wrong, sensors.len())?;
        if sensors.iter().any(|other| other.name == sensor.name) {
            return Err(wrong.value("name", &sensor.name, "another sensor has it already"));
        }
        let rate = sensor.rate.unwrap_or(recipe.fps);
        every(rate, recipe.fps).ok_or_else(|| {
            let rule = format!("write a divisor of the {} frames a second", recipe.fps);
            wrong.value("rate", rate, &rule)
        })?;
        check_mount(&wrong, recipe)?;
        let model = match &sensor.model {
            ModelSpec::Camera(camera) => ModelSpec::Camera(camera_of(&wrong, camera, recipe)?),
            ModelSpec::EventCamera(camera) => ModelSpec::EventCamera(event_camera_of(&wrong, camera, recipe)?),
            other => {
                check_model(&wrong, other)?;
                other.clone()
            }
        };
        sensors.push(SensorSpec { rate: Some(rate), model, ..sensor.clone() });
    }
    Ok(sensors)
}

/// At every so many frames a sensor of this rate measures; `None` if that is no whole number.
pub(super) fn every(rate: f64, fps: f64) -> Option<u32> {
    let every = (fps / rate).round();
    let whole = rate > 0.0 && (1.0..=1e6).contains(&every) && (every * rate / fps - 1.0).abs() <= SAME_RATE;
    whole.then_some(every as u32)
}

fn check_name(wrong: &Wrong<'_>, before: usize) -> Result<(), RecipeError> {
    let name = &wrong.0.name;
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if name.is_empty() || name.len() > NAME || !name.chars().all(plain) {
        return Err(wrong.value("name", name, "a name has 1 to 64 letters, digits, _ and -"));
    }
    if name.starts_with("camera_") && name.len() == "camera_a".len() {
        return Err(wrong.value("name", name, "this is the folder of a camera of the scene"));
    }
    if before >= MOST_SENSORS {
        return Err(wrong.value("name", name, &format!("a rig has at most {MOST_SENSORS} sensors")));
    }
    Ok(())
}

fn check_mount(wrong: &Wrong<'_>, recipe: &Recipe) -> Result<(), RecipeError> {
    let angles = |yaw: f64, pitch: f64, roll: f64| {
        wrong.within("yaw", yaw, -360.0, 360.0)?;
        wrong.within("pitch", pitch, -90.0, 90.0)?;
        wrong.within("roll", roll, -180.0, 180.0)
    };
    let place = |at: &[f64], far: f64| at.iter().try_for_each(|&value| wrong.within("at", value, -far, far));
    let counted = recipe.traffic_file.is_none();
    match &wrong.0.mount {
        MountSpec::Site { .. } => Ok(()),
        MountSpec::Pose { at, yaw, pitch, roll, .. } => {
            place(at, FAR_M)?;
            angles(*yaw, *pitch, *roll)
        }
        MountSpec::Junction { corner, height, yaw, pitch } => {
            if *corner > 3 {
                return Err(wrong.value("corner", corner, "write 0, 1, 2 or 3"));
            }
            wrong.within("height", *height, 0.1, 200.0)?;
            angles(yaw.unwrap_or(0.0), pitch.unwrap_or(0.0), 0.0)
        }
        MountSpec::Vehicle { number, at, yaw, pitch, roll, .. } => {
            if counted && recipe.density.vehicles.is_none() && *number >= recipe.vehicles {
                let rule = format!("the recipe has {} vehicles, and counting begins at 0", recipe.vehicles);
                return Err(wrong.value("number", number, &rule));
            }
            place(at, FAR_FROM_CARRIER_M)?;
            angles(*yaw, *pitch, *roll)
        }
        MountSpec::Pedestrian { number, at, yaw, pitch, roll } => {
            if counted && recipe.density.pedestrians.is_none() && *number >= recipe.pedestrians {
                let rule = format!("the recipe has {} pedestrians, and counting begins at 0", recipe.pedestrians);
                return Err(wrong.value("number", number, &rule));
            }
            place(at, FAR_FROM_CARRIER_M)?;
            angles(*yaw, *pitch, *roll)
        }
        MountSpec::Orbit { centre, radius, height, period, begin, .. } => {
            place(centre, FAR_M)?;
            wrong.within("radius", *radius, 0.0, FAR_M)?;
            wrong.within("height", *height, 1.0, FAR_M)?;
            wrong.within("period", period.abs(), 0.1, 1e6)?;
            wrong.within("begin", *begin, -360.0, 360.0)
        }
        MountSpec::WayPoints { points, .. } => {
            check_times(wrong, "points", points.iter().map(|point| point.time))?;
            points.iter().try_for_each(|point| {
                place(&point.at, FAR_M)?;
                angles(point.yaw, point.pitch, point.roll)
            })
        }
        MountSpec::PanTiltZoom { site, at, keys, .. } => {
            if site.is_some() == at.is_some() {
                return Err(wrong.value("mount", "pan_tilt_zoom", "give either site or at"));
            }
            place(at.as_ref().map_or(&[][..], |at| &at[..]), FAR_M)?;
            check_times(wrong, "keys", keys.iter().map(|key| key.time))?;
            keys.iter().try_for_each(|key| {
                key.fov.map_or(Ok(()), |fov| wrong.within("fov", fov, 1.0, 150.0))?;
                angles(key.yaw, key.pitch, 0.0)
            })
        }
    }
}

/// Times go up, and there is one.
fn check_times(wrong: &Wrong<'_>, what: &str, times: impl Iterator<Item = f64>) -> Result<(), RecipeError> {
    let times: Vec<f64> = times.collect();
    if times.is_empty() {
        return Err(wrong.value(what, "[]", "write at least one"));
    }
    times.iter().try_for_each(|&time| wrong.within("time", time, 0.0, 1e7))?;
    match times.windows(2).find(|pair| pair[1] <= pair[0]) {
        Some(pair) => Err(wrong.value("time", pair[1], &format!("write one after {}", pair[0]))),
        None => Ok(()),
    }
}

/// Sensors without a lens.
fn check_model(wrong: &Wrong<'_>, model: &ModelSpec) -> Result<(), RecipeError> {
    let settings = |checked: Result<(), String>| {
        checked.map_err(|problem| RecipeError::Sensor { sensor: wrong.0.name.clone(), problem })
    };
    match model {
        ModelSpec::Lidar(lidar) if lidar.formats.is_empty() => {
            Err(wrong.value("formats", "[]", "name at least one of kitti, ply, pcd"))
        }
        ModelSpec::Lidar(lidar) => settings(lidar.settings.check()),
        ModelSpec::Radar(radar) => settings(radar.check()),
        ModelSpec::Imu(imu) => settings(imu.check()),
        ModelSpec::Gnss(gnss) => settings(gnss.check()),
        ModelSpec::Collision | ModelSpec::LaneInvasion => match wrong.0.mount {
            MountSpec::Vehicle { .. } => Ok(()),
            MountSpec::Pedestrian { .. } if *model == ModelSpec::Collision => Ok(()),
            _ => Err(wrong.value("type", model.type_name(), "mount it on a vehicle")),
        },
        ModelSpec::Camera(_) | ModelSpec::EventCamera(_) => Ok(()),
    }
}

/// The size of a camera's pictures, as it is given or as all have it.
fn size_of(wrong: &Wrong<'_>, given: Option<&String>, recipe: &Recipe) -> Result<ImageSize, RecipeError> {
    let Some(text) = given else { return Ok(recipe.size) };
    let side = 1..=8192;
    let size: Option<ImageSize> = text.parse().ok();
    let size = size.filter(|size| side.contains(&size.width) && side.contains(&size.height));
    size.ok_or_else(|| wrong.value("size", text, "write WIDTHxHEIGHT, each from 1 to 8192"))
}

/// The field of view of a camera, degrees; `None` for that of its site.
fn fov_of(wrong: &Wrong<'_>, given: Option<f64>, lens: LensModel) -> Result<Option<f64>, RecipeError> {
    let checked = |fov: f64| {
        let problem = |problem| RecipeError::Sensor { sensor: wrong.0.name.clone(), problem };
        lens.check(fov).map_err(problem).map(|()| Some(fov))
    };
    let at_site = matches!(wrong.0.mount, MountSpec::Site { .. } | MountSpec::PanTiltZoom { site: Some(_), .. });
    match given.or(lens.usual_fov_deg()) {
        Some(fov) => checked(fov),
        None if at_site => checked(USUAL_FOV_DEG).map(|_| None),
        None => checked(USUAL_FOV_DEG),
    }
}

/// An event camera with what is not given of it.
fn event_camera_of(
    wrong: &Wrong<'_>,
    camera: &EventCameraSpec,
    recipe: &Recipe,
) -> Result<EventCameraSpec, RecipeError> {
    let checked = camera.settings.check();
    checked.map_err(|problem| RecipeError::Sensor { sensor: wrong.0.name.clone(), problem })?;
    let size = size_of(wrong, camera.size.as_ref(), recipe)?;
    Ok(EventCameraSpec {
        size: Some(size.to_string()),
        fov: fov_of(wrong, camera.fov, camera.lens.unwrap_or_default())?,
        ..camera.clone()
    })
}

/// A camera with what is not given of it.
fn camera_of(wrong: &Wrong<'_>, camera: &CameraSpec, recipe: &Recipe) -> Result<CameraSpec, RecipeError> {
    let size = size_of(wrong, camera.size.as_ref(), recipe)?;
    let fov = fov_of(wrong, camera.fov, camera.lens.unwrap_or_default())?;
    let mut layers = camera.layers.clone().unwrap_or_else(|| recipe.layers.clone());
    layers.sort_unstable();
    layers.dedup();
    let named = |layers: &[Layer]| layers.iter().map(|layer| layer.name()).collect::<Vec<_>>().join(", ");
    if layers.is_empty() {
        return Err(wrong.value("layers", "[]", "name at least one"));
    }
    if every(wrong.0.rate.unwrap_or(recipe.fps), recipe.fps) != Some(1) {
        let flow = [Layer::Flow, Layer::FlowBackward];
        if let Some(layer) = camera.layers.iter().flatten().find(|layer| flow.contains(layer)) {
            return Err(wrong.value("layers", layer, "flow leads to the scene's next frame: leave out the rate"));
        }
        layers.retain(|layer| !flow.contains(layer));
    }
    let mut mp4 = match &camera.mp4 {
        Some(mp4) => mp4.clone(),
        None => recipe.mp4.iter().filter(|layer| layers.contains(layer)).copied().collect(),
    };
    mp4.sort_unstable();
    mp4.dedup();
    if let Some(layer) = mp4.iter().find(|layer| !layers.contains(layer)) {
        return Err(wrong.value("mp4", layer, &format!("name layers that it stores: {}", named(&layers))));
    }
    Ok(CameraSpec {
        size: Some(size.to_string()),
        fov,
        lens: camera.lens,
        layers: Some(layers),
        mp4: Some(mp4),
        look: Some(camera.look.unwrap_or(recipe.camera_look)),
    })
}
