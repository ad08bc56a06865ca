//! `map.json`: its lines and areas lie in the picture, where the camera projects them.

use super::report::Finding;
use crate::{CameraLayout, read_json};
use endless_annotate::{BodyView, CameraMap, ImageArea, ImageLine};
use endless_world::{ImageSize, PinholeCamera, SceneCamera};
use glam::{DVec3, Vec2};

/// Between a place that is written and what the camera makes of it in single precision, pixels.
const MOST_OFF_PX: f32 = 0.1;

/// What is wrong with a camera's map, where it has one.
pub(super) fn check_map(layout: &CameraLayout, camera: &SceneCamera, size: ImageSize) -> Option<Finding> {
    let path = layout.map();
    if !path.is_file() {
        return None;
    }
    let map: CameraMap = match read_json(&path) {
        Ok(map) => map,
        Err(error) => return Some(error.into()),
    };
    let lens = PinholeCamera::new(&camera.site, size).with_distortion(camera.look.distortion);
    problem(&map, &lens).map(|problem| Finding::new(path, problem))
}

fn problem(map: &CameraMap, lens: &PinholeCamera) -> Option<String> {
    let lanes = map.lanes.iter().flat_map(|lane| {
        let lines = [&lane.center, &lane.left, &lane.right].into_iter().flatten();
        lines.map(|line| (format!("lane {}", lane.attributes.id), line))
    });
    let marks =
        map.marks.iter().flat_map(|mark| mark.pieces.iter().map(|line| (format!("mark {}", mark.attributes.id), line)));
    let stops = map
        .stop_lines
        .iter()
        .flat_map(|stop| stop.pieces.iter().map(|line| (format!("stop line {}", stop.attributes.id), line)));
    let wrong_line = lanes.chain(marks).chain(stops).find(|(_, line)| !agrees(line, lens));
    let crossings = map.crosswalks.iter().map(|area| (format!("crosswalk {}", area.attributes.id), &area.area));
    let walks = map.sidewalks.iter().map(|walk| (format!("sidewalk {}", walk.id), &walk.area));
    let wrong_area = crossings.chain(walks).find(|(_, area)| !lies_inside(area, lens.size));
    let signals = map.signals.iter().map(|signal| (format!("signal {}", signal.attributes.id), &signal.body));
    let signs = map.signs.iter().map(|sign| (format!("sign {}", sign.attributes.id), &sign.body));
    let wrong_box = signals.chain(signs).find(|(_, body)| !is_seen(body, lens));
    let who = wrong_line.map(|l| l.0).or(wrong_area.map(|a| a.0)).or(wrong_box.map(|b| b.0))?;
    Some(format!("{who} does not lie where the camera shows it"))
}

fn agrees(line: &ImageLine, lens: &PinholeCamera) -> bool {
    let projected = |(world, image): (&[f64; 3], &[f64; 2])| {
        let there = lens.project(DVec3::from(*world).as_vec3());
        // The short way, where the picture's left and right edges meet.
        let off = |there| lens.way_in_image(image_point(*image), there).abs().max_element();
        there.is_some_and(|(there, _)| off(there) < MOST_OFF_PX)
    };
    line.world.len() == line.image.len()
        && line.world.len() > 1
        && line.image.iter().all(|p| in_picture(*p, lens.size))
        && line.world.iter().zip(&line.image).all(projected)
}

fn image_point(p: [f64; 2]) -> Vec2 {
    Vec2::from(p.map(|value| value as f32))
}

fn in_picture([x, y]: [f64; 2], size: ImageSize) -> bool {
    (0.0..=f64::from(size.width)).contains(&x) && (0.0..=f64::from(size.height)).contains(&y)
}

fn lies_inside(area: &ImageArea, size: ImageSize) -> bool {
    area.world.len() > 2 && area.image.len() > 2 && area.image.iter().all(|p| in_picture(*p, size))
}

/// A box holds the middle of its front, as far as that lies in the picture.
fn is_seen(body: &BodyView, lens: &PinholeCamera) -> bool {
    let [x, y, w, h] = body.bbox;
    let Some((at, _)) = lens.project(DVec3::from(body.position).as_vec3()) else { return false };
    let (low, high) = (image_point([x, y]) - MOST_OFF_PX, image_point([x + w, y + h]) + MOST_OFF_PX);
    let inside = in_picture([x, y], lens.size) && w > 0.0 && h > 0.0;
    inside && (body.truncated || (at.cmpge(low).all() && at.cmple(high).all()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_annotate::{
        FeatureBody, MapFeatures, MarkAttributes, MarkFeature, PaintColor, SignAttributes, SignFeature,
    };
    use endless_world::{CameraSite, Distortion, LensModel, Mount};

    fn lens() -> PinholeCamera {
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
        PinholeCamera::new(&site, ImageSize { width: 640, height: 360 }).with_distortion(Distortion::barrel(-0.12))
    }

    fn map() -> CameraMap {
        let attributes = MarkAttributes { id: 8, broken: false, color: PaintColor::White, width_m: 0.12 };
        let line = vec![DVec3::new(-5.0, 2.0, 0.0), DVec3::new(70.0, 3.0, 0.1)];
        let corner = |i: usize| DVec3::new(20.0 + 0.1 * (i & 1) as f64, (i >> 1 & 1) as f64, 2.0 + (i >> 2 & 1) as f64);
        let body = FeatureBody {
            corners: std::array::from_fn(corner),
            center: DVec3::new(20.0, 0.5, 2.5),
            facing: DVec3::NEG_X,
        };
        let sign = SignAttributes {
            id: 2,
            code: "C,14".into(),
            convention: "vienna".into(),
            value: Some(50),
            unit: Some("km/h".into()),
            text: None,
        };
        let features = MapFeatures {
            marks: vec![MarkFeature { attributes, pieces: vec![line] }],
            signs: vec![SignFeature { attributes: sign, body }],
            ..MapFeatures::default()
        };
        CameraMap::new(&features, &lens())
    }

    #[test]
    fn what_lies_elsewhere_is_found() {
        assert_eq!(problem(&map(), &lens()), None);
        let spoil = |spoil: &dyn Fn(&mut CameraMap)| {
            let mut spoilt = map();
            spoil(&mut spoilt);
            problem(&spoilt, &lens())
        };
        let mark = Some("mark 8 does not lie where the camera shows it".to_owned());
        assert_eq!(spoil(&|map| map.marks[0].pieces[0].image[1][0] += 0.3), mark);
        assert_eq!(spoil(&|map| map.marks[0].pieces[0].world[0][1] += 0.1), mark);
        assert_eq!(spoil(&|map| map.marks[0].pieces[0].image.truncate(1)), mark);
        let sign = Some("sign 2 does not lie where the camera shows it".to_owned());
        assert_eq!(spoil(&|map| map.signs[0].body.bbox[0] += 80.0), sign);
        assert_eq!(map().signs.iter().map(|sign| sign.body.front_seen).collect::<Vec<_>>(), [true]);
    }
}
