//! COCO's run-length encoding of masks, compressed as `pycocotools` does (`maskApi.c`, `rleToString`).

use crate::PixelBox;
use endless_world::{Image, ImageSize, InstanceId, InstancePixel};

/// The visible pixels of an object, all in this box, as COCO's compressed run lengths.
pub fn visible_mask(instance: &Image<InstancePixel>, id: InstanceId, within: PixelBox) -> String {
    mask(instance, id, within, &[])
}

/// The mask of an object: its pixels in an image and some others, all in a box; others by row-major index.
pub(crate) fn mask(instance: &Image<InstancePixel>, id: InstanceId, within: PixelBox, others: &[u32]) -> String {
    let (width, height) = (instance.size.width, instance.size.height);
    let place = |x: u32, y: u32| ((x - within.x) * within.h + (y - within.y)) as usize;
    let mut set = vec![false; within.w as usize * within.h as usize];
    for y in within.y..within.y + within.h {
        for x in within.x..within.x + within.w {
            set[place(x, y)] = instance.at(x, y).id == id;
        }
    }
    for &index in others {
        set[place(index % width, index / width)] = true;
    }
    let mut runs = RunLengths::default();
    runs.add(false, within.x * height);
    for column in set.chunks_exact(within.h.max(1) as usize) {
        runs.add(false, within.y);
        column.iter().for_each(|&inside| runs.add(inside, 1));
        runs.add(false, height - within.y - within.h);
    }
    runs.add(false, (width - within.x - within.w) * height);
    compressed(&runs.finish())
}

/// The pixels of a compressed mask, by row-major index, ascending in columns; `None` if it is not one of a picture of this
/// size.
pub fn mask_pixels(text: &str, size: ImageSize) -> Option<Vec<usize>> {
    let (width, height) = (size.width as usize, size.height as usize);
    let (mut inside, mut at, mut pixels) = (false, 0, Vec::new());
    for run in decompressed(text)? {
        let end = usize::try_from(run).ok().and_then(|run| at_most(at, run, width * height))?;
        if inside {
            pixels.extend((at..end).map(|place| place % height * width + place / height));
        }
        (inside, at) = (!inside, end);
    }
    (at == width * height).then_some(pixels)
}

fn at_most(from: usize, run: usize, most: usize) -> Option<usize> {
    from.checked_add(run).filter(|end| *end <= most)
}

/// Lengths of runs, column by column; the first is of pixels outside.
#[derive(Default)]
struct RunLengths {
    done: Vec<u32>,
    inside: bool,
    length: u32,
}

impl RunLengths {
    fn add(&mut self, inside: bool, count: u32) {
        if inside != self.inside && count > 0 {
            self.done.push(self.length);
            (self.inside, self.length) = (inside, 0);
        }
        self.length += count;
    }

    fn finish(mut self) -> Vec<u32> {
        self.done.push(self.length);
        self.done
    }
}

/// Five bits and one that says "more" a character; from the fourth on, differences to the run two before.
fn compressed(runs: &[u32]) -> String {
    let mut text = String::new();
    for (i, &run) in runs.iter().enumerate() {
        let mut value = i64::from(run) - if i > 2 { i64::from(runs[i - 2]) } else { 0 };
        loop {
            let bits = (value & 0x1f) as u8;
            value >>= 5;
            let more = if bits & 0x10 == 0 { value != 0 } else { value != -1 };
            text.push(char::from(48 + (bits | if more { 0x20 } else { 0 })));
            if !more {
                break;
            }
        }
    }
    text
}

/// The runs of a compressed mask (`rleFrString`); `None` if it is none.
fn decompressed(text: &str) -> Option<Vec<i64>> {
    /// A run has at most 32 bits.
    const MOST_SHIFT: u32 = 35;
    let mut runs: Vec<i64> = Vec::new();
    let mut characters = text.bytes();
    while let Some(first) = characters.next() {
        let (mut bits, mut value, mut shift) = (i64::from(first.checked_sub(48)?), 0, 0);
        loop {
            value |= (bits & 0x1f) << shift;
            shift += 5;
            if bits & 0x20 == 0 {
                break;
            }
            bits = i64::from(characters.next().filter(|_| shift < MOST_SHIFT)?.checked_sub(48)?);
        }
        if bits & 0x10 != 0 {
            value |= -1 << shift;
        }
        let before = if runs.len() > 2 { runs[runs.len() - 2] } else { 0 };
        runs.push(before.checked_add(value)?);
    }
    Some(runs)
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::ClassTag;
    use proptest::prelude::*;

    fn image(size: ImageSize, set: &[bool]) -> Image<InstancePixel> {
        let pixel = |set: &bool| InstancePixel { tag: ClassTag::Car, id: InstanceId(u16::from(*set)) };
        Image { size, data: set.iter().map(pixel).collect() }
    }

    /// As pycocotools writes them.
    #[test]
    fn masks_are_written_as_pycocotools_does() {
        let size = ImageSize { width: 5, height: 4 };
        let inside = |i: usize| (1..=3).contains(&(i % 5)) && (1..=2).contains(&(i / 5));
        let block = image(size, &(0..20).map(inside).collect::<Vec<_>>());
        let around = PixelBox { x: 1, y: 1, w: 3, h: 2 };
        assert_eq!(mask(&block, InstanceId(1), around, &[]), "5220003");
        let corner = image(size, &[false; 20]);
        assert_eq!(mask(&corner, InstanceId(1), PixelBox { x: 0, y: 0, w: 1, h: 1 }, &[0]), "01c0");
    }

    proptest! {
        #[test]
        fn every_mask_can_be_read_again((width, height, set) in (1u32..20, 1u32..20).prop_flat_map(|(width, height)| {
            (Just(width), Just(height), prop::collection::vec(any::<bool>(), (width * height) as usize))
        }).boxed()) {
            let size = ImageSize { width, height };
            let text = mask(&image(size, &set), InstanceId(1), PixelBox { x: 0, y: 0, w: width, h: height }, &[]);
            let mut read = mask_pixels(&text, size).expect("own output");
            read.sort_unstable();
            prop_assert_eq!(read, (0..set.len()).filter(|&i| set[i]).collect::<Vec<_>>());
        }

        #[test]
        fn what_is_no_mask_is_refused(text: String) {
            let size = ImageSize { width: 7, height: 5 };
            if let Some(pixels) = mask_pixels(&text, size) {
                prop_assert!(pixels.iter().all(|&pixel| pixel < size.pixels()));
            }
        }
    }
}
