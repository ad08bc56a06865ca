//! Who passes queues.

use crate::vehicle::Vehicle;
use endless_world::Region;

/// Share of riders who pass queues: round figures. Where motorcycles are many nearly all do; in most of North America the law
/// is against it.
const fn share(region: Region) -> f64 {
    match region {
        Region::European => 0.7,
        Region::NorthAmerican => 0.15,
        Region::LatinAmerican => 0.95,
        Region::SouthEastAsian => 0.98,
    }
}

/// Whether somebody is one of those who do.
pub(crate) fn rides_past_queues(vehicle: &Vehicle, region: Region) -> bool {
    const OWN: u64 = 0x66_69_6c_74;
    vehicle.class.two_wheeled() && vehicle.stream.fork(OWN).chance(share(region))
}
