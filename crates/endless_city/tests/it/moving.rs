//! Cameras that move: what they see when they stand, how steady still things are while they move, and where flow leads.

use crate::exactness::{LoadedTown, shared};
use endless_render::{
    CameraBake, FrameScene, IndirectLight, MovingCamera, NeighbourFrame, NeighbourFrames, PixelSamples, RenderSettings,
};
use endless_world::{
    CameraLook, CameraSite, FlowPixel, FlowTarget, ImageSize, PinholeCamera, SensorFrame, SensorLayers, TimeOfDay,
    Weather,
};
use glam::{Vec2, Vec3};

const SIZE: ImageSize = ImageSize { width: 256, height: 144 };

fn settings(weather: Weather, time_of_day: TimeOfDay) -> RenderSettings {
    let layers = SensorLayers { flow: true, normals: true, shadow: true, ..SensorLayers::default() };
    RenderSettings { layers, look: CameraLook::CLEAN, ..RenderSettings::new(weather, time_of_day, 3, SIZE) }
}

/// Mean difference of the pictures, in 255ths.
fn difference(a: &SensorFrame, b: &SensorFrame) -> f64 {
    let (a, b) = (a.rgb.data.as_flattened(), b.rgb.data.as_flattened());
    a.iter().zip(b).map(|(a, b)| f64::from(a.abs_diff(*b))).sum::<f64>() / a.len() as f64
}

#[test]
fn a_camera_that_stands_sees_what_a_fixed_one_sees() {
    let LoadedTown { town, scene } = shared("Town02");
    let still = scene.static_scene();
    let mut all = Vec::new();
    // Where streets are open: in narrow ones more of the light has bounced.
    for (camera, weather, time) in [
        (8, Weather::ClearSky, TimeOfDay::Afternoon),
        (4, Weather::Cloudy, TimeOfDay::Morning),
        (1, Weather::Rainy, TimeOfDay::Night),
        (4, Weather::ClearSky, TimeOfDay::Night),
    ] {
        let site = &town.cameras[camera];
        let lights = time == TimeOfDay::Night;
        let (models, state) = shared("Town02").staged(site, camera as u64, lights);
        let frame = models.frame_scene(&state);
        let (settings, here) = (settings(weather, time), PinholeCamera::new(site, SIZE));
        let fixed = CameraBake::bake(still, &settings, site).render(still, &frame);
        let way = [here.clone(), here.clone()];
        let moving = MovingCamera::new(still, &settings, IndirectLight::Probes, &way).render(still, &frame, &here);
        assert_eq!(moving.depth, fixed.depth, "{weather} {time}");
        assert_eq!(moving.instance, fixed.instance, "{weather} {time}");
        assert_eq!(moving.normals, fixed.normals, "{weather} {time}");
        let off = difference(&moving, &fixed);
        println!("{weather} {time}: {off:.2} of 255");
        assert!(off < 2.5, "{weather} {time}: {off}");
        all.push(off);
    }
    // Light that bounced is all that differs.
    assert!(all.iter().sum::<f64>() < 2.0 * all.len() as f64, "{all:?}");
}

#[test]
fn pictures_of_pixels_centres_alone_differ_at_edges_only() {
    let LoadedTown { town, scene } = shared("Town02");
    let still = scene.static_scene();
    for (camera, weather, time) in [(0, Weather::ClearSky, TimeOfDay::Afternoon), (2, Weather::Rainy, TimeOfDay::Night)]
    {
        let site = &town.cameras[camera];
        let (models, state) = shared("Town02").staged(site, camera as u64, time == TimeOfDay::Night);
        let frame = models.frame_scene(&state);
        let (four, here) = (settings(weather, time), PinholeCamera::new(site, SIZE));
        let centre = RenderSettings { samples: PixelSamples::Centre, ..four.clone() };
        let render = |settings: &RenderSettings| {
            let way = [here.clone(), here.clone()];
            MovingCamera::new(still, settings, IndirectLight::Probes, &way).render(still, &frame, &here)
        };
        let (four, centre) = (render(&four), render(&centre));
        // Labels are those of the centres.
        assert_eq!(centre.depth, four.depth, "{weather} {time}");
        assert_eq!(centre.instance, four.instance, "{weather} {time}");
        assert_eq!(centre.normals, four.normals, "{weather} {time}");
        let off = difference(&centre, &four);
        let pixels = centre.rgb.data.iter().zip(&four.rgb.data);
        let alike = pixels.filter(|(a, b)| (0..3).all(|k| a[k].abs_diff(b[k]) <= 2)).count();
        println!("{weather} {time}: {off:.2} of 255, {alike} pixels alike of {}", centre.rgb.data.len());
        assert!((0.1..6.0).contains(&off), "{weather} {time}: {off}");
        assert!(alike * 3 > centre.rgb.data.len() * 2, "{weather} {time}: {alike}");
    }
}

