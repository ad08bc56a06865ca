//! Detections of radars as CSV (RFC 4180, lines end as on Unix).

use endless_world::{ClassTag, InstanceId, RadarDetection};
use std::fmt::Write as _;

const HEADER: &str = "depth_m,azimuth_rad,altitude_rad,velocity_mps,power_db,tag,id";

/// The text of a scan's file.
pub fn csv_from_detections(detections: &[RadarDetection]) -> String {
    let mut text = format!("{HEADER}\n");
    for d in detections {
        let (tag, id) = (d.tag.value(), d.id);
        writeln!(
            text,
            "{},{},{},{},{},{tag},{id}",
            d.depth_m, d.azimuth_rad, d.altitude_rad, d.velocity_mps, d.power_db
        )
        .expect("a text takes all");
    }
    text
}

/// The detections of a scan's file.
///
/// # Errors
/// What is wrong, with the number of the line.
pub fn detections_from_csv(text: &str) -> Result<Vec<RadarDetection>, String> {
    let lines = text.strip_suffix('\n').ok_or("does not end with a line")?;
    let mut lines = lines.split('\n');
    if lines.next() != Some(HEADER) {
        return Err(format!("does not begin with {HEADER}"));
    }
    let read = |(i, line): (usize, &str)| detection_of(line).ok_or_else(|| format!("line {} is no detection", i + 2));
    lines.enumerate().map(read).collect()
}

fn detection_of(line: &str) -> Option<RadarDetection> {
    let mut fields = line.split(',');
    let mut number = || fields.next()?.parse::<f32>().ok().filter(|number| number.is_finite());
    let [depth_m, azimuth_rad, altitude_rad, velocity_mps, power_db] =
        [number()?, number()?, number()?, number()?, number()?];
    let tag = ClassTag::from_value(fields.next()?.parse().ok()?)?;
    let id = InstanceId(fields.next()?.parse().ok()?);
    let fine = depth_m >= 0.0 && fields.next().is_none();
    fine.then_some(RadarDetection { depth_m, azimuth_rad, altitude_rad, velocity_mps, power_db, tag, id })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_detection() -> impl Strategy<Value = RadarDetection> {
        let angle = -1.5..1.5f32;
        (0.0..200.0f32, angle.clone(), angle, -80.0..80.0f32, -120.0..20.0f32, 0..29u8, any::<u16>()).prop_map(
            |(depth_m, azimuth_rad, altitude_rad, velocity_mps, power_db, tag, id)| RadarDetection {
                depth_m,
                azimuth_rad,
                altitude_rad,
                velocity_mps,
                power_db,
                tag: ClassTag::from_value(tag).expect("one of 29"),
                id: InstanceId(id),
            },
        )
    }

    proptest! {
        #[test]
        fn detections_come_back(detections in prop::collection::vec(any_detection(), 0..20)) {
            prop_assert_eq!(detections_from_csv(&csv_from_detections(&detections)), Ok(detections));
        }

        #[test]
        fn damaged_files_never_panic(text in "[a-z0-9,.\\-\n]{0,60}") {
            let damaged = format!("{HEADER}\n{text}");
            if let Ok(detections) = detections_from_csv(&damaged) {
                prop_assert_eq!(detections.len(), damaged.lines().count() - 1);
            }
        }
    }

    #[test]
    fn a_wrong_line_is_named() {
        let text = format!("{HEADER}\n1,0,0,0,-40,14,7\n1,0,0,0,-40,99,7\n");
        assert_eq!(detections_from_csv(&text), Err("line 3 is no detection".to_owned()));
    }
}
