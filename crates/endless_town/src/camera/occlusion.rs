//! Occlusion by street furniture that stands before the cameras are placed: its height, and the share of a picture that it
//! hides.

use super::raster::cells_in;
use super::surroundings::TallProp;
use crate::placement::{PlacedObject, Placement};
use endless_asset::{Catalogue, Prop};
use endless_scene::Mesh;
use endless_world::{CameraSite, ImageSize, PinholeCamera};
use glam::{Affine3A, Vec3};
use std::collections::BTreeMap;

/// Pictures are looked at in this size.
const SIZE: ImageSize = ImageSize { width: 96, height: 54 };
/// What is nearer to the lens than this hides what is behind, metres.
const NEAR_M: f32 = 9.0;
/// Things this tall are posts, metres.
const TALL_M: f32 = 2.4;

/// Things with their meshes.
pub(crate) struct PropOcclusion {
    places: Vec<((Prop, u32), Affine3A)>,
    meshes: BTreeMap<(Prop, u32), Mesh>,
}

impl PropOcclusion {
    /// Of all placements but trees, which are part of the relief.
    pub(crate) fn new(catalogue: &Catalogue, placements: &[Placement]) -> Self {
        let is_tree =
            |p: Prop| matches!(p, Prop::BroadleafTree | Prop::BareTree | Prop::Conifer | Prop::Palm | Prop::Cypress);
        let mut things = Self { places: Vec::new(), meshes: BTreeMap::new() };
        for placement in placements {
            let PlacedObject::Prop(prop, variant) = placement.object else { continue };
            if !is_tree(prop) {
                things.meshes.entry((prop, variant)).or_insert_with(|| catalogue.prop(prop, variant));
                things.places.push(((prop, variant), placement.world_from_object));
            }
        }
        things
    }

    /// Those that are tall.
    pub(crate) fn posts(&self) -> Vec<TallProp> {
        let post = |(what, place): &((Prop, u32), Affine3A)| {
            let height = self.meshes[what].bounds().1.z * place.matrix3.z_axis.z;
            TallProp { foot: Vec3::from(place.translation), height }
        };
        self.places.iter().map(post).filter(|p| p.height > TALL_M).collect()
    }

    /// The share of a site's picture that things near the lens take.
    pub(crate) fn hide(&self, site: &CameraSite) -> f32 {
        let camera = PinholeCamera::new(site, SIZE);
        let mut hidden = vec![false; SIZE.pixels()];
        for (what, place) in &self.places {
            let mesh = &self.meshes[what];
            let (low, high) = mesh.bounds();
            let reach = low.truncate().abs().max(high.truncate().abs()).length();
            if Vec3::from(place.translation).truncate().distance(camera.position.truncate()) > NEAR_M + reach {
                continue;
            }
            for triangle in &mesh.triangles {
                cover(&camera, triangle.map(|i| place.transform_point3(mesh.positions[i as usize])), &mut hidden);
            }
        }
        hidden.iter().filter(|h| **h).count() as f32 / SIZE.pixels() as f32
    }
}

/// Marks the pixels of a triangle, if it lies near and before the lens.
fn cover(camera: &PinholeCamera, corners: [Vec3; 3], hidden: &mut [bool]) {
    if corners.iter().any(|p| p.distance(camera.position) > NEAR_M) {
        return;
    }
    let seen = corners.map(|p| camera.project(p).map(|(image, _)| image));
    let [Some(a), Some(b), Some(c)] = seen else { return };
    let (width, height) = (SIZE.width as usize, SIZE.height as usize);
    cells_in([a, b, c], width, 0..height, |x, y, _| hidden[y * width + x] = true);
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{LensModel, Mount};

    #[test]
    fn a_post_at_the_lens_hides_much() {
        let catalogue = Catalogue::builtin();
        let at = |x: f32| Placement {
            object: PlacedObject::Prop(Prop::StreetLamp, 0),
            world_from_object: Affine3A::from_translation(Vec3::new(x, 0.3, 0.0)),
            signal: None,
        };
        let site = CameraSite {
            name: "x".to_owned(),
            position: [0.0, 0.0, 5.0],
            yaw_rad: 0.0,
            down_tilt_rad: 0.3,
            horizontal_fov_rad: 1.2,
            lens: LensModel::Pinhole,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        let near = PropOcclusion::new(&catalogue, &[at(1.5)]);
        let far = PropOcclusion::new(&catalogue, &[at(30.0)]);
        assert!(near.hide(&site) > 0.03, "{}", near.hide(&site));
        assert!(far.hide(&site) == 0.0);
        assert_eq!(near.posts().len(), 1);
    }
}
