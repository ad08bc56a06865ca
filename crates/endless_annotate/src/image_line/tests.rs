use super::*;
use endless_world::{CameraSite, Distortion, ImageSize, Lens, LensModel, Mount, PinholeCamera};
use proptest::prelude::*;
use std::f32::consts::FRAC_PI_2;

const SIZE: ImageSize = ImageSize { width: 640, height: 360 };
const FAR_M: f64 = 100.0;

/// Fisheyes, equirectangular lenses and parallel rays.
fn other_cameras() -> impl Strategy<Value = PinholeCamera> {
    let lenses = prop_oneof![
        Just((LensModel::Fisheye { k: [0.0; 4] }, 180.0f32)),
        Just((LensModel::Fisheye { k: [-0.01, 0.004, 0.0, 0.0] }, 215.0)),
        Just((LensModel::Equirectangular, 360.0)),
        Just((LensModel::Orthographic { width_m: 50.0 }, 70.0)),
    ];
    (-3.0..3.0f32, 0.0..1.57f32, lenses).prop_map(|(yaw_rad, down_tilt_rad, (lens, fov_deg))| {
        let site = CameraSite {
            name: "test".into(),
            position: [3.0, -2.0, 16.5],
            yaw_rad,
            down_tilt_rad,
            horizontal_fov_rad: fov_deg.to_radians(),
            lens,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        PinholeCamera::new(&site, SIZE)
    })
}

/// Where a camera that is not perspective shows a point, well inside of its picture and of the depth that is told of.
fn shown(camera: &PinholeCamera, point: DVec3) -> Option<DVec2> {
    let (at, depth) = camera.project(point.as_vec3())?;
    let at = at.as_dvec2();
    let rim = |p: DVec2| camera.shows(p.x as f32, p.y as f32);
    let inside = at.cmpgt(DVec2::splat(3.0)).all() && at.cmplt(DVec2::new(637.0, 357.0)).all();
    let around = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y].map(|way| rim(at + way * 2.0));
    (inside && around == [true; 4] && (0.2..60.0).contains(&depth)).then_some(at)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn other_lenses_show_lines_where_their_points_are(
        camera in other_cameras(), points in prop::collection::vec(places(), 2..4),
    ) {
        let lens = LensProjection::new(&camera);
        let lines = lens.line(&points, FAR_M);
        for line in &lines {
            prop_assert_eq!(line.world.len(), line.image.len());
            for (world, image) in line.world.iter().zip(&line.image) {
                let (at, _) = camera.project(DVec3::from(*world).as_vec3()).expect("it is shown");
                let image = DVec2::from(*image).as_vec2();
                let way = camera.way_in_image(at, image);
                // In the last row before a pole single precision does not tell which way that is.
                let in_pole = camera.lens == Lens::Equirectangular && (camera.intrinsics.fy * FRAC_PI_2 - (at.y - camera.intrinsics.cy).abs()) < 1.0;
                let apart = if in_pole { way.y.abs() } else { way.length() };
                prop_assert!(apart < 0.1, "{at} {image}");
                prop_assert!(lens.shows(image.as_dvec2()));
            }
            // A line never jumps across the picture.
            let steps = line.image.windows(2).map(|pair| (pair[0][0] - pair[1][0]).abs());
            prop_assert!(camera.lens != Lens::Equirectangular || steps.fold(0.0, f64::max) < 400.0);
        }
        for pair in points.windows(2) {
            for i in 0..=100 {
                let Some(at) = shown(&camera, pair[0].lerp(pair[1], f64::from(i) / 100.0)) else { continue };
                prop_assert!(distance_to_lines(at, &lines) < 0.6, "{at} of {:?} is on no line", camera.lens);
            }
        }
    }

    #[test]
    fn other_lenses_show_areas_with_their_inside(
        camera in other_cameras(), middle in (-25.0..25.0f64, -25.0..25.0f64), half in (1.0..9.0f64, 1.0..9.0f64),
    ) {
        let corner = |x: f64, y: f64| DVec3::new(middle.0 + x * half.0, middle.1 + y * half.1, 0.0);
        let outline = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        let areas = LensProjection::new(&camera).areas(&outline, FAR_M);
        let near_edge = |p: DVec2| {
            areas.iter().any(|area| {
                let closed = ImageLine { world: Vec::new(), image: [&area.image[..], &area.image[..1]].concat() };
                distance_to_lines(p, &[closed]) < 1.5
            })
        };
        let tiny = shown(&camera, corner(0.0, 0.0)).is_some() && half.0.min(half.1) < 1.5;
        for i in 0..17 {
            for k in 0..17 {
                let at = |i: i32| f64::from(i) / 5.0 - 1.6;
                let (x, y) = (at(i), at(k));
                let Some(place) = shown(&camera, corner(x, y)) else { continue };
                let inside = x.abs() < 1.0 && y.abs() < 1.0;
                if tiny || near_edge(place) {
                    continue;
                }
                let held = areas.iter().any(|area| holds(&area.image, place));
                prop_assert_eq!(held, inside, "{} {} at {} of {:?}: {:?}", x, y, place, camera.lens, areas);
            }
        }
    }
}

