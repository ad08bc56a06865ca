//! A file of the target as libraries want one to write to.

use endless_dataset::AtomicFile;
use std::io;

/// Gives what the disk says as the cause of the error.
pub(crate) struct Sink(pub(crate) AtomicFile);

impl io::Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes).map_err(io::Error::other)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
