//! Places as recordings tell them.

use crate::wire::{Location, Rotation, Transform};

/// A place of a recording: centimetres there, metres here.
pub(super) fn transform_of(location: [f32; 3], [roll, pitch, yaw]: [f32; 3]) -> Transform {
    let [x, y, z] = location.map(|cm| 0.01 * cm);
    Transform { location: Location { x, y, z }, rotation: Rotation { pitch, yaw, roll } }
}

/// The same the other way: location and rotation.
pub(super) fn recorded_place(transform: &Transform) -> ([f32; 3], [f32; 3]) {
    let Transform { location: l, rotation: r } = transform;
    ([l.x, l.y, l.z].map(|m| 100.0 * m), [r.roll, r.pitch, r.yaw])
}
