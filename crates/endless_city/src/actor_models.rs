//! The models of all actors of a video, and their geometry at one instant.

use crate::{PlacedProp, SharedModels, TownScene, moving_vehicle::MovingVehicle, person::PersonGeometry, velocity};
use endless_asset::Catalogue;
use endless_render::{Footprint, FrameDescription, FrameScene, Geometry, Instance, MovingObject};
use endless_town::PlacedObject;
use endless_world::{Actor, ClassTag, Motion, PersonRef, VehicleModelId, VehicleMotion, VehicleRef, WorldState};
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Models of all actors of a video, made once.
#[derive(Debug)]
pub struct ActorModels {
    vehicles: BTreeMap<VehicleModelId, MovingVehicle>,
    people: BTreeMap<PersonRef, PersonGeometry>,
    riders: BTreeMap<VehicleRef, Geometry>,
    tints: BTreeMap<VehicleRef, Vec3>,
    props: BTreeMap<PlacedObject, Geometry>,
}

impl ActorModels {
    /// Models of these actors.
    pub fn new(catalogue: &Catalogue, actors: &[Actor]) -> Self {
        Self::made(catalogue, actors, &SharedModels::default())
    }

    /// The same in a town of the same catalogue, whose models are shared.
    pub fn in_town(town: &TownScene, catalogue: &Catalogue, actors: &[Actor]) -> Self {
        Self::made(catalogue, actors, &town.models)
    }

    /// The same with those of props beside the actors.
    #[must_use]
    pub fn with_props(self, town: &TownScene, catalogue: &Catalogue, props: &[PlacedProp]) -> Self {
        let kinds = props.iter().map(|prop| PlacedObject::Prop(prop.prop, prop.variant)).collect();
        Self { props: town.models.props(kinds, catalogue), ..self }
    }

    fn made(catalogue: &Catalogue, actors: &[Actor], shared: &SharedModels) -> Self {
        // Everything is made by all threads, once.
        let driving: BTreeSet<VehicleRef> = actors.iter().filter_map(|a| a.asset.vehicle()).collect();
        let models: BTreeSet<VehicleModelId> = driving.iter().map(|v| v.model).collect();
        let dressed: BTreeSet<PersonRef> = actors.iter().filter_map(|a| a.asset.person()).collect();
        let ridden = actors.iter().filter(|a| a.rider_id.is_some());
        let ridden: BTreeSet<VehicleRef> = ridden.filter_map(|a| a.asset.vehicle()).collect();
        let person = |person| (person, PersonGeometry::new(catalogue.dressed_person(person)));
        let (vehicles, (people, riders)) = rayon::join(
            || shared.moving(models, catalogue),
            || {
                rayon::join(
                    || dressed.into_par_iter().map(person).collect(),
                    || ridden.into_par_iter().filter_map(|key| Some((key, rider(catalogue, key)?))).collect(),
                )
            },
        );
        let tint = |vehicle| Some((vehicle, Vec3::from_array(catalogue.vehicle_tint(vehicle)?)));
        let tints = driving.into_iter().filter_map(tint).collect();
        Self { vehicles, people, riders, tints, props: BTreeMap::new() }
    }

    /// The actors as they stand at an instant, ready to be traced.
    pub fn frame_scene(&self, state: &WorldState) -> FrameScene {
        self.frame_scene_among(state, &[])
    }

    /// The same among props, of which [`Self::with_props`] has been told.
    pub fn frame_scene_among(&self, state: &WorldState, props: &[PlacedProp]) -> FrameScene {
        // People are posed by all threads.
        let posed: Vec<Option<Geometry>> = state.actors.par_iter().map(|actor| self.posed(actor)).collect();
        let mut frame = FrameDescription {
            frame: state.frame,
            signals: state.signals.iter().map(|s| s.aspect).collect(),
            ..FrameDescription::default()
        };
        for (actor, body) in state.actors.iter().zip(posed) {
            match actor.motion {
                Motion::Vehicle(motion) => self.add_vehicle(actor, &motion, &mut frame),
                Motion::Walker(_) => frame.objects.extend(body.and_then(|body| self.person(actor, &body))),
            }
        }
        let drawn = |prop: &PlacedProp| Some(prop.drawn(self.props.get(&PlacedObject::Prop(prop.prop, prop.variant))?));
        frame.objects.extend(props.iter().filter_map(drawn));
        FrameScene::new(frame)
    }

