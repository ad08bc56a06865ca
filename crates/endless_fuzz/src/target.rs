//! What a target of fuzzing is.

use endless_world::Stream;
use std::{
    fs, io,
    path::{Path, PathBuf},
};

/// A reader of bytes with what counts as a right answer.
#[derive(Debug, Clone, Copy)]
pub struct FuzzTarget {
    /// Name of its program and of the folder of its corpus.
    pub name: &'static str,
    /// Has bytes read. What is wrong with the answer is the error; a panic is wrong as well.
    pub judge: fn(&[u8]) -> Result<(), String>,
    /// A file changed in a few places.
    pub mutate: fn(&[u8], &mut Stream) -> Vec<u8>,
}

impl FuzzTarget {
    /// The files of its corpus, by name.
    ///
    /// # Errors
    /// When they cannot be read.
    pub fn corpus(&self) -> io::Result<Vec<(PathBuf, Vec<u8>)>> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus").join(self.name);
        let mut paths = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
        paths.sort();
        paths.into_iter().map(|path| fs::read(&path).map(|bytes| (path, bytes))).collect()
    }
}

/// Errors are one line.
pub(crate) fn one_line(error: &impl ToString) -> Result<(), String> {
    let text = error.to_string();
    if text.lines().count() == 1 { Ok(()) } else { Err(format!("an error that is not one line: {text:?}")) }
}
