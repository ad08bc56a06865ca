//! Every bad input is refused in one line that says what to do, and harms nothing.

use std::{
    fs,
    path::Path,
    process::{Command, Output, Stdio},
};

fn endless(folder: &Path, args: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_endless"))
        .args(args.split_whitespace())
        .current_dir(folder)
        .env("ENDLESS_MAPS", folder.join("maps"))
        .output()
        .expect("runs")
}

/// Exit code and what was said, for each command line.
fn said(folder: &Path, commands: &[&str]) -> String {
    let mut text = String::new();
    for args in commands {
        let output = endless(folder, args);
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(message.lines().count(), 1, "one line for '{args}': {message}");
        assert!(output.stdout.is_empty());
        let code = output.status.code().expect("no signal");
        text += &format!("endless {args}\n  {code}: {message}");
    }
    text
}

#[test]
fn what_was_asked_cannot_be() {
    let folder = tempfile::tempdir().expect("temp");
    fs::write(folder.path().join("typo.toml"), "videos = 3\nwheather = [\"rainy\"]\n").expect("writable");
    fs::write(folder.path().join("broken.toml"), "videos = = 3\n").expect("writable");
    fs::write(folder.path().join("words.toml"), "videos = \"many\"\n").expect("writable");
    insta::assert_snapshot!(said(
        folder.path(),
        &[
            "",
            "generat out",
            "generate",
            "generate out --frames 3",
            "generate out --maps Town99",
            "generate out --maps Town01,",
            "generate out --weathers snowy",
            "generate out --times noon",
            "generate out --layers rgb,lidar",
            "generate out --mp4 depth --layers rgb",
            "generate out --rgb-format webp",
            "generate out --videos 0",
            "generate out --videos -3",
            "generate out --videos many",
            "generate out --vehicles -1",
            "generate out --pedestrians -1",
            "generate out --min-pixels -1",
            "generate out --fps 0",
            "generate out --fps nan",
            "generate out --duration 0",
            "generate out --duration -2",
            "generate out --duration 0.01",
            "generate out --duration 1000000",
            "generate out --size 0x720",
            "generate out --size 8193x720",
            "generate out --size 720p",
            "generate out --threads 0",
            "generate out --simulator unreal",
            "generate out --simulator carla://localhost:x",
            "generate out --memory much",
            "generate out --memory 3XB",
            "generate out --cache typo.toml/cache",
            "generate out --config missing.toml",
            "generate out --config typo.toml",
            "generate out --config broken.toml",
            "generate out --config words.toml",
            "simulate Town02",
            "simulate Town02 --out tracks.json",
            "simulate Town02 --top-view view.gif",
            "simulate Town02 --audit --vehicles many",
            "simulate Town02 --audit --seconds 0",
            "simulate Town02 --audit --fps 1000",
            "simulate Town02 --audit --weather snowy",
            "simulate Town99 --audit",
            "simulate missing.xodr --audit",
        ],
    ));
    assert!(!folder.path().join("out").exists(), "nothing was made");
}

#[test]
fn tracks_cannot_be_played() {
    let folder = tempfile::tempdir().expect("temp");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("writable");
    write("good.csv", "time,id,class,x,y,yaw\n5,a,car,0,0,0\n6,a,car,5,0,0\n");
    write("far.csv", "time,id,class,x,y,yaw\n5,a,car,90000,0,0\n6,a,car,90005,0,0\n");
    write("line.csv", "time,id,class,x,y,yaw\n5,a,car,0,0,0\n6,a,car,nowhere,0,0\n");
    write("header.csv", "frame,track,x,y\n5,a,0,0\n");
    write("cut.xml", "<fcd-export>\n<timestep time=\"0.00\">\n<vehicle id=\"a\" x=\"1\" y=\"2\"");
    write("net.xml", "<net version=\"1.20\"/>");
    write(
        "degrees.xml",
        "<fcd-export>\n<timestep time=\"0\"><vehicle id=\"a\" x=\"9.1\" y=\"48.7\" angle=\"0\" speed=\"12\"/></timestep>\n\
          <timestep time=\"1\"><vehicle id=\"a\" x=\"9.1\" y=\"48.70011\" angle=\"0\" speed=\"12\"/></timestep>\n</fcd-export>",
    );
    insta::assert_snapshot!(said(
        folder.path(),
        &[
            "generate out --maps Town02 --traffic none.xml",
            "generate out --maps Town02 --traffic line.csv",
            "generate out --maps Town02 --traffic header.csv",
            "generate out --maps Town02 --traffic cut.xml",
            "generate out --maps Town02 --traffic net.xml",
            "generate out --maps Town02 --traffic degrees.xml",
            "generate out --maps Town02 --traffic far.csv",
            "generate out --maps Town02 --traffic good.csv --traffic-begin 7",
            "generate out --maps Town02 --traffic good.csv --traffic-offset 7",
            "generate out --maps Town02 --traffic good.csv --traffic-offset 1,nan",
            "generate out --maps Town02 --traffic-offset 1,2",
            "generate out --maps Town02,Town03 --traffic good.csv",
        ],
    ));
    assert!(!folder.path().join("out").exists(), "nothing was made");
}

