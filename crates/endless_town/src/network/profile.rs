//! Cross-sections of streets.

/// The cross-section of a street, symmetric about its reference line. Metres and m/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Profile {
    /// Driving lanes in each direction.
    pub(crate) lanes: usize,
    /// Width of a driving lane.
    pub(crate) lane: f64,
    /// Width of the parking strip on each side; 0 for none.
    pub(crate) parking: f64,
    /// Width of the raised island in the middle; 0 for none.
    pub(crate) median: f64,
    /// Width of each sidewalk, kerb included.
    pub(crate) sidewalk: f64,
    /// Whether grass grows between kerb and pavement.
    pub(crate) verge: bool,
    /// Speed limit.
    pub(crate) speed_mps: f64,
    /// Who goes first: the higher number at a junction is the main road.
    pub(crate) priority: u8,
}

/// Width of the gutter between the outermost lane (or bay) and the kerb.
pub(crate) const GUTTER_M: f64 = 0.3;
/// Width of the kerb stone.
pub(crate) const KERB_M: f64 = 0.15;
/// Height of the sidewalk above the road.
pub(crate) const KERB_HEIGHT_M: f64 = 0.15;
/// Width of the strip behind the kerb in which posts and trees stand, kerb stone included.
pub(crate) const FURNITURE_M: f64 = 1.25;

impl Profile {
    /// From the reference line to the face of the kerb.
    pub(crate) fn kerb(&self) -> f64 {
        self.lane_edge() + self.parking + GUTTER_M
    }

    /// From the reference line to the outer edge of the outermost driving lane.
    pub(crate) fn lane_edge(&self) -> f64 {
        self.median / 2.0 + self.lanes as f64 * self.lane
    }

    /// From the reference line to the back of the sidewalk.
    pub(crate) fn back(&self) -> f64 {
        self.kerb() + self.sidewalk
    }

    /// From the reference line to the inner edge of the strip that is kept free for walking.
    pub(crate) fn walk_edge(&self) -> f64 {
        self.kerb() + FURNITURE_M
    }

    /// From the reference line to the middle of the strip for walking.
    pub(crate) fn walk_line(&self) -> f64 {
        (self.walk_edge() + self.back()) / 2.0
    }

    /// Width within which people walk.
    pub(crate) fn walk_width(&self) -> f64 {
        self.back() - self.walk_edge() - 0.2
    }

    /// Distance of the centre of lane `k` (0 is the leftmost seen from its driver) from the reference line.
    pub(crate) fn lane_centre(&self, k: usize) -> f64 {
        self.median / 2.0 + (k as f64 + 0.5) * self.lane
    }
}

const BASE: Profile = Profile {
    lanes: 1,
    lane: 3.2,
    parking: 0.0,
    median: 0.0,
    sidewalk: 3.2,
    verge: false,
    speed_mps: 11.1,
    priority: 1,
};

/// A residential street with cars parked on both sides.
pub(crate) const RESIDENTIAL: Profile = Profile { lane: 3.0, parking: 2.2, sidewalk: 3.4, speed_mps: 8.3, ..BASE };
/// A small town's main street: one lane each way, parking, broad sidewalks.
pub(crate) const MAIN: Profile = Profile { lane: 3.3, parking: 2.2, sidewalk: 4.0, priority: 3, ..BASE };
