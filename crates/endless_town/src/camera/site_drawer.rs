//! New cameras for every video: places drawn by mount, of which those are taken that see a street or a square.

use super::candidate::between;
use super::height_field::TopSurface;
use super::mount_draw::{DrawnPlace, MountDraw};
use super::occlusion::PropOcclusion;
use super::roadside::blocks_lane;
use super::site_selection::named_by;
use super::surroundings::CameraSurroundings;
use super::view_score::{ViewContents, ViewScorer};
use crate::geometry::{OccupiedSpace, Rect};
use endless_world::{CameraSite, Stream, ViewSubject};
use glam::{DVec2, Vec3};

/// Mounts tried for one camera, and places on each; the best of so many good ones is taken, for views that are richer than
/// most.
const MOUNTS: u64 = 24;
const PLACES: u64 = 60;
const GOOD_TO_CHOOSE_FROM: usize = 3;
/// What a picture must show of street, or of street and square, and may of walls near by and sky.
const LEAST_STREET: f32 = 0.16;
const LEAST_PAVED: f32 = 0.22;
const MOST_WALL: f32 = 0.15;
const MOST_SKY: f32 = 0.34;
/// What things near the lens may take of a picture; more of a share of pictures.
const MOST_HIDDEN: f32 = 0.04;
const MOST_OBSTRUCTED: f32 = 0.12;
const OBSTRUCTED: f64 = 0.4;
/// Least weight of places of people in a picture of a square or a park.
const LEAST_PEOPLE: f32 = 4.0;
/// Least weight of places of vehicles and people in any picture.
const LEAST_TRAFFIC: f32 = 5.0;
/// Cameras of a scene hang further apart than this, metres, or look in other directions, radians.
const APART_M: f32 = 7.0;
const TURNED_RAD: f64 = 0.5;
/// Cameras that are to see the same street look from lanes this near to what the first is aimed at, metres; each sees
/// this share of the places that another sees.
const SAME_STREET_M: f64 = 70.0;
const SHARED: f64 = 0.25;

/// Draws cameras in one town.
pub struct SiteDrawer<'s> {
    scene: CameraSurroundings<'s>,
    judge: ViewScorer<'s>,
    props: &'s PropOcclusion,
    occupied: &'s OccupiedSpace,
}

/// A view that is good enough.
struct GoodView {
    place: DrawnPlace,
    worth: f32,
}

impl<'s> SiteDrawer<'s> {
    /// Of a town as it stands before its cameras.
    pub(crate) fn new(scene: CameraSurroundings<'s>, props: &'s PropOcclusion, occupied: &'s OccupiedSpace) -> Self {
        let judge = ViewScorer::new(scene.network, scene.relief, scene.posts.clone(), &scene.parked).looking_far();
        Self { scene, judge, props, occupied }
    }

    /// So many cameras of one scene; of one town, a seed gives the same cameras everywhere. If they overlap, each sees part
    /// of what another sees. `None` where the town has no such views.
    pub fn draw(&self, seed: u64, cameras: usize, overlapping: bool, views: &[ViewSubject]) -> Option<Vec<CameraSite>> {
        let everywhere = MountDraw::new(&self.scene, views);
        let mut sites: Vec<CameraSite> = Vec::new();
        let mut same_street: Option<MountDraw<'_>> = None;
        // What the cameras see that others are to see, too.
        let mut seen: Vec<Vec<u32>> = Vec::new();
        for number in 0..cameras {
            let places = same_street.as_ref().unwrap_or(&everywhere);
            let view = self.view(places, &Stream::named(seed, "drawn site", &[number as u64]), &sites, &seen)?;
            let site = named_by(<&str>::from(view.place.site.mount), &view.place.site, &sites);
            if overlapping {
                seen.push(self.judge.places_seen(&site));
                same_street.get_or_insert_with(|| everywhere.near(view.place.aim, SAME_STREET_M));
            }
            sites.push(site);
        }
        Some(sites)
    }

    fn view(
        &self,
        places: &MountDraw<'_>,
        random: &Stream,
        before: &[CameraSite],
        seen: &[Vec<u32>],
    ) -> Option<GoodView> {
        (0..MOUNTS).find_map(|attempt| {
            let random = random.fork(attempt);
            let intent = places.intent(&mut random.fork(PLACES))?;
            let obstructed = random.fork(PLACES + 1).chance(OBSTRUCTED);
            let most_hidden = if obstructed { MOST_OBSTRUCTED } else { MOST_HIDDEN };
            let good = (0..PLACES).filter_map(|attempt| {
                let place = places.draw(intent, &mut random.fork(attempt))?;
                is_another(&place.site, before).then_some(())?;
                let worth = self.worth(&place, most_hidden)?;
                (seen.is_empty() || self.overlaps(&place.site, seen)).then_some(GoodView { place, worth })
            });
            good.take(GOOD_TO_CHOOSE_FROM).max_by(|a, b| a.worth.total_cmp(&b.worth))
        })
    }

    /// How much a place shows; `None` where it stands in the way, sees too little, or things near the lens hide more than
    /// this share.
    fn worth(&self, place: &DrawnPlace, most_hidden: f32) -> Option<f32> {
        if let Some(foot) = place.pole {
            let room = Rect::new(foot.truncate(), DVec2::splat(0.2), 0.0);
            if !self.occupied.is_free(&room) || blocks_lane(self.scene.network, foot) {
                return None;
            }
        }
        // No road ends where the camera is aimed.
        let (_, aimed_at) = self.scene.relief.at(place.aim);
        if !place.on_foot && !matches!(aimed_at, TopSurface::Road | TopSurface::Junction) {
            return None;
        }
        let seen = self.judge.look(&place.site, place.level)?;
        let street = seen.street() > LEAST_STREET && !place.on_foot;
        let square = place.on_foot && seen.people > LEAST_PEOPLE;
        let open = seen.paved() > LEAST_PAVED && seen.solid_near < MOST_WALL && seen.sky < MOST_SKY;
        let busy = seen.sizes.iter().sum::<f32>() > LEAST_TRAFFIC;
        (open && busy && (street || square) && self.props.hide(&place.site) < most_hidden).then(|| worth(&seen))
    }

    /// Whether it sees part of what one of the others sees.
    fn overlaps(&self, site: &CameraSite, seen: &[Vec<u32>]) -> bool {
        let own = self.judge.places_seen(site);
        seen.iter().any(|theirs| {
            let both = own.iter().filter(|place| theirs.binary_search(place).is_ok()).count();
            both as f64 >= SHARED * own.len().min(theirs.len()).max(1) as f64
        })
    }
}

/// Whether its picture is another than those before it.
fn is_another(site: &CameraSite, before: &[CameraSite]) -> bool {
    before.iter().all(|other| {
        let apart = Vec3::from_array(site.position).distance(Vec3::from_array(other.position));
        apart > APART_M || between(site.yaw_rad, other.yaw_rad) > TURNED_RAD
    })
}

/// More for vehicles and people of all sizes, for people, and for pavement in the lower part.
fn worth(seen: &ViewContents) -> f32 {
    let enough = |x: f32, of: f32| (x / of).min(1.0);
    let [small, middle, large] = seen.sizes;
    let traffic = 1.5 * enough(small, 12.0) + 2.0 * enough(middle, 14.0) + 1.5 * enough(large, 4.0);
    traffic + enough(seen.people, 6.0) + enough(seen.paved_low, 0.6) - 3.0 * seen.solid_near
}
