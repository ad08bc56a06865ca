//! What stands in the towns: sound meshes, cameras that see, nothing on the carriageways.

use crate::towns;
use endless_asset::{Catalogue, Prop};
use endless_scene::Mesh;
use endless_town::{PlacedObject, Town};
use endless_world::{CameraSite, ClassTag, ImageSize, LensModel, Mount, PinholeCamera};
use glam::{Affine3A, DVec2, DVec3, Vec3};
use rayon::prelude::*;

fn volume(mesh: &Mesh) -> f64 {
    let sum: f64 = mesh
        .triangles
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(|i| mesh.positions[i as usize].as_dvec3());
            a.dot(b.cross(c)) / 6.0
        })
        .sum();
    sum
}

#[test]
fn meshes_are_sound() {
    for town in towns() {
        let mut total = 0;
        for (m, mesh) in town.meshes.iter().enumerate() {
            assert_eq!(mesh.triangles.len(), mesh.triangle_materials.len());
            assert!(mesh.positions.iter().all(|p| p.is_finite()), "{}: mesh {m}", town.name);
            assert!(mesh.uvs.iter().all(|p| p.is_finite()), "{}: mesh {m}", town.name);
            assert!(mesh.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-3), "{}: mesh {m}", town.name);
            let flat = mesh
                .triangles
                .iter()
                .filter(|t| {
                    let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
                    (b - a).cross(c - a).length() < 1e-7
                })
                .count();
            assert!(flat * 1000 <= mesh.triangles.len(), "{}: mesh {m} has {flat} flat triangles", town.name);
            let building = mesh.materials.iter().any(|m| m.tag == ClassTag::Buildings);
            let bounds = mesh.bounds();
            let size = (bounds.1 - bounds.0).as_dvec3();
            let filled = volume(mesh) / (size.x * size.y * size.z).max(1e-9);
            assert!(!building || filled > 0.2, "{}: building {m} is {filled} full", town.name);
            total += mesh.triangles.len();
        }
        // Facades have depth; the largest town has 2.4 million triangles.
        assert!((20_000..2_500_000).contains(&total), "{}: {total} triangles", town.name);
    }
}

#[test]
fn the_ground_faces_up() {
    for town in towns() {
        let ground = &town.meshes[0];
        for (t, &m) in ground.triangles.iter().zip(&ground.triangle_materials) {
            // Bridges have an underside.
            if ground.materials[m as usize].tag == ClassTag::Bridge {
                continue;
            }
            let [a, b, c] = t.map(|i| ground.positions[i as usize]);
            let normal = (b - a).cross(c - a).normalize_or_zero();
            assert!(normal.z > -1e-3, "{}: {:?} at {a} faces down", town.name, ground.materials[m as usize]);
        }
    }
}

/// Heights of the roads, sidewalks and squares near a place.
fn ground_heights(town: &Town, p: DVec2) -> impl Iterator<Item = f64> {
    let lanes = town.network.lanes.iter().map(move |l| l.centerline.at(l.centerline.project(p).0).position);
    let places = lanes.chain(town.network.walk.nodes.iter().copied());
    places.filter_map(move |on| (on.truncate().distance(p) < 25.0).then_some(on.z))
}

#[test]
fn cameras_are_many_and_hang_as_asked() {
    for town in towns() {
        assert!(town.cameras.len() >= 5, "{}: {} cameras", town.name, town.cameras.len());
        for (i, camera) in town.cameras.iter().enumerate() {
            let [x, y, z] = camera.position.map(f64::from);
            let fits = ground_heights(town, DVec2::new(x, y)).any(|ground| (4.8..=12.2).contains(&(z - ground)));
            assert!(fits, "{}: {camera:?}", town.name);
            assert!((15.0..=40.0).contains(&camera.down_tilt_rad.to_degrees()), "{}: {camera:?}", town.name);
            assert!((60.0..=90.0).contains(&camera.horizontal_fov_rad.to_degrees()), "{}: {camera:?}", town.name);
            assert!(town.cameras[..i].iter().all(|c| c.name != camera.name), "{}: {}", town.name, camera.name);
        }
    }
}

