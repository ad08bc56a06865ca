//! Small crates with and without circles.

use super::file_graph;
use std::fs;

/// The circles of a crate of these files.
fn circles(files: &[(&str, &str)]) -> Vec<String> {
    let folder = tempfile::tempdir().expect("temp");
    for (name, text) in files {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().expect("in the folder")).expect("writable");
        fs::write(path, text).expect("writable");
    }
    file_graph(&folder.path().join("lib.rs")).expect("readable").cycles()
}

#[test]
fn two_files_that_use_each_other_are_a_circle() {
    let direct = circles(&[
        ("lib.rs", "mod a; mod b;"),
        ("a.rs", "use crate::b::B; pub struct A(B);"),
        ("b.rs", "pub struct B; fn of(a: &super::a::A) {}"),
    ]);
    assert_eq!(direct.len(), 1);
    assert!(direct[0].contains("2 files") && direct[0].contains("uses B of"), "{direct:?}");
    let one_way =
        [("lib.rs", "mod a; mod b;"), ("a.rs", "use crate::b::B; pub struct A(B);"), ("b.rs", "pub struct B;")];
    assert_eq!(circles(&one_way), Vec::<String>::new());
}

#[test]
fn re_exports_are_followed_and_are_no_use() {
    // Through the root's re-export, both ways.
    let through = circles(&[
        ("lib.rs", "mod a; mod b; pub use a::A; pub use b::{B as Renamed};"),
        ("a.rs", "use crate::Renamed; pub struct A(Renamed);"),
        ("b.rs", "pub struct B; fn of(a: &crate::A) {}"),
    ]);
    assert_eq!(through.len(), 1);
    // The root passes on what the files define, which use each other's one way: no circle.
    let plain = circles(&[
        ("lib.rs", "//! `A`.\nmod a; mod b; pub use a::*; pub use b::B;"),
        ("a.rs", "use crate::B; pub struct A(B);"),
        ("b.rs", "pub struct B;"),
    ]);
    assert_eq!(plain, Vec::<String>::new());
}

#[test]
fn what_a_parent_defines_itself_counts() {
    let child = ("m/child.rs", "use super::Shared; pub fn of(_: Shared) {}");
    let both =
        [("lib.rs", "mod m;"), ("m/mod.rs", "mod child; pub struct Shared; fn f() { child::of(Shared) }"), child];
    assert_eq!(circles(&both).len(), 1);
    let only_declares = [("lib.rs", "mod m;"), ("m/mod.rs", "mod child; pub struct Shared; pub use child::of;"), child];
    assert_eq!(circles(&only_declares), Vec::<String>::new());
    let passed_on_and_used = [
        ("lib.rs", "mod m;"),
        ("m/mod.rs", "mod child; pub struct Shared; pub use child::of; fn f() { of(Shared) }"),
        child,
    ];
    assert_eq!(circles(&passed_on_and_used).len(), 1);
}

#[test]
fn macros_globs_and_inline_modules_are_seen_through_and_tests_are_not() {
    let files =
        |a: &'static str| [("lib.rs", "mod a; mod b;"), ("a.rs", a), ("b.rs", "pub struct B; fn f(a: crate::a::A) {}")];
    let in_macro = circles(&files("pub struct A; fn f() { println!(\"{}\", crate::b::B) }"));
    assert_eq!(in_macro.len(), 1);
    let by_glob = circles(&files("use crate::b::*; pub struct A(B);"));
    assert_eq!(by_glob.len(), 1);
    let inline = circles(&files("pub struct A; mod inner { use super::super::b::B; struct C(B); }"));
    assert_eq!(inline.len(), 1);
    let in_tests = circles(&files("pub struct A; #[cfg(test)] mod tests { use crate::b::B; }"));
    assert_eq!(in_tests, Vec::<String>::new());
    let in_words = circles(&files("pub struct A; /* crate::b::B */ const TEXT: &str = \"crate::b::B\";"));
    assert_eq!(in_words, Vec::<String>::new());
}

#[test]
fn what_a_macro_defines_lies_in_the_file_of_its_module() {
    let files = [
        ("lib.rs", "mod ids; mod user; pub use ids::LaneId;"),
        ("ids.rs", "id_type! { LaneId } fn f(_: crate::user::User) {}"),
        ("user.rs", "use crate::LaneId; pub struct User(LaneId);"),
    ];
    assert_eq!(circles(&files).len(), 1);
}
