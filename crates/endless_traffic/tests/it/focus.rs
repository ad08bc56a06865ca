//! Traffic that comes to where cameras look: it is there from the first frame on, keeps moving, and nobody touches anybody.

use crate::watch::watch;
use endless_asset::Catalogue;
use endless_town::Town;
use endless_traffic::{Fleet, Focus, Simulation, TrafficMap, TrafficSettings, View};
use endless_world::{ImageSize, Motion, PinholeCamera, TrafficDensity};
use glam::Vec3;

const FPS: f64 = 30.0;
const SIZE: ImageSize = ImageSize { width: 1280, height: 720 };
const RANGE_M: f32 = 100.0;

struct Place {
    catalogue: Catalogue,
    town: Town,
    map: TrafficMap,
}

impl Place {
    fn new(name: &str) -> Self {
        let catalogue = Catalogue::builtin();
        let town = endless_town::load(name, &catalogue).expect("a town");
        let map = TrafficMap::new(town.network.clone(), &catalogue.vehicle_specs());
        Self { catalogue, town, map }
    }

    fn cameras(&self) -> Vec<PinholeCamera> {
        self.town.cameras.iter().take(2).map(|site| PinholeCamera::new(site, SIZE)).collect()
    }

    fn focus(&self, share: f64) -> Focus {
        let views: Vec<View> = self.cameras().into_iter().map(View::Camera).collect();
        Focus::new(&self.town.network, &views, share, &|_, _| true)
    }

    fn simulation(&self, [vehicles, pedestrians]: [u32; 2], seed: u64, focus: Focus) -> Simulation {
        let specs = self.catalogue.vehicle_specs();
        let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
        let settings = TrafficSettings { vehicles, pedestrians, seed, fps: FPS, focus, ..TrafficSettings::default() };
        Simulation::on_map(&self.map, &fleet, &self.town.parked, &settings).expect("few enough")
    }

    /// Vehicles and people in the pictures of both cameras together, houses left out.
    fn in_sight(&self, simulation: &Simulation) -> [usize; 2] {
        let cameras = self.cameras();
        let seen = |at: Vec3| {
            cameras.iter().any(|camera| {
                let shown = camera.project(at).is_some_and(|(p, _)| {
                    (0.0..SIZE.width as f32).contains(&p.x) && (0.0..SIZE.height as f32).contains(&p.y)
                });
                shown && camera.position.distance(at) < RANGE_M
            })
        };
        let mut counts = [0, 0];
        for actor in simulation.state().actors.iter().filter(|actor| seen(actor.pose.position + Vec3::Z)) {
            counts[usize::from(matches!(actor.motion, Motion::Walker(_)))] += 1;
        }
        counts
    }
}

#[test]
fn traffic_is_where_the_cameras_look_from_the_first_frame_on() {
    for name in ["Town02", "Town03", "Town10HD"] {
        let place = Place::new(name);
        let mean = |share: f64| {
            let counts = (0..4).map(|seed| place.in_sight(&place.simulation([60, 20], seed, place.focus(share))));
            counts.fold([0.0, 0.0], |sum, n| [sum[0] + n[0] as f64 / 4.0, sum[1] + n[1] as f64 / 4.0])
        };
        let (even, focused) = (mean(0.0), mean(0.8));
        assert!(focused[0] > 10.0 && focused[0] > 2.0 * even[0], "{name}: vehicles {even:?} {focused:?}");
        assert!(focused[1] > 8.0 && focused[1] > 2.0 * even[1], "{name}: people {even:?} {focused:?}");
    }
}

#[test]
fn full_pictures_flow_without_a_touch() {
    for (name, seed) in [("Town01", 1), ("Town03", 2), ("Town10HD", 3), ("Altstadt", 4)] {
        let place = Place::new(name);
        let mut traffic = place.simulation([60, 40], seed, place.focus(0.8));
        let population = traffic.population();
        let f = watch(&mut traffic, &place.town.network, &place.catalogue.vehicle_specs(), 120.0, FPS);
        let what = format!("{name}, {population:?}\n{f}");
        assert!(f.passed(), "{what}");
        let driven = f.driven_m / f64::from(population.vehicles_spawned) / 120.0;
        let walked = f.walked_m / f64::from(population.pedestrians_spawned) / 120.0;
        assert!(driven > 0.8 && walked > 0.5, "{what}: {driven:.2} and {walked:.2} m/s");
    }
}

#[test]
fn nothing_is_looked_at_without_a_share_or_a_view() {
    let place = Place::new("Town02");
    assert_eq!(place.focus(0.0), Focus::default());
    assert_eq!(Focus::new(&place.town.network, &[], 1.0, &|_, _| true), Focus::default());
    let seen = |clear: &dyn Fn(Vec3, Vec3) -> bool| {
        let views: Vec<View> = place.cameras().into_iter().map(View::Camera).collect();
        Focus::new(&place.town.network, &views, 1.0, clear).seen_m()
    };
    assert!(seen(&|_, _| true).iter().all(|[lanes, walks]| *lanes > 50.0 && *walks > 20.0));
    assert!(seen(&|_, _| false).iter().all(|metres| *metres == [0.0, 0.0]), "behind walls");
}

#[test]
fn busier_streets_have_more_of_everybody() {
    let place = Place::new("Town05");
    for focus in [place.focus(0.8), Focus::default()] {
        let [light, normal, rush] = [TrafficDensity::Light, TrafficDensity::Normal, TrafficDensity::Rush]
            .map(|d| place.map.population(&focus, d));
        for kind in 0..2 {
            assert!(0 < light[kind] && light[kind] < normal[kind] && normal[kind] < rush[kind]);
        }
    }
}
