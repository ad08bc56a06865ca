//! Street furniture.

mod glyph;
mod lamp;
mod paint;
mod seat;
mod shelter;
mod sign;
mod signal;
mod small;
mod wall;

use crate::shape::Sculpt;
use crate::{Mesh, Prop};

/// The mesh of a piece of furniture; plants are not furniture and come out empty.
pub(crate) fn furniture(prop: Prop, variant: u32) -> Mesh {
    let sculpt = match prop {
        Prop::StreetLamp => lamp::street_lamp(),
        Prop::UtilityPole => lamp::utility_pole(),
        Prop::CameraPole => lamp::camera_pole(),
        Prop::SignalPole => signal::pole_head(),
        Prop::SignalMast => signal::mast(),
        Prop::WalkSignal => signal::walk(),
        Prop::StopSign => sign::stop(),
        Prop::YieldSign => sign::give_way(),
        Prop::SpeedSign => sign::speed(variant),
        Prop::CrossingSign => sign::crossing(),
        Prop::Bench => seat::bench(),
        Prop::CafeTable => seat::cafe_table(variant),
        Prop::Bin => small::bin(variant),
        Prop::Hydrant => small::hydrant(),
        Prop::PostBox => small::post_box(variant),
        Prop::Bollard => small::bollard(),
        Prop::Cone => small::cone(),
        Prop::Cabinet => small::cabinet(),
        Prop::Dumpster => small::dumpster(variant),
        Prop::BikeRack => small::bike_rack(),
        Prop::BusShelter => shelter::bus_shelter(),
        Prop::Billboard => shelter::billboard(variant),
        Prop::Kiosk => shelter::kiosk(variant),
        Prop::Railing => wall::railing(),
        Prop::FencePanel => wall::fence_panel(),
        Prop::BroadleafTree | Prop::Conifer | Prop::Palm | Prop::Bush | Prop::Hedge | Prop::Corn | Prop::Planter => {
            Sculpt::new()
        }
    };
    sculpt.into_mesh()
}

/// How many variants there are.
pub(crate) fn variants(prop: Prop) -> u32 {
    match prop {
        Prop::SpeedSign | Prop::CafeTable | Prop::Billboard | Prop::Kiosk | Prop::Dumpster => 3,
        Prop::Bin | Prop::PostBox => 2,
        _ => 1,
    }
}
