//! What happens in a scene, whatever the cameras see of it: relations, events, and who passes counting lines.

use crate::{CountingLine, Event, EventDetector, LineCounter, LineCounts, Relation, RoadFacts, relations};
use endless_world::WorldState;
use serde::{Deserialize, Serialize};

/// What happens in one frame, as `frames.jsonl` has it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Happenings {
    /// What holds at this instant.
    #[serde(default)]
    pub relations: Vec<Relation>,
    /// What has happened since the frame before.
    #[serde(default)]
    pub events: Vec<Event>,
    /// Who has passed each counting line of the map since the video began.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub counting_lines: Vec<LineCounts>,
}

/// Looks at world states that follow one another.
#[derive(Debug, Clone)]
pub struct SceneObserver {
    detector: EventDetector,
    counter: LineCounter,
}

impl SceneObserver {
    /// With nothing seen yet; lines are those of the scene's map.
    pub fn new(road: RoadFacts, lines: Vec<CountingLine>) -> Self {
        Self { detector: EventDetector::new(road), counter: LineCounter::new(lines) }
    }

    /// What happens in the next state.
    pub fn observe(&mut self, state: &WorldState) -> Happenings {
        Happenings {
            relations: relations(state, self.detector.road()),
            events: self.detector.observe(state),
            counting_lines: self.counter.observe(state).to_vec(),
        }
    }
}
