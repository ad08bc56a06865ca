//! `endless view` as it is started.

use crate::program::refused;
use std::{fs, net::TcpListener};

const DATASET: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../endless_fuzz/datasets/all_layers");

#[test]
fn what_cannot_be_shown_is_told_in_one_line() {
    let folder = tempfile::tempdir().expect("temp");
    let said = refused(folder.path(), "view none");
    assert_eq!(
        said,
        "error: there is no dataset (no dataset.json): give the folder that `endless generate` writes: none\n"
    );
    fs::create_dir(folder.path().join("empty")).expect("room");
    assert!(refused(folder.path(), "view empty").contains("there is no dataset"));
    let taken = TcpListener::bind("127.0.0.1:0").expect("a port");
    let port = taken.local_addr().expect("bound").port();
    let said = refused(folder.path(), &format!("view {DATASET} --port {port}"));
    assert!(said.contains(&format!("port {port} of 127.0.0.1 is in use: give another with --port")), "{said}");
}

#[cfg(unix)]
#[test]
fn the_address_is_printed_and_ctrl_c_ends_it_well() {
    use std::{
        io::{BufRead, BufReader, Read, Write},
        net::TcpStream,
        process::{Command, Stdio},
    };
    let mut program = Command::new(env!("CARGO_BIN_EXE_endless"))
        .args(["view", DATASET])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("starts");
    let mut line = String::new();
    let out = program.stdout.as_mut().expect("piped");
    BufReader::new(out).read_line(&mut line).expect("text");
    let address = line.trim().strip_prefix("http://").and_then(|rest| rest.strip_suffix('/')).expect("an address");
    let mut stream = TcpStream::connect(address).expect("it listens");
    write!(stream, "GET / HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n").expect("it reads");
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("text");
    assert!(answer.starts_with("HTTP/1.1 200 OK") && answer.contains("<title>ENDLESS</title>"), "{answer:.200}");
    let interrupted = Command::new("kill").args(["-INT", &program.id().to_string()]).status().expect("kill");
    assert!(interrupted.success());
    assert_eq!(program.wait().expect("ends").code(), Some(0));
}
