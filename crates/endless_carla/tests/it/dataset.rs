//! Datasets that our client makes on our server, also through a proxy that loses, mixes up and falsifies.

use crate::client::{Client, MAP, serve};
use crate::proxy::{Fault, proxy};
use endless_carla::client::{Address, CarlaSettings, CarlaSimulator, StopFlag};
use endless_carla::wire::{EpisodeSettings, Wire};
use endless_dataset::{BuildIdentity, DatasetLayout, Layer, Recipe, RecipeDraft, RgbFormat, check, read_rgb};
use endless_pipeline::{GenerateError, GenerateOptions, SilentProgress, SimulatorError, generate, resolve_recipe};
use endless_world::Image;
use std::net::SocketAddr;
use std::path::Path;
use std::time::Duration;

const FRAMES: u32 = 6;

pub(crate) fn settings(address: SocketAddr) -> CarlaSettings {
    CarlaSettings {
        address: Address { host: address.ip().to_string(), port: address.port() },
        traffic_manager: None,
        frame_limit: Duration::from_millis(500),
        reconnect_limit: Duration::from_secs(20),
        finds_sites: true,
        stop: StopFlag::default(),
    }
}

fn recipe(simulator: &CarlaSimulator) -> Recipe {
    let draft = RecipeDraft {
        maps: Some(vec![MAP.to_owned()]),
        videos: Some(1),
        vehicles: Some(12),
        pedestrians: Some(8),
        size: Some("160x96".parse().expect("a size")),
        fps: Some(10.0),
        duration: Some(f64::from(FRAMES) / 10.0),
        weathers: Some(vec!["cloudy".to_owned()]),
        times: Some(vec!["afternoon".to_owned()]),
        min_pixels: Some(10),
        simulator: Some("carla".to_owned()),
        mp4: Some(Vec::new()),
        ..RecipeDraft::default()
    };
    resolve_recipe(draft, simulator).expect("a recipe")
}

fn make(simulator: &CarlaSimulator, out: &Path) -> Result<(), GenerateError> {
    let options = GenerateOptions {
        build: BuildIdentity { version: "0".to_owned(), sources: "0".to_owned(), commit: None },
        allow_other_build: false,
        threads: 2,
        plan_only: false,
        shard: None,
    };
    generate(simulator, &recipe(simulator), out, &options, &SilentProgress).map(drop)
}

/// The depth of every frame of both cameras: what stands where at that instant.
fn depths(out: &Path) -> Vec<Image<[u8; 3]>> {
    let layout = DatasetLayout::new(out);
    let manifest: endless_dataset::Manifest = endless_dataset::read_json(&layout.manifest()).expect("a manifest");
    let video = layout.video_named(&manifest.videos[0].name);
    let frames = |camera| (0..FRAMES).map(move |frame| (camera, frame));
    (0..2)
        .flat_map(frames)
        .map(|(camera, frame)| {
            let path = video.camera(camera).frame(Layer::Depth, frame, RgbFormat::Png);
            read_rgb(&path, RgbFormat::Png).expect("an image").rgb8().expect("8 bits").clone()
        })
        .collect()
}

/// Whether what stands where is the same to the centimetre: who is asked again for an instant may have turned a wheel meanwhile.
fn agree(told: &[Image<[u8; 3]>], expected: &[Image<[u8; 3]>]) -> bool {
    // CARLA's depth: a kilometre in 24 bits, the lowest first.
    let metres = |[low, middle, high]: [u8; 3]| {
        f64::from(u32::from_le_bytes([low, middle, high, 0])) / f64::from((1u32 << 24) - 1) * 1000.0
    };
    let near = |(a, b): (&[u8; 3], &[u8; 3])| (metres(*a) - metres(*b)).abs() < 0.01;
    told.len() == expected.len()
        && told.iter().zip(expected).all(|(told, expected)| told.data.iter().zip(&expected.data).all(near))
}

fn is_sound(out: &Path) {
    let report = check(out).expect("a dataset");
    assert_eq!((report.findings, report.images), (vec![], 3 * 2 * u64::from(FRAMES)));
}

#[test]
fn a_dataset_is_made_and_nothing_is_left_behind() {
    let server = serve();
    let before: EpisodeSettings = Client::new(server).get("get_episode_settings", &[]);
    let simulator = CarlaSimulator::connect(settings(server)).expect("a server");
    let out = tempfile::tempdir().expect("temp");
    make(&simulator, out.path()).expect("a dataset");
    is_sound(out.path());
    drop(simulator);
    let mut client = Client::new(server);
    assert_eq!(client.get::<EpisodeSettings>("get_episode_settings", &[]).to_value(), before.to_value());
    assert_eq!(client.get::<Vec<(u32, u32)>>("get_vehicle_light_states", &[]), vec![], "no vehicle is left");
}

