//! A server's world: the calls that are needed of it.

use super::address::Address;
use super::connection::{Connection, unwrapped};
use super::error::ClientError;
use super::patience::{StopFlag, Wait};
use super::subscription::Subscription;
use crate::stream::{ActorRecord, RecordKind, SensorHeader, read_snapshot};
use crate::wire::{
    Actor, ActorDefinition, Bytes, Command, EnvironmentObject, EpisodeInfo, EpisodeSettings, LabelledPoint, Location,
    MapInfo, WeatherParameters, Wire,
};
use endless_world::ObjectClass;
use rmpv::Value;
use std::collections::BTreeMap;
use std::time::Duration;

/// How long an ordinary call may take.
pub(super) const CALL: Duration = Duration::from_secs(20);
/// How long loading a map may take.
const LOAD: Duration = Duration::from_secs(180);
/// The versions whose protocol is known.
const VERSIONS: [&str; 2] = ["0.9.15", "0.9.16"];

/// A server's world.
pub(super) struct World {
    address: Address,
    connection: Connection,
    stop: StopFlag,
    version: String,
    episode: u64,
    snapshots: Option<Subscription>,
    kinds: BTreeMap<u32, RecordKind>,
    /// How long a frame may take.
    frame_limit: Duration,
    /// Before anything was changed.
    first_settings: EpisodeSettings,
}

/// An instant of the world.
pub(super) struct Snapshot {
    pub(super) header: SensorHeader,
    pub(super) actors: BTreeMap<u32, ActorRecord>,
}

impl World {
    /// Connects, and makes sure of the version.
    pub(super) fn connect(address: &Address, frame_limit: Duration, stop: &StopFlag) -> Result<Self, ClientError> {
        let mut connection = Connection::new(&address.host, address.port, stop)?;
        let version: String = connection.get("version", vec![], CALL)?;
        if !VERSIONS.iter().any(|known| version == *known || version.starts_with(&format!("{known}-"))) {
            return Err(ClientError::Unusable(format!(
                "it is CARLA {version}, and this program speaks with {}",
                VERSIONS.join(" and ")
            )));
        }
        let first_settings = connection.get("get_episode_settings", vec![], CALL)?;
        let world = Self {
            address: address.clone(),
            connection,
            stop: stop.clone(),
            version,
            episode: 0,
            snapshots: None,
            kinds: BTreeMap::new(),
            frame_limit,
            first_settings,
        };
        Ok(world)
    }

    /// Names of the maps, without paths.
    pub(super) fn available_maps(&mut self) -> Result<Vec<String>, ClientError> {
        let maps: Vec<String> = self.get("get_available_maps", vec![])?;
        Ok(maps.iter().map(|map| short(map).to_owned()).collect())
    }

    /// Loads a map, so that nobody is on it, and stops its clock.
    pub(super) fn load(&mut self, map: &str, settings: &EpisodeSettings) -> Result<(), ClientError> {
        self.snapshots = None;
        self.kinds.clear();
        let before: EpisodeInfo = self.get("get_episode_info", vec![])?;
        const ALL_LAYERS: u16 = u16::MAX;
        let arguments = vec![map.into(), true.into(), ALL_LAYERS.into()];
        self.connection.call("load_new_episode", arguments, LOAD)?;
        let wait = Wait::new("load the map", LOAD, &self.stop);
        let info = loop {
            // While a map loads there may be no episode.
            match self.connection.get::<EpisodeInfo>("get_episode_info", vec![], CALL) {
                Ok(info) if info.id != before.id => break info,
                Ok(_) | Err(ClientError::Failed { .. }) => wait.sleep(Duration::from_millis(50))?,
                Err(error) => return Err(error),
            }
        };
        self.episode = info.id;
        let token = info.token.first().ok_or_else(|| ClientError::Protocol("an episode has no stream".to_owned()))?;
        self.snapshots = Some(self.subscribe(token)?);
        self.apply_settings(settings)?;
        let info: MapInfo = self.get("get_map_info", vec![])?;
        if short(&info.name) == map || short(&info.name).strip_suffix("_Opt") == Some(map) {
            return Ok(());
        }
        Err(ClientError::Unusable(format!("it was asked to load {map}, and loaded {}", info.name)))
    }

