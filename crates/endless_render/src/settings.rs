//! Settings of a camera's picture of a scene.

use endless_world::{
    CameraLook, CameraSite, ImageSize, LightVariation, PinholeCamera, SceneRandomisation, SceneWeather, SensorLayers,
    TimeOfDay, Weather,
};

/// Where light of the sky and from other surfaces is gathered for the still picture, and with how many rays a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gathering {
    /// At one point of every two by two pixels, interpolated along surfaces from there, and wherever that does not do.
    Interpolated {
        /// Rays a point; 6 are clean after denoising.
        rays: u32,
    },
    /// At every sample of every pixel: slow; the oracle of the other.
    EverySample {
        /// Rays a sample; 4 are clean after denoising.
        rays: u32,
    },
    /// Nowhere: the probes in the air tell of it, as they do for what moves. Without grain, so that pictures of a camera that
    /// moves follow each other smoothly.
    Probes,
}

impl Gathering {
    /// As clean as the default.
    pub const EVERY_SAMPLE: Self = Self::EverySample { rays: 4 };
}

impl Default for Gathering {
    fn default() -> Self {
        Self::Interpolated { rays: 6 }
    }
}

/// Where what stands still is looked at in a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PixelSamples {
    /// At four points, in the light of all of the sun's disc; by rays where surfaces and shadows end, by interpolation elsewhere.
    #[default]
    Four,
    /// At its centre, in the light of one point of the sun: edges of things and shadows have steps.
    Centre,
}

/// Settings of a camera's picture of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct RenderSettings {
    /// Sun, sky, air and ground.
    pub weather: SceneWeather,
    /// The scene's seed.
    pub seed: u64,
    /// What is randomised, if anything is.
    pub randomised: Option<SceneRandomisation>,
    /// Image size.
    pub size: ImageSize,
    /// Where light that bounced is gathered.
    pub gathering: Gathering,
    /// Where what stands still is looked at in a pixel.
    pub samples: PixelSamples,
    /// Which of many equal patterns the gathering rays follow: pictures that differ in nothing else differ by the grain
    /// that is left.
    pub pattern: u32,
    /// Effects of lens, sensor and recorder on the picture.
    pub look: CameraLook,
    /// Frames a second, for the recorder's clock.
    pub fps: f64,
    /// Images that are wanted besides RGB, depth and instances.
    pub layers: SensorLayers,
    /// Keep what [`crate::CameraBake::render_uncached`] needs (12 bytes a sample).
    pub keep_irradiance: bool,
}

impl RenderSettings {
    /// The default settings of datasets, at 30 frames a second.
    pub fn new(weather: Weather, time_of_day: TimeOfDay, seed: u64, size: ImageSize) -> Self {
        Self {
            weather: SceneWeather::new(weather, time_of_day, seed),
            seed,
            randomised: None,
            size,
            gathering: Gathering::default(),
            samples: PixelSamples::default(),
            pattern: 0,
            look: CameraLook::CLEAN,
            fps: 30.0,
            layers: SensorLayers::default(),
            keep_irradiance: false,
        }
    }

    /// What is changed of the light of the condition.
    pub(crate) fn light(&self) -> Option<LightVariation> {
        self.randomised.as_ref()?.light
    }

    /// The camera of a site with this picture's size and lens.
    pub(crate) fn camera(&self, site: &CameraSite) -> PinholeCamera {
        PinholeCamera::new(site, self.size).with_distortion(self.look.distortion)
    }
}
