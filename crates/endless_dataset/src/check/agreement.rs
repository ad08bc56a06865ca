//! Layers that tell the same thing tell it alike.

use crate::{
    Layer, StoredImage,
    encoding::{panoptic_from_instance, semantic_from_instance},
    normals::normal_of,
};
use endless_world::{ClassTag, Image, InstancePixel};
use std::collections::BTreeMap;

/// Makes a layer of the instance image.
type FromInstance = fn(&Image<InstancePixel>) -> Image<[u8; 3]>;

/// The layers of a frame that contradict its instance image, and how.
pub(super) fn disagreements<'a>(
    stored: &'a BTreeMap<Layer, StoredImage<'_>>,
    instance: &'a Image<InstancePixel>,
) -> impl Iterator<Item = (Layer, String)> + 'a {
    let twins: [(Layer, FromInstance); 2] =
        [(Layer::Semantic, semantic_from_instance), (Layer::Panoptic, panoptic_from_instance)];
    let unlike = twins.into_iter().filter_map(move |(layer, expected)| {
        let image = stored.get(&layer)?.rgb8().ok()?;
        Some((layer, image.data.iter().zip(&expected(instance).data).filter(|(a, b)| a != b).count()))
    });
    let sky = || instance.data.iter().map(|pixel| pixel.tag == ClassTag::Sky);
    let normals = stored.get(&Layer::Normals).and_then(|image| image.rgb16().ok()).map(|image| {
        let wrong = image.data.iter().zip(sky()).filter(|(pixel, sky)| normal_of(**pixel).is_none() != *sky);
        (Layer::Normals, wrong.count())
    });
    let albedo = stored.get(&Layer::Albedo).and_then(|image| image.rgb8().ok()).map(|image| {
        let lit_sky = image.data.iter().zip(sky()).filter(|(pixel, sky)| *sky && **pixel != [0; 3]);
        (Layer::Albedo, lit_sky.count())
    });
    unlike
        .chain(normals)
        .chain(albedo)
        .filter(|(_, count)| *count > 0)
        .map(|(layer, count)| (layer, format!("is not what the instance image says at {count} pixels")))
}
