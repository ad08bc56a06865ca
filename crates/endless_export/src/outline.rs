//! Masks as polygons along the edges of pixels. A polygon with a hole goes there and back over a cut of no width, so that filling
//! it gives the mask again.

use endless_annotate::PixelBox;
use endless_world::{Image, InstanceId, InstancePixel};
use std::collections::VecDeque;

/// A closed line of corners of pixels, `[x, y]`; the last one is not the first.
pub(crate) type Polygon = Vec<[u32; 2]>;

/// The parts of an object that hang together by the edges of pixels, a polygon each, the largest first.
pub(crate) fn outlines(instance: &Image<InstancePixel>, id: InstanceId, within: PixelBox) -> Vec<Polygon> {
    let grid = Labelled::new(instance, id, within);
    let mut polygons: Vec<(usize, Polygon)> = (1..=grid.sizes.len())
        .map(|part| {
            let corner = |[x, y]: [i32; 2]| [x as u32 + within.x, y as u32 + within.y];
            (grid.sizes[part - 1], straightened(&grid.outline(part as u32)).into_iter().map(corner).collect())
        })
        .collect();
    polygons.sort_by_key(|(pixels, _)| std::cmp::Reverse(*pixels));
    polygons.into_iter().map(|(_, polygon)| polygon).collect()
}

/// All parts of an object as one polygon, which goes from part to part and back between their nearest corners.
pub(crate) fn joined(mut polygons: Vec<Polygon>) -> Polygon {
    if polygons.is_empty() {
        return Vec::new();
    }
    let mut whole = polygons.remove(0);
    for part in polygons {
        let between = |a: [u32; 2], b: [u32; 2]| {
            let [dx, dy] = [0, 1].map(|axis| i64::from(a[axis]) - i64::from(b[axis]));
            dx * dx + dy * dy
        };
        let pairs = whole
            .iter()
            .enumerate()
            .flat_map(|(i, &a)| part.iter().enumerate().map(move |(j, &b)| (between(a, b), i, j)));
        let Some((_, i, j)) = pairs.min() else { continue };
        let detour: Polygon = part[j..].iter().chain(&part[..=j]).copied().chain([whole[i]]).collect();
        whole.splice(i + 1..i + 1, detour);
    }
    whole
}

/// The pixels of an object in its box, numbered by the part that they belong to; 0 outside.
struct Labelled {
    width: i32,
    height: i32,
    part: Vec<u32>,
    sizes: Vec<usize>,
}

