//! `map.json`: what a camera sees of a map's lanes, paint, areas, signals and signs.

use crate::image_shape::{ImageArea, ImageLine, image_point, world_point};
use crate::lens_projection::LensProjection;
use crate::map_features::{
    CrosswalkAttributes, FeatureBody, LaneAttributes, LensColor, MapFeatures, MarkAttributes, SignAttributes,
    SignalAttributes, SignalFeature, StopLineAttributes,
};
use crate::other_lens::OtherLens;
use crate::rounding::{hundredths_f64, millionths};
use endless_world::PinholeCamera;
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// The static features of a map in one camera's picture.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CameraMap {
    /// Nothing deeper than this is told of, metres.
    pub far_m: f64,
    /// Lanes for driving.
    pub lanes: Vec<LaneView>,
    /// Painted lines along roads.
    pub marks: Vec<PaintView<MarkAttributes>>,
    /// Lines to stop or to give way at.
    pub stop_lines: Vec<PaintView<StopLineAttributes>>,
    /// Crossings for people.
    pub crosswalks: Vec<CrosswalkView>,
    /// Pieces of sidewalks.
    pub sidewalks: Vec<SidewalkView>,
    /// Heads of traffic lights.
    pub signals: Vec<SignalView>,
    /// Traffic signs.
    pub signs: Vec<SignView>,
}

/// A lane in a picture; all lines run in the direction of travel.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LaneView {
    /// Its words.
    #[serde(flatten)]
    pub attributes: LaneAttributes,
    /// Parts of its centre line.
    pub center: Vec<ImageLine>,
    /// Parts of its left boundary.
    pub left: Vec<ImageLine>,
    /// Parts of its right boundary.
    pub right: Vec<ImageLine>,
}

/// Paint in a picture.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PaintView<T> {
    /// Its words.
    #[serde(flatten)]
    pub attributes: T,
    /// The middle of each unbroken piece of paint.
    pub pieces: Vec<ImageLine>,
}

/// A crossing in a picture.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CrosswalkView {
    /// Its words.
    #[serde(flatten)]
    pub attributes: CrosswalkAttributes,
    /// The outline of its bars.
    #[serde(flatten)]
    pub area: ImageArea,
}

/// A piece of a sidewalk in a picture.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SidewalkView {
    /// Of the strip that it is a piece of.
    pub id: u32,
    /// Its outline.
    #[serde(flatten)]
    pub area: ImageArea,
}

/// The place of a flat thing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BodyView {
    /// `[x, y, w, h]` around its box as far as it lies in the picture, pixels, whatever hides it.
    pub bbox: [f64; 4],
    /// Whether a part of that lies outside, or it lies across the edge where both sides of the picture meet.
    pub truncated: bool,
    /// The middle of its front in the world, metres.
    pub position: [f64; 3],
    /// Where it looks in the world; a unit vector.
    pub facing: [f64; 3],
    /// From the lens, metres.
    pub distance_m: f64,
    /// Whether its front is turned to the camera.
    pub front_seen: bool,
}

/// A lens of a signal head, through the camera's own lens.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LensView {
    /// Its colour when it is lit.
    pub color: LensColor,
    /// Its middle, pixels.
    pub image: [f64; 2],
    /// Its height is twice this, pixels.
    pub radius_px: f64,
}

/// A signal head in a picture.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SignalView {
    /// Its words.
    #[serde(flatten)]
    pub attributes: SignalAttributes,
    /// Its housing.
    #[serde(flatten)]
    pub body: BodyView,
    /// Its lenses in the picture, where its front is turned to the camera.
    pub lenses: Vec<LensView>,
}

/// A sign in a picture.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SignView {
    /// Its words.
    #[serde(flatten)]
    pub attributes: SignAttributes,
    /// Its plate.
    #[serde(flatten)]
    pub body: BodyView,
}

impl CameraMap {
    /// Depth up to which features are told of, metres.
    pub const FAR_M: f64 = 100.0;

