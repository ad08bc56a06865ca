//! `endless_city.generate`, and what its shards have.

use crate::{errors::exception, recipe, supervised::supervised, watch::Watch};
use endless::Request;
use pyo3::prelude::*;
use std::{ffi::OsString, sync::Arc};

/// What a run made: videos, camera frames, bytes, seconds.
type Made = (u32, u64, u64, f64);

/// Makes the dataset of a recipe, a JSON object, in a folder. The flags are those of `endless generate`. `report` is told
/// what is said, how many camera frames are made, and how many there will be.
#[pyfunction]
pub(crate) fn generate(
    py: Python<'_>,
    out: OsString,
    recipe: &str,
    flags: Vec<OsString>,
    report: Option<Py<PyAny>>,
) -> PyResult<Made> {
    let draft = recipe::draft(recipe)?;
    let watch = Arc::new(Watch::default());
    let request = Request::new(out, flags, draft, watch.stop().clone()).map_err(|error| exception(&error))?;
    let watched = Arc::clone(&watch);
    let tell = |py: Python<'_>| report.as_ref().map_or(Ok(()), |report| report.call1(py, watch.news()).map(drop));
    let made = supervised(py, &watch, tell, move || request.generate(&*watched))?.map_err(|error| exception(&error))?;
    Ok((made.videos, made.camera_frames, made.bytes, made.seconds))
}

/// How many frames the cameras of each of so many shards make.
#[pyfunction]
pub(crate) fn camera_frames_of_shards(
    py: Python<'_>,
    recipe: &str,
    flags: Vec<OsString>,
    of: u32,
) -> PyResult<Vec<u64>> {
    let draft = recipe::draft(recipe)?;
    let stop = Watch::default().stop().clone();
    let request = Request::new(".".into(), flags, draft, stop).map_err(|error| exception(&error))?;
    py.detach(|| request.camera_frames_of_shards(of)).map_err(|error| exception(&error))
}
