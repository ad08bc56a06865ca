//! Points as PLY (Turk 1994), binary, little-endian.

use super::point_record::{FIELDS, count_in, decode, encode, split_header};
use endless_world::LidarPoint;

const LAST_LINE: &str = "end_header\n";

fn header(count: usize) -> String {
    let properties: String = FIELDS.iter().map(|field| format!("property {} {}\n", field.ply, field.name)).collect();
    format!("ply\nformat binary_little_endian 1.0\nelement vertex {count}\n{properties}{LAST_LINE}")
}

/// The bytes of a `.ply`.
pub fn ply_from_points(points: &[LidarPoint]) -> Vec<u8> {
    encode(header(points.len()), points)
}

/// The points of a `.ply` of this program.
///
/// # Errors
/// What is wrong with it.
pub fn points_from_ply(bytes: &[u8]) -> Result<Vec<LidarPoint>, String> {
    let (text, points) = split_header(bytes, LAST_LINE)?;
    decode(points, count_in(text, "element vertex", header)?)
}
