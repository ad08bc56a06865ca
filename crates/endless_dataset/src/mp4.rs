//! MP4 files of one H.264 track that play in browsers: index before data, one track, no edits.

mod boxes;
mod reader;
mod writer;

pub use reader::{Mp4Info, read_mp4};
pub use writer::Mp4Writer;

/// Ticks of the clock between two frames; the clock runs at `fps × 1000`, so that every usual rate is exact.
const TICKS_A_FRAME: u32 = 1000;

/// The NAL units of an Annex B access unit, without their start codes.
fn nal_units(access_unit: &[u8]) -> Vec<&[u8]> {
    let mut starts = Vec::new();
    let mut i = 0;
    while i + 3 <= access_unit.len() {
        if access_unit[i..i + 3] == [0, 0, 1] {
            starts.push(i + 3);
            i += 3;
        } else {
            i += 1;
        }
    }
    let ends = starts.iter().skip(1).map(|s| s - 3).chain([access_unit.len()]);
    starts
        .iter()
        .zip(ends)
        .map(|(&start, end)| {
            let unit = &access_unit[start..end];
            // A start code of four bytes leaves a zero at the end of the unit before it.
            let zeros = unit.iter().rev().take_while(|b| **b == 0).count();
            &unit[..unit.len() - zeros]
        })
        .filter(|unit| !unit.is_empty())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn start_codes_of_three_and_four_bytes() {
        let stream = [0, 0, 0, 1, 0x67, 1, 2, 0, 0, 1, 0x68, 3, 0, 0, 0, 1, 0x65, 4];
        assert_eq!(nal_units(&stream), [&[0x67, 1, 2][..], &[0x68, 3], &[0x65, 4]]);
        assert!(nal_units(&[]).is_empty());
    }
}
