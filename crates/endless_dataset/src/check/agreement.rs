//! Layers that tell the same thing tell it alike.

use crate::{
    Layer, StoredImage,
    encoding::{panoptic_from_instance, semantic_from_instance},
};
use endless_world::{Image, InstancePixel};
use std::collections::BTreeMap;

/// The layers of a frame that contradict its instance image, and how.
pub(super) fn disagreements<'a>(
    stored: &'a BTreeMap<Layer, StoredImage<'_>>,
    instance: &'a Image<InstancePixel>,
) -> impl Iterator<Item = (Layer, String)> + 'a {
    let twins: [(Layer, fn(&Image<InstancePixel>) -> Image<[u8; 3]>); 2] =
        [(Layer::Semantic, semantic_from_instance), (Layer::Panoptic, panoptic_from_instance)];
    twins.into_iter().filter_map(move |(layer, expected)| {
        let image = stored.get(&layer)?.rgb8().ok()?;
        let count = image.data.iter().zip(&expected(instance).data).filter(|(a, b)| a != b).count();
        (count > 0).then(|| (layer, format!("is not what the instance image says at {count} pixels")))
    })
}
