//! Planes as NumPy's arrays, which own the memory: nothing is copied.

use endless_dataset::{Plane, PlaneValues};
use endless_world::ImageSize;
use numpy::{Element, PyArray1, PyArrayMethods};
use pyo3::{prelude::*, types::PyDict};

/// Adds planes of an image to a dictionary of arrays, by their names.
pub(crate) fn insert_planes(arrays: &Bound<'_, PyDict>, planes: Vec<Plane>, size: ImageSize) -> PyResult<()> {
    let py = arrays.py();
    for Plane { name, channels, values } in planes {
        let mut shape = vec![size.height as usize, size.width as usize];
        if channels > 1 {
            shape.push(channels);
        }
        let array = match values {
            PlaneValues::U8(values) => shaped(py, values, shape)?,
            PlaneValues::I32(values) => shaped(py, values, shape)?,
            PlaneValues::F32(values) => shaped(py, values, shape)?,
        };
        arrays.set_item(name, array)?;
    }
    Ok(())
}

/// An array of this shape.
pub(crate) fn shaped<T: Element>(py: Python<'_>, values: Vec<T>, shape: Vec<usize>) -> PyResult<Bound<'_, PyAny>> {
    Ok(PyArray1::from_vec(py, values).reshape(shape)?.into_any())
}
