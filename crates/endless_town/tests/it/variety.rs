//! Towns that are dressed anew, towns that nobody has drawn, and cameras that are drawn in them.

use endless_asset::Catalogue;
use endless_town::{
    DressOptions, PlacedObject, Placement, SiteDrawer, Town, TownSites, ViewCheck, draw_builtin_sites, load, load_with,
    random_name, random_number,
};
use endless_world::{CameraSite, Mount, ViewSubject};
use glam::Vec3;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Two cameras for each of these seeds.
fn drawn(name: &str, town_seed: Option<u64>, seeds: u64, overlapping: bool) -> Vec<Vec<CameraSite>> {
    let catalogue = Catalogue::builtin();
    let ask = |drawer: &SiteDrawer<'_>| -> Vec<Vec<CameraSite>> {
        let draw = |seed| drawer.draw(seed, 2, overlapping, ViewSubject::ALL).expect("a town has views");
        (0..seeds).into_par_iter().map(draw).collect()
    };
    draw_builtin_sites(name, town_seed, &catalogue, ask).expect("known")
}

fn dressed(name: &str, seed: u64, sites: TownSites<'_>) -> Town {
    load_with(name, &DressOptions { seed: Some(seed), sites }, &Catalogue::builtin()).expect("known")
}

#[test]
fn drawn_cameras_are_of_all_mounts_and_within_the_ranges_of_city_cameras() {
    let sites: Vec<CameraSite> =
        ["Town03", "Town10HD"].map(|name| drawn(name, None, 60, false)).into_iter().flatten().flatten().collect();
    let mounts: BTreeSet<Mount> = sites.iter().map(|site| site.mount).collect();
    assert_eq!(mounts.len(), 7, "{mounts:?}");
    for site in &sites {
        let degrees = |radians: f32| radians.to_degrees();
        assert!((4.99..60.01).contains(&degrees(site.down_tilt_rad)), "{site:?}");
        assert!((14.99..110.01).contains(&degrees(site.horizontal_fov_rad)), "{site:?}");
        assert!(degrees(site.roll_rad).abs() < 2.51, "{site:?}");
        assert!((3.0..50.0).contains(&site.position[2]), "{site:?}");
    }
    let narrow = sites.iter().filter(|site| site.horizontal_fov_rad < 0.6).count();
    let steep = sites.iter().filter(|site| site.down_tilt_rad > 0.6).count();
    assert!(narrow > 10 && steep > 10, "{narrow} narrow, {steep} steep");
}

#[test]
fn a_seed_draws_the_same_cameras_and_another_seed_others() {
    let (once, again) = (drawn("Town05", None, 20, false), drawn("Town05", None, 20, false));
    assert_eq!(once, again);
    let places: BTreeSet<[u32; 3]> = once.iter().flatten().map(|site| site.position.map(f32::to_bits)).collect();
    assert_eq!(places.len(), 40, "no two cameras hang in one place");
    for pair in &once {
        assert_ne!(pair[0].name, pair[1].name);
    }
}

#[test]
fn overlapping_cameras_that_are_drawn_see_the_same_street() {
    let town = load("Town10HD", &Catalogue::builtin()).expect("known");
    let check = ViewCheck::new(&town, &Catalogue::builtin());
    let shared = |pair: &Vec<CameraSite>| {
        let seen = check.places_seen(pair);
        seen[0].iter().any(|place| seen[1].binary_search(place).is_ok())
    };
    let pairs = drawn("Town10HD", None, 12, true);
    assert!(pairs.iter().filter(|pair| shared(pair)).count() >= 10, "long lenses see further than the check looks");
}

#[test]
fn a_town_dressed_anew_has_the_same_roads_and_other_houses() {
    let usual = load("Town02", &Catalogue::builtin()).expect("known");
    let (one, same, other) = (
        dressed("Town02", 1, TownSites::Chosen),
        dressed("Town02", 1, TownSites::Chosen),
        dressed("Town02", 2, TownSites::Chosen),
    );
    assert_eq!(one.placements, same.placements);
    assert!(one.meshes.iter().zip(&same.meshes).all(|(a, b)| a.positions == b.positions && a.materials == b.materials));
    for (a, b) in [(&one, &other), (&one, &usual)] {
        assert_eq!(a.network, b.network);
        assert_ne!(a.placements, b.placements);
        let asphalt = |town: &Town| town.meshes[0].materials.clone();
        assert_ne!(asphalt(a), asphalt(b));
    }
    assert!(one.cameras.len() >= 5);
}

#[test]
fn a_town_is_built_around_cameras_that_are_given() {
    let usual = load("Town02", &Catalogue::builtin()).expect("known");
    for seed in 0..4 {
        let town = dressed("Town02", seed, TownSites::Given(&usual.cameras));
        assert_eq!(town.cameras, usual.cameras);
        let check = ViewCheck::new(&town, &Catalogue::builtin());
        let seen = check.places_seen(&town.cameras);
        let blind = seen.iter().filter(|places| places.len() < 4).count();
        assert!(blind <= 1, "{blind} cameras see no street with seed {seed}");
    }
}

/// How high something is.
fn height(object: PlacedObject) -> f32 {
    match object {
        PlacedObject::Prop(prop, variant) => Catalogue::builtin().prop(prop, variant).bounds().1.z,
        PlacedObject::TownMesh(_) => 0.0,
    }
}

#[test]
fn drawn_cameras_hang_in_the_open_in_the_town_that_is_made_for_them() {
    for (name, town_seed) in [("Altstadt", 3), ("Random12", 4)] {
        for sites in drawn(name, Some(town_seed), 3, false) {
            let town = dressed(name, town_seed, TownSites::Drawn(&sites));
            let check = ViewCheck::new(&town, &Catalogue::builtin());
            for (site, places) in sites.iter().zip(check.places_seen(&sites)) {
                assert!(places.len() > 1, "{name}: {site:?}");
            }
            let near = |site: &CameraSite| {
                let lens = Vec3::from_array(site.position);
                let reaches = |p: &&Placement| {
                    let foot = Vec3::from(p.world_from_object.translation);
                    let below = foot.truncate().distance(lens.truncate()) < 0.3 && foot.z < lens.z;
                    below && foot.z + height(p.object) > lens.z - 1.0
                };
                town.placements.iter().filter(reaches).count()
            };
            assert!(sites.iter().all(|site| near(site) == 0), "{name}: something reaches up to a lens");
        }
    }
}

#[test]
fn random_towns_are_made_of_their_numbers() {
    assert_eq!(random_number(&random_name(17)), Some(17));
    let towns: Vec<Town> =
        (100..108).into_par_iter().map(|n| load(&random_name(n), &Catalogue::builtin()).expect("grown")).collect();
    for town in &towns {
        assert!(town.cameras.len() >= 3 && town.parked.len() + town.lamps.len() > 20, "{}", town.name);
    }
    let again = load("Random100", &Catalogue::builtin()).expect("grown");
    assert_eq!((&again.placements, &again.network), (&towns[0].placements, &towns[0].network));
    assert_ne!(towns[0].network, towns[1].network);
}
