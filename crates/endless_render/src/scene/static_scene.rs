//! The static scene, the same in every frame.

use super::Instance;
use crate::accel::{Hit, Ray, Tlas};
use crate::light::Lamps;
use endless_scene::StreetLamp;
use glam::Vec3A;
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::sync::Arc;

/// Everything that stands still, ready to be traced: made once a map, and shared by all its videos.
#[derive(Debug, Clone)]
pub struct StaticScene {
    pub(crate) instances: Vec<Instance>,
    pub(crate) accel: Tlas,
    pub(crate) lamps: Lamps,
}

impl StaticScene {
    /// A scene of instances, and of the lamps that are lit at night. Instances without triangles are left out.
    pub fn new(instances: Vec<Instance>, lamps: &[StreetLamp]) -> Self {
        Self::of(instances, Lamps::new(lamps))
    }

    pub(super) fn of(mut instances: Vec<Instance>, lamps: Lamps) -> Self {
        instances.retain(|instance| !instance.geometry.is_empty());
        let accel = Tlas::build(instances.iter().map(Instance::placed).collect());
        Self { instances, accel, lamps }
    }

    /// What it is made of.
    pub fn instances(&self) -> &[Instance] {
        &self.instances
    }

    /// These instances alone in the light of the same lamps.
    #[must_use]
    pub fn made_of(&self, instances: Vec<Instance>) -> Self {
        Self::of(instances, self.lamps.clone())
    }

    /// The same scene in which each lamp, by its place in the list, has its light changed by factors by linear channel, and its
    /// lens with it.
    #[must_use]
    pub fn with_lamp_factors(&self, factors: impl Fn(usize) -> [f32; 3]) -> Self {
        let mut changed = self.clone();
        for instance in &mut changed.instances {
            if let Some(lamp) = instance.lens().and_then(|lens| self.lamps.at(lens)) {
                instance.tint = factors(lamp).into();
            }
        }
        Self { lamps: self.lamps.scaled(|place, _| Vec3A::from(factors(place))), ..changed }
    }

    /// Where a ray meets one triangle; `None` if it passes by, or there is no such triangle.
    pub(crate) fn hit_on(&self, ray: &Ray, instance: u32, triangle: u32) -> Option<Hit> {
        let geometry = &self.instances.get(instance as usize)?.geometry;
        let positions = geometry.posed.positions();
        let corners = geometry.mesh.triangles.get(triangle as usize)?.map(|i| positions[i as usize]);
        self.accel.hit_on(ray, instance, triangle, corners)
    }

    /// Writes all that rays can meet, so that scenes can be told apart by a digest of it: each mesh once, and where it
    /// stands, as little-endian numbers.
    ///
    /// # Errors
    /// Those of `sink`.
    pub fn write_geometry(&self, sink: &mut impl Write) -> io::Result<()> {
        let mut known = BTreeMap::new();
        for instance in &self.instances {
            let mesh = &instance.geometry.mesh;
            let next = known.len() as u32;
            let number = *known.entry(Arc::as_ptr(mesh)).or_insert(next);
            sink.write_all(&number.to_le_bytes())?;
            if number == next {
                let counts = [mesh.positions.len(), mesh.triangles.len()].map(|count| (count as u64).to_le_bytes());
                let positions = instance.geometry.posed.positions().iter().flat_map(glam::Vec3::to_array);
                let mut bytes = counts.concat();
                bytes.extend(positions.flat_map(f32::to_le_bytes));
                bytes.extend(mesh.triangles.as_flattened().iter().flat_map(|corner| corner.to_le_bytes()));
                sink.write_all(&bytes)?;
            }
            let place = instance.world_from_object.to_cols_array();
            sink.write_all(place.map(f32::to_le_bytes).as_flattened())?;
        }
        Ok(())
    }

    /// Number of triangles as placed, for reports.
    pub fn placed_triangles(&self) -> usize {
        self.instances.iter().map(|i| i.geometry.mesh.triangles.len()).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Geometry;
    use endless_scene::{Material, MeshBuilder, Surface};
    use endless_world::ClassTag;
    use glam::{Affine3A, Vec3};

    const POLE: Material = Material::new(Surface::Painted, [0.5; 3], ClassTag::Poles);
    const LENS: Material = Material::new(Surface::LampLens, [0.8; 3], ClassTag::TrafficSigns);

    /// A lamp whose lens is eight metres above its foot.
    fn lamp() -> Geometry {
        let mut builder = MeshBuilder::new();
        builder.cuboid(Vec3::new(-0.1, -0.1, 0.0), Vec3::new(0.1, 0.1, 7.8), POLE);
        builder.cuboid(Vec3::new(-0.2, -0.2, 7.9), Vec3::new(0.2, 0.2, 8.1), LENS);
        Geometry::new(builder.finish())
    }

    #[test]
    fn lenses_shine_as_their_lamps_do() {
        let at = |x: f32| Vec3::new(x, 5.0, 0.0);
        let place = |x: f32| Instance::new(&lamp(), Affine3A::from_translation(at(x)));
        let light = |x: f32| StreetLamp { position: at(x) + 8.0 * Vec3::Z, color: [1.0; 3], intensity_cd: 1000.0 };
        // In another order than their lights; the last has none.
        let instances = vec![place(30.0), place(0.0), place(60.0)];
        let scene = StaticScene::new(instances, &[light(0.0), light(30.0)]);
        let switched = scene.with_lamp_factors(|lamp| if lamp == 0 { [0.0; 3] } else { [2.0, 1.0, 0.5] });
        let tints = |scene: &StaticScene| scene.instances().iter().map(|instance| instance.tint).collect::<Vec<_>>();
        assert_eq!(tints(&switched), [Vec3A::new(2.0, 1.0, 0.5), Vec3A::ZERO, Vec3A::ONE]);
        assert_eq!(tints(&scene), [Vec3A::ONE; 3]);
    }

    #[test]
    fn meshes_lose_the_triangles_of_a_material_and_keep_the_others() {
        let whole = lamp();
        let pole = whole.without(|material| material.surface == Surface::LampLens);
        assert_eq!(pole.mesh().triangles.len(), 12);
        assert_eq!(pole.mesh().positions, whole.mesh().positions);
        assert!(pole.lens_middle().is_none() && whole.lens_middle().is_some());
        assert!(whole.without(|_| true).is_empty());
    }
}