#[test]
fn props_keep_off_the_carriageway() {
    for town in towns() {
        for placement in &town.placements {
            let PlacedObject::Prop(prop, _) = placement.object else { continue };
            if is_level(prop) {
                continue;
            }
            let z = f64::from(placement.world_from_object.translation.z);
            let at = placement.world_from_object.translation.truncate().as_dvec2();
            for lane in &town.network.lanes {
                let (s, t) = lane.centerline.project(at);
                let on = lane.centerline.at(s).position;
                // Under a bridge, or beyond the end of a lane.
                if (on.z - z).abs() > 2.0 || on.truncate().distance(at) > t.abs() + 0.1 {
                    continue;
                }
                // An island's trees stand between lanes, not on them.
                assert!(t.abs() > lane.width_m / 2.0 + 0.2, "{}: {prop:?} at {at} on {:?}", town.name, lane.id);
            }
        }
        let poles = town.placements.iter().filter(|p| p.object == PlacedObject::Prop(Prop::CameraPole, 0)).count();
        assert!(poles <= town.cameras.len());
    }
}

/// The rectangle of a thing in the world: four corners, counter-clockwise.
type Corners = [DVec2; 4];

fn corners(world_from_object: Affine3A, low: Vec3, high: Vec3) -> Corners {
    [(low.x, low.y), (high.x, low.y), (high.x, high.y), (low.x, high.y)]
        .map(|(x, y)| world_from_object.transform_point3(Vec3::new(x, y, 0.0)).truncate().as_dvec2())
}

/// Depth by which two rectangles overlap along their most separating edge normal; negative if apart.
fn overlap(a: &Corners, b: &Corners) -> f64 {
    let axes = [a[1] - a[0], a[2] - a[1], b[1] - b[0], b[2] - b[1]].map(DVec2::normalize);
    let span = |r: &Corners, axis: DVec2| {
        r.iter().map(|p| p.dot(axis)).fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(x), h.max(x)))
    };
    axes.iter()
        .map(|&axis| {
            let ((al, ah), (bl, bh)) = (span(a, axis), span(b, axis));
            (ah - bl).min(bh - al)
        })
        .fold(f64::MAX, f64::min)
}

fn parked(town: &Town, catalogue: &Catalogue) -> Vec<Corners> {
    let place = |p: &endless_world::ParkedVehicle| {
        let spec = &catalogue.vehicles()[p.vehicle.model.index()].spec;
        let half = Vec3::new(spec.length_m, spec.width_m, 0.0) / 2.0;
        corners(p.pose.world_from_object(), -half, half)
    };
    town.parked.iter().map(place).collect()
}

/// Walls of each building up to head height: awnings and eaves may reach over sidewalks.
fn buildings(town: &Town) -> Vec<Corners> {
    let own = town.placements.iter().filter_map(|p| match p.object {
        PlacedObject::TownMesh(i) => Some((&town.meshes[i as usize], p.world_from_object)),
        PlacedObject::Prop(..) => None,
    });
    own.filter(|(mesh, _)| mesh.materials.iter().any(|m| m.tag == ClassTag::Buildings))
        .map(|(mesh, place)| {
            let low = mesh.positions.iter().filter(|p| p.z < 2.1);
            let (a, b) = low.fold((Vec3::MAX, Vec3::MIN), |(l, h), &p| (l.min(p), h.max(p)));
            corners(place, a, b)
        })
        .collect()
}

#[test]
fn nothing_stands_inside_anything_else() {
    let catalogue = Catalogue::builtin();
    for town in towns() {
        let mut things = parked(town, &catalogue);
        things.extend(buildings(town));
        for (i, a) in things.iter().enumerate() {
            for b in &things[..i] {
                assert!(overlap(a, b) < 0.06, "{}: {a:?} overlaps {b:?} by {}", town.name, overlap(a, b));
            }
        }
        let posts =
            town.placements.iter().filter(|p| matches!(p.object, PlacedObject::Prop(prop, _) if !is_level(prop)));
        for post in posts {
            let at = post.world_from_object.translation.truncate().as_dvec2();
            let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| at + DVec2::new(x, y) * 0.1);
            let hit = things.iter().find(|t| overlap(t, &square) > 0.0);
            assert!(hit.is_none(), "{}: {:?} at {at} stands in {hit:?}", town.name, post.object);
        }
    }
}

