//! Reads from a client that may ask again at once: who sleeps meanwhile is woken too late.

use std::io::{self, ErrorKind, Read};
use std::net::TcpStream;
use std::thread;
use std::time::{Duration, Instant};

/// For how long the next request is looked for without sleeping: about as long as it takes to be woken.
const LOOK: Duration = Duration::from_micros(60);
/// After a look in vain, so many answers are not followed by another: a client that takes its time costs nothing.
const PAUSE: u32 = 64;

/// A client's stream.
pub(super) struct EagerReader {
    stream: TcpStream,
    /// The client was answered just now.
    is_answered: bool,
    /// Answers until it is looked again.
    pause: u32,
}

impl EagerReader {
    pub(super) fn new(stream: TcpStream) -> Self {
        Self { stream, is_answered: false, pause: 0 }
    }

    /// The client was answered: it may ask again.
    pub(super) fn answered(&mut self) {
        self.is_answered = self.pause == 0;
        self.pause = self.pause.saturating_sub(1);
    }

    /// What comes soon; `None` where nothing does.
    fn look(&mut self, buffer: &mut [u8]) -> Option<io::Result<usize>> {
        let until = Instant::now() + LOOK;
        loop {
            match now(&self.stream, buffer) {
                Err(error) if error.kind() == ErrorKind::WouldBlock => {}
                come => return Some(come),
            }
            if Instant::now() > until {
                self.pause = PAUSE;
                return None;
            }
            // Others may need this processor, the client too.
            thread::yield_now();
        }
    }
}

impl Read for EagerReader {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let come = if std::mem::take(&mut self.is_answered) { self.look(buffer) } else { None };
        come.unwrap_or_else(|| self.stream.read(buffer))
    }
}

/// What has come already.
#[cfg(unix)]
fn now(stream: &TcpStream, buffer: &mut [u8]) -> io::Result<usize> {
    let (read, _) = rustix::net::recv(stream, buffer, rustix::net::RecvFlags::DONTWAIT)?;
    Ok(read)
}

/// Without such a call nobody looks.
#[cfg(not(unix))]
fn now(stream: &TcpStream, buffer: &mut [u8]) -> io::Result<usize> {
    (&*stream).read(buffer)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write as _;
    use std::net::TcpListener;

    #[test]
    fn all_is_read_at_once_and_later_and_looks_in_vain_are_few() {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let client = TcpStream::connect(listener.local_addr().unwrap()).unwrap();
        let mut reader = EagerReader::new(listener.accept().unwrap().0);
        let (mut byte, mut looks, mut in_vain) = ([0], 0, 0);
        for number in 0..240 {
            let is_late = number % 16 == 15;
            let mut other = client.try_clone().unwrap();
            let mut write = move || other.write_all(&[number]).unwrap();
            let later = if is_late {
                Some(thread::spawn(move || {
                    thread::sleep(50 * LOOK);
                    write();
                }))
            } else {
                write();
                None
            };
            looks += u32::from(reader.is_answered);
            assert_eq!((reader.read(&mut byte).unwrap(), byte), (1, [number]));
            // On a busy machine a look may last so long that even what is late comes meanwhile.
            let was_in_vain = reader.pause == PAUSE;
            assert!(is_late || !was_in_vain, "{number} had come");
            in_vain += u32::from(was_in_vain);
            later.into_iter().for_each(|thread| thread.join().unwrap());
            reader.answered();
        }
        // Of the late ones each is looked for that comes when none was looked for in vain lately.
        assert!(looks > in_vain && (1..=4).contains(&in_vain), "{looks} looks, {in_vain} of them in vain");
        drop(client);
        assert_eq!(reader.read(&mut byte).unwrap(), 0);
    }
}