/// Fields of view to 80 degrees: behind the strongest barrel a wider one shows more than half of the world.
fn cameras() -> impl Strategy<Value = PinholeCamera> {
    (-3.0..3.0f32, 0.1..1.2f32, 0.5..1.4f32, -0.22..0.0f32).prop_map(|(yaw_rad, down_tilt_rad, fov, k1)| {
        let site = CameraSite {
            name: "test".into(),
            position: [3.0, -2.0, 6.5],
            yaw_rad,
            down_tilt_rad,
            horizontal_fov_rad: fov,
            lens: LensModel::Pinhole,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        PinholeCamera::new(&site, SIZE).with_distortion(Distortion::barrel(k1))
    })
}

fn places() -> impl Strategy<Value = DVec3> {
    (-80.0..80.0f64, -80.0..80.0f64, -1.0..3.0f64).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

fn distance_to_lines(p: DVec2, lines: &[ImageLine]) -> f64 {
    let segments = lines.iter().flat_map(|line| line.image.windows(2));
    let distance = |pair: &[[f64; 2]]| {
        let (a, along) = (DVec2::from(pair[0]), DVec2::from(pair[1]) - DVec2::from(pair[0]));
        let t = ((p - a).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
        p.distance(a + along * t)
    };
    segments.map(distance).fold(f64::INFINITY, f64::min)
}

fn holds(outline: &[[f64; 2]], p: DVec2) -> bool {
    let n = outline.len();
    let crosses = |i: usize| {
        let (a, b) = (DVec2::from(outline[i]), DVec2::from(outline[(i + 1) % n]));
        (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
    };
    (0..n).filter(|&i| crosses(i)).count() % 2 == 1
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn a_line_shows_all_that_the_camera_sees_of_it_and_nothing_else(
        camera in cameras(), points in prop::collection::vec(places(), 2..5),
    ) {
        let lens = LensProjection::new(&camera);
        let lines = lens.line(&points, FAR_M);
        for line in &lines {
            prop_assert_eq!(line.world.len(), line.image.len());
            for (world, image) in line.world.iter().zip(&line.image) {
                let there = lens.to_camera(DVec3::from(*world));
                prop_assert!(there.z <= FAR_M + 1e-3 && lens.shows(DVec2::from(*image)));
                prop_assert!(lens.image(there).distance(DVec2::from(*image)) < 0.02);
            }
        }
        for pair in points.windows(2) {
            for k in 0..=200 {
                let there = lens.to_camera(pair[0].lerp(pair[1], f64::from(k) / 200.0));
                if there.z < 1.01 || there.z > FAR_M - 0.01 {
                    continue;
                }
                let image = lens.image(there);
                // What touches the border by less than a line may bend is nobody's.
                let border = DVec2::splat(0.3);
                if lens.shows(image - border) && lens.shows(image + border) {
                    prop_assert!(distance_to_lines(image, &lines) < 0.25, "{image} is missing");
                }
            }
        }
    }

    #[test]
    fn an_area_shows_its_inside(camera in cameras(), middle in places(), half in (0.5..15.0f64, 0.5..15.0f64)) {
        let corner = |x: f64, y: f64| middle + DVec3::new(x * half.0, y * half.1, 0.0);
        let outline = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        let lens = LensProjection::new(&camera);
        let area = lens.areas(&outline, FAR_M).pop();
        for i in 0..20 {
            for k in 0..20 {
                let at = |i: i32| f64::from(i) / 9.5 - 1.0;
                let there = lens.to_camera(corner(0.98 * at(i), 0.98 * at(k)));
                let inner = DVec2::splat(1.0);
                let image = if there.z > 1.01 { lens.image(there) } else { DVec2::splat(-1.0) };
                if there.z > FAR_M - 0.01 || image.cmplt(inner).any() || image.cmpgt(lens.size - 1.0).any() {
                    continue;
                }
                let edge = match &area {
                    Some(area) if holds(&area.image, image) => continue,
                    Some(area) => {
                        let mut closed = area.image.clone();
                        closed.push(area.image[0]);
                        distance_to_lines(image, &[ImageLine { world: vec![], image: closed }])
                    }
                    None => 0.0,
                };
                prop_assert!(edge < 1.0, "{image} is missing");
            }
        }
    }
}

#[test]
fn a_straight_line_through_a_pinhole_keeps_its_two_ends() {
    let site = CameraSite {
        name: "test".into(),
        position: [0.0, 0.0, 6.0],
        yaw_rad: 0.0,
        down_tilt_rad: 0.3,
        horizontal_fov_rad: 1.2,
        lens: LensModel::Pinhole,
        mount: Mount::Pole,
        roll_rad: 0.0,
    };
    let lens = LensProjection::new(&PinholeCamera::new(&site, SIZE));
    let lines = lens.line(&[DVec3::new(20.0, 3.0, 0.0), DVec3::new(60.0, 3.0, 0.0)], FAR_M);
    assert_eq!((lines.len(), lines[0].image.len()), (1, 2));
    // From one side of the picture to the other, with both ends outside.
    let across = lens.line(&[DVec3::new(20.0, 50.0, 0.0), DVec3::new(20.0, -50.0, 0.0)], FAR_M);
    let ends = across[0].image.iter().map(|p| p[0]).collect::<Vec<_>>();
    assert_eq!((across.len(), ends), (1, vec![0.0, 640.0]));
    // Behind the camera, and beyond the farthest.
    assert!(lens.line(&[DVec3::new(-9.0, 3.0, 0.0), DVec3::new(-60.0, 3.0, 0.0)], FAR_M).is_empty());
    assert!(lens.line(&[DVec3::new(120.0, 3.0, 0.0), DVec3::new(160.0, 3.0, 0.0)], FAR_M).is_empty());
}
