//! What a town is.

use crate::dressing::near_detail::DetailSource;
use crate::placement::PlacedObject;
use crate::placement::Placement;
use crate::street_features::StreetFeatures;
use endless_asset::{Catalogue, Prop};
use endless_road::{Georeference, RoadNetwork};
use endless_scene::{Mesh, StreetLamp};
use endless_world::math::f64::atan2;
use endless_world::{BenchSeat, BusStop, CameraSite, ParkedVehicle, ParkingBay, Side, Stream};
use glam::Vec3;
use std::sync::Arc;

/// A sign and a shelter within this distance are of one stop, metres.
const ONE_STOP_M: f32 = 14.0;
/// Seats are so far to the left of the middle of a bench, and before it, clear of its back, metres.
const SEATS_M: [f32; 3] = [0.6, 0.0, -0.6];
const SEAT_AHEAD_M: f32 = 0.03;

/// A whole map. By default an empty one, without a name.
#[derive(Debug, Clone, Default)]
pub struct Town {
    /// `Town01`, ...
    pub name: String,
    /// One sentence on its character.
    pub summary: String,
    /// Roads, junctions, signals, sidewalks.
    pub network: RoadNetwork,
    /// Where on Earth it lies; `None` where its map does not say, or in a projection that is not supported.
    pub georeference: Option<Georeference>,
    /// Ground, roads, kerbs, markings and buildings.
    pub meshes: Vec<Arc<Mesh>>,
    /// All placements, own meshes included.
    pub placements: Vec<Placement>,
    /// Parked vehicles. Number i carries instance id i + 1 in every video.
    pub parked: Vec<ParkedVehicle>,
    /// Bays along the kerbs of streets, taken and free ones.
    pub parking_bays: Vec<ParkingBay>,
    /// Street lamps.
    pub lamps: Vec<StreetLamp>,
    /// At least five camera sites.
    pub cameras: Vec<CameraSite>,
    /// Paint and sidewalks.
    pub streets: StreetFeatures,
    /// The source of [`details_near`](Self::details_near); empty by default.
    pub detail_source: DetailSource,
}

impl Town {
    /// What cameras see near by and nobody sees from afar: tufts of grass, beds and benches on lawns, frayed edges of
    /// lawns, maize on fields. The same cameras get the same details. Add them to the town's placements, or to what is
    /// shown of it for these cameras.
    pub fn details_near(&self, cameras: &[CameraSite], catalogue: &Catalogue) -> Vec<Placement> {
        self.detail_source.place(&self.network, cameras, catalogue)
    }

    /// Where buses stop: signs, and shelters that have no sign near by.
    pub fn bus_stops(&self) -> Vec<BusStop> {
        let places = |wanted: Prop| {
            let of = move |placement: &Placement| match placement.object {
                PlacedObject::Prop(prop, _) if prop == wanted => {
                    Some(Vec3::from(placement.world_from_object.translation))
                }
                _ => None,
            };
            self.placements.iter().filter_map(of)
        };
        let mut found: Vec<Vec3> = Vec::new();
        for place in places(Prop::BusStop).chain(places(Prop::BusShelter)) {
            if found.iter().all(|other| other.distance(place) > ONE_STOP_M) {
                found.push(place);
            }
        }
        let side = if self.streets.left_hand { Side::Left } else { Side::Right };
        found.into_iter().map(|position| BusStop { position, side }).collect()
    }

    /// Seats of the benches along streets and in parks: of each bench one in the middle and one to either side.
    pub fn bench_seats(&self) -> Vec<BenchSeat> {
        let of = |placement: &Placement| {
            let bench = placement.world_from_object;
            let facing = bench.transform_vector3(Vec3::X);
            let seat = move |across_m: f32| BenchSeat {
                position: bench.transform_point3(Vec3::new(SEAT_AHEAD_M, across_m, 0.0)),
                yaw_rad: atan2(f64::from(facing.y), f64::from(facing.x)) as f32,
            };
            matches!(placement.object, PlacedObject::Prop(Prop::Bench, _)).then(|| SEATS_M.map(seat))
        };
        self.placements.iter().filter_map(of).flatten().collect()
    }

    /// Takes parked vehicles away, so that about this share of them, 0 to 1, is left; with a larger share stand all of a smaller
    /// one.
    pub fn keep_parked(&mut self, share: f64) {
        let draw = |parked: &ParkedVehicle| {
            let at = parked.pose.position.to_array().map(|metres| u64::from(metres.to_bits()));
            Stream::named(parked.vehicle.variant, "town.kept_parked", &at).range_f64(0.0, 1.0)
        };
        self.parked.retain(|parked| draw(parked) < share);
    }
}

/// Why a town could not be made.
#[derive(Debug, thiserror::Error, PartialEq)]
pub enum TownError {
    /// A map with nothing to drive on.
    #[error("map '{name}' has no lane for driving: nothing can be dressed")]
    NoLanes {
        /// The map.
        name: String,
    },
    /// A map that is larger than a town can be.
    #[error("map '{name}' is {width_km:.1} by {height_km:.1} km: cut out a part of at most {most_km} km a side")]
    TooLarge {
        /// The map.
        name: String,
        /// Size from west to east, kilometres.
        width_km: f64,
        /// Size from south to north, kilometres.
        height_km: f64,
        /// The most.
        most_km: f64,
    },
    /// No map of this name.
    #[error("unknown map '{given}': use one of {}", known.join(", "))]
    UnknownMap {
        /// What was asked for.
        given: String,
        /// The names there are.
        known: Vec<&'static str>,
    },
}
