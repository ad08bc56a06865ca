//! Recorded tracks are filmed where they were: a clone of traffic that was written as SUMO writes it.

use crate::fake::{assert_same, options};
use endless_asset::Catalogue;
use endless_dataset::{DatasetLayout, RecipeDraft, UserCamera, check, read_actors, read_objects};
use endless_interchange::{MapLibrary, TrackFile};
use endless_pipeline::{BakeCache, BuiltinSimulator, MapSource, SilentProgress, generate, resolve_recipe};
use endless_traffic::{Fleet, Focus, Simulation, TrafficSettings, View};
use endless_world::{Actor, Motion};
use glam::DVec2;
use std::{collections::BTreeMap, fmt::Write, fs, path::Path, sync::LazyLock};

const TOWN: &str = "Town02";
/// As a net has it that was made of a map's OpenDRIVE file.
const OFFSET: DVec2 = DVec2::new(340.0, 261.83);
/// When the tracks begin on their clock, seconds.
const BEGIN_S: f64 = 57600.0;
/// Time steps a second.
const STEPS: u32 = 5;
const SECONDS: u32 = 2;

/// The points that FCD tells of in each time step, by the names of the tracks.
type Places = Vec<BTreeMap<String, DVec2>>;

/// Traffic in a town as FCD, and where everybody is in it. Names of odd vehicles begin late and end early.
fn recorded() -> &'static (String, Places) {
    static RECORDED: LazyLock<(String, Places)> = LazyLock::new(|| {
        let library = MapLibrary::builtin();
        let (town, catalogue) = (library.town(TOWN).expect("a town"), library.catalogue());
        let specs = catalogue.vehicle_specs();
        let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
        let settings = TrafficSettings {
            vehicles: 60,
            pedestrians: 40,
            fps: f64::from(STEPS),
            focus: Focus::new(&town.network, &[View::around(town.cameras[0].position.into())], 0.8, &|_, _| true),

            ..TrafficSettings::default()
        };
        let mut traffic = Simulation::new(&town.network, &fleet, &[], &settings).expect("few");
        let (mut text, mut places) = ("<fcd-export>\n".to_owned(), Places::new());
        for step in 0..=STEPS * SECONDS {
            let time_s = BEGIN_S + f64::from(step) / f64::from(STEPS);
            writeln!(text, "<timestep time=\"{time_s:.2}\">").expect("memory");
            let mut now = BTreeMap::new();
            for actor in traffic.state().actors {
                if actor.id.0 % 7 == 1 && !(3..5).contains(&step) {
                    continue;
                }
                let (line, name, place) = element(&actor, catalogue);
                text += &line;
                now.insert(name, place);
            }
            text += "</timestep>\n";
            places.push(now);
            traffic.tick();
        }
        (text + "</fcd-export>\n", places)
    });
    &RECORDED
}

/// A line of FCD with the name of the track and the point in the map's frame, to the centimetre.
fn element(actor: &Actor, catalogue: &Catalogue) -> (String, String, DVec2) {
    let length = actor.asset.vehicle().and_then(|v| catalogue.vehicle(v.model)).map_or(0.0, |v| v.spec.length_m);
    let yaw = f64::from(actor.pose.yaw_rad);
    let ahead = DVec2::from_angle(yaw) * 0.5 * f64::from(length);
    let at = ((actor.pose.position.truncate().as_dvec2() + ahead + OFFSET) * 100.0).round() / 100.0;
    let (angle, name) = ((90.0 - yaw.to_degrees()).rem_euclid(360.0), format!("{}.{}", actor.class, actor.id));
    let (x, y, class) = (at.x, at.y, actor.class);
    let line = match actor.motion {
        Motion::Walker(_) => format!("<person id=\"{name}\" x=\"{x:.2}\" y=\"{y:.2}\" angle=\"{angle:.3}\"/>\n"),
        Motion::Vehicle(motion) => {
            let speed = motion.speed_mps;
            format!(
                "<vehicle id=\"{name}\" x=\"{x:.2}\" y=\"{y:.2}\" angle=\"{angle:.3}\" type=\"t_{class}\" speed=\"{speed:.2}\"/>\n"
            )
        }
    };
    (line, name, at - OFFSET)
}

fn simulator(text: &str) -> BuiltinSimulator {
    let tracks = TrackFile::from_bytes(text.as_bytes()).expect("tracks");
    BuiltinSimulator::new(MapLibrary::builtin()).with_bake_cache(BakeCache::in_memory(1 << 28)).with_tracks(tracks)
}

fn draft() -> RecipeDraft {
    let words = |words: &[&str]| Some(words.iter().map(|&word| word.to_owned()).collect());
    RecipeDraft {
        videos: Some(1),
        maps: words(&[TOWN]),
        weathers: words(&["cloudy"]),
        times: words(&["afternoon"]),
        size: Some("256x144".to_owned()),
        // Two frames in three lie between time steps.
        fps: Some(f64::from(3 * STEPS)),
        duration: Some(0.6),
        cameras_per_scene: Some(1),
        cameras: Some(vec![camera()]),
        traffic_begin: Some(BEGIN_S + 0.4),
        traffic_offset: Some(OFFSET.to_array()),
        min_pixels: Some(1),
        layers: words(&["depth", "instance", "flow"]),
        mp4: Some(Vec::new()),
        camera_look: Some("clean".to_owned()),
        ..RecipeDraft::default()
    }
}