#[test]
fn lanes_crossings_and_sidewalks_are_clear() {
    let catalogue = Catalogue::builtin();
    for town in towns() {
        let mut things = parked(town, &catalogue);
        things.extend(buildings(town));
        let near =
            |t: &Corners, p: DVec2, reach: f64| (t[0] + t[2]).distance(p * 2.0) < t[0].distance(t[2]) + 2.0 * reach;
        let square = |p: DVec2, half: f64| {
            [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| p + DVec2::new(x, y) * half)
        };
        for lane in &town.network.lanes {
            for i in 0..(lane.centerline.length() / 2.0) as usize {
                let p = lane.centerline.at(2.0 * i as f64).position.truncate();
                let core = square(p, 1.0);
                let hit = things.iter().filter(|t| near(t, p, 3.0)).find(|t| overlap(t, &core) > 0.0);
                assert!(hit.is_none(), "{}: {hit:?} on {:?} at {p}", town.name, lane.id);
            }
        }
        for p in town.network.walk.nodes.iter().map(|n| n.truncate()) {
            let hit = things.iter().filter(|t| near(t, p, 3.0)).find(|t| overlap(t, &square(p, 0.3)) > 0.0);
            assert!(hit.is_none(), "{}: {hit:?} on the sidewalk at {p}", town.name);
        }
        for crossing in &town.network.crossings {
            let [a, b] = crossing.ends.map(DVec3::truncate);
            for k in 0..=10 {
                let p = a.lerp(b, f64::from(k) / 10.0);
                let core = square(p, crossing.width_m / 2.0 - 0.1);
                assert!(things.iter().all(|t| overlap(t, &core) <= 0.0), "{}: crossing at {p} is blocked", town.name);
                let posts = town.placements.iter().filter(|q| matches!(q.object, PlacedObject::Prop(..)));
                let clear = posts
                    .map(|q| q.world_from_object.translation.truncate().as_dvec2())
                    .all(|q| q.distance(p) > crossing.width_m / 2.0);
                assert!(clear, "{}: a post on the crossing at {p}", town.name);
            }
        }
    }
}

/// Triangles of the town's own meshes in the world, with the tag of each.
fn still(town: &Town) -> Vec<([Vec3; 3], ClassTag)> {
    let mut all = Vec::new();
    for placement in &town.placements {
        let PlacedObject::TownMesh(i) = placement.object else { continue };
        let mesh = &town.meshes[i as usize];
        for (t, &m) in mesh.triangles.iter().zip(&mesh.triangle_materials) {
            let corners = t.map(|k| placement.world_from_object.transform_point3(mesh.positions[k as usize]));
            all.push((corners, mesh.materials[usize::from(m)].tag));
        }
    }
    all
}

/// Distance along a ray to a triangle (Möller and Trumbore 1997).
fn hit([a, b, c]: &[Vec3; 3], from: Vec3, direction: Vec3) -> Option<f32> {
    let (e1, e2) = (*b - *a, *c - *a);
    let p = direction.cross(e2);
    let det = e1.dot(p);
    if det.abs() < 1e-9 {
        return None;
    }
    let s = from - *a;
    let u = s.dot(p) / det;
    let q = s.cross(e1);
    let v = direction.dot(q) / det;
    let t = e2.dot(q) / det;
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 1e-4).then_some(t)
}

