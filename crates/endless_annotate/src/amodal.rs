//! Amodal labels: what an object covers in the picture by itself, and what hides it there.

use crate::{CameraView, PixelBox, rounding::ten_thousandths};
use endless_world::{ClassTag, InstanceId};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A rectangle of pixels that may reach beyond the picture, written as `[x, y, w, h]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "[i32; 4]", into = "[i32; 4]")]
pub struct AmodalBox {
    /// Leftmost column.
    pub x: i32,
    /// Topmost row.
    pub y: i32,
    /// Columns.
    pub w: i32,
    /// Rows.
    pub h: i32,
}

impl AmodalBox {
    /// The box around both.
    #[must_use]
    pub fn united(self, other: Self) -> Self {
        let (x, y) = (self.x.min(other.x), self.y.min(other.y));
        let (x_end, y_end) = ((self.x + self.w).max(other.x + other.w), (self.y + self.h).max(other.y + other.h));
        Self { x, y, w: x_end - x, h: y_end - y }
    }
}

impl From<[i32; 4]> for AmodalBox {
    fn from([x, y, w, h]: [i32; 4]) -> Self {
        Self { x, y, w, h }
    }
}

impl From<AmodalBox> for [i32; 4] {
    fn from(b: AmodalBox) -> Self {
        [b.x, b.y, b.w, b.h]
    }
}

/// Something that hides pixels of an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Occluder {
    /// The object; 0 for stuff, such as a pole or a tree.
    pub id: InstanceId,
    /// Class tag of the hiding pixels.
    pub tag: u8,
    /// How many pixels it takes.
    pub pixels: u32,
}

/// The amodal labels of an object, as `objects.jsonl` has them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AmodalRecord {
    /// Tight box of what the object would show if nothing hid it, also beyond the picture's edges, pixels.
    pub amodal_bbox: AmodalBox,
    /// The part of it in the picture: tight around the amodal pixels.
    pub amodal_bbox_clipped: PixelBox,
    /// Pixels of the picture that it would show if nothing hid it: the visible ones and those of the occluders.
    pub amodal_pixels: u32,
    /// Visible pixels over amodal pixels.
    pub visibility: f64,
    /// Share of the amodal box's area that lies outside the picture.
    pub truncation: f64,
    /// What hides the rest, by id and tag.
    pub occluders: Vec<Occluder>,
    /// COCO's run lengths of the amodal pixels, where they are asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub amodal_mask: Option<String>,
}

/// One object as a picture shows it, with the pixels in which something hides it.
pub(crate) struct HiddenPixels<'a> {
    pub(crate) id: InstanceId,
    /// Its visible part.
    pub(crate) bbox: PixelBox,
    pub(crate) pixels: u32,
    /// Pixels that it covers by itself, by index; the visible ones may be among them.
    pub(crate) covered: &'a [u32],
}

impl HiddenPixels<'_> {
    /// The labels; `beyond` is the rectangle around the projection, `[left, top, right, bottom]`, asked for only where the
    /// object reaches an edge of the picture.
    pub(crate) fn record(
        &self,
        view: &CameraView<'_>,
        beyond: impl FnOnce() -> Option<[f32; 4]>,
        mask: bool,
    ) -> AmodalRecord {
        let size = view.instance.size;
        let mut takers: BTreeMap<(InstanceId, ClassTag), u32> = BTreeMap::new();
        let mut hidden = Vec::new();
        let PixelBox { x, y, w, h } = self.bbox;
        let [mut x0, mut y0, mut x1, mut y1] = [x, y, x + w, y + h];
        for &index in self.covered {
            let shown = view.instance.data[index as usize];
            if shown.id == self.id {
                continue;
            }
            *takers.entry((shown.id, shown.tag)).or_default() += 1;
            let (column, row) = (index % size.width, index / size.width);
            [x0, y0, x1, y1] = [x0.min(column), y0.min(row), x1.max(column + 1), y1.max(row + 1)];
            hidden.push(index);
        }
        let clipped = PixelBox { x: x0, y: y0, w: x1 - x0, h: y1 - y0 };
        let at_edge = x0 == 0 || y0 == 0 || x1 == size.width || y1 == size.height;
        let whole = at_edge.then(beyond).flatten().map_or_else(|| clipped.into(), |b| united(clipped, b));
        let amodal_pixels = self.pixels + hidden.len() as u32;
        let area = |w: f64, h: f64| w * h;
        let inside = area(f64::from(clipped.w), f64::from(clipped.h)) / area(f64::from(whole.w), f64::from(whole.h));
        AmodalRecord {
            amodal_bbox: whole,
            amodal_bbox_clipped: clipped,
            amodal_pixels,
            visibility: ten_thousandths(self.pixels as f32 / amodal_pixels as f32),
            truncation: ten_thousandths((1.0 - inside) as f32),
            occluders: takers
                .into_iter()
                .map(|((id, tag), pixels)| Occluder { id, tag: tag.value(), pixels })
                .collect(),
            amodal_mask: mask.then(|| crate::rle::mask(view.instance, self.id, clipped, &hidden)),
        }
    }
}

impl From<PixelBox> for AmodalBox {
    fn from(b: PixelBox) -> Self {
        Self { x: b.x as i32, y: b.y as i32, w: b.w as i32, h: b.h as i32 }
    }
}

/// A box with the pixels whose centres lie in a rectangle.
fn united(inside: PixelBox, [left, top, right, bottom]: [f32; 4]) -> AmodalBox {
    // Far beyond a picture places mean nothing, and a label should not be larger than can be drawn.
    const FAR: f32 = 32_768.0;
    let first = |low: f32| (low - 0.5).ceil().clamp(-FAR, FAR) as i32;
    let end = |high: f32| ((high - 0.5).floor().clamp(-FAR, FAR) as i32) + 1;
    let (x, y) = (first(left), first(top));
    AmodalBox::from(inside).united(AmodalBox { x, y, w: end(right) - x, h: end(bottom) - y })
}
