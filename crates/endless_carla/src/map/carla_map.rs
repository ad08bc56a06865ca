//! A town as a CARLA server tells of it.

use super::georeference;
use super::ground::Ground;
use super::lane_index::LaneIndex;
use super::navmesh::{self, NavigationMesh};
use super::speed_limits::{speed_limit_signs, with_speed_limits};
use super::surface::{self, Surface};
use super::{LightCycle, TrafficLight, TrafficSign, signals, spawn};
use crate::frames;
use crate::wire::{Location, Transform};
use endless_road::RoadNetwork;
use endless_town::Town;
use glam::DVec2;
use std::sync::OnceLock;

/// A town as a CARLA server tells of it. All places are in CARLA's frame.
#[derive(Debug)]
pub struct CarlaMap {
    name: String,
    opendrive: String,
    network: RoadNetwork,
    spawn_points: Vec<Transform>,
    lights: Vec<TrafficLight>,
    signs: Vec<TrafficSign>,
    surfaces: Vec<Surface>,
    lanes: LaneIndex,
    /// Made when first asked for.
    ground: OnceLock<Ground>,
    /// Made when first asked for.
    navigation: OnceLock<Option<NavigationMesh>>,
}

impl CarlaMap {
    /// Of a town and its roads as an OpenDRIVE file, as our own writer has made it of the same network.
    pub fn new(town: &Town, opendrive: String) -> Self {
        let (lights, mut signs) = signals::signals(town);
        let limits = speed_limit_signs(town);
        let opendrive = with_speed_limits(&as_carla_reads(opendrive), &limits);
        signs.extend(limits.into_iter().map(|limit| limit.sign));
        Self {
            name: town.name.clone(),
            opendrive: georeference::with_georeference(opendrive, town.georeference),
            network: town.network.clone(),
            spawn_points: spawn::points(town),
            lights,
            signs,
            surfaces: surface::surfaces(town),
            lanes: LaneIndex::new(&town.network),
            ground: OnceLock::new(),
            navigation: OnceLock::new(),
        }
    }

    /// The same without a mesh for pedestrians.
    #[must_use]
    pub fn without_walkers(self) -> Self {
        Self { navigation: OnceLock::from(None), ..self }
    }

    /// The town's name, without a path.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The roads as an OpenDRIVE file.
    pub fn opendrive(&self) -> &str {
        &self.opendrive
    }

    /// Places where vehicles may appear: on lanes, away from junctions and parked vehicles, with room for a bus, 0.4 m
    /// above the road. The same every time.
    pub fn spawn_points(&self) -> &[Transform] {
        &self.spawn_points
    }

    /// Traffic lights, by road.
    pub fn traffic_lights(&self) -> &[TrafficLight] {
        &self.lights
    }

    /// Stop and give-way signs, then speed limits, each by road.
    pub fn traffic_signs(&self) -> &[TrafficSign] {
        &self.signs
    }

    /// All lights at the beginning of their cycle.
    pub fn light_cycle(&self) -> LightCycle {
        LightCycle::new(&self.lights)
    }

    /// The light at which a vehicle stands whose middle is at a place, as an index into
    /// [`traffic_lights`](Self::traffic_lights).
    pub fn light_at(&self, place: &Location) -> Option<usize> {
        self.lights.iter().position(|light| light.trigger_boxes.iter().any(|bounds| signals::holds(bounds, place)))
    }

    /// Height of the road, sidewalk or crossing at a place, metres: of that nearest to the place's own height. Beside all
    /// of them as the nearest road has it; `None` far from all roads.
    pub fn ground_height(&self, place: &Location) -> Option<f32> {
        let at = frames::from_carla(place).as_dvec3();
        let ground = self.ground.get_or_init(|| Ground::new(&self.surfaces));
        let height = ground.height(&self.surfaces, at).or_else(|| self.network.ground_near(at.truncate()));
        height.map(|z| z as f32)
    }

    /// Heights of the lanes at a place of this workspace's world, metres.
    pub(crate) fn lane_heights(&self, at: DVec2) -> impl Iterator<Item = f64> {
        self.ground.get_or_init(|| Ground::new(&self.surfaces)).lane_heights(&self.surfaces, at)
    }

    /// Height of the lowest road, metres.
    pub fn lowest_m(&self) -> f32 {
        let heights = self.network.lanes.iter().flat_map(|lane| lane.centerline.points()).map(|point| point.z);
        heights.reduce(f64::min).unwrap_or(0.0) as f32
    }