/// A camera a little further on its way.
fn further(site: &CameraSite, metres: f32) -> PinholeCamera {
    let camera = PinholeCamera::new(site, SIZE);
    let ahead = camera.world_from_camera.z_axis.with_z(0.0).normalize_or(Vec3::X);
    PinholeCamera { position: camera.position + ahead * metres, ..camera }
}

/// What a frame and the one after it show at the points that both see: the difference of their pictures, and of how far
/// away the points are, by pixel.
struct Followed {
    asked: usize,
    /// Mean, in 255ths.
    rgb: f64,
    /// Points that are another thing there, or at another depth.
    elsewhere: usize,
}

fn follow(settings: &RenderSettings, site: &CameraSite, step_m: f32, frame: &FrameScene) -> Followed {
    let still = shared("Town02").scene.static_scene();
    let way: Vec<PinholeCamera> = (0..2).map(|k| further(site, step_m * k as f32)).collect();
    let camera = MovingCamera::new(still, settings, IndirectLight::Probes, &way);
    let after = NeighbourFrame { camera: Some(&way[1]), ..frame.into() };
    let neighbours = NeighbourFrames { before: None, after: Some(after) };
    let now = camera.render_between(still, frame, &way[0], neighbours);
    let then = camera.render(still, frame, &way[1]);
    let flow = now.flow.as_ref().expect("it is wanted");
    let mut followed = Followed { asked: 0, rgb: 0.0, elsewhere: 0 };
    for (i, pixel) in flow.data.iter().enumerate() {
        let Ok(Some(FlowPixel { flow_px, target: FlowTarget::Visible })) = FlowPixel::decoded(*pixel) else { continue };
        let (x, y) = (i as u32 % SIZE.width, i as u32 / SIZE.width);
        let place = Vec2::new(x as f32, y as f32) + flow_px;
        let (low, part) = (place.floor(), place - place.floor());
        // Away from edges, where all four pixels around are the same thing.
        let (x1, y1) = (low.x as i32, low.y as i32);
        if x1 < 1 || y1 < 1 || x1 + 2 >= SIZE.width as i32 || y1 + 2 >= SIZE.height as i32 {
            continue;
        }
        let around = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[dx, dy]| [x1 as u32 + dx, y1 as u32 + dy]);
        let inner = |[x, y]: [u32; 2], image: &SensorFrame| {
            let own = *image.instance.at(x, y);
            let depth = *image.depth.at(x, y);
            (x.saturating_sub(1)..=x + 1).all(|x| {
                (y.saturating_sub(1)..=y + 1).all(|y| {
                    x < SIZE.width
                        && y < SIZE.height
                        && *image.instance.at(x, y) == own
                        && (image.depth.at(x, y) - depth).abs() < 0.05 * depth
                })
            })
        };
        if !inner([x, y], &now) || !around.iter().all(|&p| inner(p, &then)) {
            continue;
        }
        followed.asked += 1;
        let [now_depth, then_depth] = [*now.depth.at(x, y), *then.depth.at(around[0][0], around[0][1])];
        let other = *now.instance.at(x, y) != *then.instance.at(around[0][0], around[0][1]);
        followed.elsewhere += usize::from(other || (now_depth - step_m - then_depth).abs() > 0.1 * now_depth + step_m);
        let weights =
            [(1.0 - part.x) * (1.0 - part.y), part.x * (1.0 - part.y), (1.0 - part.x) * part.y, part.x * part.y];
        for channel in 0..3 {
            let there: f32 =
                around.iter().zip(weights).map(|(p, w)| w * f32::from(then.rgb.at(p[0], p[1])[channel])).sum();
            followed.rgb += f64::from((there - f32::from(now.rgb.at(x, y)[channel])).abs()) / 3.0;
        }
    }
    followed.rgb /= followed.asked.max(1) as f64;
    followed
}

#[test]
fn what_stands_still_is_steady_while_a_camera_moves_and_flow_leads_to_it() {
    let town = &shared("Town02").town;
    for (camera, weather, time) in [
        (8, Weather::ClearSky, TimeOfDay::Afternoon),
        (1, Weather::Cloudy, TimeOfDay::Afternoon),
        (4, Weather::Foggy, TimeOfDay::Night),
    ] {
        let site = &town.cameras[camera];
        let (models, state) = shared("Town02").staged(site, camera as u64, time == TimeOfDay::Night);
        let frame = models.frame_scene(&state);
        let Followed { asked, rgb, elsewhere } = follow(&settings(weather, time), site, 0.15, &frame);
        println!("{weather} {time}: {asked} points, {rgb:.2} of 255, {elsewhere} elsewhere");
        assert!(asked > SIZE.pixels() / 4, "{asked} points");
        assert!(rgb < 2.0, "{weather} {time}: {rgb} of 255");
        assert!(elsewhere * 1000 < asked, "{elsewhere} of {asked}");
    }
}
