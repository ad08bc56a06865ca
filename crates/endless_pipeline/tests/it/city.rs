//! The built-in city, whose catalogue and models all tests of this binary share, and the towns that several look at.

use endless_interchange::MapLibrary;
use endless_pipeline::{BuiltinMap, BuiltinSimulator, MapCatalog, MapUse, Simulator};
use std::sync::{LazyLock, OnceLock};

/// Without a cache of bakes.
pub(crate) fn city() -> &'static BuiltinSimulator {
    static CITY: LazyLock<BuiltinSimulator> = LazyLock::new(|| BuiltinSimulator::new(MapLibrary::builtin()));
    &CITY
}

/// One of the towns that are loaded once, with the details before all of its cameras.
pub(crate) fn town(name: &'static str) -> &'static BuiltinMap {
    static TOWNS: [(&str, OnceLock<BuiltinMap>); 3] =
        [("Town03", OnceLock::new()), ("Town10HD", OnceLock::new()), ("Altstadt", OnceLock::new())];
    let (_, town) = TOWNS.iter().find(|(known, _)| *known == name).expect("a town that is shared");
    town.get_or_init(|| {
        let cameras = city().cameras(name).expect("a town");
        city().load_map(&MapUse { name, cameras: &cameras, videos: &[] }).expect("a town")
    })
}
