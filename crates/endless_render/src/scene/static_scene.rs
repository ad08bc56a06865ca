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

    /// The same scene in which each lamp, by its place in the list, has its light changed by factors by linear channel.
    #[must_use]
    pub fn with_lamp_factors(&self, factors: impl Fn(usize) -> [f32; 3]) -> Self {
        Self { lamps: self.lamps.scaled(|place, _| Vec3A::from(factors(place))), ..self.clone() }
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
