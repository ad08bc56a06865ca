//! What blueprints make.

use super::sensor::SensorKind;
use endless_asset::Prop;
use endless_world::{ObjectClass, Sex, VehicleModelId};

/// What a blueprint makes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BlueprintKind {
    /// `vehicle.*`.
    Vehicle(VehicleBlueprint),
    /// `walker.*`.
    Walker(WalkerBlueprint),
    /// `sensor.*`.
    Sensor(SensorKind),
    /// `static.prop.*`.
    Prop(PropBlueprint),
    /// `static.trigger.friction`.
    FrictionTrigger,
    /// `controller.ai.walker`: moves its parent from within the client.
    WalkerController,
    /// `util.actor.empty`: a place to attach others to.
    Empty,
    /// `spectator`; clients cannot spawn it.
    Spectator,
    /// `traffic.traffic_light`; clients cannot spawn it.
    TrafficLight,
    /// `traffic.*` but traffic lights; clients cannot spawn it.
    TrafficSign,
}

/// What a server must know of a vehicle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VehicleBlueprint {
    /// Our body for it, in [`endless_asset::Catalogue::builtin`].
    pub model: VehicleModelId,
    /// CARLA's base type: it has our names.
    pub base_type: ObjectClass,
    /// `electric`, `emergency`, `taxi`, or empty.
    pub special_type: &'static str,
    /// 1 or 2.
    pub generation: u8,
    /// 4, or 2 of two-wheelers. CARLA counts no more of lorries either.
    pub wheels: u32,
    /// Whether its lights can be switched.
    pub has_lights: bool,
    /// Whether its doors open.
    pub has_dynamic_doors: bool,
    /// About the mass of such a vehicle, with a rider of two-wheelers, kg. Not CARLA's figure.
    pub mass_kg: f32,
}

/// What a server must know of a walker.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WalkerBlueprint {
    /// Our person for it.
    pub person: u64,
    /// Our person for it when it uses a wheelchair; children have none.
    pub person_in_wheelchair: Option<u64>,
    /// Our person's.
    pub sex: Sex,
    /// Whether CARLA counts it as a child.
    pub child: bool,
    /// Speeds that the blueprint recommends, m/s: standing, walking, running.
    pub speeds_mps: [f32; 3],
    /// How high the origin of CARLA's frame is over the soles, metres: it is the middle of the box.
    pub origin_height_m: f32,
}

/// What stands for a prop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct PropBlueprint {
    /// Our piece for it; none: it is an actor that nobody sees.
    pub body: Option<PropBody>,
}

/// A piece of our catalogue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct PropBody {
    /// Which.
    pub prop: Prop,
    /// Which variant of it.
    pub variant: u32,
}
