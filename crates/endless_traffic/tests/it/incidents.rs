//! Incidents on request: they happen where and when their labels say, as the trajectories alone show, and touch nobody.

use endless_asset::Catalogue;
use endless_town::Town;
use endless_traffic::{
    AuditCheck, DrivingCondition, Fleet, Focus, IncidentDetector, IncidentRequest, Simulation, TrafficAudit,
    TrafficMap, TrafficSettings, View,
};
use endless_world::{ImageSize, Incident, IncidentKind, PinholeCamera, StagedIncidents, VehicleSpec};

const FPS: f64 = 30.0;
const FRAMES: u32 = 600;

struct Place {
    town: Town,
    map: TrafficMap,
    specs: Vec<VehicleSpec>,
}

impl Place {
    fn new(name: &str) -> Self {
        let catalogue = Catalogue::builtin();
        let town = endless_town::load(name, &catalogue).expect("a town");
        let specs = catalogue.vehicle_specs();
        let map = TrafficMap::new(town.network.clone(), &specs);
        Self { town, map, specs }
    }

    fn focus(&self, camera: usize) -> Focus {
        let size = ImageSize { width: 1280, height: 720 };
        let view = View::Camera(PinholeCamera::new(&self.town.cameras[camera], size));
        Focus::new(&self.town.network, &[view], 0.8, &|_, _| true)
    }

    fn simulation(&self, vehicles: u32, seed: u64, focus: &Focus) -> Simulation {
        let fleet = Fleet { vehicles: &self.specs, pedestrian: &Catalogue::pedestrian_spec };
        let settings = TrafficSettings {
            vehicles,
            pedestrians: 20,
            seed,
            fps: FPS,
            focus: focus.clone(),
            ..TrafficSettings::default()
        };
        Simulation::on_map(&self.map, &fleet, &self.town.parked, &settings).expect("few enough")
    }
}

fn stage(traffic: &mut Simulation, kinds: &[IncidentKind], seed: u64, sight: &Focus) -> StagedIncidents {
    let condition = |_| DrivingCondition::default();
    traffic.stage(&IncidentRequest { kinds, frames: FRAMES, seed, sight, condition: &condition })
}

/// Whether the detector finds an incident, with both ends within a frame of ten a second.
fn is_found(detector: &IncidentDetector<'_>, incident: &Incident) -> bool {
    let near = |a: u32, b: u32| a.abs_diff(b) <= (FPS / 10.0) as u32;
    let Incident { actors, begin_frame, end_frame, .. } = incident;
    let mut found = detector.detect(incident.kind).into_iter();
    found.any(|f| f.actors == *actors && near(f.begin_frame, *begin_frame) && near(f.end_frame, *end_frame))
}

#[test]
fn labels_are_what_the_trajectories_show_and_nobody_touches_anybody() {
    let mut had = 0;
    for (name, camera, seed) in [("Town01", 0, 1), ("Town10HD", 1, 17), ("Altstadt", 0, 9)] {
        let place = Place::new(name);
        let focus = place.focus(camera);
        for &kind in IncidentKind::ALL {
            let mut traffic = place.simulation(60, seed, &focus);
            let StagedIncidents { incidents, missed } = stage(&mut traffic, &[kind], seed, &focus);
            assert_eq!(incidents.len() + missed.len(), 1, "{name}, {kind}");
            let [incident] = &incidents[..] else { continue };
            had += 1;
            let mut detector = IncidentDetector::new(&place.town.network, &place.specs, FPS);
            let mut audit = TrafficAudit::new(&place.town.network, &place.specs, traffic.parked(), FPS);
            for frame in 0..FRAMES {
                if frame > 0 {
                    traffic.tick();
                }
                let state = traffic.state();
                audit.look(&state);
                detector.look(state);
            }
            assert!(is_found(&detector, incident), "{name}: {incident:?}, found {:?}", detector.detect(kind));
            let touches = [AuditCheck::Collisions, AuditCheck::PeopleHit];
            for line in audit.report().lines.iter().filter(|line| touches.contains(&line.check)) {
                let wanted = line.check == AuditCheck::Collisions && kind == IncidentKind::Collision;
                assert_eq!(line.measured, f64::from(u8::from(wanted)), "{name}, {kind}: {:?}", line.places);
            }
        }
    }
    assert!(had >= 8, "only {had} incidents could be had");
}

#[test]
fn several_in_one_scene_are_the_same_every_time() {
    let place = Place::new("Town01");
    let focus = place.focus(0);
    let kinds = [IncidentKind::NearMiss, IncidentKind::Stalled];
    let run = || {
        let mut traffic = place.simulation(60, 1, &focus);
        let staged = stage(&mut traffic, &kinds, 3, &focus);
        (0..FRAMES).for_each(|_| traffic.tick());
        (staged, traffic.state())
    };
    let (staged, last) = run();
    assert_eq!(staged.incidents.iter().map(|incident| incident.kind).collect::<Vec<_>>(), kinds, "{staged:?}");
    assert_eq!(run(), (staged, last));
}

#[test]
fn traffic_without_a_request_is_as_before_and_what_cannot_be_had_is_told() {
    let place = Place::new("Town02");
    let focus = place.focus(0);
    let usual = place.simulation(20, 1, &focus);
    let mut asked = usual.clone();
    assert_eq!(stage(&mut asked, &[], 1, &focus), StagedIncidents::default());
    assert_eq!(asked.state(), usual.state());
    // Nobody drives.
    let driven: Vec<IncidentKind> =
        IncidentKind::ALL.iter().copied().filter(|kind| *kind != IncidentKind::Jaywalk).collect();
    let mut empty = place.simulation(0, 1, &focus);
    let staged = stage(&mut empty, &driven, 1, &focus);
    assert_eq!((staged.incidents, staged.missed), (Vec::new(), driven));
}
