//! Kinds of sensors.

/// Which sensor a blueprint makes.
///
/// `sensor.other.rss` is not among them: what it tells is computed by a library in the client that the published clients
/// are built without. Nor are `sensor.other.v2x` and `sensor.other.v2x_custom`: there is no radio here.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SensorKind {
    /// `sensor.camera.rgb`.
    Rgb,
    /// `sensor.camera.depth`.
    Depth,
    /// `sensor.camera.semantic_segmentation`.
    Semantic,
    /// `sensor.camera.instance_segmentation`.
    Instance,
    /// `sensor.camera.normals`.
    Normals,
    /// `sensor.camera.optical_flow`.
    OpticalFlow,
    /// `sensor.camera.dvs`: events where the brightness of a pixel changes.
    Dvs,
    /// `sensor.camera.cosmos_visualization`, since 0.9.16: lines and boxes to condition a generative model with.
    CosmosVisualization,
    /// `sensor.lidar.ray_cast`.
    Lidar,
    /// `sensor.lidar.ray_cast_semantic`.
    SemanticLidar,
    /// `sensor.other.radar`.
    Radar,
    /// `sensor.other.imu`.
    Imu,
    /// `sensor.other.gnss`.
    Gnss,
    /// `sensor.other.collision`.
    Collision,
    /// `sensor.other.obstacle`.
    Obstacle,
    /// `sensor.other.lane_invasion`: the client computes it from the map; a server only keeps the actor.
    LaneInvasion,
}

impl SensorKind {
    /// All of them.
    pub const ALL: [Self; 16] = [
        Self::Rgb,
        Self::Depth,
        Self::Semantic,
        Self::Instance,
        Self::Normals,
        Self::OpticalFlow,
        Self::Dvs,
        Self::CosmosVisualization,
        Self::Lidar,
        Self::SemanticLidar,
        Self::Radar,
        Self::Imu,
        Self::Gnss,
        Self::Collision,
        Self::Obstacle,
        Self::LaneInvasion,
    ];

    /// Id of its blueprint.
    pub const fn id(self) -> &'static str {
        match self {
            Self::Rgb => "sensor.camera.rgb",
            Self::Depth => "sensor.camera.depth",
            Self::Semantic => "sensor.camera.semantic_segmentation",
            Self::Instance => "sensor.camera.instance_segmentation",
            Self::Normals => "sensor.camera.normals",
            Self::OpticalFlow => "sensor.camera.optical_flow",
            Self::Dvs => "sensor.camera.dvs",
            Self::CosmosVisualization => "sensor.camera.cosmos_visualization",
            Self::Lidar => "sensor.lidar.ray_cast",
            Self::SemanticLidar => "sensor.lidar.ray_cast_semantic",
            Self::Radar => "sensor.other.radar",
            Self::Imu => "sensor.other.imu",
            Self::Gnss => "sensor.other.gnss",
            Self::Collision => "sensor.other.collision",
            Self::Obstacle => "sensor.other.obstacle",
            Self::LaneInvasion => "sensor.other.lane_invasion",
        }
    }

    /// The number at the head of its messages, as CARLA 0.9.16 counts.
    pub const fn stream_type_id(self) -> u64 {
        match self {
            Self::Collision => 0,
            Self::Depth => 1,
            Self::Normals => 2,
            Self::Dvs => 3,
            Self::Gnss => 4,
            Self::Imu => 5,
            Self::LaneInvasion => 6,
            Self::Obstacle => 7,
            Self::OpticalFlow => 8,
            Self::Radar => 9,
            Self::SemanticLidar => 10,
            Self::Lidar => 11,
            Self::Rgb => 13,
            Self::Semantic => 14,
            Self::Instance => 15,
            Self::CosmosVisualization => 16,
        }
    }

    /// Whether a server sends what it measures: then its actors have a stream token.
    pub const fn streams(self) -> bool {
        !matches!(self, Self::LaneInvasion)
    }

    /// Whether it sends a message only when something happens, not at every tick.
    pub const fn is_event(self) -> bool {
        matches!(self, Self::Collision | Self::Obstacle | Self::LaneInvasion)
    }

    /// Whether it has an image's size and field of view.
    pub const fn is_camera(self) -> bool {
        matches!(
            self,
            Self::Rgb
                | Self::Depth
                | Self::Semantic
                | Self::Instance
                | Self::Normals
                | Self::OpticalFlow
                | Self::Dvs
                | Self::CosmosVisualization
        )
    }
}
