//! What stands in a map and stops vehicles and people: walls, poles, trunks, furniture, parked vehicles, as upright boxes
//! found by a grid that is made once a map.
//!
//! Leaves are passed through, and what is lower than a kerb is driven over. Nothing stands on a lane: what does in the town,
//! such as the barriers of roadworks, is left out, for a traffic manager does not know of it.

mod band;
mod pieces;
mod solid;
mod walls;

use crate::frames;
use crate::map::CarlaMap;
use crate::physics::{Obstacle, OrientedBox, direction};
use crate::wire::{BoundingBox, Transform};
use endless_asset::Catalogue;
use endless_city::TownThing;
use endless_town::{PlacedObject, Placement, Town};
use endless_world::{ClassTag, ParkedVehicle};
use glam::DVec2;
use rayon::prelude::*;
use solid::{Part, bit};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::sync::Arc;

/// Side of a cell, metres.
const CELL_M: f64 = 8.0;
/// Numbers of the map's obstacles begin here; below are those of actors.
const FIRST: u64 = 1 << 32;

/// The obstacles of a map.
pub(in crate::server) struct MapObstacles {
    all: Arc<[MapObstacle]>,
    /// Their places in the list, ascending.
    cells: Arc<HashMap<[i64; 2], Vec<u32>>>,
    /// By their places in the list: clients have hidden what they are of.
    hidden: Vec<bool>,
}

/// One of them.
#[derive(Debug, Clone, Copy)]
struct MapObstacle {
    part: Part,
    thing: TownThing,
}

impl MapObstacles {
    pub(in crate::server) fn new(town: &Town, roads: &CarlaMap, catalogue: &Catalogue) -> Self {
        let kinds: BTreeSet<PlacedObject> = town.placements.iter().map(|placement| placement.object).collect();
        let known: BTreeMap<PlacedObject, Vec<Part>> = kinds
            .into_par_iter()
            .map(|object| match object {
                PlacedObject::TownMesh(mesh) => {
                    (object, town.meshes.get(mesh as usize).map_or_else(Vec::new, |mesh| walls::walls(mesh)))
                }
                PlacedObject::Prop(prop, variant) => (object, pieces::pieces(&catalogue.prop(prop, variant))),
            })
            .collect();
        let numbered = (0u32..town.placements.len() as u32).into_par_iter().zip(&town.placements);
        let standing = numbered.flat_map_iter(|(number, placement)| {
            let parts = known.get(&placement.object).into_iter().flatten();
            parts.map(move |part| MapObstacle {
                part: Part { outline: placed(placement, &part.outline), ..*part },
                thing: TownThing::Placed(number),
            })
        });
        let vehicle = |(number, vehicle): (u32, &ParkedVehicle)| {
            Some(MapObstacle { part: parked(vehicle, catalogue)?, thing: TownThing::Parked(number) })
        };
        let mut all: Vec<MapObstacle> = standing.collect();
        all.extend((0..).zip(&town.parked).filter_map(vehicle));
        all.retain(|one| one.part.outline.half.is_finite() && one.part.outline.centre.is_finite());
        let is_clear: Vec<bool> = all.par_iter().map(|one| !stands_on_lane(&one.part.outline, roads)).collect();
        let all: Arc<[_]> = all.into_iter().zip(is_clear).filter_map(|(one, clear)| clear.then_some(one)).collect();
        let mut cells: HashMap<[i64; 2], Vec<u32>> = HashMap::new();
        for (index, one) in (0..).zip(&*all) {
            let (low, high) = one.part.outline.bounds();
            for cell in cells_of(low, high) {
                cells.entry(cell).or_default().push(index);
            }
        }
        Self { hidden: vec![false; all.len()], all, cells: Arc::new(cells) }
    }

    /// The same without those that are of nothing but hidden parts of things.
    pub(in crate::server) fn without(&self, hides: impl Fn(TownThing, ClassTag) -> bool) -> Self {
        let is_hidden = |one: &MapObstacle| {
            let mut classes = ClassTag::ALL.iter().filter(|class| one.part.classes & bit(**class) != 0);
            classes.all(|class| hides(one.thing, *class))
        };
        let hidden = self.all.iter().map(is_hidden).collect();
        Self { all: Arc::clone(&self.all), cells: Arc::clone(&self.cells), hidden }
    }

