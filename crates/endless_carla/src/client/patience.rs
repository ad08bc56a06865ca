//! How long is waited, and for whom not.

use super::error::ClientError;
use std::io::{self, Read};
use std::net::TcpStream;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// How often a wait looks whether the user wants to stop.
const LOOK: Duration = Duration::from_millis(100);

/// Set when the user wants to stop.
#[derive(Debug, Clone, Default)]
pub struct StopFlag {
    is_set: Arc<AtomicBool>,
    /// While it is cleaned up, waits go on.
    is_cleaning: Arc<AtomicBool>,
}

impl StopFlag {
    /// From now on every wait ends.
    pub fn stop(&self) {
        self.is_set.store(true, Ordering::Relaxed);
    }

    /// Whether the user wants to stop.
    pub fn is_set(&self) -> bool {
        self.is_set.load(Ordering::Relaxed)
    }

    /// Does something for which it is waited even then: cleaning up.
    pub(super) fn pause<R>(&self, act: impl FnOnce() -> R) -> R {
        self.is_cleaning.store(true, Ordering::Relaxed);
        let done = act();
        self.is_cleaning.store(false, Ordering::Relaxed);
        done
    }

    /// # Errors
    /// When the user wants to stop.
    pub(super) fn check(&self) -> Result<(), ClientError> {
        if self.is_set() && !self.is_cleaning.load(Ordering::Relaxed) { Err(ClientError::Interrupted) } else { Ok(()) }
    }
}

/// A wait for something.
#[derive(Debug, Clone)]
pub(super) struct Wait {
    action: &'static str,
    limit: Duration,
    until: Instant,
    stop: StopFlag,
}

impl Wait {
    /// For an action, as in "load the map".
    pub(super) fn new(action: &'static str, limit: Duration, stop: &StopFlag) -> Self {
        Self { action, limit, until: Instant::now() + limit, stop: stop.clone() }
    }

    /// For the rest of what has begun to come, even when the user wants to stop: who stopped in the middle of it would take the rest
    /// for something new.
    pub(super) fn to_the_end(&self) -> Self {
        Self { stop: StopFlag::default(), ..self.clone() }
    }

    /// How long the next piece of waiting may be.
    ///
    /// # Errors
    /// When it has been waited long enough, or the user wants to stop.
    pub(super) fn piece(&self) -> Result<Duration, ClientError> {
        self.stop.check()?;
        let left = self.until.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return Err(ClientError::Late { action: self.action, limit: self.limit });
        }
        Ok(left.min(LOOK))
    }

    /// Sleeps before it is looked again; at most a tenth of a second.
    pub(super) fn sleep(&self, time: Duration) -> Result<(), ClientError> {
        std::thread::sleep(self.piece()?.min(time));
        Ok(())
    }
}

/// Reads from a connection as long as a wait lasts.
pub(super) struct PatientReader {
    stream: TcpStream,
    /// For ever, if there is none.
    pub(super) wait: Option<Wait>,
    /// Why reading ended, if not by the connection.
    ended: Option<ClientError>,
    /// As the connection has it.
    timeout: Option<Duration>,
}

impl PatientReader {
    pub(super) fn new(stream: TcpStream) -> Self {
        Self { stream, wait: None, ended: None, timeout: None }
    }

    /// Why reading ended: by itself, or by an error of the connection.
    pub(super) fn reason(&mut self, otherwise: impl Into<ClientError>) -> ClientError {
        self.ended.take().unwrap_or_else(|| otherwise.into())
    }
}

impl Read for PatientReader {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        loop {
            let piece = match self.wait.as_ref().map(Wait::piece).transpose() {
                Ok(piece) => piece,
                Err(error) => {
                    self.ended = Some(error);
                    return Err(io::ErrorKind::TimedOut.into());
                }
            };
            if self.timeout != piece {
                self.stream.set_read_timeout(piece)?;
                self.timeout = piece;
            }
            match self.stream.read(buffer) {
                Err(error) if matches!(error.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut) => {}
                other => return other,
            }
        }
    }
}