/// The one around which traffic was recorded.
fn camera() -> UserCamera {
    let site = MapLibrary::builtin().cameras(TOWN).expect("a town").swap_remove(0);
    UserCamera {
        map: TOWN.to_owned(),
        name: site.name,
        position: site.position.map(f64::from),
        yaw: f64::from(site.yaw_rad).to_degrees(),
        down: f64::from(site.down_tilt_rad).to_degrees(),
        fov: Some(f64::from(site.horizontal_fov_rad).to_degrees()),
        lens: site.lens,
    }
}

/// Where the file has somebody in a frame; `None` if they are not there.
fn told(places: &Places, name: &str, frame: u32) -> Option<DVec2> {
    let (step, share) = (2 + frame / 3, f64::from(frame % 3) / 3.0);
    let at = |step: u32| places[step as usize].get(name);
    if share == 0.0 { at(step).copied() } else { Some(at(step)?.lerp(*at(step + 1)?, share)) }
}

#[test]
fn a_clone_is_where_its_file_says_in_every_frame() {
    let (text, places) = recorded();
    let simulator = simulator(text);
    let recipe = resolve_recipe(draft(), &simulator).expect("a recipe");
    assert_eq!((recipe.vehicles, recipe.pedestrians), (0, 0), "nobody is simulated");
    assert_eq!(simulator.track_notes(&recipe).expect("on the map"), Vec::<String>::new());
    let out = [(); 2].map(|()| tempfile::tempdir().expect("temp"));
    let make = |out: &Path, threads| {
        generate(&simulator, &recipe, out, &options(threads), &SilentProgress).expect("a dataset")
    };
    let plan = make(out[0].path(), 2).plan;
    let video = DatasetLayout::new(out[0].path()).video(&plan.scenes[0]);
    let actors: BTreeMap<_, _> =
        read_actors(&video.actors()).expect("actors").into_iter().map(|actor| (actor.id, actor)).collect();
    let (mut worst_m, mut seen) = (0.0f64, 0);
    for line in read_objects(&video.camera(0).objects()).expect("labels") {
        for object in line.objects.iter().filter(|object| !object.parked && object.vehicle_id.is_none()) {
            let actor = &actors[&object.id];
            let name = actor.track.as_deref().expect("all play a track");
            let place = told(places, name, line.frame);
            let place = place.unwrap_or_else(|| panic!("{name} is not there in frame {}", line.frame));
            let length = actor.vehicle.as_ref().map_or(0.0, |vehicle| vehicle.size[0]);
            let front =
                DVec2::new(object.position[0], object.position[1]) + DVec2::from_angle(object.yaw_rad) * (0.5 * length);
            worst_m = worst_m.max(front.distance(place));
            seen += 1;
        }
    }
    println!("{seen} objects, at most {:.2} cm from where the file has them", 100.0 * worst_m);
    assert!(seen > 30 && worst_m < 0.05, "{seen} objects, at most {worst_m} m off");
    // Whoever comes and goes: labels, layers and flow stand up to every check.
    assert_eq!(check(out[0].path()).expect("readable").findings, []);

    make(out[1].path(), 1);
    assert_same(out[0].path(), out[1].path());
    // A run that was killed goes on, with the same file alone.
    fs::remove_file(video.scene()).expect("complete");
    fs::remove_file(video.camera(0).objects()).expect("labels");
    let other = self::simulator(&format!("{text}\n"));
    let another = resolve_recipe(draft(), &other).expect("a recipe");
    let error = generate(&other, &another, out[0].path(), &options(2), &SilentProgress).expect_err("another file");
    assert!(error.to_string().contains("another recipe (traffic_file is"), "{error}");
    make(out[0].path(), 2);
    assert_same(out[0].path(), out[1].path());
}

#[test]
fn what_does_not_fit_is_told_before_anything_is_made() {
    let (text, _) = recorded();
    let simulator = simulator(text);
    let refused = |draft| resolve_recipe(draft, &simulator).expect_err("refused").to_string();
    let two = Some(vec![TOWN.to_owned(), "Town01".to_owned()]);
    assert!(refused(RecipeDraft { maps: two, ..draft() }).contains("--maps"));
    let late = refused(RecipeDraft { traffic_begin: Some(60.0), ..draft() });
    assert!(late.contains("the file goes from 57600 s to 57602 s"), "{late}");

    let away =
        resolve_recipe(RecipeDraft { traffic_offset: Some([OFFSET.x - 100.0, OFFSET.y]), ..draft() }, &simulator)
            .expect("plausible");
    let notes = simulator.track_notes(&away);
    // Some of it lies on other roads.
    assert!(notes.is_ok_and(|notes| notes.len() == 1 && notes[0].contains("leave the map")));
    let far =
        resolve_recipe(RecipeDraft { traffic_offset: Some([5e5, 0.0]), ..draft() }, &simulator).expect("plausible");
    let error = simulator.track_notes(&far).expect_err("off the map").to_string();
    assert!(error.contains("--traffic-offset X,Y") && error.lines().count() == 1, "{error}");

    let long = RecipeDraft { duration: Some(4.0), traffic_begin: None, vehicles: Some(3), ..draft() };
    let long = resolve_recipe(long, &simulator).expect("a recipe");
    assert_eq!((long.vehicles, long.pedestrians, long.traffic_begin), (3, 0, Some(BEGIN_S)));
    let notes = simulator.track_notes(&long).expect("on the map");
    assert!(notes.len() == 1 && notes[0].contains("end 2.0 s before"), "{notes:?}");
}
