//! Street furniture.

mod advert;
mod barrier;
mod building;
mod face;
mod glyph;
mod lamp;
mod lantern;
mod paint;
mod part;
mod seat;
mod service;
mod shelter;
mod sign;
mod sign_face;
mod signal;
mod signal_look;
mod small;
mod square;
mod vendor;
mod wall;
mod waste;

pub use face::{SignPlate, SignalHead};
pub(crate) use face::{sign_plate, signal_heads};
pub(crate) use sign_face::{CODES, lettering};
pub(crate) use small::DELINEATOR;

use crate::Prop;
use crate::shape::Sculpt;
use endless_scene::Mesh;

/// The mesh of a piece of furniture; plants are not furniture and come out empty.
pub(crate) fn furniture(prop: Prop, variant: u32) -> Mesh {
    let sculpt = match prop {
        Prop::StreetLamp => lamp::street_lamp(variant),
        Prop::UtilityPole => lamp::utility_pole(),
        Prop::CameraPole => lamp::camera_pole(),
        Prop::SignalPole => signal::pole_head(signal_look::of(variant)),
        Prop::SignalMast => signal::mast(signal_look::of(variant)),
        Prop::SignalCurvedMast => signal::curved_mast(signal_look::of(variant)),
        Prop::WalkSignal => signal::walk(signal_look::of(variant)),
        Prop::StopSign => sign::stop(),
        Prop::YieldSign => sign::give_way(),
        Prop::SpeedSign => sign::speed(variant),
        Prop::CrossingSign => sign::crossing(),
        Prop::Bench => seat::bench(),
        Prop::CafeTable => seat::cafe_table(variant),
        Prop::Bin => small::bin(variant),
        Prop::Hydrant => small::hydrant(variant),
        Prop::PostBox => small::post_box(variant),
        Prop::Bollard => small::bollard(variant),
        Prop::Cone => small::cone(),
        Prop::Cabinet => small::cabinet(),
        Prop::Dumpster => small::dumpster(variant),
        Prop::BikeRack => small::bike_rack(),
        Prop::BusShelter => shelter::bus_shelter(),
        Prop::Billboard => shelter::billboard(variant),
        Prop::Kiosk => shelter::kiosk(variant),
        Prop::Railing => wall::railing(),
        Prop::KerbRail => wall::kerb_rail(variant),
        Prop::FencePanel => wall::fence_panel(),
        Prop::LanternPost => lantern::lantern_post(),
        Prop::ParkLamp => lantern::park_lamp(variant),
        Prop::DoubleLamp => lantern::double_lamp(),
        Prop::HighMast => lantern::high_mast(),
        Prop::CrowdedPole => lamp::crowded_pole(),
        Prop::SpanSignal => signal::span_wire(signal_look::of(variant)),
        Prop::CycleSignal => signal::cycle_signal(signal_look::of(variant)),
        Prop::TrafficSign => sign_face::sign(variant),
        Prop::StreetName => advert::street_name(variant),
        Prop::GuideSign => advert::guide_sign(variant),
        Prop::BusStop => service::bus_stop(),
        Prop::GuardRail => barrier::guard_rail(),
        Prop::JerseyBarrier => barrier::jersey_barrier(),
        Prop::WaterBarrier => barrier::water_barrier(variant),
        Prop::WorksBarrier => barrier::works_barrier(),
        Prop::Barricade => barrier::barricade(),
        Prop::SiteFence => barrier::site_fence(),
        Prop::Drum => barrier::drum(),
        Prop::Beacon => barrier::beacon(),
        Prop::BoomGate => barrier::boom_gate(),
        Prop::ParkingMeter => service::parking_meter(),
        Prop::PayStation => service::pay_station(),
        Prop::PhoneBooth => service::phone_booth(variant),
        Prop::NewsBox => service::news_box(variant),
        Prop::Charger => service::charger(),
        Prop::SpeedCamera => service::speed_camera(variant),
        Prop::DrinkingFountain => service::drinking_fountain(),
        Prop::AdvertColumn => advert::advert_column(variant),
        Prop::CityLight => advert::city_light(variant),
        Prop::SandwichBoard => advert::sandwich_board(variant),
        Prop::Flagpole => advert::flagpole(variant),
        Prop::WheelieBins => waste::wheelie_bins(variant),
        Prop::BottleBank => waste::bottle_bank(variant),
        Prop::Skip => waste::skip(variant),
        Prop::RubbishBags => waste::rubbish_bags(variant),
        Prop::Pallets => waste::pallets(variant),
        Prop::Manhole => waste::manhole(),
        Prop::Drain => waste::drain(),
        Prop::PicnicTable => square::picnic_table(),
        Prop::StoneBench => square::stone_bench(),
        Prop::Fountain => square::fountain(),
        Prop::Monument => square::monument(),
        Prop::MarketStall => square::market_stall(variant),
        Prop::TreeGuard => square::tree_guard(),
        Prop::BikeStand => square::bike_stand(),
        Prop::BrickWall => wall::brick_wall(),
        Prop::StoneWall => wall::stone_wall(),
        Prop::ChainLink => wall::chain_link(),
        Prop::PicketFence => wall::picket_fence(),
        Prop::FoodCart => vendor::food_cart(variant),
        Prop::HandCart => vendor::hand_cart(variant),
        Prop::VendorBlanket => vendor::vendor_blanket(variant),
        Prop::CrateStack => vendor::crate_stack(variant),
        Prop::SandHeap => building::sand_heap(variant),
        Prop::BrickPallet => building::brick_pallet(variant),
        Prop::BuildingStock => building::building_stock(variant),
        Prop::ScaffoldBay => building::scaffold_bay(variant),
        Prop::LaundryLine => building::laundry_line(variant),
        Prop::SatelliteDish => building::satellite_dish(variant),
        Prop::BroadleafTree
        | Prop::Conifer
        | Prop::Palm
        | Prop::Bush
        | Prop::Hedge
        | Prop::Corn
        | Prop::Planter
        | Prop::Cypress
        | Prop::BareTree
        | Prop::FlowerBed
        | Prop::GrassTuft
        | Prop::Wheat
        | Prop::Rock => Sculpt::new(),
    };
    sculpt.into_mesh()
}

