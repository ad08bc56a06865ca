//! Pictures.

use crate::client::{Client, serve};
use endless_carla::wire::{Actor, LightState, Location, MapInfo, Rotation, Transform, WeatherParameters, Wire};
use endless_world::math::sin_cos;

/// A camera behind and above a car sees it, under its own number, in all kinds of pictures of one frame.
#[test]
fn pictures_of_one_frame_agree() {
    let mut client = Client::new(serve());
    client.synchronous();
    let map: MapInfo = client.get("get_map_info", &[]);
    let place = &map.recommended_spawn_points[0];
    let description = client.description("vehicle.tesla.model3", &[]);
    let car = client.spawn(&description, place);
    let (sin_yaw, cos_yaw) = sin_cos(place.rotation.yaw.to_radians());
    let Location { x, y, z } = place.location;
    let view = Transform {
        location: Location { x: x - 9.0 * cos_yaw, y: y - 9.0 * sin_yaw, z: z + 4.0 },
        rotation: Rotation { pitch: -20.0, yaw: place.rotation.yaw, roll: 0.0 },
    };
    let kinds = ["rgb", "depth", "semantic_segmentation", "instance_segmentation"];
    let mut streams = Vec::new();
    for kind in kinds {
        let size = [("image_size_x", "96"), ("image_size_y", "54")];
        let camera = client.description(&format!("sensor.camera.{kind}"), &size);
        let actor: Actor = client.spawn(&camera, &view);
        streams.push(client.listen(&actor.stream_token));
    }
    for _ in 0..2 {
        let frame = client.tick();
        let images = streams.iter_mut().map(|stream| stream.of_frame(frame).payload).collect::<Vec<_>>();
        let pixels = |image: usize| images[image][12..].as_chunks::<4>().0;
        assert!(images.iter().all(|image| image.len() == 12 + 4 * 96 * 54));
        assert_eq!(images[0][..8], [96, 0, 0, 0, 54, 0, 0, 0]);
        let [depth, semantic, instance] = [1, 2, 3].map(pixels);
        let id = |pixel: &[u8; 4]| u32::from(pixel[1]) + 256 * u32::from(pixel[0]);
        let own: Vec<usize> = (0..instance.len()).filter(|&at| id(&instance[at]) == car.id).collect();
        assert!(own.len() > 60, "{} pixels of the car", own.len());
        for at in own {
            const CAR: u8 = 14;
            assert_eq!((instance[at][2], semantic[at][2]), (CAR, CAR));
            let [b, g, r, _] = depth[at].map(f64::from);
            let depth_m = (r + 256.0 * g + 65536.0 * b) / 16_777_215.0 * 1000.0;
            assert!((5.0..14.0).contains(&depth_m), "{depth_m} m");
        }
    }
}

