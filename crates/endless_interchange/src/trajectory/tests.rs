use super::*;
use crate::TrackFile;
use ::parquet::file::reader::{FileReader, SerializedFileReader};
use endless_asset::Catalogue;
use endless_traffic::{Fleet, Simulation, TrafficSettings};
use endless_world::{ObjectClass, Track, TrackPoint, WorldState};
use std::fs::{self, File};
use std::path::Path;

/// Rows of a second of traffic in a town, written to a file of this name; the states of which they were made.
fn written(path: &Path) -> Vec<WorldState> {
    let catalogue = Catalogue::builtin();
    let town = endless_town::load("Town02", &catalogue).expect("a town");
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let settings = TrafficSettings { vehicles: 12, pedestrians: 8, ..TrafficSettings::default() };
    let mut traffic = Simulation::new(&town.network, &fleet, &[], &settings).expect("few enough");
    let scene = TrajectoryScene::new(&town.network, &specs, town.streets.left_hand);
    let format = TrajectoryFormat::of(path).expect("a known ending");
    let mut writer = TrajectoryWriter::create(path, format).expect("writable");
    let states: Vec<WorldState> = (0..=10)
        .map(|frame| {
            if frame > 0 {
                traffic.tick();
            }
            let state = traffic.state();
            writer.push(state.time_s, &scene.rows(&state)).expect("writable");
            state
        })
        .collect();
    writer.finish().expect("writable");
    states
}

/// The longest way between where a track is and where its actor was, metres.
fn worst_error_m(track: &Track, states: &[WorldState], half_length_m: f64) -> f64 {
    let samples = track.pieces.concat();
    assert_eq!(samples.len(), states.len(), "{}", track.name);
    let errors = samples.iter().zip(states).map(|(sample, state)| {
        let actor = state.actors.iter().find(|actor| actor.id.to_string() == track.name).expect("an actor");
        assert!((sample.time_s - state.time_s).abs() < 1e-3);
        let (sin, cos) = endless_world::math::f64::sin_cos(sample.yaw_rad);
        let centre = match track.point {
            TrackPoint::Front => sample.position - glam::DVec2::new(cos, sin) * half_length_m,
            TrackPoint::Centre => sample.position,
        };
        centre.distance(actor.pose.position.as_dvec3().truncate())
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn what_is_written_is_played_where_it_was() {
    let folder = tempfile::tempdir().expect("a folder");
    let specs = Catalogue::builtin().vehicle_specs();
    for name in ["traj.csv", "traj.fcd.xml"] {
        let path = folder.path().join(name);
        let states = written(&path);
        let file = TrackFile::read(&path).expect("tracks");
        assert_eq!((file.tracks.len(), file.notes.len()), (20, 0), "{:?}", file.notes);
        for track in &file.tracks {
            let actor = states[0].actors.iter().find(|actor| actor.id.to_string() == track.name).expect("an actor");
            assert_eq!(track.class, actor.class, "{name}");
            let half_m = actor.asset.vehicle().map_or(0.0, |v| 0.5 * f64::from(specs[v.model.index()].length_m));
            let error_m = worst_error_m(track, &states, half_m);
            assert!(error_m < 2e-3, "{name}: {} {error_m} m", track.name);
        }
    }
}

#[test]
fn parquet_has_the_columns_of_the_csv() {
    let folder = tempfile::tempdir().expect("a folder");
    let [csv, parquet] = ["a.csv", "a.parquet"].map(|name| folder.path().join(name));
    written(&csv);
    written(&parquet);
    let again = folder.path().join("again.parquet");
    written(&again);
    assert!(fs::read(&parquet).expect("bytes") == fs::read(again).expect("bytes"), "the same bytes each time");
    let text = fs::read_to_string(csv).expect("text");
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let reader = SerializedFileReader::new(File::open(parquet).expect("a file")).expect("Parquet");
    let mut rows = reader.get_row_iter(None).expect("rows");
    for line in lines.by_ref() {
        let row = rows.next().expect("as many rows").expect("a row");
        let fields: Vec<&str> = line.split(',').collect();
        assert_eq!(row.get_column_iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), names);
        for ((name, value), text) in row.get_column_iter().zip(fields) {
            let value = value.to_string().trim_matches('"').to_owned();
            let same = match (value.parse::<f64>(), text.parse::<f64>()) {
                (Ok(value), Ok(text)) => (value - text).abs() <= 6e-3,
                _ => value == text || (value == "null" && text.is_empty()),
            };
            assert!(same, "{name}: {value} is not {text}");
        }
    }
    assert!(rows.next().is_none(), "no more rows");
}

#[test]
fn many_rows_make_several_groups() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("many.parquet");
    let row = TrajectoryRow {
        time_s: 0.0,
        id: endless_world::InstanceId(7),
        class: ObjectClass::Pedestrian,
        model: "pedestrian",
        position: [1.0, 2.0, 0.0],
        yaw_rad: 0.0,
        speed_mps: 1.0,
        acceleration_mps2: None,
        pitch_rad: 0.0,
        size_m: [0.5, 0.5, 1.75],
        lane: None,
        crossing: Some(3),
    };
    let mut writer = TrajectoryWriter::create(&path, TrajectoryFormat::Parquet).expect("writable");
    for instant in 0..200 {
        writer.push(f64::from(instant), &[row; 1000]).expect("writable");
    }
    writer.finish().expect("writable");
    let reader = SerializedFileReader::new(File::open(path).expect("a file")).expect("Parquet");
    assert_eq!(reader.metadata().file_metadata().num_rows(), 200_000);
    assert_eq!(reader.num_row_groups(), 4);
}

#[test]
fn endings_say_the_format() {
    let of = |name: &str| TrajectoryFormat::of(Path::new(name));
    assert_eq!(of("a/b.csv"), Some(TrajectoryFormat::Csv));
    assert_eq!(of("b.fcd.xml"), Some(TrajectoryFormat::Fcd));
    assert_eq!(of("B.PARQUET"), Some(TrajectoryFormat::Parquet));
    assert_eq!((of("b"), of("b.json"), of(".csv")), (None, None, None));
}