/// How many variants there are.
pub(crate) fn variants(prop: Prop) -> u32 {
    match prop {
        Prop::TrafficSign => CODES.len() as u32,
        Prop::Bollard => small::BOLLARDS,
        Prop::KerbRail => wall::KERB_RAILS,
        prop if prop.is_signal() => signal_look::COUNT,
        Prop::AdvertColumn
        | Prop::WheelieBins
        | Prop::RubbishBags
        | Prop::FoodCart
        | Prop::VendorBlanket
        | Prop::CrateStack => 4,
        Prop::StreetLamp
        | Prop::SpeedSign
        | Prop::Hydrant
        | Prop::CafeTable
        | Prop::Billboard
        | Prop::Kiosk
        | Prop::Dumpster
        | Prop::StreetName
        | Prop::CityLight
        | Prop::SandwichBoard
        | Prop::Flagpole
        | Prop::NewsBox
        | Prop::MarketStall
        | Prop::HandCart
        | Prop::SandHeap
        | Prop::BuildingStock
        | Prop::LaundryLine => 3,
        Prop::Bin
        | Prop::PostBox
        | Prop::ParkLamp
        | Prop::GuideSign
        | Prop::WaterBarrier
        | Prop::PhoneBooth
        | Prop::SpeedCamera
        | Prop::BottleBank
        | Prop::Skip
        | Prop::Pallets
        | Prop::BrickPallet
        | Prop::ScaffoldBay
        | Prop::SatelliteDish => 2,
        _ => 1,
    }
}
