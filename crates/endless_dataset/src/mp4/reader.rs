//! Reads the files of the writer.

use super::TICKS_A_FRAME;
use crate::DatasetError;
use endless_world::ImageSize;
use std::{fs, ops::Range, path::Path};

/// What an MP4 file holds.
#[derive(Debug, Clone)]
pub struct Mp4Info {
    /// Size of the pictures.
    pub size: ImageSize,
    timescale: u32,
    sps: Vec<u8>,
    pps: Vec<u8>,
    samples: Vec<Range<usize>>,
    bytes: Vec<u8>,
}

impl Mp4Info {
    /// How many pictures.
    pub fn samples(&self) -> usize {
        self.samples.len()
    }

    /// Pictures a second.
    pub fn fps(&self) -> f64 {
        f64::from(self.timescale) / f64::from(TICKS_A_FRAME)
    }

    /// One picture as an Annex B access unit that a decoder takes; the first brings the parameter sets. `None` if
    /// there are not so many or its bytes make no sense.
    pub fn access_unit(&self, index: usize) -> Option<Vec<u8>> {
        const START: [u8; 4] = [0, 0, 0, 1];
        let mut out = Vec::new();
        if index == 0 {
            out.extend([&START[..], &self.sps, &START, &self.pps].concat());
        }
        let mut rest = &self.bytes[self.samples.get(index)?.clone()];
        while !rest.is_empty() {
            let (length, after) = rest.split_first_chunk::<4>()?;
            let (unit, after) = after.split_at_checked(u32::from_be_bytes(*length) as usize)?;
            out.extend(START);
            out.extend(unit);
            rest = after;
        }
        Some(out)
    }
}

/// Reads a file.
///
/// # Errors
/// When it is missing, cut or not as the writer makes them.
pub fn read_mp4(path: &Path) -> Result<Mp4Info, DatasetError> {
    let bytes = fs::read(path).map_err(|e| DatasetError::io("cannot read", path, e))?;
    parse(bytes).ok_or_else(|| DatasetError::malformed(path, "is not a whole MP4 file of one H.264 track"))
}

fn parse(bytes: Vec<u8>) -> Option<Mp4Info> {
    let movie = child(&bytes, b"moov")?;
    let media = child(child(movie, b"trak")?, b"mdia")?;
    let timescale = word(child(media, b"mdhd")?, 12)?;
    let table = child(child(media, b"minf")?, b"stbl")?;
    let entry = child(child(table, b"stsd")?.get(8..)?, b"avc1")?;
    let size = ImageSize { width: word(entry, 22)? & 0xffff, height: word(entry, 24)? & 0xffff };
    let (sps, pps) = parameter_sets(child(entry.get(78..)?, b"avcC")?)?;
    let times = child(table, b"stts")?;
    let sizes = child(table, b"stsz")?;
    let count = word(sizes, 8)?;
    let offsets = child(table, b"stco")?;
    if word(times, 12)? != TICKS_A_FRAME || word(times, 8)? != count || word(offsets, 4)? != 1 {
        return None;
    }
    let mut start = word(offsets, 8)? as usize;
    let mut samples = Vec::new();
    for i in 0..count as usize {
        let end = start.checked_add(word(sizes, 12 + 4 * i)? as usize)?;
        samples.push(start..end);
        start = end;
    }
    (start <= bytes.len()).then_some(Mp4Info { size, timescale, sps, pps, samples, bytes })
}

fn parameter_sets(configuration: &[u8]) -> Option<(Vec<u8>, Vec<u8>)> {
    let sized = |at: usize| {
        let length = usize::from(u16::from_be_bytes(configuration.get(at..at + 2)?.try_into().ok()?));
        configuration.get(at + 2..at + 2 + length)
    };
    let sps = sized(6)?;
    let pps = sized(6 + 2 + sps.len() + 1)?;
    Some((sps.to_vec(), pps.to_vec()))
}

/// The contents of the first box of this kind.
fn child<'a>(mut boxes: &'a [u8], kind: &[u8; 4]) -> Option<&'a [u8]> {
    loop {
        let length = word(boxes, 0)? as usize;
        let (this, rest) = boxes.split_at_checked(length)?;
        if this.get(4..8)? == kind {
            return this.get(8..);
        }
        boxes = rest;
    }
}

fn word(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_be_bytes(bytes.get(at..at.checked_add(4)?)?.try_into().ok()?))
}
