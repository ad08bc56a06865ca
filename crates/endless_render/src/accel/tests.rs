//! The structure against brute force, on scenes made to be awkward.

use glam::{Affine3A, EulerRot, Quat, Vec3, Vec3A};
use proptest::prelude::*;

use super::brute::BruteForceScene;
use super::{Blas, GeometryUse, Ray, RayStream, Tlas};

type Triangles = (Vec<Vec3>, Vec<[u32; 3]>);

/// Coordinates that often coincide, so that rays meet edges, planes and corners exactly.
fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![2 => (-4i32..=4).prop_map(|i| i as f32), 1 => -4.0f32..4.0, 1 => Just(0.0f32)]
}

/// On the heap, as rays are: many of them together would not fit on a thread's stack.
fn point() -> BoxedStrategy<Vec3> {
    (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| Vec3::new(x, y, z)).boxed()
}

/// Triangle soup; shares vertices, repeats triangles and holds degenerate ones.
fn mesh() -> impl Strategy<Value = Triangles> {
    (prop::collection::vec(point(), 1..24), 0usize..60).prop_flat_map(|(points, count)| {
        let n = points.len() as u32;
        (Just(points), prop::collection::vec([0..n, 0..n, 0..n], count))
    })
}

fn place() -> impl Strategy<Value = Affine3A> {
    let angle = || -4.0f32..4.0;
    let scale = || prop_oneof![0.1f32..3.0, -2.0f32..-0.2, Just(1.0f32)];
    let free = ((scale(), scale(), scale()), (angle(), angle(), angle()), point()).prop_map(|(s, r, t)| {
        let turn = Quat::from_euler(EulerRot::ZYX, r.0, r.1, r.2);
        Affine3A::from_scale_rotation_translation(Vec3::new(s.0, s.1, s.2), turn, t)
    });
    prop_oneof![1 => Just(Affine3A::IDENTITY), 1 => point().prop_map(Affine3A::from_translation), 3 => free]
}

fn scene() -> impl Strategy<Value = BruteForceScene> {
    prop::collection::vec(mesh(), 1..4).prop_flat_map(|meshes| {
        let n = meshes.len();
        let instances = prop::collection::vec((0..n, place()), 0..14);
        (Just(meshes), instances).prop_map(|(meshes, instances)| BruteForceScene::new(meshes, instances))
    })
}

fn ray() -> BoxedStrategy<Ray> {
    let tmax = prop_oneof![3 => Just(f32::INFINITY), 1 => 0.0f32..8.0, 1 => (1i32..5).prop_map(|i| i as f32)];
    let ray = |(origin, direction, tmax): (Vec3, Vec3, f32)| Ray {
        origin: Vec3A::from(origin) * 1.5,
        direction: if direction == Vec3::ZERO { Vec3A::Z } else { direction.into() },
        tmax,
    };
    (point(), point(), tmax).prop_map(ray).boxed()
}

