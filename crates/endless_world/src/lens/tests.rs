use super::*;
use crate::{CameraSite, Distortion, ImageSize, Intrinsics, Mount, PinholeCamera};
use glam::Mat3;
use proptest::prelude::*;

const SIZE: ImageSize = ImageSize { width: 641, height: 363 };

fn camera(lens: LensModel, fov_deg: f32) -> PinholeCamera {
    let site = CameraSite {
        name: "t".into(),
        position: [3.0, -4.0, 7.0],
        yaw_rad: 2.1,
        down_tilt_rad: 0.5,
        horizontal_fov_rad: fov_deg.to_radians(),
        lens,
        mount: Mount::Pole,
        roll_rad: 0.07,
    };
    PinholeCamera::new(&site, SIZE)
}

fn all() -> Vec<PinholeCamera> {
    let fisheye = |k, fov| camera(LensModel::Fisheye { k }, fov);
    vec![
        camera(LensModel::Pinhole, 70.0),
        camera(LensModel::Pinhole, 70.0).with_distortion(Distortion::barrel(-0.2)),
        fisheye([0.0; 4], 180.0),
        fisheye([0.0; 4], 220.0),
        fisheye([-0.0127, 0.0045, -0.0012, 0.0002], 190.0),
        fisheye([0.08, -0.02, 0.003, -0.0003], 140.0),
        camera(LensModel::Equirectangular, 360.0),
        camera(LensModel::Equirectangular, 120.0),
        camera(LensModel::Orthographic { width_m: 60.0 }, 70.0),
    ]
}

proptest! {
    #[test]
    fn a_point_on_a_ray_is_shown_where_the_ray_begins(x in 0.5f32..640.5, y in 0.5f32..362.5, far in 0.5f32..300.0) {
        for camera in all() {
            let Some(ray) = camera.ray(x, y) else { continue };
            prop_assert!((ray.direction.length() - 1.0).abs() < 1e-5);
            prop_assert_eq!(ray.direction, camera.ray_through(x, y));
            let point = ray.origin + ray.direction * far;
            let shown = camera.project(point);
            // At the very edge of the image circle rounding decides.
            let rim = |p: Vec2| matches!(camera.lens, Lens::Fisheye(f) if p.length() > 0.999 * f.max_radius());
            let k = &camera.intrinsics;
            let p = Vec2::new((x - k.cx) / k.fx, (y - k.cy) / k.fy);
            if shown.is_none() && rim(p) {
                continue;
            }
            let (image, depth) = shown.expect("it is shown");
            let mut off = image - Vec2::new(x, y);
            if matches!(camera.lens, Lens::Equirectangular) {
                // A pixel near a pole is a small part of the one on the horizon that is as wide.
                off.x *= math::cos(p.y);
            }
            prop_assert!(off.length() < 2e-2, "{image} of {x} {y} by {:?}", camera.lens);
            prop_assert!((depth - camera.depth_along(ray.direction, far)).abs() < 1e-3 * far.max(1.0));
            // It is seen along that ray.
            let from = camera.eye_for(point);
            prop_assert!((from - ray.origin).length() < 1e-3, "{from} {}", ray.origin);
        }
    }

    #[test]
    fn a_fisheye_is_told_by_its_angle(k1 in -0.05f32..0.1, k2 in -0.01f32..0.02, angle in 0.0f32..1.6) {
        let fisheye = Fisheye::new([k1, k2, 0.0, 0.0], 1.6);
        prop_assume!(angle < fisheye.max_angle_rad());
        let (sin, cos) = math::sin_cos(angle);
        let place = fisheye.project(Vec3::new(0.6 * sin, -0.8 * sin, cos) * 7.0).expect("it is shown");
        prop_assert!((place.length() - fisheye.radius_of(angle)).abs() < 1e-5);
        prop_assert!((fisheye.direction(place) - Vec3::new(0.6 * sin, -0.8 * sin, cos)).length() < 2e-5);
    }
}

/// Points of the camera's frame and where OpenCV 5.0.0 shows them.
struct OpenCvTable {
    lens: Lens,
    places: &'static [([f32; 3], [f32; 2])],
}

