//! What a server is told when it is started.

use super::quality_level::QualityLevel;
use std::net::IpAddr;
use std::path::PathBuf;

/// How a server runs.
#[derive(Debug, Clone)]
pub struct ServerSettings {
    /// Who may connect: this machine alone, unless another address is given.
    pub bind: IpAddr,
    /// Of requests; the next one is that of streams. 0 for any.
    pub port: u16,
    /// The first map.
    pub map: String,
    /// Of all that is drawn.
    pub seed: u64,
    /// How good the pictures of moving cameras are.
    pub quality: QualityLevel,
    /// Where recordings are kept; none: nothing can be recorded or replayed.
    pub recordings: Option<PathBuf>,
}
