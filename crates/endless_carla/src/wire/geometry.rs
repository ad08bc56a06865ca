//! Vectors, rotations, boxes and colours.

use super::wire_structs;

/// A place: the same as a vector, metres.
pub type Location = Vector3D;

wire_structs! {
    /// Two numbers.
    Vector2D {
        /// Along the first axis.
        x: f32 = 0.0,
        /// Along the second axis.
        y: f32 = 0.0,
    }
    /// Forward (or east), right (or south), up.
    Vector3D {
        /// Forward.
        x: f32 = 0.0,
        /// Right.
        y: f32 = 0.0,
        /// Up.
        z: f32 = 0.0,
    }
    /// Degrees.
    Rotation {
        /// Nose up is positive.
        pitch: f32 = 0.0,
        /// To the right is positive.
        yaw: f32 = 0.0,
        /// Right side down is positive.
        roll: f32 = 0.0,
    }
    /// A place and a rotation.
    Transform {
        /// Metres.
        location: Location = Location::default(),
        /// Degrees.
        rotation: Rotation = Rotation::default(),
    }
    /// A box: in the frame of its actor, or in the world's.
    BoundingBox {
        /// Its centre.
        location: Location = Location::default(),
        /// Half its size.
        extent: Vector3D = Vector3D::default(),
        /// How it is turned.
        rotation: Rotation = Rotation::default(),
        /// Whose it is, since 0.9.16.
        actor_id: u32 = 0,
    }
    /// A place on Earth.
    GeoLocation {
        /// Degrees.
        latitude: f64 = 0.0,
        /// Degrees.
        longitude: f64 = 0.0,
        /// Metres.
        altitude: f64 = 0.0,
    }
    /// A colour.
    Color {
        /// Red.
        r: u8 = 0,
        /// Green.
        g: u8 = 0,
        /// Blue.
        b: u8 = 0,
    }
}
