//! What sensors measure of an episode, and how it is sent.

mod camera;
mod contact;
mod events;
mod image;
mod inertial;
mod lidar;
mod obstacle;
mod radar;
mod scene;
mod switched_lamps;
mod town_light;

use super::actor::{Body, CameraSettings, ObstacleSettings, SensorModel, ServerActor};
use super::episode::Episode;
use super::weather::scene_weather;
use crate::blueprint::SensorKind;
use crate::frames;
use crate::instance::instance_id;
use crate::stream::{Delivery, SensorHeader, StreamHub};
use camera::CameraView;
use endless_asset::Catalogue;
use endless_render::{FrameScene, LocalLight, RayCaster};
use endless_sensor::{Atmosphere, SweepInterval};
use endless_world::{
    EventCameraSettings, InstanceId, LidarSettings, RadarSettings, SceneWeather, SensorLayers, SensorPose,
};
use events::Events;
use rayon::prelude::*;
use scene::ActorScene;
use std::collections::BTreeMap;
use std::sync::Arc;
use switched_lamps::SwitchedLamps;
use town_light::{Light, TownLight};

/// The sensors of an episode, as far as something is kept of them from frame to frame.
#[derive(Default)]
pub(super) struct Sensing {
    scene: ActorScene,
    /// By the stream of the first sensor that looks through each.
    cameras: BTreeMap<u32, CameraView>,
    light: TownLight,
    lamps: SwitchedLamps,
}

/// A sensor that measures at this frame.
struct Measurement {
    kind: SensorKind,
    stream: u32,
    header: SensorHeader,
    pose: SensorPose,
    /// Since it measured last, seconds.
    interval_s: f64,
    /// In pictures, of whom it hangs on.
    carrier: Option<InstanceId>,
    what: Measured,
}

/// How it measures, where that needs to know the scene.
enum Measured {
    Camera(CameraSettings),
    Events(CameraSettings, Box<EventCameraSettings>),
    Lidar(Box<LidarSettings>),
    Radar(Box<RadarSettings>),
    /// Of this sensor on this carrier.
    Obstacle(ObstacleSettings, [u32; 2]),
    /// It has measured already.
    Done(Vec<u8>),
}

/// What clients are to be sent: by stream.
type Messages = Vec<(u32, Vec<u8>)>;

impl Sensing {
    /// Measures with those sensors that somebody hears and whose time has come, and sends it; with those that look at the scene
    /// only if it `sees`.
    pub(super) fn measure(
        &mut self,
        episode: &mut Episode,
        catalogue: &Catalogue,
        hub: &StreamHub,
        delivery: Delivery,
        sees: bool,
    ) {
        for (stream, message) in contact::collisions(episode, hub) {
            hub.publish(stream, message, delivery);
        }
        let due = due(episode, hub);
        let (done, looking): (Vec<_>, Vec<_>) = due.into_iter().partition(|one| !one.looks());
        for one in done {
            let stream = one.stream;
            if let Some(message) = one.message(episode) {
                hub.publish(stream, message, delivery);
            }
        }
        if looking.is_empty() || !sees {
            return;
        }
        let frame = self.scene.at(episode, catalogue);
        let weather = scene_weather(&episode.weather, episode.seed);
        let map = Arc::clone(&episode.map);
        if self.lamps.follow(&episode.lamps, map.scene.static_scene()) {
            self.cameras.values_mut().for_each(CameraView::forget_light);
            self.light = TownLight::default();
        }
        let still = self.lamps.scene(map.scene.static_scene());
        let (cameras, others): (Vec<_>, Vec<_>) = looking.into_iter().partition(|one| one.camera().is_some());
        let caster = RayCaster::new(still, &frame);
        let seed = episode.seed;
        let swept: Messages = others.par_iter().map(|one| (one.stream, one.sweep(&caster, &weather, seed))).collect();
        let light = Light { still, weather, seed, step_s: episode.delta_s };
        let views: Vec<(CameraView, Option<LocalLight>, Vec<Measurement>)> = look_alike(cameras)
            .into_iter()
            .map(|alike| {
                let mut view = self.cameras.remove(&alike[0].stream).unwrap_or_default();
                let (pose, settings) = (&alike[0].pose, alike[0].camera());
                let goes = settings.is_some_and(|settings| view.goes(&light, settings, pose));
                let around = goes.then(|| self.light.around(&map, &light, pose));
                (view, around, alike)
            })
            .collect();
        let shown: Vec<(CameraView, u32, Messages)> = views
            .into_par_iter()
            .map(|(mut view, around, alike)| {
                let messages = show(&mut view, &alike, &light, around.as_ref(), &frame);
                (view, alike[0].stream, messages)
            })
            .collect();
        swept.into_iter().for_each(|(stream, message)| hub.publish(stream, message, delivery));
        for (view, stream, messages) in shown {
            self.cameras.insert(stream, view);
            messages.into_iter().for_each(|(stream, message)| hub.publish(stream, message, delivery));
        }
    }

    /// What moves at this instant, as rays meet it.
    pub(super) fn scene(&mut self, episode: &Episode, catalogue: &Catalogue) -> Arc<FrameScene> {
        self.scene.at(episode, catalogue)
    }

    /// A sensor has gone.
    pub(super) fn forget(&mut self, stream: u32) {
        self.cameras.remove(&stream);
    }
}

