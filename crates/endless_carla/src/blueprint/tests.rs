//! Tests of the library.

use super::*;
use crate::wire::{ActorDefinition, ActorDescription};
use crate::wire::{Color, Wire};
use endless_asset::Catalogue;
use endless_world::{Outfit, PersonAttributes, PersonRef, Sex};
use proptest::prelude::{any, proptest};
use std::collections::HashSet;
use std::sync::LazyLock;

fn set(description: &mut ActorDescription, id: &str, value: &str) {
    let attribute = description.attributes.iter_mut().find(|attribute| attribute.id == id).expect("an attribute");
    value.clone_into(&mut attribute.value);
}

#[test]
fn ids_and_numbers_are_distinct_and_in_order() {
    let library = BlueprintLibrary::new();
    let definitions = library.definitions();
    assert!(definitions.windows(2).all(|pair| pair[0].id < pair[1].id));
    assert!(definitions.iter().zip(1..).all(|(definition, uid)| definition.uid == uid));
    let ids: HashSet<&str> = library.blueprints().iter().map(|b| b.definition.id.as_str()).collect();
    assert_eq!(ids.len(), library.blueprints().len());
    for blueprint in library.blueprints() {
        let attributes: HashSet<&str> = blueprint.definition.attributes.iter().map(|a| a.id.as_str()).collect();
        assert_eq!(attributes.len(), blueprint.definition.attributes.len(), "{}", blueprint.definition.id);
        assert_eq!(library.find(&blueprint.definition.id), Some(blueprint));
    }
    assert_eq!(definitions, BlueprintLibrary::new().definitions());
}

#[test]
fn all_vehicles_and_walkers_of_carla_are_there_with_a_body() {
    let library = BlueprintLibrary::new();
    let catalogue = Catalogue::builtin();
    let (vehicles, walkers) = Catalogue::carla_ids();
    assert_eq!((vehicles.len(), walkers.len()), (41, 51));
    for id in vehicles {
        let Some(BlueprintKind::Vehicle(vehicle)) = library.find(id).map(|b| b.kind) else { panic!("no {id}") };
        assert_eq!(Some(vehicle.model), catalogue.carla_vehicle(id));
        let spec = &catalogue.vehicle(vehicle.model).expect("a model").spec;
        assert_eq!(spec.ridden, vehicle.base_type.two_wheeled(), "{id}");
    }
    for id in walkers {
        let Some(BlueprintKind::Walker(walker)) = library.find(&id).map(|b| b.kind) else { panic!("no {id}") };
        assert_eq!(Some(walker.person), Catalogue::carla_walker(&id));
        assert_eq!(walker.child, walker.person_in_wheelchair.is_none(), "{id}");
    }
    let of = |prefix: &str| library.definitions().iter().filter(|d| d.id.starts_with(prefix)).count();
    assert_eq!((of("vehicle."), of("walker."), of("sensor.")), (41, 51, 16));
}

#[test]
fn all_defaults_and_recommended_values_are_of_their_types() {
    for blueprint in BlueprintLibrary::new().blueprints() {
        for attribute in &blueprint.definition.attributes {
            for value in attribute.recommended_values.iter().chain([&attribute.value]) {
                let checked = reading::check(attribute, value);
                assert_eq!(checked, Ok(()), "{}", blueprint.definition.id);
            }
            assert_eq!(attribute.is_modifiable, !attribute.recommended_values.is_empty(), "{attribute:?}");
        }
        let description = blueprint.description();
        assert_eq!(blueprint.attributes(&description).complete(), Ok(description.clone()));
        assert_eq!(blueprint.attributes(&ActorDescription::default()).complete(), Ok(description));
    }
}

#[test]
fn all_definitions_come_back_from_the_wire() {
    for definition in BlueprintLibrary::new().definitions() {
        let mut bytes = Vec::new();
        rmpv::encode::write_value(&mut bytes, &definition.to_value()).expect("memory");
        let value = rmpv::decode::read_value(&mut bytes.as_slice()).expect("msgpack");
        assert_eq!(ActorDefinition::from_value(&value).as_ref(), Ok(definition));
    }
}

#[test]
fn boxes_are_those_of_the_catalogues() {
    let library = BlueprintLibrary::new();
    let model3 = library.find("vehicle.tesla.model3").expect("a car");
    assert_eq!(model3.bounding_box.extent.x, 2.395_89);
    assert_eq!(model3.bounding_box.location.z, 0.735_9);
    assert_eq!(model3.semantic_tags, [14]);
    let child = library.find("walker.pedestrian.0009").expect("a child");
    assert_eq!(child.bounding_box.extent.z, 0.55);
    for blueprint in library.blueprints() {
        let BlueprintKind::Prop(prop) = blueprint.kind else { continue };
        let bounds = &blueprint.bounding_box;
        let flat = bounds.extent.x * bounds.extent.y * bounds.extent.z == 0.0;
        assert!(!flat || blueprint.definition.id == "static.prop.mesh", "{}", blueprint.definition.id);
        if prop.body.is_some() {
            // They stand on the ground.
            assert!((bounds.location.z - bounds.extent.z).abs() < 0.4, "{}: {bounds:?}", blueprint.definition.id);
        }
    }
}

#[test]
fn sensors_have_the_numbers_of_their_streams() {
    let library = BlueprintLibrary::new();
    let numbers: HashSet<u64> = SensorKind::ALL.iter().map(|kind| kind.stream_type_id()).collect();
    assert_eq!(numbers.len(), SensorKind::ALL.len());
    for kind in SensorKind::ALL {
        let blueprint = library.find(kind.id()).expect("a sensor");
        assert_eq!(blueprint.kind, BlueprintKind::Sensor(kind));
        let attributes = blueprint.description();
        assert_eq!(blueprint.attributes(&attributes).image_size().is_ok(), kind.is_camera());
    }
    assert_eq!(SensorKind::ALL.iter().filter(|kind| !kind.streams()).count(), 1);
}