/// Eight rays side by side, or eight rays of any kind.
fn rays() -> impl Strategy<Value = [Ray; 8]> {
    let beside = (ray(), prop::array::uniform8((point(), point())), 0.0f32..0.1).prop_map(|(ray, shifts, width)| {
        shifts.map(|(origin, direction)| Ray {
            origin: ray.origin + Vec3A::from(origin) * width,
            direction: ray.direction + Vec3A::from(direction) * width * 0.1,
            ..ray
        })
    });
    let fan = (ray(), prop::array::uniform8(point()))
        .prop_map(|(ray, shifts)| shifts.map(|d| Ray { direction: ray.direction + Vec3A::from(d) * 0.01, ..ray }));
    prop_oneof![beside, fan, prop::array::uniform8(ray())]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn equals_brute_force(scene in scene(), packets in prop::collection::vec((rays(), any::<u8>()), 12)) {
        for (rays, active) in packets {
            let expected = rays.map(|ray| scene.closest(&ray));
            for (ray, expected) in rays.iter().zip(expected) {
                prop_assert_eq!(scene.accel.closest(ray), expected, "{:?}", ray);
                prop_assert_eq!(scene.accel.occluded(ray), expected.is_some(), "{:?}", ray);
                let again = expected.and_then(|hit| scene.hit_on(ray, &hit));
                prop_assert_eq!(again, expected, "{:?}", ray);
            }
            let closest = scene.accel.closest8(&rays, active);
            let occluded = scene.accel.occluded8(&rays, active);
            for lane in 0..8 {
                let expected = if active >> lane & 1 != 0 { expected[lane] } else { None };
                prop_assert_eq!(closest[lane], expected, "lane {}", lane);
                prop_assert_eq!(occluded >> lane & 1 != 0, expected.is_some(), "lane {}", lane);
            }
        }
    }

    #[test]
    fn four_times_eight_rays_equal_brute_force(
        scene in scene(),
        packets in prop::collection::vec((prop::collection::vec(rays(), 4), any::<bool>(), any::<u32>()), 4),
    ) {
        for (rays, alike, active) in packets {
            let mut rays: [[Ray; 8]; 4] = std::array::from_fn(|row| rays[row]);
            if alike {
                // Neighbours of the first row.
                for row in 1..4 {
                    rays[row] = rays[0].map(|ray| Ray { origin: ray.origin + Vec3A::splat(row as f32 * 1e-3), ..ray });
                }
            }
            let bundle = RayStream::of(&rays);
            let closest = scene.accel.closest32(&bundle, active);
            let occluded = scene.accel.occluded32(&bundle, active);
            for (lane, ray) in rays.as_flattened().iter().enumerate() {
                let expected = if active >> lane & 1 != 0 { scene.closest(ray) } else { None };
                prop_assert_eq!(bundle.ray(lane).tmax.to_bits(), ray.tmax.to_bits());
                prop_assert_eq!(closest.get(lane), expected, "lane {}", lane);
                prop_assert_eq!(occluded >> lane & 1 != 0, expected.is_some(), "lane {}", lane);
            }
        }
    }

    #[test]
    fn every_triangle_lies_in_a_part((points, triangles) in mesh(), count in 1usize..40) {
        let parts = Blas::build(&points, &triangles).parts(count);
        prop_assert!(parts.len() <= count + 7);
        for corners in triangles.iter().map(|t| t.map(|i| Vec3A::from(points[i as usize]))) {
            let holds = |&(low, high): &(Vec3A, Vec3A)| {
                corners.iter().all(|p| p.cmpge(low).all() && p.cmple(high).all())
            };
            prop_assert!(parts.iter().any(holds));
        }
    }

    #[test]
    fn refit_equals_rebuild((points, triangles) in mesh(), moves in prop::collection::vec(point(), 24), rays in prop::collection::vec(ray(), 23..25)) {
        let moved: Vec<Vec3> = points.iter().zip(&moves).map(|(p, m)| *p + *m).collect();
        let mut refitted = Blas::build_for(GeometryUse::Deforming, &points, &triangles);
        // Whether or not anybody looked at it where it was before, and as a copy of one that nobody looked at.
        if rays.len() % 2 == 0 {
            prop_assert_eq!(refitted.groups().len(), refitted.clone().groups().len());
        }
        refitted.refit(points.as_slice().into());
        refitted = refitted.clone();
        refitted.refit(moved.as_slice().into());
        let rebuilt = Blas::build(&moved, &triangles);
        prop_assert_eq!(refitted.bounds(), rebuilt.bounds());
        let [a, b] = [refitted, rebuilt].map(|blas| Tlas::build(vec![(blas.into(), Affine3A::IDENTITY)]));
        for ray in rays {
            prop_assert_eq!(a.closest(&ray), b.closest(&ray));
        }
    }
}

/// A unit sphere of `2 * n * n` triangles around the origin.
fn sphere(n: u32) -> Triangles {
    let mut points = Vec::new();
    let mut triangles = Vec::new();
    for i in 0..=n {
        for j in 0..n {
            let (theta, phi) = (
                std::f32::consts::PI * i as f32 / n as f32,
                std::f32::consts::TAU * (j as f32 + 0.5 * (i % 2) as f32) / n as f32,
            );
            let (st, ct) = (endless_world::math::sin(theta), endless_world::math::cos(theta));
            let pole = i == 0 || i == n;
            let (sp, cp) = (endless_world::math::sin(phi), endless_world::math::cos(phi));
            points.push(if pole { Vec3::Z * ct.signum() } else { Vec3::new(st * cp, st * sp, ct) });
        }
    }
    for i in 0..n {
        for j in 0..n {
            let (a, b) = (i * n + j, i * n + (j + 1) % n);
            triangles.extend([[a, b, a + n], [b, b + n, a + n]]);
        }
    }
    (points, triangles)
}

