//! Labels of the map against pictures of it.

use super::map_features;
use endless_annotate::{CameraMap, ImageArea, ImageLine, LensColor, LensView, MapFeatures, SignalView};
use endless_asset::Catalogue;
use endless_city::TownScene;
use endless_render::{FrameDescription, FrameScene, IndirectLight, MovingCamera, RenderSettings};
use endless_road::opendrive;
use endless_town::Town;
use endless_world::{CameraSite, ClassTag, ImageSize, PinholeCamera, SensorFrame, SignalAspect, TimeOfDay, Weather};
use glam::{DVec2, DVec3};

const SIZE: ImageSize = ImageSize { width: 1280, height: 720 };
/// Paint is looked for up to here, metres.
const NEAR_M: f32 = 40.0;
/// And this near to where the labels say, pixels.
const MOST_OFF_PX: f64 = 2.0;
/// What is farther from the lens than the picture's depth is hidden, metres.
const HIDDEN_M: f32 = 0.3;

/// A town without those who move, as one of its cameras shows it and as its labels tell of it.
struct LabelledView {
    camera: PinholeCamera,
    map: CameraMap,
    shown: SensorFrame,
}

struct LoadedTown {
    town: Town,
    scene: TownScene,
    features: MapFeatures,
}

impl LoadedTown {
    fn new(name: &str) -> Self {
        let catalogue = Catalogue::builtin();
        let town = endless_town::load(name, &catalogue).expect("a built-in town");
        let scene = TownScene::load(&town, &catalogue).expect("few parked vehicles");
        let features = map_features(&town, &catalogue, &opendrive::lane_names(&town.network, false));
        Self { town, scene, features }
    }

    /// Under clouds, with signals as they are told to be.
    fn views<const N: usize>(&self, site: &CameraSite, aspects: [SignalAspect; N]) -> [LabelledView; N] {
        let still = self.scene.static_scene();
        let settings = RenderSettings::new(Weather::Cloudy, TimeOfDay::Afternoon, 1, SIZE);
        let camera = PinholeCamera::new(site, SIZE);
        let film = MovingCamera::new(still, &settings, IndirectLight::OpenSky, std::slice::from_ref(&camera));
        aspects.map(|aspect| {
            let signals = vec![aspect; usize::from(self.town.network.signal_groups)];
            let frame = FrameScene::new(FrameDescription { signals, ..FrameDescription::default() });
            let shown = film.render(still, &frame, &camera);
            let map = CameraMap::new(&self.features, &camera);
            LabelledView { camera: camera.clone(), map, shown }
        })
    }
}

impl LabelledView {
    /// The pixel of a place on the ground, if it is near and nothing hides it.
    fn pixel(&self, place: DVec3) -> Option<DVec2> {
        let place = place.as_vec3();
        let (image, depth) = self.camera.project(place)?;
        let inside = image.cmpge(glam::Vec2::splat(4.0)).all()
            && image.x < SIZE.width as f32 - 4.0
            && image.y < SIZE.height as f32 - 4.0;
        let near = inside && place.distance(self.camera.position) < NEAR_M;
        let hidden = |p: glam::Vec2| (self.shown.depth.at(p.x as u32, p.y as u32) - depth).abs() > HIDDEN_M;
        (near && !hidden(image)).then(|| image.as_dvec2())
    }

    fn is_paint(&self, x: u32, y: u32) -> bool {
        self.shown.instance.at(x, y).tag == ClassTag::RoadLines
    }

    /// Distance to the nearest painted pixel, up to 4 pixels; that to a pixel that holds the place is 0.
    fn off_paint_px(&self, image: DVec2) -> f64 {
        let (x, y) = (image.x as u32, image.y as u32);
        let around = (y - 4..=y + 4).flat_map(|y| (x - 4..=x + 4).map(move |x| (x, y)));
        let distance = |(x, y): (u32, u32)| {
            let middle = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            ((image - middle).abs() - 0.5).max(DVec2::ZERO).length()
        };
        around.filter(|&(x, y)| self.is_paint(x, y)).map(distance).fold(4.0, f64::min)
    }

