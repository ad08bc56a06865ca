//! What bodies sweep while they follow lanes: overhangs, the cutting-in of rears and trailers, and on which lanes a
//! vehicle fits at all.

mod design_vehicle;
mod drawbar;
mod lane_fit;
mod oriented_rectangle;
mod swept_path;

pub use design_vehicle::DesignVehicle;
pub use drawbar::{DRAWBAR, towed_heading};
pub use lane_fit::{
    LONG_M, SWINGS_OUT_M, curvature_per_m, fits, leaves_oncoming_room, mean_curvature_per_m, smallest_radius_m,
};
pub use oriented_rectangle::OrientedRectangle;
pub use swept_path::SweptPath;
