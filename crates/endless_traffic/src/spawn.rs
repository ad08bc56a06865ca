//! Spawns the actors of a scene.

use crate::company_draw::{CompanyDraw, look_for};
use crate::driver::Driver;
use crate::emergency;
use crate::filtering;
use crate::jogging;
use crate::kinematics;
use crate::roads::{RoadTables, Roads, TrafficMap};
use crate::settings::TrafficSettings;
use crate::sitting;
use crate::vehicle::Vehicle;
use crate::vehicle_mix;
use crate::walker::Walker;
use endless_road::swept::OrientedRectangle;
use endless_road::{SpawnPoint, WalkEdgeId, WalkGraph, WalkKind};
use endless_world::walking::PedestrianSpec;
use endless_world::{LookPool, ParkedVehicle, Stream, VehicleModelId, VehicleRef, VehicleSpec, choose_vehicle};
use glam::DVec2;

/// Gap between vehicles that spawn on the same lane, metres.
const GAP_M: f64 = 3.5;
/// Least distance between the middles of people, metres.
const APART_M: f64 = 0.56;
/// Places tried for a person, and if none is free.
const TRIES: u32 = 60;
const CROWDED_TRIES: u32 = 300;
/// Places among which the roomiest is taken.
const CANDIDATES: usize = 40;
/// Room kept to vehicles on other lanes, metres.
const CLEAR_M: f64 = 0.4;
/// Who is further above or below is on another level, metres.
const STOREY_M: f64 = 3.0;
/// Room kept to parked vehicles, metres.
const PARKED_M: f64 = 0.15;
/// Vehicles that may find no room before the town counts as full.
const MISSES: u64 = 40;

/// The spawn points on lanes where vehicles of some model circulate.
pub(crate) fn points(roads: &RoadTables, models: usize) -> Vec<SpawnPoint> {
    let usable = |p: &SpawnPoint| (0..models).any(|m| roads.allowed(VehicleModelId::from_index(m))[p.lane.index()]);
    roads.network.spawn_points.iter().copied().filter(usable).collect()
}

/// Lane that every vehicle needs to find its way in, metres: with less, all wait for one another on a small map.
const ROOM_M: f64 = 16.0;
/// The same where vehicles leave the map, so that nobody waits in a circle.
const OPEN_ROOM_M: f64 = 10.0;
/// Vehicles on a kilometre of lane where all stand: `examples/realism` measures it.
const JAM_PER_KM: f64 = 145.0;
/// Share of that beyond which a network carries no more, and queues reach back from one junction to the next: between a fifth and a
/// quarter in the centre of Yokohama (Geroliminis and Daganzo 2008, "Existence of urban-scale macroscopic fundamental diagrams").
const CRITICAL_SHARE: f64 = 0.25;

/// Simulated before a scene's first frame, at most, seconds.
const WARM_UP_S: f64 = 25.0;
/// Of which vehicles need so much to come up to speed, seconds.
const SPEED_UP_S: f64 = 5.0;
/// Metres of lane for which a second more is needed.
const LANES_MIXED_MPS: f64 = 100.0;

/// How many vehicles find room on the lanes on which they circulate.
pub(crate) fn capacity(roads: &RoadTables, models: usize) -> usize {
    let room = if roads.borders.are_open() { OPEN_ROOM_M } else { ROOM_M };
    as_many_as(roads, models, 1.0 / room)
}

impl TrafficMap {
    /// How many vehicles its lanes take so that traffic still flows: the number at the top of the map's macroscopic fundamental
    /// diagram.
    pub fn most_that_flow(&self) -> u32 {
        as_many_as(&self.0, self.0.specs.len(), JAM_PER_KM / 1000.0 * CRITICAL_SHARE) as u32
    }
}

/// So many a metre of the lanes on which vehicles circulate.
fn as_many_as(roads: &RoadTables, models: usize, per_metre: f64) -> usize {
    let points = points(roads, models);
    points.len().min((lanes_m(roads, &points) * per_metre).ceil() as usize)
}

