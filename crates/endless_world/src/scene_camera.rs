//! A camera of a scene.

use crate::{CameraLook, CameraSite};

/// A camera of a scene: where it hangs, and what it does to the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneCamera {
    /// Position and direction.
    pub site: CameraSite,
    /// Effects of its lens, sensor and recorder on the picture.
    pub look: CameraLook,
}
