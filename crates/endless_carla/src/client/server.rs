//! The server that a simulator has a connection to, and what is known of it.

use super::address::Address;
use super::error::ClientError;
use super::map::PlannedMap;
use super::patience::StopFlag;
use super::world::World;
use crate::blueprint::BlueprintLibrary;
use crate::wire::EpisodeSettings;
use endless_asset::Catalogue;
use endless_pipeline::SimulatorError;
use std::collections::BTreeMap;
use std::io;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Settings of a connection.
#[derive(Debug, Clone)]
pub struct CarlaSettings {
    /// Where the server is.
    pub address: Address,
    /// The TrafficManager that drives vehicles; without one our own traffic does.
    pub traffic_manager: Option<Address>,
    /// How long a frame may take.
    pub frame_limit: Duration,
    /// How long a server that has gone is waited for.
    pub reconnect_limit: Duration,
    /// Whether to find camera sites; otherwise the user gives them.
    pub finds_sites: bool,
    /// Set when the user wants to stop.
    pub stop: StopFlag,
}

/// A server, and the catalogue by which its actors are known.
pub(super) struct Server {
    pub(super) settings: CarlaSettings,
    state: Mutex<ServerState>,
    pub(super) blueprints: BlueprintLibrary,
    pub(super) catalogue: Catalogue,
}

/// What is known of a server.
pub(super) struct ServerState {
    /// None after it was lost.
    pub(super) world: Option<World>,
    /// The map that is loaded with nobody on it.
    pub(super) loaded: Option<String>,
    pub(super) planned: BTreeMap<String, Arc<PlannedMap>>,
}

impl Server {
    pub(super) fn new(settings: CarlaSettings, world: World) -> Self {
        let state = ServerState { world: Some(world), loaded: None, planned: BTreeMap::new() };
        Self {
            settings,
            state: Mutex::new(state),
            blueprints: BlueprintLibrary::new(),
            catalogue: Catalogue::builtin(),
        }
    }

    pub(super) fn state(&self) -> MutexGuard<'_, ServerState> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// An error as all simulators say it.
    pub(super) fn told(&self, error: ClientError) -> SimulatorError {
        error.at(&self.settings.address.to_string())
    }

    /// Does something in the world, whose map has somebody on it then.
    pub(super) fn with_world<R>(
        &self,
        act: impl FnOnce(&mut World) -> Result<R, ClientError>,
    ) -> Result<R, ClientError> {
        let mut state = self.state();
        state.loaded = None;
        act(state.world()?)
    }

    /// The same, also when the user wants to stop.
    pub(super) fn while_stopping<R>(
        &self,
        act: impl FnOnce(&mut World) -> Result<R, ClientError>,
    ) -> Result<R, ClientError> {
        self.settings.stop.pause(|| self.with_world(act))
    }
}

impl ServerState {
    fn world(&mut self) -> Result<&mut World, ClientError> {
        self.world.as_mut().ok_or_else(|| ClientError::Lost(io::ErrorKind::NotConnected.into()))
    }

    /// Loads a map, unless it was loaded last and nobody is on it.
    pub(super) fn load(&mut self, map: &str, clock: &EpisodeSettings) -> Result<&mut World, ClientError> {
        if self.loaded.as_deref() != Some(map) {
            self.loaded = None;
            self.world()?.load(map, clock)?;
            self.loaded = Some(map.to_owned());
        }
        self.world()
    }
}
