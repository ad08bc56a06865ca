//! What the cameras of a scene see of its traffic: the boxes of its labels, without pictures.

use endless_annotate::FrameObjects;
use endless_world::WorldState;

/// One frame of a scene, as its labels tell it.
#[derive(Debug, Clone)]
pub struct SceneBoxes {
    /// Everybody, seen or not.
    pub state: WorldState,
    /// What each camera sees, in the order of the settings: objects with enough visible pixels.
    pub cameras: Vec<FrameObjects>,
}