#[test]
fn a_camera_is_as_the_client_wants_it() {
    let library = BlueprintLibrary::new();
    let camera = library.find("sensor.camera.rgb").expect("a camera");
    let mut description = camera.description();
    assert_eq!(camera.attributes(&description).image_size(), Ok([800, 600]));
    assert_eq!(camera.attributes(&description).fov_degrees(), Ok(90.0));
    set(&mut description, "image_size_x", "1920");
    set(&mut description, "image_size_y", "1080.0");
    set(&mut description, "enable_postprocess_effects", "False");
    let attributes = camera.attributes(&description);
    assert_eq!(attributes.image_size(), Ok([1920, 1080]));
    assert_eq!(attributes.flag("enable_postprocess_effects"), Ok(false));
    assert!(matches!(attributes.number("range"), Err(AttributeError::Unknown { .. })));

    set(&mut description, "image_size_x", "abc");
    let error = camera.attributes(&description).image_size().expect_err("no number");
    assert_eq!(error.to_string(), "attribute image_size_x: expected a number, got \"abc\"");
    assert!(camera.attributes(&description).complete().is_err());
    for (id, value) in [("image_size_x", "0"), ("image_size_x", "16385"), ("fov", "180"), ("sensor_tick", "-1")] {
        let mut description = camera.description();
        set(&mut description, id, value);
        let error = camera.attributes(&description).complete().expect_err(value);
        assert!(matches!(error, AttributeError::OutOfRange { .. }), "{error}");
    }
    set(&mut description, "image_size_x", "16384");
    set(&mut description, "image_size_y", "16384");
    let error = camera.attributes(&description).image_size().expect_err("too large");
    assert_eq!(error, AttributeError::TooManyPixels { width: 16384, height: 16384 });
}

#[test]
fn what_may_not_be_changed_stays() {
    let library = BlueprintLibrary::new();
    let car = library.find("vehicle.audi.tt").expect("a car");
    let mut description = car.description();
    set(&mut description, "number_of_wheels", "17");
    set(&mut description, "color", " 1, 2,3");
    let attributes = car.attributes(&description);
    assert_eq!(attributes.integer("number_of_wheels"), Ok(4));
    assert_eq!(attributes.color("color"), Ok(Color { r: 1, g: 2, b: 3 }));
}

#[test]
fn a_red_car_is_red() {
    let library = BlueprintLibrary::new();
    let catalogue = Catalogue::builtin();
    let BlueprintKind::Vehicle(car) = library.find("vehicle.audi.tt").expect("a car").kind else { panic!("no car") };
    let red = car.reference(&catalogue, Some(Color { r: 200, g: 10, b: 10 }), 7);
    let [r, g, b] = catalogue.vehicle_tint(red).expect("a paint");
    assert!(r > 2.0 * g && r > 2.0 * b, "{r} {g} {b}");
    assert_eq!(car.reference(&catalogue, None, 7).variant, 7);
}

#[test]
fn so_many_people_ride_two_wheelers_of_a_model() {
    let (catalogue, library) = (Catalogue::builtin(), BlueprintLibrary::new());
    let look = |id: &str, actor: u32| {
        let BlueprintKind::Vehicle(vehicle) = library.find(id).expect("CARLA has it").kind else {
            panic!("no vehicle")
        };
        vehicle.reference(&catalogue, None, actor)
    };
    let bike = |actor| look("vehicle.bh.crossbike", actor);
    assert!(bike(3) != bike(4) && bike(3) == bike(3 + 64));
    let car = |actor| look("vehicle.lincoln.mkz_2020", actor);
    assert!(car(3) != car(3 + 64));
}

#[test]
fn walkers_are_of_the_sex_that_their_blueprint_says() {
    let library = BlueprintLibrary::new();
    let mut women = 0;
    for blueprint in library.blueprints() {
        let BlueprintKind::Walker(walker) = blueprint.kind else { continue };
        let description = blueprint.description();
        let female = blueprint.attributes(&description).text("gender") == Ok("female");
        let of = |seed| Catalogue::person_attributes(PersonRef { outfit: Outfit::Fair, seed });
        let seated = |person: &PersonAttributes| person.carries.iter().any(|carried| carried.piece == "wheelchair");
        let person = of(walker.person);
        assert_eq!(female, person.sex == Sex::Female);
        assert!(!seated(&person), "{}", blueprint.definition.id);
        if let Some(other) = walker.person_in_wheelchair.map(of) {
            assert!(seated(&other) && other.sex == person.sex, "{}", blueprint.definition.id);
        }
        women += u32::from(female);
    }
    assert!((15..=36).contains(&women), "{women}");
}

proptest! {
    #[test]
    fn no_text_is_too_much(text in any::<String>(), number in any::<f64>()) {
        static LIBRARY: LazyLock<BlueprintLibrary> = LazyLock::new(BlueprintLibrary::new);
        let library = &*LIBRARY;
        for id in ["sensor.camera.rgb", "vehicle.vespa.zx125"] {
            let blueprint = library.find(id).expect("a blueprint");
            for text in [text.clone(), number.to_string(), format!("{number:e}")] {
                let mut description = blueprint.description();
                for attribute in &mut description.attributes {
                    attribute.value.clone_from(&text);
                }
                let attributes = blueprint.attributes(&description);
                let _ = (attributes.complete(), attributes.image_size(), attributes.color("color"));
            }
        }
    }
}
