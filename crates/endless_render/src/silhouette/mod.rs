//! Objects by themselves: the pixels that one covers where nothing stands before it, and its extent in space.
//!
//! The pixel of an object's amodal mask is one whose centre's ray meets the object, as in the instance image: so where
//! nothing is in the way, both are the same to the pixel.

mod extent;
mod trace;

use crate::accel::Tlas;
use crate::scene::{FrameScene, Instance, StaticScene};
use endless_world::InstanceId;

/// The surfaces of one object at an instant, without all others.
#[derive(Debug)]
pub struct ObjectShape {
    instances: Vec<Instance>,
    accel: Tlas,
}

impl ObjectShape {
    fn of(id: InstanceId, all: &[Instance]) -> Option<Self> {
        let instances: Vec<Instance> = all.iter().filter(|instance| instance.id == id).cloned().collect();
        let accel = Tlas::build(instances.iter().map(Instance::placed).collect());
        (!instances.is_empty()).then_some(Self { instances, accel })
    }
}

impl FrameScene {
    /// One of the objects that move; `None` if none of them has this id.
    pub fn object_shape(&self, id: InstanceId) -> Option<ObjectShape> {
        ObjectShape::of(id, &self.instances)
    }
}

impl StaticScene {
    /// One of the objects that stand still; `None` if none of them has this id.
    pub fn object_shape(&self, id: InstanceId) -> Option<ObjectShape> {
        ObjectShape::of(id, &self.instances)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Geometry, StaticScene};
    use crate::{CameraBake, FrameDescription, RenderSettings};
    use endless_scene::{Material, MeshBuilder, Surface};
    use endless_world::{
        CameraSite, ClassTag, Distortion, ImageSize, InstancePixel, LensModel, Mount, PinholeCamera, TimeOfDay, Weather,
    };
    use glam::{Affine3A, Vec3};

    const BALL: InstanceId = InstanceId(1);
    const WALL: InstanceId = InstanceId(2);
    const SIZE: ImageSize = ImageSize { width: 150, height: 83 };

    fn block(low: [f32; 3], high: [f32; 3], tag: ClassTag) -> Geometry {
        let mut builder = MeshBuilder::new();
        builder.cuboid(low.into(), high.into(), Material::new(Surface::Painted, [0.4; 3], tag));
        Geometry::new(builder.finish())
    }

    /// Ground, a block that is turned, and a wall before half of it, if wanted.
    fn scene(walled: bool) -> StaticScene {
        let ground = block([-50.0, -50.0, -0.1], [50.0, 50.0, 0.0], ClassTag::Roads);
        let turned = Affine3A::from_rotation_z(0.6);
        let place = Affine3A::from_translation(Vec3::new(12.0, 0.5, 0.0)) * turned;
        let ball = Instance::new(&block([-1.5, -1.0, 0.0], [1.5, 1.0, 1.6], ClassTag::Car), place);
        let wall = Instance::new(&block([9.0, 0.5, 0.0], [9.2, 6.0, 3.0], ClassTag::Walls), Affine3A::IDENTITY);
        let mut instances = vec![Instance::new(&ground, Affine3A::IDENTITY), ball.with_id(BALL, ClassTag::Car)];
        instances.extend(walled.then(|| wall.with_id(WALL, ClassTag::Dynamic)));
        StaticScene::new(instances, &[])
    }

    fn site() -> CameraSite {
        CameraSite {
            name: "pole".to_owned(),
            position: [0.0, 0.0, 6.0],
            yaw_rad: 0.05,
            down_tilt_rad: 0.45,
            horizontal_fov_rad: 1.0,
            lens: LensModel::Pinhole,
            mount: Mount::Pole,
            roll_rad: 0.0,
        }
    }

    fn pixels_of(still: &StaticScene, id: InstanceId) -> Vec<u32> {
        let settings = RenderSettings::new(Weather::Cloudy, TimeOfDay::Afternoon, 0, SIZE);
        let bake = CameraBake::bake(still, &settings, &site());
        let frame = bake.render(still, &FrameScene::new(FrameDescription::default()));
        let own = |(_, pixel): &(u32, &InstancePixel)| pixel.id == id;
        (0..).zip(&frame.instance.data).filter(own).map(|(i, _)| i).collect()
    }

    fn covered(still: &StaticScene, camera: &PinholeCamera, asked: impl Fn(usize) -> bool) -> Vec<u32> {
        let mut pixels = still.object_shape(BALL).expect("there").covers(camera, asked);
        pixels.sort_unstable();
        pixels
    }

    #[test]
    fn what_nothing_hides_covers_the_pixels_that_show_it() {
        let (free, walled) = (scene(false), scene(true));
        let camera = PinholeCamera::new(&site(), SIZE);
        let shown = pixels_of(&free, BALL);
        assert!(shown.len() > 300, "{} pixels", shown.len());
        assert_eq!(covered(&free, &camera, |_| true), shown);
        // Behind a wall it covers as many.
        let visible = pixels_of(&walled, BALL);
        assert!(visible.len() < shown.len());
        assert_eq!(covered(&walled, &camera, |_| true), shown);
        let hidden: Vec<u32> = shown.iter().copied().filter(|pixel| !visible.contains(pixel)).collect();
        assert_eq!(covered(&walled, &camera, |pixel| !visible.contains(&(pixel as u32))), hidden);
    }

    #[test]
    fn only_pixels_in_its_rectangle_are_looked_at_also_through_a_lens() {
        let still = scene(false);
        let shape = still.object_shape(BALL).expect("there");
        for k1 in [0.0, -0.12, -0.22] {
            let camera = PinholeCamera::new(&site(), SIZE).with_distortion(Distortion::barrel(k1));
            let [left, top, right, bottom] = shape.image_bounds(&camera).expect("ahead");
            let pixels = covered(&still, &camera, |_| true);
            for pixel in &pixels {
                let (x, y) = ((pixel % SIZE.width) as f32 + 0.5, (pixel / SIZE.width) as f32 + 0.5);
                assert!(x > left - 0.1 && x < right + 0.1 && y > top - 0.1 && y < bottom + 0.1, "{x} {y}");
            }
            // One ray at a time, everywhere.
            let all = (0..SIZE.pixels() as u32).filter(|&pixel| {
                let ray = crate::camera_rays::sample_ray(&camera, pixel % SIZE.width, pixel / SIZE.width, 0);
                shape.accel.closest(&ray).is_some()
            });
            assert_eq!(pixels, all.collect::<Vec<_>>());
        }
        assert!(still.object_shape(InstanceId(9)).is_none());
    }

    #[test]
    fn its_box_is_tight_in_its_own_frame() {
        let still = scene(false);
        let shape = still.object_shape(BALL).expect("there");
        let place = Affine3A::from_translation(Vec3::new(12.0, 0.5, 0.0)) * Affine3A::from_rotation_z(0.6);
        assert_eq!(shape.bounds_in(&place), (Vec3::new(-1.5, -1.0, 0.0), Vec3::new(1.5, 1.0, 1.6)));
        let (low, high) = shape.bounds_in(&Affine3A::from_translation(Vec3::new(12.0, 0.5, 0.0)));
        assert!(low.x < -1.7 && high.x > 1.7 && (high.z - 1.6).abs() < 1e-5, "{low} {high}");
    }
}