    /// Whether a pixel of a head in the circle of its lens shines in the lens's colour.
    fn shines(&self, signal: &SignalView, lens: &LensView) -> bool {
        let head = self.camera.project(DVec3::from(signal.body.position).as_vec3()).map_or(0.0, |(_, depth)| depth);
        let [u, v] = lens.image;
        let reach = lens.radius_px.ceil() as i64;
        let circle = (-reach..=reach).flat_map(|dy| (-reach..=reach).map(move |dx| (dx, dy)));
        let pixels = circle.filter(|(dx, dy)| ((dx * dx + dy * dy) as f64) < lens.radius_px * lens.radius_px);
        pixels.map(|(dx, dy)| (u as i64 + dx, v as i64 + dy)).any(|(x, y)| {
            if !(0..i64::from(SIZE.width)).contains(&x) || !(0..i64::from(SIZE.height)).contains(&y) {
                return false;
            }
            let (x, y) = (x as u32, y as u32);
            let own = (self.shown.depth.at(x, y) - head).abs() < HIDDEN_M;
            let [red, green, blue] = self.shown.rgb.at(x, y).map(i32::from);
            own && match lens.color {
                LensColor::Red => red > green + 80 && red > blue + 80,
                LensColor::Yellow => red > blue + 80 && green > blue + 80,
                LensColor::Green => green > red + 60,
            }
        })
    }

    fn off_along(&self, line: &ImageLine) -> Vec<f64> {
        let segments = line.world.windows(2);
        let places = segments.flat_map(|pair| {
            let [a, b] = [pair[0], pair[1]].map(DVec3::from);
            (1..32).map(move |k| a.lerp(b, f64::from(k) / 32.0))
        });
        places.filter_map(|place| Some(self.off_paint_px(self.pixel(place)?))).collect()
    }

    /// The share of places on a crossing's bars that are painted; `None` where few are to be seen.
    fn painted_share(&self, area: &ImageArea) -> Option<f64> {
        // Along one side of the bars and back along the other: a bar, a gap, a bar.
        let outline: Vec<DVec3> = area.world.iter().map(|p| DVec3::from(*p)).collect();
        let n = outline.len() / 2;
        let bars = (0..n - 1).step_by(2).flat_map(|k| {
            let near = outline[k].midpoint(outline[k + 1]);
            let far = outline[2 * n - 1 - k].midpoint(outline[2 * n - 2 - k]);
            [0.2, 0.5, 0.8].map(|share| near.lerp(far, share))
        });
        let seen: Vec<DVec2> = bars.filter_map(|place| self.pixel(place)).collect();
        let painted = seen.iter().filter(|image| self.is_paint(image.x as u32, image.y as u32)).count();
        (seen.len() > 10).then(|| painted as f64 / seen.len() as f64)
    }
}

#[test]
fn labelled_paint_is_where_the_picture_shows_it() {
    let (mut places, mut off, mut worst, mut crossings, mut unpainted) = (0, 0, 0.0f64, 0, 0);
    for name in ["Town01", "Town03", "Ladera"] {
        let town = LoadedTown::new(name);
        for site in &town.town.cameras[3..7] {
            let [view] = town.views(site, [SignalAspect::Red]);
            let marks = view.map.marks.iter().flat_map(|mark| &mark.pieces);
            let stops = view.map.stop_lines.iter().flat_map(|stop| &stop.pieces);
            for distance in marks.chain(stops).flat_map(|line| view.off_along(line)) {
                places += 1;
                off += usize::from(distance > MOST_OFF_PX);
                worst = worst.max(distance);
            }
            for share in view.map.crosswalks.iter().filter_map(|crossing| view.painted_share(&crossing.area)) {
                crossings += 1;
                unpainted += usize::from(share < 0.95);
            }
        }
    }
    println!("{places} places on paint: {off} more than {MOST_OFF_PX} pixels off, {worst:.2} pixels the worst");
    println!("{crossings} crossings: {unpainted} without their bars");
    assert!(places > 500 && crossings > 3, "{places} places, {crossings} crossings");
    assert_eq!(off, 0, "{worst:.2} pixels");
    assert_eq!(unpainted, 0, "of {crossings} crossings");
}

#[test]
fn lit_lenses_have_the_colour_of_their_aspect() {
    let town = LoadedTown::new("Town05");
    let (mut right, mut wrong) = (0, 0);
    for site in &town.town.cameras[..2] {
        let views = town.views(site, [SignalAspect::Red, SignalAspect::Green]);
        for (view, lit) in views.iter().zip([LensColor::Red, LensColor::Green]) {
            let lenses =
                view.map.signals.iter().flat_map(|signal| signal.lenses.iter().map(move |lens| (signal, lens)));
            for (signal, lens) in lenses.filter(|(_, lens)| lens.radius_px > 1.5) {
                // Visors hide a part from above.
                let shines = view.shines(signal, lens);
                right += usize::from(shines && lens.color == lit);
                wrong += usize::from(shines && lens.color != lit);
            }
        }
    }
    println!("{right} lit lenses, {wrong} that should be dark");
    assert!(right > 4 && wrong == 0, "{right} lit lenses, {wrong} that should be dark");
}