/// East, south, west, north.
const STEPS: [[i32; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];

impl Labelled {
    fn new(instance: &Image<InstancePixel>, id: InstanceId, within: PixelBox) -> Self {
        let (width, height) = (within.w as i32, within.h as i32);
        let inside = |x: i32, y: i32| instance.at(within.x + x as u32, within.y + y as u32).id == id;
        let mut grid = Self { width, height, part: vec![0; (width * height) as usize], sizes: Vec::new() };
        let mut queue = VecDeque::new();
        for y in 0..height {
            for x in 0..width {
                if !inside(x, y) || grid.part[(y * width + x) as usize] != 0 {
                    continue;
                }
                let part = grid.sizes.len() as u32 + 1;
                grid.part[(y * width + x) as usize] = part;
                queue.push_back([x, y]);
                let mut pixels = 0;
                while let Some([x, y]) = queue.pop_front() {
                    pixels += 1;
                    for [dx, dy] in STEPS {
                        let [x, y] = [x + dx, y + dy];
                        let free = (0..width).contains(&x) && (0..height).contains(&y) && inside(x, y);
                        if free && grid.part[(y * width + x) as usize] == 0 {
                            grid.part[(y * width + x) as usize] = part;
                            queue.push_back([x, y]);
                        }
                    }
                }
                grid.sizes.push(pixels);
            }
        }
        grid
    }

    fn is(&self, part: u32, [x, y]: [i32; 2]) -> bool {
        (0..self.width).contains(&x)
            && (0..self.height).contains(&y)
            && self.part[(y * self.width + x) as usize] == part
    }

    /// The outline of a part with its holes, corner by corner.
    fn outline(&self, part: u32) -> Vec<[i32; 2]> {
        // Edges above pixels, from left to right with the part on the right hand: each belongs to one closed line.
        let mut passed = vec![false; (self.width * (self.height + 1)) as usize];
        let mut whole: Vec<[i32; 2]> = Vec::new();
        let mut holes: Vec<Vec<[i32; 2]>> = Vec::new();
        for y in 0..self.height {
            for x in 0..self.width {
                let top = self.is(part, [x, y]) && !self.is(part, [x, y - 1]);
                if top && !passed[(y * self.width + x) as usize] {
                    let line = self.follow(part, [x, y], &mut passed);
                    if whole.is_empty() { whole = line } else { holes.push(line) }
                }
            }
        }
        // From left to right, so that what lies to the left of a hole is in the outline already.
        let leftmost = |line: &[[i32; 2]]| line.iter().copied().min().unwrap_or_default();
        holes.sort_by_key(|hole| leftmost(hole));
        for hole in holes {
            let from = leftmost(&hole);
            // Along the row to the left as far as the part reaches: there the outline passes.
            let mut to = [from[0] - 1, from[1]];
            while self.is(part, [to[0] - 1, to[1]]) {
                to[0] -= 1;
            }
            let start = hole.iter().position(|&corner| corner == from).unwrap_or_default();
            let around = hole[start..].iter().chain(&hole[..=start]).copied();
            if let Some(at) = whole.iter().position(|&corner| corner == to) {
                let detour: Vec<[i32; 2]> = around.chain([to]).collect();
                whole.splice(at + 1..at + 1, detour);
            }
        }
        whole
    }

    /// The closed line that begins above this pixel, with the part on its right hand.
    fn follow(&self, part: u32, start: [i32; 2], passed: &mut [bool]) -> Vec<[i32; 2]> {
        let (mut at, mut heading, mut line) = (start, 0, Vec::new());
        loop {
            line.push(at);
            if heading == 0 {
                passed[(at[1] * self.width + at[0]) as usize] = true;
            }
            let [x, y] = [at[0] + STEPS[heading][0], at[1] + STEPS[heading][1]];
            at = [x, y];
            // The pixels ahead, to the left and to the right.
            let [left, right] = [[[0, -1], [0, 0]], [[0, 0], [-1, 0]], [[-1, 0], [-1, -1]], [[-1, -1], [0, -1]]]
                [heading]
                .map(|[dx, dy]| self.is(part, [x + dx, y + dy]));
            // Pixels that touch by a corner only are apart: to the right first.
            heading = match (left, right) {
                (_, false) => (heading + 1) % 4,
                (false, true) => heading,
                (true, true) => (heading + 3) % 4,
            };
            if at == start && heading == 0 {
                return line;
            }
        }
    }
}

/// Without the corners at which the line goes straight on.
fn straightened(line: &[[i32; 2]]) -> Vec<[i32; 2]> {
    let count = line.len();
    let direction = |a: [i32; 2], b: [i32; 2]| [(b[0] - a[0]).signum(), (b[1] - a[1]).signum()];
    let bends = |i: usize| {
        let [before, after] = [line[(i + count - 1) % count], line[(i + 1) % count]];
        direction(before, line[i]) != direction(line[i], after)
    };
    (0..count).filter(|&i| bends(i)).map(|i| line[i]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{ClassTag, ImageSize};
    use proptest::prelude::*;

    fn image(width: u32, height: u32, set: &[bool]) -> Image<InstancePixel> {
        let pixel = |set: &bool| InstancePixel { tag: ClassTag::Car, id: InstanceId(u16::from(*set)) };
        Image { size: ImageSize { width, height }, data: set.iter().map(pixel).collect() }
    }

    /// Whether a point lies inside, where lines cross it an odd number of times.
    fn holds(polygon: &Polygon, x: f64, y: f64) -> bool {
        let edge = |(i, a): (usize, &[u32; 2])| (*a, polygon[(i + 1) % polygon.len()]);
        let crosses = |(a, b): &([u32; 2], [u32; 2])| {
            let [(ax, ay), (bx, by)] = [a, b].map(|p| (f64::from(p[0]), f64::from(p[1])));
            (ay > y) != (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)
        };
        polygon.iter().enumerate().map(edge).filter(crosses).count() % 2 == 1
    }

    #[test]
    fn a_ring_is_one_polygon_with_a_cut() {
        let set: Vec<bool> = "111110001111111".chars().map(|c| c == '1').collect();
        let found = outlines(&image(5, 3, &set), InstanceId(1), PixelBox { x: 0, y: 0, w: 5, h: 3 });
        assert_eq!(found.len(), 1);
        assert!(holds(&found[0], 0.5, 0.5) && !holds(&found[0], 2.5, 1.5) && holds(&found[0], 4.5, 1.5));
    }

    #[test]
    fn a_block_has_four_corners() {
        let found = outlines(&image(3, 2, &[true; 6]), InstanceId(1), PixelBox { x: 0, y: 0, w: 3, h: 2 });
        assert_eq!(found, [vec![[0, 0], [3, 0], [3, 2], [0, 2]]]);
    }

    proptest! {
        #[test]
        fn filled_outlines_are_the_mask((width, height, set) in (1u32..12, 1u32..12).prop_flat_map(|(width, height)| {
            (Just(width), Just(height), prop::collection::vec(prop::bool::weighted(0.7), (width * height) as usize))
        }).boxed()) {
            let within = PixelBox { x: 0, y: 0, w: width, h: height };
            let parts = outlines(&image(width, height, &set), InstanceId(1), within);
            let whole = joined(parts.clone());
            for y in 0..height {
                for x in 0..width {
                    let (px, py) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
                    let inside = parts.iter().filter(|part| holds(part, px, py)).count();
                    prop_assert_eq!(inside, usize::from(set[(y * width + x) as usize]));
                    prop_assert_eq!(holds(&whole, px, py - 1e-4 * f64::from(x % 7)), set[(y * width + x) as usize]);
                }
            }
        }
    }
}
