//! Ground truth from the instance image and the state of the scene: bounding boxes, visible pixels, tracks, keypoints.
//!
//! Boxes are in image coordinates: pixels from the top-left corner, `[x, y, w, h]` with `w = xmax − xmin + 1`, tight
//! around the object's visible pixels (COCO's convention). A track is an [`endless_world::InstanceId`]: the same
//! object in all cameras and in all frames of a video.
//!
//! [`visible_objects`] finds the objects of an instance image, [`annotate`] joins them with the [`SceneObjects`] of the
//! instant, and [`FrameObjects::with_keypoints`] adds people's keypoints as a [`CameraView`] shows them. From the objects'
//! own [`ObjectShapes`] follow boxes in space ([`FrameObjects::with_boxes3d`]) and what is hidden
//! ([`FrameObjects::with_amodal`]).
//!
//! ```
//! use endless_annotate::{PixelBox, visible_objects};
//! use endless_world::{ClassTag, Image, ImageSize, InstanceId, InstancePixel};
//!
//! let size = ImageSize { width: 6, height: 4 };
//! let mut instance = Image::filled(size, InstancePixel { tag: ClassTag::Roads, id: InstanceId::STUFF });
//! for pixel in [8, 9, 10, 14, 15] {
//!     instance.data[pixel] = InstancePixel { tag: ClassTag::Car, id: InstanceId(7) };
//! }
//! let found = visible_objects(&instance);
//! assert_eq!((found[0].id, found[0].pixels), (InstanceId(7), 5));
//! assert_eq!(found[0].bbox, PixelBox { x: 2, y: 1, w: 3, h: 2 });
//! ```

mod activity;
mod actor_record;
mod amodal;
mod box3d;
mod camera_map;
mod counting;
mod events;
mod frame;
mod ground_plane;
mod happenings;
mod image_line;
mod image_shape;
mod keypoint;
mod lens_projection;
mod map_features;
mod object;
mod other_lens;
mod polygon;
mod ridden;
mod rle;
mod rounding;
mod shape_labels;
mod shapes;
mod vehicle_events;
mod visible;

pub use activity::{Action, Activity};
pub use actor_record::ActorRecord;
pub use amodal::{AmodalBox, AmodalRecord, Occluder};
pub use box3d::{Box3d, Box3dRecord};
pub use counting::{ClassCounts, CountingLine, LineCounter, LineCounts};
pub use events::{
    ENCROACHMENT_S, Event, EventDetector, Footprint, HARD_BRAKING_MPS2, LaneCrossing, LaneFacts, NEAR_MISS_S, Relation,
    RoadFacts, relations,
};
pub use frame::{AnnotateError, FrameObjects, annotate};
pub use happenings::{Happenings, SceneObserver};
mod scene_frame;
mod way_inside;

pub use camera_map::{
    BodyView, CameraMap, CrosswalkView, LaneView, LensView, PaintView, SidewalkView, SignView, SignalView,
};
pub use ground_plane::GroundPlane;
pub use image_shape::{ImageArea, ImageLine};
pub use keypoint::{CameraView, Keypoint, Keypoints, Visibility, WorldKeypoints};
pub use map_features::{
    CrosswalkAttributes, CrosswalkFeature, FeatureBody, LaneAttributes, LaneControl, LaneFeature, LensColor,
    MapFeatures, MarkAttributes, MarkFeature, PaintColor, SidewalkFeature, SignAttributes, SignFeature,
    SignalAttributes, SignalFeature, SignalKind, SignalLens, StopLineAttributes, StopLineFeature,
};
pub use object::{ObjectRecord, SceneObjects};
pub use ridden::WithRider;
pub use rle::{mask_pixels, visible_mask};
pub use scene_frame::{LightState, SceneFrame, SignalRecord, SunState, WeatherState, count_by_class};
pub use shapes::{ObjectShapes, Spatial};
pub use vehicle_events::{BodySize, CollisionEvent, CollisionSensor, LaneInvasionEvent, LaneInvasionSensor};
pub use visible::{PixelBox, VisibleObject, visible_objects};
