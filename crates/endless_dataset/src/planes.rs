//! Layers as numbers: what the pixels of a stored image mean, as plain arrays.

use crate::{Layer, StoredImage, encoding::metres_from_rgb, normals::normal_of};
use endless_world::{FlowPixel, FlowTarget, Image};

/// The numbers of an image, row by row from the top-left pixel, the channels of a pixel side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    /// What they are: the layer's name, or `classes` and `flow_target` of what a layer has besides.
    pub name: &'static str,
    /// Numbers a pixel.
    pub channels: usize,
    /// The numbers.
    pub values: PlaneValues,
}

/// Numbers of one type.
#[derive(Debug, Clone, PartialEq)]
pub enum PlaneValues {
    /// Colours, tags, shares.
    U8(Vec<u8>),
    /// Ids.
    I32(Vec<i32>),
    /// Measures.
    F32(Vec<f32>),
}

impl Layer {
    /// What a stored image of the layer says:
    ///
    /// | layer | planes |
    /// |---|---|
    /// | `rgb`, `albedo` | sRGB, three channels |
    /// | `depth` | metres |
    /// | `instance` | `instance`: ids, 0 for stuff; `classes`: class tags |
    /// | `semantic` | class tags |
    /// | `panoptic` | segments: id + 65536 × class tag |
    /// | `normals` | unit vectors, x right, y down, z forward; the sky is 0, 0, 0 |
    /// | `shadow` | share of the sun's disc that is hidden, 255 for all of it |
    /// | `body_parts` | parts, 0 for everything else |
    /// | `flow` | `flow`: pixels, x and y, 0 where unknown; `flow_target`: 0 unknown, 1 visible, 2 hidden, 3 outside |
    /// | `flow_backward` | `flow_backward` and `flow_backward_target`, alike |
    ///
    /// # Errors
    /// What is wrong with the image.
    pub fn planes(self, stored: StoredImage<'_>) -> Result<Vec<Plane>, String> {
        let plane = |channels, values| vec![Plane { name: self.name(), channels, values }];
        Ok(match self {
            Self::Rgb | Self::Albedo => match stored {
                StoredImage::Rgb8(image) => plane(3, PlaneValues::U8(image.into_owned().data.into_flattened())),
                StoredImage::Rgb16(_) => return stored.rgb8().map(|_| Vec::new()),
            },
            Self::Depth => {
                let metres = stored.rgb8()?.data.iter().map(|&pixel| metres_from_rgb(pixel)).collect();
                plane(1, PlaneValues::F32(metres))
            }
            Self::Instance => {
                let image = stored.rgb8()?;
                let id = |&[_, low, high]: &[u8; 3]| i32::from(u16::from_le_bytes([low, high]));
                let ids = PlaneValues::I32(image.data.iter().map(id).collect());
                vec![
                    Plane { name: self.name(), channels: 1, values: ids },
                    Plane { name: "classes", channels: 1, values: reds(image) },
                ]
            }
            Self::Semantic | Self::Shadow | Self::BodyParts => plane(1, reds(stored.rgb8()?)),
            Self::Panoptic => {
                let segment = |&[r, g, b]: &[u8; 3]| i32::from_le_bytes([r, g, b, 0]);
                plane(1, PlaneValues::I32(stored.rgb8()?.data.iter().map(segment).collect()))
            }
            Self::Normals => {
                let normals = stored.rgb16()?.data.iter().map(|&pixel| normal_of(pixel).unwrap_or_default());
                plane(3, PlaneValues::F32(normals.collect::<Vec<[f32; 3]>>().into_flattened()))
            }
            Self::Flow => flow(stored.rgb16()?, ["flow", "flow_target"])?,
            Self::FlowBackward => flow(stored.rgb16()?, ["flow_backward", "flow_backward_target"])?,
        })
    }
}

fn reds(image: &Image<[u8; 3]>) -> PlaneValues {
    PlaneValues::U8(image.data.iter().map(|pixel| pixel[0]).collect())
}

fn flow(image: &Image<[u16; 3]>, [name, target_name]: [&'static str; 2]) -> Result<Vec<Plane>, String> {
    let mut flows = Vec::with_capacity(image.data.len());
    let mut targets = Vec::with_capacity(image.data.len());
    for &pixel in &image.data {
        let (flow, target) = match FlowPixel::decoded(pixel)? {
            None => ([0.0; 2], 0),
            Some(FlowPixel { flow_px, target: FlowTarget::Visible }) => (flow_px.to_array(), 1),
            Some(FlowPixel { flow_px, target: FlowTarget::Hidden }) => (flow_px.to_array(), 2),
            Some(FlowPixel { flow_px, target: FlowTarget::Outside }) => (flow_px.to_array(), 3),
        };
        flows.push(flow);
        targets.push(target);
    }
    Ok(vec![
        Plane { name, channels: 2, values: PlaneValues::F32(flows.into_flattened()) },
        Plane { name: target_name, channels: 1, values: PlaneValues::U8(targets) },
    ])
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::ImageSize;

    const SIZE: ImageSize = ImageSize { width: 2, height: 1 };

    fn planes(layer: Layer, data: [[u8; 3]; 2]) -> Vec<Plane> {
        layer.planes(Image { size: SIZE, data: data.to_vec() }.into()).expect("legal")
    }

    #[test]
    fn eight_bits_are_read_as_their_layer_says() {
        let pixels = [[12, 0x34, 0x12], [4, 0, 0]];
        let values = |layer, place: usize| planes(layer, pixels).swap_remove(place).values;
        assert_eq!(values(Layer::Rgb, 0), PlaneValues::U8(vec![12, 0x34, 0x12, 4, 0, 0]));
        assert_eq!(values(Layer::Instance, 0), PlaneValues::I32(vec![0x1234, 0]));
        assert_eq!(values(Layer::Instance, 1), PlaneValues::U8(vec![12, 4]));
        assert_eq!(values(Layer::Semantic, 0), PlaneValues::U8(vec![12, 4]));
        assert_eq!(values(Layer::Panoptic, 0), PlaneValues::I32(vec![0x0012_340c, 4]));
        let metres = pixels.map(metres_from_rgb).to_vec();
        assert_eq!(values(Layer::Depth, 0), PlaneValues::F32(metres));
    }

    #[test]
    fn sixteen_bits_are_read_as_their_layer_says() {
        let planes = |layer: Layer, data: [[u16; 3]; 2]| layer.planes(Image { size: SIZE, data: data.to_vec() }.into());
        let normals = planes(Layer::Normals, [[65_535, 0, 65_535], [0; 3]]).expect("legal").swap_remove(0);
        assert_eq!((normals.channels, normals.values), (3, PlaneValues::F32(vec![1.0, -1.0, 1.0, 0.0, 0.0, 0.0])));
        let flow = planes(Layer::FlowBackward, [[32_768 + 96, 32_768 - 64, 2], [0; 3]]).expect("legal");
        assert_eq!(flow[0].values, PlaneValues::F32(vec![1.5, -1.0, 0.0, 0.0]));
        assert_eq!((flow[1].name, &flow[1].values), ("flow_backward_target", &PlaneValues::U8(vec![2, 0])));
        assert!(planes(Layer::Flow, [[1, 1, 9], [0; 3]]).is_err());
        assert!(planes(Layer::Rgb, [[0; 3]; 2]).is_err());
        assert!(Layer::Normals.planes(Image::filled(SIZE, [0u8; 3]).into()).is_err());
    }
}
