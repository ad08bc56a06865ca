//! The objects of a camera frame as columns.

use crate::arrays::shaped;
use endless_annotate::{FrameObjects, Keypoint, ObjectRecord, Visibility};
use endless_world::{KEYPOINT_COUNT, ObjectClass};
use numpy::{Element, PyArray1};
use pyo3::{prelude::*, types::PyDict};

/// Columns of N objects, by their names. What an object does not have is NaN, and 0 of keypoints.
pub(crate) fn columns<'py>(py: Python<'py>, of: &FrameObjects) -> PyResult<Bound<'py, PyDict>> {
    let objects = &of.objects[..];
    let columns = PyDict::new(py);
    let class = |o: &ObjectRecord| ObjectClass::ALL.iter().position(|class| *class == o.class).unwrap_or_default();
    set(&columns, "ids", objects, |o| i32::from(o.id.0))?;
    set(&columns, "class_ids", objects, |o| class(o) as i64)?;
    set(&columns, "pixels", objects, |o| i64::from(o.pixels))?;
    set(&columns, "truncated", objects, |o| o.truncated)?;
    set(&columns, "parked", objects, |o| o.parked)?;
    set(&columns, "visibility", objects, |o| o.amodal.as_ref().map_or(f32::NAN, |amodal| amodal.visibility as f32))?;
    set(&columns, "yaw_rad", objects, |o| o.yaw_rad)?;
    set_rows(&columns, "boxes", objects, |o| [o.bbox.x, o.bbox.y, o.bbox.w, o.bbox.h].map(|n| n as f32))?;
    set_rows(&columns, "amodal_boxes", objects, |o| {
        o.amodal.as_ref().map_or([f32::NAN; 4], |amodal| {
            let b = amodal.amodal_bbox;
            [b.x, b.y, b.w, b.h].map(|n| n as f32)
        })
    })?;
    set_rows(&columns, "positions_m", objects, |o| o.position)?;
    set_rows(&columns, "velocities_mps", objects, |o| o.velocity_mps)?;
    let keypoints = objects.iter().flat_map(|o| o.keypoints.map_or([[0.0; 3]; KEYPOINT_COUNT], |k| k.0.map(row)));
    let keypoints = keypoints.collect::<Vec<[f32; 3]>>().into_flattened();
    columns.set_item("keypoints", shaped(py, keypoints, vec![objects.len(), KEYPOINT_COUNT, 3])?)?;
    Ok(columns)
}

/// x, y, and COCO's visibility.
fn row(keypoint: Keypoint) -> [f32; 3] {
    let visibility = match keypoint.visibility {
        Visibility::Outside => 0.0,
        Visibility::Hidden => 1.0,
        Visibility::Visible => 2.0,
    };
    [keypoint.x as f32, keypoint.y as f32, visibility]
}

fn set<T: Element>(
    columns: &Bound<'_, PyDict>,
    name: &str,
    objects: &[ObjectRecord],
    value: impl Fn(&ObjectRecord) -> T,
) -> PyResult<()> {
    columns.set_item(name, PyArray1::from_vec(columns.py(), objects.iter().map(value).collect()))
}

fn set_rows<T: Element, const N: usize>(
    columns: &Bound<'_, PyDict>,
    name: &str,
    objects: &[ObjectRecord],
    value: impl Fn(&ObjectRecord) -> [T; N],
) -> PyResult<()> {
    let values = objects.iter().map(value).collect::<Vec<_>>().into_flattened();
    columns.set_item(name, shaped(columns.py(), values, vec![objects.len(), N])?)
}
