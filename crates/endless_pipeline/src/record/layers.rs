//! The layers of one camera's frame: written, or read back where they are stored already.

use super::times::StageClock;
use endless_dataset::{
    CameraLayout, CameraOutput, DatasetError, LastPng, Layer, StoredImage, instance_from_rgb, read_rgb, write_atomic,
};
use endless_world::{Image, InstancePixel, SensorFrame};

/// The layers of which videos are wanted, in the output's order, as whoever reads the files finds them.
pub(super) type StoredImages<'f> = Vec<(Layer, StoredImage<'f>)>;

/// One camera's frame as it was read.
pub(super) struct StoredLayers {
    pub(super) images: StoredImages<'static>,
    pub(super) depth: Image<[u8; 3]>,
    pub(super) instance: Image<InstancePixel>,
}

/// Whether a stored frame is enough to make everything else of: everything that labels are judged by, without loss.
pub(super) fn stored_layers_suffice(output: &CameraOutput) -> bool {
    [Layer::Depth, Layer::Instance]
        .iter()
        .all(|layer| output.layers.contains(layer) && layer.format(output.rgb_format).entry().exact)
}

impl StoredLayers {
    /// Reads a frame of which every layer is stored, where [`stored_layers_suffice`]. All are decoded, also those that are
    /// not used, so that a spoilt one is noticed.
    pub(super) fn read(files: &CameraLayout, output: &CameraOutput, frame: u32) -> Result<Self, DatasetError> {
        let mut images = StoredImages::new();
        let (mut depth, mut instance) = (None, None);
        for &layer in &output.layers {
            let path = files.frame(layer, frame, output.rgb_format);
            let image = read_rgb(&path, layer.format(output.rgb_format))?;
            if image.size() != output.size {
                return Err(DatasetError::malformed(path, "has another size"));
            }
            (layer.entry().check)(&image).map_err(|reason| DatasetError::malformed(&path, reason))?;
            match (layer, image.rgb8()) {
                (Layer::Depth, Ok(image)) => depth = Some(image.clone()),
                (Layer::Instance, Ok(image)) => instance = instance_from_rgb(image).ok(),
                _ => {}
            }
            if output.mp4.contains(&layer) {
                images.push((layer, image));
            }
        }
        let missing = || DatasetError::malformed(files.folder(), "lacks layers that labels are judged by");
        Ok(Self { images, depth: depth.ok_or_else(missing)?, instance: instance.ok_or_else(missing)? })
    }
}

/// All layers of a camera's frame as whoever reads its files finds them.
pub(crate) fn as_stored(
    output: &CameraOutput,
    frame: &SensorFrame,
) -> Result<Vec<(Layer, StoredImage<'static>)>, String> {
    let image = |layer: Layer| {
        let made = (layer.entry().encode)(frame).ok_or_else(|| format!("the simulator gives no {layer}"))?;
        let format = layer.format(output.rgb_format).entry();
        let stored = if format.exact {
            made.into_owned()
        } else {
            (format.decode)(&(format.encode)(&made, &LastPng::default())?)?
        };
        Ok((layer, stored))
    };
    output.layers.iter().map(|layer| image(*layer)).collect()
}

/// Writes all layers of a camera's frame; `last` is what was written last of each.
pub(super) fn write<'f>(
    files: &CameraLayout,
    output: &CameraOutput,
    frame: &'f SensorFrame,
    last: &[LastPng],
    clock: &StageClock,
) -> Result<StoredImages<'f>, DatasetError> {
    let mut images = StoredImages::new();
    for (&layer, last) in output.layers.iter().zip(last) {
        let path = files.frame(layer, frame.frame, output.rgb_format);
        let format = layer.format(output.rgb_format).entry();
        let malformed = |reason: String| DatasetError::malformed(&path, reason);
        let (mut image, bytes) = clock.time_layer(layer, || {
            let made = (layer.entry().encode)(frame);
            let image = made.ok_or_else(|| malformed(format!("cannot be: the simulator gives no {layer}")))?;
            let bytes = (format.encode)(&image, last).map_err(malformed)?;
            write_atomic(&path, &bytes)?;
            Ok::<_, DatasetError>((image, bytes))
        })?;
        if !output.mp4.contains(&layer) {
            continue;
        }
        // The video is made of the frames as they lie on disk, so that a resumed one is the same.
        if !format.exact {
            image = (format.decode)(&bytes).map_err(malformed)?;
        }
        images.push((layer, image));
    }
    Ok(images)
}
