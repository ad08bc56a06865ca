//! What moves is blurred by its way while the shutter is open (Potmesil and Chakravarty 1983): its light is taken out of
//! the picture and spread over that way, in front of what lies behind it.

use endless_world::{ImageSize, InstanceId};
use glam::{Vec2, Vec3, Vec3A, Vec4};

/// Pixels that move less are left as they are.
pub(crate) const LEAST_PX: f32 = 0.6;
/// No streak is longer.
pub(crate) const LONGEST_PX: f32 = 200.0;

/// Light of a moving object in a pixel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Streak {
    pub(crate) id: InstanceId,
    /// Light of what moves, times `cover`.
    pub(crate) light: Vec3A,
    /// Share of the pixel that it covers.
    pub(crate) cover: f32,
    /// Light of what lies behind it, where some of that is seen.
    pub(crate) behind: Option<Vec3A>,
    /// Way in the image while the shutter is open, pixels; it is here in the middle of that time.
    pub(crate) way: Vec2,
    /// Planar, metres.
    pub(crate) depth: f32,
}

/// Room to work in, which frames hand on to one another: empty, but large.
#[derive(Debug, Default)]
pub(crate) struct BlurScratch {
    /// Light and cover that pixels get.
    spread: Vec<Vec4>,
    /// One more than the number of each pixel's streak; 0 without.
    at: Vec<u32>,
    /// Pixels that get any.
    reached: Vec<u32>,
}

/// Spreads streaks, each with the index of its pixel, over a picture. `still` is the picture without anything that moves;
/// `hidden` tells whether a pixel shows something in front of a streak. `changed` gets the pixels that are not as they
/// were.
pub(crate) fn blur(
    size: ImageSize,
    streaks: &mut [(u32, Streak)],
    still: &[Vec3A],
    hidden: impl Fn(usize, &Streak) -> bool,
    picture: &mut [Vec3A],
    changed: &mut Vec<u32>,
    pad: &mut BlurScratch,
) {
    // In one order, whatever the order in which the picture was made: sums depend on it.
    streaks.sort_unstable_by_key(|(pixel, _)| *pixel);
    let BlurScratch { spread, at, reached } = pad;
    spread.resize(picture.len(), Vec4::ZERO);
    at.resize(picture.len(), 0);
    for (i, (pixel, _)) in streaks.iter().enumerate() {
        at[*pixel as usize] = i as u32 + 1;
    }
    for (pixel, streak) in &*streaks {
        picture[*pixel as usize] = streak.behind.unwrap_or(still[*pixel as usize]);
        changed.push(*pixel);
        along(size, *pixel, streak, |pixel, share| {
            if hidden(pixel, streak) {
                return;
            }
            if spread[pixel] == Vec4::ZERO {
                reached.push(pixel as u32);
            }
            spread[pixel] += Vec3::from(streak.light * share).extend(streak.cover * share);
        });
    }
    for &pixel in &*reached {
        let mut light = std::mem::take(&mut spread[pixel as usize]);
        if light.w > 1.0 || inside(size, streaks, at, pixel) {
            light /= light.w.max(1e-3);
        }
        let behind = picture[pixel as usize];
        picture[pixel as usize] = Vec3A::from_vec4(light) + behind * (1.0 - light.w).max(0.0);
    }
    changed.append(reached);
    for (pixel, _) in &*streaks {
        at[*pixel as usize] = 0;
    }
}

/// Where a pixel lies.
fn place(size: ImageSize, pixel: u32) -> Vec2 {
    Vec2::new((pixel % size.width) as f32, (pixel / size.width) as f32)
}

/// The pixels along a streak and the share of its light that each gets.
fn along(size: ImageSize, pixel: u32, streak: &Streak, mut give: impl FnMut(usize, f32)) {
    let steps = streak.way.length().ceil() as i32 + 1;
    let (width, height) = (size.width as i32, size.height as i32);
    let from = place(size, pixel) - streak.way * 0.5;
    for step in 0..steps {
        let at = from + streak.way * (step as f32 / (steps - 1).max(1) as f32);
        let corner = at.floor();
        let part = at - corner;
        let (x, y) = (corner.x as i32, corner.y as i32);
        for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let share = if dx == 1 { part.x } else { 1.0 - part.x } * if dy == 1 { part.y } else { 1.0 - part.y };
            let (x, y) = (x + dx, y + dy);
            if share > 0.0 && x >= 0 && y >= 0 && x < width && y < height {
                give((y * width + x) as usize, share / steps as f32);
            }
        }
    }
}

