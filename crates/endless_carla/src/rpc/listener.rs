//! Accepts clients, and passes what they ask on to the one who answers.

use super::connection::{Caller, ConnectionId};
use super::decode::read_value;
use super::eager::EagerReader;
use super::request::Request;
use super::standing::StandingAnswers;
use std::io::BufReader;
use std::net::{TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::SyncSender;
use std::thread;

/// Most clients at a time.
const MOST_CLIENTS: usize = 512;

/// What happens to connections.
#[derive(Debug)]
pub enum RpcEvent {
    /// A client asks for something.
    Call(Caller, Request),
    /// A client has gone.
    Gone(ConnectionId),
}

/// Accepts clients for ever, each with threads of its own. All but the standing answers are left to who takes the events.
pub fn listen(listener: &TcpListener, events: &SyncSender<RpcEvent>, standing: &Arc<StandingAnswers>) {
    let clients = Arc::new(AtomicUsize::new(0));
    for (id, stream) in (1..).map(ConnectionId).zip(listener.incoming()) {
        let Ok(stream) = stream else { continue };
        if clients.fetch_add(1, Ordering::Relaxed) >= MOST_CLIENTS {
            clients.fetch_sub(1, Ordering::Relaxed);
            tracing::warn!("{MOST_CLIENTS} clients are connected: another one is turned away");
            continue;
        }
        let (events, standing, clients) = (events.clone(), Arc::clone(standing), Arc::clone(&clients));
        let spawned = thread::Builder::new().name(format!("client {}", id.0)).spawn(move || {
            if let Err(error) = serve(id, stream, &events, &standing) {
                tracing::info!(client = id.0, "a client's connection is closed: {error}");
            }
            clients.fetch_sub(1, Ordering::Relaxed);
            // Nobody listens any more when the server ends.
            let _ = events.send(RpcEvent::Gone(id));
        });
        if let Err(error) = spawned {
            tracing::warn!("no thread for a client: {error}");
        }
    }
}

/// Reads requests until the client goes or sends what is none.
fn serve(
    id: ConnectionId,
    stream: TcpStream,
    events: &SyncSender<RpcEvent>,
    standing: &StandingAnswers,
) -> Result<(), String> {
    let failed = |error: std::io::Error| error.to_string();
    stream.set_nodelay(true).map_err(failed)?;
    let mut reader = BufReader::new(EagerReader::new(stream.try_clone().map_err(failed)?));
    let (caller, queue) = Caller::new(id, stream);
    let name = format!("answers {}", id.0);
    let writer = thread::Builder::new().name(name).spawn(move || queue.write_all()).map_err(failed)?;
    let result = loop {
        let message = match read_value(&mut reader) {
            Ok(message) => message,
            Err(error) if error.is_end() => break Ok(()),
            Err(error) => break Err(error.to_string()),
        };
        let request = match Request::from_message(&message) {
            Ok(request) => request,
            Err(error) => break Err(error.to_string()),
        };
        let is_over = match standing.response(&request) {
            Some(response) => {
                // A TrafficManager that has asked for the settings goes on at once: nobody stands in its way (standing.rs).
                if request.method != "get_episode_settings" {
                    reader.get_mut().answered();
                }
                caller.send_now(&response).is_err()
            }
            None => events.send(RpcEvent::Call(caller.clone(), request)).is_err(),
        };
        if is_over {
            break Ok(());
        }
    };
    caller.close();
    drop(caller);
    // The answers that the client no longer reads end with its connection.
    let _ = writer.join();
    result
}
