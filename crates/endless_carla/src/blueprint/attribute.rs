//! How attributes of blueprints are written down.

use crate::wire::{ActorAttribute, AttributeType};

/// One that may be changed: its first recommended value is its default.
pub(super) fn choice(id: &str, kind: AttributeType, recommended: &[&str]) -> ActorAttribute {
    ActorAttribute {
        id: id.to_owned(),
        kind,
        value: recommended.first().copied().unwrap_or_default().to_owned(),
        recommended_values: recommended.iter().map(|&value| value.to_owned()).collect(),
        is_modifiable: true,
        restrict_to_recommended: false,
    }
}

/// One that may have no other than the recommended values.
pub(super) fn restricted(id: &str, kind: AttributeType, recommended: &[&str]) -> ActorAttribute {
    ActorAttribute { restrict_to_recommended: true, ..choice(id, kind, recommended) }
}

/// One that may not be changed.
pub(super) fn fixed(id: &str, kind: AttributeType, value: impl Into<String>) -> ActorAttribute {
    ActorAttribute { id: id.to_owned(), kind, value: value.into(), ..ActorAttribute::default() }
}

/// A number with its default.
pub(super) fn float(id: &str, default: &str) -> ActorAttribute {
    choice(id, AttributeType::Float, &[default])
}

/// Numbers with one default.
pub(super) fn floats(ids: &[&str], default: &str) -> impl Iterator<Item = ActorAttribute> {
    ids.iter().map(move |id| float(id, default))
}

/// An integer with its default.
pub(super) fn int(id: &str, default: &str) -> ActorAttribute {
    choice(id, AttributeType::Int, &[default])
}

/// A switch with its default.
pub(super) fn switch(id: &str, default: bool) -> ActorAttribute {
    choice(id, AttributeType::Bool, &[word(default)])
}

/// Which part an actor plays; scripts put their own words.
pub(super) fn role_name(recommended: &[&str]) -> ActorAttribute {
    choice("role_name", AttributeType::String, recommended)
}

/// Simulated seconds between measurements; 0: in every frame.
pub(super) fn sensor_tick() -> ActorAttribute {
    float("sensor_tick", "0.0")
}

/// As CARLA writes it.
pub(super) const fn word(yes: bool) -> &'static str {
    if yes { "true" } else { "false" }
}
