//! The disk space that a dataset needs.

/// Estimate of the disk space that the remaining frames need, and of the free space.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DiskEstimate {
    /// Images of each layer still to be made.
    pub camera_frames: u64,
    /// MapStatistics so many bytes.
    pub bytes: u64,
    /// Bytes free on the disk.
    pub free: u64,
}