/// By exact rays: no wall within 3 m ahead, and at least a quarter of the picture on road, sidewalk or square.
#[test]
fn cameras_stand_clear_and_see_pavement() {
    let size = ImageSize { width: 16, height: 9 };
    for town in towns() {
        let still = still(town);
        town.cameras.par_iter().for_each(|site| {
            let camera = PinholeCamera::new(site, size);
            let near: Vec<_> = still
                .iter()
                .filter(|(t, _)| t.iter().any(|p| p.distance(camera.position) < 90.0) || t[0].distance(t[1]) > 50.0)
                .filter(|(t, _)| may_be_seen(&camera, t))
                .collect();
            let mut paved = 0;
            for i in 0..size.pixels() {
                let (u, v) = ((i % 16) as f32 + 0.5, (i / 16) as f32 + 0.5);
                let k = camera.intrinsics;
                let ray = Vec3::new((u - k.cx) / k.fx, (v - k.cy) / k.fy, 1.0).normalize();
                let direction = (camera.world_from_camera * ray).normalize();
                let first = near
                    .iter()
                    .filter_map(|(t, tag)| hit(t, camera.position, direction).map(|d| (d, *tag)))
                    .min_by(|a, b| a.0.total_cmp(&b.0));
                let Some((distance, tag)) = first else { continue };
                // A wire may hang nearer.
                let clear = distance > 3.0 || tag == ClassTag::Static;
                assert!(clear, "{}: {} looks at {tag:?} {distance} m ahead", town.name, site.name);
                let on_pavement =
                    matches!(tag, ClassTag::Roads | ClassTag::RoadLines | ClassTag::Sidewalks | ClassTag::Ground);
                paved += usize::from(on_pavement);
            }
            assert!(paved * 4 >= size.pixels(), "{}: {} sees {paved} of 144 on pavement", town.name, site.name);
        });
    }
}

/// Whether a triangle's bounding sphere reaches into the pyramid of a camera's picture.
fn may_be_seen(camera: &PinholeCamera, triangle: &[Vec3; 3]) -> bool {
    let centre = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
    let radius = triangle.iter().map(|p| p.distance(centre)).fold(0.0, f32::max);
    let seen = camera.world_from_camera.inverse() * (centre - camera.position);
    let k = camera.intrinsics;
    let within = |across: f32, slope: f32| across.abs() - slope * seen.z <= radius * slope.hypot(1.0);
    within(seen.x, k.cx / k.fx) && within(seen.y, k.cy / k.fy)
}

/// Just below the horizon there is land, or something that stands on it, all across each picture.
#[test]
fn no_camera_sees_the_edge_of_the_world() {
    const COLUMNS: u32 = 9;
    const BELOW_HORIZON: f32 = 0.005;
    let size = ImageSize { width: COLUMNS, height: 5 };
    for town in towns() {
        let still = still(town);
        for site in &town.cameras {
            let camera = PinholeCamera::new(site, size);
            for column in 0..COLUMNS {
                let u = column as f32 + 0.5 - camera.intrinsics.cx;
                let across = camera.world_from_camera * Vec3::new(u / camera.intrinsics.fx, 0.0, 1.0).normalize();
                let level = across.truncate().normalize();
                let direction = level.extend(-BELOW_HORIZON).normalize();
                let ends = still.iter().all(|(t, _)| hit(t, camera.position, direction).is_none());
                assert!(!ends, "{}: {} sees past the land towards {level:.2}", town.name, site.name);
            }
        }
    }
}

/// Flat things of different kinds never lie at the same height one upon the other.
#[test]
fn paint_lies_clear_of_what_is_below() {
    // On slopes paint lies at any height.
    let level = |town: &&Town| town.network.lanes.iter().all(|l| l.centerline.points().iter().all(|p| p.z == 0.0));
    for town in towns().iter().filter(level) {
        let ground = &town.meshes[0];
        let road = ground.triangles.iter().zip(&ground.triangle_materials).filter_map(|(t, &m)| {
            let tag = ground.materials[usize::from(m)].tag;
            let corners = t.map(|i| ground.positions[i as usize]);
            let flat = corners.iter().all(|p| (p.z - corners[0].z).abs() < 1e-6);
            (flat && tag == ClassTag::RoadLines).then_some(corners)
        });
        let mut lines = 0;
        for corners in road {
            assert!(corners.iter().all(|p| (0.002..0.02).contains(&p.z)), "{}: paint at {corners:?}", town.name);
            lines += 1;
        }
        assert!(lines > 200, "{}: {lines} pieces of paint", town.name);
    }
}

/// A town with a square, a park, a fast road or fields has a camera that looks at it.
#[test]
fn cameras_cover_what_a_town_has() {
    let kinds = [
        ("Town04", &["highway", "junction", "square"][..]),
        ("Town06", &["highway", "junction"]),
        ("Town07", &["rural"]),
        ("Town10HD", &["square", "junction"]),
        ("Ladera", &["square"]),
        ("Altstadt", &["square", "junction"]),
    ];
    for (name, kinds) in kinds {
        let town = towns().iter().find(|t| t.name == name).expect("a town");
        for kind in kinds {
            assert!(town.cameras.iter().any(|c| c.name.starts_with(kind)), "{name} has no camera of a {kind}");
        }
    }
}

