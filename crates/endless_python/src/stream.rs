//! `endless_city.stream`: frames of a thread of their own, through a channel that holds a few.

use crate::{
    errors::{EndlessError, exception},
    recipe,
    streamed::ReadyFrame,
    supervised::{panicked, spawn},
    watch::Watch,
};
use anyhow::Result;
use endless::Request;
use endless_pipeline::{StreamEnd, StreamOptions, StreamOrder};
use pyo3::{prelude::*, types::PyDict};
use std::{
    ffi::OsString,
    ops::ControlFlow,
    sync::{
        Arc, Mutex, PoisonError,
        mpsc::{Receiver, RecvTimeoutError, sync_channel},
    },
    thread::JoinHandle,
    time::Duration,
};

/// How often signals are looked for.
const LOOK: Duration = Duration::from_millis(50);

/// Frames of a recipe while they are made. Who drops it stops it.
#[pyclass(frozen, module = "endless_city._native")]
pub(crate) struct FrameStream {
    watch: Arc<Watch>,
    state: Mutex<Option<Running>>,
    /// The thread is this process's: a fork has none.
    process: u32,
}

struct Running {
    items: Receiver<Item>,
    thread: JoinHandle<()>,
    /// The video of the last frame.
    last: Option<u32>,
}

enum Item {
    Frame(Box<ReadyFrame>),
    End(Result<StreamEnd>),
}

#[pymethods]
impl FrameStream {
    /// Of a recipe, a JSON object. The flags are those of `endless generate`.
    #[new]
    fn new(recipe: &str, flags: Vec<OsString>, first_frame: u64, by_number: bool, buffer: usize) -> PyResult<Self> {
        let draft = recipe::draft(recipe)?;
        let watch = Arc::new(Watch::default());
        let request =
            Request::new(".".into(), flags, draft, watch.stop().clone()).map_err(|error| exception(&error))?;
        let order = if by_number { StreamOrder::ByNumber } else { StreamOrder::ByMap };
        let options = StreamOptions { order, first_frame, ..StreamOptions::default() };
        let (sender, items) = sync_channel(buffer.clamp(1, 1024));
        let watched = Arc::clone(&watch);
        let thread = spawn(move || {
            let mut broken = None;
            let mut take = |frame| {
                let sent = ReadyFrame::new(frame).map(|frame| sender.send(Item::Frame(Box::new(frame))));
                match sent {
                    Ok(Ok(())) => ControlFlow::Continue(()),
                    Ok(Err(_nobody_listens)) => ControlFlow::Break(()),
                    Err(error) => {
                        broken = Some(error);
                        ControlFlow::Break(())
                    }
                }
            };
            let end = request.stream(&options, &*watched, &mut take);
            // Where nobody listens, nobody asks how it ended.
            let _ = sender.send(Item::End(broken.map_or(end, |error| Err(error.into()))));
        })?;
        let state = Mutex::new(Some(Running { items, thread, last: None }));
        Ok(Self { watch, state, process: std::process::id() })
    }

    /// The next frame; `None` after the last.
    fn next<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        if self.process != std::process::id() {
            return Err(EndlessError::new_err("a stream belongs to the process that made it: make it after the fork"));
        }
        loop {
            let item = py.detach(|| {
                let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
                let running = state.as_mut()?;
                let item = running.items.recv_timeout(LOOK);
                let begins = match &item {
                    Ok(Item::Frame(frame)) => frame.begins(&mut running.last),
                    _ => false,
                };
                if let Ok(Item::End(_)) | Err(RecvTimeoutError::Disconnected) = &item {
                    let ended = state.take();
                    return Some((item, begins, ended.map(|ended| ended.thread)));
                }
                Some((item, begins, None))
            });
            match item {
                None => return Ok(None),
                Some((Ok(Item::Frame(frame)), begins, _)) => return frame.into_dict(py, begins).map(Some),
                Some((Ok(Item::End(end)), ..)) => return end.map(|_| None).map_err(|error| exception(&error)),
                Some((Err(RecvTimeoutError::Timeout), ..)) => py.check_signals()?,
                Some((Err(RecvTimeoutError::Disconnected), _, thread)) => {
                    let payload = thread.and_then(|thread| thread.join().err());
                    return Err(panicked(payload.as_deref()));
                }
            }
        }
    }

    /// Makes no more frames. It may be called at any time, again, and from any thread.
    fn close(&self, py: Python<'_>) {
        self.watch.stop().stop();
        py.detach(|| drop(self.state.lock().unwrap_or_else(PoisonError::into_inner).take()));
    }

    /// What was said since somebody asked last.
    fn news(&self) -> Vec<String> {
        self.watch.news().0
    }
}

impl Drop for FrameStream {
    fn drop(&mut self) {
        self.watch.stop().stop();
    }
}