/// Rays from inside a closed mesh to points on its edges and vertices, and between: none may leave.
#[test]
fn closed_meshes_do_not_leak() {
    let mesh = sphere(48);
    let (points, triangles) = mesh.clone();
    let turn = Quat::from_euler(EulerRot::ZYX, 0.3, 1.1, 2.0);
    let places = [
        Affine3A::IDENTITY,
        Affine3A::from_scale_rotation_translation(Vec3::new(3.0, 0.7, 11.0), turn, Vec3::new(412.0, -655.0, 3.0)),
    ];
    for place in places {
        let scene = BruteForceScene::new(vec![mesh.clone()], vec![(0, place)]);
        let mut rays = 0;
        for from in [Vec3A::ZERO, Vec3A::new(0.5, 0.31, -0.4), Vec3A::new(-0.9, 0.0, 0.1)] {
            let origin = place.transform_point3a(from);
            for triangle in &triangles {
                let [a, b, c] = triangle.map(|i| place.transform_point3a(points[i as usize].into()));
                for target in [a, b, (a + b) * 0.5, a * 0.3 + c * 0.7, b * 0.125 + c * 0.875, (a + b + c) / 3.0] {
                    let direction = target - origin;
                    let ray = Ray { origin, direction, tmax: f32::INFINITY };
                    let hit = scene.accel.closest(&ray).expect("no leak");
                    assert!((hit.t - 1.0).abs() < 2e-3, "{hit:?}");
                    assert!(scene.accel.occluded(&ray));
                    rays += 1;
                }
            }
        }
        assert_eq!(rays, 3 * 6 * triangles.len());
    }
}

/// A ground of squares seen from far away along grid lines, where barycentric tests leave gaps.
#[test]
fn a_tessellated_ground_does_not_leak() {
    let n = 64u32;
    let points: Vec<Vec3> =
        (0..=n * (n + 2)).map(|i| Vec3::new((i % (n + 1)) as f32 * 0.37, (i / (n + 1)) as f32 * 0.29, 0.0)).collect();
    let mut triangles = Vec::new();
    for y in 0..n {
        for x in 0..n {
            let a = y * (n + 1) + x;
            triangles.extend([[a, a + 1, a + n + 1], [a + 1, a + n + 2, a + n + 1]]);
        }
    }
    let accel = Tlas::build(vec![(Blas::build(&points, &triangles).into(), Affine3A::IDENTITY)]);
    for origin in [Vec3A::new(-310.0, -222.0, 7.3), Vec3A::new(11.84, 9.28, 1.0), Vec3A::new(900.0, 4.0, 120.0)] {
        for triangle in &triangles {
            let [a, b, c] = triangle.map(|i| Vec3A::from(points[i as usize]));
            for target in [(a + b) * 0.5, (b + c) * 0.5, a * 0.9 + b * 0.1, (a + c) * 0.5] {
                let rim = 1e-3;
                let (last_x, last_y) = (n as f32 * 0.37 - rim, n as f32 * 0.29 - rim);
                if target.x < rim || target.y < rim || target.x > last_x || target.y > last_y {
                    continue;
                }
                let ray = Ray { origin, direction: target - origin, tmax: f32::INFINITY };
                assert!(accel.closest(&ray).is_some(), "leak at {target}");
            }
        }
    }
}