/// Each camera sees lanes and crossings in the range that matters, with no building before them.
#[test]
fn cameras_look_at_streets() {
    let size = ImageSize { width: 1280, height: 720 };
    for town in towns() {
        for site in &town.cameras {
            let camera = PinholeCamera::new(site, size);
            let seen = |p: Vec3| {
                camera.project(p).is_some_and(|(q, depth)| {
                    (0.0..1280.0).contains(&q.x) && (0.0..720.0).contains(&q.y) && (6.0..60.0).contains(&depth)
                })
            };
            let lanes = town
                .network
                .lanes
                .iter()
                .flat_map(|l| (0..(l.centerline.length() / 3.0) as usize).map(|i| l.centerline.at(3.0 * i as f64)))
                .filter(|place| seen(place.position.as_vec3()))
                .count();
            let people = town.network.walk.nodes.iter().filter(|n| seen(n.as_vec3())).count();
            let on_foot = ["square", "park"].iter().any(|kind| site.name.starts_with(kind));
            assert!(
                lanes >= 12 || (on_foot && people >= 6),
                "{}: {} sees {lanes} places on lanes, {people} of people",
                town.name,
                site.name
            );
            let forward = camera.world_from_camera.z_axis;
            let near = town
                .placements
                .iter()
                .filter(|p| matches!(p.object, PlacedObject::Prop(prop, _) if prop != Prop::CameraPole));
            for placement in near {
                let between =
                    Vec3::from(placement.world_from_object.translation).truncate() - camera.position.truncate();
                let ahead = between.dot(forward.truncate().normalize());
                let aside = (between.length_squared() - ahead * ahead).max(0.0).sqrt();
                let low = matches!(placement.object, PlacedObject::Prop(prop, _) if is_low(prop));
                assert!(
                    low || !(0.0..1.5).contains(&ahead) || aside > 1.0,
                    "{}: {:?} before {}",
                    town.name,
                    placement.object,
                    site.name
                );
            }
        }
    }
}

/// Things that are level with the road.
fn is_level(prop: Prop) -> bool {
    matches!(prop, Prop::Manhole | Prop::Drain)
}

/// Things that end well below any lens.
fn is_low(prop: Prop) -> bool {
    !matches!(
        prop,
        Prop::BroadleafTree
            | Prop::Conifer
            | Prop::Palm
            | Prop::StreetLamp
            | Prop::UtilityPole
            | Prop::CrowdedPole
            | Prop::SignalMast
            | Prop::SignalCurvedMast
            | Prop::Flagpole
    )
}

/// Cameras of the user's own get details before them, too, and the same ones every time.
#[test]
fn details_come_near_any_camera() {
    let catalogue = Catalogue::builtin();
    let mut with_details = 0;
    for town in towns() {
        let line = &town.network.lanes[town.network.lanes.len() / 2].centerline;
        let here = line.at(line.length() / 2.0);
        let site = CameraSite {
            name: "own".to_owned(),
            position: (here.position.as_vec3() + Vec3::Z * 7.0).to_array(),
            yaw_rad: here.heading_rad as f32,
            down_tilt_rad: 0.3,
            horizontal_fov_rad: 1.4,
            lens: LensModel::Pinhole,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        let details = town.details_near(std::slice::from_ref(&site), &catalogue);
        assert_eq!(details, town.details_near(std::slice::from_ref(&site), &catalogue), "{}", town.name);
        assert!(details.len() < 6000, "{}: {} details", town.name, details.len());
        with_details += usize::from(!details.is_empty());
        let lens = Vec3::from_array(site.position).truncate();
        for detail in &details {
            let distance = Vec3::from(detail.world_from_object.translation).truncate().distance(lens);
            assert!((2.5..175.0).contains(&distance), "{}: {:?} at {distance} m", town.name, detail.object);
        }
        assert!(town.details_near(&[], &catalogue).is_empty());
    }
    // There is no lawn before every place.
    assert!(with_details >= 7, "{with_details} towns have details");
}
