//! Optical flow of towns: it leads to the same objects in the next frame, and back.

use crate::{city::city, fake::options};
use endless_dataset::{DatasetLayout, Layer, RecipeDraft, RgbFormat, VideoLayout, check, read_rgb};
use endless_pipeline::{SilentProgress, generate, resolve_recipe};
use endless_world::{FlowPixel, FlowTarget, Image, ImageSize, InstancePixel};
use glam::Vec2;
use std::{fs, path::Path};

const SIZE: ImageSize = ImageSize { width: 640, height: 360 };
const FRAMES: u32 = 4;

fn draft(map: &str, size: ImageSize, cameras: i64) -> RecipeDraft {
    let words = |words: &[&str]| Some(words.iter().map(|&word| word.to_owned()).collect());
    RecipeDraft {
        videos: Some(1),
        // Traffic that is near enough to be seen, and not so near that its edges are all there is.
        focus: Some(0.2),
        seed: Some(1),
        maps: words(&[map]),
        weathers: words(&["cloudy"]),
        times: words(&["afternoon"]),
        vehicles: Some(120),
        pedestrians: Some(120),
        size: Some(size.to_string()),
        fps: Some(10.0),
        duration: Some(0.1 * f64::from(FRAMES)),
        layers: words(&["depth", "instance", "flow", "flow_backward"]),
        mp4: words(&["flow"]),
        camera_look: Some("random".into()),
        cameras_per_scene: Some(cameras),
        ..RecipeDraft::default()
    }
}

fn make(map: &str, size: ImageSize, cameras: i64, out: &Path, threads: usize) -> VideoLayout {
    let recipe = resolve_recipe(draft(map, size, cameras), city()).expect("a recipe");
    let made = generate(city(), &recipe, out, &options(threads), &SilentProgress).expect("a dataset");
    DatasetLayout::new(out).video(&made.plan.scenes[0])
}

/// What a camera stores of a frame.
struct StoredFrame {
    depth: Image<[u8; 3]>,
    instance: Image<InstancePixel>,
    forward: Vec<Option<FlowPixel>>,
    backward: Vec<Option<FlowPixel>>,
}

impl StoredFrame {
    fn read(folder: &Path, frame: u32) -> Self {
        let image = |layer: Layer| {
            let path = folder.join(layer.name()).join(format!("{frame:06}.png"));
            read_rgb(&path, RgbFormat::Png).expect("an image")
        };
        let flow = |layer| {
            let image = image(layer).rgb16().expect("16 bits").clone();
            image.data.into_iter().map(|pixel| FlowPixel::decoded(pixel).expect("legal")).collect()
        };
        Self {
            depth: image(Layer::Depth).rgb8().expect("8 bits").clone(),
            instance: endless_dataset::instance_from_rgb(image(Layer::Instance).rgb8().expect("8 bits")).expect("tags"),
            forward: flow(Layer::Flow),
            backward: flow(Layer::FlowBackward),
        }
    }
}

/// Counts of pixels that flow says are visible in the other frame.
#[derive(Debug, Default)]
struct Agreement {
    still: usize,
    moving: usize,
    /// The pixel in which the point lies shows the same object there.
    same: usize,
    /// One of the four whose centres are nearest to the point does.
    near: usize,
    hidden: usize,
    /// Whose four nearest pixels show the same piece there: the flow back is interpolated among them.
    returning: usize,
    /// Those that come back to within a tenth of a pixel.
    undone: usize,
    worst_px: f32,
}

