//! Light of traffic lights.

use crate::scene::{FrameScene, SurfaceInteraction};
use endless_scene::{LensAspect, Surface};
use endless_world::SignalAspect;
use glam::Vec3A;

/// Light of a traffic light's lens in the state that its group is in.
pub(crate) fn lens_light(frame: &FrameScene, point: &SurfaceInteraction<'_>, night: bool) -> Vec3A {
    let (Surface::SignalLens(lens), Some(signal)) = (point.material.surface, point.instance.signal) else {
        return Vec3A::ZERO;
    };
    let Some(aspect) = frame.signals.get(usize::from(signal.0)) else { return Vec3A::ZERO };
    let lit = match lens {
        LensAspect::Red => matches!(aspect, SignalAspect::Red | SignalAspect::RedYellow),
        LensAspect::Yellow => matches!(aspect, SignalAspect::Yellow | SignalAspect::RedYellow),
        LensAspect::Green => matches!(aspect, SignalAspect::Green),
    };
    if !lit {
        return Vec3A::ZERO;
    }
    let color = match lens {
        LensAspect::Red => Vec3A::new(1.0, 0.04, 0.02),
        LensAspect::Yellow => Vec3A::new(1.0, 0.46, 0.02),
        LensAspect::Green => Vec3A::new(0.02, 1.0, 0.42),
    };
    color * if night { 0.3 } else { 11.0 }
}
