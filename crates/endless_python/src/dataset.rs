//! Random access to a dataset on the disk.

use crate::{
    arrays::insert_planes,
    errors::{RecipeError, undivided, unreadable},
    objects::columns,
};
use endless_annotate::FrameObjects;
use endless_dataset::{CameraFrames, DatasetError, FrameReader, FrameSelection, Layer, Plane, PoseLine, read_lines};
use endless_export::{SplitBy, SplitShares};
use endless_world::{ImageSize, UnknownName};
use pyo3::{
    exceptions::{PyIndexError, PyValueError},
    prelude::*,
    types::{PyBytes, PyDict},
};
use std::{path::PathBuf, thread};

/// The parts in which `endless export` divides a dataset, with the names of the videos of each.
#[pyfunction]
pub(crate) fn split(
    py: Python<'_>,
    root: PathBuf,
    shares: Option<&str>,
    by: &str,
) -> PyResult<Vec<(String, Vec<String>)>> {
    let wrong = |reason: String| RecipeError::new_err(reason);
    let shares: Option<SplitShares> = shares.map(str::parse).transpose().map_err(wrong)?;
    let by: SplitBy = by.parse().map_err(|error: UnknownName| wrong(error.to_string()))?;
    py.detach(|| endless_export::parts(&root, shares.as_ref(), by)).map_err(|error| undivided(&error))
}

/// Reads the camera frames of a dataset, decoded without the interpreter's lock.
#[pyclass(frozen, module = "endless_city._native")]
pub(crate) struct DatasetReader {
    reader: FrameReader,
}

#[pymethods]
impl DatasetReader {
    #[new]
    fn new(py: Python<'_>, root: PathBuf, videos: Option<Vec<String>>, cameras: Option<Vec<String>>) -> PyResult<Self> {
        let open = || FrameReader::open(&root, &FrameSelection { videos, cameras });
        Ok(Self { reader: py.detach(open).map_err(|error| unreadable(&error))? })
    }

    fn __len__(&self) -> usize {
        self.reader.len()
    }

    /// The recipe, as JSON.
    fn recipe(&self) -> String {
        serde_json::to_string(&self.reader.manifest().recipe).unwrap_or_default()
    }

    /// Names of the classes, by their ids.
    fn classes(&self) -> Vec<&str> {
        self.reader.manifest().labels.classes.iter().map(|class| class.name.as_str()).collect()
    }

    /// Of each camera: its video, its name, the layers that are stored, the index of its first frame, how many it has.
    fn cameras(&self) -> Vec<(&str, &str, Vec<&'static str>, usize, usize)> {
        let row = |camera: &'_ CameraFrames| {
            let layers = camera.layers.iter().map(|layer| layer.name()).collect();
            (layers, camera.first, camera.count)
        };
        let rows = self.reader.cameras().iter();
        rows.map(|camera| {
            let (layers, first, count) = row(camera);
            (camera.video.name.as_str(), camera.name.as_str(), layers, first, count)
        })
        .collect()
    }

    /// Of a camera frame: the place of its camera, and its number in the video.
    fn place(&self, index: usize) -> PyResult<(usize, u32)> {
        let place = self.reader.place(index);
        place.ok_or_else(|| PyIndexError::new_err(format!("there are {} camera frames", self.reader.len())))
    }

    /// `camera.json` of a camera.
    fn camera_json<'py>(&self, py: Python<'py>, camera: usize) -> PyResult<Bound<'py, PyBytes>> {
        let path = self.camera(camera)?.files.camera();
        let text = std::fs::read(&path).map_err(|e| unreadable(&DatasetError::io("cannot read", path, e)))?;
        Ok(PyBytes::new(py, &text))
    }

    /// Row-major 4×4 of a camera that moves, of its own frame with this number.
    fn moving_pose(&self, py: Python<'_>, camera: usize, frame: u32) -> PyResult<Option<[[f64; 4]; 4]>> {
        let path = self.camera(camera)?.files.poses();
        let lines: Vec<PoseLine> = py.detach(|| read_lines(&path)).map_err(|error| unreadable(&error))?;
        Ok(lines.iter().find(|line| line.frame == frame).and_then(|line| line.world_from_camera))
    }

    /// Layers of a camera frame as arrays, by their names; each on a thread of its own.
    fn load<'py>(
        &self,
        py: Python<'py>,
        camera: usize,
        frame: u32,
        layers: Vec<String>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let of = self.camera(camera)?;
        let layers = layers.iter().map(|name| name.parse::<Layer>()).collect::<Result<Vec<_>, _>>();
        let layers = layers.map_err(|error| PyValueError::new_err(error.to_string()))?;
        let decoded = py.detach(|| side_by_side(&layers, |layer| self.decode(of, frame, layer)));
        let arrays = PyDict::new(py);
        for decoded in decoded {
            let (size, planes) = decoded.map_err(|error| unreadable(&error))?;
            insert_planes(&arrays, planes, size)?;
        }
        Ok(arrays)
    }

    /// The objects of a camera frame: their columns, and the line of `objects.jsonl`.
    fn objects<'py>(
        &self,
        py: Python<'py>,
        camera: usize,
        frame: u32,
    ) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyBytes>)> {
        let of = self.camera(camera)?;
        let read = || -> Result<(FrameObjects, Vec<u8>), DatasetError> {
            let line = of.objects_line(frame)?;
            let malformed = |e: serde_json::Error| DatasetError::malformed(of.files.objects(), e.to_string());
            Ok((serde_json::from_slice(&line).map_err(malformed)?, line))
        };
        let (objects, line) = py.detach(read).map_err(|error| unreadable(&error))?;
        Ok((columns(py, &objects)?, PyBytes::new(py, &line)))
    }
}

impl DatasetReader {
    fn camera(&self, place: usize) -> PyResult<&CameraFrames> {
        self.reader.cameras().get(place).ok_or_else(|| PyIndexError::new_err("there is no such camera"))
    }

    fn decode(&self, of: &CameraFrames, frame: u32, layer: Layer) -> Result<(ImageSize, Vec<Plane>), DatasetError> {
        let stored = self.reader.image(of, frame, layer)?;
        let size = stored.size();
        let planes = layer.planes(stored).map_err(|reason| DatasetError::malformed(of.files.layer(layer), reason))?;
        Ok((size, planes))
    }
}

/// Does the same with each layer, the last on this thread. No pool: its threads would be missing after a fork.
fn side_by_side<T: Send>(layers: &[Layer], decode: impl Fn(Layer) -> T + Sync) -> Vec<T> {
    let Some((&last, others)) = layers.split_last() else { return Vec::new() };
    thread::scope(|scope| {
        let decode = &decode;
        let spawn = |&layer: &Layer| {
            let thread = thread::Builder::new().spawn_scoped(scope, move || decode(layer));
            (layer, thread)
        };
        let threads: Vec<_> = others.iter().map(spawn).collect();
        let of_last = decode(last);
        // Where the system gives no thread, this one does it.
        let joined = threads.into_iter().map(|(layer, thread)| match thread.map(thread::ScopedJoinHandle::join) {
            Ok(Ok(decoded)) => decoded,
            Ok(Err(panic)) => std::panic::resume_unwind(panic),
            Err(_none_given) => decode(layer),
        });
        joined.chain(std::iter::once_with(|| of_last)).collect()
    })
}
