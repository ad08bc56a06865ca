//! What messages of streams carry, in memory that is used again: a picture has megabytes, and the next one as many.

use std::ops::Deref;
use std::sync::{Arc, Mutex, PoisonError};

/// Memory of payloads that nobody reads any more.
#[derive(Debug, Default)]
pub(super) struct Spares(Mutex<Vec<Vec<u8>>>);

/// Most that are kept.
const MOST: usize = 4;

impl Spares {
    /// The memory of an earlier payload, which still holds that, or new memory.
    pub(super) fn take(&self) -> Vec<u8> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).pop().unwrap_or_default()
    }

    fn give(&self, bytes: Vec<u8>) {
        let mut spares = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if spares.len() < MOST {
            spares.push(bytes);
        }
    }
}

/// What follows a message's header.
#[derive(Debug)]
pub(super) struct Payload {
    bytes: Vec<u8>,
    home: Arc<Spares>,
}

impl Payload {
    /// Whose memory goes back there.
    pub(super) fn new(bytes: Vec<u8>, home: &Arc<Spares>) -> Self {
        Self { bytes, home: Arc::clone(home) }
    }
}

impl Deref for Payload {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        &self.bytes
    }
}

impl Drop for Payload {
    fn drop(&mut self) {
        self.home.give(std::mem::take(&mut self.bytes));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_comes_back_and_little_is_kept() {
        let home = Arc::new(Spares::default());
        let payload = Payload::new(vec![7; 9], &home);
        assert_eq!((&payload[..], home.take().len()), (&[7; 9][..], 0));
        drop(payload);
        assert_eq!((home.take(), home.take()), (vec![7; 9], vec![]));
        drop([(); 9].map(|()| Payload::new(vec![1], &home)));
        assert_eq!((0..9).filter(|_| !home.take().is_empty()).count(), MOST);
    }
}
