//! Changing files at random, so that much of them still makes sense.

use endless_world::Stream;

const VALUES: &[&str] = &[
    "",
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "-2",
    "3",
    "7",
    "1e-9",
    "-1e-7",
    "0.001",
    "0.3",
    "-0.25",
    "0.5",
    "1.5",
    "3.5",
    "12",
    "40",
    "100",
    "-100",
    "999",
    "1000",
    "1e5",
    "1e7",
    "-1e7",
    "1e308",
    "nan",
    "inf",
    "-inf",
    "3.14159265",
    "6.2831853",
    "1.5707963",
    "90",
    "180",
    "-180.0000001",
    "2147483648",
    "-2147483649",
    "9223372036854775807",
    "18446744073709551616",
    "yes",
    "no",
    "true",
    "start",
    "end",
    "both",
    "+",
    "-",
    "none",
    "road",
    "junction",
    "driving",
    "sidewalk",
    "bidirectional",
    "solid",
    "broken",
    "residential",
    "motorway",
    "footway",
    "roundabout",
    "traffic_signals",
    "crosswalk",
    "left|right",
    "left;through|;|right||",
    "virtual",
    "direct",
    "crossing",
    "normalized",
    "arcLength",
    "\u{fffd}",
    "&#0;",
    "&bad;",
    "<",
    "50 mph",
    "m/s",
    "km/h",
    "-1;2;nan",
    "1'2\"",
    "multipolygon",
    "restriction",
    "no_left_turn",
    "outer",
    "inner",
];

/// A text changed in a few places: values, lines, bytes.
pub(crate) fn text(file: &[u8], stream: &mut Stream) -> Vec<u8> {
    let mut file = file.to_vec();
    for _ in 0..1 + stream.below(6) {
        match stream.below(20) {
            0..=5 => value(&mut file, stream),
            6..=9 => nudge(&mut file, stream),
            10..=12 => swap_values(&mut file, stream),
            13..=16 => lines(&mut file, stream),
            17 => bytes(&mut file, stream),
            18 => truncate(&mut file, stream),
            _ => repeat(&mut file, stream),
        }
    }
    file
}

/// Bytes alone.
pub(crate) fn binary(file: &[u8], stream: &mut Stream) -> Vec<u8> {
    let mut file = file.to_vec();
    for _ in 0..1 + stream.below(5) {
        match stream.below(8) {
            0..=4 => bytes(&mut file, stream),
            5 => truncate(&mut file, stream),
            6 => repeat(&mut file, stream),
            _ => {
                if !file.is_empty() {
                    // The longest varint and lengths that are not there.
                    let at = stream.below(file.len());
                    let n = 1 + stream.below(10);
                    file.splice(at..at, std::iter::repeat_n(0xff, n));
                }
            }
        }
    }
    file
}

/// The ranges of bytes between quotation marks, and of numbers outside of them.
fn values(file: &[u8]) -> Vec<(usize, usize)> {
    let is_number = |byte: &u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'+' | b'e' | b'E');
    let mut found = Vec::new();
    let mut at = 0;
    while at < file.len() {
        let before = at.checked_sub(1).map(|k| file[k]);
        let to = match file[at] {
            quote @ (b'"' | b'\'') => {
                file[at + 1..].iter().position(|byte| *byte == quote).map(|n| (at + 1, at + 1 + n))
            }
            b'0'..=b'9' | b'-' if before.is_none_or(|byte| !byte.is_ascii_alphanumeric()) => {
                Some((at, at + 1 + file[at + 1..].iter().take_while(|byte| is_number(byte)).count()))
            }
            _ => None,
        };
        found.extend(to);
        at = to.map_or(at, |(_, to)| to) + 1;
    }
    found
}

fn value(file: &mut Vec<u8>, stream: &mut Stream) {
    let places = values(file);
    if !places.is_empty() {
        let (from, to) = *stream.pick(&places);
        file.splice(from..to, stream.pick(VALUES).bytes());
    }
}

/// A number made a little or much larger or smaller.
fn nudge(file: &mut Vec<u8>, stream: &mut Stream) {
    let number = |range: &(usize, usize)| std::str::from_utf8(&file[range.0..range.1]).ok()?.parse::<f64>().ok();
    let places: Vec<((usize, usize), f64)> =
        values(file).into_iter().filter_map(|range| Some((range, number(&range)?))).collect();
    if places.is_empty() {
        return;
    }
    let &((from, to), old) = stream.pick(&places);
    let new = match stream.below(6) {
        0 => -old,
        1 => old + stream.range_f64(-1.0, 1.0),
        2 => old * stream.range_f64(0.0, 3.0),
        3 => old + stream.range_f64(-1e-3, 1e-3),
        4 => old.round() + 1.0,
        _ => stream.range_f64(-60.0, 60.0),
    };
    file.splice(from..to, format!("{new}").into_bytes());
}

fn swap_values(file: &mut Vec<u8>, stream: &mut Stream) {
    let places = values(file);
    if places.len() > 1 {
        let (a, b) = (*stream.pick(&places), *stream.pick(&places));
        let taken = file[b.0..b.1].to_vec();
        file.splice(a.0..a.1, taken);
    }
}

/// Lines dropped, doubled or moved.
fn lines(file: &mut Vec<u8>, stream: &mut Stream) {
    let starts = |file: &[u8]| -> Vec<usize> {
        let ends = file.iter().enumerate().filter(|(_, byte)| **byte == b'\n').map(|(at, _)| at + 1);
        std::iter::once(0).chain(ends).collect()
    };
    let own = starts(file);
    let first = stream.below(own.len());
    let last = (first + 1 + stream.below(8)).min(own.len() - 1).max(first);
    let (from, to) = (own[first], own[last]);
    match stream.below(3) {
        0 => drop(file.drain(from..to)),
        1 => {
            let copy = file[from..to].to_vec();
            file.splice(to..to, copy);
        }
        _ => {
            let taken: Vec<u8> = file.drain(from..to).collect();
            let left = starts(file);
            let at = *stream.pick(&left);
            file.splice(at..at, taken);
        }
    }
}

fn bytes(file: &mut Vec<u8>, stream: &mut Stream) {
    if file.is_empty() {
        return;
    }
    let at = stream.below(file.len());
    match stream.below(4) {
        0 => file[at] ^= 1 << stream.below(8),
        1 => file[at] = stream.below(256) as u8,
        2 => drop(file.remove(at)),
        _ => file.insert(at, stream.below(256) as u8),
    }
}

fn truncate(file: &mut Vec<u8>, stream: &mut Stream) {
    file.truncate(stream.below(file.len() + 1));
}

/// A part many times over.
fn repeat(file: &mut Vec<u8>, stream: &mut Stream) {
    if file.is_empty() {
        return;
    }
    let from = stream.below(file.len());
    let to = (from + 1 + stream.below(200)).min(file.len());
    let part = file[from..to].repeat(1 + stream.below(20));
    file.splice(to..to, part);
}