/// How long the lanes are on which vehicles can spawn, metres.
fn lanes_m(roads: &RoadTables, points: &[SpawnPoint]) -> f64 {
    let mut lanes: Vec<_> = points.iter().map(|p| p.lane).collect();
    lanes.sort_unstable();
    lanes.dedup();
    lanes.iter().map(|&lane| roads.table(lane).length).sum()
}

/// For how long a scene is simulated before its first frame, seconds: until who stood has come up to speed and has met others at
/// junctions. A small map is soon driven through; later most would stand before its one junction.
pub(crate) fn warm_up_s(roads: &RoadTables, models: usize) -> f64 {
    (SPEED_UP_S + lanes_m(roads, &points(roads, models)) / LANES_MIXED_MPS).min(WARM_UP_S)
}

/// The bodies of parked vehicles, with room around them.
pub(crate) fn standing(specs: &[VehicleSpec], parked: &[ParkedVehicle]) -> Vec<OrientedRectangle> {
    let body = |ParkedVehicle { vehicle, pose }: &ParkedVehicle| {
        let spec = &specs[vehicle.model.index()];
        OrientedRectangle::new(spec, pose.position.as_dvec3().truncate(), f64::from(pose.yaw_rad), PARKED_M)
    };
    parked.iter().map(body).collect()
}

