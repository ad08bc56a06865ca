//! Light for cameras that go anywhere in a town, found where they come and kept.

use crate::indirect::{Cell, ProbeMap};
use crate::light::{LampMaps, Lamps};
use crate::lighting::Lighting;
use crate::scene::StaticScene;
use crate::settings::{Gathering, RenderSettings};
use endless_world::SceneWeather;
use glam::Vec3;
use std::sync::Arc;

/// Columns of probes that are baked again at most, for each place that is asked for, after the light has changed a little.
const AGAIN: usize = 24;
/// Places around which light is kept ready.
const KEPT: usize = 8;

/// The light of a town: sun, sky and air, and what bounced off streets and walls around the places that were asked for.
///
/// The same calls in the same order give the same light.
pub struct RoamingLight {
    settings: RenderSettings,
    ground_m: f32,
    dark: Lighting,
    lamp_maps: LampMaps,
    probes: ProbeMap,
    /// Those asked for last at the end.
    windows: Vec<(Cell, LocalLight)>,
}

/// The light around a place.
#[derive(Clone)]
pub struct LocalLight(pub(super) Arc<Lighting>);

impl RoamingLight {
    /// Nothing is found yet; the air lies on ground of this height, metres.
    pub fn new(still: &StaticScene, settings: &RenderSettings, ground_m: f32) -> Self {
        let settings = RenderSettings { gathering: Gathering::Probes, ..settings.clone() };
        Self {
            ground_m,
            dark: Lighting::dark(still, &settings, ground_m),
            lamp_maps: LampMaps::default(),
            probes: ProbeMap::new(settings.pattern, ground_m),
            windows: Vec::new(),
            settings,
        }
    }

    /// In what it was found, or is being found.
    pub fn weather(&self) -> &SceneWeather {
        &self.settings.weather
    }

    /// The weather is a little different from now on: what bounced follows, first near the cameras.
    pub fn change(&mut self, still: &StaticScene, weather: SceneWeather) {
        self.settings.weather = weather;
        self.dark = Lighting::dark(still, &self.settings, self.ground_m);
        self.probes.age();
        self.windows.clear();
    }

    /// The light around a place, found if it is not known.
    pub fn around(&mut self, still: &StaticScene, place: Vec3) -> LocalLight {
        let middle = ProbeMap::cell(place);
        let known = self.windows.iter().position(|(cell, _)| *cell == middle).map(|at| self.windows.remove(at).1);
        let lamps = if self.dark.environment.night { still.lamps.all() } else { &[] };
        if known.is_none() {
            let [low, high] = ProbeMap::bounds(middle);
            self.lamp_maps.reach(&still.accel, lamps, low, high, Lamps::range_m());
        }
        let lit = Lighting { lamp_maps: self.lamp_maps.clone(), ..self.dark.without_probes() };
        let changed = self.probes.complete(&lit.tracer(still, None), middle, AGAIN);
        let light = match known {
            Some(light) if !changed => light,
            _ => LocalLight(Arc::new(Lighting { probes: Some(self.probes.window(middle)), ..lit })),
        };
        if self.windows.len() >= KEPT {
            self.windows.remove(0);
        }
        self.windows.push((middle, light.clone()));
        light
    }
}
