//! Layers that tell the same thing tell it alike.

use crate::{
    Layer, StoredImage,
    encoding::{panoptic_from_instance, semantic_from_instance},
    normals::normal_of,
};
use endless_world::{ClassTag, FlowPixel, Image, InstancePixel};
use glam::Vec2;
use std::collections::BTreeMap;

/// Makes a layer of the instance image.
type FromInstance = fn(&Image<InstancePixel>) -> Image<[u8; 3]>;

/// Whether a pixel has flow that is not zero.
fn moves(pixel: [u16; 3]) -> bool {
    FlowPixel::decoded(pixel).is_ok_and(|flow| flow.is_some_and(|flow| flow.flow_px != Vec2::ZERO))
}

/// The layers of a frame that contradict its instance image, and how; the camera stands still, or does not.
pub(super) fn disagreements<'a>(
    stored: &'a BTreeMap<Layer, StoredImage<'_>>,
    instance: &'a Image<InstancePixel>,
    stands: bool,
) -> impl Iterator<Item = (Layer, String)> + 'a {
    let twins: [(Layer, FromInstance); 2] =
        [(Layer::Semantic, semantic_from_instance), (Layer::Panoptic, panoptic_from_instance)];
    let unlike = twins.into_iter().filter_map(move |(layer, expected)| {
        let image = stored.get(&layer)?.rgb8().ok()?;
        Some((layer, image.data.iter().zip(&expected(instance).data).filter(|(a, b)| a != b).count()))
    });
    // Beyond the image circle of a fisheye nothing is shown either.
    let sky = || instance.data.iter().map(|pixel| [ClassTag::Sky, ClassTag::Unlabeled].contains(&pixel.tag));
    let normals = stored.get(&Layer::Normals).and_then(|image| image.rgb16().ok()).map(|image| {
        let wrong = image.data.iter().zip(sky()).filter(|(pixel, sky)| normal_of(**pixel).is_none() != *sky);
        (Layer::Normals, wrong.count())
    });
    let black_sky = [Layer::Albedo, Layer::Shadow].into_iter().filter_map(move |layer| {
        let image = stored.get(&layer)?.rgb8().ok()?;
        Some((layer, image.data.iter().zip(sky()).filter(|(pixel, sky)| *sky && **pixel != [0; 3]).count()))
    });
    let parts = stored.get(&Layer::BodyParts).and_then(|image| image.rgb8().ok()).map(|image| {
        let people = [ClassTag::Pedestrians, ClassTag::Rider];
        let people = instance.data.iter().map(move |seen| people.contains(&seen.tag));
        (Layer::BodyParts, image.data.iter().zip(people).filter(|(pixel, person)| (pixel[0] != 0) != *person).count())
    });
    // Of a camera that moves, `flow_of_still_points` says more.
    let flow = [Layer::Flow, Layer::FlowBackward].into_iter().filter(move |_| stands).filter_map(move |layer| {
        let image = stored.get(&layer)?.rgb16().ok()?;
        let moving = image.data.iter().zip(&instance.data).filter(|(pixel, seen)| seen.id.0 == 0 && moves(**pixel));
        Some((layer, moving.count()))
    });
    unlike
        .chain(parts)
        .chain(flow)
        .chain(normals)
        .chain(black_sky)
        .filter(|(_, count)| *count > 0)
        .map(|(layer, count)| (layer, format!("is not what the instance image says at {count} pixels")))
}
