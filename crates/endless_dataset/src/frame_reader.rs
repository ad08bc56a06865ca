//! Random access to the camera frames of a dataset.

use crate::{
    CameraLayout, DatasetError, DatasetLayout, Layer, Manifest, RgbFormat, StoredImage, VideoEntry, VideoLayout,
    read_json, read_rgb,
};
use endless_world::SceneSettings;
use std::{
    fs::{self, File},
    io::{Read, Seek, SeekFrom},
    path::{Path, PathBuf},
    sync::OnceLock,
};

/// The camera frames of all complete videos: by video, by camera, by time.
#[derive(Debug)]
pub struct FrameReader {
    manifest: Manifest,
    root: PathBuf,
    cameras: Vec<CameraFrames>,
}

/// Which camera frames are read; all where nothing is said.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct FrameSelection {
    /// Names of videos.
    pub videos: Option<Vec<String>>,
    /// Names of cameras: `camera_a`, or a sensor's of the rig.
    pub cameras: Option<Vec<String>>,
}

/// The frames of one camera.
#[derive(Debug)]
pub struct CameraFrames {
    /// Index of its first frame among all.
    pub first: usize,
    /// How many it has.
    pub count: usize,
    /// Its video.
    pub video: VideoEntry,
    /// Its name.
    pub name: String,
    /// Its files.
    pub files: CameraLayout,
    /// The layers that are stored of it.
    pub layers: Vec<Layer>,
    /// Frames of the video from one of its own to the next.
    every: u32,
    /// Where the lines of `objects.jsonl` begin, and where the last ends; once somebody asks.
    lines: OnceLock<Vec<u64>>,
}

impl FrameReader {
    /// Opens a dataset.
    ///
    /// # Errors
    /// When it is none, or has no such video or camera.
    pub fn open(root: &Path, selection: &FrameSelection) -> Result<Self, DatasetError> {
        let layout = DatasetLayout::new(root);
        let manifest = Manifest::read(&layout.manifest())?;
        let chosen = |names: &Option<Vec<String>>, name: &String| names.as_ref().is_none_or(|all| all.contains(name));
        let mut reader = Self { manifest, root: root.to_owned(), cameras: Vec::new() };
        let mut known = Vec::new();
        let mut first = 0;
        for video in reader.manifest.videos.iter().filter(|video| chosen(&selection.videos, &video.name)) {
            let files = layout.video_named(&video.name);
            if !files.scene().is_file() {
                continue;
            }
            for (camera, every) in cameras(&layout, &reader.manifest, video)? {
                if !known.contains(&camera) {
                    known.push(camera.clone());
                }
                if chosen(&selection.cameras, &camera) {
                    let count = video.frames.div_ceil(every.max(1)) as usize;
                    reader.cameras.push(CameraFrames::new(video, &files, camera, every, first, count));
                    first += count;
                }
            }
        }
        let of_videos: Vec<String> = reader.manifest.videos.iter().map(|video| video.name.clone()).collect();
        reader.all_are_known("video", selection.videos.as_deref(), &of_videos)?;
        reader.all_are_known("camera", selection.cameras.as_deref(), &known)?;
        Ok(reader)
    }

    fn all_are_known(&self, what: &str, asked: Option<&[String]>, known: &[String]) -> Result<(), DatasetError> {
        let unknown = asked.into_iter().flatten().find(|name| !known.contains(name));
        unknown.map_or(Ok(()), |name| {
            let reason = format!("the dataset has no complete {what} '{name}': use some of {}", known.join(", "));
            Err(DatasetError::malformed(&self.root, reason))
        })
    }

    /// `dataset.json`.
    pub fn manifest(&self) -> &Manifest {
        &self.manifest
    }

    /// The cameras, in the order of their frames.
    pub fn cameras(&self) -> &[CameraFrames] {
        &self.cameras
    }

    /// Number of camera frames.
    pub fn len(&self) -> usize {
        self.cameras.last().map_or(0, |camera| camera.first + camera.count)
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The place of a frame's camera, and the frame's number in its video; `None` beyond the end.
    pub fn place(&self, index: usize) -> Option<(usize, u32)> {
        let place = self.cameras.partition_point(|camera| camera.first <= index).checked_sub(1)?;
        let camera = &self.cameras[place];
        let own = index - camera.first;
        (own < camera.count).then(|| (place, own as u32 * camera.every))
    }

    /// The image of a layer.
    ///
    /// # Errors
    /// When it is not stored, or cannot be read.
    pub fn image(&self, camera: &CameraFrames, frame: u32, layer: Layer) -> Result<StoredImage<'static>, DatasetError> {
        let rgb_format: RgbFormat = self.manifest.recipe.rgb_format;
        read_rgb(&camera.files.frame(layer, frame, rgb_format), layer.format(rgb_format))
    }
}

/// Names of the cameras of a video, and at every so many of its frames each films.
fn cameras(
    layout: &DatasetLayout,
    manifest: &Manifest,
    video: &VideoEntry,
) -> Result<Vec<(String, u32)>, DatasetError> {
    let mut cameras: Vec<_> = (0..video.cameras.len()).map(|camera| (VideoLayout::camera_name(camera), 1)).collect();
    if !manifest.recipe.sensor.is_empty() {
        let settings: SceneSettings = read_json(&layout.scene(video.video))?;
        let files = layout.video_named(&video.name);
        let of_rig = settings.sensors.into_iter().filter(|sensor| files.sensor(&sensor.name).camera().is_file());
        cameras.extend(of_rig.map(|sensor| (sensor.name, sensor.every)));
    }
    Ok(cameras)
}

impl CameraFrames {
    fn new(video: &VideoEntry, files: &VideoLayout, name: String, every: u32, first: usize, count: usize) -> Self {
        let files = files.sensor(&name);
        let layers = Layer::ALL.iter().copied().filter(|layer| files.layer(*layer).is_dir()).collect();
        Self { first, count, video: video.clone(), name, files, layers, every: every.max(1), lines: OnceLock::new() }
    }

    /// The line of `objects.jsonl` of a frame of the video, without its end.
    ///
    /// # Errors
    /// When it cannot be read.
    pub fn objects_line(&self, frame: u32) -> Result<Vec<u8>, DatasetError> {
        let path = self.files.objects();
        let lines = match self.lines.get() {
            Some(lines) => lines,
            None => {
                let text = fs::read(&path).map_err(|e| DatasetError::io("cannot read", &path, e))?;
                let ends = (1..).zip(&text).filter_map(|(end, byte)| (*byte == b'\n').then_some(end));
                self.lines.get_or_init(|| std::iter::once(0).chain(ends).collect())
            }
        };
        let own = (frame / self.every) as usize;
        let Some(&[start, end]) = lines.get(own..own + 2) else {
            return Err(DatasetError::malformed(&path, format!("has no line of frame {frame}")));
        };
        let mut line = vec![0; (end - start - 1) as usize];
        File::open(&path)
            .and_then(|mut file| file.seek(SeekFrom::Start(start)).and_then(|_| file.read_exact(&mut line)))
            .map_err(|e| DatasetError::io("cannot read", &path, e))?;
        Ok(line)
    }
}
