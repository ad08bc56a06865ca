//! What stands on posts: traffic lights, signs, street lamps; and the things that a map names.

use crate::dressing::assembly::{PropPose, TownAssembly};
use crate::dressing::ground::ground_grid::GroundGrid;
use crate::dressing::ground::pavement_index::PavementIndex;
use crate::dressing::preset::TownPreset;
use crate::geometry::unit;
use endless_asset::{Catalogue, Prop};
use endless_road::{Lane, MapObjectKind, RoadMap, TrafficControl};
use endless_scene::StreetLamp;
use endless_world::SignalId;
use glam::{DVec2, DVec3, Vec3};
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, PI};

/// From the edge of the carriageway to the middle of posts, metres.
pub(crate) const POST_M: f64 = 0.55;
const HALF: DVec2 = DVec2::splat(0.2);
/// Distance between lamps, metres.
const LAMPS_M: f64 = 30.0;
/// Roads at least this fast are lit even without sidewalks, m/s.
const LIT_FROM_MPS: f64 = 16.0;
/// Most lamps of a map.
const MOST_LAMPS: usize = 900;

/// Signs of the German catalogue (VzKat), which most OpenDRIVE files use, and what they are in the Vienna Convention.
const GERMAN: &[(&str, &str)] = &[
    ("101", "A,32"),
    ("103", "A,1b"),
    ("105", "A,1b"),
    ("123", "A,16"),
    ("131", "A,17a"),
    ("133", "A,12"),
    ("136", "A,13"),
    ("209", "D,1a"),
    ("215", "D,3"),
    ("220", "E,3"),
    ("222", "D,2"),
    ("237", "D,4"),
    ("240", "D,4"),
    ("241", "D,4"),
    ("250", "C,2"),
    ("267", "C,1"),
    ("283", "C,19"),
    ("286", "C,18"),
    ("306", "B,3"),
    ("314", "E,14"),
];

/// The variant of [`Prop::TrafficSign`] with exactly this code.
pub(crate) fn sign_variant(code: &str) -> Option<u32> {
    Catalogue::sign_codes().iter().position(|c| *c == code).map(|k| k as u32)
}

/// The face of a sign of this code (country, type, subtype): of the German catalogue or of the MUTCD.
fn face_of(code: &str) -> Option<u32> {
    let words = code.split(|c: char| !c.is_ascii_alphanumeric() && c != '-');
    let found = words.filter_map(|word| {
        let german = GERMAN.iter().find(|g| g.0 == word.split('-').next().unwrap_or(word));
        german.map_or_else(|| sign_variant(word), |g| sign_variant(g.1))
    });
    found.max()
}

/// A point beside a carriageway.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RoadsideSpot {
    pub(crate) at: DVec2,
    pub(crate) z: f64,
    /// Whether it lies on a pavement for people.
    pub(crate) walk: bool,
}

/// Places posts beside roads: signals, signs, lamps, stops.
pub(crate) struct RoadsidePosts<'a> {
    pub(crate) map: &'a RoadMap,
    pub(crate) pavement: &'a PavementIndex,
    pub(crate) land: &'a GroundGrid,
    pub(crate) preset: &'a TownPreset,
}

