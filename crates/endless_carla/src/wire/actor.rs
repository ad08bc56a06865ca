//! Blueprints and actors.

use super::geometry::BoundingBox;
use super::value::{Bytes, Wire, WireError};
use super::wire_structs;
use rmpv::Value;

/// What an attribute's text stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AttributeType {
    /// `true` or `false`.
    Bool = 1,
    /// An integer.
    Int = 2,
    /// A number.
    Float = 3,
    /// Text.
    #[default]
    String = 4,
    /// `r,g,b`.
    RgbColor = 5,
}

impl Wire for AttributeType {
    fn to_value(&self) -> Value {
        Value::from(*self as u8)
    }

    fn from_value(value: &Value) -> Result<Self, WireError> {
        Ok(match u8::from_value(value)? {
            1 => Self::Bool,
            2 => Self::Int,
            3 => Self::Float,
            4 => Self::String,
            5 => Self::RgbColor,
            _ => return Err(WireError::new("the type of an attribute (1 to 5)", value)),
        })
    }
}

wire_structs! {
    /// An attribute of a blueprint.
    ActorAttribute {
        /// Its name.
        id: String = String::new(),
        /// What its text stands for.
        kind: AttributeType = AttributeType::String,
        /// Its value unless changed.
        value: String = String::new(),
        /// Values to choose from.
        recommended_values: Vec<String> = Vec::new(),
        /// Whether it may be changed.
        is_modifiable: bool = false,
        /// Whether it may have no other than the recommended values.
        restrict_to_recommended: bool = false,
    }
    /// A blueprint.
    ActorDefinition {
        /// Number in the library.
        uid: u32 = 0,
        /// Such as `vehicle.tesla.model3`.
        id: String = String::new(),
        /// Its words, with commas between them.
        tags: String = String::new(),
        /// Its attributes.
        attributes: Vec<ActorAttribute> = Vec::new(),
    }
    /// The value of an attribute.
    ActorAttributeValue {
        /// Its name.
        id: String = String::new(),
        /// What its text stands for.
        kind: AttributeType = AttributeType::String,
        /// Its value.
        value: String = String::new(),
    }
    /// What an actor is made of: a blueprint, and its attributes' values.
    ActorDescription {
        /// Number of the blueprint.
        uid: u32 = 0,
        /// Name of the blueprint.
        id: String = String::new(),
        /// In any order.
        attributes: Vec<ActorAttributeValue> = Vec::new(),
    }
    /// What stays the same of an actor.
    Actor {
        /// Never given twice in an episode.
        id: u32 = 0,
        /// Whom it is attached to; 0 for nobody.
        parent_id: u32 = 0,
        /// What it is made of.
        description: ActorDescription = ActorDescription::default(),
        /// In its own frame.
        bounding_box: BoundingBox = BoundingBox::default(),
        /// A byte each.
        semantic_tags: Bytes = Bytes::default(),
        /// Of the stream of a sensor; empty for all others.
        stream_token: Bytes = Bytes::default(),
    }
}

impl ActorDescription {
    /// The value of an attribute.
    pub fn attribute(&self, id: &str) -> Option<&str> {
        self.attributes.iter().find(|attribute| attribute.id == id).map(|attribute| attribute.value.as_str())
    }
}
