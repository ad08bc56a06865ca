//! The built-in city as the renderer draws it: the geometry of towns and of traffic's actors.
//!
//! ```text
//! Town, Catalogue ── TownScene ──────────────┬─ StaticScene
//! actors ── ActorModels ── with a WorldState ┴─ FrameScene
//! ```
//! A [`TownScene`] is loaded once a map, [`ActorModels`] are made once a video, and a
//! [`FrameScene`](endless_render::FrameScene) once a frame. [`SharedModels`] keep what towns and videos have in common.
//!
//! ```
//! use endless_asset::Catalogue;
//! use endless_city::{ActorModels, TownScene};
//! use endless_render::{CameraBake, RenderSettings};
//! use endless_town::Town;
//! use endless_world::{CameraSite, ImageSize, LensModel, Mount, TimeOfDay, Weather, WorldState};
//!
//! let catalogue = Catalogue::builtin();
//! let town = TownScene::load(&Town::default(), &catalogue)?;
//! let state = WorldState { frame: 0, time_s: 0.0, actors: vec![], signals: vec![] };
//! let models = ActorModels::in_town(&town, &catalogue, &state.actors);
//! let site = CameraSite {
//!     name: "pole".to_owned(),
//!     position: [0.0, 0.0, 6.0],
//!     yaw_rad: 0.0,
//!     down_tilt_rad: 0.4,
//!     horizontal_fov_rad: 1.0,
//!     lens: LensModel::Pinhole,
//!     mount: Mount::Pole,
//!     roll_rad: 0.0,
//! };
//! let size = ImageSize { width: 32, height: 18 };
//! let settings = RenderSettings::new(Weather::Cloudy, TimeOfDay::Morning, 0, size);
//! let still = town.static_scene();
//! let image = CameraBake::bake(still, &settings, &site).render(still, &models.frame_scene(&state));
//! assert_eq!(image.rgb.data.len(), 32 * 18);
//! # Ok::<(), endless_world::TooManyInstances>(())
//! ```

mod actor_models;
mod clutter;
mod moving_vehicle;
mod person;
mod placed_prop;
mod shared_models;
mod town_scene;
mod town_thing;
mod vehicle;
mod velocity;

pub use actor_models::ActorModels;
pub use clutter::{ClutterPiece, clutter};
pub use placed_prop::PlacedProp;
pub use shared_models::SharedModels;
pub use town_scene::TownScene;
pub use town_thing::TownThing;
