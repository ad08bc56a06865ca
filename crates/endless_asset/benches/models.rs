//! Building vehicles and people, and what a person costs in every frame: the stance, its vertices, its keypoints.

use divan::counter::ItemsCount;
use endless_asset::{Catalogue, PersonModel, VehicleModel};
use endless_world::{Gait, ObjectClass, WalkerMotion};

fn main() {
    divan::main();
}

/// The meshes of a new draw of the first design of a class; items are triangles.
#[divan::bench(args = [ObjectClass::Car, ObjectClass::Truck, ObjectClass::Bus, ObjectClass::Bicycle])]
fn vehicle(bencher: divan::Bencher<'_, '_>, class: ObjectClass) {
    let designs = Catalogue::vehicle_designs();
    let design = designs.iter().find(|design| design.class == class).expect("a design of each class");
    // A model keeps its meshes: each is drawn anew.
    let draw = || Catalogue::draw_vehicle(design.name, 0).expect("a design of the catalogue");
    let build = |model: VehicleModel| model.whole();
    bencher.counter(ItemsCount::new(build(draw()).triangles.len())).with_inputs(draw).bench_values(build);
}

/// A person with clothes, hair and what is carried, from the seed.
#[divan::bench]
fn person(bencher: divan::Bencher<'_, '_>) {
    let catalogue = Catalogue::builtin();
    let mut seed = 0;
    bencher
        .with_inputs(|| {
            seed += 1;
            seed
        })
        .bench_local_values(|seed| catalogue.person(seed));
}

fn walker() -> (PersonModel, WalkerMotion) {
    let motion =
        WalkerMotion { speed_mps: 1.4, gait: Gait::Walk, walked_m: 3.1, time_s: 2.2, footing: None, risen: 0.0 };
    (Catalogue::builtin().person(7), motion)
}

#[divan::bench]
fn stance(bencher: divan::Bencher<'_, '_>) {
    let (person, motion) = walker();
    bencher.bench(|| person.stance(divan::black_box(&motion)));
}

/// All vertices of a person, without normals; items are vertices.
#[divan::bench]
fn vertices(bencher: divan::Bencher<'_, '_>) {
    let (person, motion) = walker();
    let stance = person.stance(&motion);
    let mut positions = person.rest.positions.clone();
    bencher.counter(ItemsCount::new(positions.len())).bench_local(|| {
        person.place(divan::black_box(&stance), &mut positions);
        positions[0]
    });
}

#[divan::bench]
fn keypoints(bencher: divan::Bencher<'_, '_>) {
    let (person, motion) = walker();
    bencher.bench(|| person.keypoints(divan::black_box(&motion)));
}
