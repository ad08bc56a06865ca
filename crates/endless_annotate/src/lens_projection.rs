//! A camera's projection in double precision, as `camera.json` describes it, and the part of the world that it can show.

use endless_world::{Lens, PinholeCamera};
use glam::{DMat3, DVec2, DVec3, Vec2};

/// Nearest depth that is projected, metres.
pub(crate) const NEAR_M: f64 = 1.0;
/// Share by which the frustum is wider than the picture, so that it cuts nothing off.
const MARGIN: f64 = 1.02;

/// Projects points of the world into undistorted and distorted pixels.
#[derive(Debug, Clone)]
pub(crate) struct LensProjection {
    pub(crate) camera_from_world: DMat3,
    pub(crate) position: DVec3,
    focal: DVec2,
    principal: DVec2,
    distortion: [f64; 2],
    /// Picture size, pixels.
    pub(crate) size: DVec2,
    /// Largest |x / z| and |y / z| that the picture of a perspective lens shows, with a margin.
    reach: DVec2,
    /// The lens, if it is not perspective.
    other: Option<Lens>,
}

impl LensProjection {
    pub(crate) fn new(camera: &PinholeCamera) -> Self {
        let k = &camera.intrinsics;
        let (focal, principal) = (Vec2::new(k.fx, k.fy), Vec2::new(k.cx, k.cy));
        let size = Vec2::new(camera.size.width as f32, camera.size.height as f32);
        let border = [0.0, 0.5, 1.0].map(|x| [0.0, 0.5, 1.0].map(|y| Vec2::new(x, y) * size));
        let (distortion, other) = match camera.lens {
            Lens::Perspective(distortion) => ([distortion.k1, distortion.k2].map(f64::from), None),
            other => ([0.0; 2], Some(other)),
        };
        let straight = |p: &Vec2| undistorted(((*p - principal) / focal).as_dvec2(), distortion).abs();
        let reach = border.iter().flatten().map(straight).fold(DVec2::ZERO, DVec2::max) * MARGIN;
        Self {
            camera_from_world: camera.world_from_camera.transpose().as_dmat3(),
            position: camera.position.as_dvec3(),
            focal: focal.as_dvec2(),
            principal: principal.as_dvec2(),
            distortion,
            size: size.as_dvec2(),
            reach,
            other,
        }
    }

    /// The lens, if it is not perspective.
    pub(crate) fn other_lens(&self) -> Option<&Lens> {
        self.other.as_ref()
    }

    /// The pixel at `p`: see [`Lens`].
    pub(crate) fn pixel(&self, p: DVec2) -> DVec2 {
        self.principal + self.focal * p
    }

    /// In the camera's frame.
    pub(crate) fn to_camera(&self, point_in_world: DVec3) -> DVec3 {
        self.camera_from_world * (point_in_world - self.position)
    }

    /// In the world.
    pub(crate) fn to_world(&self, point_in_camera: DVec3) -> DVec3 {
        self.camera_from_world.transpose() * point_in_camera + self.position
    }

    /// The pixel of a point before a perspective camera, through the lens.
    pub(crate) fn image(&self, point_in_camera: DVec3) -> DVec2 {
        let p = point_in_camera.truncate() / point_in_camera.z;
        self.principal + self.focal * p * stretch(p.length_squared(), self.distortion)
    }

    /// `K` of `image ~ K · camera`, for a picture without distortion.
    pub(crate) fn matrix(&self) -> DMat3 {
        DMat3::from_cols(
            DVec3::new(self.focal.x, 0.0, 0.0),
            DVec3::new(0.0, self.focal.y, 0.0),
            self.principal.extend(1.0),
        )
    }

    /// Whether a pixel lies in the picture, its border included.
    pub(crate) fn shows(&self, image: DVec2) -> bool {
        image.cmpge(DVec2::ZERO).all() && image.cmple(self.size).all()
    }

    /// The planes around what may be seen up to a depth: the frustum is where all of these linear functions of a point in
    /// the camera's frame are at least 0.
    pub(crate) fn frustum(&self, far_m: f64) -> [FrustumPlane; 6] {
        let DVec2 { x, y } = self.reach;
        [
            (DVec3::Z, -NEAR_M),
            (DVec3::NEG_Z, far_m),
            (DVec3::new(1.0, 0.0, x), 0.0),
            (DVec3::new(-1.0, 0.0, x), 0.0),
            (DVec3::new(0.0, 1.0, y), 0.0),
            (DVec3::new(0.0, -1.0, y), 0.0),
        ]
        .map(|(normal, offset)| FrustumPlane { normal, offset })
    }

    /// Projected points along a segment before the camera: both ends, and enough between them that straight lines from each
    /// to the next stay this near to what the lens makes of it.
    pub(crate) fn samples(&self, ends: [DVec3; 2]) -> Vec<DVec3> {
        let mut points = vec![ends[0]];
        self.add_samples(ends, MOST_HALVINGS, &mut points);
        points
    }

    fn add_samples(&self, [a, b]: [DVec3; 2], halvings: u32, points: &mut Vec<DVec3>) {
        let (from, to) = (self.image(a), self.image(b));
        let bent = [0.25, 0.5, 0.75]
            .iter()
            .any(|&share| distance_to_segment(self.image(between(a, b, share)), from, to) > MOST_DEVIATION_PX);
        if bent && halvings > 0 {
            let middle = between(a, b, 0.5);
            self.add_samples([a, middle], halvings - 1, points);
            self.add_samples([middle, b], halvings - 1, points);
        } else {
            points.push(b);
        }
    }
}

/// By how much a lens moves a point away from the principal point, whose distance squared this is.
fn stretch(r2: f64, [k1, k2]: [f64; 2]) -> f64 {
    1.0 + r2 * (k1 + k2 * r2)
}

/// The pinhole image point of a distorted one, by bisection: also where a wide lens bends so much that Newton's method
/// would need many steps.
fn undistorted(p: DVec2, distortion: [f64; 2]) -> DVec2 {
    /// Tangent of the largest angle from the optical axis that is looked for.
    const WIDEST: f64 = 100.0;
    let bent = p.length();
    let (mut low, mut high) = (0.0, WIDEST);
    for _ in 0..60 {
        let r = 0.5 * (low + high);
        if r * stretch(r * r, distortion) < bent { low = r } else { high = r }
    }
    if bent > 0.0 { p * (high / bent) } else { p }
}

/// Distance of straight lines from what they stand for, pixels.
pub(crate) const MOST_DEVIATION_PX: f64 = 0.2;
const MOST_HALVINGS: u32 = 10;

/// A side of the frustum.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FrustumPlane {
    normal: DVec3,
    offset: f64,
}

impl FrustumPlane {
    /// At least 0 on the inner side.
    pub(crate) fn inwards(&self, point_in_camera: DVec3) -> f64 {
        self.normal.dot(point_in_camera) + self.offset
    }
}

/// The point of a segment that a pinhole shows at this share of the way between the images of its ends.
pub(crate) fn between(a: DVec3, b: DVec3, share: f64) -> DVec3 {
    a.lerp(b, share * a.z / (b.z + share * (a.z - b.z)))
}

pub(crate) fn distance_to_segment(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = b - a;
    let t = ((p - a).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
    p.distance(a + along * t)
}
