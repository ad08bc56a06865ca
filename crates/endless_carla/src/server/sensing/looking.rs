//! Sensors that look at the scene do so beside the thread that answers: in asynchronous mode nobody waits for a picture.

use super::look::{Look, Views};
use crate::stream::{Delivery, StreamHub};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};

/// Who looks, and what is kept of the frames before.
pub(super) struct Looking {
    state: State,
    /// Sensors that have gone since.
    gone: Vec<u32>,
}

enum State {
    Free(Box<Views>),
    /// They will come back from there.
    Busy(Receiver<Box<Views>>),
}

impl Looking {
    pub(super) fn new() -> Self {
        Self { state: State::Free(Box::default()), gone: Vec::new() }
    }

    /// Takes what is kept, when it is free: waited for, if every frame counts. It must be put back, or begin.
    pub(super) fn views(&mut self, delivery: Delivery) -> Option<Box<Views>> {
        let mut views = match std::mem::replace(&mut self.state, State::Free(Box::default())) {
            State::Free(views) => views,
            State::Busy(back) => match (delivery, back.try_recv()) {
                (_, Ok(views)) => views,
                (Delivery::Latest, Err(TryRecvError::Empty)) => {
                    self.state = State::Busy(back);
                    return None;
                }
                (Delivery::Every, Err(TryRecvError::Empty)) => back.recv().unwrap_or_default(),
                (_, Err(TryRecvError::Disconnected)) => Box::default(),
            },
        };
        self.gone.drain(..).for_each(|stream| views.forget(stream));
        Some(views)
    }

    pub(super) fn put_back(&mut self, views: Box<Views>) {
        self.state = State::Free(views);
    }

    /// Looks, and sends what is seen; to the end, if every frame counts.
    pub(super) fn begin(&mut self, mut views: Box<Views>, look: Look, hub: &Arc<StreamHub>, delivery: Delivery) {
        let (done, back) = channel();
        let hub = Arc::clone(hub);
        rayon::spawn(move || {
            views.look(look, &hub, delivery);
            // Nobody takes it back when another episode has begun.
            let _ = done.send(views);
        });
        self.state = match delivery {
            Delivery::Every => State::Free(back.recv().unwrap_or_default()),
            Delivery::Latest => State::Busy(back),
        };
    }

    /// A sensor has gone.
    pub(super) fn forget(&mut self, stream: u32) {
        match &mut self.state {
            State::Free(views) => views.forget(stream),
            State::Busy(_) => self.gone.push(stream),
        }
    }
}
