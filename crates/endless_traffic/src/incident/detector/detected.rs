//! What was found, and runs of frames.

use endless_world::{IncidentKind, InstanceId};

/// An incident that was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DetectedIncident {
    /// Its kind.
    pub kind: IncidentKind,
    /// Who takes part, the one who causes it first.
    pub actors: Vec<InstanceId>,
    /// The first frame in which it happens.
    pub begin_frame: u32,
    /// The last one.
    pub end_frame: u32,
}

/// Runs of frames that are told of, with gaps of at most so many frames between.
pub(super) fn runs(frames: impl IntoIterator<Item = usize>, gap: usize) -> Vec<(usize, usize)> {
    let mut found: Vec<(usize, usize)> = Vec::new();
    for frame in frames {
        match found.last_mut() {
            Some((_, last)) if frame - *last <= gap + 1 => *last = frame,
            _ => found.push((frame, frame)),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::runs;

    #[test]
    fn frames_near_one_another_are_one_run() {
        assert_eq!(runs([2, 3, 4, 7, 8, 20], 2), [(2, 8), (20, 20)]);
        assert_eq!(runs([2, 3, 4, 7, 8, 20], 0), [(2, 4), (7, 8), (20, 20)]);
    }
}
