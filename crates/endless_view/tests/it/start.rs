//! What is said when nothing can be shown.

use crate::{
    fixture::Fixture,
    http::{get, send},
};
use endless_view::{ViewSettings, Viewer};
use std::{fs, path::Path};

fn refusal(folder: &Path, port: u16) -> String {
    let settings = ViewSettings { folder: folder.to_owned(), bind: [127, 0, 0, 1].into(), port };
    let said = Viewer::bind(&settings).expect_err("it cannot begin").to_string();
    assert_eq!(said.lines().count(), 1);
    said
}

#[test]
fn a_folder_that_is_no_dataset_is_told() {
    let folder = tempfile::tempdir().expect("temp");
    for path in [folder.path().to_owned(), folder.path().join("none")] {
        assert!(refusal(&path, 0).starts_with("there is no dataset (no dataset.json): give the folder"));
    }
    fs::write(folder.path().join("dataset.json"), "[]").expect("room");
    assert!(refusal(folder.path(), 0).contains("dataset.json: is not a dataset's"));
    fs::write(folder.path().join("dataset.json"), "{\"format\": 1}").expect("room");
    assert!(refusal(folder.path(), 0).contains("has format 1, this program shows 2"));
}

#[test]
fn a_port_in_use_is_told() {
    let fixture = Fixture::new();
    let served = fixture.serve();
    let port = served.address.port();
    assert_eq!(
        refusal(&fixture.out, port),
        format!("port {port} of 127.0.0.1 is in use: give another with --port, or leave it out for any that is free")
    );
}

#[test]
fn others_are_let_in_by_address_where_that_is_asked_for() {
    let fixture = Fixture::new();
    let settings = ViewSettings { folder: fixture.out.clone(), bind: [0, 0, 0, 0].into(), port: 0 };
    let viewer = Viewer::bind(&settings).expect("a dataset");
    let address = ([127, 0, 0, 1], viewer.address().port()).into();
    let stopper = viewer.stopper();
    let thread = std::thread::spawn(move || viewer.run());
    assert_eq!(get(address, "/").status, 200);
    for (host, status) in [("192.168.7.7:80", 200), ("evil.example", 403)] {
        let request = format!("GET / HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n");
        assert_eq!(send(address, request.as_bytes()).status, status, "{host}");
    }
    stopper.stop();
    thread.join().expect("it ends").expect("without an error");
}