/// Whether a pixel shows only one object while the shutter is open.
fn inside(size: ImageSize, streaks: &[(u32, Streak)], at: &[u32], pixel: u32) -> bool {
    let find = |pixel: u32| Some(&streaks[at[pixel as usize].checked_sub(1)? as usize].1);
    let Some(here) = find(pixel).filter(|s| s.cover >= 1.0) else { return false };
    let limit = Vec2::new(size.width as f32, size.height as f32);
    [-0.5, 0.5].into_iter().all(|end| {
        let there = (place(size, pixel) + here.way * end).round();
        let out = there.cmplt(Vec2::ZERO).any() || there.cmpge(limit).any();
        out || find(there.y as u32 * size.width + there.x as u32).is_some_and(|s| s.id == here.id && s.cover >= 1.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: ImageSize = ImageSize { width: 64, height: 16 };

    const WALL: [Vec3A; SIZE.pixels()] = [Vec3A::splat(0.5); SIZE.pixels()];

    /// A bright square before a grey wall, on its way.
    fn square(way: Vec2) -> (Vec<(u32, Streak)>, Vec<Vec3A>) {
        let mut picture = WALL.to_vec();
        let mut streaks = Vec::new();
        for y in 4..12 {
            for x in 20..36 {
                let pixel = y * SIZE.width + x;
                picture[pixel as usize] = Vec3A::splat(2.0);
                let light = Vec3A::splat(2.0);
                streaks.push((pixel, Streak { id: InstanceId(3), light, cover: 1.0, behind: None, way, depth: 10.0 }));
            }
        }
        (streaks, picture)
    }

    #[test]
    fn light_is_spread_not_lost() {
        let (mut streaks, mut picture) = square(Vec2::new(7.0, 0.0));
        let before: f32 = picture.iter().map(|p| p.x).sum();
        let mut changed = Vec::new();
        blur(SIZE, &mut streaks, &WALL, |_, _| false, &mut picture, &mut changed, &mut BlurScratch::default());
        let after: f32 = picture.iter().map(|p| p.x).sum();
        assert!((after / before - 1.0).abs() < 3e-3, "{before} {after}");
        let row = |x: usize| picture[8 * SIZE.width as usize + x].x;
        // The middle is as it was, the edges are ramps, half way where the edge was, and all else is the wall.
        assert!((row(28) - 2.0).abs() < 1e-4);
        assert!((0.9..1.6).contains(&row(20)) && (0.9..1.6).contains(&row(35)), "{} {}", row(20), row(35));
        assert!((row(12) - 0.5).abs() < 1e-6 && (row(44) - 0.5).abs() < 1e-6);
        assert!(row(17) < row(20) && row(20) < row(23));
        assert!(changed.len() >= streaks.len());
    }

    #[test]
    fn what_stands_in_front_stays_clean() {
        let (mut streaks, mut picture) = square(Vec2::new(12.0, 0.0));
        let mut pad = BlurScratch::default();
        blur(SIZE, &mut streaks, &WALL, |pixel, _| pixel % 64 == 38, &mut picture, &mut Vec::new(), &mut pad);
        assert!((0..16).all(|y| picture[y * 64 + 38].x == 0.5));
        assert!(picture[8 * 64 + 37].x > 0.6);
    }

    #[test]
    fn order_does_not_matter() {
        let (mut streaks, picture) = square(Vec2::new(5.3, -2.2));
        let (mut a, mut b) = (picture.clone(), picture);
        // The second finds the pad as the first left it.
        let mut pad = BlurScratch::default();
        blur(SIZE, &mut streaks, &WALL, |_, _| false, &mut a, &mut Vec::new(), &mut pad);
        streaks.reverse();
        blur(SIZE, &mut streaks, &WALL, |_, _| false, &mut b, &mut Vec::new(), &mut pad);
        assert_eq!(a, b);
    }
}
