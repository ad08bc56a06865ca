//! The fields of an object in `objects.jsonl`, for whoever reads `dataset.json`.

use serde::{Deserialize, Serialize};

/// One field.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct FieldLabel {
    /// Its name.
    pub name: String,
    /// Shape, unit, frame of reference.
    pub meaning: String,
}

/// Every field that an object can have; docs/objects.md tells more.
pub(crate) fn object_fields() -> Vec<FieldLabel> {
    FIELDS.iter().map(|(name, meaning)| FieldLabel { name: (*name).into(), meaning: (*meaning).into() }).collect()
}

const FIELDS: &[(&str, &str)] = &[
    ("id", "the track: the same in all cameras and frames of a video"),
    ("class", "a name of `classes`"),
    ("bbox", "[x, y, w, h], pixels: tight around the visible pixels"),
    ("pixels", "number of visible pixels"),
    ("truncated", "whether bbox touches an edge of the picture"),
    ("parked", "parked for the whole video"),
    ("vehicle_id", "of a rider: the two-wheeler"),
    ("rider_id", "of a two-wheeler: its rider"),
    ("skin_tone", "Monk scale, 1 to 10"),
    ("keypoints", "COCO's [x1, y1, v1, ...] of 17 keypoints, pixels"),
    ("num_keypoints", "number of keypoints with v > 0"),
    ("foot_kpts", "COCO-WholeBody's [x1, y1, v1, ...] of 6 keypoints of feet, pixels"),
    ("keypoints_3d", "[[x, y, z], ...] of the 17 in the world, metres"),
    ("foot_kpts_3d", "[[x, y, z], ...] of the 6 in the world, metres"),
    ("position", "[x, y, z] of the origin, on the ground under the centre, in the world, metres"),
    ("yaw_rad", "heading, counter-clockwise from east, radians"),
    ("speed_mps", "length of velocity_mps"),
    ("velocity_mps", "[x, y, z] in the world, m/s"),
    ("action", "what somebody on foot or on a two-wheeler does"),
    ("lights", "lamps lit at this instant, by CARLA's names"),
    ("stopped", "a vehicle stands in traffic"),
    ("acceleration_mps2", "change of a vehicle's speed, m/s²"),
    ("steer_rad", "angle of the front wheels, positive to the left, radians"),
    ("indicating", "left or right: where a vehicle's indicators show, lit at this instant or not"),
    ("turning", "left or right: which way a vehicle's lane turns on a junction"),
    ("lane", "index of a vehicle's lane in the map's road network"),
    ("road", "OpenDRIVE id of that lane's road, in the file that endless maps export writes"),
    ("road_lane", "OpenDRIVE id of that lane on its road"),
    ("lane_s_m", "metres along that lane's centre line"),
    ("lane_left", "index of the lane that a vehicle leaves for another"),
    ("parking", "a vehicle that parks at the kerb during the video: pulling_in, parked or pulling_out"),
    ("crossing", "index of the crossing under somebody's feet"),
    ("waiting_to_cross", "somebody stands at a kerb until they may cross"),
    (
        "box3d",
        "center [x, y, z], size [length, width, height], metres, and rotation [w, x, y, z] in the world; \
         center_in_camera, rotation_in_camera; corners in the picture, pixels",
    ),
    ("distance_m", "from the lens to the middle of box3d, metres"),
    ("image_velocity_pxps", "[x, y] of that middle in the picture, pixels a second"),
    ("amodal_bbox", "[x, y, w, h], pixels: tight around what would show if nothing hid it, also beyond the picture"),
    ("amodal_bbox_clipped", "the part of amodal_bbox in the picture"),
    ("amodal_pixels", "pixels of the picture that would show it if nothing hid it"),
    ("visibility", "pixels / amodal_pixels"),
    ("truncation", "share of the area of amodal_bbox outside the picture"),
    ("occluders", "[{id, tag, pixels}, ...]: what hides the rest"),
    ("with_rider", "of a two-wheeler and its rider as one: bbox, pixels, amodal_bbox, box3d"),
    ("amodal_mask", "the amodal pixels as COCO's compressed run lengths"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_on_objects_names_every_field() {
        let page = include_str!("../../../docs/objects.md");
        for FieldLabel { name, .. } in object_fields() {
            assert!(page.contains(&name), "docs/objects.md lacks {name}");
        }
    }
}
