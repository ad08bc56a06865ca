//! Distractors: things of no annotated class that stand beside the roads of a video and hide some of what moves behind
//! them (Tremblay et al. 2018).
//!
//! Rays from the cameras find places on sidewalks and greens. A place is taken if the ground there is level, nothing stands
//! on it, and no vehicle or walker comes that way. Most tries are made just beside lanes and sidewalks.

mod clearance;
mod kind;
mod solid;

use crate::TownScene;
use clearance::Clearance;
use endless_asset::Catalogue;
use endless_render::{Geometry, Instance, StaticScene};
use endless_town::Town;
use endless_world::{CameraSite, ClassTag, ImageSize, PinholeCamera, Stream, math};
use glam::{Affine3A, Mat3A, Vec2, Vec3, Vec3A};
use kind::ClutterModels;
use std::f32::consts::TAU;

/// Pieces before a camera at full strength.
const MOST: f32 = 60.0;
/// Tries for each piece that is wanted.
const TRIES: usize = 30;
/// Share of tries beside lanes and sidewalks, where what moves is hidden.
const ROADSIDE: f64 = 0.8;
/// Share of slim things among these: others find no room on sidewalks.
const SLIM: f64 = 0.6;
/// How far before a camera they stand, metres.
const NEAREST_M: f32 = 7.0;
const FARTHEST_M: f32 = 55.0;
/// Share of the picture's height that none exceeds.
const TALLEST: f32 = 0.28;
/// Pictures are judged at this size.
const SIZE: ImageSize = ImageSize { width: 1280, height: 720 };
/// How much the ground under a piece may rise or fall, metres.
const UNEVEN_M: f32 = 0.05;

/// A thing beside the road.
#[derive(Debug, Clone)]
pub struct ClutterPiece {
    geometry: Geometry,
    world_from_object: Affine3A,
    /// Of the disc on the ground that holds it, metres.
    pub radius_m: f32,
    /// Height, metres.
    pub height_m: f32,
}

impl ClutterPiece {
    /// Where it stands on the ground.
    pub fn foot(&self) -> Vec3 {
        self.world_from_object.translation.into()
    }

    /// For the renderer: it has no id, and its pixels the classes of its materials.
    pub fn instance(&self) -> Instance {
        Instance::new(&self.geometry, self.world_from_object)
    }
}

/// Puts things before cameras, the more the greater the strength (0 to 1).
pub fn clutter(
    town: &Town,
    scene: &TownScene,
    catalogue: &Catalogue,
    cameras: &[CameraSite],
    strength: f32,
    seed: u64,
) -> Vec<ClutterPiece> {
    let models = ClutterModels::new(&scene.models, catalogue);
    let mut pieces = Vec::new();
    for (number, site) in (0..).zip(cameras) {
        let random = Stream::named(seed, "clutter", &[number]);
        let camera = PinholeCamera::new(site, SIZE);
        let around = place_of(camera.position).as_dvec2();
        let clearance = Clearance::around(&town.network, around, f64::from(FARTHEST_M) + 10.0);
        let stage = Stage { still: scene.static_scene(), clearance, camera, site };
        stage.furnish(&models, strength, random, &mut pieces);
    }
    pieces
}

/// Seen from above.
fn place_of(point: Vec3) -> Vec2 {
    point.truncate()
}

/// What one camera sees.
struct Stage<'a> {
    still: &'a StaticScene,
    clearance: Clearance,
    camera: PinholeCamera,
    site: &'a CameraSite,
}

