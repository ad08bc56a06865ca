//! `frames.jsonl`: a line a frame, signals that count down to their changes, a sun that stands where its angles say.

use super::report::Finding;
use crate::{Recipe, VideoLayout, read_lines};
use endless_annotate::{ClassCounts, LineCounts, SceneFrame, SignalRecord, SunState};
use endless_world::math::f64::sin_cos;
use endless_world::{ConditionChange, SceneSettings};

/// Times are written to the microsecond.
const ROUNDING_S: f64 = 2e-6;
/// No signal shows anything for a shorter time.
const SHORTEST_PHASE_S: f64 = 0.5;

/// What is wrong with a video's frames, where the simulator knew them.
pub(super) fn check_frames(video: &VideoLayout, settings: &SceneSettings, recipe: &Recipe) -> Vec<Finding> {
    let path = video.frames();
    if !path.is_file() {
        return Vec::new();
    }
    let lines: Vec<SceneFrame> = match read_lines(&path) {
        Ok(lines) => lines,
        Err(error) => return vec![error.into()],
    };
    let mut problems = Vec::new();
    if lines.len() != recipe.frames() as usize {
        problems.push(format!("has {} lines for {} frames", lines.len(), recipe.frames()));
    }
    for (line, frame) in lines.iter().zip(0..) {
        if line.frame != frame || (line.time_s - f64::from(frame) / recipe.fps).abs() > 1e-6 {
            problems.push(format!("line {} is of frame {} at {} s", frame + 1, line.frame, line.time_s));
        }
        if !is_of_scene(line, settings) {
            problems.push(format!("frame {frame} has the weather of another scene"));
        }
        if !stands_so(&line.light.sun) {
            problems.push(format!("frame {frame}: the sun does not stand where its angles say"));
        }
    }
    problems.extend(lines.windows(2).filter_map(|pair| signal_problem(&pair[0], &pair[1])));
    problems.extend(lines.windows(2).filter_map(|pair| counting_problem(&pair[0], &pair[1])));
    let named = |line: &SceneFrame| line.happenings.counting_lines.iter().map(|l| l.name.clone()).collect::<Vec<_>>();
    let asked: Vec<_> =
        recipe.counting_lines.iter().filter(|l| l.map == settings.map).map(|l| l.name.clone()).collect();
    if let Some(line) = lines.iter().find(|line| named(line) != asked) {
        problems.push(format!("frame {}: does not count at the lines of the recipe", line.frame));
    }
    problems.into_iter().map(|problem| Finding::new(&path, problem)).collect()
}

/// Whether a line has the names of a scene's condition, or of that to which it changes.
fn is_of_scene(line: &SceneFrame, settings: &SceneSettings) -> bool {
    let SceneSettings { weather, time_of_day, changing_to, .. } = settings;
    let to = changing_to.unwrap_or(ConditionChange { weather: *weather, time_of_day: *time_of_day });
    [*weather, to.weather].contains(&line.weather.name)
        && [*time_of_day, to.time_of_day].contains(&line.light.time_of_day)
}

fn stands_so(sun: &SunState) -> bool {
    let ((sin_azimuth, cos_azimuth), (sin_altitude, cos_altitude)) =
        (sin_cos(sun.azimuth_rad), sin_cos(sun.altitude_rad));
    let direction = [cos_azimuth * cos_altitude, sin_azimuth * cos_altitude, sin_altitude];
    let same = direction.iter().zip(sun.direction).all(|(a, b)| (a - b).abs() < 1e-5);
    same && sun.up == (sun.altitude_rad > 0.0)
}

/// From a frame to the next, a signal counts down, or changes to what was announced.
fn signal_problem(before: &SceneFrame, after: &SceneFrame) -> Option<String> {
    if before.signals.len() != after.signals.len() {
        return Some(format!("frame {}: has another number of signals than the one before", after.frame));
    }
    let passed_s = after.time_s - before.time_s;
    let wrong = before.signals.iter().zip(&after.signals).find(|(b, a)| !follows(b, a, passed_s))?;
    Some(format!("frame {}: signal {} does not follow from the frame before", after.frame, wrong.1.id.0))
}

/// Counts never fall.
fn counting_problem(before: &SceneFrame, after: &SceneFrame) -> Option<String> {
    let less = |before: &ClassCounts, after: &ClassCounts| {
        before.iter().any(|(class, count)| after.get(class).copied().unwrap_or(0) < *count)
    };
    let lines = before.happenings.counting_lines.iter().zip(&after.happenings.counting_lines);
    let fell = |(b, a): &(&LineCounts, &LineCounts)| less(&b.to_left, &a.to_left) || less(&b.to_right, &a.to_right);
    let (line, _) = lines.into_iter().find(fell)?;
    Some(format!("frame {}: fewer have passed {} than in the frame before", after.frame, line.name))
}

fn follows(before: &SignalRecord, after: &SignalRecord, passed_s: f64) -> bool {
    let same_group = before.id == after.id;
    let (Some(remaining_s), Some(next)) = (before.remaining_s, before.next) else {
        return same_group && before == after;
    };
    let left_s = remaining_s - passed_s;
    let counts_down = after.aspect == before.aspect
        && after.next == Some(next)
        && after.remaining_s.is_some_and(|now| (now - left_s).abs() < ROUNDING_S);
    // Where frames are far apart it may have changed more than once.
    let changed = after.aspect == next || passed_s > SHORTEST_PHASE_S;
    same_group
        && match left_s {
            left_s if left_s > ROUNDING_S => counts_down,
            left_s if left_s < -ROUNDING_S => changed,
            _ => counts_down || changed,
        }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{SignalAspect, SignalId};

    fn record(aspect: SignalAspect, remaining_s: f64, next: SignalAspect) -> SignalRecord {
        SignalRecord::new(SignalId(3), aspect, Some((remaining_s, next)))
    }

    #[test]
    fn a_signal_counts_down_and_changes_to_what_was_announced() {
        use SignalAspect::{Green, Red, Yellow};
        let before = record(Green, 0.15, Yellow);
        assert!(follows(&before, &record(Green, 0.05, Yellow), 0.1));
        assert!(follows(&before, &record(Yellow, 2.95, Red), 0.2));
        for (wrong, passed_s) in [
            (record(Green, 0.06, Yellow), 0.1),
            (record(Green, 0.05, Red), 0.1),
            (record(Yellow, 3.0, Red), 0.1),
            (record(Red, 9.0, Green), 0.2),
            (record(Green, 0.05, Yellow), 0.2),
        ] {
            assert!(!follows(&before, &wrong, passed_s), "{wrong:?} after {passed_s} s");
        }
        let never = SignalRecord::new(SignalId(3), Red, None);
        assert!(follows(&never, &never, 0.1) && !follows(&never, &before, 0.1));
        assert!(!follows(&before, &SignalRecord { id: SignalId(4), ..record(Green, 0.05, Yellow) }, 0.1));
    }

    #[test]
    fn a_sun_stands_where_its_angles_say() {
        let sun = SunState::new(1.0, 0.4, 1.0);
        assert!(stands_so(&sun));
        assert!(!stands_so(&SunState { azimuth_rad: 1.1, ..sun }));
        assert!(!stands_so(&SunState { up: false, ..sun }));
    }
}
