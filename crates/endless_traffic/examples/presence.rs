//! How much there is to see: mean numbers of vehicles and people within 60 m of the cameras over 30 s, and which kinds
//! of vehicles there are: `cargo run -p endless_traffic --release --example presence -- [vehicles] [people]`.
#![expect(clippy::print_stdout, reason = "a report on standard output")]

use endless_asset::Catalogue;
use endless_town::Town;
use endless_traffic::{Fleet, Focus, Simulation, TrafficSettings, View};
use endless_world::{Motion, ObjectClass};
use glam::Vec3;
use std::error::Error;

const NEAR_M: f32 = 60.0;
const SECONDS: u32 = 30;
const SEEDS: u64 = 3;

fn simulation(town: &Town, catalogue: &Catalogue, settings: &TrafficSettings) -> Simulation {
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    Simulation::new(&town.network, &fleet, &town.parked, settings).expect("few enough")
}

/// Mean numbers of vehicles and of people near each place.
fn presence(town: &Town, catalogue: &Catalogue, asked: [u32; 2], focus: &[Vec3], places: &[Vec3]) -> Vec<[f32; 2]> {
    let mut sums = vec![[0.0; 2]; places.len()];
    for seed in 0..SEEDS {
        let [vehicles, pedestrians] = asked;
        let views: Vec<View> = focus.iter().map(|&at| View::around(at)).collect();
        let focus = Focus::new(&town.network, &views, 0.8, &|_, _| true);
        let settings = TrafficSettings { vehicles, pedestrians, seed, focus, ..TrafficSettings::default() };
        let mut s = simulation(town, catalogue, &settings);
        for _ in 0..SECONDS {
            (0..10).for_each(|_| s.tick());
            for actor in &s.state().actors {
                let kind = usize::from(matches!(actor.motion, Motion::Walker(_)));
                for (sum, place) in sums.iter_mut().zip(places) {
                    let near = actor.pose.position.truncate().distance(place.truncate()) < NEAR_M;
                    sum[kind] += f32::from(u8::from(near));
                }
            }
        }
    }
    let n = (SECONDS * SEEDS as u32) as f32;
    sums.into_iter().map(|[v, p]| [v / n, p / n]).collect()
}

/// The kinds of the vehicles of ten scenes.
fn kinds(town: &Town, catalogue: &Catalogue, vehicles: u32) -> Vec<usize> {
    let mut counts = vec![0; ObjectClass::ALL.len()];
    for seed in 0..10 {
        let settings = TrafficSettings { vehicles, pedestrians: 0, seed, ..TrafficSettings::default() };
        let s = simulation(town, catalogue, &settings);
        for actor in s.state().actors {
            counts[ObjectClass::ALL.iter().position(|&c| c == actor.class).unwrap_or(0)] += 1;
        }
    }
    counts
}

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<u32> = std::env::args().skip(1).map(|a| a.parse()).collect::<Result<_, _>>()?;
    let asked = [args.first().copied().unwrap_or(30), args.get(1).copied().unwrap_or(20)];
    let catalogue = Catalogue::builtin();
    println!(
        "{:9} {:>6} {:26} {:26} vehicles by class, ten scenes",
        "", "", "unfocused: each camera", "focused on pairs"
    );
    for name in endless_town::NAMES {
        let town = endless_town::load(name, &catalogue)?;
        let places: Vec<Vec3> = town.cameras.iter().map(|c| Vec3::from_array(c.position)).collect();
        let plain = presence(&town, &catalogue, asked, &[], &places);
        let pairs: Vec<[f32; 2]> =
            places.chunks_exact(2).flat_map(|pair| presence(&town, &catalogue, asked, pair, pair)).collect();
        let mean = |of: &[[f32; 2]], kind: usize| of.iter().map(|p| p[kind]).sum::<f32>() / of.len() as f32;
        let least = |of: &[[f32; 2]], kind: usize| of.iter().map(|p| p[kind]).fold(f32::INFINITY, f32::min);
        let show = |of: &[[f32; 2]]| {
            let [v, p] = [0, 1].map(|k| format!("{:.1} (least {:.1})", mean(of, k), least(of, k)));
            format!("{v} {p}")
        };
        let kinds: Vec<String> = ObjectClass::ALL
            .iter()
            .zip(kinds(&town, &catalogue, asked[0]))
            .filter(|(_, n)| *n > 0)
            .map(|(class, n)| format!("{class} {n}"))
            .collect();
        println!("{name:9} {:6} {:34} {:34} {}", places.len(), show(&plain), show(&pairs), kinds.join(", "));
    }
    Ok(())
}
