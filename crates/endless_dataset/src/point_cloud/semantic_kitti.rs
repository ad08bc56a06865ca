//! SemanticKITTI's labels: for each point of a `.bin` 32 bits, little-endian, the class in the lower half, the object in the
//! upper (Behley et al.: SemanticKITTI: A Dataset for Semantic Scene Understanding of LiDAR Sequences, ICCV 2019).

use endless_world::{ClassTag, InstanceId, LidarPoint};

/// Class and object of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PointLabel {
    /// SemanticKITTI's number of the class, as in its `semantic-kitti.yaml`.
    pub class: u16,
    /// The object.
    pub id: InstanceId,
}

/// SemanticKITTI's numbers of a class, standing and moving (`semantic-kitti.yaml` of `semantic-kitti-api`).
///
/// Its cyclists are one with what they ride. Of ours a two-wheeler that moves is one of theirs; a rider is a `bicyclist`,
/// whatever is ridden. Points without a class are rain and fog: `outlier`.
const fn class_numbers(tag: ClassTag) -> [u16; 2] {
    match tag {
        ClassTag::Unlabeled => [1, 1],                                           // outlier
        ClassTag::Sky => [0, 0],                                                 // unlabeled
        ClassTag::Car => [10, 252],                                              // car
        ClassTag::Bicycle => [11, 253],                                          // bicycle, bicyclist
        ClassTag::Bus => [13, 257],                                              // bus
        ClassTag::Motorcycle => [15, 255],                                       // motorcycle, motorcyclist
        ClassTag::Train => [16, 256],                                            // on-rails
        ClassTag::Truck => [18, 258],                                            // truck
        ClassTag::Pedestrians => [30, 254],                                      // person
        ClassTag::Rider => [31, 253],                                            // bicyclist
        ClassTag::Roads => [40, 40],                                             // road
        ClassTag::Sidewalks => [48, 48],                                         // sidewalk
        ClassTag::Ground | ClassTag::RailTrack | ClassTag::Water => [49, 49],    // other-ground
        ClassTag::Buildings => [50, 50],                                         // building
        ClassTag::Fences | ClassTag::GuardRail => [51, 51],                      // fence
        ClassTag::Walls | ClassTag::Bridge => [52, 52],                          // other-structure
        ClassTag::RoadLines => [60, 60],                                         // lane-marking
        ClassTag::Vegetation => [70, 70],                                        // vegetation
        ClassTag::Terrain => [72, 72],                                           // terrain
        ClassTag::Poles => [80, 80],                                             // pole
        ClassTag::TrafficSigns => [81, 81],                                      // traffic-sign
        ClassTag::TrafficLight | ClassTag::Static | ClassTag::Other => [99, 99], // other-object
        ClassTag::Dynamic => [99, 259],                                          // other-object, other-vehicle
    }
}

/// The bytes of a `.label`.
pub fn label_from_points(points: &[LidarPoint]) -> Vec<u8> {
    let label = |point: &LidarPoint| {
        let class = class_numbers(point.tag)[usize::from(point.moving)];
        u32::from(class) | u32::from(point.id.0) << 16
    };
    points.iter().map(label).flat_map(u32::to_le_bytes).collect()
}

/// The labels of a `.label`.
///
/// # Errors
/// What is wrong: a broken label, or a class that there is not.
pub fn point_labels(bytes: &[u8]) -> Result<Vec<PointLabel>, String> {
    let (labels, rest) = bytes.as_chunks::<4>();
    if !rest.is_empty() {
        return Err(format!("has {} bytes, which is no multiple of 4", bytes.len()));
    }
    let read = |(i, &bytes): (usize, &[u8; 4])| {
        let label = u32::from_le_bytes(bytes);
        let (class, id) = (label as u16, InstanceId((label >> 16) as u16));
        let known = ClassTag::ALL.iter().any(|&tag| class_numbers(tag).contains(&class));
        if known {
            Ok(PointLabel { class, id })
        } else {
            Err(format!("point {i} has class {class}, which there is not"))
        }
    };
    labels.iter().enumerate().map(read).collect()
}
