//! Deflate (RFC 1951) of a piece of data by itself: one block with Huffman codes of its own, in which runs of one byte are
//! all that is matched. Filtered rows hold little else that repeats, and looking for it takes ten times as long.

use super::huffman::{Code, codes};
use std::ops::Range;

/// An empty block, the last of a stream.
pub(super) const END: [u8; 2] = [0x03, 0x00];

const END_OF_BLOCK: usize = 256;
/// Literals, the end of the block, and lengths.
const SYMBOLS: usize = 286;
/// Runs of one byte, as they are looked for: each of at least four more has a byte at every fourth place.
const STRIDE: usize = 4;
const LONGEST_RUN: usize = 258;
/// So short that codes of four literals fit into a word with what is left of the last byte.
const LONGEST_CODE: u8 = 14;

/// What is needed in between, kept for the next piece.
#[derive(Debug, Default)]
pub(super) struct Buffers {
    /// Bytes that are as the one before them: where they begin and end.
    runs: Vec<Range<usize>>,
}

impl Buffers {
    /// Appends data as whole bytes, after which another piece or [`END`] may follow.
    pub(super) fn compress(&mut self, data: &[u8], out: &mut Vec<u8>) {
        let start = out.len();
        let counts = self.find_runs(data);
        let codes = codes(&counts, LONGEST_CODE);
        let mut bits = BitWriter::new(out, 512 + 2 * data.len());
        // Not the last block, codes of its own.
        bits.push(0b100, 3);
        push_code_lengths(&codes, &mut bits);
        let mut done = 0;
        for run in &self.runs {
            push_literals(&data[done..run.start], &codes, &mut bits);
            let Length { symbol, extra, extra_bits } = Length::of(run.len());
            bits.push_code(codes[symbol]);
            // Then the distance: of the only code, one byte back.
            bits.push(u32::from(extra), extra_bits + 1);
            done = run.end;
        }
        push_literals(&data[done..], &codes, &mut bits);
        bits.push_code(codes[END_OF_BLOCK]);
        // An empty stored block ends on a whole byte.
        bits.push(0, 3);
        bits.finish();
        out.extend([0, 0, 0xff, 0xff]);
        if out.len() - start > stored_length(data.len()) {
            out.truncate(start);
            store(data, out);
        }
    }

    /// Finds the runs, and counts the symbols.
    fn find_runs(&mut self, data: &[u8]) -> [u32; SYMBOLS] {
        self.runs.clear();
        // Four counts of each literal: the processor need not wait for one before it adds to the next.
        let mut literals = [[0u32; 256]; STRIDE];
        let mut count_literals = |data: &[u8]| {
            let (fours, rest) = data.as_chunks::<STRIDE>();
            for four in fours {
                for (counts, byte) in literals.iter_mut().zip(four) {
                    counts[usize::from(*byte)] += 1;
                }
            }
            for byte in rest {
                literals[0][usize::from(*byte)] += 1;
            }
        };
        let mut lengths = [0u32; SYMBOLS - END_OF_BLOCK];
        lengths[0] = 1;
        let (mut at, mut done) = (STRIDE, 0);
        while let Some(four) = data.get(at - 2..).and_then(|rest| rest.first_chunk()) {
            // Each byte with the next: two that follow each other must be alike, and the middle ones at that.
            let four = u32::from_le_bytes(*four);
            let unlike = four ^ four >> 8;
            if (unlike & 0xffff).min(unlike & 0x00ff_ff00) != 0 {
                at += STRIDE;
                continue;
            }
            let byte = data[at];
            // The first is a literal; nothing before `done` can be taken again.
            let first =
                data[done..at].iter().rposition(|other| *other != byte).map_or(done, |other| done + other + 1) + 1;
            let end = data[at..].iter().position(|other| *other != byte).map_or(data.len(), |other| at + other);
            let mut begin = first;
            while end - begin >= STRIDE {
                let run = begin..end.min(begin + LONGEST_RUN);
                count_literals(&data[done..run.start]);
                lengths[Length::of(run.len()).symbol - END_OF_BLOCK] += 1;
                (begin, done) = (run.end, run.end);
                self.runs.push(run);
            }
            at = (end + 1).next_multiple_of(STRIDE);
        }
        count_literals(&data[done..]);
        std::array::from_fn(|symbol| match symbol.checked_sub(END_OF_BLOCK) {
            Some(length) => lengths[length],
            None => literals.iter().map(|counts| counts[symbol]).sum(),
        })
    }
}

fn push_literals(data: &[u8], codes: &[Code; SYMBOLS], bits: &mut BitWriter<'_>) {
    let (fours, rest) = data.as_chunks::<STRIDE>();
    for four in fours {
        let (mut word, mut count) = (0u64, 0);
        for byte in four {
            let code = codes[usize::from(*byte)];
            word |= u64::from(code.bits) << count;
            count += code.length;
        }
        bits.push_word(word, count);
    }
    for byte in rest {
        bits.push_code(codes[usize::from(*byte)]);
    }
}

/// How the length of a run is told (section 3.2.5).
#[derive(Clone, Copy)]
struct Length {
    symbol: usize,
    extra: u16,
    extra_bits: u8,
}

