//! One client that listens to one stream.

use std::collections::VecDeque;
use std::io::{ErrorKind, Write};
use std::net::{Shutdown, TcpStream};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Most bytes that wait for a client: hundreds of images.
const MOST_BYTES: usize = 256 << 20;
/// A client that takes nothing for so long is let go.
const PATIENCE: Duration = Duration::from_secs(20);
/// How often a session whose stream is silent asks whether its client is still there.
const LISTEN: Duration = Duration::from_millis(500);

/// What waits for one client.
pub(super) struct Session {
    stream: TcpStream,
    queue: Mutex<Queue>,
    changed: Condvar,
}

#[derive(Default)]
struct Queue {
    messages: VecDeque<Arc<Vec<u8>>>,
    bytes: usize,
    /// One is on its way.
    writing: bool,
    closed: bool,
}

impl Session {
    pub(super) fn new(stream: TcpStream) -> Self {
        Self { stream, queue: Mutex::default(), changed: Condvar::new() }
    }

    fn queue(&self) -> MutexGuard<'_, Queue> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn is_open(&self) -> bool {
        !self.queue().closed
    }

    pub(super) fn close(&self) {
        self.queue().closed = true;
        self.changed.notify_all();
        // It may be gone already.
        let _ = self.stream.shutdown(Shutdown::Both);
    }

    /// Adds a message, and waits for room; closes the session if there is none for too long.
    pub(super) fn send(&self, message: &Arc<Vec<u8>>) {
        let deadline = Instant::now() + PATIENCE;
        let mut queue = self.queue();
        while !queue.closed && queue.bytes > 0 && queue.bytes + message.len() > MOST_BYTES {
            let left = deadline.saturating_duration_since(Instant::now());
            if left.is_zero() {
                drop(queue);
                tracing::warn!("a client does not read its stream: it is closed");
                return self.close();
            }
            queue = self.changed.wait_timeout(queue, left).unwrap_or_else(PoisonError::into_inner).0;
        }
        queue.push(message);
        self.changed.notify_all();
    }

    /// Adds a message unless another waits.
    pub(super) fn send_latest(&self, message: &Arc<Vec<u8>>) {
        let mut queue = self.queue();
        if queue.messages.is_empty() && !queue.writing {
            queue.push(message);
            self.changed.notify_all();
        }
    }

    /// Writes until the session is closed.
    pub(super) fn write_all(&self) {
        // A client that has gone away without a word holds up this thread alone.
        let _ = self.stream.set_write_timeout(Some(PATIENCE));
        while let Some(message) = self.next() {
            let mut stream = &self.stream;
            let length = (message.len() as u32).to_le_bytes();
            if stream.write_all(&length).and_then(|()| stream.write_all(&message)).is_err() {
                break;
            }
            self.queue().writing = false;
            self.changed.notify_all();
        }
        self.close();
    }

    /// The next message; `None` when the session ends.
    fn next(&self) -> Option<Arc<Vec<u8>>> {
        let mut queue = self.queue();
        loop {
            if queue.closed {
                return None;
            }
            if let Some(message) = queue.messages.pop_front() {
                queue.bytes -= message.len();
                queue.writing = true;
                self.changed.notify_all();
                return Some(message);
            }
            let (woken, wait) = self.changed.wait_timeout(queue, LISTEN).unwrap_or_else(PoisonError::into_inner);
            queue = woken;
            if wait.timed_out() && !self.client_is_there() {
                return None;
            }
        }
    }

    /// Clients send nothing after their stream's number.
    fn client_is_there(&self) -> bool {
        if self.stream.set_nonblocking(true).is_err() {
            return false;
        }
        let there = match self.stream.peek(&mut [0]) {
            Ok(count) => count > 0,
            Err(error) => error.kind() == ErrorKind::WouldBlock,
        };
        there && self.stream.set_nonblocking(false).is_ok()
    }
}

impl Queue {
    fn push(&mut self, message: &Arc<Vec<u8>>) {
        if !self.closed {
            self.bytes += message.len();
            self.messages.push_back(Arc::clone(message));
        }
    }
}
