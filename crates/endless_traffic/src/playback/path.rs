//! Where a track leads at any time: between its samples positions are interpolated along straight lines, headings the
//! short way round.

use endless_world::math::f64::{sin_cos, wrap_angle};
use endless_world::{Track, TrackPoint, TrackSample};
use glam::DVec2;

/// Instants this near to an end of a track belong to it, seconds.
const ROUNDING_S: f64 = 1e-6;
/// Speeds follow from what happens in this time before and after at least, seconds.
const LEAST_WINDOW_S: f64 = 0.1;

/// A track in the map's frame.
#[derive(Debug, Clone)]
pub(super) struct TrackPath {
    /// How far the point that it follows is ahead of the centre, metres.
    ahead_m: f64,
    pieces: Vec<Piece>,
}

/// A stretch without gaps.
#[derive(Debug, Clone)]
struct Piece {
    samples: Vec<PathSample>,
    /// Half the usual time from one sample to the next, seconds.
    window_s: f64,
}

#[derive(Debug, Clone, Copy)]
struct PathSample {
    time_s: f64,
    position: DVec2,
    height_m: Option<f64>,
    /// Without turns of a whole circle.
    yaw: f64,
    speed: Option<f64>,
    /// Way in the direction of the heading since the track began, metres: less where it goes backwards or sideways.
    rolled: f64,
    /// Way since the piece began, however it leads, metres.
    way: f64,
}

/// Where and how fast somebody is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PathPlace {
    /// Which stretch of time without gaps it is.
    pub(super) piece: usize,
    /// Of the centre, metres.
    pub(super) centre: DVec2,
    /// As the file has it, metres.
    pub(super) height_m: Option<f64>,
    /// Radians; may exceed a whole circle.
    pub(super) yaw: f64,
    /// Forward, m/s.
    pub(super) speed: f64,
    /// Of the centre, m/s.
    pub(super) velocity: DVec2,
    /// Change of the forward speed, m/s².
    pub(super) acceleration: f64,
    /// To the left, rad/s.
    pub(super) turning: f64,
    /// Way in the direction of the heading since the track began, metres.
    pub(super) rolled: f64,
}

impl TrackPath {
    /// Of somebody of this length (metres), on a map whose origin has this position in the file.
    pub(super) fn new(track: &Track, offset: DVec2, length_m: f64) -> Self {
        let mut rolled = 0.0;
        let pieces = track.pieces.iter().filter(|piece| !piece.is_empty()).map(|samples| {
            let piece = Piece::new(samples, offset, rolled);
            rolled = piece.samples.last().map_or(rolled, |last| last.rolled);
            piece
        });
        let ahead_m = if track.point == TrackPoint::Front { 0.5 * length_m } else { 0.0 };
        Self { ahead_m, pieces: pieces.collect() }
    }

    /// Where they are at a time (seconds, on the file's clock); `None` while they are not there.
    pub(super) fn at(&self, time_s: f64) -> Option<PathPlace> {
        let number = self.pieces.partition_point(|piece| piece.ends().1 < time_s - ROUNDING_S);
        let piece = self.pieces.get(number).filter(|piece| piece.ends().0 <= time_s + ROUNDING_S)?;
        let here = piece.at(time_s);
        let [before, after] = [-1.0, 1.0].map(|side| piece.at(time_s + side * piece.window_s));
        let rate =
            |change: f64| if after.time_s > before.time_s { change / (after.time_s - before.time_s) } else { 0.0 };
        let centre = |sample: &PathSample| sample.position - heading(sample.yaw) * self.ahead_m;
        let way = centre(&after) - centre(&before);
        Some(PathPlace {
            piece: number,
            centre: centre(&here),
            height_m: here.height_m,
            yaw: here.yaw,
            speed: piece.speed(time_s),
            velocity: DVec2::new(rate(way.x), rate(way.y)),
            acceleration: rate(piece.speed(after.time_s) - piece.speed(before.time_s)),
            turning: rate(after.yaw - before.yaw),
            rolled: here.rolled,
        })
    }

    /// How far the heading turns to the left, radians, within so many seconds or so many metres from a time on, whichever
    /// is longer; 0 while they are not there.
    pub(super) fn turn_ahead(&self, time_s: f64, within_s: f64, within_m: f64) -> f64 {
        let Some(PathPlace { piece, .. }) = self.at(time_s) else { return 0.0 };
        let piece = &self.pieces[piece];
        let here = piece.at(time_s);
        let there = piece.samples.partition_point(|sample| sample.way < here.way + within_m);
        let arrival_s = piece.samples.get(there).map_or(f64::INFINITY, |sample| sample.time_s);
        piece.at(arrival_s.max(time_s + within_s)).yaw - here.yaw
    }
}

impl Piece {
    fn new(samples: &[TrackSample], offset: DVec2, rolled: f64) -> Self {
        let mut kept: Vec<PathSample> = Vec::with_capacity(samples.len());
        for sample in samples {
            let mut next = PathSample {
                time_s: sample.time_s,
                position: sample.position - offset,
                height_m: sample.height_m,
                yaw: wrap_angle(sample.yaw_rad),
                speed: sample.speed_mps,
                rolled,
                way: 0.0,
            };
            if let Some(last) = kept.last() {
                let way = next.position - last.position;
                next.yaw = last.yaw + wrap_angle(next.yaw - last.yaw);
                next.rolled = last.rolled + way.dot(heading(0.5 * (last.yaw + next.yaw)));
                next.way = last.way + way.length();
            }
            kept.push(next);
        }
        let steps = kept.len().saturating_sub(1).max(1) as f64;
        let lasts_s = samples.last().zip(samples.first()).map_or(0.0, |(last, first)| last.time_s - first.time_s);
        Self { samples: kept, window_s: (0.5 * lasts_s / steps).max(LEAST_WINDOW_S) }
    }

