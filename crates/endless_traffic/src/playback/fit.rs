//! Whether tracks lie on a map.

use super::PlayedTracks;
use super::ground::GroundIndex;
use endless_road::RoadNetwork;
use endless_world::Track;
use glam::DVec2;

/// How tracks lie on a map, during a video.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TrackFit {
    /// How many there are.
    pub tracks: usize,
    /// Names of those who are off the map at some time: further than 30 m from every lane and sidewalk, where they are
    /// not played.
    pub leave: Vec<String>,
    /// Whether somebody is on the map at some time.
    pub any_on_map: bool,
    /// Least and greatest coordinates of all, in the map's frame, metres.
    pub bounds: [DVec2; 2],
}

impl PlayedTracks<'_> {
    /// How they lie on a map.
    pub fn fit(&self, network: &RoadNetwork) -> TrackFit {
        let ground = GroundIndex::new(network);
        let bounds = [DVec2::INFINITY, DVec2::NEG_INFINITY];
        let mut fit = TrackFit { bounds, ..TrackFit::default() };
        for track in self.tracks {
            let mut places = self.places(track).peekable();
            fit.tracks += usize::from(places.peek().is_some());
            let mut leaves = false;
            for at in places {
                let on = ground.height_m(network, at, true, None).is_some();
                fit.any_on_map |= on;
                leaves |= !on;
                fit.bounds = [fit.bounds[0].min(at), fit.bounds[1].max(at)];
            }
            if leaves {
                fit.leave.push(track.name.clone());
            }
        }
        fit
    }

    /// Where a track has samples during the video.
    fn places<'t>(&self, track: &'t Track) -> impl Iterator<Item = DVec2> + use<'t> {
        let (begin_s, end_s) = (self.playback.begin_s, self.playback.begin_s + self.duration_s);
        let offset = DVec2::from_array(self.playback.offset_m);
        let samples = track.pieces.iter().flatten();
        samples
            .filter(move |sample| (begin_s..=end_s).contains(&sample.time_s))
            .map(move |sample| sample.position - offset)
    }
}
