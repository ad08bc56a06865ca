//! A point as PLY and PCD hold it: all that is known of it, one number after another, little-endian.

use endless_world::{ClassTag, InstanceId, LidarPoint};
use glam::Vec3;

/// One number of a point.
pub(super) struct PointField {
    pub(super) name: &'static str,
    /// Type in PLY.
    pub(super) ply: &'static str,
    /// Type in PCD.
    pub(super) pcd: &'static str,
    pub(super) bytes: usize,
}

const fn float(name: &'static str) -> PointField {
    PointField { name, ply: "float", pcd: "F", bytes: 4 }
}

const fn unsigned(name: &'static str, bytes: usize) -> PointField {
    // Of the two names that PLY has for 16 bits, Open3D knows this one only.
    PointField { name, ply: if bytes == 1 { "uchar" } else { "uint16" }, pcd: "U", bytes }
}

/// In their order: metres, share, seconds, then words as numbers.
pub(super) const FIELDS: [PointField; 9] = [
    float("x"),
    float("y"),
    float("z"),
    float("intensity"),
    float("time"),
    unsigned("ring", 2),
    unsigned("id", 2),
    unsigned("tag", 1),
    unsigned("moving", 1),
];

const POINT_BYTES: usize = 26;

/// A header and the points after it.
pub(super) fn encode(header: String, points: &[LidarPoint]) -> Vec<u8> {
    let mut bytes = header.into_bytes();
    bytes.reserve(points.len() * POINT_BYTES);
    for point in points {
        let Vec3 { x, y, z } = point.position;
        for number in [x, y, z, point.intensity, point.time_s] {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend(point.channel.to_le_bytes());
        bytes.extend(point.id.0.to_le_bytes());
        bytes.extend([point.tag.value(), u8::from(point.moving)]);
    }
    bytes
}

/// So many points, which must be all that there is.
pub(super) fn decode(bytes: &[u8], count: usize) -> Result<Vec<LidarPoint>, String> {
    let (points, rest) = bytes.as_chunks::<POINT_BYTES>();
    if points.len() != count || !rest.is_empty() {
        return Err(format!("has {} bytes of points instead of {count} × {POINT_BYTES}", bytes.len()));
    }
    let read =
        |(i, point): (usize, &[u8; POINT_BYTES])| decode_point(point).map_err(|wrong| format!("point {i} has {wrong}"));
    points.iter().enumerate().map(read).collect()
}

fn decode_point(bytes: &[u8; POINT_BYTES]) -> Result<LidarPoint, String> {
    let (numbers, words) = bytes.split_at(20);
    let (numbers, _) = numbers.as_chunks::<4>();
    let [x, y, z, intensity, time_s] = std::array::from_fn(|i| f32::from_le_bytes(numbers[i]));
    if ![x, y, z, intensity, time_s].iter().all(|number| number.is_finite()) {
        return Err("a number that is not finite".to_owned());
    }
    if !(0.0..=1.0).contains(&intensity) {
        return Err(format!("intensity {intensity}, which is not from 0 to 1"));
    }
    let tag = ClassTag::from_value(words[4]).ok_or_else(|| format!("class tag {}, which there is not", words[4]))?;
    let moving = match words[5] {
        0 => false,
        1 => true,
        other => return Err(format!("moving {other}, which is neither 0 nor 1")),
    };
    Ok(LidarPoint {
        position: Vec3::new(x, y, z),
        intensity,
        channel: u16::from_le_bytes([words[0], words[1]]),
        time_s,
        tag,
        id: InstanceId(u16::from_le_bytes([words[2], words[3]])),
        moving,
    })
}

/// A header that ends with a line, and what comes after it.
pub(super) fn split_header<'a>(bytes: &'a [u8], last_line: &str) -> Result<(&'a str, &'a [u8]), String> {
    /// Ours have some hundreds of bytes.
    const LONGEST: usize = 2000;
    let start = &bytes[..bytes.len().min(LONGEST)];
    let end = start.windows(last_line.len()).position(|window| window == last_line.as_bytes());
    let end = end.ok_or_else(|| format!("has no header that ends with {}", last_line.trim()))? + last_line.len();
    let header =
        std::str::from_utf8(&bytes[..end]).map_err(|error| format!("has a header that is no text: {error}"))?;
    Ok((header, &bytes[end..]))
}

/// The number of points that a header tells of: ours, or none.
pub(super) fn count_in(header: &str, name: &str, ours: impl Fn(usize) -> String) -> Result<usize, String> {
    let told = header.lines().find_map(|line| line.strip_prefix(name)).and_then(|count| count.trim().parse().ok());
    let count = told.ok_or_else(|| format!("has no {name} in its header"))?;
    if header == ours(count) { Ok(count) } else { Err("has another header than those of this program".to_owned()) }
}
