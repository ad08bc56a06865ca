//! The index of an MP4 file (ISO/IEC 14496-12 and -15).

use super::TICKS_A_FRAME;
use endless_world::ImageSize;

/// What the index must know of the track.
pub(super) struct Track<'a> {
    pub(super) size: ImageSize,
    pub(super) fps: f64,
    pub(super) sps: &'a [u8],
    pub(super) pps: &'a [u8],
    pub(super) sample_sizes: &'a [u32],
    /// Numbers of the key frames, from 1.
    pub(super) key_samples: &'a [u32],
}

/// A box: its size, its four letters, its contents.
fn boxed(kind: &[u8; 4], contents: &[&[u8]]) -> Vec<u8> {
    let length = 8 + contents.iter().map(|c| c.len()).sum::<usize>();
    let mut out = Vec::with_capacity(length);
    out.extend((length as u32).to_be_bytes());
    out.extend(kind);
    for part in contents {
        out.extend(*part);
    }
    out
}

/// A box with version 0 and flags.
fn full(kind: &[u8; 4], flags: u32, contents: &[&[u8]]) -> Vec<u8> {
    let head = flags.to_be_bytes();
    let mut parts = vec![&head[..]];
    parts.extend(contents);
    boxed(kind, &parts)
}

fn words(values: &[u32]) -> Vec<u8> {
    values.iter().flat_map(|v| v.to_be_bytes()).collect()
}

/// The transform that leaves the picture as it is.
const IDENTITY: [u32; 9] = [0x1_0000, 0, 0, 0, 0x1_0000, 0, 0, 0, 0x4000_0000];

pub(super) fn file_type() -> Vec<u8> {
    boxed(b"ftyp", &[b"isom", &words(&[0x200]), b"isomiso2avc1mp41"])
}

/// The head of the data box; its size needs 64 bits in long videos.
pub(super) fn data_head(length: u64) -> Vec<u8> {
    match u32::try_from(length + 8) {
        Ok(short) => [&short.to_be_bytes()[..], b"mdat"].concat(),
        Err(_too_long) => [&1u32.to_be_bytes()[..], b"mdat", &(length + 16).to_be_bytes()].concat(),
    }
}

/// The index; `data_offset` is where the first sample lies in the file.
pub(super) fn movie(track: &Track<'_>, data_offset: u32) -> Vec<u8> {
    let timescale = timescale(track.fps);
    let duration = track.sample_sizes.len() as u32 * TICKS_A_FRAME;
    let matrix = words(&IDENTITY);
    let movie_header = full(
        b"mvhd",
        0,
        &[&words(&[0, 0, timescale, duration, 0x1_0000, 0x0100_0000, 0, 0]), &matrix, &words(&[0; 6]), &words(&[2])],
    );
    let size = [track.size.width << 16, track.size.height << 16];
    let track_header = full(b"tkhd", 3, &[&words(&[0, 0, 1, 0, duration, 0, 0, 0, 0]), &matrix, &words(&size)]);
    // Language "und", five bits a letter.
    let media_header = full(b"mdhd", 0, &[&words(&[0, 0, timescale, duration, 0x55c4_0000])]);
    let handler = full(b"hdlr", 0, &[&words(&[0]), b"vide", &words(&[0; 3]), b"endless\0"]);
    let data_here = full(b"url ", 1, &[]);
    let references = full(b"dref", 0, &[&words(&[1]), &data_here]);
    let media_information = boxed(
        b"minf",
        &[&full(b"vmhd", 1, &[&words(&[0, 0])]), &boxed(b"dinf", &[&references]), &sample_table(track, data_offset)],
    );
    let media = boxed(b"mdia", &[&media_header, &handler, &media_information]);
    boxed(b"moov", &[&movie_header, &boxed(b"trak", &[&track_header, &media])])
}

pub(super) fn timescale(fps: f64) -> u32 {
    (fps * f64::from(TICKS_A_FRAME)).round().max(1.0) as u32
}

fn sample_table(track: &Track<'_>, data_offset: u32) -> Vec<u8> {
    let count = track.sample_sizes.len() as u32;
    boxed(
        b"stbl",
        &[
            &full(b"stsd", 0, &[&words(&[1]), &sample_entry(track)]),
            &full(b"stts", 0, &[&words(&[1, count, TICKS_A_FRAME])]),
            &full(b"stss", 0, &[&words(&[track.key_samples.len() as u32]), &words(track.key_samples)]),
            // All samples in one chunk.
            &full(b"stsc", 0, &[&words(&[1, 1, count, 1])]),
            &full(b"stsz", 0, &[&words(&[0, count]), &words(track.sample_sizes)]),
            &full(b"stco", 0, &[&words(&[1, data_offset])]),
        ],
    )
}

fn sample_entry(track: &Track<'_>) -> Vec<u8> {
    let length_of = |unit: &[u8]| (unit.len() as u16).to_be_bytes();
    let configuration = boxed(
        b"avcC",
        &[
            // Version, then profile, compatibility and level as in the parameter set; lengths of four bytes.
            &[1, track.sps[1], track.sps[2], track.sps[3], 0xff, 0xe1],
            &length_of(track.sps),
            track.sps,
            &[1],
            &length_of(track.pps),
            track.pps,
        ],
    );
    // BT.709, studio range.
    let colour = boxed(b"colr", &[b"nclx", &[0, 1, 0, 1, 0, 1, 0]]);
    let [_, _, w1, w0] = track.size.width.to_be_bytes();
    let [_, _, h1, h0] = track.size.height.to_be_bytes();
    boxed(
        b"avc1",
        &[
            &[0, 0, 0, 0, 0, 0, 0, 1],
            &[0; 16],
            &[w1, w0, h1, h0],
            // 72 dpi, one frame a sample, no compressor's name, 24 bit.
            &words(&[0x48_0000, 0x48_0000, 0]),
            &[0, 1],
            &[0; 32],
            &[0, 0x18, 0xff, 0xff],
            &configuration,
            &colour,
        ],
    )
}
