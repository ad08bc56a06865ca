//! A built-in town, as one of its cameras sees it.

use std::collections::BTreeMap;
use std::sync::Arc;

use endless_asset::Catalogue;
use endless_render::{Accel, Blas};
use endless_town::What;
use glam::Vec3A;

use crate::town::{Mesh, Town, placed};

impl Town {
    /// Buildings, ground, plants and furniture of a town; its first camera looks.
    ///
    /// # Panics
    /// If there is no such town.
    pub(crate) fn builtin(name: &str) -> Self {
        let catalogue = Catalogue::builtin();
        let town = endless_town::load(name, &catalogue).expect("a town's name");
        let plain =
            |mesh: &endless_asset::Mesh| Mesh { positions: mesh.positions.clone(), triangles: mesh.triangles.clone() };
        let mut meshes: Vec<Mesh> = town.meshes.iter().map(|mesh| plain(mesh)).collect();
        let mut props = BTreeMap::new();
        let mut instances = Vec::new();
        for placement in &town.placements {
            let mesh = match placement.what {
                What::Own(i) => i as usize,
                What::Prop(prop, variant) => *props.entry(placement.what).or_insert_with(|| {
                    meshes.push(plain(&catalogue.prop(prop, variant)));
                    meshes.len() - 1
                }),
            };
            if !meshes[mesh].triangles.is_empty() {
                instances.push((mesh, placement.world_from_object));
            }
        }
        let blas: Vec<_> = meshes.iter().map(|m| Arc::new(Blas::build(&m.positions, &m.triangles))).collect();
        let accel = Accel::build(placed(&blas, &instances));
        let site = &town.cameras[0];
        let camera = endless_world::PinholeCamera::new(site, endless_world::ImageSize { width: 1280, height: 720 });
        let eye = Vec3A::from_array(site.position);
        Town { meshes, instances, accel, blas, eye, forward: Vec3A::from(camera.world_from_camera.z_axis) }
    }
}
