//! Reads a recording packet by packet.

use super::bytes::{RecordingError, Stored};
use super::packet::Packet;
use std::io::{self, Read, Seek, SeekFrom};

const MAGIC: &str = "CARLA_RECORDER";
const VERSION: u16 = 1;
/// Largest packet, bytes: ten thousand actors that come at once have a few million.
const LARGEST: u32 = 256 << 20;

/// The beginning of a recording.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LogHeader {
    /// Of the format.
    pub version: u16,
    /// When it began, seconds of Unix.
    pub date_s: i64,
    /// Name of the map.
    pub map: String,
}

impl LogHeader {
    /// Of a map, at a time.
    pub fn new(map: &str, date_s: i64) -> Self {
        Self { version: VERSION, date_s, map: map.to_owned() }
    }

    /// Appends it to a file's bytes.
    pub fn write(&self, out: &mut Vec<u8>) {
        self.version.write(out);
        MAGIC.to_owned().write(out);
        self.date_s.write(out);
        self.map.write(out);
    }
}

/// Whether a file that begins so is a recording.
pub fn is_recording(begin: &[u8]) -> bool {
    begin.get(4..).is_some_and(|rest| rest.starts_with(MAGIC.as_bytes()))
}

/// Reads a recording packet by packet. One whose end is missing ends with its last whole packet.
#[derive(Debug)]
pub struct LogReader<R> {
    reader: R,
    header: LogHeader,
}

impl<R: Read + Seek> LogReader<R> {
    /// Reads the beginning.
    ///
    /// # Errors
    /// When it is no recording's.
    pub fn new(mut reader: R) -> Result<Self, RecordingError> {
        let version = u16::from_le_bytes(exactly(&mut reader)?);
        if text(&mut reader)? != MAGIC.as_bytes() {
            return Err(RecordingError::NoRecording);
        }
        let date_s = i64::from_le_bytes(exactly(&mut reader)?);
        let map = String::from_utf8_lossy(&text(&mut reader)?).into_owned();
        Ok(Self { reader, header: LogHeader { version, date_s, map } })
    }

    /// The beginning.
    pub fn header(&self) -> &LogHeader {
        &self.header
    }

    /// The next packet; none at the end.
    ///
    /// # Errors
    /// When it cannot be read.
    pub fn packet(&mut self) -> Result<Option<Packet>, RecordingError> {
        let Some((number, size)) = self.packet_header()? else { return Ok(None) };
        let mut bytes = Vec::new();
        let read = (&mut self.reader).take(size.into()).read_to_end(&mut bytes)?;
        if read < size as usize {
            return Ok(None);
        }
        Packet::read(number, &bytes).map(Some)
    }

    /// When the last frame begins, seconds after the first one. The reader is then where it was.
    ///
    /// # Errors
    /// When the file cannot be read.
    pub fn total_s(&mut self) -> Result<f64, RecordingError> {
        let at = self.reader.stream_position()?;
        let mut last_s = 0.0;
        while let Some((number, size)) = self.packet_header()? {
            if number != 0 {
                self.reader.seek(SeekFrom::Current(size.into()))?;
                continue;
            }
            let mut bytes = Vec::new();
            (&mut self.reader).take(size.into()).read_to_end(&mut bytes)?;
            match Packet::read(number, &bytes) {
                Ok(Packet::FrameStart(start)) => last_s = start.elapsed_s,
                _ => break,
            }
        }
        self.reader.seek(SeekFrom::Start(at))?;
        Ok(last_s)
    }

    fn packet_header(&mut self) -> Result<Option<(u8, u32)>, RecordingError> {
        let mut head = [0; 5];
        match self.reader.read_exact(&mut head) {
            Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => return Ok(None),
            other => other?,
        }
        let [number, size @ ..] = head;
        let size = u32::from_le_bytes(size);
        if size > LARGEST { Err(RecordingError::Packet(size)) } else { Ok(Some((number, size))) }
    }
}

fn exactly<const N: usize>(reader: &mut impl Read) -> Result<[u8; N], RecordingError> {
    let mut bytes = [0; N];
    match reader.read_exact(&mut bytes) {
        Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => Err(RecordingError::NoRecording),
        other => Ok(other.map(|()| bytes)?),
    }
}

fn text(reader: &mut impl Read) -> Result<Vec<u8>, RecordingError> {
    let length = u16::from_le_bytes(exactly(reader)?);
    let mut bytes = Vec::new();
    let read = reader.take(length.into()).read_to_end(&mut bytes)?;
    if read < usize::from(length) { Err(RecordingError::NoRecording) } else { Ok(bytes) }
}
