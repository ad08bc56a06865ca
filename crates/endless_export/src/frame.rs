//! One labelled frame of a camera.

use crate::{ClassMapping, ExportError, PooledInstance, Sequence};
use endless_annotate::{FrameObjects, ObjectRecord, PixelBox};
use endless_dataset::{DatasetError, Layer, StoredImage, read_rgb};
use endless_world::ImageSize;

/// An object of a frame that is exported.
#[derive(Debug, Clone)]
pub struct Label {
    /// Place of its class in the mapping.
    pub class: usize,
    /// Its line in `objects.jsonl`.
    pub object: ObjectRecord,
}

impl Label {
    /// Share of its pixels that can be seen; 1 where nothing tells it.
    pub fn visibility(&self) -> f64 {
        self.object.amodal.as_ref().map_or(1.0, |amodal| amodal.visibility)
    }

    /// Whether something hides more than a twentieth of it.
    pub fn is_occluded(&self) -> bool {
        self.visibility() < 0.95
    }
}

/// A frame of a camera with the objects that are exported.
#[derive(Debug)]
pub struct LabelledFrame<'a> {
    /// The camera.
    pub sequence: &'a Sequence,
    /// Place among the exported frames of its sequence, from 0.
    pub place: usize,
    /// Number of the scene's frame.
    pub frame: u32,
    /// Seconds since the video's first frame.
    pub time_s: f64,
    /// Objects, by id.
    pub labels: Vec<Label>,
}

impl<'a> LabelledFrame<'a> {
    /// A line of `objects.jsonl` with the objects that are of a class of the mapping and to be seen enough.
    ///
    /// # Errors
    /// When a box is empty or not in the picture.
    pub fn new(
        sequence: &'a Sequence,
        place: usize,
        line: FrameObjects,
        classes: &ClassMapping,
        min_visibility: f64,
    ) -> Result<Self, ExportError> {
        let size = sequence.output.size;
        if let Some(object) = line.objects.iter().find(|object| !boxes(object).all(|bbox| is_inside(bbox, size))) {
            let reason = format!("frame {}: the box of object {} is not in the picture", line.frame, object.id);
            return Err(DatasetError::malformed(sequence.files.objects(), reason).into());
        }
        let label = |object: ObjectRecord| Some(Label { class: classes.place(object.class)?, object });
        let mut labels: Vec<Label> = line.objects.into_iter().filter_map(label).collect();
        labels.retain(|label| label.visibility() >= min_visibility);
        Ok(Self { sequence, place, frame: line.frame, time_s: line.time_s, labels })
    }

    /// A name that no other frame of the dataset has, without an ending.
    pub fn name(&self) -> String {
        self.sequence.frame_name(self.frame)
    }

    /// A stored image of it.
    ///
    /// # Errors
    /// When it cannot be read or is not of the camera's size.
    pub fn read(&self, layer: Layer) -> Result<StoredImage<'static>, ExportError> {
        let path = self.sequence.image(layer, self.frame);
        let image = read_rgb(&path, layer.format(self.sequence.output.rgb_format))?;
        if image.size() != self.sequence.output.size {
            let reason = format!("is {} instead of {}", image.size(), self.sequence.output.size);
            return Err(DatasetError::malformed(path, reason).into());
        }
        Ok(image)
    }

    /// Which object every pixel shows.
    ///
    /// # Errors
    /// When the instance image cannot be read.
    pub fn instance(&self) -> Result<PooledInstance, ExportError> {
        let path = self.sequence.image(Layer::Instance, self.frame);
        Ok(PooledInstance::read(|reader| reader.read(&path, self.sequence.output.size).map(|_image| ()))?)
    }
}

/// The boxes of an object's visible pixels.
fn boxes(object: &ObjectRecord) -> impl Iterator<Item = PixelBox> {
    [Some(object.bbox), object.with_rider.as_ref().map(|both| both.bbox)].into_iter().flatten()
}

/// Whether a box has pixels, and all in a picture of this size.
fn is_inside(PixelBox { x, y, w, h }: PixelBox, size: ImageSize) -> bool {
    let ends = |from: u32, length: u32, end: u32| length > 0 && from.checked_add(length).is_some_and(|to| to <= end);
    ends(x, w, size.width) && ends(y, h, size.height)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_lie_in_the_picture() {
        let size = ImageSize { width: 8, height: 6 };
        let inside = |x, y, w, h| is_inside(PixelBox { x, y, w, h }, size);
        assert!(inside(0, 0, 8, 6) && inside(7, 5, 1, 1));
        assert!(!inside(0, 0, 9, 6) && !inside(0, 0, 0, 1) && !inside(u32::MAX, 0, 2, 1) && !inside(3, 4, 1, 3));
    }
}
