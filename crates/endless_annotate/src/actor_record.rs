//! What stays the same of each object of a video.

use endless_world::{InstanceId, ObjectClass, Occupants, PersonAttributes, Reid, VehicleAttributes};
use serde::{Deserialize, Serialize};

/// One object of a video, seen or not: an entry of `actors.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ActorRecord {
    /// The track.
    pub id: InstanceId,
    /// Its class.
    pub class: ObjectClass,
    /// Parked for the whole video.
    pub parked: bool,
    /// The identity of its look: equal for what looks the same, in all videos of all maps.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reid: Option<Reid>,
    /// For a rider: the two-wheeler ridden.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vehicle_id: Option<InstanceId>,
    /// For a two-wheeler: who rides it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rider_id: Option<InstanceId>,
    /// For vehicles: which one it is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vehicle: Option<VehicleAttributes>,
    /// For vehicles with a cabin: who sits in it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub occupants: Option<Occupants>,
    /// For people and riders: who they are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub person: Option<PersonAttributes>,
    /// Of what plays a recorded track: the track's name in its file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub track: Option<String>,
}

impl ActorRecord {
    /// An object of which nothing else is known.
    pub fn new(id: InstanceId, class: ObjectClass, parked: bool) -> Self {
        Self {
            id,
            class,
            parked,
            reid: None,
            vehicle_id: None,
            rider_id: None,
            vehicle: None,
            occupants: None,
            person: None,
            track: None,
        }
    }
}
