//! Sensors that look at the scene do so beside the thread that answers: in asynchronous mode nobody waits for a picture, and in
//! synchronous mode nobody waits long.

use super::look::Views;
use crate::stream::Delivery;
use std::sync::mpsc::{Receiver, RecvTimeoutError, TryRecvError, channel};
use std::time::Duration;

/// For how long a tick waits for all that is seen of its frame. The first picture of a place may take longer than clients wait
/// for an answer (many scripts say two seconds): it follows, and the next tick waits for it.
pub(super) const PATIENCE: Duration = Duration::from_millis(1500);

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

    /// Looks; if every frame counts, it waits for that with some patience.
    pub(super) fn begin(
        &mut self,
        mut views: Box<Views>,
        look: impl FnOnce(&mut Views) + Send + 'static,
        delivery: Delivery,
        patience: Duration,
    ) {
        let (done, back) = channel();
        rayon::spawn(move || {
            look(&mut views);
            // Nobody takes it back when another episode has begun.
            let _ = done.send(views);
        });
        self.state = match delivery {
            Delivery::Latest => State::Busy(back),
            Delivery::Every => match back.recv_timeout(patience) {
                Ok(views) => State::Free(views),
                Err(RecvTimeoutError::Timeout) => State::Busy(back),
                Err(RecvTimeoutError::Disconnected) => State::Free(Box::default()),
            },
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nobody_waits_for_ever_and_no_frame_is_lost() {
        let mut looking = Looking::new();
        let (go, gate) = channel::<()>();
        let views = looking.views(Delivery::Every).expect("nobody looks yet");
        let slow = move |_: &mut Views| gate.recv().expect("it is opened");
        looking.begin(views, slow, Delivery::Every, Duration::from_millis(1));
        // It still looks: who may leave frames out does so.
        assert!(looking.views(Delivery::Latest).is_none());
        looking.forget(7);
        go.send(()).expect("it waits");
        let views = looking.views(Delivery::Every).expect("what counts is waited for");
        let (tell, told) = channel();
        looking.begin(views, move |_| tell.send(()).expect("it is heard"), Delivery::Latest, PATIENCE);
        told.recv().expect("it has looked");
        assert!(looking.views(Delivery::Every).is_some());
    }
}
