use super::*;
use crate::wire::Vector3D;
use endless_asset::Prop;
use endless_scene::{Material, MeshBuilder, Surface};
use glam::Vec3;

/// The boxes of a mesh as they stand in their own frame.
fn boxes(parts: &[Part]) -> Vec<(DVec2, DVec2)> {
    parts.iter().map(|part| part.outline.bounds()).collect()
}

#[test]
fn a_building_is_its_walls() {
    let brick = Material::new(Surface::Brick, [0.5; 3], ClassTag::Buildings);
    let mut builder = MeshBuilder::new();
    builder.cuboid(Vec3::new(-6.0, -4.0, -2.0), Vec3::new(6.0, 4.0, 9.0), brick);
    let walls = walls::walls(&builder.finish());
    assert_eq!(walls.len(), 4);
    assert!(walls.iter().all(|wall| wall.tag == ClassTag::Buildings && wall.outline.half.min_element() < 0.2));
    let (low, high) = boxes(&walls).into_iter().fold((DVec2::MAX, DVec2::MIN), |(a, b), (c, d)| (a.min(c), b.max(d)));
    assert!(low.distance(DVec2::new(-6.1, -4.1)) < 0.1 && high.distance(DVec2::new(6.1, 4.1)) < 0.1);
    // Nobody walks into a door step, an awning or leaves.
    for (low_m, high_m, surface) in
        [(0.0, 0.3, Surface::Stone), (2.4, 3.0, Surface::Cloth), (0.0, 3.0, Surface::Foliage)]
    {
        let mut builder = MeshBuilder::new();
        let material = Material::new(surface, [0.5; 3], ClassTag::Buildings);
        builder.cuboid(Vec3::new(0.0, 0.0, low_m), Vec3::new(1.0, 1.0, high_m), material);
        assert!(walls::walls(&builder.finish()).is_empty());
    }
}

#[test]
fn props_stand_where_they_touch_the_ground() {
    let catalogue = Catalogue::builtin();
    let of = |prop| boxes(&pieces::pieces(&catalogue.prop(prop, 0)));
    let tree = of(Prop::BroadleafTree);
    assert!(tree.len() == 1 && (tree[0].1 - tree[0].0).max_element() < 1.2, "{tree:?}");
    // Two poles, and the wire between them is high.
    assert_eq!(of(Prop::SpanSignal).len(), 2);
    let mast = of(Prop::SignalMast);
    assert!(mast.iter().all(|(low, high)| (high - low).max_element() < 1.0), "{mast:?}");
    assert!(of(Prop::Manhole).is_empty() && of(Prop::Hedge).is_empty() && of(Prop::GrassTuft).is_empty());
    let wall = of(Prop::BrickWall);
    assert!(wall.len() == 1 && (wall[0].1.x - wall[0].0.x - 2.0).abs() < 0.2, "{wall:?}");
}

#[test]
fn lanes_of_a_town_are_free_and_its_sides_are_not() {
    let catalogue = Catalogue::builtin();
    let town = endless_town::load("Town02", &catalogue).expect("a town");
    let roads = CarlaMap::new(&town, String::new());
    let obstacles = MapObstacles::new(&town, &roads, &catalogue);
    let found = |at: DVec2, reach_m: f64| {
        let mut found = Vec::new();
        obstacles.near(at - reach_m, at + reach_m, &mut found);
        found
    };
    for point in roads.spawn_points() {
        let bounds = BoundingBox {
            location: Vector3D { z: 1.0, ..Vector3D::default() },
            extent: Vector3D { x: 2.4, y: 1.0, z: 0.7 },
            ..BoundingBox::default()
        };
        let body = upright(point, &bounds);
        let met = found(body.centre, 3.0).into_iter().find(|other| body.touches(&other.outline));
        assert_eq!(met, None, "{point:?}");
    }
    let count = |wanted: ClassTag| obstacles.all.iter().filter(|one| one.part.tag == wanted).count();
    for tag in [ClassTag::Buildings, ClassTag::Vegetation, ClassTag::Poles, ClassTag::Car] {
        assert!(count(tag) > 20, "{}: {}", tag.name(), count(tag));
    }
    // A grid finds what looking at all finds.
    for (index, MapObstacle { part: Part { outline, tag, .. }, .. }) in obstacles.all.iter().enumerate().step_by(97) {
        let id = FIRST + index as u64;
        assert!(found(outline.centre, 0.5).iter().any(|other| other.id == id && other.outline == *outline));
        assert_eq!(obstacles.tag(id), Some(*tag));
    }
    // Of a hidden thing nothing is found, and all is again when nothing is hidden.
    let first = obstacles.all[0];
    let others = obstacles.without(|thing, _| thing == first.thing);
    let at = first.part.outline.centre;
    let near = |obstacles: &MapObstacles| {
        let mut found = Vec::new();
        obstacles.near(at - 0.5, at + 0.5, &mut found);
        found
    };
    assert!(near(&obstacles).iter().any(|other| other.id == FIRST));
    assert!(near(&others).iter().all(|other| other.id != FIRST));
    assert_eq!(near(&others.without(|_, _| false)), near(&obstacles));
    assert_eq!((obstacles.tag(7), obstacles.tag(u64::MAX)), (None, None));
}