impl Agreement {
    fn compare(
        &mut self,
        now: &StoredFrame,
        then: &StoredFrame,
        flow: &[Option<FlowPixel>],
        back: &[Option<FlowPixel>],
    ) {
        for (i, pixel) in flow.iter().enumerate() {
            let Some(FlowPixel { flow_px, target }) = *pixel else { panic!("pixel {i} has no flow") };
            let seen = now.instance.data[i];
            if target != FlowTarget::Visible {
                self.hidden += usize::from(target == FlowTarget::Hidden);
                continue;
            }
            if flow_px == Vec2::ZERO && then.instance.data[i] == seen && then.depth.data[i] == now.depth.data[i] {
                self.still += 1;
                continue;
            }
            self.moving += 1;
            let place = Vec2::new((i as u32 % SIZE.width) as f32 + 0.5, (i as u32 / SIZE.width) as f32 + 0.5) + flow_px;
            let last = Vec2::new(SIZE.width as f32, SIZE.height as f32) - 1.0;
            let at = |p: Vec2| {
                let p = p.clamp(Vec2::ZERO, last);
                p.y as usize * SIZE.width as usize + p.x as usize
            };
            self.same += usize::from(then.instance.data[at(place)] == seen);
            let corner = (place - 0.5).floor();
            let four = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|step| at(corner + Vec2::from(step)));
            self.near += usize::from(four.iter().any(|&p| then.instance.data[p] == seen));
            self.undo(flow_px, place - 0.5 - corner, four.map(|p| back[p].filter(|_| then.instance.data[p] == seen)));
        }
    }

    /// The flow back at the place where a flow leads, among four pixels.
    fn undo(&mut self, flow_px: Vec2, share: Vec2, four: [Option<FlowPixel>; 4]) {
        let [Some(a), Some(b), Some(c), Some(d)] = four.map(|pixel| pixel.map(|pixel| pixel.flow_px)) else { return };
        // Of pieces that move otherwise, an arm before a body, nothing lies between.
        if [b, c, d].iter().any(|other| other.distance(a) > 0.15) {
            return;
        }
        let back = a.lerp(b, share.x).lerp(c.lerp(d, share.x), share.y);
        let miss = (flow_px + back).length();
        self.returning += 1;
        self.undone += usize::from(miss < 0.1);
        self.worst_px = self.worst_px.max(miss);
    }
}

#[test]
fn flow_leads_to_the_same_objects_and_back() {
    let mut all = [Agreement::default(), Agreement::default()];
    for map in ["Town10HD", "Town05"] {
        let out = tempfile::tempdir().expect("temp");
        let video = make(map, SIZE, 2, out.path(), 2);
        assert_eq!(check(out.path()).expect("a dataset").findings, []);
        for camera in 0..2 {
            let folder = video.camera(camera).folder().to_owned();
            let frames: Vec<StoredFrame> = (0..FRAMES).map(|frame| StoredFrame::read(&folder, frame)).collect();
            assert!(frames[0].backward.iter().all(Option::is_none), "there is no frame before the first");
            assert!(frames[FRAMES as usize - 1].forward.iter().all(Option::is_none), "nor one after the last");
            for pair in frames.windows(2) {
                let [now, then] = pair else { continue };
                all[0].compare(now, then, &now.forward, &then.backward);
                all[1].compare(then, now, &then.backward, &now.forward);
            }
        }
    }
    for counts in &all {
        println!("{counts:?}");
        let share = |part: usize, whole: usize| part as f64 / whole as f64;
        let Agreement { still, moving, same, near, hidden, returning, undone, .. } = *counts;
        assert!(moving > 20_000 && hidden > 500 && returning > moving / 3, "{counts:?}");
        assert!(share(still + same, still + moving) > 0.999, "{counts:?}");
        // Legs and spokes are narrower than a pixel far away, and lie between four centres.
        assert!(share(near, moving) > 0.995, "{counts:?}");
        assert!(share(undone, returning) > 0.99, "{counts:?}");
    }
}

/// The files of a folder of images, by name.
fn images(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut all: Vec<_> = fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .map(|path| (path.file_name().expect("a name").to_string_lossy().into_owned(), fs::read(&path).expect("read")))
        .collect();
    all.sort();
    all
}

#[test]
fn flow_depends_on_neither_threads_nor_resuming() {
    let [one, two] = [(); 2].map(|()| tempfile::tempdir().expect("temp"));
    let size = ImageSize { width: 193, height: 109 };
    let make = |out: &Path, threads| make("Town01", size, 1, out, threads);
    let [of_one, of_two] = [(one.path(), 1), (two.path(), 2)].map(|(out, threads)| make(out, threads));
    let same = |what: &str| {
        for layer in [Layer::Flow, Layer::FlowBackward] {
            let [first, second] = [&of_one, &of_two].map(|video| images(&video.camera(0).layer(layer)));
            assert_eq!(first.len(), FRAMES as usize);
            assert!(first == second, "{what} changes {layer}");
        }
    };
    same("threads");
    // As if the run had ended with some frames only: the flow of those left leads to frames that are there.
    fs::remove_file(of_two.scene()).expect("there");
    for (layer, frame) in [(Layer::Flow, 0), (Layer::Depth, 2), (Layer::FlowBackward, 3)] {
        let path = of_two.camera(0).layer(layer).join(format!("{frame:06}.png"));
        fs::remove_file(path).expect("there");
    }
    make(two.path(), 2);
    same("resuming");
}
