//! The built-in catalogue.

use crate::carla;
use crate::furniture::{self, SignPlate, SignalHead};
use crate::person;
use crate::prop_mesh;
use crate::vehicle;
use crate::{Anatomy, ImportedAsset, ImportedStaticModel, PersonModel, Prop, VehicleDesignSummary, VehicleModel};
use endless_scene::{Material, Mesh};
use endless_world::walking::PedestrianSpec;
use endless_world::{
    AssetRef, BodyPart, Outfit, PersonAttributes, PersonRef, Reid, Stream, VehicleAttributes, VehicleModelId,
    VehicleRef, VehicleSpec, choose_vehicle,
};
use std::sync::Arc;

/// Everything that can be placed in a scene. Building it is deterministic and takes a few milliseconds; meshes are made
/// when they are first asked for.
#[derive(Debug, Clone)]
pub struct Catalogue {
    vehicles: Vec<VehicleModel>,
    /// How many of them are built in; those from files follow.
    built_in: usize,
    static_models: Vec<ImportedStaticModel>,
}

impl Catalogue {
    /// The bollard of plastic that marks where the carriageway ends, and its variant.
    pub const DELINEATOR: (Prop, u32) = (Prop::Bollard, furniture::DELINEATOR);

    /// The built-in catalogue.
    pub fn builtin() -> Self {
        let vehicles = vehicle::all();
        Self { built_in: vehicles.len(), vehicles, static_models: Vec::new() }
    }

    /// With more, from files, in this order. What was there keeps its place.
    #[must_use]
    pub fn with(mut self, imported: impl IntoIterator<Item = ImportedAsset>) -> Self {
        for asset in imported {
            match asset {
                ImportedAsset::Vehicle(vehicle) => self.vehicles.push(vehicle),
                ImportedAsset::StaticModel(model) => self.static_models.push(model),
            }
        }
        self
    }

    /// The vehicles among [`Self::vehicles`] that come from files.
    pub fn imported_vehicles(&self) -> &[VehicleModel] {
        &self.vehicles[self.built_in..]
    }

    /// Props and buildings from files.
    pub fn imported_static_models(&self) -> &[ImportedStaticModel] {
        &self.static_models
    }

    /// Vehicle models, some draws of each design; [`VehicleModelId`] indexes them.
    pub fn vehicles(&self) -> &[VehicleModel] {
        &self.vehicles
    }

    /// One vehicle model; `None` if this catalogue has no such model.
    pub fn vehicle(&self, model: VehicleModelId) -> Option<&VehicleModel> {
        self.vehicles.get(model.index())
    }

    /// What traffic needs to know of the vehicle models, in the same order.
    pub fn vehicle_specs(&self) -> Vec<VehicleSpec> {
        self.vehicles.iter().map(|model| model.spec.clone()).collect()
    }

    /// A model drawn by frequency among those that may stand parked and are `allowed`; `None` if there are none. A
    /// design more in the catalogue changes only those draws that it wins. Takes one number from the stream.
    pub fn choose_parked(&self, stream: &mut Stream, allowed: impl Fn(&VehicleSpec) -> bool) -> Option<VehicleModelId> {
        let frequency = |spec: &VehicleSpec| if spec.parks && allowed(spec) { spec.frequency } else { 0.0 };
        choose_vehicle(stream, self.vehicles.iter().map(|m| (&m.spec, frequency(&m.spec))))
    }

    /// The designs of vehicles with the ranges of their sizes.
    pub fn vehicle_designs() -> Vec<VehicleDesignSummary> {
        vehicle::design_summaries()
    }

    /// Any draw of the design of a name (`car.sedan`): no end of vehicles beside those of [`Self::vehicles`], which
    /// are the first draws.
    pub fn draw_vehicle(name: &str, index: u64) -> Option<VehicleModel> {
        vehicle::drawn(name, index)
    }

    /// The vehicle that stands for one of CARLA's blueprints (`vehicle.audi.a2`): of its class and about its size.
    pub fn carla_vehicle(&self, id: &str) -> Option<VehicleModelId> {
        let place = carla::VEHICLES.iter().position(|b| b.0 == id)?;
        Some(VehicleModelId::from_index(self.built_in - carla::VEHICLES.len() + place))
    }

    /// The person (a variant) that stands for one of CARLA's blueprints (`walker.pedestrian.0001`).
    pub fn carla_walker(id: &str) -> Option<u64> {
        carla::walker(id)
    }

    /// The person (a variant) that stands for one of CARLA's grown-up walkers when it uses a wheelchair: of the same sex as
    /// the one on foot. None for children.
    pub fn carla_walker_in_wheelchair(id: &str) -> Option<u64> {
        carla::walker_in_wheelchair(id)
    }

