//! Labels of objects against one another and against the camera: boxes in one another, shares, counts, places in space.

use endless_annotate::{AmodalBox, AmodalRecord, Box3dRecord, ObjectRecord, Occluder, PixelBox, Spatial, mask_pixels};
use endless_world::{DepthMeasure, Image, ImageSize, InstancePixel, PinholeCamera};
use glam::{DQuat, DVec3, Vec2};

/// Places in the picture are written to hundredths of a pixel; sizes and rotations that lead there are rounded, too.
const PIXELS: f64 = 0.25;
/// Lengths are written in millimetres.
const METRES: f64 = 2e-3;
/// Further beside the picture than so many of its widths a corner is not compared: there the polynomial of a lens magnifies the
/// last digit of a place to any distance.
const WIDTHS_BESIDE: f64 = 10.0;

/// A frame as its labels are judged by.
pub(super) struct LabelledFrame<'a> {
    pub(super) camera: &'a PinholeCamera,
    pub(super) instance: Option<&'a Image<InstancePixel>>,
    /// As the lens measures it, metres.
    pub(super) depth: Option<&'a Image<f32>>,
}

impl LabelledFrame<'_> {
    /// What is wrong with the boxes of an object, if anything.
    pub(super) fn problem(&self, object: &ObjectRecord) -> Option<String> {
        let amodal = object.amodal.as_ref().and_then(|amodal| self.amodal_problem(object, amodal));
        let spatial = || object.spatial.as_ref().and_then(|spatial| self.spatial_problem(object, spatial));
        amodal.or_else(spatial).map(str::to_owned)
    }

    fn amodal_problem(&self, object: &ObjectRecord, amodal: &AmodalRecord) -> Option<&'static str> {
        let hidden = amodal.occluders.iter().try_fold(0u32, |sum, occluder| sum.checked_add(occluder.pixels));
        let clipped = AmodalBox::from(amodal.amodal_bbox_clipped);
        if !holds(clipped, object.bbox.into()) || !holds(amodal.amodal_bbox, clipped) {
            return Some("has an amodal box that its visible box leaves");
        }
        if !holds(whole(self.camera.size), clipped) {
            return Some("has a clipped amodal box that leaves the picture");
        }
        if hidden.and_then(|hidden| hidden.checked_add(object.pixels)) != Some(amodal.amodal_pixels) {
            return Some("has visible and hidden pixels that are not its amodal pixels");
        }
        let off = |written: f64, exact: f64| (written - exact).abs() > 1e-3;
        if off(amodal.visibility, f64::from(object.pixels) / f64::from(amodal.amodal_pixels)) {
            return Some("has a visibility that does not follow from its pixels");
        }
        if off(amodal.truncation, 1.0 - area(clipped) / area(amodal.amodal_bbox)) {
            return Some("has a truncation that does not follow from its boxes");
        }
        let takes = |occluder: &Occluder| occluder.id != object.id && self.shows(amodal.amodal_bbox_clipped, occluder);
        if !amodal.occluders.iter().all(takes) {
            return Some("is hidden by what does not show so many pixels there");
        }
        amodal.amodal_mask.as_ref().and_then(|mask| self.mask_problem(object, amodal, mask))
    }

    /// Whether an occluder shows as many pixels within a box as it is said to take.
    fn shows(&self, PixelBox { x, y, w, h }: PixelBox, occluder: &Occluder) -> bool {
        let Some(image) = self.instance else { return true };
        let within = (y..y + h).flat_map(|y| (x..x + w).map(move |x| (x, y)));
        let own = |&(x, y): &(u32, u32)| {
            let pixel = image.at(x, y);
            pixel.id == occluder.id && pixel.tag.value() == occluder.tag
        };
        within.filter(own).count() >= occluder.pixels as usize
    }

    fn mask_problem(&self, object: &ObjectRecord, amodal: &AmodalRecord, mask: &str) -> Option<&'static str> {
        let Some(pixels) = mask_pixels(mask, self.camera.size) else {
            return Some("has an amodal mask that is none of this picture");
        };
        if pixels.len() != amodal.amodal_pixels as usize {
            return Some("has an amodal mask of another number of pixels");
        }
        let image = self.instance?;
        let seen = pixels.iter().filter(|&&pixel| image.data[pixel].id == object.id).count();
        (seen != object.pixels as usize).then_some("has an amodal mask without all of its visible pixels")
    }

    fn spatial_problem(&self, object: &ObjectRecord, spatial: &Spatial) -> Option<&'static str> {
        let around = &spatial.box3d;
        let rotation = |[w, x, y, z]: [f64; 4]| DQuat::from_xyzw(x, y, z, w);
        let [world_from_object, camera_from_object] = [around.rotation, around.rotation_in_camera].map(rotation);
        if [world_from_object, camera_from_object].iter().any(|q| (q.length() - 1.0).abs() > 1e-4) {
            return Some("has a rotation that is no unit quaternion");
        }
        let [centre, half] = [DVec3::from(around.center), 0.5 * DVec3::from(around.size)];
        let in_camera = self.camera.camera_from_world(centre.as_vec3()).as_dvec3();
        if in_camera.distance(DVec3::from(around.center_in_camera)) > METRES {
            return Some("is elsewhere before the camera than in the world");
        }
        if (in_camera.length() - spatial.distance_m).abs() > METRES {
            return Some("has a distance that is not that of its box");
        }
        let turned = |i: usize| centre + world_from_object * (half * sign(i));
        let place = |i: usize| {
            let (at, depth) = self.camera.project(turned(i).as_vec3())?;
            let in_reach = f64::from(at.abs().max_element()) < WIDTHS_BESIDE * f64::from(self.camera.size.width);
            (depth > 0.2 && in_reach).then(|| (at.to_array().map(f64::from), f64::from(depth)))
        };
        let near =
            |i: usize| place(i).zip(around.corners[i]).is_none_or(|((a, depth), b)| self.same_place(a, b, depth));
        if !(0..8).all(near) {
            return Some("has corners that are not those of its box");
        }
        self.depth_problem(object, around, camera_from_object)
    }

    /// Far beside the picture a rounded rotation moves a corner by more, and close to the lens a rounded place does.
    fn same_place(&self, a: [f64; 2], b: [f64; 2], depth: f64) -> bool {
        let far = (a[0].abs() + a[1].abs()) / f64::from(self.camera.size.width);
        let close = 0.5 * METRES * f64::from(self.camera.intrinsics.fx) / depth;
        let place = |p: [f64; 2]| Vec2::from_array(p.map(|value| value as f32));
        // The short way, where the picture's left and right edges meet.
        let way = self.camera.way_in_image(place(a), place(b));
        f64::from(way.abs().max_element()) < (PIXELS + close) * (1.0 + far)
    }

    /// Its pixels lie as deep as its box, to two centimetres.
    fn depth_problem(
        &self,
        object: &ObjectRecord,
        around: &Box3dRecord,
        camera_from_object: DQuat,
    ) -> Option<&'static str> {
        let (instance, depth) = (self.instance?, self.depth?);
        let (reach, middle): (f64, f64) = match self.camera.lens.depth_measure() {
            DepthMeasure::Planar => {
                let axes = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| (camera_from_object * axis).z.abs());
                (axes.iter().zip(around.size).map(|(axis, size)| 0.5 * axis * size).sum(), around.center_in_camera[2])
            }
            DepthMeasure::Distance => {
                (0.5 * DVec3::from(around.size).length(), DVec3::from(around.center_in_camera).length())
            }
        };
        let PixelBox { x, y, w, h } = object.bbox;
        let own = (y..y + h).flat_map(|y| (x..x + w).map(move |x| (x, y)));
        let mut own = own.filter(|&(x, y)| instance.at(x, y).id == object.id);
        let outside = own.any(|(x, y)| (f64::from(*depth.at(x, y)) - middle).abs() > reach + 0.02);
        outside.then_some("shows pixels nearer or farther than its box")
    }
}

