//! A dataset that is being written shows what is complete.

use crate::{
    fixture::{FRAMES, Fixture, SECRET},
    http::{Answer, get},
};
use serde_json::Value;
use std::{fs, net::SocketAddr, thread::sleep, time::Duration};

/// Asks for the overview until it is as it should be.
fn overview_once(address: SocketAddr, done: impl Fn(&Value) -> bool) -> Value {
    for _ in 0..600 {
        let overview = get(address, "/api/dataset").json();
        if done(&overview) {
            return overview;
        }
        sleep(Duration::from_millis(50));
    }
    panic!("it never came: {}", get(address, "/api/dataset").text());
}

#[test]
fn what_is_half_written_is_shown_as_far_as_it_goes() {
    let fixture = Fixture::new();
    let folder = fixture.add_video(1, "planned");
    // As a run leaves it that is at its second frame: no labels yet, an image half written.
    for file in ["scene.json", "actors.json", "frames.jsonl"] {
        let _ = fs::remove_file(folder.join(file));
    }
    let camera = folder.join("camera_a");
    fs::rename(camera.join("objects.jsonl"), camera.join(".objects.jsonl.tmp")).expect("there");
    for layer in fs::read_dir(&camera).expect("there").flatten().filter(|entry| entry.path().is_dir()) {
        fs::rename(layer.path().join("000001.png"), layer.path().join(".000001.png.tmp")).expect("there");
    }
    let untouched = fixture.add_video(2, "planned");
    fs::remove_dir_all(untouched).expect("there");

    let served = fixture.serve();
    let get = |path: &str| get(served.address, path);
    let overview = overview_once(served.address, |overview| overview["pending"] == 0);
    let videos = overview["videos"].as_array().expect("videos");
    assert_eq!(videos.len(), 3);
    assert!(videos[0]["facts"]["most_at_once"].as_u64() > Some(0) && videos[0].get("recorded").is_none());
    assert_eq!((&videos[1]["recorded"], videos[1].get("facts")), (&1.into(), None));
    assert_eq!((videos[2].get("recorded"), &videos[2]["state"]), (None, &"planned".into()));

    let video = get("/api/videos/1").json();
    assert_eq!((&video["frames_there"], &video["views"][0]["has_objects"]), (&1.into(), &false.into()));
    let status = |answer: Answer| answer.status;
    assert_eq!(status(get("/api/videos/1/cameras/0/images/rgb/0")), 200);
    assert_eq!(status(get("/api/videos/1/cameras/0/thumbnail")), 200);
    for missing in ["cameras/0/images/rgb/1", "cameras/0/objects?from=0&count=1", "frames?from=0&count=1", "actors"] {
        assert_eq!(status(get(&format!("/api/videos/1/{missing}"))), 404, "{missing}");
    }
    assert_eq!(get("/api/videos/1/timeline").json()["objects"], Value::Array(Vec::new()));
    assert_eq!(get("/api/videos/2").json()["frames_there"], 0);
}

#[test]
fn a_video_appears_when_it_is_complete() {
    let fixture = Fixture::new();
    fixture.add_video(1, "planned");
    let served = fixture.serve();
    let before = overview_once(served.address, |overview| overview["pending"] == 0);
    assert_eq!(before["videos"][1]["state"], "planned");
    fixture.change(|manifest| manifest["videos"][1]["state"] = "complete".into());
    let after = overview_once(served.address, |overview| overview["videos"][1].get("facts").is_some());
    assert_eq!(after["videos"][1]["facts"]["objects"], after["videos"][0]["facts"]["objects"]);
    let video = get(served.address, "/api/videos/1").json();
    assert_eq!((&video["state"], &video["frames_there"]), (&"complete".into(), &FRAMES.into()));
}

#[test]
fn damaged_files_are_told_and_harm_nothing_else() {
    let fixture = Fixture::new();
    let served = fixture.serve();
    let camera = fixture.video().join("camera_a");
    fs::write(camera.join("rgb/000000.png"), "no picture").expect("room");
    fs::write(camera.join("depth/000000.png"), [0; 7]).expect("room");
    fs::write(camera.join("objects.jsonl"), "{\"frame\":0,\n").expect("room");
    let told = |path: &str| {
        let answer = get(served.address, path);
        (answer.status, answer.text())
    };
    assert!(matches!(told("/api/videos/0/cameras/0/thumbnail"), (500, text) if text.starts_with("rgb/000000.png: ")));
    assert_eq!(told("/api/videos/0/cameras/0/pictures/depth/0").0, 500);
    assert!(matches!(told("/api/videos/0/timeline"), (500, text) if text.contains("objects.jsonl: line 1")));
    // The list of videos does without its facts.
    let overview = overview_once(served.address, |overview| overview["pending"] == 0);
    assert_eq!(overview["videos"][0].get("facts"), None);
    assert_eq!(told("/api/videos/0/cameras/0/images/rgb/1").0, 200);

    fs::write(fixture.out.join("dataset.json"), "{").expect("room");
    assert!(matches!(told("/api/dataset"), (500, text) if text.contains("dataset.json")));
    assert_eq!(told("/").0, 200);
}

#[test]
fn names_in_the_dataset_lead_nowhere() {
    let fixture = Fixture::new();
    fs::create_dir_all(fixture.out.join("../elsewhere")).expect("room");
    for (number, name) in [(1, "../../elsewhere"), (2, ".."), (3, "a/b"), (4, "/"), (5, "<script>alert(1)</script>")] {
        fixture.add_video(number, "complete");
        fixture.change(|manifest| {
            manifest["videos"][number as usize]["name"] = name.into();
            manifest["videos"][number as usize]["map"] = "</script><script>alert(1)</script>".into();
        });
    }
    let served = fixture.serve();
    let overview = get(served.address, "/api/dataset");
    assert_eq!((overview.status, overview.header("content-type")), (200, Some("application/json")));
    assert_eq!(overview.json()["videos"][5]["name"], "<script>alert(1)</script>");
    for number in 1..=5 {
        for rest in ["", "/actors", "/timeline", "/cameras/0/images/rgb/0", "/cameras/0/thumbnail"] {
            let answer = get(served.address, &format!("/api/videos/{number}{rest}"));
            assert!(answer.status >= 400, "video {number}{rest}");
            assert!(!answer.text().contains(SECRET));
        }
    }
}

#[cfg(unix)]
#[test]
fn links_that_leave_the_dataset_are_not_followed() {
    use std::os::unix::fs::symlink;
    let fixture = Fixture::new();
    let camera = fixture.video().join("camera_a");
    let replace = |file: &str, target: &str| {
        fs::remove_file(camera.join(file)).expect("there");
        symlink(target, camera.join(file)).expect("room");
    };
    replace("rgb/000000.png", "../../../../../secret.txt");
    replace("objects.jsonl", "/etc/passwd");
    replace("map.json", "../../../../secret.txt");
    replace("depth/000000.png", "000001.png");
    let served = fixture.serve();
    for path in ["images/rgb/0", "pictures/rgb/0", "thumbnail", "objects?from=0&count=9", "map"] {
        let answer = get(served.address, &format!("/api/videos/0/cameras/0/{path}"));
        assert_eq!(answer.status, 404, "{path}: {}", answer.text());
    }
    assert_eq!(get(served.address, "/api/videos/0/cameras/0/images/depth/0").status, 200, "a link inside");
}
