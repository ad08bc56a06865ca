//! How many vehicles and people make streets so busy.

use crate::outing::shares;
use crate::{Focus, TrafficMap};
use endless_road::WalkKind;
use endless_world::{DrawnSun, SceneSettings, TrafficDensity};

/// The lane that a vehicle has where cameras look and the sidewalk that a person has, metres; and on the rest of the map,
/// kilometres. Where people look, the mean spacing is that of the level of service: B to C of light traffic, D of a working
/// day, E to F of the rush hour (Highway Capacity Manual 2016, exhibit 18-1, at urban speeds).
struct Spacing {
    seen_m: [f64; 2],
    map_km: [f64; 2],
}

fn spacing(density: TrafficDensity) -> Spacing {
    match density {
        TrafficDensity::Light => Spacing { seen_m: [48.0, 48.0], map_km: [1.2, 1.2] },
        TrafficDensity::Normal => Spacing { seen_m: [24.0, 24.0], map_km: [0.6, 0.6] },
        TrafficDensity::Rush => Spacing { seen_m: [12.0, 13.0], map_km: [0.3, 0.4] },
    }
}

/// Of those who come to what is seen, the share that is there at a time: the others are on their way to it.
const THERE: [f64; 2] = [0.65, 0.8];
/// No scene has more of the traffic of the rest of the map than this.
const MOST_ELSEWHERE: f64 = 120.0;
/// Sidewalk that every person needs at least, on the mean of the map, metres.
const LEAST_WALK_M: f64 = 12.0;

impl TrafficMap {
    /// The vehicles and people that a scene asks for, by number, or by how busy its streets are, at its time of day and in its
    /// weather.
    pub fn asked(&self, focus: &Focus, settings: &SceneSettings) -> [u32; 2] {
        let SceneSettings { vehicles, pedestrians, density, .. } = settings;
        let out = shares(settings.weather, settings.time_of_day, DrawnSun::of(settings).is_some());
        let follows = |density: Option<TrafficDensity>, kind: usize| {
            density.map_or(0, |d| (f64::from(self.population(focus, d)[kind]) * out[kind]).round() as u32)
        };
        [vehicles + follows(density.vehicles, 0), pedestrians + follows(density.pedestrians, 1)]
    }

    /// Vehicles and people that make the streets of a map so busy by day, and those most that are looked at.
    pub fn population(&self, focus: &Focus, density: TrafficDensity) -> [u32; 2] {
        let Spacing { seen_m, map_km } = spacing(density);
        let network = self.network();
        let lanes = network.lanes.iter().filter(|lane| lane.junction.is_none());
        let walks = network.walk.edges.iter().filter(|edge| edge.kind == WalkKind::Sidewalk);
        let walk_m = |edge: &endless_road::WalkEdge| {
            let [a, b] = edge.nodes.map(|node| network.walk.nodes[node.index()]);
            a.distance(b)
        };
        let whole_m = [lanes.map(|lane| lane.centerline.length()).sum::<f64>(), walks.map(walk_m).sum::<f64>()];
        let seen = focus.seen_m();
        [0, 1].map(|kind| {
            let coming: f64 = seen.iter().map(|metres| metres[kind] / seen_m[kind] / THERE[kind]).sum();
            let elsewhere = (whole_m[kind] / 1000.0 / map_km[kind]).min(MOST_ELSEWHERE);
            let number = if focus.share() > 0.0 {
                (coming / focus.share()).max(coming + elsewhere * (1.0 - focus.share()))
            } else {
                elsewhere
            };
            let most = if kind == 0 { f64::from(self.most_that_flow()) } else { whole_m[kind] / LEAST_WALK_M };
            number.min(most).round() as u32
        })
    }
}
