//! Memory for instance images, a few for all threads, handed on from frame to frame.

use endless_dataset::InstanceReader;
use endless_world::{Image, InstancePixel};
use std::{
    ops::Deref,
    sync::{Mutex, PoisonError},
};

/// Those that nobody uses at the moment.
static SPARE: Mutex<Vec<InstanceReader>> = Mutex::new(Vec::new());

/// An instance image in such memory.
#[derive(Debug)]
pub struct PooledInstance(Option<InstanceReader>);

impl PooledInstance {
    /// An image that this reads.
    pub(crate) fn read<E>(read: impl FnOnce(&mut InstanceReader) -> Result<(), E>) -> Result<Self, E> {
        let mut reader = SPARE.lock().unwrap_or_else(PoisonError::into_inner).pop().unwrap_or_default();
        read(&mut reader)?;
        Ok(Self(Some(reader)))
    }
}

impl Deref for PooledInstance {
    type Target = Image<InstancePixel>;

    fn deref(&self) -> &Self::Target {
        self.0.as_ref().expect("there until it is dropped").image()
    }
}

impl Drop for PooledInstance {
    fn drop(&mut self) {
        SPARE.lock().unwrap_or_else(PoisonError::into_inner).extend(self.0.take());
    }
}
