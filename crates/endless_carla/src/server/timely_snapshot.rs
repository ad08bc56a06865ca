//! Snapshots of synchronous mode that wait for pictures, but not for ever.
//!
//! A snapshot is sent after all that was measured of its frame, so that a client whose tick has ended has its pictures on their
//! way. The first picture of a place may take longer than clients wait for a tick (many scripts say two seconds): then the
//! snapshot goes first, with the answer to the tick.

use crate::rpc::Caller;
use crate::stream::{Delivery, StreamHub};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};
use std::thread;
use std::time::{Duration, Instant};

/// How long a snapshot waits for what is measured of its frame.
const PATIENCE: Duration = Duration::from_millis(1500);
/// How often it is looked at whether that is over.
const LOOK: Duration = Duration::from_millis(100);

/// The answer to a tick.
pub(super) struct TickAnswer {
    pub(super) caller: Caller,
    pub(super) message: Vec<u8>,
}

/// A snapshot that is due at a time, if it was not sent before.
struct Due {
    at: Instant,
    stream: u32,
    message: Vec<u8>,
    /// It goes right after.
    answer: Option<TickAnswer>,
}

/// Where a snapshot waits.
pub(super) struct TimelySnapshot {
    hub: Arc<StreamHub>,
    due: Arc<Mutex<Option<Due>>>,
}

impl TimelySnapshot {
    /// With a thread that ends with it; without one, where none can be had, snapshots wait for as long as it takes.
    pub(super) fn new(hub: Arc<StreamHub>) -> Self {
        let due = Arc::default();
        let (seen, streams) = (Arc::downgrade(&due), Arc::clone(&hub));
        let watch = thread::Builder::new().name("snapshots".to_owned());
        if let Err(error) = watch.spawn(move || watch_over(&seen, &streams)) {
            tracing::warn!("no thread for snapshots: {error}");
        }
        Self { hub, due }
    }

    /// A snapshot begins to wait.
    pub(super) fn wait(&self, stream: u32, message: Vec<u8>, answer: Option<TickAnswer>) {
        *lock(&self.due) = Some(Due { at: Instant::now() + PATIENCE, stream, message, answer });
    }

    /// All of its frame is on its way: it goes, if it has not gone.
    pub(super) fn go(&self) {
        send(&mut lock(&self.due), &self.hub);
    }
}

fn watch_over(due: &Weak<Mutex<Option<Due>>>, hub: &StreamHub) {
    loop {
        thread::sleep(LOOK);
        let Some(due) = due.upgrade() else { return };
        let mut due = lock(&due);
        if due.as_ref().is_some_and(|due| Instant::now() >= due.at) {
            send(&mut due, hub);
        }
    }
}

fn lock(due: &Mutex<Option<Due>>) -> MutexGuard<'_, Option<Due>> {
    due.lock().unwrap_or_else(PoisonError::into_inner)
}

/// While it is sent nobody else may send one: they keep their order.
fn send(due: &mut Option<Due>, hub: &StreamHub) {
    if let Some(Due { stream, message, answer, .. }) = due.take() {
        hub.publish(stream, message, Delivery::Every);
        if let Some(TickAnswer { caller, message }) = answer {
            caller.send(message);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stream::listen_for_sessions;
    use std::io::{Read, Write};
    use std::net::{TcpListener, TcpStream};

    #[test]
    fn snapshots_go_when_all_is_measured_and_in_time() {
        let hub = Arc::new(StreamHub::default());
        hub.open(7);
        let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
        let mut client = TcpStream::connect(listener.local_addr().expect("a port")).expect("it listens");
        let streams = Arc::clone(&hub);
        thread::spawn(move || listen_for_sessions(&listener, &streams));
        hub.expect(7);
        client.write_all(&7u32.to_le_bytes()).expect("it reads");
        hub.wait_for_expected();
        let mut next = || {
            let mut message = [0; 5];
            client.read_exact(&mut message).expect("a message");
            message[4]
        };
        let snapshots = TimelySnapshot::new(hub);
        // Measured soon: at once, and once only.
        snapshots.wait(7, vec![1], None);
        snapshots.go();
        snapshots.go();
        assert_eq!(next(), 1);
        // Not measured in time: without it, and not again afterwards.
        let began = Instant::now();
        snapshots.wait(7, vec![2], None);
        assert_eq!(next(), 2);
        assert!(began.elapsed() >= PATIENCE);
        snapshots.go();
        snapshots.wait(7, vec![3], None);
        snapshots.go();
        assert_eq!(next(), 3);
    }
}
