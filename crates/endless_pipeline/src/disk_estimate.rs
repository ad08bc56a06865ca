//! How much disk a dataset takes.

/// What is still to be made, and the room for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DiskEstimate {
    /// Images of each layer still to be made.
    pub camera_frames: u64,
    /// MapStatistics so many bytes.
    pub bytes: u64,
    /// Bytes free on the disk.
    pub free: u64,
}