/// The corners in the order of [`Box3dRecord::corners`].
fn sign(corner: usize) -> DVec3 {
    let [x, y] = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]][corner % 4];
    DVec3::new(x, y, if corner < 4 { -1.0 } else { 1.0 })
}

fn whole(size: ImageSize) -> AmodalBox {
    AmodalBox { x: 0, y: 0, w: size.width as i32, h: size.height as i32 }
}

fn holds(outer: AmodalBox, inner: AmodalBox) -> bool {
    let end = |from: i32, length: i32| i64::from(from) + i64::from(length);
    outer.x <= inner.x
        && outer.y <= inner.y
        && end(outer.x, outer.w) >= end(inner.x, inner.w)
        && end(outer.y, outer.h) >= end(inner.y, inner.h)
}

fn area(b: AmodalBox) -> f64 {
    f64::from(b.w) * f64::from(b.h)
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{CameraSite, ClassTag, InstanceId, LensModel, Mount};

    /// A car whose left half stands behind somebody, and everything that its labels are judged by.
    struct Example {
        camera: PinholeCamera,
        instance: Image<InstancePixel>,
        depth: Image<f32>,
        object: ObjectRecord,
    }

    const SIZE: ImageSize = ImageSize { width: 64, height: 48 };

    fn example() -> Example {
        let site = CameraSite {
            name: "mast".into(),
            position: [0.0; 3],
            yaw_rad: 0.0,
            down_tilt_rad: 0.0,
            horizontal_fov_rad: 1.0,
            lens: LensModel::Pinhole,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        let camera = PinholeCamera::new(&site, SIZE);
        let ground = InstancePixel { tag: ClassTag::Roads, id: InstanceId::STUFF };
        let (mut instance, mut depth) = (Image::filled(SIZE, ground), Image::filled(SIZE, 30.0));
        for (x, y) in (20..24).flat_map(|x| (20..26).map(move |y| (x, y))) {
            let (tag, id) = if x < 22 { (ClassTag::Pedestrians, 2) } else { (ClassTag::Car, 1) };
            let place = (y * SIZE.width + x) as usize;
            instance.data[place] = InstancePixel { tag, id: InstanceId(id) };
            depth.data[place] = 20.0;
        }
        let corner = |i: usize| {
            let place = DVec3::new(20.0, 0.0, 0.0) + DVec3::new(2.0, 1.0, 0.5) * sign(i);
            camera.project(place.as_vec3()).map(|(at, _)| at.to_array().map(f64::from))
        };
        let corners: [_; 8] = std::array::from_fn(corner);
        let object = serde_json::from_value(serde_json::json!({
            "id": 1, "class": "car", "bbox": [22, 20, 2, 6], "pixels": 12, "truncated": false, "parked": false,
            "position": [20.0, 0.0, -0.5], "yaw_rad": 0.0, "speed_mps": 0.0, "velocity_mps": [0.0, 0.0, 0.0],
            "box3d": {
                "center": [20.0, 0.0, 0.0], "size": [4.0, 2.0, 1.0], "rotation": [1.0, 0.0, 0.0, 0.0],
                "center_in_camera": [0.0, 0.0, 20.0], "rotation_in_camera": [0.5, 0.5, -0.5, 0.5], "corners": corners,
            },
            "distance_m": 20.0, "image_velocity_pxps": [0.0, 0.0],
            "amodal_bbox": [20, 20, 4, 6], "amodal_bbox_clipped": [20, 20, 4, 6], "amodal_pixels": 24,
            "visibility": 0.5, "truncation": 0.0, "occluders": [{"id": 2, "tag": 12, "pixels": 12}],
        }));
        Example { camera, instance, depth, object: object.expect("an object") }
    }

    impl Example {
        fn problem(&self, change: impl FnOnce(&mut ObjectRecord)) -> Option<String> {
            let mut object = self.object.clone();
            change(&mut object);
            let Self { camera, instance, depth, .. } = self;
            LabelledFrame { camera, instance: Some(instance), depth: Some(depth) }.problem(&object)
        }
    }

    #[test]
    fn what_is_right_passes_and_each_fault_is_named() {
        type Change = fn(&mut AmodalRecord, &mut Spatial);
        let example = example();
        assert_eq!(example.problem(|_| ()), None);
        let changes: [(&str, Change); 11] = [
            ("visible box leaves", |a, _| a.amodal_bbox_clipped.x = 23),
            ("leaves the picture", |a, _| {
                a.amodal_bbox_clipped.w = 90;
                a.amodal_bbox.w = 90;
            }),
            ("not its amodal pixels", |a, _| a.amodal_pixels = 25),
            ("visibility", |a, _| a.visibility = 0.6),
            ("truncation", |a, _| a.amodal_bbox.w = 5),
            ("hidden by", |a, _| a.occluders[0].tag = 14),
            ("amodal mask", |a, _| a.amodal_mask = Some("01c0".into())),
            ("unit quaternion", |_, s| s.box3d.rotation = [1.1, 0.0, 0.0, 0.0]),
            ("elsewhere", |_, s| s.box3d.center_in_camera[0] = 0.1),
            ("distance", |_, s| s.distance_m = 20.1),
            ("corners", |_, s| s.box3d.corners[3] = Some([0.0, 0.0])),
        ];
        for (named, change) in changes {
            let found = example.problem(|object| {
                let parts = object.amodal.as_mut().zip(object.spatial.as_mut());
                let (amodal, spatial) = parts.expect("both");
                change(amodal, spatial);
            });
            assert!(found.as_ref().is_some_and(|problem| problem.contains(named)), "{named}: {found:?}");
        }
        let mut deep = example;
        deep.depth.data[(22 * SIZE.width + 22) as usize] = 22.1;
        assert!(deep.problem(|_| ()).is_some_and(|problem| problem.contains("nearer or farther")));
    }
}