    /// Adds those that come into a rectangle.
    pub(in crate::server) fn near(&self, low: DVec2, high: DVec2, found: &mut Vec<Obstacle>) {
        let mut indices: Vec<u32> =
            cells_of(low, high).filter_map(|cell| self.cells.get(&cell)).flatten().copied().collect();
        indices.sort_unstable();
        indices.dedup();
        found.extend(indices.into_iter().filter_map(|index| {
            let outline = self.all.get(index as usize).filter(|_| !self.hidden[index as usize])?.part.outline;
            outline.comes_into(low, high).then_some(Obstacle { id: FIRST + u64::from(index), outline })
        }));
    }

    /// What an obstacle is made of, by its number.
    pub(in crate::server) fn tag(&self, id: u64) -> Option<ClassTag> {
        self.all.get(usize::try_from(id.checked_sub(FIRST)?).ok()?).map(|one| one.part.tag)
    }
}

fn cells_of(low: DVec2, high: DVec2) -> impl Iterator<Item = [i64; 2]> {
    // Nobody goes so far in a step; a client may put somebody anywhere.
    const MOST: i64 = 64;
    let [x, y] = [low.x, low.y].map(|at| (at / CELL_M).floor() as i64);
    let [to_x, to_y] = [high.x, high.y].map(|at| (at / CELL_M).floor() as i64);
    let (to_x, to_y) = (to_x.min(x.saturating_add(MOST)), to_y.min(y.saturating_add(MOST)));
    (x..=to_x).flat_map(move |x| (y..=to_y).map(move |y| [x, y]))
}

/// A part of a thing where the thing stands.
fn placed(placement: &Placement, part: &OrientedBox) -> OrientedBox {
    let world = &placement.world_from_object;
    let to_world = |at: DVec2, z: f64| world.transform_point3(at.extend(z).as_vec3()).as_dvec3();
    let stretched = |axis: DVec2| world.transform_vector3(axis.extend(0.0).as_vec3()).as_dvec3().truncate();
    let (length, width) = (stretched(part.along), stretched(part.along.perp()));
    OrientedBox {
        centre: to_world(part.centre, 0.0).truncate(),
        half: part.half * DVec2::new(length.length(), width.length()),
        along: length.normalize_or(DVec2::X),
        low_m: to_world(part.centre, part.low_m).z,
        high_m: to_world(part.centre, part.high_m).z,
    }
}

fn parked(vehicle: &ParkedVehicle, catalogue: &Catalogue) -> Option<Part> {
    let spec = &catalogue.vehicle(vehicle.vehicle.model)?.spec;
    let place = vehicle.pose.position.as_dvec3();
    let outline = OrientedBox {
        centre: place.truncate(),
        half: 0.5 * DVec2::new(spec.length_m.into(), spec.width_m.into()),
        along: direction(vehicle.pose.yaw_rad.into()),
        low_m: place.z,
        high_m: place.z + f64::from(spec.height_m),
    };
    let tag = spec.class.tag();
    Some(Part { tag, classes: bit(tag), outline })
}

/// Whether vehicles would meet it that keep to their lane.
fn stands_on_lane(outline: &OrientedBox, roads: &CarlaMap) -> bool {
    /// From one look at the lanes to the next, metres.
    const STEP_M: f64 = 1.0;
    /// Below a lane and above it, metres: vehicles are upright boxes, also on slopes.
    const BELOW_M: f64 = 0.8;
    const ABOVE_M: f64 = 4.0;
    let steps = (outline.half.x / STEP_M).ceil().min(200.0) as i32;
    (-steps..=steps).any(|step| {
        let at = outline.centre + outline.along * (outline.half.x * f64::from(step) / f64::from(steps.max(1)));
        roads.lane_heights(at).any(|z| outline.low_m < z + ABOVE_M && outline.high_m > z - BELOW_M)
    })
}

/// The upright box of an actor's bounding box.
pub(in crate::server) fn upright(actor: &Transform, bounds: &BoundingBox) -> OrientedBox {
    let own = Transform { location: bounds.location.clone(), rotation: bounds.rotation.clone() };
    let placed = frames::place(&frames::attached(actor, &own));
    let [x, y, z] = [bounds.extent.x, bounds.extent.y, bounds.extent.z].map(f64::from);
    OrientedBox {
        centre: placed.position.truncate(),
        half: DVec2::new(x, y),
        along: direction(placed.yaw_rad),
        low_m: placed.position.z - z,
        high_m: placed.position.z + z,
    }
}

#[cfg(test)]
mod tests;
