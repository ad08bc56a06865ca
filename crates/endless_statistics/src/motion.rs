//! Tracks and speeds.

use crate::merge::merge_fields;
use crate::scales::{SEEN_S, VEHICLE_SPEED_MPS, WALKING_SPEED_MPS};
use crate::{Histogram, Scale, Tally};
use serde::Serialize;

/// Slower than this one stands, m/s; as `stopped` in `objects.jsonl`.
pub(crate) const STANDS_MPS: f64 = 0.1;

/// How long one camera sees the objects of a class that do not stand parked for the whole video.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TrackStatistics {
    /// Tracks: an object seen by a camera is one, whatever its gaps.
    pub tracks: u64,
    /// Tracks of what stands parked for the whole video; they are in no other figure.
    pub parked_tracks: u64,
    /// Frames in which a track's object is seen.
    pub frames_seen: Tally,
    /// The same in seconds.
    pub seconds_seen: Histogram,
    /// Tracks with at least one gap.
    pub tracks_with_gaps: u64,
    /// Frames of each gap: between two in which the object is seen.
    pub gap_frames: Tally,
}

merge_fields!(TrackStatistics { tracks, parked_tracks, frames_seen, seconds_seen, tracks_with_gaps, gap_frames });

impl Default for TrackStatistics {
    fn default() -> Self {
        Self {
            tracks: 0,
            parked_tracks: 0,
            frames_seen: Tally::default(),
            seconds_seen: Histogram::new(&SEEN_S),
            tracks_with_gaps: 0,
            gap_frames: Tally::default(),
        }
    }
}

/// One object seen by one camera, frame by frame.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Track {
    parked: bool,
    seen: u64,
    last: u64,
    gaps: Vec<u64>,
}

impl Track {
    /// Seen for the first time, in this frame of the camera.
    pub(crate) fn begin(frame: u64, parked: bool) -> Self {
        Self { parked, seen: 1, last: frame, gaps: Vec::new() }
    }

    /// Seen again.
    pub(crate) fn see(&mut self, frame: u64) {
        if frame <= self.last {
            return;
        }
        if frame > self.last + 1 {
            self.gaps.push(frame - self.last - 1);
        }
        self.seen += 1;
        self.last = frame;
    }
}

impl TrackStatistics {
    /// Counts a track that is over, of a camera with so many frames a second.
    pub(crate) fn add(&mut self, track: &Track, fps: f64) {
        if track.parked {
            self.parked_tracks += 1;
            return;
        }
        self.tracks += 1;
        self.frames_seen.add(track.seen);
        self.seconds_seen.add(track.seen as f64 / fps);
        self.tracks_with_gaps += u64::from(!track.gaps.is_empty());
        for gap in &track.gaps {
            self.gap_frames.add(*gap);
        }
    }
}

/// How objects of a kind move, box by box.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MotionStatistics {
    /// Boxes of those that stand parked, be it for the whole video or for a while.
    pub parked: u64,
    /// Boxes of others that stand: slower than 0.1 m/s.
    pub standing: u64,
    /// Boxes of those that move.
    pub moving: u64,
    /// Speed of those that move.
    pub speed_mps: Histogram,
}

merge_fields!(MotionStatistics { parked, standing, moving, speed_mps });

impl MotionStatistics {
    fn new(scale: &'static Scale) -> Self {
        Self { parked: 0, standing: 0, moving: 0, speed_mps: Histogram::new(scale) }
    }

    /// Counts a box.
    pub(crate) fn add(&mut self, parked: bool, speed_mps: f64) {
        if parked {
            self.parked += 1;
        } else if speed_mps < STANDS_MPS {
            self.standing += 1;
        } else {
            self.moving += 1;
            self.speed_mps.add(speed_mps);
        }
    }
}

/// How those move that are seen.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Motions {
    /// Vehicles, two-wheelers among them; their riders are not counted again.
    pub vehicles: MotionStatistics,
    /// People on foot.
    pub people: MotionStatistics,
}

merge_fields!(Motions { vehicles, people });

impl Default for Motions {
    fn default() -> Self {
        Self { vehicles: MotionStatistics::new(&VEHICLE_SPEED_MPS), people: MotionStatistics::new(&WALKING_SPEED_MPS) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_are_what_lies_between() {
        let mut track = Track::begin(3, false);
        for frame in [4, 4, 7, 8, 20] {
            track.see(frame);
        }
        let mut tracks = TrackStatistics::default();
        tracks.add(&track, 10.0);
        tracks.add(&Track::begin(0, true), 10.0);
        assert_eq!((tracks.tracks, tracks.parked_tracks, tracks.tracks_with_gaps), (1, 1, 1));
        assert_eq!(tracks.frames_seen.iter().collect::<Vec<_>>(), [(5, 1)]);
        assert_eq!(tracks.gap_frames.iter().collect::<Vec<_>>(), [(2, 1), (11, 1)]);
        assert_eq!((tracks.seconds_seen.mean(), tracks.seconds_seen.counts()[2]), (Some(0.5), 1));
    }

    #[test]
    fn who_stands_has_no_speed() {
        let mut vehicles = Motions::default().vehicles;
        vehicles.add(true, 0.0);
        vehicles.add(false, 0.099);
        vehicles.add(false, 0.1);
        vehicles.add(false, 13.0);
        assert_eq!((vehicles.parked, vehicles.standing, vehicles.moving), (1, 1, 2));
        assert_eq!(vehicles.speed_mps.mean(), Some(6.55));
    }
}