    /// Adds a vehicle, its rider and its lights, and what it draws.
    fn add_vehicle(&self, actor: &Actor, motion: &VehicleMotion, frame: &mut FrameDescription) {
        let Some(named) = actor.asset.vehicle() else { return };
        let Some(vehicle) = self.vehicles.get(&named.model) else { return };
        let world_from_object = actor.pose.world_from_object();
        let velocity = velocity::of_body(actor, vehicle.geometry.wheelbase_m());
        let placed = vehicle.geometry.place(world_from_object, motion, velocity);
        let tint = self.tints.get(&named).copied().unwrap_or(Vec3::ONE);
        let dressed = |i: Instance| i.with_id(actor.id, actor.class.tag()).with_tint(tint).with_lights(motion.lights);
        let mut towing: Vec<Instance> = placed.towing.into_iter().map(dressed).collect();
        let mut trailing: Vec<Instance> = placed.trailer.into_iter().map(dressed).collect();
        if let (Some(rider_id), Some(rider)) = (actor.rider_id, self.riders.get(&named)) {
            let last = if trailing.is_empty() { &mut towing } else { &mut trailing };
            let rider = Instance::new(rider, world_from_object);
            last.push(rider.with_id(rider_id, ClassTag::Rider).with_velocity(velocity));
        }
        let trailer = vehicle.geometry.trailer.as_ref();
        let world_from_last =
            trailer.map_or(world_from_object, |t| world_from_object * t.object_from_straight(motion.hitch_rad));
        frame.beams.extend(vehicle.beams(motion.lights, world_from_object, world_from_last));
        let extent = vehicle.extent;
        let rear = trailer.map_or(-extent.x, |_| vehicle.towing_rear.max(-extent.x));
        let footprint = vehicle.footprint(world_from_object, rear, extent.x);
        frame.objects.push(MovingObject { instances: towing, footprint });
        if let Some(trailer) = trailer {
            let footprint = vehicle.footprint(world_from_last, -extent.x, trailer.high.x);
            frame.objects.push(MovingObject { instances: trailing, footprint });
        }
    }

    /// The body of a person on foot as it stands.
    fn posed(&self, actor: &Actor) -> Option<Geometry> {
        let Motion::Walker(motion) = &actor.motion else { return None };
        Some(self.people.get(&actor.asset.person()?)?.posed(motion))
    }

    fn person(&self, actor: &Actor, body: &Geometry) -> Option<MovingObject> {
        let world_from_object = actor.pose.world_from_object();
        let instance = Instance::new(body, world_from_object)
            .with_id(actor.id, actor.class.tag())
            .with_velocity(velocity::of_body(actor, 0.0));
        let height_m = self.people.get(&actor.asset.person()?)?.height_m();
        let footprint = Footprint { world_from_object, ahead_m: 0.0, half_m: Vec2::new(0.2, 0.22), height_m };
        Some(MovingObject { instances: vec![instance], footprint })
    }
}

/// Who rides a vehicle.
fn rider(catalogue: &Catalogue, vehicle: VehicleRef) -> Option<Geometry> {
    let (mesh, parts) = catalogue.rider_body(vehicle)?;
    let rider = Geometry::rigid(mesh).with_body_parts(parts);
    Some(rider.with_ambient_occlusion(Vec3::new(-0.5, -0.4, 0.0), Vec3::new(0.5, 0.4, 1.8)))
}