#[test]
fn what_is_lost_or_false_on_the_way_never_comes_into_a_dataset() {
    let whole = tempfile::tempdir().expect("temp");
    let simulator = CarlaSimulator::connect(settings(serve())).expect("a server");
    make(&simulator, whole.path()).expect("a dataset");
    let expected = depths(whole.path());
    for fault in [
        Fault::LosesATenth,
        Fault::DeliversLate,
        Fault::SaysThingsTwice,
        Fault::Stalls,
        Fault::ReusesIds,
        Fault::Hangs,
        Fault::SendsGarbage,
    ] {
        let (address, faults) = proxy(serve(), fault);
        let simulator = CarlaSimulator::connect(settings(address)).expect("a server behind a proxy");
        let out = tempfile::tempdir().expect("temp");
        make(&simulator, out.path()).unwrap_or_else(|error| panic!("{fault:?}: {error}"));
        is_sound(out.path());
        assert!(faults.count() > 0, "{fault:?} happened");
        assert!(agree(&depths(out.path()), &expected), "{fault:?}: every frame shows its own instant");
    }
}

#[test]
fn a_server_of_0_9_15_is_spoken_with_in_its_terms() {
    let [newer, older] = [(); 2].map(|()| tempfile::tempdir().expect("temp"));
    let simulator = CarlaSimulator::connect(settings(serve())).expect("a server");
    make(&simulator, newer.path()).expect("a dataset");
    let (address, misunderstood) = proxy(serve(), Fault::IsOlder);
    let simulator = CarlaSimulator::connect(settings(address)).expect("an older server");
    make(&simulator, older.path()).expect("a dataset");
    is_sound(older.path());
    assert_eq!(misunderstood.count(), 0);
    assert!(depths(older.path()) == depths(newer.path()));
}

#[test]
fn who_stops_leaves_nothing_behind() {
    // While one of each vehicle stands in the sky to be measured, and when videos are made.
    let has_vehicles = |client: &mut Client, _: &Path| !vehicles(client).is_empty();
    let has_videos = |_: &mut Client, out: &Path| out.join("videos").is_dir();
    for is_now in [has_vehicles as fn(&mut Client, &Path) -> bool, has_videos] {
        let server = serve();
        let settings = settings(server);
        let stop = settings.stop.clone();
        let simulator = CarlaSimulator::connect(settings).expect("a server");
        let out = tempfile::tempdir().expect("temp");
        std::thread::scope(|scope| {
            scope.spawn(|| {
                let mut client = Client::new(server);
                while !is_now(&mut client, out.path()) {
                    std::thread::sleep(Duration::from_millis(1));
                }
                stop.stop();
            });
            let error = make(&simulator, out.path()).expect_err("it is stopped");
            assert!(matches!(error, GenerateError::Simulator(SimulatorError::Interrupted)), "{error}");
        });
        drop(simulator);
        let mut client = Client::new(server);
        assert!(!client.get::<EpisodeSettings>("get_episode_settings", &[]).synchronous_mode);
        assert_eq!(vehicles(&mut client), vec![], "no vehicle is left");
    }
}

/// Ids and lights of the vehicles there are.
fn vehicles(client: &mut Client) -> Vec<(u32, u32)> {
    client.get("get_vehicle_light_states", &[])
}

#[test]
fn other_peers_are_told_apart() {
    let refused =
        |address: SocketAddr| CarlaSimulator::connect(settings(address)).err().expect("no server").to_string();
    let free = std::net::TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = free.local_addr().expect("an address");
    drop(free);
    assert!(refused(address).contains("nothing listens there"), "{}", refused(address));
    for (said, told) in [
        (&b"HTTP/1.1 400 Bad Request\r\n\r\n"[..], "does not speak CARLA's protocol"),
        (&[0x94, 1, 1, 0xc0, 0x91, 0x92, 1, 0xa6, b'0', b'.', b'9', b'.', b'1', b'0'][..], "it is CARLA 0.9.10"),
        (&[][..], "broke"),
    ] {
        let listener = std::net::TcpListener::bind("127.0.0.1:0").expect("a port");
        let address = listener.local_addr().expect("an address");
        std::thread::spawn(move || {
            let (mut stream, _) = listener.accept().expect("a client");
            // The client may have gone.
            let _ = std::io::Read::read(&mut stream, &mut [0; 64]);
            let _ = std::io::Write::write_all(&mut stream, said);
        });
        let error = refused(address);
        assert!(error.contains(told) || error.contains("lost"), "{error}");
    }
}
