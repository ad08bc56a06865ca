//! What rays meet, for sensors other than cameras.

use crate::accel::{Hit, Ray, RayStream, lanes};
use crate::scene::{FrameScene, Instance, StaticScene};
use endless_scene::Surface;
use endless_world::math::UnfusedVec3A;
use endless_world::{ClassTag, InstanceId};
use glam::Vec3A;

/// The surface that a ray meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RayHit {
    /// From the ray's origin, in units of its direction: metres for a direction of unit length.
    pub distance: f32,
    /// Class.
    pub tag: ClassTag,
    /// Object.
    pub id: InstanceId,
    /// Unit normal of the triangle in the world, on the side that the ray came from.
    pub normal: Vec3A,
    /// Kind of its surface.
    pub surface: Surface,
    /// Linear colour, 0 to 1; of vehicles with their paint.
    pub base_color: Vec3A,
    /// Velocity of the point that was hit, world frame, m/s. People and animals move as rigid bodies.
    pub velocity_mps: Vec3A,
}

/// Casts rays into what stands still and what moves at an instant. It asks for surfaces, not for light.
///
/// A pure function of both: call it from any number of threads.
#[derive(Debug, Clone, Copy)]
pub struct RayCaster<'a> {
    still: &'a StaticScene,
    moving: &'a FrameScene,
    ignored: &'a [InstanceId],
}

impl<'a> RayCaster<'a> {
    /// Into a scene at an instant.
    pub fn new(still: &'a StaticScene, moving: &'a FrameScene) -> Self {
        Self { still, moving, ignored: &[] }
    }

    /// The same, looking through these objects: who carries a sensor does not stand in its way.
    #[must_use]
    pub fn ignoring(self, ignored: &'a [InstanceId]) -> Self {
        Self { ignored, ..self }
    }

    /// The nearest surface along a ray.
    pub fn closest(&self, ray: &Ray) -> Option<RayHit> {
        let still = self.still.accel.closest(ray);
        let shortened = Ray { tmax: still.map_or(ray.tmax, |hit| hit.t), ..*ray };
        let moving = self.moving.accel.closest(&shortened);
        self.surface(ray, still, moving)
    }

    /// [`Self::closest`] for those of a bundle's rays whose bit is set in `active`, several times as fast if they run side by
    /// side: hands each lane that meets something to `found`, in ascending order.
    pub fn closest32(&self, rays: &RayStream<4>, active: u32, mut found: impl FnMut(usize, RayHit)) {
        let still = self.still.accel.closest32(rays, active);
        let moving = self.moving.accel.closest32(&still.shortened(rays), active);
        for lane in lanes(active) {
            if let Some(hit) = self.surface(&rays.ray(lane), still.get(lane), moving.get(lane)) {
                found(lane, hit);
            }
        }
    }

    /// The nearer of two hits; what stands still wins a tie.
    fn surface(&self, ray: &Ray, still: Option<Hit>, moving: Option<Hit>) -> Option<RayHit> {
        let (hit, instances) = match (still, moving) {
            (Some(s), Some(m)) if m.t >= s.t => (s, &self.still.instances),
            (_, Some(m)) => (m, &self.moving.instances),
            (s, None) => (s?, &self.still.instances),
        };
        let instance = &instances[hit.instance as usize];
        if self.ignored.contains(&instance.id) && instance.id != InstanceId::STUFF {
            return self.beyond(ray, &hit);
        }
        Some(surface_of(instance, ray, &hit))
    }

    /// What lies behind a hit that does not count.
    fn beyond(&self, ray: &Ray, hit: &Hit) -> Option<RayHit> {
        // Two surfaces of a body may touch: whatever is nearer than this to the first is left out with it.
        const STEP: f32 = 1e-4;
        let start = hit.t * (1.0 + 1e-6) + STEP / ray.direction.length();
        let rest = Ray { origin: ray.origin + ray.direction * start, tmax: ray.tmax - start, ..*ray };
        let behind = if rest.tmax > 0.0 { self.closest(&rest) } else { None };
        behind.map(|behind| RayHit { distance: start + behind.distance, ..behind })
    }
}

