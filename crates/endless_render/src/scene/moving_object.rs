//! Moving objects, and the volumes that bound what they change.

use super::Instance;
use crate::accel::Tlas;
use crate::light::VehicleBeam;
use glam::{Affine3A, Vec2, Vec3A};
use std::ops::Range;

/// A rigid or deforming object that moves: its instances, and the ground that it stands on. Of what is jointed, such as a
/// lorry and its trailer, each piece is an object.
#[derive(Debug, Clone)]
pub struct MovingObject {
    /// Its instances.
    pub instances: Vec<Instance>,
    /// Its footprint on the ground.
    pub footprint: Footprint,
}

/// The rectangle of ground under an object: there it casts its contact shadow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footprint {
    /// World frame, x forward along the rectangle, z up from the ground.
    pub world_from_object: Affine3A,
    /// Middle of the rectangle ahead of the origin, metres.
    pub ahead_m: f32,
    /// Half extents along and across, metres.
    pub half_m: Vec2,
    /// Height of the object above the ground, metres.
    pub height_m: f32,
}

/// One moving object as a volume: what its shadows, reflections and contact shadows are bounded by.
#[derive(Debug, Clone)]
pub(crate) struct MovingVolume {
    /// World-space bounds of all its instances.
    pub(crate) low: Vec3A,
    pub(crate) high: Vec3A,
    /// World-space boxes, `(low, high)`, that together hold it more closely.
    pub(crate) parts: Vec<(Vec3A, Vec3A)>,
    /// Centre of the footprint, seen from above.
    pub(crate) centre: Vec2,
    /// Unit vector along the body.
    pub(crate) along: Vec2,
    /// Half extents of the footprint along and across the body.
    pub(crate) half: Vec2,
    /// Height of the surface it stands on.
    pub(crate) ground: f32,
    pub(crate) height: f32,
    /// Vehicle lights that may reach it, ascending.
    pub(crate) beams: Vec<u16>,
}

impl MovingVolume {
    /// Of the object that these of the instances make up; `accel` holds all of them.
    pub(super) fn new(
        accel: &Tlas,
        instances: &[Instance],
        own: Range<usize>,
        footprint: &Footprint,
        beams: &[VehicleBeam],
    ) -> Self {
        let (mut low, mut high) = (Vec3A::INFINITY, Vec3A::NEG_INFINITY);
        let mut parts = Vec::new();
        for i in own {
            let (a, b) = accel.instance_bounds(i);
            (low, high) = (low.min(a), high.max(b));
            parts.extend(instances[i].close_bounds());
        }
        let reaches = |beam: &VehicleBeam| beam.reaches(low - 0.1, high + 0.1);
        let beams = (0u16..).zip(beams).filter(|(_, beam)| reaches(beam)).map(|(i, _)| i).collect();
        let forward = footprint.world_from_object.matrix3.x_axis;
        let foot = footprint.world_from_object.transform_point3a(Vec3A::X * footprint.ahead_m);
        Self {
            low,
            high,
            parts,
            centre: Vec2::new(foot.x, foot.y),
            along: Vec2::new(forward.x, forward.y).normalize_or(Vec2::X),
            half: footprint.half_m,
            ground: foot.z,
            height: footprint.height_m,
            beams,
        }
    }
}