/// Flow and events are where a car has been moved, and nowhere else.
#[test]
fn flow_and_events_tell_of_what_moves() {
    let mut client = Client::new(serve());
    client.synchronous();
    let map: MapInfo = client.get("get_map_info", &[]);
    let place = &map.recommended_spawn_points[0];
    let (sin_yaw, cos_yaw) = sin_cos(place.rotation.yaw.to_radians());
    let beside = |right_m: f32, ahead_m: f32, up_m: f32| {
        let Location { x, y, z } = place.location;
        Location {
            x: x + ahead_m * cos_yaw - right_m * sin_yaw,
            y: y + ahead_m * sin_yaw + right_m * cos_yaw,
            z: z + up_m,
        }
    };
    let at = |right_m: f32| Transform { location: beside(right_m, 0.0, -0.3), rotation: place.rotation.clone() };
    let car = client.description("vehicle.tesla.model3", &[]);
    let car = client.spawn(&car, &at(0.0));
    client.call("set_actor_simulate_physics", &[car.id.into(), false.into()]).expect("held");
    let level = Rotation { pitch: 0.0, yaw: place.rotation.yaw, roll: 0.0 };
    let view = Transform { location: beside(0.0, -10.0, 1.0), rotation: level };
    let mut streams = Vec::new();
    for kind in ["optical_flow", "dvs", "instance_segmentation"] {
        let size = [("image_size_x", "128"), ("image_size_y", "72")];
        let camera = client.description(&format!("sensor.camera.{kind}"), &size);
        let actor: Actor = client.spawn(&camera, &view);
        streams.push(client.listen(&actor.stream_token));
    }
    let mut seen = |client: &mut Client| {
        let frame = client.tick();
        let images = streams.iter_mut().map(|stream| stream.of_frame(frame).payload).collect::<Vec<_>>();
        let number = |bytes: &[u8]| f32::from_le_bytes(bytes.try_into().expect("four bytes"));
        let flow: Vec<[f32; 2]> = images[0][12..].chunks(8).map(|xy| [number(&xy[..4]), number(&xy[4..])]).collect();
        assert!(images.iter().all(|image| image[..8] == [128, 0, 0, 0, 72, 0, 0, 0]));
        let events: Vec<Vec<u8>> = images[1][12..].chunks(13).map(<[u8]>::to_vec).collect();
        let own = |pixel: &[u8; 4]| u32::from(pixel[1]) + 256 * u32::from(pixel[0]) == car.id;
        (flow, events, images[2][12..].as_chunks::<4>().0.iter().map(own).collect::<Vec<_>>())
    };
    let (flow, events, own) = seen(&mut client);
    assert!(events.is_empty() && flow.iter().all(|pixel| *pixel == [0.0; 2]));
    assert!(own.iter().filter(|own| **own).count() > 60);
    client.call("set_actor_transform", &[car.id.into(), at(0.5).to_value()]).expect("moved");
    let (flow, events, own) = seen(&mut client);
    for (flow, own) in flow.iter().zip(&own) {
        // Half a metre to the right, at 7 to 13 m, where 90 degrees are twice the distance wide.
        let expected = if *own { 0.5 / 13.0..0.5 / 7.0 } else { -1e-6..1e-6 };
        assert!(expected.contains(&flow[0]) && flow[1].abs() < 0.02, "{flow:?} {own}");
    }
    assert!(events.len() > 30, "{} events", events.len());
    let time_ns = |event: &[u8]| i64::from_le_bytes(event[4..12].try_into().expect("eight bytes"));
    assert!(events.iter().all(|event| event.len() == 13 && event[12] <= 1));
    let span = time_ns(&events[events.len() - 1]) - time_ns(&events[0]);
    assert!((0..=50_000_000).contains(&span), "{span} ns");
    let column = |event: &[u8]| u16::from_le_bytes([event[0], event[1]]);
    let near = events.iter().filter(|event| (30..110).contains(&column(event))).count();
    assert!(near > events.len() / 2, "{near} of {} events", events.len());
}

/// A lamp that clients switch off lights nothing, and one that they switch on again lights what it did.
#[test]
fn lamps_light_pictures_as_they_are_switched() {
    let mut client = Client::new(serve());
    client.synchronous();
    let night = WeatherParameters { sun_altitude_angle: -90.0, ..WeatherParameters::default() };
    client.call("set_weather_parameters", &[night.to_value()]).expect("night");
    let lamps: Vec<LightState> = client.get("query_lights_state", &["".into()]);
    let Location { x, y, z } = lamps[0].location;
    let rotation = Rotation { pitch: -89.0, yaw: 0.0, roll: 0.0 };
    let below = Transform { location: Location { x, y, z: z - 1.0 }, rotation };
    let camera = client.description("sensor.camera.rgb", &[("image_size_x", "64"), ("image_size_y", "36")]);
    let camera = client.spawn(&camera, &below);
    let mut stream = client.listen(&camera.stream_token);
    let mut lit = |client: &mut Client, active: bool| {
        let lamps: Vec<LightState> = lamps.iter().map(|lamp| LightState { active, ..lamp.clone() }).collect();
        client.call("update_lights_state", &["".into(), lamps.to_value(), false.into()]).expect("set");
        client.tick();
        let frame = client.tick();
        stream.of_frame(frame).payload[12..].to_vec()
    };
    let mean = |image: &[u8]| image.iter().map(|&value| f64::from(value)).sum::<f64>() / image.len() as f64;
    let differ =
        |a: &[u8], b: &[u8]| a.iter().zip(b).map(|(&a, &b)| f64::from(a.abs_diff(b))).sum::<f64>() / a.len() as f64;
    let [on, off, again] = [true, false, true].map(|active| lit(&mut client, active));
    assert!(differ(&on, &off) > 5.0, "{} {}", mean(&on), mean(&off));
    assert!(differ(&on, &again) < 3.0, "{}", differ(&on, &again));
}
