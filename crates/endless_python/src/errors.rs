//! Errors as exceptions of `endless_city.errors`: what was asked for, what is on the disk, what was simulated.

use endless::UsageError;
use endless_dataset::DatasetError as UnreadableDataset;
use endless_export::ExportError;
use endless_pipeline::{GenerateError, PlanError, RecipeError as UnmadeRecipe, SimulatorError};
use pyo3::{PyErr, exceptions::PyKeyboardInterrupt, import_exception};

import_exception!(endless_city.errors, EndlessError);
import_exception!(endless_city.errors, DatasetError);
import_exception!(endless_city.errors, RecipeError);
import_exception!(endless_city.errors, SimulationError);

/// The exception of an error; its message is the program's own.
pub(crate) fn exception(error: &anyhow::Error) -> PyErr {
    let message = format!("{error:#}");
    if let Some(error) = error.downcast_ref::<GenerateError>() {
        return match error {
            GenerateError::Plan(PlanError::Simulator(error)) | GenerateError::Simulator(error) => {
                of_simulator(error, message)
            }
            GenerateError::Plan(_) => RecipeError::new_err(message),
            GenerateError::Threads(_) => EndlessError::new_err(message),
            GenerateError::Annotate(_) => SimulationError::new_err(message),
            _ => DatasetError::new_err(message),
        };
    }
    match error.downcast_ref() {
        Some(UnmadeRecipe::Map(error)) => of_simulator(error, message),
        Some(_) => RecipeError::new_err(message),
        None if error.is::<UsageError>() => RecipeError::new_err(message),
        None if error.is::<UnreadableDataset>() => DatasetError::new_err(message),
        None => error.downcast_ref().map_or_else(
            || EndlessError::new_err(message.clone()),
            |error: &SimulatorError| of_simulator(error, message.clone()),
        ),
    }
}

fn of_simulator(error: &SimulatorError, message: String) -> PyErr {
    match error {
        SimulatorError::Interrupted => PyKeyboardInterrupt::new_err(message),
        SimulatorError::UnknownMap { .. } | SimulatorError::Unsupported { .. } | SimulatorError::NoRigs => {
            RecipeError::new_err(message)
        }
        _ => SimulationError::new_err(message),
    }
}

/// The exception of a dataset that cannot be read.
pub(crate) fn unreadable(error: &UnreadableDataset) -> PyErr {
    DatasetError::new_err(error.to_string())
}

/// The exception of a dataset that cannot be divided into parts.
pub(crate) fn undivided(error: &ExportError) -> PyErr {
    match error {
        ExportError::Split(reason) => RecipeError::new_err(reason.clone()),
        _ => DatasetError::new_err(error.to_string()),
    }
}
