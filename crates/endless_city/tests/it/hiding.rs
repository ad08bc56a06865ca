//! Things of a town that are out of sight.

use endless_asset::{Catalogue, Prop};
use endless_city::{TownScene, TownThing};
use endless_render::{FrameDescription, FrameScene, Ray, RayCaster};
use endless_town::{PlacedObject, Placement, Town};
use endless_world::{ClassTag, InstanceId, ParkedVehicle, Pose, VehicleModelId, VehicleRef};
use glam::{Affine3A, Vec3, Vec3A};

/// What a ray meets: its class and its number.
fn met(scene: &TownScene, origin: Vec3A, direction: Vec3A) -> Option<(ClassTag, InstanceId)> {
    let nobody = FrameScene::new(FrameDescription::default());
    let caster = RayCaster::new(scene.static_scene(), &nobody);
    caster.closest(&Ray { origin, direction, tmax: 60.0 }).map(|hit| (hit.tag, hit.id))
}

/// What one from above meets.
fn below(scene: &TownScene, x: f32, y: f32) -> Option<(ClassTag, InstanceId)> {
    met(scene, Vec3A::new(x, y, 50.0), Vec3A::NEG_Z)
}

#[test]
fn hidden_things_are_gone_and_others_keep_their_numbers() {
    let catalogue = Catalogue::builtin();
    let place = |x: f32| Placement {
        object: PlacedObject::Prop(Prop::SignalMast, 0),
        world_from_object: Affine3A::from_translation(Vec3::new(x, 0.0, 0.0)),
        signal: None,
    };
    let parked = |x: f32| ParkedVehicle {
        vehicle: VehicleRef { model: VehicleModelId(0), variant: 0 },
        pose: Pose::level(Vec3::new(x, 20.0, 0.0), 0.0),
    };
    let town =
        Town { placements: vec![place(0.0), place(30.0)], parked: vec![parked(0.0), parked(30.0)], ..Town::default() };
    let whole = TownScene::load(&town, &catalogue).expect("few vehicles");
    let numbers = [below(&whole, 0.0, 20.0), below(&whole, 30.0, 20.0)].map(|met| met.map(|(_, id)| id));
    assert_eq!(numbers, [Some(InstanceId(1)), Some(InstanceId(2))]);
    // Two heads hang on the arm of a mast, and face to the east.
    let facing = |scene: &TownScene, y: f32| met(scene, Vec3A::new(5.0, y, 5.7), Vec3A::NEG_X);
    let is_head = |&y: &f32| facing(&whole, y).is_some_and(|(class, _)| class == ClassTag::TrafficLight);
    let head = (0u8..120).map(|step| -0.05 * f32::from(step)).find(is_head).expect("a head");

    let gone = |thing: TownThing, class: ClassTag| match thing {
        TownThing::Parked(number) => number == 0,
        TownThing::Placed(number) => number == 1 || class == ClassTag::TrafficLight,
    };
    let left = whole.without(gone);
    assert_eq!(below(&left, 0.0, 20.0), None);
    assert_eq!(below(&left, 30.0, 20.0), below(&whole, 30.0, 20.0));
    assert_ne!(facing(&left, head), facing(&whole, head));
    assert!(below(&left, 0.0, 0.0).is_some(), "the pole still stands");
    assert_eq!((below(&whole, 30.0, 0.0).is_some(), below(&left, 30.0, 0.0)), (true, None));
    // Nothing is lost by what is taken away later, or not at all.
    let digest = |scene: &TownScene| {
        let mut bytes = Vec::new();
        scene.static_scene().write_geometry(&mut bytes).expect("memory");
        bytes
    };
    assert_eq!(digest(&whole.without(|_, _| false)), digest(&whole));
    assert_eq!(digest(&whole.without(gone)), digest(&left.without(gone)));
    assert!(left.without(|_, _| true).static_scene().instances().is_empty());
}
