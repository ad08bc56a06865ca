//! The one list of vehicle designs.

use super::assemble::VehicleBlueprint;
use super::draw::DesignDraw;
use super::tint::{self, PaintShare};
use super::{articulated, bus, cars, conventional, emergency, fire, heavy, minivan};
use super::{stake, three_wheeler, trade, truck, two_wheeler, van};
use endless_world::ObjectClass;

/// What all draws of a design have in common.
pub(crate) struct VehicleDesign {
    /// Unique.
    pub(crate) name: &'static str,
    pub(crate) class: ObjectClass,
    /// Comfortable speed on an empty road, m/s.
    pub(crate) cruise_mps: f32,
    /// m/s².
    pub(crate) acceleration_mps2: f32,
    /// Relative frequency on the road, of all draws together. Sums by class are those of a city: cars 78, vans 8,
    /// lorries 5, buses 3, motorcycles 6, bicycles 3.
    pub(crate) frequency: f64,
    /// Whether it may stand parked at a kerb.
    pub(crate) parks: bool,
    /// Whether who drives it sits in the open: an object of their own.
    pub(crate) ridden: bool,
    /// How many draws the catalogue holds.
    pub(crate) draws: u8,
    pub(crate) paints: &'static [PaintShare],
    pub(crate) blueprint: fn(&DesignDraw) -> VehicleBlueprint,
}

type DrawBlueprint = fn(&DesignDraw) -> VehicleBlueprint;

const fn car(name: &'static str, frequency: f64, draws: u8, blueprint: DrawBlueprint) -> VehicleDesign {
    VehicleDesign {
        name,
        class: ObjectClass::Car,
        cruise_mps: 38.0,
        acceleration_mps2: 2.0,
        frequency,
        parks: true,
        ridden: false,
        draws,
        paints: tint::CARS,
        blueprint,
    }
}

const fn van(name: &'static str, frequency: f64, draws: u8, blueprint: DrawBlueprint) -> VehicleDesign {
    VehicleDesign {
        class: ObjectClass::Van,
        cruise_mps: 34.0,
        acceleration_mps2: 1.5,
        paints: tint::VANS,
        ..car(name, frequency, draws, blueprint)
    }
}

const fn truck(name: &'static str, frequency: f64, draws: u8, blueprint: DrawBlueprint) -> VehicleDesign {
    VehicleDesign {
        class: ObjectClass::Truck,
        cruise_mps: 23.0,
        acceleration_mps2: 1.0,
        parks: false,
        paints: tint::TRUCKS,
        ..car(name, frequency, draws, blueprint)
    }
}

const fn bus(name: &'static str, frequency: f64, draws: u8, blueprint: DrawBlueprint) -> VehicleDesign {
    VehicleDesign {
        class: ObjectClass::Bus,
        cruise_mps: 22.0,
        acceleration_mps2: 1.1,
        parks: false,
        paints: tint::BUSES,
        ..car(name, frequency, draws, blueprint)
    }
}

const fn motorcycle(name: &'static str, frequency: f64, draws: u8, blueprint: DrawBlueprint) -> VehicleDesign {
    VehicleDesign {
        class: ObjectClass::Motorcycle,
        cruise_mps: 34.0,
        acceleration_mps2: 2.4,
        ridden: true,
        paints: tint::MOTORCYCLES,
        ..car(name, frequency, draws, blueprint)
    }
}

const fn bicycle(name: &'static str, frequency: f64, draws: u8, blueprint: DrawBlueprint) -> VehicleDesign {
    VehicleDesign {
        class: ObjectClass::Bicycle,
        cruise_mps: 4.8,
        acceleration_mps2: 0.9,
        parks: false,
        ridden: true,
        paints: tint::BICYCLES,
        ..car(name, frequency, draws, blueprint)
    }
}

impl VehicleDesign {
    const fn painted(self, paints: &'static [PaintShare]) -> Self {
        Self { paints, ..self }
    }

    const fn never_parked(self) -> Self {
        Self { parks: false, ..self }
    }

    /// Driven in the open.
    const fn ridden(self) -> Self {
        Self { ridden: true, ..self }
    }

    const fn cruising(self, cruise_mps: f32) -> Self {
        Self { cruise_mps, ..self }
    }
}

/// The frequency of what European streets hardly have: regions that do have it take it this many thousand times
/// (`vehicle_mix` of the traffic crate).
const ELSEWHERE: f64 = 0.001;

