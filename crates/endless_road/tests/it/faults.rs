//! What every network promises: lanes do not overlap, successors meet, spawn points are no traps, crossings join
//! sidewalks. On real files where they are at hand, and on random towns, as they are read and as they are written.
#![expect(clippy::print_stdout, clippy::unwrap_used, reason = "tests")]

use endless_road::osm::{self, OsmOptions};
use endless_road::{NetworkFaultKind, RoadMap, RoadNetwork, opendrive};
use proptest::prelude::*;
use std::path::PathBuf;

fn files(folder: &str) -> Vec<(String, Vec<u8>)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data").join(folder);
    let Ok(entries) = std::fs::read_dir(&folder) else {
        println!("skipped: {} is not there", folder.display());
        return Vec::new();
    };
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let name = |path: &PathBuf| path.file_name().unwrap().to_string_lossy().into_owned();
    paths.iter().map(|path| (name(path), std::fs::read(path).unwrap())).collect()
}

/// What is wrong, but for so many overlaps: carriageways that a file draws on one another stay where it has them.
fn wrong(network: &RoadNetwork, overlaps: usize) -> Vec<String> {
    let faults = network.faults();
    let allowed = faults.iter().filter(|f| f.kind == NetworkFaultKind::Overlap).count() <= overlaps;
    let counts = |kind: NetworkFaultKind| kind != NetworkFaultKind::Overlap || !allowed;
    faults.into_iter().filter(|f| counts(f.kind)).map(|f| format!("{:?} {}: {}", f.kind, f.place, f.text)).collect()
}

#[test]
fn real_drives_keep_all_promises() {
    for (name, bytes) in files("opendrive") {
        let map = opendrive::read(&String::from_utf8(bytes).unwrap()).unwrap();
        assert_eq!(wrong(&map.network, 0), [""; 0], "{name}");
    }
}

#[test]
fn real_extracts_keep_all_promises() {
    for (name, bytes) in files("osm") {
        let map = osm::read(&bytes, &OsmOptions::default()).unwrap();
        assert_eq!(wrong(&map.network, map.network.lanes.len() / 500), [""; 0], "{name}");
        written_and_read(&name, &map, map.network.lanes.len() / 500).unwrap();
    }
}

/// A map written as OpenDRIVE and read again is the same network, and keeps its promises.
fn written_and_read(name: &str, map: &RoadMap, overlaps: usize) -> Result<(), String> {
    let again = opendrive::read(&opendrive::write(map, name)).map_err(|error| format!("{name}: {error}"))?;
    let (a, b) = (&map.network, &again.network);
    let faults = wrong(b, overlaps);
    if !faults.is_empty() {
        return Err(format!("{name}: as written: {faults:?}"));
    }
    let metres = |network: &RoadNetwork| network.lanes.iter().map(|l| l.centerline.length()).sum::<f64>();
    let joints = |network: &RoadNetwork| network.lanes.iter().map(|l| l.successors.len()).sum::<usize>();
    let same = a.lanes.len() == b.lanes.len()
        && joints(a) == joints(b)
        && a.crossings.len() == b.crossings.len()
        && (metres(a) - metres(b)).abs() < 1e-3 * metres(a);
    if same {
        return Ok(());
    }
    let figures = |n: &RoadNetwork| {
        format!("{} lanes, {} joints, {} crossings, {:.1} m", n.lanes.len(), joints(n), n.crossings.len(), metres(n))
    };
    Err(format!("{name}: {} became {}; {:?}", figures(a), figures(b), again.notes))
}

/// A town of blocks that are not quite square, with streets missing, of any class, one-way or not.
#[derive(Debug, Clone)]
struct Blocks {
    across: usize,
    jitter: Vec<(f64, f64)>,
    streets: Vec<TestStreet>,
}

#[derive(Debug, Clone)]
struct TestStreet {
    missing: bool,
    class: usize,
    lanes: usize,
    oneway: bool,
    crossing: bool,
    sidewalk: bool,
}

