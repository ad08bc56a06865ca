//! Accepts clients of streams.

use super::hub::StreamHub;
use std::io::Read;
use std::net::{TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

/// Most sessions at a time, of all streams.
const MOST_SESSIONS: usize = 4096;
/// How long a client may take to say what it wants to hear.
const HELLO: Duration = Duration::from_secs(5);

/// Accepts clients for ever, each with a thread of its own.
pub fn listen_for_sessions(listener: &TcpListener, hub: &Arc<StreamHub>) {
    let sessions = Arc::new(AtomicUsize::new(0));
    for stream in listener.incoming() {
        let Ok(stream) = stream else { continue };
        if sessions.fetch_add(1, Ordering::Relaxed) >= MOST_SESSIONS {
            sessions.fetch_sub(1, Ordering::Relaxed);
            tracing::warn!("{MOST_SESSIONS} streams are listened to: another one is refused");
            continue;
        }
        let (hub, sessions) = (Arc::clone(hub), Arc::clone(&sessions));
        let spawned = thread::Builder::new().name("stream".to_owned()).spawn(move || {
            if let Some(id) = hello(&stream) {
                hub.join(id, stream);
            }
            sessions.fetch_sub(1, Ordering::Relaxed);
        });
        if let Err(error) = spawned {
            tracing::warn!("no thread for a stream: {error}");
        }
    }
}

/// The number of the stream that a client wants to hear.
fn hello(mut stream: &TcpStream) -> Option<u32> {
    stream.set_nodelay(true).ok()?;
    stream.set_read_timeout(Some(HELLO)).ok()?;
    let mut id = [0; 4];
    stream.read_exact(&mut id).ok()?;
    stream.set_read_timeout(None).ok()?;
    Some(u32::from_le_bytes(id))
}
