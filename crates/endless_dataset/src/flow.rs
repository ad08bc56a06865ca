//! Optical flow: what is wrong with an image of it, and a picture for people.

use endless_world::{FlowPixel, FlowTarget, Image, math};
use glam::Vec2;

/// Whether every pixel is legal, and leads into the picture unless it says that it does not.
///
/// # Errors
/// What is wrong.
pub(crate) fn check_flow(image: &Image<[u16; 3]>) -> Result<(), String> {
    /// A place on the edge may have been rounded to its other side.
    const STEP_PX: f32 = 1.0 / 64.0;
    let size = Vec2::new(image.size.width as f32, image.size.height as f32);
    let mut astray = 0;
    for (y, row) in image.data.chunks(image.size.width as usize).enumerate() {
        for (x, &pixel) in row.iter().enumerate() {
            let Some(FlowPixel { flow_px, target }) = FlowPixel::decoded(pixel)? else { continue };
            let place = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) + flow_px;
            let edge = place.min(size - place).min_element();
            astray += usize::from(if target == FlowTarget::Outside { edge > STEP_PX } else { edge < -STEP_PX });
        }
    }
    if astray == 0 { Ok(()) } else { Err(format!("has {astray} pixels whose flow and blue do not agree")) }
}

/// The colours of Middlebury's benchmark: hue by direction, white where nothing moves, fuller the faster. Unknown flow is
/// black; what the other frame does not show is darker.
///
/// # Errors
/// What is wrong with the image.
pub(crate) fn flow_preview(image: &Image<[u16; 3]>) -> Result<Image<[u8; 3]>, String> {
    let fast_px = FULL_COLOR * image.size.width as f32;
    let mut last = None;
    let mut data = Vec::with_capacity(image.data.len());
    for &pixel in &image.data {
        let color = match last {
            // Runs are long: most of a picture stands still.
            Some((same, color)) if same == pixel => color,
            _ => color_of(pixel, fast_px)?,
        };
        last = Some((pixel, color));
        data.push(color);
    }
    Ok(Image { size: image.size, data })
}

/// Share of the picture's width that flow of the fullest colour has.
const FULL_COLOR: f32 = 0.01;

/// Hues of the wheel from one colour to the next: red, yellow, green, cyan, blue, magenta (Baker et al.: A database and
/// evaluation methodology for optical flow, IJCV 2011).
const HUES: [(f32, [f32; 3]); 6] = [
    (15.0, [1.0, 0.0, 0.0]),
    (6.0, [1.0, 1.0, 0.0]),
    (4.0, [0.0, 1.0, 0.0]),
    (11.0, [0.0, 1.0, 1.0]),
    (13.0, [0.0, 0.0, 1.0]),
    (6.0, [1.0, 0.0, 1.0]),
];
const HUE_COUNT: f32 = 55.0;

fn color_of(pixel: [u16; 3], fast_px: f32) -> Result<[u8; 3], String> {
    let Some(FlowPixel { flow_px, target }) = FlowPixel::decoded(pixel)? else { return Ok([0; 3]) };
    let fullness = (flow_px.length() / fast_px).min(1.0);
    let light = if target == FlowTarget::Visible { 255.0 } else { 160.0 };
    let turn = math::atan2(-flow_px.y, -flow_px.x) / std::f32::consts::TAU + 0.5;
    Ok(hue(turn).map(|full| ((1.0 - fullness * (1.0 - full)) * light).round() as u8))
}

/// The wheel's colour at a part of its circumference, 0 to 1: rightwards is red, then clockwise as seen in the picture.
fn hue(turn: f32) -> [f32; 3] {
    let mut left = turn * HUE_COUNT;
    for (i, (count, from)) in HUES.iter().enumerate() {
        if left <= *count {
            let to = HUES[(i + 1) % HUES.len()].1;
            return [0, 1, 2].map(|k| from[k] + (to[k] - from[k]) * (left / count));
        }
        left -= count;
    }
    HUES[0].1
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::ImageSize;

    const SIZE: ImageSize = ImageSize { width: 100, height: 50 };

    fn flowing(x: f32, y: f32, target: FlowTarget) -> [u16; 3] {
        FlowPixel { flow_px: Vec2::new(x, y), target }.encoded()
    }

    #[test]
    fn places_beside_the_picture_are_told() {
        let mut image = Image::filled(SIZE, FlowPixel::STILL.encoded());
        assert_eq!(check_flow(&image), Ok(()));
        image.data[0] = flowing(-0.5, 3.0, FlowTarget::Outside);
        assert_eq!(check_flow(&image), Ok(()));
        for (x, y, target) in [(-2.0, 0.0, FlowTarget::Hidden), (5.0, 5.0, FlowTarget::Outside)] {
            image.data[0] = flowing(x, y, target);
            assert!(check_flow(&image).is_err_and(|reason| reason.contains("1 pixel")), "{x} {y}");
        }
        image.data[0] = [1, 0, 0];
        assert!(check_flow(&image).is_err_and(|reason| reason.contains("unknown")));
    }

    #[test]
    fn directions_have_the_hues_of_middlebury() {
        let shown = |pixel| flow_preview(&Image::filled(SIZE, pixel)).expect("legal").data[0];
        assert_eq!(shown(FlowPixel::STILL.encoded()), [255; 3]);
        assert_eq!(shown(FlowPixel::UNKNOWN), [0; 3]);
        let visible = |x, y| shown(flowing(x, y, FlowTarget::Visible));
        assert_eq!(visible(9.0, 0.0), [255, 0, 0]);
        // Down is yellow, left cyan to blue, up between blue and magenta.
        assert!(matches!(visible(0.0, 9.0), [255, 200..=255, 0]), "{:?}", visible(0.0, 9.0));
        assert!(matches!(visible(-9.0, 0.0), [0, 100..=255, 255]), "{:?}", visible(-9.0, 0.0));
        assert!(matches!(visible(0.0, -9.0), [50..=255, 0, 255]), "{:?}", visible(0.0, -9.0));
        assert_eq!(visible(0.5, 0.0), [255, 128, 128]);
        assert_eq!(shown(flowing(9.0, 0.0, FlowTarget::Hidden)), [160, 0, 0]);
    }
}
