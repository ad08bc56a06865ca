//! All streams and who listens to them.

use super::session::Session;
use std::collections::BTreeMap;
use std::net::TcpStream;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// What happens to a message for which a client is too slow.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Delivery {
    /// It waits, and so does the world: nothing is lost.
    Every,
    /// It is lost.
    Latest,
}

/// All streams and who listens to them.
#[derive(Default)]
pub struct StreamHub {
    streams: Mutex<BTreeMap<u32, Stream>>,
    joined: Condvar,
}

#[derive(Default)]
struct Stream {
    sessions: Vec<Arc<Session>>,
    /// Clients that were told where it is, and have not come yet: they are expected until then.
    expected: Vec<Instant>,
}

/// Most clients of one stream.
const MOST_SESSIONS: usize = 256;
/// How long a client is waited for that was told where a stream is: on a busy machine its thread may take long to connect.
const EXPECTED: Duration = Duration::from_secs(2);

impl StreamHub {
    fn streams(&self) -> MutexGuard<'_, BTreeMap<u32, Stream>> {
        self.streams.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Begins a stream.
    pub fn open(&self, id: u32) {
        self.streams().entry(id).or_default();
    }

    /// Ends it, and all its sessions.
    pub fn close(&self, id: u32) {
        let ended = self.streams().remove(&id);
        ended.into_iter().flat_map(|stream| stream.sessions).for_each(|session| session.close());
    }

    /// A client was told where a stream is.
    pub fn expect(&self, id: u32) {
        if let Some(stream) = self.streams().get_mut(&id) {
            stream.expected.push(Instant::now() + EXPECTED);
        }
    }

    /// Waits for clients that are expected, so that they miss nothing of what comes next.
    pub fn wait_for_expected(&self) {
        let mut streams = self.streams();
        loop {
            let now = Instant::now();
            streams.values_mut().for_each(|stream| stream.expected.retain(|until| *until > now));
            let Some(until) = streams.values().flat_map(|stream| &stream.expected).max().copied() else { return };
            streams = self.joined.wait_timeout(streams, until - now).unwrap_or_else(PoisonError::into_inner).0;
        }
    }

    /// Whether anybody listens, or is about to.
    pub fn is_heard(&self, id: u32) -> bool {
        self.streams().get_mut(&id).is_some_and(|stream| {
            stream.sessions.retain(|session| session.is_open());
            !stream.sessions.is_empty() || !stream.expected.is_empty()
        })
    }

    /// Sends a message to all who listen.
    pub fn publish(&self, id: u32, message: Vec<u8>, delivery: Delivery) {
        let sessions = self.streams().get(&id).map_or_else(Vec::new, |stream| stream.sessions.clone());
        let message = Arc::new(message);
        for session in sessions {
            match delivery {
                Delivery::Every => session.send(&message),
                Delivery::Latest => session.send_latest(&message),
            }
        }
    }

    /// A client listens to a stream until it goes; refused if there is no such stream.
    pub(super) fn join(&self, id: u32, client: TcpStream) {
        let session = Arc::new(Session::new(client));
        {
            let mut streams = self.streams();
            let Some(stream) = streams.get_mut(&id).filter(|stream| stream.sessions.len() < MOST_SESSIONS) else {
                drop(streams);
                return session.close();
            };
            stream.sessions.push(Arc::clone(&session));
            if !stream.expected.is_empty() {
                stream.expected.remove(0);
            }
        }
        self.joined.notify_all();
        session.write_all();
        if let Some(stream) = self.streams().get_mut(&id) {
            stream.sessions.retain(|other| !Arc::ptr_eq(other, &session));
        }
    }
}
