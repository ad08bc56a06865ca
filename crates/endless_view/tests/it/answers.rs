//! What a dataset has is what the page is told.

use crate::{
    fixture::{FRAMES, Fixture},
    http::{get, get_with, send},
};
use endless_dataset::{Layer, RgbFormat, read_objects};
use std::{collections::BTreeSet, fs};

#[test]
fn lines_and_files_are_those_of_the_dataset() {
    let fixture = Fixture::new();
    let served = fixture.serve();
    let get = |path: &str| {
        let answer = get(served.address, path);
        assert_eq!(answer.status, 200, "{path}: {}", answer.text());
        answer
    };
    let video = get("/api/videos/0").json();
    assert_eq!((&video["state"], &video["frames_there"]), (&"complete".into(), &FRAMES.into()));
    assert_eq!(video["views"].as_array().map(Vec::len), Some(1));
    assert_eq!(video["views"][0]["layers"].as_array().map(Vec::len), Some(Layer::ALL.len()));
    let camera = fixture.video().join("camera_a");
    let record = fs::read_to_string(camera.join("camera.json")).expect("there");
    assert_eq!(video["views"][0]["camera"], serde_json::from_str::<serde_json::Value>(&record).expect("JSON"));

    let lines = fs::read_to_string(camera.join("objects.jsonl")).expect("there");
    let asked = get("/api/videos/0/cameras/0/objects?from=0&count=9").text();
    assert_eq!(asked, format!("[{}]", lines.trim_end().replace('\n', ",")));
    assert_eq!(
        get("/api/videos/0/cameras/0/objects?from=1&count=1").text(),
        format!("[{}]", lines.lines().nth(1).expect("two"))
    );
    assert_eq!(get("/api/videos/0/cameras/0/objects?from=99&count=9").text(), "[]");
    assert_eq!(get("/api/videos/0/frames?from=0&count=9").json().as_array().map(Vec::len), Some(FRAMES as usize));
    for (path, file) in [("/api/videos/0/actors", "actors.json"), ("/api/videos/0/cameras/0/map", "camera_a/map.json")]
    {
        assert_eq!(get(path).body, fs::read(fixture.video().join(file)).expect("there"), "{path}");
    }
}

#[test]
fn pictures_are_as_stored_or_in_colour() {
    let fixture = Fixture::new();
    let served = fixture.serve();
    for layer in Layer::ALL {
        let path = format!("/api/videos/0/cameras/0/images/{layer}/1");
        let stored = get(served.address, &path);
        let file = fs::read(fixture.video().join(format!("camera_a/{layer}/000001.png"))).expect("there");
        assert_eq!((stored.status, stored.header("content-type")), (200, Some("image/png")), "{layer}");
        assert_eq!(stored.body, file, "{layer}");
        let shown = get(served.address, &path.replace("images", "pictures"));
        let of = |bytes: &[u8]| (RgbFormat::Png.entry().decode)(bytes).expect("a PNG");
        let (shown, stored) = (of(&shown.body), of(&file));
        assert_eq!(shown.size(), stored.size(), "{layer}");
        assert!(shown.rgb8().is_ok(), "{layer}: 8 bits");
        let plain = matches!(layer, Layer::Rgb | Layer::Albedo | Layer::Shadow);
        assert_eq!(shown == stored, plain, "{layer}: in colour");
    }
    let small = get(served.address, "/api/videos/0/cameras/0/thumbnail");
    assert_eq!((small.status, small.header("content-type")), (200, Some("image/jpeg")));
    assert!((RgbFormat::Jpg.entry().decode)(&small.body).is_ok());
}

