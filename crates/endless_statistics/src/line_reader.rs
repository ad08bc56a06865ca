//! Files of one JSON object a line, one line in memory at a time.

use endless_dataset::DatasetError;
use std::{
    fs::File,
    io::{BufRead, BufReader},
    path::Path,
};

/// Gives the lines whose number from 0 is a multiple of `stride` to `each`, which says what is wrong with one; tells how many
/// lines there are.
///
/// # Errors
/// When the file cannot be read, or `each` finds something wrong; the message has the line's number.
pub(crate) fn each_line(
    path: &Path,
    stride: u64,
    mut each: impl FnMut(u64, &[u8]) -> Result<(), String>,
) -> Result<u64, DatasetError> {
    let unreadable = |e| DatasetError::io("cannot read", path, e);
    let mut reader = BufReader::with_capacity(1 << 16, File::open(path).map_err(unreadable)?);
    let mut line = Vec::new();
    let mut number = 0;
    loop {
        line.clear();
        if reader.read_until(b'\n', &mut line).map_err(unreadable)? == 0 {
            return Ok(number);
        }
        if number % stride == 0 {
            let text = line.strip_suffix(b"\n").unwrap_or(&line);
            each(number, text)
                .map_err(|reason| DatasetError::malformed(path, format!("line {}: {reason}", number + 1)))?;
        }
        number += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_counted_and_faults_have_their_number() {
        let folder = tempfile::tempdir().expect("temp");
        let path = folder.path().join("a.jsonl");
        std::fs::write(&path, "a\nb\nc\nd").expect("writable");
        let lines = |stride| {
            let mut seen = Vec::new();
            let count = each_line(&path, stride, |number, line| {
                seen.push((number, String::from_utf8_lossy(line).into_owned()));
                if line == b"d" && stride == 3 { Err("is d".into()) } else { Ok(()) }
            });
            (count.map_err(|e| e.to_string()), seen)
        };
        assert_eq!(lines(1).0, Ok(4));
        assert_eq!(lines(2), (Ok(4), vec![(0, "a".into()), (2, "c".into())]));
        assert!(lines(3).0.is_err_and(|message| message.starts_with("line 4: is d: ")));
        assert!(each_line(&folder.path().join("none"), 1, |_, _| Ok(())).is_err());
    }
}