impl RoadsidePosts<'_> {
    /// The side of a lane where posts stand, seen by its driver: −1 is right.
    pub(crate) fn side(&self) -> f64 {
        if self.map.left_hand { 1.0 } else { -1.0 }
    }

    /// Whether a lane is the outermost of its direction.
    pub(crate) fn is_outermost(&self, lane: &Lane) -> bool {
        if self.map.left_hand { lane.left.is_none() } else { lane.right.is_none() }
    }

    /// The outermost lanes of streets, junctions apart, with their places among all.
    pub(crate) fn kerb_lanes(&self) -> impl Iterator<Item = (usize, &Lane)> {
        self.map.network.lanes.iter().enumerate().filter(|(_, lane)| lane.junction.is_none() && self.is_outermost(lane))
    }

    /// The place `beyond` metres outside the carriageway at `s` of a lane, on its `side`.
    pub(crate) fn verge(&self, lane: &Lane, s: f64, side: f64, beyond: f64) -> Option<RoadsideSpot> {
        let place = lane.centerline.at(s);
        let out = unit(place.heading_rad).perp() * side;
        let here = place.position.truncate();
        let drives = |d: f64| {
            self.pavement.at(here + out * d).any(|(p, z)| {
                crate::dressing::ground::pavement_index::is_carriageway(p.kind) && (z - place.position.z).abs() < 1.0
            })
        };
        let edge =
            (0..44).map(|k| lane.width_m / 2.0 - 0.2 + 0.2 * f64::from(k)).find(|&d| !drives(d) && !drives(d + 0.3))?;
        if drives(edge + beyond) || drives(edge + beyond + 0.25) {
            return None;
        }
        let at = here + out * (edge + beyond);
        let paved = self.pavement.height(at, place.position.z + 1.0).filter(|z| (z - place.position.z).abs() < 1.0);
        let z = paved.unwrap_or_else(|| self.land.height(at));
        ((z - place.position.z).abs() < 1.2).then_some(RoadsideSpot { at, z, walk: paved.is_some() })
    }

    fn put(
        &self,
        assembly: &mut TownAssembly<'_>,
        prop: Prop,
        at: DVec2,
        z: f64,
        yaw: f64,
        signal: Option<SignalId>,
    ) -> bool {
        assembly.put(prop, PropPose { z, ..PropPose::new(at, yaw) }, HALF, signal)
    }

    /// Height on which something at a place stands.
    pub(crate) fn ground(&self, p: DVec3) -> f64 {
        let near = self.pavement.height(p.truncate(), p.z + 2.0).filter(|z| (z - p.z).abs() < 2.0);
        near.unwrap_or_else(|| self.land.height(p.truncate()))
    }

    /// Traffic lights where the map has them, beside the road if it has them on it, and at every approach that lacks one.
    pub(crate) fn signals(&self, assembly: &mut TownAssembly<'_>) {
        let mut shown: BTreeSet<SignalId> = BTreeSet::new();
        for object in &self.map.objects {
            let at = object.position.truncate();
            let (prop, signal) = match object.kind {
                MapObjectKind::TrafficLight(signal) => (Prop::SignalPole, signal),
                MapObjectKind::WalkLight(signal) => (Prop::WalkSignal, signal),
                _ => continue,
            };
            let yaw = object.heading_rad + PI;
            let free = !self.pavement.is_carriageway(at);
            if free && self.put(assembly, prop, at, self.ground(object.position), yaw, Some(signal)) {
                shown.insert(signal);
            }
        }
        for lane in self.map.network.lanes.iter().filter(|l| self.is_outermost(l)) {
            let TrafficControl::Signal(signal) = lane.end_control else { continue };
            if shown.contains(&signal) && !self.map.objects.is_empty() && self.is_shown_near(assembly, lane, signal) {
                continue;
            }
            self.head_at_stop_line(assembly, lane, signal);
        }
    }

    /// Whether a head of the group faces the end of a lane.
    fn is_shown_near(&self, assembly: &TownAssembly<'_>, lane: &Lane, signal: SignalId) -> bool {
        let end = lane.centerline.at(lane.centerline.length());
        let forward = unit(end.heading_rad);
        assembly.placements.iter().filter(|p| p.signal == Some(signal)).any(|p| {
            let at = p.world_from_object.translation.truncate().as_dvec2() - end.position.truncate();
            let faces = p.world_from_object.transform_vector3(Vec3::X).truncate().as_dvec2();
            at.length() < 45.0 && at.dot(forward) > -6.0 && faces.dot(forward) < -0.5
        })
    }

    fn head_at_stop_line(&self, assembly: &mut TownAssembly<'_>, lane: &Lane, signal: SignalId) {
        let length = lane.centerline.length();
        let yaw = lane.centerline.at(length).heading_rad + PI;
        let wide = self.preset.masts_everywhere || lane.left.is_some() || lane.right.is_some();
        // Their arms reach to the left.
        let prop = if wide && !self.map.left_hand { self.preset.signal_mast } else { Prop::SignalPole };
        let repeater = self.preset.signal_repeaters.then_some((Prop::SignalPole, -self.side()));
        for (prop, side) in [Some((prop, self.side())), repeater].into_iter().flatten() {
            let places = [0.2, 1.2, 2.4, 4.0].into_iter().flat_map(|back| [(back, POST_M), (back, 1.2)]);
            for (back, beyond) in places {
                let verge = self.verge(lane, length - back, side, beyond);
                if verge.is_some_and(|v| self.put(assembly, prop, v.at, v.z, yaw, Some(signal))) {
                    break;
                }
            }
        }
    }

    /// Signs of the map, and those that stop lines without one need.
    pub(crate) fn signs(&self, assembly: &mut TownAssembly<'_>) {
        let mut known: Vec<DVec2> = Vec::new();
        for object in &self.map.objects {
            let prop = match &object.kind {
                MapObjectKind::Stop => Prop::StopSign,
                MapObjectKind::Yield => Prop::YieldSign,
                MapObjectKind::SpeedLimit(_) => Prop::SpeedSign,
                MapObjectKind::Sign(code) if code.contains("350") => Prop::CrossingSign,
                MapObjectKind::Sign(code) => {
                    let at = object.position.truncate();
                    if let Some(variant) = face_of(code).filter(|_| !self.pavement.is_carriageway(at)) {
                        let spot =
                            PropPose { z: self.ground(object.position), ..PropPose::new(at, object.heading_rad + PI) };
                        assembly.put_variant((Prop::TrafficSign, variant), spot, HALF);
                    }
                    continue;
                }
                _ => continue,
            };
            let at = object.position.truncate();
            let yaw = object.heading_rad + PI;
            if !self.pavement.is_carriageway(at)
                && self.put(assembly, prop, at, self.ground(object.position), yaw, None)
                && matches!(object.kind, MapObjectKind::Stop | MapObjectKind::Yield)
            {
                known.push(at);
            }
        }
        for lane in self.map.network.lanes.iter().filter(|l| self.is_outermost(l)) {
            let prop = match lane.end_control {
                TrafficControl::Stop => Prop::StopSign,
                TrafficControl::Yield => Prop::YieldSign,
                _ => continue,
            };
            let length = lane.centerline.length();
            let end = lane.centerline.at(length);
            if known.iter().any(|at| at.distance(end.position.truncate()) < 12.0) {
                continue;
            }
            for back in [0.8, 2.0, 3.5] {
                let verge = self.verge(lane, length - back, self.side(), POST_M);
                if verge.is_some_and(|v| self.put(assembly, prop, v.at, v.z, end.heading_rad + PI, None)) {
                    break;
                }
            }
        }
    }

    /// The rest of what the map names.
    pub(crate) fn street_furniture(&self, assembly: &mut TownAssembly<'_>) {
        for object in &self.map.objects {
            let (prop, half) = match object.kind {
                MapObjectKind::Bench => (Prop::Bench, DVec2::new(0.42, 0.95)),
                MapObjectKind::BusStop => (Prop::BusShelter, DVec2::new(1.0, 2.2)),
                MapObjectKind::Bollard => (Prop::Bollard, DVec2::splat(0.15)),
                MapObjectKind::Bin => (Prop::Bin, DVec2::splat(0.3)),
                MapObjectKind::Hydrant => (Prop::Hydrant, DVec2::splat(0.25)),
                MapObjectKind::UtilityPole => (Prop::UtilityPole, DVec2::splat(0.22)),
                _ => continue,
            };
            let at = object.position.truncate();
            if !self.pavement.is_carriageway(at) {
                let spot = PropPose { z: self.ground(object.position), ..PropPose::new(at, object.heading_rad) };
                assembly.put(prop, spot, half, None);
            }
        }
    }

    /// Lamps where the map has them; else along streets with sidewalks and along fast roads.
    pub(crate) fn lamps(&self, assembly: &mut TownAssembly<'_>) {
        for object in self.map.objects.iter().filter(|t| t.kind == MapObjectKind::StreetLamp) {
            let at = object.position.truncate();
            if !self.pavement.is_carriageway(at) {
                self.lamp(assembly, at, self.ground(object.position), self.towards_road(at, object.heading_rad));
            }
        }
        if !assembly.lamps.is_empty() {
            return;
        }
        for (i, lane) in self.map.network.lanes.iter().enumerate() {
            let length = lane.centerline.length();
            if lane.junction.is_some() || !self.is_outermost(lane) || length < 12.0 {
                continue;
            }
            let count = (length / LAMPS_M).round().max(1.0);
            for k in 0..count as usize {
                // Lamps of the two directions alternate.
                let shift = if i % 2 == 0 { 0.3 } else { 0.8 };
                let s = length * (k as f64 + shift) / count;
                let Some(verge) = self.verge(lane, s, self.side(), POST_M) else { continue };
                let wanted = verge.walk || lane.speed_limit_mps > LIT_FROM_MPS;
                if wanted {
                    let yaw = lane.centerline.at(s).heading_rad - self.side() * FRAC_PI_2;
                    self.lamp(assembly, verge.at, verge.z, yaw);
                }
            }
        }
    }

    /// Direction to the nearest carriageway, or as given.
    fn towards_road(&self, at: DVec2, usual: f64) -> f64 {
        let ways = (0..16).map(|k| PI / 8.0 * f64::from(k));
        let near = ways.filter_map(|way| {
            let d = (1..20).map(|d| 0.5 * f64::from(d)).find(|&d| self.pavement.is_carriageway(at + unit(way) * d))?;
            Some((d, way))
        });
        near.min_by(|a, b| a.0.total_cmp(&b.0)).map_or(usual, |n| n.1)
    }

    /// A lamp post whose arm points along `yaw`; whether there was room.
    pub(crate) fn lamp(&self, assembly: &mut TownAssembly<'_>, at: DVec2, z: f64, yaw: f64) -> bool {
        let stands = assembly.lamps.len() < MOST_LAMPS && self.put(assembly, Prop::StreetLamp, at, z, yaw, None);
        if stands {
            let lens = (at + unit(yaw) * 2.0).extend(z + 7.9).as_vec3();
            assembly.lamps.push(StreetLamp {
                position: lens,
                color: self.preset.lamp_color,
                intensity_cd: self.preset.lamp_cd,
            });
        }
        stands
    }
}