#[test]
fn the_timeline_counts_what_the_lines_hold() {
    let fixture = Fixture::new();
    let served = fixture.serve();
    let timeline = get(served.address, "/api/videos/0/timeline").json();
    let lines = read_objects(&fixture.video().join("camera_a/objects.jsonl")).expect("own data");
    let total = |frame: usize| {
        timeline["counts"]
            .as_array()
            .expect("rows")
            .iter()
            .map(|row| row[frame].as_u64().expect("a number"))
            .sum::<u64>()
    };
    for (frame, line) in lines.iter().enumerate() {
        assert_eq!(total(frame), line.objects.len() as u64, "frame {frame}");
    }
    let ids: BTreeSet<u16> = lines.iter().flat_map(|line| line.objects.iter().map(|object| object.id.0)).collect();
    let told = timeline["objects"].as_array().expect("objects");
    assert!(
        !ids.is_empty()
            && told.iter().map(|object| object["id"].as_u64()).eq(ids.iter().map(|id| Some(u64::from(*id))))
    );
    for object in told {
        let camera = &object["cameras"][0];
        let seen: Vec<u32> = lines
            .iter()
            .filter(|line| line.objects.iter().any(|o| Some(u64::from(o.id.0)) == object["id"].as_u64()))
            .map(|line| line.frame)
            .collect();
        assert_eq!(camera["boxes"].as_u64(), Some(seen.len() as u64));
        assert_eq!(camera["ranges"][0][0].as_u64(), Some(u64::from(seen[0])));
        let pixels = lines
            .iter()
            .flat_map(|line| &line.objects)
            .filter(|o| Some(u64::from(o.id.0)) == object["id"].as_u64())
            .map(|o| o.pixels)
            .max();
        assert_eq!(camera["best"]["pixels"].as_u64(), pixels.map(u64::from));
    }
}

#[test]
fn a_browser_keeps_what_has_not_changed() {
    let fixture = Fixture::new();
    let served = fixture.serve();
    for path in [
        "/",
        "/main.js",
        "/api/videos/0",
        "/api/videos/0/cameras/0/images/rgb/0",
        "/api/videos/0/cameras/0/pictures/depth/0",
    ] {
        let first = get(served.address, path);
        let tag = first.header("etag").unwrap_or_else(|| panic!("{path} has no tag")).to_owned();
        let again = get_with(served.address, path, &format!("If-None-Match: {tag}\r\n"));
        assert_eq!((again.status, again.body.len()), (304, 0), "{path}");
        let other = get_with(served.address, path, "If-None-Match: \"other\"\r\n");
        assert_eq!((other.status, other.body), (200, first.body), "{path}");
    }
}

#[test]
fn every_answer_tells_the_browser_to_be_careful() {
    let fixture = Fixture::new();
    let served = fixture.serve();
    for path in ["/", "/api/dataset", "/nothing", "/api/videos/7", "/api/videos/0/cameras/0/images/rgb/0"] {
        let answer = get(served.address, path);
        let policy = answer.header("content-security-policy").unwrap_or_default();
        assert!(
            policy.starts_with("default-src 'none'; script-src 'self'") && !policy.contains("unsafe"),
            "{path}: {policy}"
        );
        assert_eq!(answer.header("x-content-type-options"), Some("nosniff"), "{path}");
        assert_eq!(answer.header("cross-origin-resource-policy"), Some("same-origin"), "{path}");
        assert_eq!(answer.header("access-control-allow-origin"), None, "{path}");
    }
    let head = send(
        served.address,
        format!("HEAD / HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", served.address).as_bytes(),
    );
    assert_eq!((head.status, head.body.len()), (200, 0));
}

#[test]
fn the_page_holds_no_other_address_and_no_code_of_its_own() {
    let fixture = Fixture::new();
    let served = fixture.serve();
    let page = get(served.address, "/").text();
    let files: Vec<&str> =
        page.split('"').filter(|part| [".js", ".css", ".svg"].iter().any(|end| part.ends_with(end))).collect();
    assert!(files.len() > 20, "{files:?}");
    for file in files {
        let answer = get(served.address, &format!("/{file}"));
        assert_eq!(answer.status, 200, "{file}");
        let text = answer.text().replace("http://www.w3.org/2000/svg", "");
        assert!(!text.contains("http://") && !text.contains("https://"), "{file} loads from elsewhere");
        assert!(!text.contains("innerHTML") && !text.contains("eval("), "{file} makes code of text");
    }
    assert!(!page.contains("onclick") && !page.contains("<style") && !page.contains("style="));
}
