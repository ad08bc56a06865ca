//! The ray tracer: what fixed cameras see of a scene, fast and exact on a CPU.
//!
//! A scene consists of meshes with materials, instances of them with ids and classes, lamps, and a condition (weather and
//! time of day).
//!
//! ```text
//! Mesh ─ Geometry ─ Instance ─┬─ StaticScene ────────────────────┐
//! StreetLamp ─────────────────┘                                  │
//! CameraSite, RenderSettings ──────────── CameraBake ────────────┼─ render → SensorFrame
//! MovingObject, VehicleBeam ─ FrameDescription ─ FrameScene ─────┘
//! ```
//! A [`StaticScene`] is made once a map, a [`CameraBake`] once a camera and video (it holds the fixed-camera cache), a
//! [`FrameScene`] once a frame. Rendering is a pure function of the three: call it from as many threads as there are frames
//! to make.
//!
//! ```
//! use endless_render::{CameraBake, FrameDescription, FrameScene, Geometry, Instance, RenderSettings, StaticScene};
//! use endless_scene::{Material, MeshBuilder, Surface};
//! use endless_world::{CameraSite, ClassTag, ImageSize, InstanceId, LensModel, Mount, TimeOfDay, Weather};
//! use glam::{Affine3A, Vec3};
//!
//! // A street, and a box on it that is an object of its own.
//! let cuboid = |low: [f32; 3], high: [f32; 3], material: Material| {
//!     let mut builder = MeshBuilder::new();
//!     builder.cuboid(low.into(), high.into(), material);
//!     Geometry::new(builder.finish())
//! };
//! let asphalt = Material::new(Surface::Asphalt, [0.14; 3], ClassTag::Roads);
//! let street = cuboid([-40.0, -40.0, -0.1], [40.0, 40.0, 0.0], asphalt);
//! let paint = Material::new(Surface::Painted, [0.5, 0.1, 0.1], ClassTag::Static);
//! let block = cuboid([-1.0, -1.0, 0.0], [1.0, 1.0, 2.0], paint);
//! let place = Affine3A::from_translation(Vec3::new(10.0, 0.0, 0.0));
//! let instances = vec![
//!     Instance::new(&street, Affine3A::IDENTITY),
//!     Instance::new(&block, place).with_id(InstanceId(1), ClassTag::Dynamic),
//! ];
//! let still = StaticScene::new(instances, &[]);
//!
//! // Six metres up, looking east and down.
//! let site = CameraSite {
//!     name: "pole".to_owned(),
//!     position: [0.0, 0.0, 6.0],
//!     yaw_rad: 0.0,
//!     down_tilt_rad: 0.5,
//!     horizontal_fov_rad: 1.0,
//!     lens: LensModel::Pinhole,
//!     mount: Mount::Pole,
//!     roll_rad: 0.0,
//! };
//! let size = ImageSize { width: 64, height: 36 };
//! let settings = RenderSettings::new(Weather::ClearSky, TimeOfDay::Afternoon, 0, size);
//! let bake = CameraBake::bake(&still, &settings, &site);
//! let frame = bake.render(&still, &FrameScene::new(FrameDescription::default()));
//! let middle = 18 * 64 + 32;
//! assert_eq!(frame.instance.data[middle].id, InstanceId(1));
//! assert!((frame.depth.data[middle] - 10.0).abs() < 1.0);
//! ```
//!
//! Modules: `accel` intersects rays; `scene` holds geometry and instances; `light` and `material` are light sources and
//! BSDFs; `shade` computes radiance from them; `indirect` and `cache` keep what does not change; `film` makes pixels of
//! radiance; `silhouette` asks what single objects cover; `ray_caster` serves sensors that are no cameras.

mod accel;
mod cache;
mod camera_rays;
mod exact8;
mod film;
mod image_rect;
mod indirect;
mod light;
mod lighting;
mod material;
mod math8;
mod moving_camera;
mod octahedron;
mod pixel_layers;
mod ray_caster;
mod rgb9e5;
mod sampling;
mod scene;
mod settings;
mod shade;
mod silhouette;
mod variation;
mod vec3x8;
mod work_share;

pub use accel::{Blas, Hit, Ray, RayStream, StreamHits, Tlas};
pub use cache::{BakeStats, CameraBake, CoveredCentres, NeighbourFrame, NeighbourFrames};
pub use indirect::IndirectHits;
pub use light::{BeamKind, VehicleBeam};
pub use material::occupants;
pub use moving_camera::{IndirectLight, LocalLight, MovingCamera, RoamingCamera, RoamingLight, render_labels};
pub use ray_caster::{RayCaster, RayHit};
pub use scene::{
    DeformableMesh, Deformation, Footprint, FrameDescription, FrameScene, Geometry, Instance, MovingObject,
    RigidVelocity, StaticScene, SurfacePoint,
};
pub use settings::{Gathering, PixelSamples, RenderSettings};
pub use silhouette::ObjectShape;