/// The boxes are wide enough not to change what the triangle test says, short of degenerate cases.
#[test]
fn boxes_reject_nothing_that_triangles_accept() {
    let mut stream = endless_world::Stream::named(7, "boxes", &[]);
    let mut random = || stream.range_f32(-1.0, 1.0);
    let mut vector = || Vec3::new(random(), random(), random());
    let mesh = sphere(16);
    let instances = (0..12)
        .map(|i| {
            let turn = Quat::from_scaled_axis(vector() * 3.0);
            let place = Affine3A::from_scale_rotation_translation(vector() * 4.0, turn, vector() * 300.0);
            (0, if i == 0 { Affine3A::IDENTITY } else { place })
        })
        .collect::<Vec<_>>();
    let targets: Vec<_> = instances.iter().map(|(_, place)| *place).collect();
    let scene = BruteForceScene::new(vec![mesh], instances);
    let mut hits = 0;
    for k in 0..4000 {
        let origin = Vec3A::from(vector() * 400.0);
        let target = targets[k % targets.len()].transform_point3a(Vec3A::from(vector()));
        let ray = Ray { origin, direction: (target - origin).normalize(), tmax: f32::INFINITY };
        let (with, without) = (scene.closest(&ray), scene.closest_without_boxes(&ray));
        let key = |h: super::Hit| (h.instance, h.triangle, h.u, h.v);
        assert_eq!(with.map(key), without.map(key));
        if let (Some(a), Some(b)) = (with, without) {
            assert!((a.t - b.t).abs() <= 1e-5 * b.t, "{a:?} {b:?}");
            hits += 1;
        }
    }
    assert!(hits > 1000);
}

#[test]
fn nothing_is_hit_in_an_empty_scene() {
    let ray = Ray { origin: Vec3A::ZERO, direction: Vec3A::X, tmax: f32::INFINITY };
    for accel in [
        Tlas::build(vec![]),
        Tlas::build(vec![(Blas::build(&[], &[]).into(), Affine3A::IDENTITY)]),
        Tlas::build(vec![(Blas::build(&[Vec3::ZERO], &[[0, 0, 0]]).into(), Affine3A::from_scale(Vec3::ZERO))]),
    ] {
        assert_eq!(accel.closest(&ray), None);
        assert!(!accel.occluded(&ray));
        assert_eq!(accel.closest8(&[ray; 8], 255), [None; 8]);
        assert_eq!(accel.occluded8(&[ray; 8], 255), 0);
    }
    assert!(Tlas::build(vec![]).is_empty());
}

#[test]
fn a_single_triangle_is_hit_where_expected() {
    let points = [Vec3::ZERO, Vec3::X, Vec3::Y];
    let place = Affine3A::from_translation(Vec3::new(0.0, 0.0, 2.0));
    let accel = Tlas::build(vec![(Blas::build(&points, &[[0, 1, 2]]).into(), place)]);
    let ray = Ray { origin: Vec3A::new(0.25, 0.5, 0.0), direction: Vec3A::Z * 4.0, tmax: 1.0 };
    let hit = accel.closest(&ray).expect("hit");
    assert_eq!((hit.t, hit.instance, hit.triangle, hit.u, hit.v), (0.5, 0, 0, 0.25, 0.5));
    assert!(accel.closest(&Ray { tmax: 0.5, ..ray }).is_some(), "tmax is included");
    assert!(accel.closest(&Ray { tmax: 0.49, ..ray }).is_none());
    assert!(accel.closest(&Ray { direction: -Vec3A::Z, ..ray }).is_none());
    assert!(!accel.occluded(&Ray { origin: Vec3A::new(0.6, 0.5, 0.0), ..ray }));
}

/// Rays with parts that are no numbers must not hang or panic.
#[test]
fn odd_rays_end() {
    let scene = BruteForceScene::new(
        vec![sphere(8)],
        vec![(0, Affine3A::IDENTITY), (0, Affine3A::from_scale(Vec3::splat(2.0)))],
    );
    let odd = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.0, -0.0, f32::MIN_POSITIVE, f32::MAX];
    for a in odd {
        for b in odd {
            let ray = Ray { origin: Vec3A::new(a, 0.1, b), direction: Vec3A::new(b, a, 1.0), tmax: a };
            scene.accel.closest(&ray);
            scene.accel.occluded(&ray);
            scene.accel.closest8(&[ray; 8], 255);
            scene.accel.occluded8(&[ray; 8], 255);
            let bundle = RayStream::of(&[[ray; 8]; 4]);
            scene.accel.closest32(&bundle, u32::MAX);
            scene.accel.occluded32(&bundle, u32::MAX);
        }
    }
}
