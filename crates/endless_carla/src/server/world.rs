//! The world that clients share: an episode, how its time runs, and what measures it.

use super::call_error::CallError;
use super::drawn_boxes::DrawnBoxes;
use super::episode::Episode;
use super::error::ServerError;
use super::loaded_map::MapShelf;
use super::map_layer::MapLayer;
use super::quality_level::QualityLevel;
use super::recorder::Recordings;
use super::sensing::Sensing;
use super::settings::ServerSettings;
use super::version::VERSION;
use crate::blueprint::BlueprintLibrary;
use crate::rpc::{Answer, ConnectionId, StandingAnswers};
use crate::stream::{Delivery, StreamHub, Token};
use crate::wire::{Bytes, EpisodeSettings};
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Instant;

/// Frames a second without a fixed step.
const USUAL_FPS: f64 = 30.0;

/// The world that clients share.
pub(super) struct World {
    pub(super) shelf: MapShelf,
    pub(super) blueprints: BlueprintLibrary,
    pub(super) episode: Episode,
    /// Changed by [`Self::set_settings`].
    pub(super) settings: EpisodeSettings,
    /// The version and the settings are told while frames are made.
    pub(super) standing: Arc<StandingAnswers>,
    pub(super) sensing: Sensing,
    pub(super) drawn_boxes: DrawnBoxes,
    pub(super) recordings: Recordings,
    pub(super) hub: Arc<StreamHub>,
    /// Their hosts, by port.
    pub(super) traffic_managers: BTreeMap<u16, String>,
    /// Who made time pass last in synchronous mode.
    pub(super) ticking: Option<ConnectionId>,
    /// On which clients are told to hear streams; of no meaning until it is open.
    pub(super) stream_port: u16,
    seed: u64,
    quality: QualityLevel,
    begun: Instant,
}

impl World {
    /// With its first episode, on this map.
    pub(super) fn new(
        settings: &ServerSettings,
        mut shelf: MapShelf,
        hub: Arc<StreamHub>,
    ) -> Result<Self, ServerError> {
        let &ServerSettings { seed, quality, .. } = settings;
        let map = shelf.load(&settings.map)?;
        // Made now rather than while somebody waits.
        let _ = map.loaded.roads.navigation();
        let blueprints = BlueprintLibrary::new();
        let mut world = Self {
            episode: Episode::new(map, MapLayer::ALL, seed, &blueprints, None),
            shelf,
            blueprints,
            settings: EpisodeSettings::default(),
            standing: Arc::default(),
            sensing: Sensing::new(quality),
            drawn_boxes: DrawnBoxes::default(),
            recordings: Recordings::new(None),
            hub,
            traffic_managers: BTreeMap::new(),
            ticking: None,
            seed,
            quality,
            stream_port: 0,
            begun: Instant::now(),
        };
        world.hub.open(world.episode.stream());
        world.standing.set("version", Answer::of(&VERSION.to_owned()));
        world.set_settings(EpisodeSettings::default());
        Ok(world)
    }

    /// Time runs like this from now on.
    pub(super) fn set_settings(&mut self, settings: EpisodeSettings) {
        self.standing.set("get_episode_settings", Answer::of(&settings));
        self.settings = settings;
    }

    /// Seconds from frame to frame, where the settings say.
    fn fixed_step_s(&self) -> Option<f64> {
        self.settings.fixed_delta_seconds.filter(|s| *s > 0.0)
    }

    /// Seconds from frame to frame.
    pub(super) fn step_s(&self) -> f64 {
        self.fixed_step_s().unwrap_or(1.0 / USUAL_FPS)
    }

    /// A client lets time pass; gives the new frame. In asynchronous mode it passes by itself.
    pub(super) fn tick(&mut self, by: ConnectionId) -> u64 {
        if self.settings.synchronous_mode {
            self.ticking = Some(by);
            self.hub.wait_for_expected();
            self.advance(self.step_s());
        }
        self.episode.frame
    }

    /// Time passes: as much as the settings say, else so much.
    pub(super) fn advance(&mut self, passed_s: f64) {
        let step_s = self.fixed_step_s().unwrap_or(passed_s);
        self.episode.show_scenery(self.shelf.catalogue());
        self.episode.step(step_s);
        self.replay(step_s);
        self.record();
        let delivery = if self.settings.synchronous_mode { Delivery::Every } else { Delivery::Latest };
        let sees = !self.settings.no_rendering_mode;
        self.sensing.measure(&mut self.episode, self.shelf.catalogue(), &self.hub, delivery, sees);
        // After what was measured, so that a client whose tick has ended has it on its way, unless that takes long.
        let message = self.episode.snapshot(self.begun.elapsed().as_secs_f64());
        self.hub.publish(self.episode.stream(), message, delivery);
    }

    /// Another episode begins, on some layers of this map or another.
    pub(super) fn load(&mut self, map: &str, reset_settings: bool, layers: u16) -> Result<(), CallError> {
        let map = match map {
            "" => self.episode.named_map(),
            name => self.shelf.load(name).map_err(|error| CallError::refused(error.to_string()))?,
        };
        if reset_settings {
            self.set_settings(EpisodeSettings::default());
        }
        let walked = Arc::clone(&map.loaded);
        rayon::spawn(move || {
            let _ = walked.roads.navigation();
        });
        let next = Episode::new(map, layers, self.seed, &self.blueprints, Some(&self.episode));
        for stream in self.episode.sensor_streams() {
            self.hub.close(stream);
        }
        self.episode = next;
        self.recordings.end();
        self.sensing = Sensing::new(self.quality);
        Ok(())
    }

    /// What tells a client where a stream is.
    pub(super) fn token(&self, stream: u32) -> Bytes {
        Token { stream, port: self.stream_port }.bytes()
    }
}