    /// Listens to a sensor or to the snapshots.
    pub(super) fn subscribe(&mut self, token: &Bytes) -> Result<Subscription, ClientError> {
        let number = token.0.first_chunk::<4>().map(|bytes| u32::from_le_bytes(*bytes));
        let number = number.ok_or_else(|| ClientError::Protocol("a stream's token has 24 bytes".to_owned()))?;
        let tokens: Vec<Bytes> = self.get("get_sensor_token", vec![number.into()])?;
        Subscription::new(&self.address.host, tokens.first().unwrap_or(token))
    }

    /// How time runs from now on.
    pub(super) fn apply_settings(&mut self, settings: &EpisodeSettings) -> Result<(), ClientError> {
        self.get::<u64>("set_episode_settings", vec![settings.to_value()]).map(drop)
    }

    /// As it was before this client came: its clock runs again by itself, if it did.
    pub(super) fn restore_settings(&mut self) -> Result<(), ClientError> {
        let settings = self.first_settings.clone();
        self.apply_settings(&settings)
    }

    /// The roads as OpenDRIVE.
    pub(super) fn opendrive(&mut self) -> Result<String, ClientError> {
        self.get("get_map_data", vec![])
    }

    pub(super) fn map_info(&mut self) -> Result<MapInfo, ClientError> {
        self.get("get_map_info", vec![])
    }

    pub(super) fn definitions(&mut self) -> Result<Vec<ActorDefinition>, ClientError> {
        self.get("get_actor_definitions", vec![])
    }

    pub(super) fn set_weather(&mut self, weather: &WeatherParameters) -> Result<(), ClientError> {
        self.connection.tell("set_weather_parameters", vec![weather.to_value()])
    }

    /// What stays the same of actors; those that are unknown are left out.
    pub(super) fn actors(&mut self, ids: &[u32]) -> Result<Vec<Actor>, ClientError> {
        let actors: Vec<Actor> = self.get("get_actors_by_id", vec![ids.to_vec().to_value()])?;
        for actor in &actors {
            self.kinds.insert(actor.id, kind(&actor.description.id));
        }
        Ok(actors)
    }

    /// Lights of vehicles, by their ids.
    pub(super) fn vehicle_lights(&mut self) -> Result<BTreeMap<u32, u32>, ClientError> {
        let lights: Vec<(u32, u32)> = self.get("get_vehicle_light_states", vec![])?;
        Ok(lights.into_iter().collect())
    }

    /// Things of the map of a class.
    pub(super) fn environment_objects(&mut self, label: u8) -> Result<Vec<EnvironmentObject>, ClientError> {
        self.get("get_environment_objects", vec![label.into()])
    }

    /// What lies on the way from a place to another, in order.
    pub(super) fn cast_ray(&mut self, from: &Location, to: &Location) -> Result<Vec<LabelledPoint>, ClientError> {
        self.get("cast_ray", vec![from.to_value(), to.to_value()])
    }

    /// Tells a light to stay, and what it shows.
    pub(super) fn set_traffic_light(&mut self, light: u32, state: u8) -> Result<(), ClientError> {
        self.connection.tell("set_traffic_light_state", vec![light.into(), state.into()])
    }

    pub(super) fn freeze_traffic_light(&mut self, light: u32, frozen: bool) -> Result<(), ClientError> {
        self.connection.tell("freeze_traffic_light", vec![light.into(), frozen.into()])
    }

    /// Turns the front wheels of a vehicle that no physics moves, degrees to the right. Of two-wheelers CARLA's wheel 1 is the
    /// rear one.
    pub(super) fn steer_wheels(&mut self, vehicle: u32, class: ObjectClass, degrees: f32) -> Result<(), ClientError> {
        for wheel in 0..if class.two_wheeled() { 1u8 } else { 2 } {
            let arguments = vec![vehicle.into(), wheel.into(), degrees.into()];
            self.connection.tell("set_wheel_steer_direction", arguments)?;
        }
        Ok(())
    }

