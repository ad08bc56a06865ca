//! Keypoints of people in COCO's form: image position and visibility of each.

use crate::rounding::hundredths;
use endless_world::{
    BodyKeypoints, FOOT_KEYPOINT_COUNT, Image, ImageSize, InstanceId, InstancePixel, KEYPOINT_COUNT, PinholeCamera,
};
use glam::Vec3;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error, ser::SerializeSeq};
use std::collections::BTreeMap;

/// World positions of people's keypoints, metres.
pub type WorldKeypoints = BTreeMap<InstanceId, BodyKeypoints>;

/// COCO's flag `v`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum Visibility {
    /// Not in the picture; x and y are 0.
    Outside = 0,
    /// In the picture, but hidden by something, or by the person's own body.
    Hidden = 1,
    /// To be seen.
    Visible = 2,
}

/// One keypoint in a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Keypoint {
    /// Pixels from the picture's left edge, to hundredths.
    pub x: f64,
    /// Pixels from its top edge.
    pub y: f64,
    /// Visibility.
    pub visibility: Visibility,
}

impl Keypoint {
    const OUTSIDE: Self = Self { x: 0.0, y: 0.0, visibility: Visibility::Outside };

    /// The pixels, `[x, y]`, that may show one who has it in a picture of this size: its own and those beside it.
    /// They follow from the place as it is written, so that who reads it finds what who wrote it saw.
    pub fn pixels_around(&self, size: ImageSize) -> impl Iterator<Item = [u32; 2]> + use<> {
        let around = |at: f64, end: u32| (at as u32).saturating_sub(1)..(at as u32).saturating_add(2).min(end);
        let (columns, rows) = (around(self.x, size.width), around(self.y, size.height));
        rows.flat_map(move |y| columns.clone().map(move |x| [x, y]))
    }
}

/// Keypoints of one person, written as COCO's `[x1, y1, v1, x2, ...]`: the 17 of COCO, or others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Keypoints<const N: usize = KEYPOINT_COUNT>(pub [Keypoint; N]);

impl<const N: usize> Keypoints<N> {
    /// Number of keypoints in the picture, visible or hidden: COCO's `num_keypoints`.
    pub fn labelled(&self) -> u32 {
        self.0.iter().filter(|k| k.visibility != Visibility::Outside).count() as u32
    }
}

impl<const N: usize> Serialize for Keypoints<N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut list = serializer.serialize_seq(Some(3 * N))?;
        for keypoint in &self.0 {
            list.serialize_element(&keypoint.x)?;
            list.serialize_element(&keypoint.y)?;
            list.serialize_element(&(keypoint.visibility as u8))?;
        }
        list.end()
    }
}

impl<'de, const N: usize> Deserialize<'de> for Keypoints<N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let numbers = Vec::<f64>::deserialize(deserializer)?;
        if numbers.len() != 3 * N {
            let expected = format!("x, y and v of {N} keypoints");
            return Err(D::Error::invalid_length(numbers.len(), &expected.as_str()));
        }
        let mut keypoints = [Keypoint::OUTSIDE; N];
        for (keypoint, given) in keypoints.iter_mut().zip(numbers.chunks_exact(3)) {
            let visibility = match given[2] {
                0.0 => Visibility::Outside,
                1.0 => Visibility::Hidden,
                2.0 => Visibility::Visible,
                other => return Err(D::Error::custom(format!("{other} is no visibility: 0, 1 or 2"))),
            };
            *keypoint = Keypoint { x: given[0], y: given[1], visibility };
        }
        Ok(Self(keypoints))
    }
}

/// A camera with its depth and instance images, by which the visibility of keypoints is judged.
#[derive(Clone, Copy)]
pub struct CameraView<'a> {
    /// Its number among the scene's cameras that stand still; `None` of one that moves.
    pub number: Option<usize>,
    /// The camera.
    pub camera: &'a PinholeCamera,
    /// Whose each pixel is.
    pub instance: &'a Image<InstancePixel>,
    /// Depth of a pixel by its index, as the lens measures it, metres.
    pub depth: &'a dyn Fn(usize) -> f32,
}

/// How far behind the surface a keypoint that can be seen may lie, metres, in the order of the keypoints: joints are
/// inside limbs, eyes and noses on the face.
const BENEATH_M: [f32; KEYPOINT_COUNT] =
    [0.06, 0.06, 0.06, 0.07, 0.07, 0.15, 0.15, 0.10, 0.10, 0.08, 0.08, 0.20, 0.20, 0.13, 0.13, 0.11, 0.11];