impl Measurement {
    fn camera(&self) -> Option<CameraSettings> {
        match self.what {
            Measured::Camera(settings) | Measured::Events(settings, _) => Some(settings),
            _ => None,
        }
    }

    /// Whether it needs what the renderer draws.
    fn looks(&self) -> bool {
        !matches!(self.what, Measured::Done(_) | Measured::Obstacle(..))
    }

    /// What it tells that needs no picture.
    fn message(self, episode: &Episode) -> Option<Vec<u8>> {
        match self.what {
            Measured::Done(message) => Some(message),
            Measured::Obstacle(settings, ids) => obstacle::message(&self.header, episode, ids, &settings, &self.pose),
            _ => None,
        }
    }

    fn sweep(&self, caster: &RayCaster<'_>, weather: &SceneWeather, seed: u64) -> Vec<u8> {
        let caster = caster.ignoring(self.carrier.as_slice());
        let interval = SweepInterval::standing(self.pose, self.interval_s, self.header.frame as u32);
        let seed = seed ^ u64::from(self.stream);
        match &self.what {
            Measured::Lidar(settings) => {
                lidar::message(&self.header, self.kind, settings, &caster, &Atmosphere::from(weather), &interval, seed)
            }
            Measured::Radar(settings) => radar::message(&self.header, settings, &caster, &interval, seed),
            _ => Vec::new(),
        }
    }
}

/// The messages of cameras that look alike, such as one for colours and one for depth: they share one picture.
fn show(
    view: &mut CameraView,
    alike: &[Measurement],
    light: &Light<'_>,
    around: Option<&LocalLight>,
    frame: &Arc<FrameScene>,
) -> Messages {
    let (first, Some(settings)) = (&alike[0], alike[0].camera()) else { return Vec::new() };
    let normals = alike.iter().any(|one| one.kind == SensorKind::Normals);
    let flow_backward = alike.iter().any(|one| one.kind == SensorKind::OpticalFlow);
    let layers = SensorLayers { normals, flow_backward, ..SensorLayers::default() };
    let (seen, camera) = view.render(light, around, frame, settings, &first.pose, layers);
    let message = |one: &Measurement| {
        let message = match &one.what {
            Measured::Events(_, events) => {
                let new = || Events::new(events, settings.size, light.seed ^ u64::from(one.stream));
                view.events.entry(one.stream).or_insert_with(new).message(&one.header, settings.fov_deg, &seen.rgb)
            }
            _ => image::message(&one.header, one.kind, settings.fov_deg, &seen, &camera),
        };
        Some((one.stream, message?))
    };
    alike.iter().filter_map(message).collect()
}

fn look_alike(cameras: Vec<Measurement>) -> Vec<Vec<Measurement>> {
    let mut alike: Vec<Vec<Measurement>> = Vec::new();
    for one in cameras {
        let same = |others: &&mut Vec<Measurement>| {
            others[0].header.transform == one.header.transform && others[0].camera() == one.camera()
        };
        match alike.iter_mut().find(same) {
            Some(others) => others.push(one),
            None => alike.push(vec![one]),
        }
    }
    alike
}

/// The sensors that measure now and are heard.
fn due(episode: &mut Episode, hub: &StreamHub) -> Vec<Measurement> {
    let (now_s, frame, step_s) = (episode.elapsed_s, episode.frame, episode.delta_s);
    let (map, seed) = (Arc::clone(&episode.map), episode.seed);
    let measurement = |actor: &mut ServerActor| {
        let carrier = instance_id(actor.told.parent_id);
        let Body::Sensor(sensor) = &mut actor.body else { return None };
        if !sensor.measures(now_s) || !hub.is_heard(sensor.stream) {
            return None;
        }
        let pose = frames::sensor_pose(&actor.transform);
        let interval_s = sensor.last_s.map_or(step_s, |last_s| now_s - last_s).max(1e-6);
        let header = sensor.header(&actor.transform, frame, now_s);
        let own_seed = seed ^ u64::from(sensor.stream);
        let what = match &mut sensor.model {
            SensorModel::Camera(settings) => Measured::Camera(*settings),
            SensorModel::Events(camera, events) => Measured::Events(*camera, events.clone()),
            SensorModel::Obstacle(settings) => Measured::Obstacle(*settings, [actor.told.id, actor.told.parent_id]),
            SensorModel::Lidar(settings) => Measured::Lidar(settings.clone()),
            SensorModel::Radar(settings) => Measured::Radar(settings.clone()),
            SensorModel::Imu(settings, imu) => {
                let imu = imu.get_or_insert_with(|| inertial::imu(settings, interval_s, own_seed));
                Measured::Done(inertial::imu_message(&header, imu, &pose))
            }
            SensorModel::Gnss(settings) => {
                let place = map.town.georeference.unwrap_or_default().wgs84(pose.position);
                Measured::Done(inertial::gnss_message(&header, settings, place, own_seed))
            }
            SensorModel::Event => return None,
        };
        sensor.last_s = Some(now_s);
        let carrier = Some(carrier).filter(|id| *id != InstanceId::STUFF);
        Some(Measurement { kind: sensor.kind, stream: sensor.stream, header, pose, interval_s, carrier, what })
    };
    episode.actors.values_mut().filter_map(measurement).collect()
}