    fn ends(&self) -> (f64, f64) {
        (self.samples[0].time_s, self.samples[self.samples.len() - 1].time_s)
    }

    /// Between samples, and the nearest beyond the ends.
    fn at(&self, time_s: f64) -> PathSample {
        let next = self.samples.partition_point(|sample| sample.time_s <= time_s);
        let Some(last) = next.checked_sub(1).map(|last| &self.samples[last]) else { return self.samples[0] };
        let Some(next) = self.samples.get(next) else { return *last };
        let share = (time_s - last.time_s) / (next.time_s - last.time_s);
        let between = |a: f64, b: f64| a + (b - a) * share;
        let known = |a: Option<f64>, b: Option<f64>| a.zip(b).map(|(a, b)| between(a, b)).or(a);
        PathSample {
            time_s,
            position: last.position.lerp(next.position, share),
            height_m: known(last.height_m, next.height_m),
            yaw: between(last.yaw, next.yaw),
            speed: known(last.speed, next.speed),
            rolled: between(last.rolled, next.rolled),
            way: between(last.way, next.way),
        }
    }

    /// Forward speed: as the file has it, else by the way around this time.
    fn speed(&self, time_s: f64) -> f64 {
        self.at(time_s).speed.unwrap_or_else(|| {
            let [before, after] = [-1.0, 1.0].map(|side| self.at(time_s + side * self.window_s));
            let lasts_s = after.time_s - before.time_s;
            if lasts_s > 0.0 { (after.rolled - before.rolled) / lasts_s } else { 0.0 }
        })
    }
}

/// The unit vector of a heading.
pub(super) fn heading(yaw: f64) -> DVec2 {
    let (sin, cos) = sin_cos(yaw);
    DVec2::new(cos, sin)
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::ObjectClass;
    use proptest::prelude::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn track(point: TrackPoint, pieces: &[&[(f64, f64, f64, f64)]]) -> Track {
        let sample = |&(time_s, x, y, yaw_rad): &(f64, f64, f64, f64)| TrackSample {
            time_s,
            position: DVec2::new(x, y),
            height_m: None,
            yaw_rad,
            speed_mps: None,
        };
        Track {
            name: "t".into(),
            kind: "car".into(),
            class: ObjectClass::Car,
            length_m: None,
            point,
            pieces: pieces.iter().map(|piece| piece.iter().map(sample).collect()).collect(),
        }
    }

    #[test]
    fn a_front_bumper_is_half_a_length_ahead_of_the_centre() {
        let north = track(TrackPoint::Front, &[&[(0.0, 110.0, 220.0, FRAC_PI_2), (1.0, 110.0, 230.0, FRAC_PI_2)]]);
        let path = TrackPath::new(&north, DVec2::new(100.0, 200.0), 4.0);
        let place = path.at(0.5).expect("there");
        assert!(place.centre.distance(DVec2::new(10.0, 23.0)) < 1e-9, "{place:?}");
        assert!((place.speed - 10.0).abs() < 1e-9 && (place.rolled - 5.0).abs() < 1e-9, "{place:?}");
        assert!(place.velocity.distance(DVec2::new(0.0, 10.0)) < 1e-9 && place.acceleration.abs() < 1e-9);
    }

    #[test]
    fn nobody_is_there_in_gaps_nor_before_and_after() {
        let path = TrackPath::new(
            &track(TrackPoint::Centre, &[&[(1.0, 0.0, 0.0, 0.0), (2.0, 3.0, 0.0, 0.0)], &[(9.0, 30.0, 0.0, 0.0)]]),
            DVec2::ZERO,
            4.0,
        );
        for (time_s, piece) in [(0.9, None), (1.0, Some(0)), (2.0, Some(0)), (2.1, None), (9.0, Some(1)), (9.1, None)] {
            assert_eq!(path.at(time_s).map(|place| place.piece), piece, "at {time_s} s");
        }
        assert_eq!(path.at(9.0).map(|place| place.speed), Some(0.0), "nothing is known of it");
    }

    #[test]
    fn backwards_is_a_negative_speed_and_sideways_none() {
        let back = track(TrackPoint::Centre, &[&[(0.0, 0.0, 0.0, PI), (1.0, 2.0, 0.0, PI), (2.0, 2.0, 3.0, PI)]]);
        let path = TrackPath::new(&back, DVec2::ZERO, 4.0);
        assert!((path.at(0.5).expect("there").speed + 2.0).abs() < 1e-9);
        assert!((path.at(2.0).expect("there").rolled + 2.0).abs() < 1e-9);
    }

    proptest! {
        #[test]
        fn headings_turn_the_short_way(from in -PI..PI, turn in -3.1..3.1f64, share in 0.0..1.0f64) {
            let bend = track(TrackPoint::Centre, &[&[(0.0, 0.0, 0.0, from), (1.0, 1.0, 0.0, from + turn)]]);
            let path = TrackPath::new(&bend, DVec2::ZERO, 4.0);
            let yaw = path.at(share).expect("there").yaw;
            prop_assert!(wrap_angle(yaw - from - share * turn).abs() < 1e-9);
            prop_assert!((path.turn_ahead(share, 5.0, 0.0) - (1.0 - share) * turn).abs() < 1e-9);
        }
    }
}
