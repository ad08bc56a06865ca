//! Addresses of object storage and of folders.

use crate::program::{refused, succeed};

#[test]
fn addresses_that_cannot_be_are_refused_without_their_secrets() {
    let folder = tempfile::tempdir().expect("temp");
    for out in ["s3://AKIAHIDDEN:hunter2@bucket/a", "az://container/a?sig=hunter2"] {
        let said = refused(folder.path(), &format!("-vv generate {out} --videos 1"));
        assert!(said.contains("must not hold a user") && !said.contains("hunter2") && !said.contains("AKIA"), "{said}");
    }
    let said = refused(folder.path(), "generate ftp://host/a --videos 1");
    assert!(said.contains("unknown kind of address"), "{said}");
    let said = refused(folder.path(), "stats s3://bucket/a");
    assert!(said.contains("reads folders alone"), "{said}");
    let left: Vec<_> = std::fs::read_dir(folder.path()).expect("there").collect();
    assert!(left.is_empty(), "{left:?}");
}

#[cfg(not(feature = "cloud"))]
#[test]
fn a_program_without_object_storage_says_how_to_get_one() {
    let folder = tempfile::tempdir().expect("temp");
    for command in ["generate", "check"] {
        let said = refused(folder.path(), &format!("{command} s3://bucket/a"));
        assert!(said.contains("--features cloud"), "{said}");
    }
}

#[test]
fn the_address_of_a_folder_is_its_path() {
    let folder = tempfile::tempdir().expect("temp");
    let (out, _) =
        succeed(folder.path(), &format!("generate file://{}/out --videos 2 --plan-only", folder.path().display()));
    assert_eq!(out.lines().count(), 2);
    assert!(folder.path().join("out/scenes/0001.json").is_file());
}
