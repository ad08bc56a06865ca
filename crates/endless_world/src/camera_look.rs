//! Effects of a camera's lens, sensor and recorder on its pictures.

use crate::{DrawnSun, Stream, TimeOfDay, UnknownName, math};
use glam::Vec2;
use serde::{Deserialize, Serialize};
use strum::VariantArray as _;

/// The camera looks that a recipe can ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum CameraLookChoice {
    /// A good camera: a little noise, a little more contrast and colour than there is, and what moves is blurred by as long as
    /// the shutter is open.
    Natural,
    /// No effects, at one instant.
    Clean,
    /// A usual surveillance camera: a wide lens, some noise, a recorder that compresses and stamps the time.
    Cctv,
    /// Another camera each time, from good to poor.
    Random,
}

impl CameraLookChoice {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// The word used on the command line and in files.
    pub fn name(self) -> &'static str {
        self.into()
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("camera look", given, Self::ALL)
    }
}

/// Radial distortion in OpenCV's model: an image point at `r` (in focal lengths from the principal point) moves to
/// `r (1 + k1 r² + k2 r⁴)`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Distortion {
    /// Second order: below 0, straight lines bulge outwards (barrel).
    pub k1: f32,
    /// Fourth order.
    pub k2: f32,
}

impl Distortion {
    /// A true pinhole.
    pub const NONE: Self = Self { k1: 0.0, k2: 0.0 };

    /// A barrel that is monotone everywhere: with k2 = k1² / 2 no ray folds back into the picture.
    pub fn barrel(k1: f32) -> Self {
        Self { k1, k2: 0.5 * k1 * k1 }
    }

    /// The distorted position of a pinhole image point.
    #[inline]
    pub fn distort(self, p: Vec2) -> Vec2 {
        let r2 = p.length_squared();
        p * (1.0 + r2 * (self.k1 + self.k2 * r2))
    }

    /// Steps of Newton's method that undo a distortion, begun at `r (1 - k1 r²)`: as good as single precision.
    pub const NEWTON_STEPS: u32 = 4;

    /// The pinhole image point of a distorted one, by Newton's method on the radius.
    #[inline]
    pub fn undistort(self, p: Vec2) -> Vec2 {
        if self == Self::NONE {
            return p;
        }
        let bent = p.length();
        let mut r = bent * (1.0 - bent * bent * self.k1);
        for _ in 0..Self::NEWTON_STEPS {
            let r2 = r * r;
            let miss = r * (1.0 + r2 * (self.k1 + self.k2 * r2)) - bent;
            r -= miss / (1.0 + r2 * (3.0 * self.k1 + 5.0 * self.k2 * r2)).max(0.05);
        }
        if bent > 0.0 { p * (r / bent) } else { p }
    }
}

/// The recorder's clock at the first frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct RecorderClock {
    /// Year, month, day.
    pub date: [u16; 3],
    /// Seconds since midnight.
    pub second: u32,
}

impl RecorderClock {
    /// A random day, at an hour that fits the light, or the sun where that is drawn.
    pub fn new(time: TimeOfDay, sun: Option<DrawnSun>, random: &mut Stream) -> Self {
        let usual = match time {
            TimeOfDay::Morning => 7 * 3600,
            TimeOfDay::Afternoon => 14 * 3600,
            TimeOfDay::Night => 22 * 3600,
        };
        let begin = sun.map_or(usual, second_of);
        let mut number = |n: u32| random.range_f32(0.0, n as f32) as u32;
        let date = [2019 + number(6) as u16, 1 + number(12) as u16, 1 + number(28) as u16];
        Self { date, second: begin + number(5400) }
    }
}

/// The earliest second of a day at which the sun stands so. On both sides of noon it moves by ten degrees an hour, from where it
/// is in a usual morning, and to where it is in a usual afternoon.
fn second_of(DrawnSun { elevation_deg, rises }: DrawnSun) -> u32 {
    const DEGREES_AN_HOUR: f32 = 10.0;
    let hour = if rises {
        7.0 + (elevation_deg - 15.0) / DEGREES_AN_HOUR
    } else {
        14.0 + (51.0 - elevation_deg) / DEGREES_AN_HOUR
    };
    (hour * 3600.0) as u32
}

