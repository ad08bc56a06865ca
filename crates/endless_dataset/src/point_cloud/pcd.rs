//! Points as PCD 0.7, binary (Point Cloud Library, "The PCD file format").

use super::point_record::{FIELDS, PointField, count_in, decode, encode, split_header};
use endless_world::LidarPoint;

const LAST_LINE: &str = "DATA binary\n";

/// The viewpoint is the origin: points are in the sensor's frame.
fn header(count: usize) -> String {
    let of = |what: fn(&PointField) -> String| FIELDS.iter().map(what).collect::<Vec<_>>().join(" ");
    let (names, sizes) = (of(|field| field.name.to_owned()), of(|field| field.bytes.to_string()));
    let (types, counts) = (of(|field| field.pcd.to_owned()), of(|_| "1".to_owned()));
    format!(
        "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS {names}\nSIZE {sizes}\nTYPE {types}\n\
         COUNT {counts}\nWIDTH {count}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {count}\n{LAST_LINE}"
    )
}

/// The bytes of a `.pcd`.
pub fn pcd_from_points(points: &[LidarPoint]) -> Vec<u8> {
    encode(header(points.len()), points)
}

/// The points of a `.pcd` of this program.
///
/// # Errors
/// What is wrong with it.
pub fn points_from_pcd(bytes: &[u8]) -> Result<Vec<LidarPoint>, String> {
    let (text, points) = split_header(bytes, LAST_LINE)?;
    decode(points, count_in(text, "POINTS", header)?)
}

#[cfg(test)]
mod tests {
    use super::super::*;
    use super::*;
    use endless_world::{ClassTag, InstanceId};
    use glam::Vec3;
    use proptest::prelude::*;

    fn any_point() -> impl Strategy<Value = LidarPoint> {
        let place = prop::array::uniform3(-300.0..300.0f32);
        (place, 0.0..=1.0f32, any::<u16>(), 0.0..0.1f32, 0..29u8, any::<u16>(), any::<bool>()).prop_map(
            |(place, intensity, channel, time_s, tag, id, moving)| LidarPoint {
                position: Vec3::from_array(place),
                intensity,
                channel,
                time_s,
                tag: ClassTag::from_value(tag).expect("one of 29"),
                id: InstanceId(id),
                moving,
            },
        )
    }

    proptest! {
        #[test]
        fn points_come_back(points in prop::collection::vec(any_point(), 0..40)) {
            prop_assert_eq!(points_from_ply(&ply_from_points(&points)).expect("ours"), points.clone());
            prop_assert_eq!(points_from_pcd(&pcd_from_points(&points)).expect("ours"), points.clone());
            let bin = points_from_bin(&bin_from_points(&points)).expect("ours");
            let numbers = |p: &LidarPoint| [p.position.x, p.position.y, p.position.z, p.intensity];
            prop_assert_eq!(bin, points.iter().map(numbers).collect::<Vec<_>>());
            let labels = point_labels(&label_from_points(&points)).expect("ours");
            prop_assert!(labels.iter().zip(&points).all(|(label, point)| label.id == point.id));
            prop_assert_eq!(labels.len(), points.len());
        }

        #[test]
        fn damaged_files_are_told_and_never_panic(
            points in prop::collection::vec(any_point(), 1..5), at in any::<prop::sample::Index>(), with in any::<u8>(),
            end in any::<prop::sample::Index>(),
        ) {
            for mut bytes in [ply_from_points(&points), pcd_from_points(&points)] {
                let cut = &bytes[..end.index(bytes.len())];
                prop_assert!(points_from_ply(cut).is_err() && points_from_pcd(cut).is_err());
                let place = at.index(bytes.len());
                bytes[place] = with;
                let _ = (points_from_ply(&bytes), points_from_pcd(&bytes), points_from_bin(&bytes), point_labels(&bytes));
            }
        }
    }

    #[test]
    fn labels_have_semantic_kittis_numbers() {
        let of = |tag, moving, id| LidarPoint {
            position: Vec3::X,
            intensity: 0.5,
            channel: 0,
            time_s: 0.0,
            tag,
            id: InstanceId(id),
            moving,
        };
        let points = [
            of(ClassTag::Car, true, 9),
            of(ClassTag::Car, false, 300),
            of(ClassTag::Roads, false, 0),
            of(ClassTag::Pedestrians, true, 1),
            of(ClassTag::Unlabeled, false, 0),
        ];
        let labels = point_labels(&label_from_points(&points)).expect("ours");
        let expected = [(252, 9), (10, 300), (40, 0), (254, 1), (1, 0)];
        assert_eq!(labels, expected.map(|(class, id)| PointLabel { class, id: InstanceId(id) }));
        assert_eq!(point_labels(&[2, 0, 0, 0]), Err("point 0 has class 2, which there is not".to_owned()));
        assert!(point_labels(&[40, 0, 0]).is_err());
    }

    #[test]
    fn a_header_tells_what_others_need() {
        let header = header(2);
        assert!(header.contains("FIELDS x y z intensity time ring id tag moving\nSIZE 4 4 4 4 4 2 2 1 1\n"));
        let sizes: usize = FIELDS.iter().map(|field| field.bytes).sum();
        assert_eq!(sizes, 26);
        assert!(points_from_pcd(header.as_bytes()).expect_err("no points").contains("instead of 2 × 26"));
    }
}
