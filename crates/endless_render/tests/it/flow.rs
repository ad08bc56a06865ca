//! Optical flow of a block that moves on a floor before and behind blocks that stand.

use endless_render::{
    CameraBake, Footprint, FrameDescription, FrameScene, Geometry, Instance, MovingObject, NeighbourFrames,
    RenderSettings, StaticScene,
};
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::math::UnfusedMatrix;
use endless_world::{
    CameraLook, CameraSite, ClassTag, Distortion, FlowPixel, FlowTarget, Image, ImageSize, InstanceId, LensModel,
    Mount, PinholeCamera, SensorFrame, SensorLayers, TimeOfDay, Weather,
};
use glam::{Affine3A, Vec2, Vec3};

const SIZE: ImageSize = ImageSize { width: 241, height: 135 };
const MOVING: InstanceId = InstanceId(7);

fn cuboid(low: Vec3, high: Vec3, tag: ClassTag) -> Geometry {
    let mut builder = MeshBuilder::new();
    builder.cuboid(low, high, Material::new(Surface::Painted, [0.4, 0.3, 0.2], tag));
    Geometry::new(builder.finish())
}

/// A floor, and a post that hides part of what moves.
fn still() -> StaticScene {
    let floor = cuboid(Vec3::new(-60.0, -60.0, -0.1), Vec3::new(60.0, 60.0, 0.0), ClassTag::Roads);
    let post = cuboid(Vec3::new(7.0, -0.4, 0.0), Vec3::new(7.3, 0.4, 4.0), ClassTag::Poles);
    let placed = |geometry| Instance::new(geometry, Affine3A::IDENTITY);
    StaticScene::new(vec![placed(&floor), placed(&post)], &[])
}

/// The block, turning as it goes to the left (y), at three instants.
fn places() -> [Affine3A; 3] {
    [(-0.4, 0.2), (0.1, 0.35), (0.8, 0.5)]
        .map(|(y, yaw)| Affine3A::from_translation(Vec3::new(11.0, y, 0.0)) * Affine3A::from_rotation_z(yaw))
}

fn frame(block: &Geometry, world_from_object: Affine3A) -> FrameScene {
    let instances = vec![Instance::new(block, world_from_object).with_id(MOVING, ClassTag::Dynamic)];
    let footprint = Footprint { world_from_object, ahead_m: 0.0, half_m: Vec2::ONE, height_m: 2.0 };
    FrameScene::new(FrameDescription {
        objects: vec![MovingObject { instances, footprint }],
        ..FrameDescription::default()
    })
}

fn settings(k1: f32) -> RenderSettings {
    RenderSettings {
        layers: SensorLayers { flow: true, flow_backward: true, ..SensorLayers::default() },
        look: CameraLook { distortion: Distortion::barrel(k1), ..CameraLook::CLEAN },
        ..RenderSettings::new(Weather::Cloudy, TimeOfDay::Afternoon, 3, SIZE)
    }
}

fn site() -> CameraSite {
    CameraSite {
        name: "pole".to_owned(),
        position: [0.0, 0.0, 5.0],
        yaw_rad: 0.05,
        down_tilt_rad: 0.3,
        roll_rad: 0.0,
        horizontal_fov_rad: 1.0,
        lens: LensModel::Pinhole,
        mount: Mount::Pole,
    }
}

fn centre(pixel: usize) -> Vec2 {
    let (x, y) = (pixel as u32 % SIZE.width, pixel as u32 / SIZE.width);
    Vec2::new(x as f32 + 0.5, y as f32 + 0.5)
}

/// The point in the world that a pixel shows.
fn point(camera: &PinholeCamera, frame: &SensorFrame, pixel: usize) -> Vec3 {
    let at = centre(pixel);
    let ray = camera.ray(at.x, at.y).expect("it is shown");
    ray.origin + ray.direction * (frame.depth.data[pixel] / camera.depth_along(ray.direction, 1.0))
}