/// The look of one camera in one scene.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CameraLook {
    /// Lens distortion, the same for all layers.
    pub distortion: Distortion,
    /// Share of the light that the corners lose.
    pub vignetting: f32,
    /// How much farther from the middle red lies, and how much nearer blue, as a share.
    pub aberration: f32,
    /// Drops of rain on the lens, in rainy scenes.
    #[serde(default)]
    pub droplets: u32,
    /// Spots of dirt on the glass.
    #[serde(default, skip_serializing_if = "is_zero_count")]
    pub smudges: u32,
    /// Standard deviation of the blur of a lens out of focus, as a share of the picture's height.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub defocus: f32,
    /// Stops by which the picture is too bright, or too dark.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub exposure_stops: f32,
    /// Slope of the tone curve, as a multiple of the usual one: recorders are set to show more contrast than there is.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub contrast: f32,
    /// Factor of the colours' distance from grey.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub saturation: f32,
    /// How long the shutter is open, seconds: what moves is blurred by it. Labels are of the middle of that time. 0: an
    /// instant.
    #[serde(default)]
    pub shutter_s: f32,
    /// Standard deviation of the sensor's noise in middle grey, in 255ths.
    pub noise: f32,
    /// Factors by linear channel of a white balance that is off.
    #[serde(default = "neutral", skip_serializing_if = "is_neutral")]
    pub white_balance: [f32; 3],
    /// Strength of the unsharp mask.
    pub sharpening: f32,
    /// Quality of the recorder's JPEG-like compression, 1 to 100.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub jpeg_quality: Option<u8>,
    /// The time that is stamped into the picture.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clock: Option<RecorderClock>,
}

/// Key of the stream of faults: what is drawn of them changes nothing else.
const FAULTS: u64 = 1;
/// Key of the stream of how a recorder is set, and the ranges of that.
const PICTURE: u64 = 2;
const CONTRAST: [f32; 2] = [1.0, 1.8];
const SATURATION: [f32; 2] = [0.8, 1.8];
/// Shares of cameras with dirt on their glass, badly focused, and badly exposed.
const DIRTY: f64 = 0.2;
const OUT_OF_FOCUS: f64 = 0.15;
const BADLY_EXPOSED: f64 = 0.15;

/// What is wrong with a camera that nobody looks after.
struct CameraFaults {
    smudges: u32,
    defocus: f32,
    exposure_stops: f32,
}

impl CameraFaults {
    fn draw(random: &mut Stream) -> Self {
        let smudges = if random.chance(DIRTY) { 2 + random.below(12) as u32 } else { 0 };
        let defocus = if random.chance(OUT_OF_FOCUS) { random.range_f32(0.0008, 0.003) } else { 0.0 };
        let exposure_stops = if random.chance(BADLY_EXPOSED) { random.range_f32(-0.7, 1.3) } else { 0.0 };
        Self { smudges, defocus, exposure_stops }
    }
}