/// `cv2.fisheye.projectPoints` and `cv2.projectPoints` with K = [[310, 0, 320], [0, 310, 180], [0, 0, 1]], no rotation, no
/// translation.
fn opencv() -> [OpenCvTable; 5] {
    let fisheye = |k| Lens::Fisheye(Fisheye::new(k, 1.6));
    [
        OpenCvTable {
            lens: fisheye([0.0; 4]),
            places: &[
                ([0.3, -0.2, 1.0], [409.258, 120.495]),
                ([2.0, 1.0, 1.5], [591.706, 315.853]),
                ([-3.0, 2.0, 0.9], [-22.069, 408.046]),
                ([5.0, -1.0, 0.4], [773.693, 89.261]),
                ([-0.5, 4.0, 0.1], [260.555, 655.557]),
                ([0.02, 0.01, 10.0], [320.62, 180.31]),
            ],
        },
        OpenCvTable {
            lens: fisheye([-0.0127, 0.0045, -0.0012, 0.0002]),
            places: &[
                ([0.3, -0.2, 1.0], [409.128, 120.582]),
                ([2.0, 1.0, 1.5], [589.277, 314.639]),
                ([-3.0, 2.0, 0.9], [-17.611, 405.074]),
                ([5.0, -1.0, 0.4], [767.205, 90.559]),
                ([-0.5, 4.0, 0.1], [261.418, 648.659]),
                ([0.02, 0.01, 10.0], [320.62, 180.31]),
            ],
        },
        OpenCvTable {
            lens: fisheye([0.08, -0.02, 0.003, -0.0003]),
            places: &[
                ([0.3, -0.2, 1.0], [410.088, 119.942]),
                ([2.0, 1.0, 1.5], [608.22, 324.11]),
                ([-3.0, 2.0, 0.9], [-53.637, 429.092]),
                ([5.0, -1.0, 0.4], [821.212, 79.758]),
                ([-0.5, 4.0, 0.1], [254.128, 706.978]),
            ],
        },
        OpenCvTable {
            lens: Lens::PINHOLE,
            places: &[
                ([0.3, -0.2, 1.0], [413.0, 118.0]),
                ([2.0, 1.0, 4.5], [457.778, 248.889]),
                ([-3.0, 2.0, 7.0], [187.143, 268.571]),
            ],
        },
        OpenCvTable {
            lens: Lens::Perspective(Distortion { k1: -0.12, k2: 0.0072 }),
            places: &[
                ([0.3, -0.2, 1.0], [411.561, 118.96]),
                ([2.0, 1.0, 4.5], [453.756, 246.878]),
                ([-3.0, 2.0, 7.0], [191.305, 265.796]),
            ],
        },
    ]
}

#[test]
fn opencv_shows_points_in_the_same_places() {
    let intrinsics = Intrinsics { fx: 310.0, fy: 310.0, cx: 320.0, cy: 180.0 };
    let size = ImageSize { width: 640, height: 360 };
    for OpenCvTable { lens, places } in opencv() {
        let camera = PinholeCamera { size, intrinsics, position: Vec3::ZERO, world_from_camera: Mat3::IDENTITY, lens };
        for (point, expected) in places {
            let (image, _) = camera.project(Vec3::from_array(*point)).expect("it is shown");
            // Single precision at places of some hundreds of pixels.
            assert!((image - Vec2::from_array(*expected)).length() < 1.2e-3, "{image} {expected:?} {lens:?}");
        }
    }
}

#[test]
fn what_lies_beyond_a_lens_has_no_place() {
    let fisheye = camera(LensModel::Fisheye { k: [0.0; 4] }, 180.0);
    let behind = fisheye.position - fisheye.world_from_camera.z_axis;
    let beside = fisheye.position + fisheye.world_from_camera.x_axis;
    assert_eq!(fisheye.project(behind), None);
    assert!(fisheye.project(beside + fisheye.world_from_camera.z_axis * 0.01).is_some());
    assert!(fisheye.shows(1.0, 181.5) && !fisheye.shows(1.0, 1.0) && fisheye.ray(1.0, 1.0).is_none());
    // All round, nothing does but the lens itself.
    let round = camera(LensModel::Equirectangular, 360.0);
    assert!(round.project(behind).is_some() && round.project(round.position).is_none());
    // A strip above and below: 641 pixels of 360 degrees are 320.5 of 180, and the picture has 363 lines.
    assert!(!round.shows(320.5, 1.0) && round.shows(320.5, 22.0) && !round.shows(320.5, 362.0));
    let above = camera(LensModel::Orthographic { width_m: 60.0 }, 70.0);
    assert_eq!(above.project(behind), None);
    assert_eq!(above.intrinsics.fx, 641.0 / 60.0);
}

