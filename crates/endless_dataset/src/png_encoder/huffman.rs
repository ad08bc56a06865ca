//! Canonical Huffman codes of limited length (RFC 1951, section 3.2.2).

use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The code of a symbol: its bits, the first lowest, and how many.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Code {
    pub(super) bits: u16,
    pub(super) length: u8,
}

/// Codes for symbols that occur so often; those that do not occur have none. At least two must occur.
pub(super) fn codes<const N: usize>(counts: &[u32; N], longest: u8) -> [Code; N] {
    let mut counts = *counts;
    loop {
        let lengths = lengths(&counts);
        if lengths.iter().all(|length| *length <= longest) {
            return canonical(&lengths);
        }
        // Rare symbols less rare: their codes get shorter.
        counts = counts.map(|count| count.div_ceil(2) + u32::from(count > 0));
    }
}

/// Lengths of the codes of Huffman's tree.
fn lengths<const N: usize>(counts: &[u32; N]) -> [u8; N] {
    let mut waiting: BinaryHeap<Reverse<(u32, usize)>> =
        (0..N).filter(|&symbol| counts[symbol] > 0).map(|symbol| Reverse((counts[symbol], symbol))).collect();
    // Symbols first, then the nodes above them.
    let mut parents = vec![0usize; N];
    while let (Some(Reverse((one, a))), Some(Reverse((other, b)))) = (waiting.pop(), waiting.pop()) {
        let node = parents.len();
        parents.push(0);
        (parents[a], parents[b]) = (node, node);
        waiting.push(Reverse((one + other, node)));
        if waiting.len() == 1 {
            break;
        }
    }
    let mut depths = vec![0u8; parents.len()];
    for node in (N..parents.len().saturating_sub(1)).rev() {
        depths[node] = depths[parents[node]] + 1;
    }
    std::array::from_fn(|symbol| if counts[symbol] > 0 { depths[parents[symbol]] + 1 } else { 0 })
}

/// The codes that these lengths name.
fn canonical<const N: usize>(lengths: &[u8; N]) -> [Code; N] {
    let mut next = [0u16; 17];
    for length in 1..16u8 {
        let count = lengths.iter().filter(|l| **l == length).count() as u16;
        next[usize::from(length) + 1] = (next[usize::from(length)] + count) << 1;
    }
    lengths.map(|length| {
        if length == 0 {
            return Code::default();
        }
        let code = next[usize::from(length)];
        next[usize::from(length)] += 1;
        Code { bits: code.reverse_bits() >> (16 - length), length }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_those_of_the_rfc() {
        // The example of section 3.2.2: lengths 3, 3, 3, 3, 3, 2, 4, 4.
        let codes = canonical(&[3, 3, 3, 3, 3, 2, 4, 4]);
        let read = codes.map(|Code { bits, length }| bits.reverse_bits() >> (16 - length));
        assert_eq!(read, [0b010, 0b011, 0b100, 0b101, 0b110, 0b00, 0b1110, 0b1111]);
    }

    #[test]
    fn no_code_is_longer_than_allowed_and_none_is_left() {
        // Fibonacci's numbers make the deepest trees.
        let (mut a, mut b) = (1u32, 1);
        let counts: [u32; 30] = std::array::from_fn(|_| {
            (a, b) = (b, a + b);
            a
        });
        for longest in [5, 7, 15] {
            let codes = codes(&counts, longest);
            assert!(codes.iter().all(|code| (1..=longest).contains(&code.length)));
            let share: f64 = codes.iter().map(|code| 0.5f64.powi(i32::from(code.length))).sum();
            assert_eq!(share, 1.0);
        }
    }
}
