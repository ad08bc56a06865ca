//! Episodes, maps, weather and what stands in them.

use super::geometry::{BoundingBox, Color, Location, Transform};
use super::value::Bytes;
use super::wire_structs;

wire_structs! {
    /// Which episode runs, and where its snapshots come from.
    EpisodeInfo {
        /// Another for every load of a map.
        id: u64 = 0,
        /// Of the stream of snapshots.
        token: Vec<Bytes> = Vec::new(),
    }
    /// How time runs.
    EpisodeSettings {
        /// Time waits for the client's ticks.
        synchronous_mode: bool = false,
        /// Cameras show nothing.
        no_rendering_mode: bool = false,
        /// Seconds from frame to frame; `None` for those that pass.
        fixed_delta_seconds: Option<f64> = None,
        /// Physics in smaller steps.
        substepping: bool = true,
        /// Of such a step, seconds.
        max_substep_delta_time: f64 = 0.01,
        /// Of a frame.
        max_substeps: i32 = 10,
        /// Metres.
        max_culling_distance: f32 = 0.0,
        /// The same falls every time.
        deterministic_ragdolls: bool = true,
        /// Metres.
        tile_stream_distance: f32 = 3000.0,
        /// Metres.
        actor_active_distance: f32 = 2000.0,
        /// The spectator counts as one around whom the world is loaded.
        spectator_as_ego: bool = true,
    }
    /// A map.
    MapInfo {
        /// Such as `Carla/Maps/Town01`.
        name: String = String::new(),
        /// Where vehicles may begin.
        recommended_spawn_points: Vec<Transform> = Vec::new(),
    }
    /// CARLA's weather.
    WeatherParameters {
        /// Percent.
        cloudiness: f32 = 0.0,
        /// Percent.
        precipitation: f32 = 0.0,
        /// Puddles, percent.
        precipitation_deposits: f32 = 0.0,
        /// Percent.
        wind_intensity: f32 = 0.0,
        /// Degrees.
        sun_azimuth_angle: f32 = 0.0,
        /// Degrees.
        sun_altitude_angle: f32 = 0.0,
        /// Percent.
        fog_density: f32 = 0.0,
        /// Where it begins, metres.
        fog_distance: f32 = 0.0,
        /// How fast it thins out upwards.
        fog_falloff: f32 = 0.0,
        /// Percent.
        wetness: f32 = 0.0,
        /// Light in volumes.
        scattering_intensity: f32 = 0.0,
        /// Haze.
        mie_scattering_scale: f32 = 0.0,
        /// Air.
        rayleigh_scattering_scale: f32 = 0.0331,
        /// Percent.
        dust_storm: f32 = 0.0,
    }
    /// How a world is made of an OpenDRIVE text.
    OpendriveGenerationParameters {
        /// Metres.
        vertex_distance: f64 = 2.0,
        /// Metres.
        max_road_length: f64 = 50.0,
        /// Metres.
        wall_height: f64 = 1.0,
        /// Metres.
        additional_width: f64 = 0.6,
        /// Junctions are smoothed.
        smooth_junctions: bool = true,
        /// It is seen.
        enable_mesh_visibility: bool = true,
        /// People may walk.
        enable_pedestrian_navigation: bool = true,
    }
    /// A thing of the map.
    EnvironmentObject {
        /// In the world.
        transform: Transform = Transform::default(),
        /// In the world.
        bounding_box: BoundingBox = BoundingBox::default(),
        /// Its number.
        id: u64 = 0,
        /// Its name.
        name: String = String::new(),
        /// Its class.
        label: u8 = 0,
    }
    /// A place on a ray, and what is there.
    LabelledPoint {
        /// In the world.
        location: Location = Location::default(),
        /// Its class.
        label: u8 = 0,
    }
    /// A lamp of the map.
    LightState {
        /// Its number.
        id: u32 = 0,
        /// In the world.
        location: Location = Location::default(),
        /// Lumens.
        intensity: f32 = 0.0,
        /// 0 none, 1 vehicle, 2 street, 3 building, 4 other.
        group: u8 = 0,
        /// Its colour.
        color: Color = Color::default(),
        /// Whether it is on.
        active: bool = false,
    }
}
