//! The shapes of a scene's objects, by which boxes and hidden pixels are labelled.

use endless_annotate::{Box3d, CameraView, ObjectShapes};
use endless_render::{FrameScene, ObjectShape, StaticScene};
use endless_world::{Actor, InstanceId, Pose};
use std::{
    collections::BTreeMap,
    sync::{Arc, Mutex, OnceLock, PoisonError},
};

/// What never changes of an object that stands still in a video.
#[derive(Default)]
struct StillObject {
    shape: OnceLock<Option<ObjectShape>>,
    around: OnceLock<Option<Box3d>>,
    /// By camera.
    covered: Mutex<BTreeMap<usize, Arc<[u32]>>>,
    image_bounds: Mutex<BTreeMap<usize, Option<[f32; 4]>>>,
}

/// The parked vehicles of a video: found when they are first asked for, and kept.
pub(super) struct ParkedShapes<'m> {
    still: &'m StaticScene,
    objects: BTreeMap<InstanceId, (Pose, StillObject)>,
}

impl<'m> ParkedShapes<'m> {
    pub(super) fn new(still: &'m StaticScene, parked: &[Actor]) -> Self {
        let objects = parked.iter().map(|actor| (actor.id, (actor.pose, StillObject::default())));
        Self { still, objects: objects.collect() }
    }
}

impl StillObject {
    fn shape(&self, still: &StaticScene, id: InstanceId) -> Option<&ObjectShape> {
        self.shape.get_or_init(|| still.object_shape(id)).as_ref()
    }
}

/// What is kept of a camera that stands still, or made and kept. Two threads may make the same; either is right.
fn kept<V: Clone>(by_camera: &Mutex<BTreeMap<usize, V>>, camera: Option<usize>, make: impl FnOnce() -> V) -> V {
    let Some(camera) = camera else { return make() };
    let known = || by_camera.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(value) = known().get(&camera) {
        return value.clone();
    }
    let value = make();
    known().insert(camera, value.clone());
    value
}

impl ObjectShapes for ParkedShapes<'_> {
    fn box3d(&self, id: InstanceId) -> Option<Box3d> {
        let (pose, object) = self.objects.get(&id)?;
        *object.around.get_or_init(|| Some(box_around(object.shape(self.still, id)?, pose)))
    }

    fn covered(&self, view: &CameraView<'_>, id: InstanceId) -> Option<Arc<[u32]>> {
        let (_, object) = self.objects.get(&id)?;
        let shape = object.shape(self.still, id)?;
        if view.number.is_none() {
            return Some(hidden_pixels(shape, view, id));
        }
        Some(kept(&object.covered, view.number, || shape.covers(view.camera, |_| true).into()))
    }

    fn image_bounds(&self, view: &CameraView<'_>, id: InstanceId) -> Option<[f32; 4]> {
        let (_, object) = self.objects.get(&id)?;
        let shape = object.shape(self.still, id)?;
        kept(&object.image_bounds, view.number, || shape.image_bounds(view.camera))
    }
}

fn box_around(shape: &ObjectShape, pose: &Pose) -> Box3d {
    let (low, high) = shape.bounds_in(&pose.world_from_object());
    Box3d::new(pose, low, high)
}

/// Pixels that a shape covers and that show something nearer.
fn hidden_pixels(shape: &ObjectShape, view: &CameraView<'_>, id: InstanceId) -> Arc<[u32]> {
    let farthest = shape.farthest_depth(view.camera);
    let may_hide = |pixel: usize| view.instance.data[pixel].id != id && (view.depth)(pixel) < farthest;
    shape.covers(view.camera, may_hide).into()
}

/// Those that move, at one instant.
pub(super) struct MovingShapes {
    /// Poses of all; of riders that of their vehicle.
    poses: BTreeMap<InstanceId, Pose>,
    frame: Arc<FrameScene>,
    /// Those that were asked for.
    shapes: Mutex<BTreeMap<InstanceId, Option<Arc<ObjectShape>>>>,
}

impl MovingShapes {
    pub(super) fn new(actors: &[Actor], frame: Arc<FrameScene>) -> Self {
        let own = actors.iter().map(|actor| (actor.id, actor.pose));
        let riders = actors.iter().filter_map(|actor| Some((actor.rider_id?, actor.pose)));
        Self { poses: own.chain(riders).collect(), frame, shapes: Mutex::default() }
    }

    fn shape(&self, id: InstanceId) -> Option<Arc<ObjectShape>> {
        let mut shapes = self.shapes.lock().unwrap_or_else(PoisonError::into_inner);
        shapes.entry(id).or_insert_with(|| self.frame.object_shape(id).map(Arc::new)).clone()
    }
}

impl ObjectShapes for MovingShapes {
    fn box3d(&self, id: InstanceId) -> Option<Box3d> {
        Some(box_around(&*self.shape(id)?, self.poses.get(&id)?))
    }

    fn covered(&self, view: &CameraView<'_>, id: InstanceId) -> Option<Arc<[u32]>> {
        Some(hidden_pixels(&*self.shape(id)?, view, id))
    }

    fn image_bounds(&self, view: &CameraView<'_>, id: InstanceId) -> Option<[f32; 4]> {
        self.shape(id)?.image_bounds(view.camera)
    }
}
