//! What sensors measure of an episode, and how it is sent.

mod camera;
mod contact;
mod events;
mod image;
mod inertial;
mod lidar;
mod look;
mod looking;
mod measurement;
mod obstacle;
mod radar;
mod scene;
mod switched_lamps;
mod town_light;

use super::actor::{Body, SensorModel, ServerActor};
use super::episode::Episode;
use super::quality_level::QualityLevel;
use super::weather::scene_weather;
use crate::frames;
use crate::instance::instance_id;
use crate::stream::{Delivery, StreamHub};
use endless_asset::Catalogue;
use endless_render::FrameScene;
use endless_world::InstanceId;
use look::Look;
use looking::{Looking, PATIENCE};
use measurement::{Measured, Measurement};
use scene::ActorScene;
use std::sync::Arc;

/// The sensors of an episode, as far as something is kept of them from frame to frame.
pub(super) struct Sensing {
    scene: ActorScene,
    looking: Looking,
    quality: QualityLevel,
    /// Time since the last frame at which sensors looked, seconds.
    passed_s: f64,
}

impl Sensing {
    /// Of an episode that begins.
    pub(super) fn new(quality: QualityLevel) -> Self {
        Self { scene: ActorScene::default(), looking: Looking::new(), quality, passed_s: 0.0 }
    }

    /// Measures with those sensors that somebody hears and whose time has come, and sends it; with those that look at the scene
    /// only if it `sees`. Where a message may be lost time does not wait for them: those that still look at an earlier frame
    /// leave this one out.
    pub(super) fn measure(
        &mut self,
        episode: &mut Episode,
        catalogue: &Catalogue,
        hub: &Arc<StreamHub>,
        delivery: Delivery,
        sees: bool,
    ) {
        for (stream, message) in contact::collisions(episode, hub) {
            hub.publish(stream, message, delivery);
        }
        self.passed_s += episode.delta_s;
        let views = if sees { self.looking.views(delivery) } else { None };
        let due = due(episode, hub, views.is_some());
        let (done, looking): (Vec<_>, Vec<_>) = due.into_iter().partition(|one| !one.looks());
        for one in done {
            let stream = one.stream;
            if let Some(message) = one.message(episode) {
                hub.publish(stream, message, delivery);
            }
        }
        let Some(views) = views else { return };
        if looking.is_empty() {
            return self.looking.put_back(views);
        }
        let look = Look {
            frame: self.scene.at(episode, catalogue),
            weather: scene_weather(&episode.weather, episode.seed),
            lamps: episode.lamps.factors(),
            map: Arc::clone(&episode.map),
            seed: episode.seed,
            quality: self.quality,
            step_s: std::mem::take(&mut self.passed_s),
            sensors: looking,
        };
        let hub = Arc::clone(hub);
        self.looking.begin(views, move |views| views.look(look, &hub, delivery), delivery, PATIENCE);
    }

    /// What moves at this instant, as rays meet it.
    pub(super) fn scene(&mut self, episode: &Episode, catalogue: &Catalogue) -> Arc<FrameScene> {
        self.scene.at(episode, catalogue)
    }

    /// A sensor has gone.
    pub(super) fn forget(&mut self, stream: u32) {
        self.looking.forget(stream);
    }
}

/// The sensors that measure now and are heard, with those that look at the scene or without.
fn due(episode: &mut Episode, hub: &StreamHub, may_look: bool) -> Vec<Measurement> {
    let (now_s, frame, step_s) = (episode.elapsed_s, episode.frame, episode.delta_s);
    let map = Arc::clone(&episode.map);
    let measurement = |actor: &mut ServerActor| {
        let carrier = instance_id(actor.told.parent_id);
        let Body::Sensor(sensor) = &mut actor.body else { return None };
        if sensor.model.looks() && !may_look || !sensor.measures(now_s) || !hub.is_heard(sensor.stream) {
            return None;
        }
        let pose = frames::sensor_pose(&actor.transform);
        let interval_s = sensor.last_s.map_or(step_s, |last_s| now_s - last_s).max(1e-6);
        let header = sensor.header(&actor.transform, frame, now_s);
        let (number, seed) = (sensor.count, sensor.seed);
        let what = match &mut sensor.model {
            SensorModel::Camera(settings) => Measured::Camera(*settings),
            SensorModel::Events(camera, events) => Measured::Events(*camera, events.clone()),
            SensorModel::Obstacle(settings) => Measured::Obstacle(*settings, [actor.told.id, actor.told.parent_id]),
            SensorModel::Lidar(settings) => Measured::Lidar(settings.clone()),
            SensorModel::Radar(settings) => Measured::Radar(settings.clone()),
            SensorModel::Imu(settings, imu) => {
                let imu = imu.get_or_insert_with(|| inertial::imu(settings, interval_s, seed));
                Measured::Done(inertial::imu_message(&header, imu, &pose))
            }
            SensorModel::Gnss(settings) => {
                let place = map.town.georeference.unwrap_or_default().wgs84(pose.position);
                Measured::Done(inertial::gnss_message(&header, settings, place, number, seed))
            }
            SensorModel::Event => return None,
        };
        sensor.last_s = Some(now_s);
        sensor.count = number.wrapping_add(1);
        let carrier = Some(carrier).filter(|id| *id != InstanceId::STUFF);
        Some(Measurement {
            kind: sensor.kind,
            stream: sensor.stream,
            header,
            number,
            seed,
            pose,
            interval_s,
            carrier,
            what,
        })
    };
    episode.actors.values_mut().filter_map(measurement).collect()
}