impl Length {
    fn of(run: usize) -> Self {
        if run == LONGEST_RUN {
            return Self { symbol: 285, extra: 0, extra_bits: 0 };
        }
        let from_three = run as u16 - 3;
        if from_three < 8 {
            return Self { symbol: 257 + usize::from(from_three), extra: 0, extra_bits: 0 };
        }
        // Four symbols for each doubling.
        let extra_bits = from_three.ilog2() as u8 - 2;
        let symbol = 257 + 4 * usize::from(extra_bits) + usize::from(from_three >> extra_bits);
        Self { symbol, extra: from_three & ((1 << extra_bits) - 1), extra_bits }
    }
}

/// Writes the lengths of the codes of symbols, and of the only distance (section 3.2.7).
fn push_code_lengths(codes: &[Code; SYMBOLS], bits: &mut BitWriter<'_>) {
    const ORDER: [usize; 19] = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];
    let lengths: Vec<u8> = codes.iter().map(|code| code.length).chain([1]).collect();
    // Symbol, what follows it, and in how many bits.
    let mut told: Vec<(usize, u32, u8)> = Vec::new();
    for same in lengths.chunk_by(|a, b| a == b) {
        let (length, mut left) = (usize::from(same[0]), same.len() as u32);
        if length > 0 {
            told.push((length, 0, 0));
            left -= 1;
        }
        while left > 0 {
            let (told_now, count) = match (length, left) {
                (_, 1..=2) => ((length, 0, 0), 1),
                (0, 3..=10) => ((17, left - 3, 3), left),
                (0, _) => ((18, left.min(138) - 11, 7), left.min(138)),
                _ => ((16, left.min(6) - 3, 2), left.min(6)),
            };
            told.push(told_now);
            left -= count;
        }
    }
    let mut counts = [0u32; 19];
    // A code of one symbol is none.
    (counts[0], counts[18]) = (1, 1);
    for (symbol, ..) in &told {
        counts[*symbol] += 1;
    }
    let length_codes = self::codes(&counts, 7);
    let count = ORDER.iter().rposition(|symbol| length_codes[*symbol].length > 0).map_or(4, |last| (last + 1).max(4));
    bits.push((SYMBOLS - 257) as u32, 5);
    bits.push(0, 5);
    bits.push(count as u32 - 4, 4);
    for symbol in &ORDER[..count] {
        bits.push(u32::from(length_codes[*symbol].length), 3);
    }
    for (symbol, extra, extra_bits) in told {
        bits.push_code(length_codes[symbol]);
        bits.push(extra, extra_bits);
    }
}

const LONGEST_STORED: usize = 65_535;

fn stored_length(data: usize) -> usize {
    data + 5 * data.div_ceil(LONGEST_STORED)
}

/// Blocks of data as it is (section 3.2.4).
fn store(data: &[u8], out: &mut Vec<u8>) {
    for part in data.chunks(LONGEST_STORED) {
        let length = part.len() as u16;
        out.push(0);
        out.extend(length.to_le_bytes());
        out.extend((!length).to_le_bytes());
        out.extend(part);
    }
}

/// Appends bits, the lowest first.
struct BitWriter<'a> {
    out: &'a mut Vec<u8>,
    /// Bytes of `out` that are whole.
    end: usize,
    /// Fewer than eight between calls.
    bits: u64,
    count: u8,
}

impl<'a> BitWriter<'a> {
    /// With room for so many bytes.
    fn new(out: &'a mut Vec<u8>, room: usize) -> Self {
        let end = out.len();
        out.resize(end + room + size_of::<u64>(), 0);
        Self { out, end, bits: 0, count: 0 }
    }

    fn push_code(&mut self, code: Code) {
        self.push(u32::from(code.bits), code.length);
    }

    fn push(&mut self, bits: u32, count: u8) {
        self.push_word(u64::from(bits), count);
    }

    /// At most 56 bits.
    #[inline]
    fn push_word(&mut self, word: u64, count: u8) {
        self.bits |= word << self.count;
        self.count += count;
        self.out[self.end..self.end + size_of::<u64>()].copy_from_slice(&self.bits.to_le_bytes());
        let whole = self.count / 8;
        self.end += usize::from(whole);
        self.bits = self.bits.checked_shr(u32::from(8 * whole)).unwrap_or(0);
        self.count %= 8;
    }

    /// Ends on a whole byte, and gives back the room that was not needed.
    fn finish(self) {
        self.out.truncate(self.end + usize::from(self.count > 0));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_told_as_the_rfc_tells_them() {
        for (run, symbol, extra, bits) in [
            (4, 258, 0, 0),
            (10, 264, 0, 0),
            (11, 265, 0, 1),
            (12, 265, 1, 1),
            (18, 268, 1, 1),
            (19, 269, 0, 2),
            (130, 280, 15, 4),
            (131, 281, 0, 5),
            (257, 284, 30, 5),
            (258, 285, 0, 0),
        ] {
            let length = Length::of(run);
            assert_eq!((length.symbol, length.extra, length.extra_bits), (symbol, extra, bits), "{run}");
        }
    }

    #[test]
    fn noise_grows_by_five_bytes() {
        let noise: Vec<u8> =
            (0..5000u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 11) as u8 ^ (i >> 3) as u8).collect();
        let mut out = Vec::new();
        Buffers::default().compress(&noise, &mut out);
        assert!(out.len() <= noise.len() + 5, "{}", out.len());
    }

    #[test]
    fn one_byte_repeated_takes_next_to_nothing() {
        let mut out = Vec::new();
        Buffers::default().compress(&[0; 61_456], &mut out);
        assert!(out.len() < 150, "{}", out.len());
    }
}
