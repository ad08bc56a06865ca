//! A client's connection: what it is answered waits in a queue with bounds, so that a client that does not read holds up
//! nobody.

use std::io::{self, Write};
use std::net::{Shutdown, TcpStream};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};

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
    stream: Arc<AnswerStream>,
}

/// What waits for a client.
pub(super) struct AnswerQueue {
    receiver: Receiver<Vec<u8>>,
    waiting: Arc<AtomicUsize>,
    stream: Arc<AnswerStream>,
}

/// Where answers are written, each of them whole.
#[derive(Debug)]
struct AnswerStream {
    stream: TcpStream,
    writing: Mutex<()>,
}

impl AnswerStream {
    fn write(&self, message: &[u8]) -> io::Result<()> {
        let _one_at_a_time = self.writing.lock().unwrap_or_else(PoisonError::into_inner);
        (&self.stream).write_all(message)
    }

    fn close(&self) {
        // It may be gone already.
        let _ = self.stream.shutdown(Shutdown::Both);
    }
}

impl Caller {
    pub(super) fn new(id: ConnectionId, stream: TcpStream) -> (Self, AnswerQueue) {
        let (queue, receiver) = sync_channel(MOST_WAITING);
        let (waiting, stream) = (Arc::default(), Arc::new(AnswerStream { stream, writing: Mutex::default() }));
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

    /// Sends a message at once: waits for a client that does not read.
    pub(super) fn send_now(&self, message: &[u8]) -> io::Result<()> {
        self.stream.write(message)
    }

    /// Ends the connection.
    pub(super) fn close(&self) {
        self.stream.close();
    }
}

impl AnswerQueue {
    /// Writes answers until the connection ends.
    pub(super) fn write_all(self) {
        for message in &self.receiver {
            self.waiting.fetch_sub(message.len(), Ordering::Relaxed);
            if self.stream.write(&message).is_err() {
                break;
            }
        }
        self.stream.close();
    }
}