    /// Runs commands that spawn, also when the user wants to stop meanwhile: what was spawned must be known, to be taken away.
    pub(super) fn spawn(&mut self, commands: &[Command]) -> Result<Vec<Result<u32, String>>, ClientError> {
        self.stop.clone().pause(|| self.batch(commands))
    }

    /// Runs commands: the actor of each, or why it failed.
    pub(super) fn batch(&mut self, commands: &[Command]) -> Result<Vec<Result<u32, String>>, ClientError> {
        let commands: Vec<Value> = commands.iter().map(|command| self.in_its_version(command)).collect();
        let answer = self.connection.bare("apply_batch", vec![Value::Array(commands), false.into()], CALL)?;
        let wrong = || ClientError::Protocol("apply_batch gives a list".to_owned());
        let responses = answer.as_array().ok_or_else(wrong)?;
        let response = |response: &Value| match unwrapped("apply_batch", response) {
            Ok(value) => Ok(Ok(u32::from_value(&value)?)),
            Err(ClientError::Failed { text, .. }) => Ok(Err(text)),
            Err(error) => Err(error),
        };
        responses.iter().map(response).collect()
    }

    /// A command as the server's version has it.
    fn in_its_version(&self, command: &Command) -> Value {
        let mut value = command.to_value();
        let is_older = self.version.starts_with("0.9.15");
        if let (true, Command::SpawnActor(_), Value::Array(outer)) = (is_older, command, &mut value)
            && let Some(Value::Array(variant)) = outer.first_mut()
            && let Some(Value::Array(fields)) = variant.get_mut(1)
        {
            // Without attachment and socket.
            fields.drain(3..5.min(fields.len()));
        }
        value
    }

    /// Lets the world go on by a frame.
    pub(super) fn tick(&mut self) -> Result<Snapshot, ClientError> {
        let frame: u64 = self.connection.get("tick_cue", vec![], self.frame_limit.max(CALL))?;
        let wait = Wait::new("give a frame", self.frame_limit, &self.stop);
        let lost = || ClientError::Unfit("a snapshot of the world was lost".to_owned());
        let snapshots = self.snapshots.as_mut().ok_or_else(lost)?;
        let message = snapshots.of_frame(frame, &wait)?.ok_or_else(lost)?;
        let kinds = &self.kinds;
        let kind = |id: u32| kinds.get(&id).copied().unwrap_or(RecordKind::Other);
        let (episode, actors) = read_snapshot(&message.payload, kind)
            .ok_or_else(|| ClientError::Protocol("a snapshot is too short".to_owned()))?;
        if episode.id != self.episode {
            return Err(ClientError::Unfit("somebody else has loaded another map".to_owned()));
        }
        let actors = actors.into_iter().map(|actor| (actor.id, actor)).collect();
        Ok(Snapshot { header: message.header, actors })
    }

    /// The same where nobody moves by themselves: again, if the world is not seen.
    pub(super) fn tick_until_seen(&mut self, tries: u32) -> Result<Snapshot, ClientError> {
        for _ in 1..tries {
            match self.tick() {
                Err(ClientError::Unfit(_) | ClientError::Late { .. }) => {}
                other => return other,
            }
        }
        self.tick()
    }

    /// For messages of a frame.
    pub(super) fn frame_wait(&self) -> Wait {
        Wait::new("give a frame", self.frame_limit, &self.stop)
    }

    pub(super) fn stop(&self) -> &StopFlag {
        &self.stop
    }

    fn get<T: Wire>(&mut self, method: &'static str, arguments: Vec<Value>) -> Result<T, ClientError> {
        self.connection.get(method, arguments, CALL)
    }
}

/// A map's name without its path.
fn short(map: &str) -> &str {
    map.rsplit('/').next().unwrap_or(map)
}

/// The kind of an actor, by its blueprint.
fn kind(blueprint: &str) -> RecordKind {
    match blueprint.split('.').next() {
        Some("vehicle") => RecordKind::Vehicle,
        Some("walker") => RecordKind::Walker,
        Some("traffic") if blueprint == "traffic.traffic_light" => RecordKind::Light,
        Some("traffic") => RecordKind::Sign,
        _ => RecordKind::Other,
    }
}
