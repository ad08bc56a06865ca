//! An event camera (dynamic vision sensor), made of the frames of an ordinary one.
//!
//! The model is that of ESIM (Rebecq, Gehrig and Scaramuzza, *ESIM: an Open Event Camera Simulator*, CoRL 2018), with the
//! parameters of CARLA's `sensor.camera.dvs`. The level of a pixel is the logarithm of its intensity, ln(ε + I / 255) with
//! I = 0.2989 R + 0.587 G + 0.114 B of the 8-bit picture. Between two frames it changes linearly. Each time it has gone up or
//! down by a threshold from the pixel's reference level, the pixel gives an event, and the reference level follows by
//! that threshold. So the events of a pixel, each times its threshold, add up to the change of its level to within one
//! threshold.
//!
//! It departs from CARLA in one point: where a threshold that is drawn anew turns out smaller than the difference that a
//! pixel already has, it gives its event at once, and does not stay silent until the level has come back.

use endless_world::math::f64::ln;
use endless_world::{EventCameraSettings, Image, ImageSize, PixelEvent, Stream};
use rayon::prelude::*;

/// An event camera; it is shown frames in order.
#[derive(Debug, Clone)]
pub struct EventCamera {
    settings: EventCameraSettings,
    size: ImageSize,
    seed: u64,
    frame: u64,
    time_ns: i64,
    pixels: Vec<PixelState>,
}

/// What a pixel remembers.
#[derive(Debug, Clone, Copy)]
struct PixelState {
    rgb: [u8; 3],
    level: f64,
    reference: f64,
    last_event_ns: i64,
}

/// Before any event.
const NEVER_NS: i64 = i64::MIN;

impl EventCamera {
    /// With nothing seen yet.
    ///
    /// # Panics
    /// If a side is longer than 65,536 pixels: events could not tell where they are.
    pub fn new(settings: &EventCameraSettings, size: ImageSize, seed: u64) -> Self {
        assert!(size.width <= 1 << 16 && size.height <= 1 << 16, "an event camera of {size:?} is too large");
        Self { settings: *settings, size, seed, frame: 0, time_ns: 0, pixels: Vec::new() }
    }

    /// The events since the frame before, by time, then row, then column; none at the first. Their times, µs, are after
    /// that frame's (or just there) and not after `time_us`. All threads of the pool work; the result does not depend on
    /// how many they are.
    ///
    /// # Panics
    /// If the picture has another size than the camera, or is not later than the one before.
    pub fn observe(&mut self, time_us: i64, image: &Image<[u8; 3]>) -> Vec<PixelEvent> {
        assert_eq!(image.size, self.size, "the picture of an event camera");
        let now_ns = time_us * 1000;
        let frame = self.frame;
        self.frame += 1;
        let before_ns = std::mem::replace(&mut self.time_ns, now_ns);
        let settings = &self.settings;
        if self.pixels.is_empty() {
            self.pixels = image.data.par_iter().map(|&rgb| PixelState::new(rgb, settings)).collect();
            return Vec::new();
        }
        assert!(now_ns > before_ns, "frames of an event camera come in order");
        let (width, seed) = (self.size.width as usize, self.seed);
        let rows = self.pixels.par_chunks_mut(width).zip(image.data.par_chunks(width)).enumerate();
        let mut events: Vec<PixelEvent> = rows
            .flat_map_iter(|(y, (states, picture))| {
                let mut events = Vec::new();
                for (x, (state, &rgb)) in states.iter_mut().zip(picture).enumerate() {
                    if state.rgb == rgb {
                        continue;
                    }
                    let noise = || Stream::named(seed, "event_camera", &[frame, (y * width + x) as u64]).normal();
                    state.change(rgb, settings, [before_ns, now_ns], noise, |time_ns, polarity| {
                        let t_us = time_ns.div_euclid(1000);
                        events.push(PixelEvent { t_us, y: y as u16, x: x as u16, polarity });
                    });
                }
                events
            })
            .collect();
        // Equal events cannot be told apart, so that an unstable order is as good.
        events.par_sort_unstable();
        events
    }
}

impl PixelState {
    fn new(rgb: [u8; 3], settings: &EventCameraSettings) -> Self {
        let level = level(rgb, settings);
        Self { rgb, level, reference: level, last_event_ns: NEVER_NS }
    }

    /// Goes to another colour within an interval, and tells its events in order.
    fn change(
        &mut self,
        rgb: [u8; 3],
        settings: &EventCameraSettings,
        [from_ns, to_ns]: [i64; 2],
        noise: impl FnOnce() -> f64,
        mut event: impl FnMut(i64, bool),
    ) {
        let (from, to) = (self.level, level(rgb, settings));
        (self.rgb, self.level) = (rgb, to);
        let polarity = to > from;
        let (sign, threshold, sigma) = if polarity {
            (1.0, settings.positive_threshold, settings.sigma_positive_threshold)
        } else {
            (-1.0, settings.negative_threshold, settings.sigma_negative_threshold)
        };
        let noise = if sigma > 0.0 { sigma * noise() } else { 0.0 };
        let threshold = (threshold + noise).max(EventCameraSettings::LEAST_THRESHOLD);
        while sign * (to - self.reference) >= threshold {
            self.reference += sign * threshold;
            let share = ((self.reference - from) / (to - from)).clamp(0.0, 1.0);
            let time_ns = from_ns + (share * (to_ns - from_ns) as f64) as i64;
            let rested = time_ns.saturating_sub(self.last_event_ns);
            if self.last_event_ns == NEVER_NS || rested as u64 >= settings.refractory_period_ns {
                self.last_event_ns = time_ns;
                event(time_ns, polarity);
            }
        }
    }
}

