//! Whether a camera that was moved a little still sees what it is there for.

use crate::camera::{HeightField, PropOcclusion, TopSurface, ViewContents, ViewScorer};
use crate::placement::{PlacedObject, Placement};
use crate::town::Town;
use endless_asset::Catalogue;
use endless_world::CameraSite;
use glam::DVec2;

/// Judges other places of a town's cameras, on the town as a field of heights and on the furniture near the lens.
pub struct ViewCheck<'t> {
    town: &'t Town,
    relief: HeightField,
    props: PropOcclusion,
}

/// Share of the street and of the pavement in the usual picture that must be left.
const LEAST_LEFT: f32 = 0.65;
/// Shares of the picture that walls near by, sky and furniture may take more than before.
const MORE_WALL: f32 = 0.06;
const MORE_SKY: f32 = 0.12;
const MORE_HIDDEN: f32 = 0.015;

impl<'t> ViewCheck<'t> {
    /// Of a town.
    pub fn new(town: &'t Town, catalogue: &Catalogue) -> Self {
        let mesh = |placement: &Placement| match placement.object {
            PlacedObject::TownMesh(i) => Some((&**town.meshes.get(i as usize)?, placement.world_from_object)),
            PlacedObject::Prop(..) => None,
        };
        let meshes: Vec<_> = town.placements.iter().filter_map(mesh).collect();
        let relief = HeightField::new(&town.network, &meshes);
        Self { town, relief, props: PropOcclusion::new(catalogue, &town.placements) }
    }

    /// Whether a site sees about as much of the street as the usual one, with nothing before its lens that was not there.
    /// `false` where even the usual site sees no street.
    pub fn sees_as_well(&self, usual: &CameraSite, moved: &CameraSite) -> bool {
        let judge = ViewScorer::new(&self.town.network, &self.relief, Vec::new(), &[]);
        let (Some(before), Some(now)) = (self.look(&judge, usual), self.look(&judge, moved)) else { return false };
        before.street() > 0.0
            && now.street() >= LEAST_LEFT * before.street()
            && now.paved_low >= LEAST_LEFT * before.paved_low
            && now.solid_near <= before.solid_near + MORE_WALL
            && now.sky <= before.sky + MORE_SKY
            && self.props.hide(moved) <= self.props.hide(usual) + MORE_HIDDEN
    }

    /// Numbers of the town's places of vehicles and people that each site sees, ascending: what two sites have in common
    /// both see.
    pub fn places_seen(&self, sites: &[CameraSite]) -> Vec<Vec<u32>> {
        let judge = ViewScorer::new(&self.town.network, &self.relief, Vec::new(), &[]);
        sites.iter().map(|site| judge.places_seen(site)).collect()
    }

    fn look(&self, judge: &ViewScorer<'_>, site: &CameraSite) -> Option<ViewContents> {
        let [x, y, lens] = site.position.map(f64::from);
        let (ground, top) = self.relief.at(DVec2::new(x, y));
        let clear = top != TopSurface::Solid && f64::from(ground) < lens - 2.0;
        judge.look(site, f64::from(ground)).filter(|_| clear)
    }
}