#[test]
fn rigs_cannot_be_mounted() {
    let folder = tempfile::tempdir().expect("temp");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("writable");
    let car = "mount = { on = \"vehicle\", class = \"car\", at = [0.0, 0.0, 1.7] }\n";
    let sensor = |rest: &str| format!("[[sensor]]\nname = \"a\"\n{rest}");
    write("type.toml", &sensor(&format!("type = \"sonar\"\n{car}")));
    write("twice.toml", &sensor(&format!("type = \"imu\"\n{car}")).repeat(2));
    write("stopped.toml", &sensor(&format!("type = \"lidar\"\nrate = 0\n{car}")));
    write("odd.toml", &sensor(&format!("type = \"lidar\"\nrate = 7\n{car}")));
    write("key.toml", &sensor(&format!("type = \"lidar\"\nchanels = 7\n{car}")));
    write("preset.toml", &sensor(&format!("type = \"lidar\"\npreset = \"hdl_65\"\n{car}")));
    write("value.toml", &sensor(&format!("type = \"lidar\"\nrange = -4.0\n{car}")));
    write("word.toml", &sensor(&format!("type = \"gnss\"\nrate = \"fast\"\n{car}")));
    write("unmounted.toml", &sensor("type = \"imu\"\n"));
    write("syntax.toml", "[[sensor]\n");
    write("syntax.json", "{\"sensor\": [");
    write("empty.toml", "");
    let on = |mount: &str| sensor(&format!("type = \"camera\"\nmount = {{ {mount} }}\n"));
    write("nobody.toml", &on("on = \"vehicle\", number = 500, at = [0.0, 0.0, 1.7]"));
    write("tank.toml", &on("on = \"vehicle\", class = \"tank\", at = [0.0, 0.0, 1.7]"));
    write("ground.toml", &on("on = \"pose\", from = \"junction\", at = [0.0, 0.0, -3.0]"));
    write("site.toml", &on("on = \"site\", site = \"moon\""));
    let rigs = [
        "type",
        "twice",
        "stopped",
        "odd",
        "key",
        "preset",
        "value",
        "word",
        "unmounted",
        "syntax",
        "empty",
        "nobody",
        "tank",
        "ground",
        "site",
    ];
    let commands = rigs.map(|rig| format!("generate out --maps Town02 --rig {rig}.toml"));
    let more = ["none.toml", "syntax.json"].map(|rig| format!("generate out --maps Town02 --rig {rig}"));
    let bench = ["bench --rig type.toml".to_owned(), "bench --conditions --rig nobody.toml".to_owned()];
    let all: Vec<&str> = commands.iter().chain(&more).chain(&bench).map(String::as_str).collect();
    insta::assert_snapshot!(said(folder.path(), &all));
    assert!(!folder.path().join("out").exists(), "nothing was made");
}

#[test]
fn the_output_cannot_be_used() {
    let folder = tempfile::tempdir().expect("temp");
    fs::write(folder.path().join("file"), "dear").expect("writable");
    fs::create_dir(folder.path().join("full")).expect("writable");
    fs::write(folder.path().join("full/thesis.tex"), "dear").expect("writable");
    insta::assert_snapshot!(said(
        folder.path(),
        &[
            "generate file --maps Town01",
            "generate full --maps Town01",
            "generate file/below --maps Town01 --plan-only",
            "generate /proc/out --maps Town01 --plan-only",
            "check full",
            "check nowhere",
        ],
    ));
    assert_eq!(fs::read_to_string(folder.path().join("full/thesis.tex")).expect("there"), "dear");
    let plan = endless(folder.path(), "generate out --maps Town01 --videos 3 --plan-only");
    assert_eq!((plan.status.code(), String::from_utf8_lossy(&plan.stdout).lines().count()), (Some(0), 3));
    insta::assert_snapshot!(said(
        folder.path(),
        &[
            "generate out --maps Town01 --videos 3 --fps 25",
            "generate out --maps Town01 --videos 2",
            "generate out --maps Town01 --videos 3 --seed 1",
        ],
    ));
    let huge = endless(folder.path(), "generate huge --maps Town01 --videos 5000 --duration 900");
    let message = String::from_utf8_lossy(&huge.stderr);
    assert_eq!(huge.status.code(), Some(1));
    assert!(message.contains("free, the dataset needs about") && message.lines().count() == 1, "{message}");
    assert!(!folder.path().join("huge").exists(), "said before it starts");
}

#[test]
fn a_reader_who_has_seen_enough_is_no_error() {
    let mut listing = Command::new(env!("CARGO_BIN_EXE_endless"))
        .args(["assets", "list"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("starts");
    drop(listing.stdout.take());
    let output = listing.wait_with_output().expect("ends");
    assert!(output.status.success());
    assert!(!String::from_utf8_lossy(&output.stderr).contains("error"), "{output:?}");
}