fn level([red, green, blue]: [u8; 3], settings: &EventCameraSettings) -> f64 {
    let intensity = 0.2989 * f64::from(red) + 0.587 * f64::from(green) + 0.114 * f64::from(blue);
    if settings.use_log { ln(settings.log_eps + intensity / 255.0) } else { intensity }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SIZE: ImageSize = ImageSize { width: 7, height: 5 };

    fn images() -> impl Strategy<Value = Vec<Image<[u8; 3]>>> {
        let image = prop::collection::vec(any::<[u8; 3]>(), SIZE.pixels()).prop_map(|data| Image { size: SIZE, data });
        prop::collection::vec(image, 2..8)
    }

    fn film(settings: &EventCameraSettings, images: &[Image<[u8; 3]>]) -> Vec<Vec<PixelEvent>> {
        let mut camera = EventCamera::new(settings, SIZE, 3);
        (0..).zip(images).map(|(i, image)| camera.observe(i * 1_000, image)).collect()
    }

    proptest! {
        #[test]
        fn events_add_up_to_the_change_of_level(
            images in images(), up in 0.05..0.6f64, down in 0.05..0.6f64, use_log in any::<bool>(),
        ) {
            let settings = EventCameraSettings {
                positive_threshold: up, negative_threshold: down, use_log, ..EventCameraSettings::default()
            };
            let mut sums = vec![0.0; SIZE.pixels()];
            for (i, (events, image)) in film(&settings, &images).iter().zip(&images).enumerate() {
                let after_us = (i as i64 - 1).max(0) * 1000;
                prop_assert!(events.iter().all(|e| (after_us..=i as i64 * 1000).contains(&e.t_us)));
                prop_assert!(events.is_sorted_by_key(|e| (e.t_us, e.y, e.x)));
                for event in events {
                    let pixel = usize::from(event.y) * SIZE.width as usize + usize::from(event.x);
                    sums[pixel] += if event.polarity { up } else { -down };
                }
                for (pixel, sum) in sums.iter().enumerate() {
                    let change = level(image.data[pixel], &settings) - level(images[0].data[pixel], &settings);
                    prop_assert!(change - sum < up + 1e-9 && sum - change < down + 1e-9, "{change} {sum}");
                }
            }
        }

        #[test]
        fn the_pool_does_not_matter(images in images()) {
            let settings = EventCameraSettings { sigma_positive_threshold: 0.1, ..EventCameraSettings::default() };
            let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            let [one, four] = [1, 4].map(|threads| pool(threads).install(|| film(&settings, &images)));
            prop_assert_eq!(one, four);
        }

        #[test]
        fn tired_pixels_rest(images in images(), refractory_us in 1..3000u64) {
            let tireless = EventCameraSettings::default();
            let settings = EventCameraSettings { refractory_period_ns: refractory_us * 1000, ..tireless };
            let (all, rested) = (film(&tireless, &images).concat(), film(&settings, &images).concat());
            prop_assert!(rested.len() <= all.len() && rested.iter().all(|e| all.contains(e)));
            let mut last = vec![None; SIZE.pixels()];
            for event in rested {
                let pixel = usize::from(event.y) * SIZE.width as usize + usize::from(event.x);
                // Times are cut to whole microseconds.
                prop_assert!(last[pixel].is_none_or(|then| event.t_us - then >= refractory_us as i64 - 1));
                last[pixel] = Some(event.t_us);
            }
        }
    }

    #[test]
    fn times_are_linear_in_the_level() {
        // From black to white is ln(1.001 / 0.001) = 6.909: 23 thresholds of 0.3, the last after 99.9 % of the way.
        let pictures = [0, 255].map(|grey| Image::filled(SIZE, [grey; 3]));
        let events = film(&EventCameraSettings::default(), &pictures).concat();
        let of_one: Vec<PixelEvent> = events.into_iter().filter(|e| (e.x, e.y) == (2, 1)).collect();
        assert_eq!(of_one.len(), 23);
        assert!(of_one.iter().all(|e| e.polarity));
        for (i, event) in (1..).zip(&of_one) {
            assert!((event.t_us as f64 - f64::from(i) * 300.0 / 6.9087).abs() < 1.5, "{event:?}");
        }
    }

    #[test]
    fn thresholds_vary_as_asked() {
        // White to black through 1 % noise: not all pixels give the last events at the same time.
        let pictures = [255, 0].map(|grey| Image::filled(SIZE, [grey; 3]));
        let noisy = EventCameraSettings { sigma_negative_threshold: 0.02, ..EventCameraSettings::default() };
        let first = |settings: &EventCameraSettings| {
            let events = film(settings, &pictures).concat();
            (0..SIZE.width as u16).map(|x| events.iter().find(|e| e.x == x).expect("one each").t_us).collect::<Vec<_>>()
        };
        let even = first(&EventCameraSettings::default());
        assert!(even.windows(2).all(|pair| pair[0] == pair[1]));
        assert!(first(&noisy).windows(2).any(|pair| pair[0] != pair[1]));
    }
}
