//! SUMO's floating car data, as SUMO 1.20 writes it with elevation: `x` and `y` of a vehicle are the middle of its front
//! bumper, of a person the centre; `angle` is in degrees clockwise from north, `slope` in degrees.
//! <https://sumo.dlr.de/docs/Simulation/Output/FCDOutput.html>

use super::row::TrajectoryRow;
use endless_world::ObjectClass;
use endless_world::math::f64::sin_cos;
use std::fmt::Write;

pub(super) const HEADER: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\n<fcd-export xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xsi:noNamespaceSchemaLocation=\"http://sumo.dlr.de/xsd/fcd_file.xsd\">\n";

pub(super) const FOOTER: &str = "</fcd-export>\n";

/// The time step of an instant.
pub(super) fn write_rows(time_s: f64, rows: &[TrajectoryRow<'_>], into: &mut String) {
    // A string takes everything.
    let _ = writeln!(into, "    <timestep time=\"{time_s:.3}\">");
    for row in rows {
        let [x, y, z] = row.position;
        let (sin, cos) = sin_cos(row.yaw_rad);
        let (on_foot, half_m) = (row.class == ObjectClass::Pedestrian, 0.5 * row.size_m[0]);
        let (element, ahead_m) = if on_foot { ("person", 0.0) } else { ("vehicle", half_m) };
        let (x, y) = (x + cos * ahead_m, y + sin * ahead_m);
        let angle = (90.0 - row.yaw_rad.to_degrees()).rem_euclid(360.0);
        let slope = row.pitch_rad.to_degrees();
        let _ = write!(
            into,
            "        <{element} id=\"{}\" x=\"{x:.3}\" y=\"{y:.3}\" z=\"{z:.3}\" angle=\"{angle:.3}\" type=\"{}\" speed=\"{:.3}\"",
            row.id,
            row.model.replace(['&', '<', '"'], "_"),
            row.speed_mps
        );
        if let Some(lane) = row.lane {
            let _ = write!(into, " pos=\"{:.3}\" lane=\"{}_{}\"", lane.s_m + ahead_m, lane.name.road, lane.name.lane);
        }
        let _ = writeln!(into, " slope=\"{slope:.2}\"/>");
    }
    into.push_str("    </timestep>\n");
}
