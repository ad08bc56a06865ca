//! Boxes and visible pixels of every object, in one pass over the instance image.

use endless_world::{ClassTag, Image, InstanceId, InstancePixel};
use serde::{Deserialize, Serialize};

/// A tight box in pixels, written as `[x, y, w, h]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "[u32; 4]", into = "[u32; 4]")]
pub struct PixelBox {
    /// Leftmost column.
    pub x: u32,
    /// Topmost row.
    pub y: u32,
    /// Columns: `xmax − xmin + 1`.
    pub w: u32,
    /// Rows: `ymax − ymin + 1`.
    pub h: u32,
}

impl PixelBox {
    /// The box around both.
    #[must_use]
    pub fn united(self, other: Self) -> Self {
        let (x, y) = (self.x.min(other.x), self.y.min(other.y));
        let (x_end, y_end) = ((self.x + self.w).max(other.x + other.w), (self.y + self.h).max(other.y + other.h));
        Self { x, y, w: x_end - x, h: y_end - y }
    }
}

impl From<[u32; 4]> for PixelBox {
    fn from([x, y, w, h]: [u32; 4]) -> Self {
        Self { x, y, w, h }
    }
}

impl From<PixelBox> for [u32; 4] {
    fn from(b: PixelBox) -> Self {
        [b.x, b.y, b.w, b.h]
    }
}

/// The visible part of one object in an instance image.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct VisibleObject {
    /// The object.
    pub id: InstanceId,
    /// Tag of its pixels.
    pub tag: ClassTag,
    /// Whether all its pixels have that tag.
    pub one_tag: bool,
    /// Tight box.
    pub bbox: PixelBox,
    /// Number of its pixels.
    pub pixels: u32,
}

/// Everything that is not stuff, by ascending id.
pub fn visible_objects(instance: &Image<InstancePixel>) -> Vec<VisibleObject> {
    let mut gather = ObjectScan { slot_of_id: vec![0; 1 << 16], extents: Vec::new() };
    let width = instance.size.width.max(1) as usize;
    for (y, row) in instance.data.chunks_exact(width).enumerate() {
        let mut x = 0;
        while x < width {
            let pixel = row[x];
            let start = x;
            if pixel.id == InstanceId::STUFF {
                x += run_length(&row[x..], |p| p.id == InstanceId::STUFF);
            } else {
                x += run_length(&row[x..], |p| *p == pixel);
                gather.add_run(pixel, start as u32, x as u32, y as u32);
            }
        }
    }
    let mut found: Vec<VisibleObject> = gather.extents.iter().map(ObjectExtent::visible).collect();
    found.sort_unstable_by_key(|v| v.id);
    found
}

/// How many leading pixels hold; eight are tested at a time, as most runs are long.
fn run_length(row: &[InstancePixel], holds: impl Fn(&InstancePixel) -> bool) -> usize {
    let eights = row.chunks_exact(8).take_while(|eight| eight.iter().fold(true, |all, p| all & holds(p))).count() * 8;
    eights + row[eights..].iter().take_while(|p| holds(p)).count()
}

struct ObjectScan {
    /// Position in `extents` plus one; 0 for an id not seen yet.
    slot_of_id: Vec<u16>,
    extents: Vec<ObjectExtent>,
}

struct ObjectExtent {
    first: InstancePixel,
    one_tag: bool,
    x_min: u32,
    x_end: u32,
    y_min: u32,
    y_max: u32,
    pixels: u32,
}

impl ObjectScan {
    fn add_run(&mut self, pixel: InstancePixel, x_start: u32, x_end: u32, y: u32) {
        let slot = &mut self.slot_of_id[usize::from(pixel.id.0)];
        if *slot == 0 {
            self.extents.push(ObjectExtent {
                first: pixel,
                one_tag: true,
                x_min: x_start,
                x_end,
                y_min: y,
                y_max: y,
                pixels: 0,
            });
            // At most 65,535 ids are not stuff, so the count fits.
            *slot = self.extents.len() as u16;
        }
        let extent = &mut self.extents[usize::from(*slot) - 1];
        extent.one_tag &= extent.first.tag == pixel.tag;
        extent.x_min = extent.x_min.min(x_start);
        extent.x_end = extent.x_end.max(x_end);
        extent.y_max = y;
        extent.pixels += x_end - x_start;
    }
}

impl ObjectExtent {
    fn visible(&self) -> VisibleObject {
        VisibleObject {
            id: self.first.id,
            tag: self.first.tag,
            one_tag: self.one_tag,
            bbox: PixelBox { x: self.x_min, y: self.y_min, w: self.x_end - self.x_min, h: self.y_max - self.y_min + 1 },
            pixels: self.pixels,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::ImageSize;
    use proptest::prelude::*;

    fn brute_force(instance: &Image<InstancePixel>) -> Vec<VisibleObject> {
        let mut ids: Vec<InstanceId> = instance.data.iter().map(|p| p.id).filter(|id| id.0 != 0).collect();
        ids.sort_unstable();
        ids.dedup();
        ids.into_iter()
            .map(|id| {
                let mut found = Vec::new();
                for y in 0..instance.size.height {
                    for x in 0..instance.size.width {
                        if instance.at(x, y).id == id {
                            found.push((x, y, instance.at(x, y).tag));
                        }
                    }
                }
                let x = found.iter().map(|f| f.0).min().expect("seen");
                let y = found.iter().map(|f| f.1).min().expect("seen");
                VisibleObject {
                    id,
                    tag: found[0].2,
                    one_tag: found.iter().all(|f| f.2 == found[0].2),
                    bbox: PixelBox {
                        x,
                        y,
                        w: found.iter().map(|f| f.0).max().expect("seen") - x + 1,
                        h: found.iter().map(|f| f.1).max().expect("seen") - y + 1,
                    },
                    pixels: found.len() as u32,
                }
            })
            .collect()
    }

    fn images() -> impl Strategy<Value = Image<InstancePixel>> {
        (1u32..40, 1u32..12).prop_flat_map(|(width, height)| {
            let size = ImageSize { width, height };
            let ids = prop_oneof![4 => Just(0u16), 2 => 1u16..4, 1 => Just(u16::MAX)];
            let pixel = (ids, 0usize..40).prop_map(|(id, tag)| InstancePixel {
                id: InstanceId(id),
                tag: if tag == 0 { ClassTag::Bus } else { ClassTag::Car },
            });
            // Runs of several lengths, so that long ones are met too.
            let runs = prop::collection::vec((pixel, 1usize..25), size.pixels());
            runs.prop_map(move |runs| {
                let data = runs.into_iter().flat_map(|(p, n)| std::iter::repeat_n(p, n)).take(size.pixels()).collect();
                Image { size, data }
            })
        })
    }

    proptest! {
        #[test]
        fn agrees_with_brute_force(image in images()) {
            prop_assert_eq!(visible_objects(&image), brute_force(&image));
        }
    }
}
