//! What there is: maps, assets, options, classes.

use crate::{
    arrays::insert_planes,
    errors::{EndlessError, RecipeError},
};
use endless_dataset::{LabelSchema, Layer, recipe_schema};
use endless_interchange::{MapLibrary, MapStatistics, asset_preview as draw_asset, list_assets};
use endless_world::Image;
use pyo3::{prelude::*, types::PyDict};
use serde_json::json;

/// All maps: a list in JSON.
#[pyfunction]
pub(crate) fn maps(py: Python<'_>) -> PyResult<String> {
    let library = MapLibrary::user();
    let (builtin, imported) = (library.builtin_names(), library.imported_names());
    let mut rows = Vec::new();
    for name in builtin.iter().chain(&imported) {
        py.check_signals()?;
        // One damaged map must not hide the others.
        let Ok(town) = py.detach(|| library.town(name)) else { continue };
        let of = MapStatistics::of(&town);
        rows.push(json!({
            "name": of.name, "summary": of.summary, "area_km2": of.area_km2, "lanes": of.lanes, "lane_km": of.lane_km,
            "cameras": town.cameras.iter().map(|camera| &camera.name).collect::<Vec<_>>(),
            "features": of.features, "imported": imported.contains(name),
        }));
    }
    Ok(serde_json::Value::from(rows).to_string())
}

/// A map from above, with the views of its cameras: uint8 (H, W, 3).
#[pyfunction]
pub(crate) fn map_preview<'py>(py: Python<'py>, map: &str) -> PyResult<Bound<'py, PyAny>> {
    let picture = py.detach(|| MapLibrary::user().preview(map));
    picture_array(py, picture.map_err(|error| RecipeError::new_err(error.to_string()))?)
}

/// All assets: a list in JSON.
#[pyfunction]
pub(crate) fn assets(py: Python<'_>) -> String {
    let listed = py.detach(|| list_assets(MapLibrary::builtin().catalogue()));
    let row = |asset: &endless_interchange::AssetListing| {
        json!({
            "name": asset.name, "kind": asset.class, "length_m": asset.length_m, "width_m": asset.width_m,
            "height_m": asset.height_m, "triangles": asset.triangles, "variants": asset.draws,
        })
    };
    serde_json::Value::from(listed.iter().map(row).collect::<Vec<_>>()).to_string()
}

/// A variant of an asset from all sides: uint8 (H, W, 3).
#[pyfunction]
pub(crate) fn asset_preview<'py>(py: Python<'py>, name: &str, variant: u64) -> PyResult<Bound<'py, PyAny>> {
    let picture = py.detach(|| draw_asset(MapLibrary::builtin().catalogue(), name, variant));
    picture_array(py, picture.map_err(|error| RecipeError::new_err(error.to_string()))?)
}

fn picture_array(py: Python<'_>, picture: Image<[u8; 3]>) -> PyResult<Bound<'_, PyAny>> {
    let arrays = PyDict::new(py);
    let size = picture.size;
    insert_planes(&arrays, Layer::Rgb.planes(picture.into()).map_err(EndlessError::new_err)?, size)?;
    arrays.as_any().get_item(Layer::Rgb.name())
}

/// The options of a recipe: a JSON schema.
#[pyfunction]
pub(crate) fn options() -> String {
    recipe_schema().to_string()
}

/// Names of the classes of objects, by their ids.
#[pyfunction]
pub(crate) fn classes() -> Vec<String> {
    LabelSchema::current().classes.into_iter().map(|class| class.name).collect()
}

/// Names of the class tags of pixels, by their values.
#[pyfunction]
pub(crate) fn tags() -> Vec<String> {
    LabelSchema::current().tags.into_iter().map(|tag| tag.name).collect()
}

/// What identifies this build, as `endless --version` tells it.
#[pyfunction]
pub(crate) fn version() -> String {
    endless::this_build().to_string()
}
