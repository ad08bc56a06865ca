//! Streams that are listened to.

use super::connection::connect;
use super::error::ClientError;
use super::patience::{PatientReader, Wait};
use super::payload::{Payload, Spares};
use crate::stream::SensorHeader;
use crate::wire::Bytes;
use std::io::{self, BufReader, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::thread;

/// Messages that wait to be looked at; a server that sends more waits, too.
const MOST_WAITING: usize = 4;
/// A stream that was waited for so often in vain has nobody at its other end.
const HANGS: u32 = 4;
/// Longest message: a picture of 8192 × 8192.
const LONGEST: u32 = 300 << 20;

/// A stream.
pub(super) struct Subscription {
    stream: TcpStream,
    messages: Receiver<Result<StreamMessage, ClientError>>,
    /// Came before anybody asked for its frame.
    early: Option<StreamMessage>,
    /// How often in a row it was waited for in vain.
    waits_in_vain: u32,
}

/// A message of a stream.
pub(super) struct StreamMessage {
    pub(super) header: SensorHeader,
    /// What follows the header.
    pub(super) payload: Payload,
}

impl Subscription {
    /// Listens to the stream of a token on a host.
    pub(super) fn new(host: &str, token: &Bytes) -> Result<Self, ClientError> {
        let wrong = || ClientError::Protocol("a stream's token has 24 bytes".to_owned());
        let (id, rest) = token.0.split_first_chunk::<4>().ok_or_else(wrong)?;
        let (port, rest) = rest.split_first_chunk::<2>().ok_or_else(wrong)?;
        let kind = rest.get(1).ok_or_else(wrong)?;
        // An address of its own, unless it is that of nobody and everybody.
        let own = match (kind, rest.get(2..6)) {
            (1, Some(&[a, b, c, d])) if [a, b, c, d] != [0; 4] => Some(format!("{a}.{b}.{c}.{d}")),
            _ => None,
        };
        let mut stream = connect(own.as_deref().unwrap_or(host), u16::from_le_bytes(*port))?;
        stream.write_all(id).map_err(ClientError::Lost)?;
        let reader = BufReader::new(PatientReader::new(stream.try_clone().map_err(ClientError::Lost)?));
        let (sender, messages) = sync_channel(MOST_WAITING);
        thread::Builder::new()
            .name("stream".to_owned())
            .spawn(move || listen(reader, &sender))
            .map_err(ClientError::Lost)?;
        Ok(Self { stream, messages, early: None, waits_in_vain: 0 })
    }

    /// The next message.
    pub(super) fn next(&mut self, wait: &Wait) -> Result<StreamMessage, ClientError> {
        if let Some(early) = self.early.take() {
            return Ok(early);
        }
        loop {
            let piece = wait.piece().inspect_err(|_| self.waits_in_vain += 1);
            if self.waits_in_vain >= HANGS {
                return Err(ClientError::Lost(io::ErrorKind::TimedOut.into()));
            }
            match self.messages.recv_timeout(piece?) {
                Ok(message) => {
                    self.waits_in_vain = 0;
                    return message;
                }
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(ClientError::Lost(io::ErrorKind::UnexpectedEof.into()));
                }
            }
        }
    }

    /// The message of a frame, or `None` if one of a later frame came first. Those of earlier frames are passed over.
    pub(super) fn of_frame(&mut self, frame: u64, wait: &Wait) -> Result<Option<StreamMessage>, ClientError> {
        loop {
            let message = self.next(wait)?;
            if message.header.frame == frame {
                return Ok(Some(message));
            }
            if message.header.frame > frame {
                self.early = Some(message);
                return Ok(None);
            }
        }
    }
}

impl Drop for Subscription {
    fn drop(&mut self) {
        // It may be gone already.
        let _ = self.stream.shutdown(Shutdown::Both);
    }
}

fn listen(mut reader: BufReader<PatientReader>, messages: &SyncSender<Result<StreamMessage, ClientError>>) {
    let spares = Arc::default();
    loop {
        let message = read_message(&mut reader, &spares);
        let is_end = message.is_err();
        // Nobody may listen any more.
        if messages.send(message).is_err() || is_end {
            break;
        }
    }
}

fn read_message(reader: &mut impl Read, spares: &Arc<Spares>) -> Result<StreamMessage, ClientError> {
    let mut length = [0; 4];
    reader.read_exact(&mut length).map_err(ClientError::Lost)?;
    let length = u32::from_le_bytes(length);
    if length > LONGEST {
        return Err(ClientError::Protocol(format!("a message of a stream has {length} bytes")));
    }
    let mut header = [0; SensorHeader::SIZE];
    let short = || ClientError::Protocol(format!("a message of a stream has {length} bytes"));
    let rest = (length as usize).checked_sub(header.len()).ok_or_else(short)?;
    reader.read_exact(&mut header).map_err(ClientError::Lost)?;
    // Memory is taken for what arrives, not for what is announced.
    let mut bytes = spares.take();
    bytes.truncate(rest);
    reader.read_exact(&mut bytes).map_err(ClientError::Lost)?;
    reader.take((rest - bytes.len()) as u64).read_to_end(&mut bytes).map_err(ClientError::Lost)?;
    if bytes.len() < rest {
        return Err(ClientError::Lost(io::ErrorKind::UnexpectedEof.into()));
    }
    Ok(StreamMessage { header: SensorHeader::read(&header), payload: Payload::new(bytes, spares) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::Transform;
    use proptest::prelude::*;

    #[test]
    fn messages_are_read_as_they_are_written() {
        let mut transform = Transform::default();
        (transform.location.y, transform.rotation.yaw) = (-3.5, 12.25);
        let header = SensorHeader { type_id: 13, frame: 7, timestamp: 0.35, transform };
        let mut message = header.begin(3);
        message.extend([1, 2, 3]);
        let bytes = [&(message.len() as u32).to_le_bytes()[..], &message].concat();
        let spares = Arc::default();
        let read_one = |mut bytes: &[u8]| read_message(&mut bytes, &spares);
        // Into new memory, into what is left of a longer one and of a shorter one.
        for left in [0, 9, 2] {
            drop(Payload::new(vec![255; left], &spares));
            let read = read_one(&bytes).unwrap();
            assert_eq!((&read.header, &read.payload[..]), (&header, &[1, 2, 3][..]));
            let _not_for_the_next = spares.take();
        }
        assert!(matches!(read_one(&bytes[..20]), Err(ClientError::Lost(_))));
        assert!(matches!(read_one(&bytes[..bytes.len() - 1]), Err(ClientError::Lost(_))));
        assert!(matches!(read_one(&[255; 99]), Err(ClientError::Protocol(_))));
    }

    proptest! {
        #[test]
        fn any_bytes_are_a_message_or_an_error(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            let _ = read_message(&mut &bytes[..], &Arc::default());
        }
    }
}
