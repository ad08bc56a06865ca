//! Materials of grounds and streets; linear albedo.

use endless_scene::{Material, Surface};
use endless_world::ClassTag;

pub(crate) const ASPHALT: Material = Material::new(Surface::Asphalt, [0.125, 0.125, 0.127], ClassTag::Roads);
pub(crate) const COBBLES: Material = Material::new(Surface::Cobbles, [0.155, 0.145, 0.135], ClassTag::Roads);
pub(crate) const PAVING: Material = Material::new(Surface::Paving, [0.36, 0.34, 0.31], ClassTag::Sidewalks);
pub(crate) const KERB: Material = Material::new(Surface::Kerb, [0.42, 0.41, 0.39], ClassTag::Sidewalks);
pub(crate) const LAWN: Material = Material::new(Surface::Grass, [0.09, 0.17, 0.045], ClassTag::Terrain);
pub(crate) const MEADOW: Material = Material::new(Surface::Grass, [0.14, 0.16, 0.06], ClassTag::Terrain);
pub(crate) const HILL: Material = Material::new(Surface::Grass, [0.07, 0.11, 0.04], ClassTag::Terrain);
pub(crate) const SOIL: Material = Material::new(Surface::Soil, [0.12, 0.085, 0.055], ClassTag::Terrain);
pub(crate) const GRAVEL: Material = Material::new(Surface::Gravel, [0.33, 0.30, 0.26], ClassTag::Ground);
pub(crate) const YARD: Material = Material::new(Surface::Concrete, [0.32, 0.31, 0.29], ClassTag::Ground);
pub(crate) const YARD_DARK: Material = Material::new(Surface::Concrete, [0.185, 0.18, 0.172], ClassTag::Ground);
pub(crate) const YARD_SLABS: Material = Material::new(Surface::Paving, [0.27, 0.255, 0.235], ClassTag::Ground);
pub(crate) const PLAZA: Material = Material::new(Surface::Paving, [0.30, 0.285, 0.26], ClassTag::Ground);
pub(crate) const PLAZA_BAND: Material = Material::new(Surface::Paving, [0.15, 0.145, 0.14], ClassTag::Ground);
pub(crate) const WHITE_PAINT: Material = Material::new(Surface::RoadPaint, [0.72, 0.72, 0.70], ClassTag::RoadLines);
pub(crate) const YELLOW_PAINT: Material = Material::new(Surface::RoadPaint, [0.72, 0.45, 0.05], ClassTag::RoadLines);
pub(crate) const CYCLEWAY: Material = Material::new(Surface::Asphalt, [0.17, 0.075, 0.06], ClassTag::Roads);
pub(crate) const TRACK: Material = Material::new(Surface::Gravel, [0.30, 0.26, 0.21], ClassTag::Roads);
pub(crate) const BALLAST: Material = Material::new(Surface::Gravel, [0.20, 0.18, 0.16], ClassTag::RailTrack);
pub(crate) const DECK: Material = Material::new(Surface::Concrete, [0.40, 0.39, 0.37], ClassTag::Bridge);
pub(crate) const FIELD: Material = Material::new(Surface::Soil, [0.17, 0.14, 0.08], ClassTag::Terrain);
pub(crate) const WOODLAND: Material = Material::new(Surface::Grass, [0.06, 0.09, 0.03], ClassTag::Terrain);
pub(crate) const WATER: Material = Material::new(Surface::Water, [0.03, 0.06, 0.06], ClassTag::Water);
pub(crate) const CAR_PARK: Material = Material::new(Surface::Asphalt, [0.118, 0.117, 0.116], ClassTag::Ground);

/// Surface coordinate of asphalt that belongs to no lane: far from any wheel path.
pub(crate) const NO_LANE: f32 = 50.0;
