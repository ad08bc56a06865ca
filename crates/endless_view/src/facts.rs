//! What the list of videos tells of each: its classes, its events.

use crate::timeline::Timeline;
use endless_dataset::SceneRecord;
use endless_world::{IncidentKind, ObjectClass};
use serde::Serialize;
use std::collections::BTreeMap;

/// What is known of a complete video.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct VideoFacts {
    /// Objects of each class that its cameras see.
    pub(crate) objects: BTreeMap<ObjectClass, u32>,
    /// The most objects that they see at once.
    pub(crate) most_at_once: u32,
    /// What was staged.
    pub(crate) incidents: Vec<IncidentKind>,
    /// How often each thing happens.
    pub(crate) events: BTreeMap<String, u32>,
}

impl VideoFacts {
    pub(crate) fn new(timeline: &Timeline, record: Option<&SceneRecord>) -> Self {
        let mut objects = BTreeMap::new();
        for object in &timeline.objects {
            *objects.entry(object.class).or_default() += 1;
        }
        let mut events = BTreeMap::new();
        for event in &timeline.events {
            *events.entry(event.kind.clone()).or_default() += 1;
        }
        let frames = timeline.counts.first().map_or(0, Vec::len);
        let at = |frame: usize| timeline.counts.iter().map(|class| class[frame]).sum::<u32>();
        let most_at_once = (0..frames).map(at).max().unwrap_or(0);
        let incidents = record.map(|record| record.incidents.iter().map(|incident| incident.kind).collect());
        Self { objects, most_at_once, incidents: incidents.unwrap_or_default(), events }
    }
}
