//! A look at the scene at one instant: by cameras, LiDARs and radars.

use super::camera::{CameraView, Making};
use super::events::Events;
use super::image;
use super::measurement::{Measured, Measurement};
use super::switched_lamps::{LampFactors, SwitchedLamps};
use super::town_light::{Light, TownLight};
use crate::blueprint::SensorKind;
use crate::server::loaded_map::LoadedMap;
use crate::server::quality_level::QualityLevel;
use crate::stream::{Delivery, StreamHub};
use endless_render::{FrameScene, RayCaster};
use endless_world::{SceneWeather, SensorLayers};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::Arc;

/// What cameras keep from frame to frame.
#[derive(Default)]
pub(super) struct Views {
    /// By the stream of the first sensor that looks through each.
    cameras: BTreeMap<u32, CameraView>,
    light: TownLight,
    lamps: SwitchedLamps,
    /// The map as it was seen last.
    map: Option<Arc<LoadedMap>>,
}

/// What is looked at, and by whom.
pub(super) struct Look {
    pub(super) frame: Arc<FrameScene>,
    pub(super) weather: SceneWeather,
    /// By which clients have changed the light of street lamps.
    pub(super) lamps: LampFactors,
    pub(super) map: Arc<LoadedMap>,
    pub(super) seed: u64,
    pub(super) quality: QualityLevel,
    /// Since the look before, seconds.
    pub(super) step_s: f64,
    pub(super) sensors: Vec<Measurement>,
}

impl Views {
    /// Looks, and sends what is seen.
    pub(super) fn look(&mut self, look: Look, hub: &StreamHub, delivery: Delivery) {
        let Look { frame, weather, lamps, map, seed, quality, step_s, sensors } = look;
        if self.map.as_ref().is_none_or(|known| !Arc::ptr_eq(known, &map)) {
            // Other things stand in it.
            self.cameras.values_mut().for_each(CameraView::forget_town);
            self.light = TownLight::default();
            self.lamps = SwitchedLamps::default();
            self.map = Some(Arc::clone(&map));
        }
        if self.lamps.follow(lamps, map.scene.static_scene()) {
            self.cameras.values_mut().for_each(CameraView::forget_town);
            self.light = TownLight::default();
        }
        let still = self.lamps.scene(map.scene.static_scene());
        let (cameras, others): (Vec<_>, Vec<_>) = sensors.into_iter().partition(|one| one.camera().is_some());
        let caster = RayCaster::new(still, &frame);
        let swept: Vec<(u32, Vec<u8>)> =
            others.par_iter().map(|one| (one.stream, one.sweep(&caster, &weather))).collect();
        let light = Light { still, weather, seed, quality, step_s };
        let alike = look_alike(cameras);
        let at_once = alike.len() < rayon::current_num_threads();
        let views: Vec<(CameraView, Making, Vec<Measurement>)> = alike
            .into_iter()
            .map(|alike| {
                let mut view = self.cameras.remove(&alike[0].stream).unwrap_or_default();
                let (pose, settings) = (&alike[0].pose, alike[0].camera());
                let goes = settings.is_some_and(|settings| view.goes(&light, settings, pose));
                let making = match (goes, alike.iter().any(Measurement::needs_light)) {
                    (false, _) => Making::Still { at_once },
                    (true, true) => Making::Moving(self.light.around(&map, &light, pose)),
                    (true, false) => Making::Labels,
                };
                (view, making, alike)
            })
            .collect();
        // What is seen is on its way while others still look.
        let send = |stream, message| hub.publish(stream, message, delivery);
        swept.into_iter().for_each(|(stream, message)| send(stream, message));
        let shown: Vec<(u32, CameraView)> = views
            .into_par_iter()
            .map(|(mut view, making, alike)| {
                show(&mut view, &alike, &light, &making, &frame, send);
                (alike[0].stream, view)
            })
            .collect();
        self.cameras.extend(shown);
    }

    /// A sensor has gone.
    pub(super) fn forget(&mut self, stream: u32) {
        self.cameras.remove(&stream);
    }
}

/// Sends the messages of cameras that look alike, such as one for colours and one for depth: they share one picture.
fn show(
    view: &mut CameraView,
    alike: &[Measurement],
    light: &Light<'_>,
    making: &Making,
    frame: &Arc<FrameScene>,
    send: impl Fn(u32, Vec<u8>),
) {
    let (first, Some(settings)) = (&alike[0], alike[0].camera()) else { return };
    let normals = alike.iter().any(|one| one.kind == SensorKind::Normals);
    let flow_backward = alike.iter().any(|one| one.kind == SensorKind::OpticalFlow);
    let layers = SensorLayers { normals, flow_backward, ..SensorLayers::default() };
    let (seen, camera) = view.render(light, making, frame, settings, &first.pose, layers);
    for one in alike {
        let message = match &one.what {
            Measured::Events(_, events) => {
                let new = || Events::new(events, settings.size, one.seed);
                view.events.entry(one.stream).or_insert_with(new).message(&one.header, settings.fov_deg, &seen.rgb)
            }
            _ => image::message(&one.header, one.kind, settings.fov_deg, &seen, &camera),
        };
        if let Some(message) = message {
            send(one.stream, message);
        }
    }
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
