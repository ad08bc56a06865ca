//! Things of a map and whole layers that clients take out of sight and bring back.

use crate::client::{Client, Stream, serve};
use crate::solid_things::{ahead, crash};
use endless_carla::wire::{
    BoundingBox, EnvironmentObject, LabelledPoint, LightState, Location, Rotation, Transform, Wire,
};
use std::collections::BTreeSet;

const BUILDING: u8 = 3;
const VEGETATION: u8 = 9;
const CAR: u8 = 14;
const ANY: u8 = 255;

fn things(client: &mut Client, label: u8) -> Vec<EnvironmentObject> {
    client.get("get_environment_objects", &[label.into()])
}

fn enable(client: &mut Client, things: &[&EnvironmentObject], enabled: bool) {
    let ids: Vec<u64> = things.iter().map(|thing| thing.id).collect();
    client.call("enable_environment_objects", &[ids.to_value(), enabled.into()]).expect("accepted");
}

/// Classes of what a ray from the sky meets.
fn met_from_above(client: &mut Client, thing: &EnvironmentObject) -> Vec<u8> {
    let at = |z: f32| Location { z, ..thing.bounding_box.location.clone() };
    let points: Vec<LabelledPoint> = client.get("cast_ray", &[at(300.0).to_value(), at(-5.0).to_value()]);
    points.into_iter().map(|point| point.label).collect()
}

/// Cameras before a thing and above it.
fn cameras(client: &mut Client, thing: &EnvironmentObject) -> Vec<Stream> {
    let BoundingBox { location, extent, .. } = &thing.bounding_box;
    let reach = extent.x.hypot(extent.y);
    let back = Location { x: location.x - reach - 12.0, y: location.y, z: location.z + extent.z + 14.0 };
    let place = Transform { location: back, rotation: Rotation { pitch: -35.0, ..Rotation::default() } };
    ["sensor.camera.semantic_segmentation", "sensor.camera.depth", "sensor.camera.rgb"]
        .map(|kind| {
            let camera = client.description(kind, &[("image_size_x", "96"), ("image_size_y", "54")]);
            let camera = client.spawn(&camera, &place);
            client.listen(&camera.stream_token)
        })
        .into()
}

fn seen(client: &mut Client, streams: &mut [Stream]) -> Vec<Vec<u8>> {
    let frame = client.tick();
    streams.iter_mut().map(|stream| stream.of_frame(frame).payload).collect()
}

fn pixels(semantic: &[u8], label: u8) -> usize {
    semantic[12..].as_chunks::<4>().0.iter().filter(|pixel| pixel[2] == label).count()
}

#[test]
fn hidden_things_are_neither_seen_nor_met_until_they_are_shown_again() {
    let mut client = Client::new(serve());
    client.synchronous();
    let buildings = things(&mut client, BUILDING);
    let size = |thing: &&EnvironmentObject| thing.bounding_box.extent.x.min(thing.bounding_box.extent.y);
    let building = buildings.iter().max_by(|a, b| size(a).total_cmp(&size(b))).expect("one");
    let all = things(&mut client, ANY);
    let of_it =
        |thing: &&EnvironmentObject| (thing.id - building.id % 32) / 32 == (building.id - building.id % 32) / 32;
    let parts: Vec<&EnvironmentObject> = all.iter().filter(|thing| thing.id > 1_000_000).filter(of_it).collect();
    let mut streams = cameras(&mut client, building);
    // Twice, for what a camera has learnt of a place must not stay.
    let before = seen(&mut client, &mut streams);
    assert_eq!(seen(&mut client, &mut streams)[..2], before[..2]);
    assert!(met_from_above(&mut client, building).contains(&BUILDING));

    enable(&mut client, &parts, false);
    let hidden = seen(&mut client, &mut streams);
    let [with, without] = [&before, &hidden].map(|seen| pixels(&seen[0], BUILDING));
    assert!(with > 800 && without + 800 < with, "{with} and {without} pixels");
    assert!(hidden[1] != before[1] && hidden[2] != before[2]);
    assert!(!met_from_above(&mut client, building).contains(&BUILDING));
    // It can still be named, and has no box in the level.
    assert_eq!(things(&mut client, BUILDING).len(), buildings.len());
    let boxes: Vec<BoundingBox> = client.get("get_all_level_BBs", &[BUILDING.into()]);
    assert_eq!(boxes.len() + 1, buildings.len());

    enable(&mut client, &parts, true);
    let again = seen(&mut client, &mut streams);
    assert_eq!(again[..2], before[..2]);
    assert!(met_from_above(&mut client, building).contains(&BUILDING));
}

