//! The types that all crates of ENDLESS share: ids, class tags, frames of reference, units, weather, cameras, scene
//! settings, the per-frame world state and the sensor frame.
//!
//! Data flows one way: `Recipe → Plan → SceneSettings → (load) Scene → (tick) WorldState → SensorFrame → Annotations
//! → files`. The types at the arrows are defined here, so that crates exchange data without depending on one another.
//!
//! # Frames of reference
//! | frame | axes | units | used by |
//! |---|---|---|---|
//! | world | right-handed, x east, y north, z up | metres, radians counter-clockwise from east | everything inside |
//! | object | x forward, y left, z up; origin on the ground under the centre | metres | meshes of vehicles and people |
//! | camera (RDF) | x right, y down, z forward | metres | projection, depth |
//! | image | x right, y down; pixel (i, j) has its centre at (i + 0.5, j + 0.5) | pixels | boxes, layers |
//!
//! CARLA's left-handed degrees appear only where files and messages are read or written.

mod actor;
mod asset;
mod attributes;
mod behaviour;
mod bench_seat;
mod body_part;
mod bus_stop;
mod camera;
mod camera_look;
mod class;
mod color_name;
mod color_variation;
mod condition;
mod condition_mix;
mod condition_table;
mod drawn_sun;
mod driving_side;
mod flow;
mod glyph;
mod ids;
mod incident;
mod intrinsics;
mod keypoint;
mod lens;
mod light_variation;
pub mod math;
mod parking_bay;
mod per_video;
mod randomisation;
mod reid;
mod rig;
mod rng;
mod scene;
mod scene_camera;
mod scene_sun;
mod scene_weather;
mod sensor;
mod state;
mod sun_path;
mod track;
mod traffic_density;
mod traffic_profile;
mod unknown_name;
mod vehicle_choice;
mod vehicle_spec;
mod view_subject;
pub mod walking;
mod weather_quantities;
mod weather_timeline;

pub use actor::{Actor, FootPlace, Footing, Gait, Motion, Pose, VehicleLights, VehicleMotion, WalkerMotion};
pub use asset::{AssetRef, Outfit, PersonRef, VehicleModelId, VehicleRef};
pub use attributes::{
    AgeGroup, ColoredPiece, Hairdo, NamedColor, Occupants, PersonAttributes, Sex, VehicleAttributes, Word,
};
pub use behaviour::{Behaviour, LanePlace, Parking, Side};
pub use bench_seat::BenchSeat;
pub use body_part::BodyPart;
pub use bus_stop::BusStop;
pub use camera::{CameraRay, CameraSite, Mount, PinholeCamera};
pub use camera_look::{CameraLook, CameraLookChoice, Distortion, RecorderClock};
pub use class::{ClassTag, ObjectClass};
pub use color_name::{ColorName, ColoredThing, srgb_from_linear};
pub use color_variation::ColorVariation;
pub use condition::{Changing, ConditionChange, TimeOfDay, Weather};
pub use condition_table::{Condition, ValueRange};
pub use drawn_sun::DrawnSun;
pub use driving_side::DrivingSide;
pub use flow::{FlowPixel, FlowTarget};
pub use glyph::glyph;
pub use ids::{InstanceId, InstanceIdAllocator, SignalId, TooManyInstances};
pub use incident::{Incident, IncidentKind, StagedIncidents};
pub use intrinsics::{ImageSize, Intrinsics};
pub use keypoint::{BodyKeypoints, FOOT_KEYPOINT_COUNT, FOOT_KEYPOINTS, KEYPOINT_COUNT, KEYPOINT_LIMBS, KEYPOINTS};
pub use lens::{DepthMeasure, Fisheye, Lens, LensModel};
pub use light_variation::LightVariation;
pub use parking_bay::ParkingBay;
pub use per_video::PerVideo;
pub use randomisation::{RandomisedPart, SceneRandomisation};
pub use reid::{LookPool, Reid};
pub use rig::{
    Carrier, EventCameraSettings, GnssMeasurement, GnssRecord, GnssSettings, ImuMeasurement, ImuRecord, ImuSettings,
    LidarBeam, LidarPoint, LidarPreset, LidarSettings, LidarSweep, PixelEvent, Placement, RadarDetection, RadarScan,
    RadarSettings, RigCamera, RigEventCamera, ScanPattern, SceneSensor, SensorModel, SensorMount, SensorPose, WayPoint,
    carried, moving_to, rotation_from_angles, rotation_from_vector, rotation_vector,
};
pub use rng::{Stream, fnv1a};
pub use scene::{FixedCamera, SceneSettings};
pub use scene_camera::SceneCamera;
pub use scene_weather::SceneWeather;
pub use sensor::{FAR_PLANE_M, Image, InstancePixel, SensorFrame, SensorLayers};
pub use state::{SignalAspect, SignalState, WorldState};
pub use track::{Track, TrackPlayback, TrackPoint, TrackSample};
pub use traffic_density::{ActorDensity, TrafficDensity};
pub use traffic_profile::{Clothing, Region, RegionChoice, SignalControl, TrafficProfile};
pub use unknown_name::UnknownName;
pub use vehicle_choice::choose_vehicle;
pub use vehicle_spec::{ParkedVehicle, TrailerSpec, VehicleSpec};
pub use view_subject::ViewSubject;
pub use weather_quantities::WeatherQuantities;
pub use weather_timeline::WeatherTimeline;
