//! Long work on a thread of its own, while the interpreter's thread waits for it, without the interpreter's lock, and looks
//! for Ctrl-C.

use crate::{errors::EndlessError, watch::Watch};
use pyo3::prelude::*;
use std::{
    any::Any,
    sync::{Arc, Mutex, PoisonError, mpsc},
    thread::{self, JoinHandle},
    time::Duration,
};

/// How often signals are looked for.
const LOOK: Duration = Duration::from_millis(50);
/// How long Ctrl-C waits for the work to end. A bake is not interrupted: it ends in the background.
const PATIENCE: Duration = Duration::from_millis(300);

/// Work that was told to stop and has not ended yet.
static ENDING: Mutex<Vec<JoinHandle<()>>> = Mutex::new(Vec::new());

/// Does work on a thread of its own, and tells `report` of it from time to time.
///
/// # Errors
/// What a signal raised, after which the work is told to stop; what `report` raised; [`EndlessError`] of work that panicked.
pub(crate) fn supervised<T: Send + 'static>(
    py: Python<'_>,
    watch: &Arc<Watch>,
    mut report: impl FnMut(Python<'_>) -> PyResult<()>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    wait_for_ending(py)?;
    let (done, result) = mpsc::sync_channel(1);
    let thread = spawn(move || {
        // Nobody waits any more after Ctrl-C.
        let _ = done.send(work());
    })?;
    // A receiver is for one thread; this is the one, with and without the lock.
    let result = Mutex::new(result);
    let wait =
        |py: Python<'_>, time| py.detach(|| result.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(time));
    loop {
        let answer = wait(py, LOOK);
        let told = py.check_signals().and_then(|()| report(py));
        match (answer, told) {
            (Ok(made), Ok(())) => return Ok(made),
            (Err(mpsc::RecvTimeoutError::Timeout), Ok(())) => {}
            (Err(mpsc::RecvTimeoutError::Disconnected), Ok(())) => {
                return Err(panicked(thread.join().err().as_deref()));
            }
            (_, Err(raised)) => {
                watch.stop().stop();
                // Whether it ended in time or not, who comes next waits for the rest.
                let _ = wait(py, PATIENCE);
                ENDING.lock().unwrap_or_else(PoisonError::into_inner).push(thread);
                return Err(raised);
            }
        }
    }
}

/// Waits until work that was told to stop has ended: it may hold the lock of a dataset.
fn wait_for_ending(py: Python<'_>) -> PyResult<()> {
    let ending = std::mem::take(&mut *ENDING.lock().unwrap_or_else(PoisonError::into_inner));
    let mut ending = ending.into_iter();
    while let Some(thread) = ending.next() {
        while !thread.is_finished() {
            py.detach(|| thread::sleep(LOOK));
            if let Err(raised) = py.check_signals() {
                ENDING.lock().unwrap_or_else(PoisonError::into_inner).extend(std::iter::once(thread).chain(ending));
                return Err(raised);
            }
        }
    }
    Ok(())
}

/// A thread for long work.
pub(crate) fn spawn(work: impl FnOnce() + Send + 'static) -> PyResult<JoinHandle<()>> {
    let thread = thread::Builder::new().name("endless".to_owned()).spawn(work);
    thread.map_err(|error| EndlessError::new_err(format!("the system gives no thread: {error}")))
}

/// The exception of a thread that panicked.
pub(crate) fn panicked(payload: Option<&(dyn Any + Send)>) -> PyErr {
    let text = payload.and_then(|payload| {
        payload.downcast_ref::<String>().map(String::as_str).or_else(|| payload.downcast_ref::<&str>().copied())
    });
    EndlessError::new_err(format!("a mistake in endless, please report it: {}", text.unwrap_or("no message")))
}
