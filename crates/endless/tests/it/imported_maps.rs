//! Maps from files, from `maps import` to a checked dataset: one of each format.

use crate::program::{endless, refused, succeed};
use std::{fs, path::Path};

const SMALL: &str = "--videos 1 --weathers cloudy --times morning --size 97x55 --fps 4 --duration 1 --vehicles 30 \
                     --pedestrians 20 --min-pixels 5 --mp4 none";

/// A crossroads with lights, sidewalks, a crossing and three houses, 300 m across.
fn openstreetmap() -> String {
    let mut nodes = String::new();
    let mut ways = String::new();
    let mut node = |id: u32, east_m: f64, north_m: f64, tags: &str| {
        let (lat, lon) = (48.0 + north_m / 111_195.0, 11.0 + east_m / 74_404.0);
        nodes += &format!("<node id='{id}' lat='{lat:.7}' lon='{lon:.7}'>{tags}</node>\n");
    };
    node(1, 0.0, 0.0, "<tag k='highway' v='traffic_signals'/>");
    let ends = [(2, -150.0, 0.0), (3, 150.0, 0.0), (4, 0.0, -150.0), (5, 0.0, 150.0)];
    for (id, east, north) in ends {
        node(id, east, north, "");
    }
    node(6, 60.0, 0.0, "<tag k='highway' v='crossing'/><tag k='crossing' v='marked'/>");
    let mut way = |id: u32, nodes: &[u32], tags: &[(&str, &str)]| {
        let nodes: String = nodes.iter().map(|n| format!("<nd ref='{n}'/>")).collect();
        let tags: String = tags.iter().map(|(k, v)| format!("<tag k='{k}' v='{v}'/>")).collect();
        ways += &format!("<way id='{id}'>{nodes}{tags}</way>\n");
    };
    let street = [("highway", "secondary"), ("lanes", "2"), ("sidewalk", "both"), ("maxspeed", "50")];
    way(1, &[2, 1, 6, 3], &street);
    way(2, &[4, 1, 5], &street);
    for (k, east) in [(0, 20.0), (1, 45.0), (2, 80.0)] {
        let corner = |n: u32| 10 + 4 * k + n;
        for (n, x, y) in [(0, 0.0, 0.0), (1, 12.0, 0.0), (2, 12.0, 10.0), (3, 0.0, 10.0)] {
            node(corner(n), east + x, 20.0 + y, "");
        }
        let outline = [corner(0), corner(1), corner(2), corner(3), corner(0)];
        way(10 + k, &outline, &[("building", "apartments"), ("building:levels", "4")]);
    }
    format!("<?xml version='1.0' encoding='UTF-8'?>\n<osm version='0.6'>\n{nodes}{ways}</osm>\n")
}

fn from_first_to_last(folder: &Path, name: &str) {
    let (list, _) = succeed(folder, &format!("maps list {name} --cameras"));
    let row = list.lines().find(|l| l.starts_with(name)).expect("it is listed");
    assert!(row.contains("lanes") && row.contains("cameras"), "{row}");
    let generate = format!("generate out_{name} --maps {name} {SMALL}");
    succeed(folder, &generate);
    succeed(folder, &format!("check out_{name}"));
    // Complete already: the same command finds nothing to do and changes nothing.
    let manifest = folder.join(format!("out_{name}/dataset.json"));
    let before = fs::read(&manifest).expect("a manifest");
    assert!(String::from_utf8_lossy(&before).contains("map_files"));
    succeed(folder, &generate);
    assert_eq!(before, fs::read(&manifest).expect("a manifest"));
}

#[test]
fn an_opendrive_file_becomes_a_dataset() {
    let folder = tempfile::tempdir().expect("a folder");
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../endless_road/tests/data/crossroads.xodr");
    fs::copy(data, folder.path().join("Town04.xodr")).expect("the file is there");
    let (_, notes) = succeed(folder.path(), "maps import Town04.xodr");
    assert!(notes.contains("called Town04_imported"), "{notes}");
    from_first_to_last(folder.path(), "Town04_imported");
    assert!(refused(folder.path(), "maps import Town04.xodr --name Town04").contains("already"));
    succeed(folder.path(), "maps export Town04_imported --opendrive again.xodr --gltf town.glb --geojson town.geojson");
    let starts = |file: &str, with: &[u8]| fs::read(folder.path().join(file)).expect("written").starts_with(with);
    assert!(starts("town.glb", b"glTF\x02\0\0\0") && starts("town.geojson", b"{\""));
    let output = endless(folder.path(), "maps export Town04_imported");
    assert_eq!(output.status.code(), Some(2), "a file to write is needed");
    succeed(folder.path(), "maps import again.xodr");
}

#[test]
fn an_openstreetmap_extract_becomes_a_dataset() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("corner.osm"), openstreetmap()).expect("writable");
    let (said, _) = succeed(folder.path(), "maps import corner.osm");
    assert!(said.contains("generate OUT --maps corner"), "{said}");
    from_first_to_last(folder.path(), "corner");

    // Another content under the same name is another map: its datasets are not gone on with.
    fs::write(folder.path().join("corner.osm"), openstreetmap().replace("v='50'", "v='30'")).expect("writable");
    assert!(refused(folder.path(), "maps import corner.osm").contains("--replace"));
    succeed(folder.path(), "maps import corner.osm --replace");
    let generate = format!("generate out_corner --maps corner {SMALL}");
    assert!(refused(folder.path(), &generate).contains("another recipe"));

    // A stored map that was changed or lost is refused.
    let stored = folder.path().join("maps/corner.osm");
    fs::write(&stored, openstreetmap()).expect("writable");
    let fresh = format!("generate fresh --maps corner {SMALL}");
    assert!(refused(folder.path(), &fresh).contains("was changed after it was imported"));
    fs::remove_file(&stored).expect("removable");
    assert!(refused(folder.path(), &fresh).contains("import it again"));
    let (list, _) = succeed(folder.path(), "maps list corner Town02");
    assert!(list.lines().any(|l| l.starts_with("corner") && l.contains("damaged")), "{list}");
    assert!(list.lines().any(|l| l.starts_with("Town02")), "{list}");
    fs::remove_file(folder.path().join("maps/corner.toml")).expect("removable");
    assert!(refused(folder.path(), &fresh).contains("unknown map 'corner'"));
}
