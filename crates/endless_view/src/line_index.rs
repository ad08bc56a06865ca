//! Where the lines of a file begin, found as far as somebody has asked: the first line of a file of gigabytes is there
//! at once.

use crate::{folder::StampedFile, refusal::Refusal};
use std::io::{self, Read, Seek, SeekFrom};

/// Bytes that are searched at once.
const BLOCK: usize = 1 << 20;
/// Most lines of one answer.
pub(crate) const MOST_LINES: u32 = 256;
/// Most bytes of one answer.
const MOST_BYTES: u64 = 64 << 20;

/// The ends of the lines of a file, as far as it was read.
#[derive(Debug, Default)]
pub(crate) struct LineIndex {
    /// Behind the line break of each line.
    ends: Vec<u64>,
    searched: u64,
}

impl LineIndex {
    /// Some lines as a JSON array, fewer where the file has no more. A line without a line break is not whole yet, and left
    /// out.
    pub(crate) fn array(&mut self, file: &mut StampedFile, from: u32, count: u32) -> Result<Vec<u8>, Refusal> {
        let wanted = from as usize + count.min(MOST_LINES) as usize;
        let unreadable = |cause: io::Error| Refusal::Damaged(cause.to_string());
        self.search(file, wanted).map_err(unreadable)?;
        let end = wanted.min(self.ends.len());
        let begin = (from as usize).min(end);
        let place = |line: usize| if line == 0 { 0 } else { self.ends[line - 1] };
        let (first, last) = (place(begin), place(end));
        if last - first > MOST_BYTES {
            return Err(Refusal::Bad("that is too much at once: ask for fewer lines".into()));
        }
        let mut text = vec![0; (last - first) as usize];
        file.file.seek(SeekFrom::Start(first)).map_err(unreadable)?;
        file.file.read_exact(&mut text).map_err(unreadable)?;
        let mut array = Vec::with_capacity(text.len() + 2);
        array.push(b'[');
        for line in begin..end {
            let (from, to) = ((place(line) - first) as usize, (place(line + 1) - first) as usize);
            array.extend_from_slice(text[from..to].trim_ascii_end());
            array.push(b',');
        }
        if end > begin {
            array.pop();
        }
        array.push(b']');
        Ok(array)
    }

    /// Finds the ends of so many lines, or of all.
    fn search(&mut self, file: &mut StampedFile, wanted: usize) -> io::Result<()> {
        if self.ends.len() >= wanted || self.searched >= file.bytes {
            return Ok(());
        }
        file.file.seek(SeekFrom::Start(self.searched))?;
        let mut block = vec![0; BLOCK];
        while self.ends.len() < wanted {
            let read = file.file.read(&mut block)?;
            if read == 0 {
                break;
            }
            let searched = self.searched;
            self.ends.extend(memchr::memchr_iter(b'\n', &block[..read]).map(|at| searched + at as u64 + 1));
            self.searched += read as u64;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::folder::DatasetFolder;
    use proptest::prelude::*;
    use std::fs;

    /// What a fresh index and one that has answered before say.
    fn arrays(text: &str, asked: &[(u32, u32)]) -> Vec<String> {
        let folder = tempfile::tempdir().expect("temp");
        let path = folder.path().join("lines");
        fs::write(&path, text).expect("room");
        let folder = DatasetFolder::new(folder.path()).expect("a folder");
        let mut index = LineIndex::default();
        let array = |&(from, count): &(u32, u32)| {
            let mut file = folder.open(&path).expect("there");
            String::from_utf8(index.array(&mut file, from, count).expect("readable")).expect("text")
        };
        asked.iter().map(array).collect()
    }

    #[test]
    fn only_whole_lines_are_told() {
        let asked = [(0, 1), (0, 9), (1, 1), (2, 1), (3, 1), (u32::MAX, u32::MAX)];
        assert_eq!(arrays("1\n22\r\n333", &asked), ["[1]", "[1,22]", "[22]", "[]", "[]", "[]"]);
        assert_eq!(arrays("", &[(0, 1)]), ["[]"]);
    }

    proptest! {
        #[test]
        fn lines_are_those_of_the_standard_library(
            lines in prop::collection::vec("[0-9]{1,5}", 0..300),
            asked in prop::collection::vec((0u32..310, 0u32..310), 1..5),
        ) {
            let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
            let told = arrays(&text, &asked);
            for ((from, count), told) in asked.into_iter().zip(told) {
                let some = lines.iter().skip(from as usize).take(count.min(MOST_LINES) as usize);
                prop_assert_eq!(told, format!("[{}]", some.cloned().collect::<Vec<_>>().join(",")));
            }
        }
    }
}
