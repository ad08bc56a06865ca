//! Towns whose plans are written in the terms of an extract: each file is the description of one, read by the same road
//! builder and dressed like any map.

mod altstadt;
mod ladera;
mod plan;
mod shape;
mod town01;
mod town03;
mod town04;
mod town05;
mod town06;
mod town07;
mod town10hd;

use crate::imported::{Look, dress};
use crate::{Town, TownError};
use endless_asset::Catalogue;
use endless_road::RoadMap;

type Make = fn() -> (RoadMap, Look);

const PLANS: &[(&str, Make)] = &[
    ("Town01", town01::make),
    ("Town03", town03::make),
    ("Town04", town04::make),
    ("Town05", town05::make),
    ("Town06", town06::make),
    ("Town07", town07::make),
    ("Town10HD", town10hd::make),
    ("Ladera", ladera::make),
    ("Altstadt", altstadt::make),
];

/// A town with a plan of its own, if the name is one's.
pub(crate) fn load(name: &str, catalogue: &Catalogue) -> Option<Result<Town, TownError>> {
    let (name, make) = PLANS.iter().find(|(known, _)| *known == name)?;
    let (map, look) = make();
    Some(dress(name, &map, &look, catalogue))
}

/// Whether a town has a plan of its own.
#[cfg(test)]
pub(crate) fn has(name: &str) -> bool {
    PLANS.iter().any(|(known, _)| *known == name)
}
