//! CARLA's wire as data: values, structs, requests and answers. Everything is in CARLA's units: metres, degrees, seconds,
//! left-handed axes (x forward, y right, z up).

mod actor;
mod command;
mod episode;
mod geometry;
mod value;
mod vehicle;

pub use actor::{Actor, ActorAttribute, ActorAttributeValue, ActorDefinition, ActorDescription, AttributeType};
pub use command::{Command, SpawnActor};
pub use episode::{
    EnvironmentObject, EpisodeInfo, EpisodeSettings, LabelledPoint, LightState, MapInfo, OpendriveGenerationParameters,
    WeatherParameters,
};
pub use geometry::{BoundingBox, Color, GeoLocation, Location, Rotation, Transform, Vector2D, Vector3D};
pub use value::{Bytes, Wire, WireError};
pub(crate) use value::{array, wire_structs};
pub use vehicle::{
    AckermannControllerSettings, BoneTransform, GearPhysicsControl, VehicleAckermannControl, VehicleControl,
    VehiclePhysicsControl, VehicleTelemetryData, WalkerBones, WalkerBonesControl, WalkerControl, WheelPhysicsControl,
    WheelTelemetryData,
};