#[test]
fn a_fisheye_ends_where_it_would_fold_back() {
    // The derivative, 1 - 0.6 θ², is 0 at 1.29.
    let folding = Fisheye::new([-0.2, 0.0, 0.0, 0.0], 1.6);
    assert!((1.2..1.29).contains(&folding.max_angle_rad()), "{}", folding.max_angle_rad());
    let model = LensModel::Fisheye { k: [-0.2, 0.0, 0.0, 0.0] };
    let told = model.check(180.0).expect_err("it folds back");
    assert!(told.contains("folds back: write a fov of at most 14"), "{told}");
    assert_eq!(model.check(140.0), Ok(()));
}

#[test]
fn the_way_across_the_seam_is_the_short_one() {
    let round = camera(LensModel::Equirectangular, 360.0);
    let way = round.way_in_image(Vec2::new(640.0, 10.0), Vec2::new(2.0, 12.0));
    assert!((way - Vec2::new(3.0, 2.0)).length() < 1e-3, "{way}");
    assert_eq!(round.way_in_image(Vec2::new(40.0, 10.0), Vec2::new(20.0, 10.0)), Vec2::new(-20.0, 0.0));
}

#[test]
fn lenses_are_read_and_written() {
    let read = |text: &str| serde_json::from_str::<LensModel>(text).map_err(|e| e.to_string());
    for (text, lens) in [
        (r#""pinhole""#, LensModel::Pinhole),
        (r#""fisheye""#, LensModel::Fisheye { k: [0.0; 4] }),
        (r#"{"model":"fisheye","k":[0.5,0.0,0.25,0.0]}"#, LensModel::Fisheye { k: [0.5, 0.0, 0.25, 0.0] }),
        (r#""equirectangular""#, LensModel::Equirectangular),
        (r#"{"model":"orthographic","width":40.0}"#, LensModel::Orthographic { width_m: 40.0 }),
    ] {
        assert_eq!(read(text), Ok(lens));
        assert_eq!(serde_json::to_string(&lens).expect("plain"), text);
    }
    assert_eq!(read(r#""orthographic""#), Ok(LensModel::Orthographic { width_m: 60.0 }));
    assert_eq!(read(r#"{"model":"pinhole"}"#), Ok(LensModel::Pinhole));
    for (text, told) in [
        (r#""fish""#, "'fish' is no lens: write one of pinhole, fisheye, equirectangular, orthographic"),
        (r#"{"model":"pinhole","k":[0,0,0,0]}"#, "a lens that is pinhole has no k"),
        (r#"{"model":"fisheye","width":3}"#, "a lens that is fisheye has no width"),
        (r#"{"model":"fisheye","radius":3}"#, "a lens is \"pinhole\", \"fisheye\""),
        ("7", "a lens is \"pinhole\", \"fisheye\""),
    ] {
        assert!(read(text).is_err_and(|e| e.starts_with(told)), "{text}: {:?}", read(text));
    }
    for (lens, fov, told) in [
        (LensModel::Pinhole, 151.0, "fov is 151: write a number from 1 to 150 for a pinhole lens"),
        (LensModel::Fisheye { k: [0.0; 4] }, 221.0, "fov is 221: write a number from 1 to 220 for a fisheye lens"),
        (LensModel::Fisheye { k: [f32::NAN; 4] }, 180.0, "k is [NaN, NaN, NaN, NaN]: write four numbers"),
        (LensModel::Orthographic { width_m: 0.0 }, 70.0, "width is 0: write the picture's width in metres"),
    ] {
        assert!(lens.check(fov).is_err_and(|e| e.starts_with(told)), "{:?}", lens.check(fov));
    }
    assert_eq!(LensModel::Equirectangular.check(360.0), Ok(()));
}
