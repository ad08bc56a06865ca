//! One blueprint.

use super::attribute::choice;
use super::kind::BlueprintKind;
use crate::wire::{ActorAttribute, ActorAttributeValue, ActorDefinition, ActorDescription, AttributeType, BoundingBox};
use endless_world::ClassTag;

/// A blueprint, and what it means here.
#[derive(Debug, Clone, PartialEq)]
pub struct Blueprint {
    /// As clients get it.
    pub definition: ActorDefinition,
    /// What it makes.
    pub kind: BlueprintKind,
    /// Of its actors, in their own frame: CARLA's figures of vehicles and walkers, those of our bodies of props.
    pub bounding_box: BoundingBox,
    /// CARLA's semantic labels of its actors.
    pub semantic_tags: Vec<u8>,
}

impl Blueprint {
    /// Without a number yet. The words of the id are its tags, and all have a name for ROS.
    pub(super) fn new(
        id: &str,
        mut attributes: Vec<ActorAttribute>,
        kind: BlueprintKind,
        bounding_box: BoundingBox,
        semantic_tags: Vec<ClassTag>,
    ) -> Self {
        let semantic_tags = semantic_tags.into_iter().map(ClassTag::value).collect();
        attributes.push(choice("ros_name", AttributeType::String, &[id]));
        let definition = ActorDefinition { uid: 0, id: id.to_owned(), tags: id.replace('.', ","), attributes };
        Self { definition, kind, bounding_box, semantic_tags }
    }

    /// With all defaults: the description of an actor that the server itself makes.
    pub fn description(&self) -> ActorDescription {
        let values = self.definition.attributes.iter().map(|attribute| ActorAttributeValue {
            id: attribute.id.clone(),
            kind: attribute.kind,
            value: attribute.value.clone(),
        });
        ActorDescription { uid: self.definition.uid, id: self.definition.id.clone(), attributes: values.collect() }
    }
}