    /// What a camera sees of a map.
    pub fn new(features: &MapFeatures, camera: &PinholeCamera) -> Self {
        let lens = LensProjection::new(camera);
        let line = |line: &Vec<_>| lens.line(line, Self::FAR_M);
        let lanes = features.lanes.iter().map(|lane| LaneView {
            attributes: lane.attributes.clone(),
            center: line(&lane.center),
            left: line(&lane.left),
            right: line(&lane.right),
        });
        let marks = features.marks.iter().map(|mark| PaintView {
            attributes: mark.attributes.clone(),
            pieces: mark.pieces.iter().flat_map(line).collect(),
        });
        let stop_lines = features.stop_lines.iter().map(|stop| PaintView {
            attributes: stop.attributes.clone(),
            pieces: stop.pieces.iter().flat_map(line).collect(),
        });
        let crosswalks = features.crosswalks.iter().flat_map(|crossing| {
            let areas = lens.areas(&crossing.outline, Self::FAR_M).into_iter();
            areas.map(|area| CrosswalkView { attributes: crossing.attributes.clone(), area })
        });
        let sidewalks = features.sidewalks.iter().flat_map(|walk| {
            let areas = lens.areas(&walk.outline, Self::FAR_M).into_iter();
            areas.map(|area| SidewalkView { id: walk.id, area })
        });
        let signs = features
            .signs
            .iter()
            .filter_map(|sign| Some(SignView { attributes: sign.attributes.clone(), body: lens.body(&sign.body)? }));
        Self {
            far_m: Self::FAR_M,
            lanes: lanes.filter(|l| !(l.center.is_empty() && l.left.is_empty() && l.right.is_empty())).collect(),
            marks: marks.filter(|mark| !mark.pieces.is_empty()).collect(),
            stop_lines: stop_lines.filter(|stop| !stop.pieces.is_empty()).collect(),
            crosswalks: crosswalks.collect(),
            sidewalks: sidewalks.collect(),
            signals: features.signals.iter().filter_map(|signal| lens.signal(signal)).collect(),
            signs: signs.collect(),
        }
    }
}

impl LensProjection {
    /// The box of a thing, if it lies before the camera and reaches into the picture.
    fn body(&self, body: &FeatureBody) -> Option<BodyView> {
        let frustum = self.frustum(CameraMap::FAR_M);
        let corners = body.corners.map(|p| self.to_camera(p));
        let (low, high) = if let Some(other) = self.other_lens() {
            OtherLens { lens: self, other, far_m: CameraMap::FAR_M }.rectangle(&corners)?
        } else {
            // Before the camera as a whole: what is cut by the near plane has no box.
            if corners.iter().any(|p| frustum[..2].iter().any(|plane| plane.inwards(*p) < 0.0)) {
                return None;
            }
            let image = corners.map(|p| self.image(p));
            let low = image.iter().fold(DVec2::INFINITY, |l, &p| l.min(p));
            let high = image.iter().fold(DVec2::NEG_INFINITY, |h, &p| h.max(p));
            (low, high)
        };
        let (from, to) = (low.max(DVec2::ZERO), high.min(self.size));
        let center = self.to_camera(body.center);
        // A lens that bends strongly may fold what is far outside back into the picture.
        let perspective = self.other_lens().is_none();
        let beside = perspective && frustum.iter().any(|plane| corners.iter().all(|p| plane.inwards(*p) < 0.0));
        let in_picture = !beside && (to - from).min_element() > 0.0 && (to - from).element_product() >= 1.0;
        let to_lens = self.position - body.center;
        in_picture.then(|| BodyView {
            bbox: [from.x, from.y, to.x - from.x, to.y - from.y].map(hundredths_f64),
            truncated: low != from || high != to,
            position: world_point(body.center),
            facing: world_point(body.facing),
            distance_m: millionths(center.length()),
            front_seen: body.facing.dot(to_lens) > 0.0,
        })
    }

    fn signal(&self, signal: &SignalFeature) -> Option<SignalView> {
        let body = self.body(&signal.body)?;
        let lenses = signal.lenses.iter().filter(|_| body.front_seen).filter_map(|lens| {
            let seen = |p| match self.other_lens() {
                None => Some(self.image(self.to_camera(p))),
                Some(other) => OtherLens { lens: self, other, far_m: CameraMap::FAR_M }.place(self.to_camera(p)),
            };
            let (image, top) = (seen(lens.center)?, seen(lens.center + glam::DVec3::Z * lens.radius_m)?);
            let radius_px = hundredths_f64(image.distance(top));
            self.shows(image).then(|| LensView { color: lens.color, image: image_point(image), radius_px })
        });
        Some(SignalView { attributes: signal.attributes.clone(), lenses: lenses.collect(), body })
    }
}