impl CameraView<'_> {
    /// The keypoints of a person's feet as they are seen.
    pub fn foot_keypoints(&self, id: InstanceId, feet: &[Vec3; FOOT_KEYPOINT_COUNT]) -> Keypoints<FOOT_KEYPOINT_COUNT> {
        /// Inside shoes.
        const BENEATH_FOOT_M: f32 = 0.08;
        Keypoints(feet.map(|point| self.keypoint(id, point, BENEATH_FOOT_M)))
    }

    /// The keypoints of a person as they are seen.
    pub fn keypoints(&self, id: InstanceId, body: &[Vec3; KEYPOINT_COUNT]) -> Keypoints {
        Keypoints(std::array::from_fn(|k| self.keypoint(id, body[k], BENEATH_M[k])))
    }

    fn keypoint(&self, id: InstanceId, point: Vec3, beneath_m: f32) -> Keypoint {
        let size = self.instance.size;
        let inside = |x: f32, y: f32| x >= 0.0 && y >= 0.0 && x < size.width as f32 && y < size.height as f32;
        match self.camera.project(point) {
            Some((at, depth)) if inside(at.x, at.y) => {
                let hidden = Keypoint { x: hundredths(at.x), y: hundredths(at.y), visibility: Visibility::Hidden };
                let seen = self.shows(id, &hidden, depth - beneath_m);
                Keypoint { visibility: if seen { Visibility::Visible } else { Visibility::Hidden }, ..hidden }
            }
            _ => Keypoint::OUTSIDE,
        }
    }

    /// Whether a pixel around a keypoint shows an object no nearer than this depth.
    fn shows(&self, id: InstanceId, keypoint: &Keypoint, depth: f32) -> bool {
        let size = self.instance.size;
        keypoint.pixels_around(size).any(|[x, y]| {
            let pixel = y as usize * size.width as usize + x as usize;
            self.instance.data[pixel].id == id && (self.depth)(pixel) >= depth
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{CameraSite, ClassTag, ImageSize, LensModel, Mount};

    const SIZE: ImageSize = ImageSize { width: 64, height: 48 };
    const PERSON: InstanceId = InstanceId(7);

    /// Looks east from the origin.
    fn camera() -> PinholeCamera {
        let site = CameraSite {
            name: "test".into(),
            position: [0.0; 3],
            yaw_rad: 0.0,
            down_tilt_rad: 0.0,
            horizontal_fov_rad: 1.0,
            lens: LensModel::Pinhole,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        PinholeCamera::new(&site, SIZE)
    }

    fn image(id: InstanceId) -> Image<InstancePixel> {
        Image::filled(SIZE, InstancePixel { tag: ClassTag::Pedestrians, id })
    }

    fn visibility(shown: InstanceId, depth: f32, point: Vec3) -> Visibility {
        let (camera, instance) = (camera(), image(shown));
        let keypoints = CameraView { number: Some(0), camera: &camera, instance: &instance, depth: &|_| depth }
            .keypoints(PERSON, &[point; 17]);
        keypoints.0[0].visibility
    }

    #[test]
    fn what_lies_behind_something_is_hidden() {
        let ahead = Vec3::new(10.0, 0.5, 0.2);
        assert_eq!(visibility(PERSON, 9.97, ahead), Visibility::Visible);
        // Behind the person's own body, and behind somebody else.
        assert_eq!(visibility(PERSON, 9.7, ahead), Visibility::Hidden);
        assert_eq!(visibility(InstanceId(8), 9.97, ahead), Visibility::Hidden);
        assert_eq!(visibility(PERSON, 9.97, Vec3::new(-10.0, 0.5, 0.2)), Visibility::Outside);
        assert_eq!(visibility(PERSON, 9.97, Vec3::new(10.0, 9.0, 0.2)), Visibility::Outside);
    }

    #[test]
    fn a_keypoint_is_judged_where_it_is_written() {
        let camera = camera();
        // Just left of a pixel's border, and written to be on it.
        let focal = camera.project(Vec3::new(1.0, -1.0, 0.0)).expect("ahead").0.x - 32.0;
        let at = |x: f32| Vec3::new(10.0, (32.0 - x) / focal * 10.0, 0.0);
        for (x, written, shown, expected) in [
            (39.996, 40.0, 41, Visibility::Visible),
            (39.996, 40.0, 38, Visibility::Hidden),
            (39.99, 39.99, 38, Visibility::Visible),
            (39.99, 39.99, 41, Visibility::Hidden),
            // What is written to be on the right edge is in the last column.
            (63.998, 64.0, 63, Visibility::Visible),
        ] {
            let mut instance = image(InstanceId::STUFF);
            for row in 0..SIZE.height {
                instance.data[(row * SIZE.width + shown) as usize].id = PERSON;
            }
            let picture = CameraView { number: Some(0), camera: &camera, instance: &instance, depth: &|_| 10.0 };
            let keypoint = picture.keypoints(PERSON, &[at(x); 17]).0[0];
            assert_eq!((keypoint.x, keypoint.visibility), (written, expected), "{x} beside column {shown}");
            // Who reads it looks at the same pixels.
            let found = keypoint.pixels_around(SIZE).any(|[x, y]| instance.at(x, y).id == PERSON);
            assert_eq!(found, expected == Visibility::Visible);
        }
    }

    #[test]
    fn they_are_written_as_coco_does() {
        let (camera, instance) = (camera(), image(PERSON));
        let picture = CameraView { number: Some(0), camera: &camera, instance: &instance, depth: &|_| 10.0 };
        let mut body = [Vec3::new(10.0, 0.0, 0.0); 17];
        body[1] = -Vec3::X;
        let keypoints = picture.keypoints(PERSON, &body);
        assert_eq!(keypoints.labelled(), 16);
        let text = serde_json::to_string(&keypoints).expect("plain data");
        assert!(text.starts_with("[32.0,24.0,2,0.0,0.0,0,32.0,24.0,2,"), "{text}");
        assert_eq!(serde_json::from_str::<Keypoints>(&text).expect("own output"), keypoints);
        for wrong in ["[1,2,2]".to_owned(), text.replacen(",2,", ",3,", 1)] {
            assert!(serde_json::from_str::<Keypoints>(&wrong).is_err(), "{wrong}");
        }
    }
}
