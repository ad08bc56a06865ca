//! Integration tests of `endless_town`, in one binary: a module a subject.

use endless_asset::Catalogue;
use endless_town::{NAMES, Town, load};
use rayon::prelude::*;
use std::sync::OnceLock;

mod cameras;
mod imported;
mod moved_cameras;
mod network;
mod opendrive;
mod parked;
mod scene;
mod variety;

/// All towns with the details near their cameras, made once for all tests.
fn towns() -> &'static [Town] {
    static TOWNS: OnceLock<Vec<Town>> = OnceLock::new();
    TOWNS.get_or_init(|| {
        let catalogue = Catalogue::builtin();
        let with_details = |name: &&str| {
            let mut town = load(name, &catalogue).expect("known");
            let details = town.details_near(&town.cameras, &catalogue);
            town.placements.extend(details);
            town
        };
        NAMES.par_iter().map(with_details).collect()
    })
}
