//! Bodies that touch. A contact counts once, when it begins.

use super::body::Body;
use super::bus_door::goes_through;
use super::cell_grid::CellGrid;
use super::check::AuditCheck;
use super::finding::Incidents;
use super::report::AuditLine;
use super::sight::Sight;
use crate::walk_strip::SIDEWAYS_APART_M;
use endless_world::{Actor, InstanceId, VehicleSpec};
use glam::DVec2;

/// People are discs of this radius to vehicles, metres; to one another as those who turn their shoulders.
const PERSON_M: f64 = 0.25;
/// They touch when they overlap by more than this, metres: positions are rounded.
const ROUNDING_M: f64 = 1e-3;
/// Height of a person, metres.
const TALL_M: f64 = 1.8;

type Pair = (InstanceId, InstanceId);

/// Counts contacts.
#[derive(Debug, Default)]
pub(super) struct Contacts {
    parked: Vec<(InstanceId, Body)>,
    parked_grid: CellGrid,
    bodies: Vec<(InstanceId, Body)>,
    grid: CellGrid,
    people_grid: CellGrid,
    /// Who touches whom, in order.
    touching: Vec<Pair>,
    touched_before: Vec<Pair>,
    collisions: Incidents,
    people_hit: Incidents,
    people_touch: Incidents,
}

fn pieces(actor: &Actor, specs: &[VehicleSpec]) -> impl Iterator<Item = (InstanceId, Body)> {
    let spec = actor.asset.vehicle().map(|vehicle| &specs[vehicle.model.index()]);
    let id = actor.id;
    let pieces = spec.map(|spec| Body::pieces(actor, spec));
    pieces.into_iter().flatten().map(move |body| (id, body))
}

impl Contacts {
    pub(super) fn new(specs: &[VehicleSpec], parked: &[Actor]) -> Self {
        let parked: Vec<(InstanceId, Body)> = parked.iter().flat_map(|actor| pieces(actor, specs)).collect();
        let mut parked_grid = CellGrid::default();
        parked_grid.rebuild(parked.iter().map(|(_, body)| body.bounds()));
        Self { parked, parked_grid, ..Self::default() }
    }

    pub(super) fn look(&mut self, sight: &Sight<'_>) {
        self.touching.clear();
        self.vehicles(sight);
        self.people(sight);
        self.touching.sort_unstable();
        self.touching.dedup();
        for pair in &self.touching {
            if self.touched_before.binary_search(pair).is_ok() {
                continue;
            }
            let of = |id: InstanceId| sight.glances.iter().find(|glance| glance.actor.id == id);
            let (one, other) = (of(pair.0), of(pair.1));
            let told = || {
                let one = one.or(other).map(|glance| glance.told(sight)).unwrap_or_default();
                let other = other.map_or_else(
                    || format!("parked {}", pair.1),
                    |glance| format!("{} {}", glance.actor.class, glance.actor.id),
                );
                format!("{one} and {other}")
            };
            let on_foot = [one, other].into_iter().flatten().filter(|glance| glance.driven.is_none()).count();
            match on_foot {
                0 => self.collisions.add(told),
                1 => self.people_hit.add(told),
                _ => self.people_touch.add(told),
            }
        }
        std::mem::swap(&mut self.touching, &mut self.touched_before);
    }

    fn vehicles(&mut self, sight: &Sight<'_>) {
        self.bodies.clear();
        self.bodies.extend(sight.state.actors.iter().flat_map(|actor| pieces(actor, sight.specs)));
        self.grid.rebuild(self.bodies.iter().map(|(_, body)| body.bounds()));
        for (number, (id, body)) in self.bodies.iter().enumerate() {
            let bounds = body.bounds();
            let moving = self.grid.near(bounds).filter(|&other| other > number).map(|other| &self.bodies[other]);
            let parked = self.parked_grid.near(bounds).map(|other| &self.parked[other]);
            let touched = moving.chain(parked).filter(|(other_id, other)| other_id != id && body.touches(other));
            self.touching.extend(touched.map(|&(other, _)| (*id, other)));
        }
    }

    fn people(&mut self, sight: &Sight<'_>) {
        let people: Vec<_> = sight.glances.iter().filter(|glance| glance.driven.is_none()).collect();
        let around = |at: DVec2, metres: f64| [at - DVec2::splat(metres), at + DVec2::splat(metres)];
        self.people_grid.rebuild(people.iter().map(|person| [person.at; 2]));
        for (number, person) in people.iter().enumerate() {
            let (id, feet) = (person.actor.id, f64::from(person.actor.pose.position.z));
            let bounds = around(person.at, PERSON_M);
            let moving = self.grid.near(bounds).map(|other| &self.bodies[other]);
            let parked = self.parked_grid.near(bounds).map(|other| &self.parked[other]);
            let hit = moving
                .chain(parked)
                .filter(|(_, body)| body.touches_disc(person.at, PERSON_M - ROUNDING_M, feet, feet + TALL_M))
                .filter(|(vehicle, _)| !sight.of(*vehicle).is_some_and(|bus| goes_through(bus, person.at)));
            self.touching.extend(hit.map(|&(vehicle, _)| (id, vehicle)));
            let others = self.people_grid.near(around(person.at, SIDEWAYS_APART_M)).filter(|&other| other > number);
            let touched = others.map(|other| people[other]).filter(|other| {
                let apart_m = f64::from(other.actor.pose.position.z) - feet;
                other.at.distance(person.at) < SIDEWAYS_APART_M - ROUNDING_M && apart_m.abs() < TALL_M
            });
            self.touching.extend(touched.map(|other| (id, other.actor.id)));
        }
    }

    pub(super) fn lines(&self) -> Vec<AuditLine> {
        vec![
            self.collisions.line(AuditCheck::Collisions),
            self.people_hit.line(AuditCheck::PeopleHit),
            self.people_touch.line(AuditCheck::PeopleTouch),
        ]
    }
}