/// All of them: by class, then those of other regions and of other decades.
pub(crate) static DESIGNS: &[VehicleDesign] = &[
    car("car.micro", 1.5, 2, cars::micro),
    car("car.city", 8.0, 3, cars::city),
    car("car.hatchback", 13.0, 4, cars::hatchback),
    car("car.liftback", 3.5, 2, cars::liftback),
    car("car.sedan", 10.0, 4, cars::sedan),
    car("car.executive", 4.0, 2, cars::executive),
    car("car.estate", 4.5, 3, cars::estate),
    car("car.coupe", 2.5, 2, cars::coupe),
    car("car.crossover", 6.0, 3, cars::crossover),
    car("car.suv", 7.0, 3, cars::suv),
    car("car.suv_large", 2.5, 2, cars::large_suv),
    car("car.offroad", 1.0, 2, cars::offroad),
    car("car.mpv", 4.0, 2, cars::mpv),
    car("car.pickup", 3.6, 2, cars::pickup),
    car("car.trailer", 0.5, 2, articulated::car_with_trailer).never_parked(),
    car("car.pickup_large", 1.0, 2, cars::large_pickup),
    car("car.taxi", 3.6, 2, cars::taxi).painted(tint::TAXIS),
    car("car.taxi_mpv", 0.8, 1, cars::large_taxi).painted(tint::TAXIS),
    car("car.police", 1.0, 2, emergency::police_car).painted(tint::POLICE),
    car("car.police_suv", 0.4, 1, emergency::police_suv).painted(tint::POLICE),
    van("van.small", 2.2, 2, van::small),
    van("van.panel", 2.8, 2, van::panel),
    van("van.high", 1.0, 2, van::high),
    van("van.minibus", 1.2, 2, van::minibus),
    van("van.camper", 0.3, 1, van::camper).painted(tint::CAMPERS),
    van("van.ambulance", 0.4, 2, emergency::ambulance).painted(tint::AMBULANCES),
    van("van.police", 0.3, 1, emergency::police_van).painted(tint::WHITES),
    truck("truck.box_small", 1.0, 2, truck::small_box),
    truck("truck.box", 1.0, 2, truck::box_truck),
    truck("truck.flatbed", 0.7, 2, heavy::flatbed),
    truck("truck.tipper", 0.6, 2, truck::tipper),
    truck("truck.mixer", 0.25, 1, heavy::mixer),
    truck("truck.tanker", 0.25, 1, heavy::tanker),
    truck("truck.tractor", 0.1, 1, heavy::tractor),
    truck("truck.refuse", 0.35, 1, heavy::refuse).painted(tint::REFUSE),
    truck("truck.fire", 0.15, 1, fire::engine).painted(tint::FIRE),
    truck("truck.semi", 0.6, 2, articulated::semi),
    bus("bus.midi", 0.6, 2, bus::midi),
    bus("bus.school", 0.2, 1, bus::school).painted(tint::SCHOOL),
    bus("bus.double", 0.3, 1, bus::double_decker),
    bus("bus.city", 1.1, 2, bus::city),
    bus("bus.articulated", 0.3, 1, bus::articulated),
    bus("bus.coach", 0.5, 1, bus::coach).cruising(27.0),
    motorcycle("motorcycle.scooter", 1.4, 2, two_wheeler::scooter).cruising(25.0),
    motorcycle("motorcycle.scooter_delivery", 0.8, 2, two_wheeler::moped_delivery).cruising(13.0),
    motorcycle("motorcycle.commuter", 1.9, 2, two_wheeler::commuter).cruising(28.0),
    motorcycle("motorcycle.delivery", 0.7, 2, two_wheeler::delivery),
    motorcycle("motorcycle.sport", 0.7, 2, two_wheeler::sport).cruising(42.0),
    motorcycle("motorcycle.cruiser", 0.5, 2, two_wheeler::cruiser),
    bicycle("bicycle.city", 1.3, 2, two_wheeler::city),
    bicycle("bicycle.mountain", 0.6, 2, two_wheeler::mountain).cruising(5.2),
    bicycle("bicycle.road", 0.4, 1, two_wheeler::road).cruising(7.0),
    bicycle("bicycle.cargo", 0.25, 1, two_wheeler::cargo).cruising(4.5),
    bicycle("bicycle.kick_scooter", 0.45, 1, two_wheeler::kick_scooter).cruising(5.0),
    car("car.auto_rickshaw", ELSEWHERE, 4, three_wheeler::auto_rickshaw)
        .painted(tint::THREE_WHEELERS)
        .ridden()
        .cruising(13.0),
    van("van.cargo_tricycle", ELSEWHERE, 4, three_wheeler::cargo_tricycle)
        .painted(tint::THREE_WHEELERS)
        .ridden()
        .cruising(11.0),
    motorcycle("motorcycle.underbone", ELSEWHERE, 3, two_wheeler::underbone).cruising(22.0),
    motorcycle("motorcycle.underbone_delivery", ELSEWHERE, 4, two_wheeler::underbone_delivery).cruising(20.0),
    motorcycle("motorcycle.scooter_for_two", ELSEWHERE, 2, two_wheeler::scooter_for_two).cruising(22.0),
    motorcycle("motorcycle.commuter_for_two", ELSEWHERE, 3, two_wheeler::commuter_for_two).cruising(25.0),
    car("car.saloon_old", ELSEWHERE, 4, cars::old_saloon).painted(tint::OLD),
    car("car.hatchback_old", ELSEWHERE, 4, cars::old_hatchback).painted(tint::OLD),
    car("car.pickup_old", ELSEWHERE, 4, cars::old_pickup).painted(tint::OLD),
    car("car.hatchback_worn", ELSEWHERE, 4, cars::worn_hatchback),
    car("car.sedan_worn", ELSEWHERE, 4, cars::worn_sedan),
    van("van.kei", ELSEWHERE, 4, minivan::kei),
    van("van.cab_over", ELSEWHERE, 4, minivan::cab_over),
    van("van.small_trade", ELSEWHERE, 3, trade::small),
    van("van.panel_trade", ELSEWHERE, 3, trade::panel),
    truck("truck.stake", ELSEWHERE, 4, stake::stake),
    truck("truck.conventional", ELSEWHERE, 3, conventional::conventional),
    bus("bus.colectivo", ELSEWHERE, 4, bus::colectivo).painted(tint::COLECTIVOS),
];