#[test]
fn nobody_meets_what_is_hidden() {
    let mut client = Client::new(serve());
    client.synchronous();
    let parked = things(&mut client, CAR);
    let start = ahead(&parked[0].transform, -9.0, 0.3);
    let (met, moved) = crash(&mut client, &start, 12.0);
    assert!(met.is_some() && moved < 9.0, "{moved} m");
    // Behind them others stand.
    let all = things(&mut client, ANY);
    enable(&mut client, &all.iter().collect::<Vec<_>>(), false);
    let (met, moved) = crash(&mut client, &start, 12.0);
    assert!(met.is_none() && moved > 9.0, "{moved} m, {met:?}");
    // Another episode has everything again.
    client.call("load_new_episode", &["".into(), false.into(), 65535.into()]).expect("the same map");
    let (met, again) = crash(&mut client, &start, 12.0);
    assert!(met.is_some() && again < 9.0, "{again} m");
}

#[test]
fn layers_go_and_come() {
    const FOLIAGE: u16 = 4;
    const STREET_LIGHTS: u16 = 128;
    let mut client = Client::new(serve());
    client.synchronous();
    let ids = |things: &[EnvironmentObject]| things.iter().map(|thing| thing.id).collect::<BTreeSet<u64>>();
    let all = things(&mut client, ANY);
    let tree = things(&mut client, VEGETATION).into_iter().max_by(|a, b| {
        let size = |thing: &EnvironmentObject| thing.bounding_box.extent.z;
        size(a).total_cmp(&size(b))
    });
    let tree = tree.expect("a tree");
    let mut streams = cameras(&mut client, &tree);
    let before = seen(&mut client, &mut streams);
    let lamps: Vec<LightState> = client.get("query_lights_state", &["".into()]);
    assert!(!lamps.is_empty());
    client.call("unload_map_layer", &[(FOLIAGE | STREET_LIGHTS).into()]).expect("unloaded");
    let left = things(&mut client, ANY);
    assert!(!ids(&left).contains(&tree.id) && ids(&left).is_subset(&ids(&all)) && left.len() * 2 > all.len() / 2);
    assert_eq!(client.get::<Vec<LightState>>("query_lights_state", &["".into()]), vec![]);
    let bare = seen(&mut client, &mut streams);
    let [with, without] = [&before, &bare].map(|seen| pixels(&seen[0], VEGETATION));
    assert!(without * 2 < with, "{with} and {without} pixels");
    assert!(!met_from_above(&mut client, &tree).contains(&VEGETATION));

    client.call("load_map_layer", &[65535.into()]).expect("loaded");
    assert_eq!(seen(&mut client, &mut streams)[..2], before[..2]);
    assert_eq!(ids(&things(&mut client, ANY)), ids(&all));
    assert_eq!(client.get::<Vec<LightState>>("query_lights_state", &["".into()]), lamps);
    // A map can also be loaded without some.
    let without = !FOLIAGE;
    client.call("load_new_episode", &["".into(), false.into(), without.into()]).expect("the same map");
    assert!(!ids(&things(&mut client, ANY)).contains(&tree.id));
    assert!(!met_from_above(&mut client, &tree).contains(&VEGETATION));
}