/// As many vehicles as asked for, or as fit, in rest pose on their lanes.
pub(crate) fn vehicles(
    roads: &Roads,
    specs: &[VehicleSpec],
    standing: &[OrientedRectangle],
    settings: &TrafficSettings,
) -> Vec<Vehicle> {
    let seed = settings.seed;
    let mut free = points(roads, specs.len());
    // Models that find no way round this town stay away.
    let has_way = |m: usize| roads.allowed(VehicleModelId::from_index(m)).contains(&true);
    let frequencies = vehicle_mix::frequencies(specs, &settings.profile);
    let weights: Vec<f64> =
        frequencies.into_iter().enumerate().map(|(m, frequency)| if has_way(m) { frequency } else { 0.0 }).collect();
    let mut placed: Vec<Vehicle> = Vec::new();
    // Vehicles that found no room: in all, and in the slot that is to be filled.
    let (mut misses, mut tries) = (0, 0);
    // Classes of `settings.first` of which none can be placed here.
    let mut denied = 0;
    let most = capacity(roads, specs.len()).min(settings.vehicles as usize);
    while placed.len() < most && !free.is_empty() {
        let mut own = Stream::named(seed, "traffic.vehicle", &[placed.len() as u64, tries]);
        let wanted = settings.first.get(placed.len() + denied);
        let fits_class = |spec: &VehicleSpec| wanted.is_none_or(|class| spec.class == *class);
        let weigh = |(spec, weight): (_, &f64)| (spec, if fits_class(spec) { *weight } else { 0.0 });
        let weighed = specs.iter().zip(&weights).map(weigh);
        let Some(model) = choose_vehicle(&mut own, weighed) else {
            if wanted.is_none() {
                break;
            }
            denied += 1;
            continue;
        };
        let spec = &specs[model.index()];
        let half = 0.5 * f64::from(spec.length_m);
        let fits = |p: &SpawnPoint| {
            let length = roads.table(p.lane).length;
            let on = roads.network.lane(p.lane).centerline.at(p.s);
            let body = OrientedRectangle::new(spec, on.position.truncate(), on.heading_rad, 0.0);
            let inside = roads.allowed(model)[p.lane.index()] && p.s > half + 1.0 && p.s < length - half - 1.0;
            inside
                && placed.iter().all(|v| v.lane() != p.lane || (v.s - p.s).abs() > v.half_length + half + GAP_M)
                && placed.iter().all(|v| {
                    let apart = v.pose.position.as_dvec3() - on.position;
                    let far = apart.truncate().length() > 20.0 || apart.z.abs() > STOREY_M;
                    far || !body.overlaps(&v.footprint(specs, CLEAR_M))
                })
                && standing.iter().all(|other| other.center.distance(body.center) > 20.0 || !body.overlaps(other))
        };
        // The roomiest of some places: each place has a rank of its own, so that one more or less leaves the others.
        let drawn = roads.attraction.draws(&mut own);
        let salt = own.next_u64();
        let rank = |p: &SpawnPoint| Stream::new(salt, &[u64::from(p.lane.0), p.s.to_bits()]).next_u64();
        let mut ranked: Vec<(u64, usize)> = free.iter().enumerate().map(|(i, p)| (rank(p), i)).collect();
        ranked.sort_unstable();
        let fitting = ranked.into_iter().map(|(_, i)| i).filter(|&i| fits(&free[i]));
        let candidates: Vec<usize> = fitting.take(CANDIDATES).collect();
        let room = |&i: &usize| {
            let at = roads.network.lane(free[i].lane).centerline.at(free[i].s).position.truncate();
            let wanted = roads.attraction.departure_density(&roads.network, free[i].lane, free[i].s, drawn);
            wanted * room_at(at, placed.iter().map(|v| v.pose.position.as_dvec3().truncate()))
        };
        let Some(place) = candidates.into_iter().max_by(|a, b| room(a).total_cmp(&room(b))) else {
            // Nothing of this length fits any more; a shorter one may.
            (misses, tries) = (misses + 1, tries + 1);
            if misses > MISSES {
                if wanted.is_none() {
                    break;
                }
                (misses, denied) = (0, denied + 1);
            }
            continue;
        };
        tries = 0;
        let point = free.remove(place);
        let taken = |seed| placed.iter().any(|v| v.asset == VehicleRef { model, variant: seed });
        let variant = vehicle_mix::looks(spec, settings.profile.region).draw(own.next_u64(), taken);
        let asset = VehicleRef { model, variant };
        let driver = Driver::new(spec, &settings.condition, settings.profile.aggressiveness, &mut own);
        let mut vehicle = Vehicle::new(spec, asset, driver, point.lane, point.s, own);
        emergency::call(roads, &mut vehicle);
        vehicle.drawn = drawn;
        vehicle.rides_past_queues = filtering::rides_past_queues(&vehicle, settings.profile.region);
        vehicle.plan(roads);
        kinematics::settle(&mut vehicle, roads);
        placed.push(vehicle);
    }
    placed
}

/// How much room a place has: the square of the distance to the nearest of those placed, to be weighed with the density
/// that is wanted there. Taking the roomiest of some random places spreads points evenly (Mitchell 1991, "Spectrally
/// optimal sampling for distribution ray tracing").
fn room_at(at: DVec2, placed: impl Iterator<Item = DVec2>) -> f64 {
    placed.map(|p| p.distance_squared(at)).fold(1e6, f64::min)
}

