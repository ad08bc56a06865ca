//! Street furniture stands on the ground, is closed as seen from outside, and has the sizes of the real things.

use crate::soup::Soup;
use endless_asset::{Catalogue, Prop};
use endless_scene::Surface;
use std::sync::LazyLock;

static CATALOGUE: LazyLock<Catalogue> = LazyLock::new(Catalogue::builtin);

fn furniture() -> impl Iterator<Item = (Prop, u32)> {
    let all = Prop::ALL.iter().copied().filter(|p| !p.is_plant());
    all.flat_map(|p| (0..CATALOGUE.prop_variants(p)).map(move |v| (p, v)))
}

#[test]
fn there_are_sixty_kinds_and_no_two_are_called_alike() {
    let kinds: Vec<&str> = Prop::ALL.iter().filter(|p| !p.is_plant()).map(|p| p.name()).collect();
    assert!(kinds.len() >= 60, "{}", kinds.len());
    for (i, name) in kinds.iter().enumerate() {
        assert!(!kinds[..i].contains(name), "{name}");
    }
}

#[test]
fn furniture_stands_on_the_ground_about_its_origin() {
    for (prop, variant) in furniture() {
        let (low, high) = CATALOGUE.prop(prop, variant).bounds();
        assert!(low.z > -0.06 && low.z < 0.07, "{prop:?} {variant} begins at {}", low.z);
        assert!(low.x <= 0.001 && low.y <= 0.001 && high.x >= -0.001 && high.y >= -0.001, "{prop:?}: {low} {high}");
    }
}

/// Cloth, netting and flags are sheets with both their sides; nobody sees the inside of anything.
#[test]
fn furniture_is_closed_as_seen_from_outside() {
    const RAYS: usize = 400;
    let mut open = Vec::new();
    for (prop, variant) in furniture().filter(|f| f.1 < 3) {
        let soup = Soup::new(&CATALOGUE.prop(prop, variant));
        let (met, inner) = soup.inner_sides(RAYS, prop.name());
        if met > 0 && inner * 50 > met {
            open.push(format!("{prop:?} {variant}: {inner} of {met}"));
        }
    }
    assert!(open.is_empty(), "{open:#?}");
}

/// Heights in metres, from standards and data sheets.
#[test]
fn furniture_has_the_sizes_of_the_real_things() {
    let sizes = [
        (Prop::LanternPost, 3.5, 5.0),
        (Prop::ParkLamp, 3.0, 4.5),
        (Prop::DoubleLamp, 8.0, 12.0),
        (Prop::HighMast, 18.0, 30.0),
        (Prop::CrowdedPole, 8.0, 11.0),
        (Prop::SpanSignal, 5.5, 9.0),
        (Prop::SignalCurvedMast, 5.7, 6.3),
        (Prop::TrafficSign, 2.2, 3.2),
        (Prop::StreetName, 2.1, 3.3),
        (Prop::GuideSign, 3.0, 6.0),
        (Prop::BusStop, 2.4, 3.2),
        (Prop::GuardRail, 0.70, 0.80),
        (Prop::JerseyBarrier, 0.81, 0.92),
        (Prop::WaterBarrier, 0.6, 1.1),
        (Prop::Drum, 0.9, 1.1),
        (Prop::ParkingMeter, 1.3, 1.6),
        (Prop::PhoneBooth, 2.2, 2.7),
        (Prop::AdvertColumn, 2.8, 4.2),
        (Prop::WheelieBins, 1.0, 1.15),
        (Prop::BottleBank, 1.4, 2.0),
        (Prop::Skip, 1.0, 1.5),
        (Prop::Manhole, 0.0, 0.02),
        (Prop::Drain, 0.0, 0.02),
        (Prop::PicnicTable, 0.7, 0.8),
        (Prop::StoneBench, 0.4, 0.5),
        (Prop::MarketStall, 2.3, 3.0),
        (Prop::FoodCart, 1.9, 2.6),
        (Prop::HandCart, 0.6, 1.4),
        (Prop::VendorBlanket, 0.2, 0.5),
        (Prop::CrateStack, 0.5, 1.5),
        (Prop::SandHeap, 0.6, 0.9),
        (Prop::BrickPallet, 0.8, 1.2),
        (Prop::BuildingStock, 0.1, 1.3),
        (Prop::ScaffoldBay, 4.5, 5.5),
        (Prop::LaundryLine, 1.9, 2.2),
        (Prop::KerbRail, 0.95, 1.1),
        (Prop::Bollard, 0.75, 1.1),
        (Prop::Hydrant, 0.7, 1.15),
        (Prop::SatelliteDish, 0.8, 1.2),
        (Prop::BrickWall, 1.7, 2.0),
        (Prop::ChainLink, 1.7, 2.0),
        (Prop::PicketFence, 0.85, 1.1),
    ];
    for (prop, low, high) in sizes {
        for variant in 0..CATALOGUE.prop_variants(prop) {
            let top = CATALOGUE.prop(prop, variant).bounds().1.z;
            assert!((low..=high).contains(&top), "{prop:?} {variant} is {top} m high");
        }
    }
}

#[test]
fn lamps_have_lenses_and_lights_have_all_their_colours() {
    let surfaces =
        |prop, variant| -> Vec<Surface> { CATALOGUE.prop(prop, variant).materials.iter().map(|m| m.surface).collect() };
    for &prop in Prop::ALL.iter().filter(|prop| prop.is_street_lamp()) {
        for variant in 0..CATALOGUE.prop_variants(prop) {
            assert!(surfaces(prop, variant).contains(&Surface::LampLens), "{prop:?} {variant}");
        }
    }
    for &prop in Prop::ALL.iter().filter(|&&prop| prop.is_vehicle_signal() || prop == Prop::CycleSignal) {
        let lenses = surfaces(prop, 0).iter().filter(|s| matches!(s, Surface::SignalLens(_))).count();
        assert_eq!(lenses, 3, "{prop:?}");
    }
}