impl Stage<'_> {
    fn furnish(&self, models: &ClutterModels, strength: f32, mut random: Stream, pieces: &mut Vec<ClutterPiece>) {
        let wanted = (MOST * strength * random.range_f32(0.4, 1.0)).round() as usize;
        let mut placed = 0;
        for _ in 0..wanted * TRIES {
            if placed == wanted {
                break;
            }
            let piece = self.try_one(models, &mut random, pieces);
            placed += usize::from(piece.is_some());
            pieces.extend(piece);
        }
    }

    /// A piece at a place that a ray of sight finds, if it can stand there.
    fn try_one(&self, models: &ClutterModels, random: &mut Stream, others: &[ClutterPiece]) -> Option<ClutterPiece> {
        let turn = random.range_f32(0.0, TAU);
        let roadside = random.chance(ROADSIDE);
        let drawn = if roadside && random.chance(SLIM) { models.draw_slim(random) } else { models.draw(random) };
        let height_m = drawn.size.z;
        let radius_m = 0.5 * drawn.size.truncate().length();
        let target = if roadside {
            self.clearance.border(random, f64::from(radius_m))?.as_vec3()
        } else {
            self.somewhere_ahead(random)?
        };
        let sight = target - self.camera.position;
        let seen = self.still.first_surface(self.camera.position, sight.normalize(), 1.5 * FARTHEST_M)?;
        let (image, depth) = self.camera.project(seen.position)?;
        let in_picture = (0.0..SIZE.width as f32).contains(&image.x) && (0.0..SIZE.height as f32).contains(&image.y);
        let far = place_of(seen.position).distance(place_of(self.camera.position)) > FARTHEST_M;
        let tall = height_m / depth * self.camera.intrinsics.fy > TALLEST * SIZE.height as f32;
        let place = place_of(seen.position);
        let crowded = others.iter().any(|other| {
            let apart = place_of(other.foot()).distance(place);
            apart < other.radius_m + radius_m + 0.1
        });
        let free = self.clearance.is_free(place.as_dvec2(), f64::from(radius_m));
        if !in_picture || far || tall || depth < NEAREST_M || crowded || !free || !may_stand_on(seen.tag) {
            return None;
        }
        let foot = seen.position.with_z(self.level_ground(seen.position, radius_m)?);
        self.has_room(foot, radius_m, height_m).then(|| ClutterPiece {
            geometry: drawn.geometry,
            world_from_object: Affine3A {
                matrix3: Mat3A::from_rotation_z(turn) * Mat3A::from_diagonal(drawn.scale),
                translation: Vec3A::from(foot),
            },
            radius_m,
            height_m,
        })
    }

    /// On the level of the ground under the camera.
    fn somewhere_ahead(&self, random: &mut Stream) -> Option<Vec3> {
        let half = 0.5 * self.site.horizontal_fov_rad;
        let (sin, cos) = math::sin_cos(self.site.yaw_rad + random.range_f32(-half, half));
        let ahead = random.range_f32(NEAREST_M, FARTHEST_M);
        let below = self.still.first_surface(self.camera.position, -Vec3::Z, 30.0)?.position.z;
        Some((self.camera.position + Vec3::new(cos * ahead, sin * ahead, 0.0)).with_z(below))
    }

    /// The lowest height of the ground under a disc; `None` if it is uneven or not all ground.
    fn level_ground(&self, foot: Vec3, radius_m: f32) -> Option<f32> {
        let mut lowest = foot.z;
        for away in around(radius_m) {
            let under = self.still.first_surface(foot + away + Vec3::Z * 0.5, -Vec3::Z, 1.0)?;
            if (under.position.z - foot.z).abs() > UNEVEN_M || !may_stand_on(under.tag) {
                return None;
            }
            lowest = lowest.min(under.position.z);
        }
        Some(lowest)
    }

    /// Whether nothing stands in a cylinder, as rays from its axis and up along its sides say.
    fn has_room(&self, foot: Vec3, radius_m: f32, height_m: f32) -> bool {
        let reach = radius_m + 0.12;
        let clear = |from: Vec3, way: Vec3, reach: f32| self.still.first_surface(from, way, reach).is_none();
        let levels = [0.12, 0.45 * height_m.max(0.4), 0.95 * height_m.max(0.4)];
        let aside = levels.iter().all(|&z| around(1.0).all(|way| clear(foot + Vec3::Z * z, way.normalize(), reach)));
        let up = around(radius_m).chain([Vec3::ZERO]);
        aside && up.into_iter().all(|away| clear(foot + away + Vec3::Z * 0.1, Vec3::Z, height_m + 0.2))
    }
}

/// Eight ways about an upright axis.
fn around(radius_m: f32) -> impl Iterator<Item = Vec3> {
    (0..8).map(move |i| {
        let (sin, cos) = math::sin_cos(TAU * i as f32 / 8.0);
        Vec3::new(cos * radius_m, sin * radius_m, 0.0)
    })
}

fn may_stand_on(tag: ClassTag) -> bool {
    matches!(tag, ClassTag::Sidewalks | ClassTag::Terrain | ClassTag::Ground)
}