/// As many people as asked for, or as find room on the sidewalks.
pub(crate) fn walkers(
    roads: &Roads,
    graph: &WalkGraph,
    pedestrian: &dyn Fn(u64) -> PedestrianSpec,
    settings: &TrafficSettings,
) -> Vec<Walker> {
    let walk = &roads.network.walk;
    let lengths: Vec<f64> = walk
        .edges
        .iter()
        .map(|e| {
            let [a, b] = e.nodes.map(|n| walk.nodes[n.index()]);
            if e.kind == WalkKind::Sidewalk { a.distance(b) } else { 0.0 }
        })
        .collect();
    let mut placed: Vec<Walker> = Vec::new();
    if lengths.iter().sum::<f64>() <= 0.0 {
        return placed;
    }
    let mut companies = CompanyDraw::new(settings.seed, settings.groups);
    for k in 0..settings.pedestrians {
        let mut own = Stream::named(settings.seed, "traffic.walker", &[u64::from(k)]);
        let variant = if settings.groups > 0.0 {
            look_for(placed.last().filter(|_| companies.joins()), pedestrian, &placed, &mut own)
        } else {
            LookPool::people().draw(own.next_u64(), |seed| placed.iter().any(|w| w.variant == seed))
        };
        let hurries = own.chance(0.05);
        let spec = pedestrian(variant);
        let brisk = own.range_f64(0.92, 1.08);
        let pace = f64::from(spec.walk_mps).clamp(0.6, 2.0) * if hurries && spec.can_run() { 1.9 } else { brisk };
        let jogs = if companies.joins() { None } else { jogging::pace_mps(&spec, &settings.condition, &own) };
        let (pace, jogs) = (jogs.unwrap_or(pace), jogs.is_some());
        let side = own.range_f64(0.15, 0.85);
        let drawn = roads.attraction.draws(&mut own);
        // Who pushes or draws something uses crossings.
        let jaywalks = spec.can_run()
            && !jogs
            && settings.jaywalking > 0.0
            && Stream::named(settings.seed, "traffic.jaywalker", &[u64::from(k)]).chance(settings.jaywalking);
        if companies.joins() {
            companies.joined();
            if let Some(position) = companies.place(roads, &placed, APART_M) {
                let first = companies.first(&placed);
                let (edge, to) = first.way[0];
                let at = (edge, [first.from, to]);
                let walked = own.range_f64(0.0, 2.0);
                let drawn = first.drawn;
                placed.push(Walker {
                    variant,
                    drawn,
                    pace,
                    walked,
                    ..Walker::new(roads, &spec, at, position, own.fork(1))
                });
                companies.finish(roads, graph, &mut placed);
                continue;
            }
        }
        let mut best: Option<(f64, Walker)> = None;
        let mut found = 0;
        for attempt in 0..CROWDED_TRIES {
            // Where it is crowded, people are anywhere on their half of the sidewalk.
            let across = match attempt {
                0..TRIES => side,
                _ if best.is_some() => break,
                _ => own.range_f64(0.0, 1.0),
            };
            let edge = WalkEdgeId(own.weighted(&lengths) as u32);
            let mut nodes = walk.edges[edge.index()].nodes;
            if own.chance(0.5) {
                nodes.reverse();
            }
            let [a, b] = nodes.map(|n| walk.nodes[n.index()].truncate());
            let along = (b - a).normalize_or(DVec2::X);
            let room = (0.5 * walk.edges[edge.index()].width_m - 0.25).max(0.1);
            let share = own.range_f64(0.05, 0.95);
            let position = a.lerp(b, share) - along.perp() * (across * room);
            let from_first = a.distance(b) * if nodes == walk.edges[edge.index()].nodes { share } else { 1.0 - share };
            let seen = drawn && roads.attraction.focus.on_walk(edge.index(), from_first) != 0;
            if placed.iter().any(|w| w.position.distance(position) < APART_M) {
                continue;
            }
            let room = roads.attraction.density(position, seen) * room_at(position, placed.iter().map(|w| w.position));
            found += 1;
            if best.as_ref().is_some_and(|(other, _)| *other >= room) {
                continue;
            }
            let walker = Walker {
                variant,
                drawn,
                pace,
                side,
                jaywalks,
                jogs,
                walked: own.range_f64(0.0, 2.0),
                ..Walker::new(roads, &spec, (edge, nodes), position, own.fork(1))
            };
            best = Some((room, walker));
            if found == CANDIDATES {
                break;
            }
        }
        if let Some((_, mut walker)) = best {
            walker.plan(roads, graph);
            placed.push(walker);
            // Who jogs does so alone.
            if !jogs {
                companies.begin(&placed);
            }
        }
    }
    sitting::seat_some(roads, &mut placed, &settings.condition, settings.seed);
    placed
}

#[cfg(test)]
mod tests;
