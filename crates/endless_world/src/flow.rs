//! Optical flow as pixels have it: KITTI's 16-bit encoding, with what the other frame shows.

use glam::Vec2;

/// What another frame shows where the point of a pixel is then.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlowTarget {
    /// The point itself.
    Visible,
    /// Something nearer to the camera, be it the point's own object.
    Hidden,
    /// Nothing: the point lies beside the picture.
    Outside,
}

/// Where the point of the world that a pixel's centre shows is in the picture of another frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlowPixel {
    /// From the pixel's centre to that place, pixels, x right, y down.
    pub flow_px: Vec2,
    /// What is seen there.
    pub target: FlowTarget,
}

/// Steps of a pixel.
const STEPS: f32 = 64.0;
/// What stands for 0.
const ZERO: u16 = 1 << 15;

impl FlowPixel {
    /// What stands still, and is seen in the other frame, too.
    pub const STILL: Self = Self { flow_px: Vec2::ZERO, target: FlowTarget::Visible };
    /// The encoding of an unknown flow.
    pub const UNKNOWN: [u16; 3] = [0; 3];

    /// `round(64 × flow) + 2¹⁵` of x and y, and the target: 1 visible, 2 hidden, 3 outside. [`Self::UNKNOWN`] where the
    /// flow is too large, from 512 pixels on.
    pub fn encoded(self) -> [u16; 3] {
        let steps = (self.flow_px * STEPS).round() + f32::from(ZERO);
        let fits = |value: f32| (0.0..=65_535.0).contains(&value);
        if !fits(steps.x) || !fits(steps.y) {
            return Self::UNKNOWN;
        }
        let target = match self.target {
            FlowTarget::Visible => 1,
            FlowTarget::Hidden => 2,
            FlowTarget::Outside => 3,
        };
        [steps.x as u16, steps.y as u16, target]
    }

    /// The flow of a pixel; `None` if it is unknown.
    ///
    /// # Errors
    /// What is wrong with the pixel.
    pub fn decoded([x, y, target]: [u16; 3]) -> Result<Option<Self>, String> {
        let target = match target {
            0 if x == 0 && y == 0 => return Ok(None),
            0 => return Err(format!("has an unknown flow of {x}, {y}: it is 0, 0")),
            1 => FlowTarget::Visible,
            2 => FlowTarget::Hidden,
            3 => FlowTarget::Outside,
            other => return Err(format!("has a flow with blue {other}: it ends at 3")),
        };
        let pixels = |value: u16| (f32::from(value) - f32::from(ZERO)) / STEPS;
        Ok(Some(Self { flow_px: Vec2::new(pixels(x), pixels(y)), target }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn what_is_unknown_is_not_zero_flow() {
        assert_eq!(FlowPixel::STILL.encoded(), [32_768, 32_768, 1]);
        assert_eq!(FlowPixel::decoded(FlowPixel::UNKNOWN), Ok(None));
        assert!(FlowPixel::decoded([32_768, 32_768, 0]).is_err());
        assert!(FlowPixel::decoded([32_768, 32_768, 4]).is_err());
        for (x, known) in [(-512.0, true), (-512.1, false), (511.98, true), (512.0, false), (f32::NAN, false)] {
            let pixel = FlowPixel { flow_px: Vec2::new(x, 0.0), ..FlowPixel::STILL };
            assert_eq!(pixel.encoded() != FlowPixel::UNKNOWN, known, "{x}");
        }
    }

    proptest! {
        #[test]
        fn it_is_exact_to_half_a_step(x in -511.9f32..511.9, y in -511.9f32..511.9, target in 0usize..3) {
            let target = [FlowTarget::Visible, FlowTarget::Hidden, FlowTarget::Outside][target];
            let pixel = FlowPixel { flow_px: Vec2::new(x, y), target };
            let back = FlowPixel::decoded(pixel.encoded()).expect("legal").expect("known");
            prop_assert!((back.flow_px - pixel.flow_px).abs().max_element() <= 0.5 / 64.0 + 1e-4);
            prop_assert_eq!(back.target, target);
            prop_assert_eq!(back.encoded(), pixel.encoded());
        }
    }
}