    /// Ids of the blueprints of CARLA that have a counterpart here: vehicles, then walkers.
    pub fn carla_ids() -> (Vec<&'static str>, Vec<String>) {
        (carla::VEHICLES.iter().map(|b| b.0).collect(), carla::walkers().collect())
    }

    /// Linear paint colour of a vehicle, distributed as on real roads; `None` if this catalogue has no such model.
    pub fn vehicle_tint(&self, vehicle: VehicleRef) -> Option<[f32; 3]> {
        Some(self.vehicle(vehicle.model)?.tint(vehicle.variant))
    }

    /// The person of a seed, dressed for fair weather.
    pub fn person(&self, seed: u64) -> PersonModel {
        self.dressed_person(PersonRef { outfit: Outfit::Fair, seed })
    }

    /// What traffic needs to know of the person of a seed.
    pub fn pedestrian_spec(seed: u64) -> PedestrianSpec {
        person::pedestrian_spec(seed)
    }

    /// A person, dressed for the weather that the reference says.
    pub fn dressed_person(&self, person: PersonRef) -> PersonModel {
        PersonModel::new(person)
    }

    /// The skeleton of that person, which takes no time to make.
    pub fn anatomy(&self, person: PersonRef) -> Anatomy {
        Anatomy::of(person)
    }

    /// Skin of a person on foot or of a vehicle's rider, 1 to 10 on the Monk scale; `None` for what has no skin.
    pub fn skin_tone(&self, asset: AssetRef) -> Option<u8> {
        match asset {
            AssetRef::Person(person) => Some(person::skin_tone(person.seed)),
            AssetRef::Vehicle(vehicle) => self.vehicle(vehicle.model)?.rider_skin_tone(vehicle.variant),
        }
    }

    /// Who a person is, what they wear and carry.
    pub fn person_attributes(person: PersonRef) -> PersonAttributes {
        person::attributes(person)
    }

    /// Which vehicle it is; `None` if this catalogue has no such model.
    pub fn vehicle_attributes(&self, vehicle: VehicleRef) -> Option<VehicleAttributes> {
        Some(self.vehicle(vehicle.model)?.attributes(vehicle.variant))
    }

    /// The identity of a look, of vehicles without their rider; `None` if this catalogue has no such model.
    pub fn reid(&self, asset: AssetRef) -> Option<Reid> {
        match asset {
            AssetRef::Person(person) => Some(person::reid(person)),
            AssetRef::Vehicle(vehicle) => Some(self.vehicle(vehicle.model)?.reid(vehicle.variant)),
        }
    }

    /// Who rides a two-wheeler or a three-wheeler, seated, in the vehicle's object frame; `None` for other models.
    pub fn rider(&self, vehicle: VehicleRef) -> Option<Mesh> {
        self.vehicle(vehicle.model)?.rider(vehicle.variant)
    }

    /// The same with the part of the body that each triangle shows.
    pub fn rider_body(&self, vehicle: VehicleRef) -> Option<(Mesh, Arc<[BodyPart]>)> {
        self.vehicle(vehicle.model)?.rider_body(vehicle.variant)
    }

    /// A plant or a piece of furniture. Few distinct variants exist of each ([`Self::prop_variants`]), so that towns
    /// can instance them.
    pub fn prop(&self, prop: Prop, variant: u32) -> Mesh {
        prop_mesh::prop(prop, variant)
    }

    /// The heads of a traffic light; none of other props.
    pub fn signal_heads(prop: Prop, variant: u32) -> Vec<SignalHead> {
        furniture::signal_heads(prop, variant)
    }

    /// The plate of a traffic sign; `None` for other props.
    pub fn sign_plate(&self, prop: Prop, variant: u32) -> Option<SignPlate> {
        furniture::sign_plate(prop, variant, || self.prop(prop, variant))
    }

    /// Codes of traffic signs, of the Vienna Convention (`C,1`) and of the MUTCD (`R5-1`): the variants of
    /// [`Prop::TrafficSign`].
    pub fn sign_codes() -> &'static [&'static str] {
        furniture::CODES
    }

    /// Words in raised strokes on a plane that looks towards +x, their middle at the origin; +y is the reader's right.
    /// Letters A to Z, figures, hyphen and exclamation mark.
    pub fn lettering(words: &str, height_m: f32, stroke_m: f32, material: Material) -> Mesh {
        furniture::lettering(words, height_m, stroke_m, material)
    }

    /// How many variants of a prop there are, at least 1.
    pub fn prop_variants(&self, prop: Prop) -> u32 {
        prop_mesh::variants(prop)
    }
}
