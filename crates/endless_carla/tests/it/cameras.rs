//! Pictures.

use crate::client::{Client, serve};
use endless_carla::wire::{Actor, Location, MapInfo, Rotation, Transform};
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