/// k1 of the widest lenses.
const STRONGEST_BARREL: f32 = -0.25;

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it")]
fn is_zero(number: &f32) -> bool {
    *number == 0.0
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it")]
fn is_zero_count(count: &u32) -> bool {
    *count == 0
}

const fn one() -> f32 {
    1.0
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it")]
fn is_one(factor: &f32) -> bool {
    *factor == one()
}

const fn neutral() -> [f32; 3] {
    [1.0; 3]
}

fn is_neutral(white_balance: &[f32; 3]) -> bool {
    *white_balance == neutral()
}

impl CameraLook {
    /// No effects.
    pub const CLEAN: Self = Self {
        distortion: Distortion::NONE,
        vignetting: 0.0,
        aberration: 0.0,
        droplets: 0,
        smudges: 0,
        defocus: 0.0,
        exposure_stops: 0.0,
        contrast: 1.0,
        saturation: 1.0,
        shutter_s: 0.0,
        noise: 0.0,
        white_balance: neutral(),
        sharpening: 0.0,
        jpeg_quality: None,
        clock: None,
    };

    /// The look of a camera; `random` is its own, `clock` that of the scene.
    pub fn new(choice: CameraLookChoice, time: TimeOfDay, clock: RecorderClock, random: &mut Stream) -> Self {
        let dark = if time == TimeOfDay::Night { 2.5 } else { 1.0 };
        // Cameras open the shutter for as long as the light asks, then amplify.
        let shutter_s = match time {
            TimeOfDay::Morning => 1.0 / 200.0,
            TimeOfDay::Afternoon => 1.0 / 500.0,
            TimeOfDay::Night => 1.0 / 60.0,
        };
        match choice {
            CameraLookChoice::Clean => Self::CLEAN,
            CameraLookChoice::Natural => {
                Self { contrast: 1.2, saturation: 1.15, shutter_s, noise: 0.6 * dark, ..Self::CLEAN }
            }
            CameraLookChoice::Cctv => Self {
                distortion: Distortion::barrel(-0.12),
                vignetting: 0.3,
                aberration: 0.0006,
                droplets: 14,
                smudges: 0,
                defocus: 0.0,
                exposure_stops: 0.0,
                contrast: 1.3,
                saturation: 1.3,
                shutter_s: 1.5 * shutter_s,
                noise: 1.4 * dark,
                white_balance: neutral(),
                sharpening: 0.5,
                jpeg_quality: Some(60),
                clock: Some(clock),
            },
            CameraLookChoice::Random => {
                let faults = CameraFaults::draw(&mut random.fork(FAULTS));
                let mut picture = random.fork(PICTURE);
                let [contrast, saturation] = [CONTRAST, SATURATION].map(|[low, high]| picture.range_f32(low, high));
                let mut share = |chance: f32| random.f32() < chance;
                let (bent, recorded, stamped) = (share(0.7), share(0.75), share(0.6));
                let mut within = |low: f32, high: f32| random.range_f32(low, high);
                Self {
                    distortion: Distortion::barrel(if bent { -within(0.02, 0.22) } else { 0.0 }),
                    vignetting: within(0.0, 0.5),
                    aberration: within(0.0, 0.0014),
                    droplets: (within(-30.0, 60.0).max(0.0)) as u32,
                    smudges: faults.smudges,
                    defocus: faults.defocus,
                    exposure_stops: faults.exposure_stops,
                    contrast,
                    saturation,
                    shutter_s: within(0.5, 2.0) * shutter_s,
                    noise: within(0.3, 3.0) * dark,
                    white_balance: neutral(),
                    sharpening: within(0.0, 1.0),
                    jpeg_quality: recorded.then(|| within(30.0, 92.0) as u8),
                    clock: stamped.then_some(clock),
                }
            }
        }
    }

    /// The look with a lens and a sensor that differ by chance, up to a strength of 1; a clean camera stays clean.
    #[must_use]
    pub fn randomised(self, strength: f32, random: &mut Stream) -> Self {
        if self.is_clean() {
            return self;
        }
        let mut within = |low: f32, high: f32| random.range_f32(low, high) * strength;
        let k1 = (self.distortion.k1 - within(0.0, 0.16)).max(STRONGEST_BARREL.min(self.distortion.k1));
        let [warm, green] = [within(-0.3, 0.3), within(-0.12, 0.12)];
        Self {
            distortion: Distortion::barrel(k1),
            vignetting: (self.vignetting + within(0.0, 0.35)).min(0.6),
            noise: self.noise * math::exp2(within(-1.0, 1.6)),
            white_balance: [warm, green, -warm].map(math::exp2),
            ..self
        }
    }

    /// Whether it has no effect.
    pub fn is_clean(&self) -> bool {
        *self == Self::CLEAN
    }
}

impl Default for CameraLook {
    fn default() -> Self {
        Self::CLEAN
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn barrels_are_monotone_and_invertible() {
        for k1 in [0.0f32, -0.02, -0.12, -0.22, -0.3] {
            let lens = Distortion::barrel(k1);
            let mut before = -1.0;
            for i in 0..200 {
                let r = i as f32 * 0.008;
                let bent = lens.distort(Vec2::new(0.6 * r, -0.8 * r));
                assert!(bent.length() > before, "{k1} folds at {r}");
                before = bent.length();
                let back = lens.undistort(bent);
                assert!((back.length() - r).abs() < 2e-5, "{k1} at {r}: {back}");
            }
        }
    }

    #[test]
    fn looks_differ_from_camera_to_camera() {
        let clock = RecorderClock::new(TimeOfDay::Night, None, &mut Stream::named(1, "clock", &[]));
        let look = |n| {
            CameraLook::new(
                CameraLookChoice::Random,
                TimeOfDay::Night,
                clock,
                &mut Stream::named(1, "camera look", &[n]),
            )
        };
        assert_ne!(look(0), look(1));
        assert_eq!(look(2), look(2));
        let natural =
            CameraLook::new(CameraLookChoice::Natural, TimeOfDay::Night, clock, &mut Stream::named(1, "", &[]));
        assert!(natural.shutter_s > 0.01 && natural.noise > 0.0 && natural.distortion == Distortion::NONE);
        assert!(
            CameraLook::new(CameraLookChoice::Clean, TimeOfDay::Night, clock, &mut Stream::named(1, "", &[]))
                .is_clean()
        );
    }
}
