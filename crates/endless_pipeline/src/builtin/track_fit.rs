//! Whether a file of tracks fits a recipe.

use crate::{SimulatorError, TrackFileSummary};
use endless_dataset::Recipe;
use endless_interchange::TrackFile;
use endless_road::RoadNetwork;
use endless_traffic::PlayedTracks;
use endless_world::{ObjectClass, TrackPlayback};
use glam::DVec2;

/// Names that a note lists.
const LISTED: usize = 3;

/// What a recipe needs to know of a file.
pub(super) fn summary(file: &TrackFile) -> TrackFileSummary {
    let on_foot = |class| class == ObjectClass::Pedestrian;
    TrackFileSummary {
        content_hash: file.content_hash.clone(),
        begin_s: file.begin_s,
        end_s: file.end_s,
        vehicles: file.tracks.iter().any(|track| !on_foot(track.class)),
        people: file.tracks.iter().any(|track| on_foot(track.class)),
    }
}

/// What of a file is guessed or left out on a map, a line each.
///
/// # Errors
/// [`SimulatorError::TracksOffMap`] when all of it is left out.
pub(super) fn notes(
    file: &TrackFile,
    recipe: &Recipe,
    map: &str,
    network: &RoadNetwork,
) -> Result<Vec<String>, SimulatorError> {
    let begin_s = recipe.traffic_begin.unwrap_or(file.begin_s);
    let playback = TrackPlayback { begin_s, offset_m: recipe.traffic_offset, seed: recipe.seed };
    let duration_s = f64::from(recipe.frames()) / recipe.fps;
    let fit = PlayedTracks { tracks: &file.tracks, playback, duration_s }.fit(network);
    if fit.tracks > 0 && !fit.any_on_map {
        let points = || network.lanes.iter().flat_map(|lane| lane.centerline.points()).map(|point| point.truncate());
        let [low, high] = fit.bounds.map(place);
        let road_low = place(points().fold(DVec2::INFINITY, DVec2::min));
        let road_high = place(points().fold(DVec2::NEG_INFINITY, DVec2::max));
        let places = format!("tracks lie from {low} to {high}, roads from {road_low} to {road_high}");
        return Err(SimulatorError::TracksOffMap { map: map.to_owned(), places });
    }
    let mut notes = file.notes.clone();
    if !fit.leave.is_empty() {
        let listed: Vec<String> = fit.leave.iter().take(LISTED).map(|name| format!("'{}'", plain(name))).collect();
        let more = if fit.leave.len() > LISTED { ", …" } else { "" };
        notes.push(format!(
            "{} of {} tracks leave the map ({}{more}): absent where no road or sidewalk is within 30 m",
            fit.leave.len(),
            fit.tracks,
            listed.join(", ")
        ));
    }
    let early_s = begin_s + duration_s - file.end_s;
    // The last frame is one before the end.
    if early_s > 1.0 / recipe.fps + 1e-6 {
        notes.push(format!("the tracks end {early_s:.1} s before the videos do: nobody of them is there afterwards"));
    }
    if begin_s < file.begin_s {
        let late_s = file.begin_s - begin_s;
        notes.push(format!("the tracks begin {late_s:.1} s after the videos do: nobody of them is there before"));
    }
    Ok(notes)
}

fn place(at: DVec2) -> String {
    format!("{:.1},{:.1}", at.x, at.y)
}

/// Names come from a file.
fn plain(name: &str) -> String {
    name.chars().filter(|c| !c.is_control()).take(40).collect()
}