fn street() -> impl Strategy<Value = TestStreet> {
    (0..8usize, 0..6usize, 1..5usize, 0..5usize, any::<bool>(), any::<bool>()).prop_map(
        |(missing, class, lanes, oneway, crossing, sidewalk)| TestStreet {
            missing: missing == 0,
            class,
            lanes,
            oneway: oneway == 0,
            crossing,
            sidewalk,
        },
    )
}

fn blocks() -> impl Strategy<Value = Blocks> {
    (2..5usize, prop::collection::vec((-18.0..18.0, -18.0..18.0), 16), prop::collection::vec(street(), 24))
        .prop_map(|(across, jitter, streets)| Blocks { across, jitter, streets })
}

impl Blocks {
    fn file(&self) -> String {
        let n = self.across;
        let mut text = String::from("<osm version='0.6'>\n");
        let mut node = |id: usize, (x, y): (f64, f64), tags: &str| {
            text += &format!("<node id='{id}' lat='{:.8}' lon='{:.8}'>{tags}</node>\n", y / 111_200.0, x / 111_300.0);
        };
        let at = |i: usize, j: usize| {
            let (dx, dy) = self.jitter[(4 * i + j) % self.jitter.len()];
            (110.0 * i as f64 + dx, 95.0 * j as f64 + dy)
        };
        for i in 0..n {
            for j in 0..n {
                let lit = (i + 2 * j) % 3 == 0;
                node(1 + 10 * i + j, at(i, j), if lit { "<tag k='highway' v='traffic_signals'/>" } else { "" });
            }
        }
        let between = (0..n).flat_map(|i| (0..n).flat_map(move |j| [((i, j), (i + 1, j)), ((i, j), (i, j + 1))]));
        let between: Vec<_> = between.filter(|(_, (i, j))| *i < n && *j < n).collect();
        for (k, &(a, b)) in between.iter().enumerate() {
            let ((x0, y0), (x1, y1)) = (at(a.0, a.1), at(b.0, b.1));
            let crossing = self.streets[k % self.streets.len()].crossing;
            let tags = if crossing { "<tag k='highway' v='crossing'/>" } else { "" };
            node(500 + k, (0.5 * (x0 + x1) + 3.0, 0.5 * (y0 + y1) - 2.0), tags);
        }
        let classes = ["primary", "secondary", "tertiary", "residential", "unclassified", "living_street"];
        for (k, &(a, b)) in between.iter().enumerate() {
            let street = &self.streets[k % self.streets.len()];
            if street.missing && k > 0 {
                continue;
            }
            let (first, last) = (1 + 10 * a.0 + a.1, 1 + 10 * b.0 + b.1);
            text += &format!("<way id='{k}'><nd ref='{first}'/><nd ref='{}'/><nd ref='{last}'/>", 500 + k);
            let oneway = if street.oneway { "yes" } else { "no" };
            let sidewalk = if street.sidewalk { "both" } else { "no" };
            let lanes = if street.oneway { street.lanes.min(3) } else { street.lanes.max(2) };
            for (key, value) in [
                ("highway", classes[street.class]),
                ("oneway", oneway),
                ("sidewalk", sidewalk),
                ("lanes", &lanes.to_string()),
            ] {
                text += &format!("<tag k='{key}' v='{value}'/>");
            }
            text += "</way>\n";
        }
        text + "</osm>"
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn random_towns_keep_all_promises(blocks in blocks()) {
        let text = blocks.file();
        let map = osm::read(text.as_bytes(), &OsmOptions::default()).unwrap();
        prop_assert_eq!(wrong(&map.network, 0), [""; 0], "{}", text);
        if let Err(error) = written_and_read("blocks", &map, 0) {
            return Err(TestCaseError::fail(format!("{error}\n{text}")));
        }
    }
}
