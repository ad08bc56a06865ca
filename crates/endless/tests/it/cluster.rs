//! `endless cluster`: what it writes for the schedulers of others.

use crate::program::{endless, refused, succeed};
use std::{
    fs,
    io::Write,
    path::Path,
    process::{Command, Stdio},
};

fn with_recipe() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("recipe.toml"), "videos = 8\nsize = \"64x36\"\n# it's \"small\"\n").expect("writable");
    folder
}

/// Without the folder of this test.
fn plain(folder: &Path, text: &str) -> String {
    text.replace(&folder.display().to_string(), "/shared")
}

#[test]
fn slurm_script() {
    let folder = with_recipe();
    let (least, _) = succeed(folder.path(), "cluster slurm recipe.toml --out out --shards 8");
    let all = "--time 04:00:00 --partition long --account lab --mem 16G --at-once 4 --cpus 16 --name paper";
    let (most, _) =
        succeed(folder.path(), &format!("cluster slurm recipe.toml --out s3://bucket/out --shards 64 {all}"));
    for script in [&least, &most] {
        let mut bash = Command::new("bash").arg("-n").stdin(Stdio::piped()).spawn().expect("bash");
        bash.stdin.take().expect("a pipe").write_all(script.as_bytes()).expect("writable");
        assert!(bash.wait().expect("waits").success());
    }
    insta::assert_snapshot!(plain(folder.path(), &least));
    insta::assert_snapshot!(plain(folder.path(), &most));
}

#[test]
fn kubernetes_manifest() {
    let folder = with_recipe();
    let shards = "cluster kubernetes recipe.toml --shards 8 --image registry/endless:1";
    let (claim, _) = succeed(folder.path(), &format!("{shards} --out paper --claim datasets"));
    insta::assert_snapshot!(claim);
    let (store, _) =
        succeed(folder.path(), &format!("{shards} --out s3://bucket/paper --secret store --cpus 4 --memory 6Gi"));
    insta::assert_snapshot!(store);
}

#[test]
fn what_no_cluster_takes_is_told_in_a_line() {
    let folder = with_recipe();
    fs::write(folder.path().join("broken.toml"), "videoz = 8\n").expect("writable");
    assert!(refused(folder.path(), "cluster slurm broken.toml --out out --shards 8").contains("broken.toml:1:1"));
    assert!(refused(folder.path(), "cluster slurm none.toml --out out --shards 8").contains("none.toml"));
    assert!(refused(folder.path(), "cluster slurm recipe.toml --out out --shards 0").contains("--shards"));
    let spaced = endless(folder.path(), "cluster slurm recipe.toml --out out --shards 8 --name Two_Words");
    assert!(!spaced.status.success());
}