fn surface_of(instance: &Instance, ray: &Ray, hit: &Hit) -> RayHit {
    let triangle = hit.triangle as usize;
    let mesh = &*instance.geometry.mesh;
    let positions = instance.geometry.posed.positions();
    let [a, b, c] = mesh.triangles[triangle].map(|corner| Vec3A::from(positions[corner as usize]));
    let normal = (instance.normal_matrix * (b - a).cross_unfused(c - a)).normalize_or(-ray.direction);
    let (_, material) = instance.material_of(hit.triangle);
    let paint = if material.surface == Surface::CarPaint { instance.tint } else { Vec3A::ONE };
    RayHit {
        distance: hit.t,
        tag: instance.class.unwrap_or(material.tag),
        id: instance.id,
        normal: if normal.dot(ray.direction) > 0.0 { -normal } else { normal },
        surface: material.surface,
        base_color: Vec3A::from(material.base_color) * paint,
        velocity_mps: instance.velocity.at(ray.origin + ray.direction * hit.t),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Footprint, FrameDescription, Geometry, MovingObject, RigidVelocity};
    use endless_scene::{Material, MeshBuilder};
    use endless_world::Stream;
    use glam::{Affine3A, Vec2, Vec3};

    fn cuboid(low: Vec3, high: Vec3, material: Material) -> Geometry {
        let mut builder = MeshBuilder::new();
        builder.cuboid(low, high, material);
        Geometry::new(builder.finish())
    }

    /// A street and two boxes in a row, the nearer one moving.
    fn scene() -> (StaticScene, FrameScene) {
        let asphalt = Material::new(Surface::Asphalt, [0.14; 3], ClassTag::Roads);
        let street = cuboid(Vec3::new(-50.0, -50.0, -0.1), Vec3::new(50.0, 50.0, 0.0), asphalt);
        let brick = Material::new(Surface::Brick, [0.4, 0.2, 0.1], ClassTag::Buildings);
        let wall = cuboid(Vec3::new(20.0, -5.0, 0.0), Vec3::new(21.0, 5.0, 5.0), brick);
        let paint = Material::new(Surface::CarPaint, [0.5; 3], ClassTag::Static);
        let body = cuboid(Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, 1.0, 2.0), paint);
        let place = Affine3A::from_translation(Vec3::new(10.0, 0.0, 0.0));
        let velocity = RigidVelocity {
            linear_mps: Vec3A::new(-3.0, 0.0, 0.0),
            angular_radps: Vec3A::Z,
            about: Vec3A::new(10.0, 0.0, 0.0),
        };
        let car = Instance::new(&body, place)
            .with_id(InstanceId(7), ClassTag::Car)
            .with_tint(Vec3::new(1.0, 0.5, 0.0))
            .with_velocity(velocity);
        let footprint = Footprint { world_from_object: place, ahead_m: 0.0, half_m: Vec2::ONE, height_m: 2.0 };
        let objects = vec![MovingObject { instances: vec![car], footprint }];
        let still = StaticScene::new(
            vec![Instance::new(&street, Affine3A::IDENTITY), Instance::new(&wall, Affine3A::IDENTITY)],
            &[],
        );
        (still, FrameScene::new(FrameDescription { objects, ..FrameDescription::default() }))
    }

    fn ahead(height: f32) -> Ray {
        Ray { origin: Vec3A::new(0.0, 0.25, height), direction: Vec3A::X, tmax: 100.0 }
    }

    #[test]
    fn a_hit_tells_all_of_its_surface() {
        let (still, moving) = scene();
        let caster = RayCaster::new(&still, &moving);
        let car = caster.closest(&ahead(1.0)).expect("the car");
        assert_eq!((car.tag, car.id, car.surface), (ClassTag::Car, InstanceId(7), Surface::CarPaint));
        assert!((car.distance - 9.0).abs() < 1e-5 && (car.normal + Vec3A::X).length() < 1e-6);
        assert!((car.base_color - Vec3A::new(0.5, 0.25, 0.0)).length() < 1e-6);
        // It also turns: its side goes ahead by the cross product.
        assert!((car.velocity_mps - Vec3A::new(-3.25, -1.0, 0.0)).length() < 1e-5);
        let wall = caster.closest(&ahead(3.0)).expect("the wall");
        assert_eq!((wall.tag, wall.id, wall.velocity_mps), (ClassTag::Buildings, InstanceId::STUFF, Vec3A::ZERO));
        assert_eq!(caster.closest(&ahead(9.0)), None);
    }

    #[test]
    fn ignored_objects_are_looked_through() {
        let (still, moving) = scene();
        let caster = RayCaster::new(&still, &moving).ignoring(&[InstanceId(7)]);
        let inside = Ray { origin: Vec3A::new(10.0, 0.0, 1.0), ..ahead(1.0) };
        for (ray, distance) in [(ahead(1.0), 20.0), (inside, 10.0)] {
            let wall = caster.closest(&ray).expect("the wall");
            assert_eq!(wall.tag, ClassTag::Buildings);
            assert!((wall.distance - distance).abs() < 1e-4, "{}", wall.distance);
        }
        // Stuff is never ignored.
        let nobody = RayCaster::new(&still, &moving).ignoring(&[InstanceId::STUFF]);
        assert_eq!(nobody.closest(&ahead(3.0)).expect("the wall").tag, ClassTag::Buildings);
    }

    #[test]
    fn bundles_meet_what_single_rays_meet() {
        let (still, moving) = scene();
        let ignored = [InstanceId(7)];
        let mut random = Stream::new(5, &[]);
        for caster in [RayCaster::new(&still, &moving), RayCaster::new(&still, &moving).ignoring(&ignored)] {
            let mut met = 0;
            for _ in 0..200 {
                let rays = std::array::from_fn(|_| {
                    std::array::from_fn(|_| {
                        let aside = Vec3A::new(1.0, random.range_f32(-0.4, 0.4), random.range_f32(-0.4, 0.4));
                        Ray { direction: aside.normalize_or(Vec3A::X), ..ahead(1.5) }
                    })
                });
                let active = random.next_u64() as u32;
                let mut found = [None; 32];
                caster.closest32(&RayStream::of(&rays), active, |lane, hit| found[lane] = Some(hit));
                for (lane, hit) in found.into_iter().enumerate() {
                    let asked = active >> lane & 1 == 1;
                    assert_eq!(hit, caster.closest(&rays[lane / 8][lane % 8]).filter(|_| asked));
                    met += usize::from(hit.is_some());
                }
            }
            assert!(met > 1000);
        }
    }
}