fn check(camera: &PinholeCamera, now: &SensorFrame, then: &SensorFrame, flow: &Image<[u16; 3]>, moved: Affine3A) {
    let (mut visible, mut astray, mut hidden, mut uncovered) = (0, 0, 0, 0);
    for (pixel, &code) in flow.data.iter().enumerate() {
        if !camera.shows(centre(pixel).x, centre(pixel).y) {
            assert_eq!(code, FlowPixel::UNKNOWN, "beyond the image circle, pixel {pixel}");
            continue;
        }
        let FlowPixel { flow_px, target } = FlowPixel::decoded(code).expect("legal").expect("known");
        if now.instance.data[pixel].id != MOVING {
            // What stands is hidden where the other picture shows what moves at the same pixel, and nowhere else.
            let covered = then.instance.data[pixel].id == MOVING;
            assert_eq!((flow_px, target == FlowTarget::Hidden), (Vec2::ZERO, covered), "pixel {pixel}");
            uncovered += usize::from(covered);
            continue;
        }
        let there = moved.transform_point3(point(camera, now, pixel));
        let (place, depth) = camera.project(there).expect("ahead");
        assert!((centre(pixel) + flow_px).distance(place) < 0.02, "pixel {pixel}: {flow_px}");
        let beside = place.x < 0.0 || place.y < 0.0 || place.x > SIZE.width as f32 || place.y > SIZE.height as f32;
        assert_eq!(target == FlowTarget::Outside, beside, "pixel {pixel}");
        if beside {
            continue;
        }
        // The point is seen between the centres of four pixels: at the block's corners all four may pass by it.
        let shown = |x: f32, y: f32| {
            let corner = (place - 0.5).floor() + Vec2::new(x, y);
            let corner = corner.clamp(Vec2::ZERO, Vec2::new(SIZE.width as f32, SIZE.height as f32) - 1.0);
            let at = corner.y as usize * SIZE.width as usize + corner.x as usize;
            (then.instance.data[at].id == MOVING, then.depth.data[at])
        };
        let four = [shown(0.0, 0.0), shown(1.0, 0.0), shown(0.0, 1.0), shown(1.0, 1.0)];
        if target == FlowTarget::Visible {
            visible += 1;
            astray += usize::from(!four.iter().any(|(own, d)| *own && (d - depth).abs() < 0.4));
        } else {
            hidden += 1;
            assert!(four.iter().any(|(_, d)| *d < depth - 0.01), "pixel {pixel} leads to {place}, {depth} m: {four:?}");
        }
    }
    assert!(astray * 200 < visible, "{astray} of {visible}");
    assert!(visible > 400 && hidden > 30 && uncovered > 30, "{visible} visible, {hidden} hidden, {uncovered}");
}

#[test]
fn a_block_flows_as_it_moves_and_turns() {
    let (still, block) = (still(), cuboid(Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, 1.0, 2.0), ClassTag::Dynamic));
    let [past, present, future] = places().map(|place| frame(&block, place));
    let behind = |lens| CameraSite { lens, ..site() };
    for (k1, site) in [
        (0.0, site()),
        (-0.15, site()),
        (0.0, behind(LensModel::Fisheye { k: [0.02, -0.004, 0.0, 0.0] })),
        (0.0, behind(LensModel::Equirectangular)),
        (0.0, behind(LensModel::Orthographic { width_m: 12.0 })),
    ] {
        let bake = CameraBake::bake(&still, &settings(k1), &site);
        let beside = NeighbourFrames { before: Some((&past).into()), after: Some((&future).into()) };
        let now = bake.render_between(&still, &present, beside);
        let moved = |to: Affine3A| to * places()[1].inverse_unfused();
        for (flow, then, moved) in
            [(&now.flow, &future, moved(places()[2])), (&now.flow_backward, &past, moved(places()[0]))]
        {
            let flow = flow.as_ref().expect("wanted");
            check(bake.camera(), &now, &bake.render(&still, then), flow, moved);
        }
    }
}

#[test]
fn what_leaves_the_picture_flows_out_of_it() {
    let (still, block) = (still(), cuboid(Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, 1.0, 2.0), ClassTag::Dynamic));
    let at = |y: f32| Affine3A::from_translation(Vec3::new(11.0, y, 0.0));
    let bake = CameraBake::bake(&still, &settings(0.0), &site());
    let [present, future] = [5.0, 6.0].map(|y| frame(&block, at(y)));
    let beside = NeighbourFrames { before: None, after: Some((&future).into()) };
    let now = bake.render_between(&still, &present, beside);
    let backward = now.flow_backward.as_ref().expect("wanted");
    assert!(backward.data.iter().all(|pixel| *pixel == FlowPixel::UNKNOWN));
    let forward = now.flow.as_ref().expect("wanted");
    let outside = forward.data.iter().filter(|pixel| pixel[2] == 3).count();
    assert!(outside > 100, "{outside} pixels");
    let own = |i: &usize| forward.data[*i][2] == 3;
    assert!((0..SIZE.pixels()).filter(own).all(|i| now.instance.data[i].id == MOVING));
    // Another mesh under the same number is another thing.
    let other = cuboid(Vec3::NEG_ONE, Vec3::ONE, ClassTag::Dynamic);
    let other = frame(&other, at(6.0));
    let beside = NeighbourFrames { before: None, after: Some((&other).into()) };
    let forward = bake.render_between(&still, &present, beside).flow.expect("wanted");
    for (pixel, label) in forward.data.iter().zip(&now.instance.data) {
        assert_eq!(*pixel == FlowPixel::UNKNOWN, label.id == MOVING);
    }
}

#[test]
fn what_moves_and_does_not_is_as_visible_as_it_was() {
    let (still, block) = (still(), cuboid(Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, 1.0, 2.0), ClassTag::Dynamic));
    for k1 in [0.0, -0.15] {
        let bake = CameraBake::bake(&still, &settings(k1), &site());
        let [present, future] = [places()[1]; 2].map(|place| frame(&block, place));
        let beside = NeighbourFrames { before: Some((&future).into()), after: Some((&future).into()) };
        let now = bake.render_between(&still, &present, beside);
        for flow in [now.flow, now.flow_backward] {
            assert!(flow.expect("wanted").data.iter().all(|pixel| *pixel == FlowPixel::STILL.encoded()));
        }
    }
}
