//! `endless_city.render`: one frame.

use crate::{
    errors::{RecipeError, exception},
    recipe,
    streamed::ReadyFrame,
    supervised::supervised,
    watch::Watch,
};
use endless::Request;
use endless_world::{Image, ImageSize};
use numpy::{PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::{
    prelude::*,
    types::{PyBytes, PyDict},
};
use std::{ffi::OsString, sync::Arc};

/// Frame `frame` of the first video of a recipe, a JSON object, filmed by one camera of its first map or by those that the
/// plan chooses.
#[pyfunction]
pub(crate) fn render<'py>(
    py: Python<'py>,
    recipe: &str,
    flags: Vec<OsString>,
    camera: Option<String>,
    frame: u32,
) -> PyResult<Bound<'py, PyDict>> {
    let draft = recipe::draft(recipe)?;
    let watch = Arc::new(Watch::default());
    let request = Request::new(".".into(), flags, draft, watch.stop().clone()).map_err(|error| exception(&error))?;
    let watched = Arc::clone(&watch);
    let work = move || {
        let rendered = request.render(camera.as_deref(), frame, &*watched)?;
        anyhow::Ok(rendered.map(ReadyFrame::new).transpose()?)
    };
    let ready = supervised(py, &watch, |_| Ok(()), work)?.map_err(|error| exception(&error))?;
    let ready =
        ready.ok_or_else(|| RecipeError::new_err(format!("the video has no frame {frame}: render an earlier one")))?;
    ready.into_dict(py, true)
}

/// The bytes of a PNG of an image, uint8 (H, W, 3).
#[pyfunction]
pub(crate) fn encode_png<'py>(py: Python<'py>, rgb: PyReadonlyArray3<'py, u8>) -> PyResult<Bound<'py, PyBytes>> {
    let [height, width, channels] = [0, 1, 2].map(|axis| rgb.shape()[axis]);
    if channels != 3 || height == 0 || width == 0 || height.max(width) > 1 << 14 {
        return Err(RecipeError::new_err("give an image of shape (H, W, 3), at most 16384 pixels a side"));
    }
    let data: Vec<u8> = rgb.as_array().iter().copied().collect();
    let size = ImageSize { width: width as u32, height: height as u32 };
    let image = Image { size, data: data.as_chunks::<3>().0.to_vec() };
    Ok(PyBytes::new(py, &py.detach(|| endless_dataset::encode_png(&image))))
}
