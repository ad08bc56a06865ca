//! A client's connection: what it is answered waits in a queue with bounds, so that a client that does not read holds up
//! nobody.

use std::io::Write;
use std::net::{Shutdown, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};

/// Most answers that wait for a client.
const MOST_WAITING: usize = 1 << 16;
/// Most bytes of them.
const MOST_BYTES: usize = 256 << 20;

/// Tells connections apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ConnectionId(pub u64);

/// Who waits for an answer.
#[derive(Debug, Clone)]
pub struct Caller {
    /// Whose connection.
    pub id: ConnectionId,
    queue: SyncSender<Vec<u8>>,
    waiting: Arc<AtomicUsize>,
    stream: Arc<TcpStream>,
}

/// What waits for a client.
pub(super) struct AnswerQueue {
    receiver: Receiver<Vec<u8>>,
    waiting: Arc<AtomicUsize>,
    stream: Arc<TcpStream>,
}

impl Caller {
    pub(super) fn new(id: ConnectionId, stream: TcpStream) -> (Self, AnswerQueue) {
        let (queue, receiver) = sync_channel(MOST_WAITING);
        let (waiting, stream) = (Arc::default(), Arc::new(stream));
        let own = AnswerQueue { receiver, waiting: Arc::clone(&waiting), stream: Arc::clone(&stream) };
        (Self { id, queue, waiting, stream }, own)
    }

    /// Sends a message, when the client reads. A client for whom too much waits is let go.
    pub fn send(&self, message: Vec<u8>) {
        let bytes = message.len();
        let waiting = self.waiting.fetch_add(bytes, Ordering::Relaxed) + bytes;
        if waiting > MOST_BYTES || self.queue.try_send(message).is_err() {
            tracing::warn!(client = self.id.0, "a client does not read its answers: its connection is closed");
            self.close();
        }
    }

    /// Ends the connection.
    pub(super) fn close(&self) {
        // It may be gone already.
        let _ = self.stream.shutdown(Shutdown::Both);
    }
}

impl AnswerQueue {
    /// Writes answers until the connection ends.
    pub(super) fn write_all(self) {
        let mut stream = &*self.stream;
        for message in &self.receiver {
            self.waiting.fetch_sub(message.len(), Ordering::Relaxed);
            if stream.write_all(&message).is_err() {
                break;
            }
        }
        let _ = stream.shutdown(Shutdown::Both);
    }
}