    /// The speed limit of the nearest lane, km/h; `None` far from all lanes.
    pub fn speed_limit_kmh(&self, place: &Location) -> Option<f32> {
        let lane = self.lanes.nearest(frames::from_carla(place).as_dvec3())?;
        Some((self.network.lane(lane).speed_limit_mps * 3.6) as f32)
    }

    /// The mesh on which pedestrians find their way; `None` where nobody can walk. Made when first asked for, which takes
    /// seconds on a large town.
    pub fn navigation(&self) -> Option<&NavigationMesh> {
        self.navigation.get_or_init(|| navmesh::build(&self.name, &self.surfaces)).as_ref()
    }
}

/// CARLA's reader is of a version of the standard without direct junctions: there every connection has a connecting road.
fn as_carla_reads(opendrive: String) -> String {
    if opendrive.contains(" linkedRoad=") {
        return opendrive.replace(" linkedRoad=", " connectingRoad=");
    }
    opendrive
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::SignKind;
    use endless_asset::Catalogue;
    use endless_road::{RoadMap, TrafficControl, opendrive};
    use endless_world::math::f64::sin_cos;
    use glam::{DVec2, DVec3};
    use std::collections::BTreeSet;
    use std::sync::LazyLock;

    static TOWN: LazyLock<(Town, CarlaMap)> = LazyLock::new(|| {
        let town = endless_town::load("Town02", &Catalogue::builtin()).expect("a town");
        let roads = RoadMap { network: town.network.clone(), ..RoadMap::default() };
        let map = CarlaMap::new(&town, opendrive::write(&roads, &town.name));
        (town, map)
    });

    #[test]
    fn lights_and_signs_are_those_of_the_file() {
        let (town, map) = &*TOWN;
        let in_file = |kind: &str| map.opendrive().matches(&format!("type=\"{kind}\"")).count();
        assert_eq!(map.traffic_lights().len(), in_file("1000001"));
        let of_kind = |kind: SignKind| map.traffic_signs().iter().filter(|sign| sign.kind == kind).count();
        assert_eq!([of_kind(SignKind::Stop), of_kind(SignKind::Yield)], [in_file("206"), in_file("205")]);
        let limits: Vec<&TrafficSign> =
            map.traffic_signs().iter().filter(|sign| matches!(sign.kind, SignKind::SpeedLimit(_))).collect();
        assert_eq!(limits.len(), in_file("274"));
        assert!(limits.len() > 20, "{}", limits.len());
        for limit in limits {
            let SignKind::SpeedLimit(kmh) = limit.kind else { continue };
            // Who passes it is told the same.
            for passed in &limit.trigger_boxes {
                let told = map.speed_limit_kmh(&passed.location).expect("a lane");
                assert!((told - f32::from(kmh)).abs() <= 0.5, "{told} {limit:?}");
            }
        }
        let again = opendrive::read(map.opendrive()).expect("a map");
        assert_eq!(again.network.lanes.len(), town.network.lanes.len());
        let ids = map.traffic_lights().iter().map(|l| &l.sign_id).chain(map.traffic_signs().iter().map(|s| &s.sign_id));
        let ids: Vec<&String> = ids.collect();
        assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len());
        for id in ids {
            let signal = map
                .opendrive()
                .lines()
                .find(|line| line.contains("<signal ") && line.contains(&format!("id=\"{id}\"")));
            assert!(signal.is_some(), "{id}");
            assert!(id.len() < 32, "snapshots have 32 bytes for it");
        }
        let held = |lane: &&endless_road::Lane| matches!(lane.end_control, TrafficControl::Signal(_));
        let lanes: usize = map.traffic_lights().iter().map(|light| light.lanes.len()).sum();
        assert_eq!(lanes, town.network.lanes.iter().filter(held).count());
    }

    #[test]
    fn vehicles_stand_at_the_light_of_their_lane() {
        let (town, map) = &*TOWN;
        for (index, light) in map.traffic_lights().iter().enumerate() {
            for (&lane, bounds) in light.lanes.iter().zip(&light.trigger_boxes) {
                let line = &town.network.lane(lane).centerline;
                let before = |m: f64| frames::to_carla(line.position(line.length() - m).as_vec3());
                assert_eq!(map.light_at(&before(1.0)), Some(index));
                assert_eq!(map.light_at(&before(20.0)), None);
                assert_eq!(
                    bounds.rotation,
                    frames::heading(DVec3::ZERO, line.at(line.length()).heading_rad, 0.0).rotation
                );
            }
            // The box in the frame of the pole is where the others are.
            let (pole, volume) = (&light.pole, &light.trigger_volume);
            let (sin, cos) = sin_cos(f64::from(pole.rotation.yaw).to_radians());
            let local = DVec2::new(f64::from(volume.location.x), f64::from(volume.location.y));
            let turned = DVec2::new(cos * local.x - sin * local.y, sin * local.x + cos * local.y);
            let middle = turned + DVec2::new(f64::from(pole.location.x), f64::from(pole.location.y));
            let of_boxes =
                light.trigger_boxes.iter().map(|b| DVec2::new(f64::from(b.location.x), f64::from(b.location.y)));
            let of_boxes = of_boxes.sum::<DVec2>() / light.trigger_boxes.len() as f64;
            assert!(middle.distance(of_boxes) < 1.0, "{middle} {of_boxes}");
            assert!(middle.distance(DVec2::new(f64::from(pole.location.x), f64::from(pole.location.y))) < 30.0);
            // Across the road, then along it.
            assert!(volume.extent.x < 3.0 * light.lanes.len() as f32 && volume.extent.y < 7.0);
        }
    }

    #[test]
    fn lights_of_a_junction_take_turns() {
        let (town, map) = &*TOWN;
        let groups: BTreeSet<u32> = map.traffic_lights().iter().map(|light| light.group).collect();
        assert_eq!(groups.len(), town.network.junctions.iter().filter(|j| j.program.is_some()).count());
        let mut cycle = map.light_cycle();
        let mut was_green = BTreeSet::new();
        for _ in 0..600 {
            for light in map.traffic_lights().iter().enumerate().filter(|(i, _)| cycle.state(*i).number() == 2) {
                was_green.insert(light.0);
                let others = cycle.group(light.0).into_iter().filter(|&other| cycle.state(other).number() == 2);
                assert!(others.map(|other| &map.traffic_lights()[other]).all(|other| other.stage == light.1.stage));
            }
            cycle.tick(0.1);
        }
        assert_eq!(was_green.len(), map.traffic_lights().len());
        assert!(map.traffic_lights().iter().any(|light| light.stage > 0));
    }

    #[test]
    fn vehicles_spawn_apart_above_the_road() {
        let (town, map) = &*TOWN;
        let points = map.spawn_points();
        assert!(points.len() > 60, "{}", points.len());
        for (i, point) in points.iter().enumerate() {
            let above = point.location.z - map.ground_height(&point.location).expect("a road");
            assert!((0.3..0.5).contains(&above), "{above}");
            assert!((20.0..60.0).contains(&map.speed_limit_kmh(&point.location).expect("a lane")));
            let place = frames::from_carla(&point.location).as_dvec3();
            for other in &points[..i] {
                assert!(place.distance(frames::from_carla(&other.location).as_dvec3()) > 2.7);
            }
            for parked in &town.parked {
                assert!(place.distance(parked.pose.position.as_dvec3()) > 2.4);
            }
        }
        assert_eq!(map.speed_limit_kmh(&Location { x: 1e5, y: 0.0, z: 0.0 }), None);
    }

    #[test]
    fn sidewalks_are_higher_than_roads() {
        let (town, map) = &*TOWN;
        for node in &town.network.walk.nodes {
            let z = f64::from(map.ground_height(&frames::to_carla(node.as_vec3())).expect("a sidewalk"));
            assert!((z - node.z).abs() < 0.05, "{z} {}", node.z);
        }
        assert_eq!(map.ground_height(&Location { x: 1e5, y: 0.0, z: 0.0 }), None);
        let mesh = map.navigation().expect("people walk");
        assert!(mesh.file_name.starts_with("Nav/Town02-") && mesh.file_name.ends_with(".bin"));
    }

    #[test]
    #[ignore = "all towns: half a minute"]
    fn all_towns_have_room_for_traffic() {
        for name in endless_town::NAMES {
            let town = endless_town::load(name, &Catalogue::builtin()).expect("a town");
            let map = CarlaMap::new(&town, String::new());
            let (points, lights) = (map.spawn_points().len(), map.traffic_lights().len());
            println!("{name}: {points} spawn points, {lights} lights, {} signs", map.traffic_signs().len());
            assert!(points > 60, "{name}: {points}");
            for point in map.spawn_points() {
                let ground = map.ground_height(&point.location).expect("a road");
                assert!((0.3..0.5).contains(&(point.location.z - ground)), "{name}: {point:?} {ground}");
            }
        }
    }

    #[test]
    fn direct_junctions_are_written_as_carla_reads_them() {
        let text = "<connection id=\"0\" incomingRoad=\"1\" linkedRoad=\"2\" contactPoint=\"start\">".to_owned();
        assert!(as_carla_reads(text).contains(" connectingRoad=\"2\""));
    }
}
