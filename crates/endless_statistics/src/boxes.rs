//! What boxes are like: sizes, shapes, visibility, distance.

use crate::Histogram;
use crate::merge::merge_fields;
use crate::scales::{ASPECT_RATIO, BOX_SIDE_PERCENT, BOX_SIDE_PX, DISTANCE_M, SHARE};
use serde::Serialize;

/// Sizes as COCO tells them apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Sizes {
    /// Less than 32² square pixels.
    pub small: u64,
    /// From 32² to less than 96² square pixels.
    pub medium: u64,
    /// 96² square pixels and more.
    pub large: u64,
}

merge_fields!(Sizes { small, medium, large });

impl Sizes {
    /// Counts an area in square pixels.
    pub fn add(&mut self, area_px: f64) {
        let of_size = if area_px < 32.0 * 32.0 {
            &mut self.small
        } else if area_px < 96.0 * 96.0 {
            &mut self.medium
        } else {
            &mut self.large
        };
        *of_size += 1;
    }

    /// Whether nothing was counted.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}

/// A box, as far as its file tells of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SeenBox {
    /// `[x, y, w, h]`, pixels.
    pub(crate) bbox: [f64; 4],
    /// Width and height of the picture, pixels.
    pub(crate) picture: [f64; 2],
    /// Pixels of the object itself.
    pub(crate) pixels: Option<f64>,
    /// Whether it touches the picture's edge.
    pub(crate) at_edge: bool,
    /// Visible pixels over amodal pixels.
    pub(crate) visibility: Option<f64>,
    /// Share of the amodal box outside the picture.
    pub(crate) truncation: Option<f64>,
    /// From the camera, metres.
    pub(crate) distance_m: Option<f64>,
}

/// What the boxes of a class are like, or all boxes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BoxStatistics {
    /// Boxes.
    pub boxes: u64,
    /// Those that touch an edge of the picture.
    pub at_edge: u64,
    /// By the area of the box, width times height.
    pub sizes_by_box: Sizes,
    /// By the visible pixels of the object, COCO's `area`.
    #[serde(skip_serializing_if = "Sizes::is_empty")]
    pub sizes_by_pixels: Sizes,
    /// Root of the area of the box, pixels.
    pub side_px: Histogram,
    /// Root of the area of the box over the root of the picture's, percent.
    pub side_percent: Histogram,
    /// Width of the box over its height.
    pub aspect_ratio: Histogram,
    /// Visible pixels over amodal pixels.
    #[serde(skip_serializing_if = "Histogram::is_empty")]
    pub visibility: Histogram,
    /// Share of the amodal box outside the picture.
    #[serde(skip_serializing_if = "Histogram::is_empty")]
    pub truncation: Histogram,
    /// From the camera to the middle of the 3D box, metres.
    #[serde(skip_serializing_if = "Histogram::is_empty")]
    pub distance_m: Histogram,
}

merge_fields!(BoxStatistics {
    boxes,
    at_edge,
    sizes_by_box,
    sizes_by_pixels,
    side_px,
    side_percent,
    aspect_ratio,
    visibility,
    truncation,
    distance_m,
});

impl Default for BoxStatistics {
    fn default() -> Self {
        Self {
            boxes: 0,
            at_edge: 0,
            sizes_by_box: Sizes::default(),
            sizes_by_pixels: Sizes::default(),
            side_px: Histogram::new(&BOX_SIDE_PX),
            side_percent: Histogram::new(&BOX_SIDE_PERCENT),
            aspect_ratio: Histogram::new(&ASPECT_RATIO),
            visibility: Histogram::new(&SHARE),
            truncation: Histogram::new(&SHARE),
            distance_m: Histogram::new(&DISTANCE_M),
        }
    }
}

impl BoxStatistics {
    /// Counts a box.
    pub(crate) fn add(&mut self, seen: &SeenBox) {
        let ([_, _, w, h], [width, height]) = (seen.bbox, seen.picture);
        self.boxes += 1;
        self.at_edge += u64::from(seen.at_edge);
        self.sizes_by_box.add(w * h);
        if let Some(pixels) = seen.pixels {
            self.sizes_by_pixels.add(pixels);
        }
        self.side_px.add((w * h).sqrt());
        self.side_percent.add(100.0 * (w * h / (width * height)).sqrt());
        self.aspect_ratio.add(w / h);
        for (histogram, value) in [
            (&mut self.visibility, seen.visibility),
            (&mut self.truncation, seen.truncation),
            (&mut self.distance_m, seen.distance_m),
        ] {
            if let Some(value) = value {
                histogram.add(value);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_is_counted_in_every_figure_that_its_file_tells() {
        let mut boxes = BoxStatistics::default();
        let seen = SeenBox {
            bbox: [10.0, 10.0, 64.0, 16.0],
            picture: [640.0, 160.0],
            pixels: Some(500.0),
            at_edge: true,
            visibility: Some(0.5),
            truncation: None,
            distance_m: Some(25.0),
        };
        boxes.add(&seen);
        assert_eq!((boxes.boxes, boxes.at_edge), (1, 1));
        // 64 × 16 is 32², the smallest box of medium size; its object has fewer pixels.
        assert_eq!(boxes.sizes_by_box, Sizes { medium: 1, ..Sizes::default() });
        assert_eq!(boxes.sizes_by_pixels, Sizes { small: 1, ..Sizes::default() });
        assert_eq!((boxes.side_px.mean(), boxes.side_percent.mean()), (Some(32.0), Some(10.0)));
        assert_eq!(boxes.side_px.counts()[5], 1, "32 to 48 pixels");
        assert_eq!((boxes.aspect_ratio.mean(), boxes.aspect_ratio.counts()[19]), (Some(4.0), 1));
        assert_eq!((boxes.visibility.counts()[10], boxes.distance_m.counts()[2]), (1, 1));
        assert!(boxes.truncation.is_empty());
        let json = serde_json::to_value(&boxes).expect("plain");
        assert!(json.get("truncation").is_none() && json.get("visibility").is_some());
    }

    #[test]
    fn limits_are_those_of_coco() {
        let mut sizes = Sizes::default();
        for area in [1023.9, 1024.0, 9215.9, 9216.0, 1e9] {
            sizes.add(area);
        }
        assert_eq!(sizes, Sizes { small: 1, medium: 2, large: 2 });
    }
}
