//! The keypoints of a person, as COCO and COCO-WholeBody name and join them.

use glam::Vec3;

/// Number of keypoints.
pub const KEYPOINT_COUNT: usize = 17;

/// Their names, in COCO's order.
pub const KEYPOINTS: [&str; KEYPOINT_COUNT] = [
    "nose",
    "left_eye",
    "right_eye",
    "left_ear",
    "right_ear",
    "left_shoulder",
    "right_shoulder",
    "left_elbow",
    "right_elbow",
    "left_wrist",
    "right_wrist",
    "left_hip",
    "right_hip",
    "left_knee",
    "right_knee",
    "left_ankle",
    "right_ankle",
];

/// Number of keypoints of feet.
pub const FOOT_KEYPOINT_COUNT: usize = 6;

/// Their names, in COCO-WholeBody's order.
pub const FOOT_KEYPOINTS: [&str; FOOT_KEYPOINT_COUNT] =
    ["left_big_toe", "left_small_toe", "left_heel", "right_big_toe", "right_small_toe", "right_heel"];

/// Where the keypoints of a person are, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyKeypoints {
    /// In the order of [`KEYPOINTS`].
    pub body: [Vec3; KEYPOINT_COUNT],
    /// In the order of [`FOOT_KEYPOINTS`].
    pub feet: [Vec3; FOOT_KEYPOINT_COUNT],
}

impl BodyKeypoints {
    /// In another frame of reference.
    #[must_use]
    pub fn map(self, place: impl Fn(Vec3) -> Vec3) -> Self {
        Self { body: self.body.map(&place), feet: self.feet.map(&place) }
    }
}

/// Which of them limbs join, counted from 1, as in the `skeleton` of COCO's `person_keypoints`.
pub const KEYPOINT_LIMBS: [[u8; 2]; 19] = [
    [16, 14],
    [14, 12],
    [17, 15],
    [15, 13],
    [12, 13],
    [6, 12],
    [7, 13],
    [6, 7],
    [6, 8],
    [7, 9],
    [8, 10],
    [9, 11],
    [2, 3],
    [1, 2],
    [1, 3],
    [2, 4],
    [3, 5],
    [4, 6],
    [5, 7],
];
