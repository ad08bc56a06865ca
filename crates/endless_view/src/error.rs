//! Why a dataset cannot be shown at all.

use std::{io, net::SocketAddr, path::PathBuf};

/// The viewer cannot begin. Messages are one line, which says what to do.
#[derive(Debug, thiserror::Error)]
pub enum ViewError {
    /// There is no dataset.
    #[error("there is no dataset (no dataset.json): give the folder that `endless generate` writes: {}", folder.display())]
    NoDataset {
        /// Where.
        folder: PathBuf,
    },
    /// The dataset cannot be read.
    #[error("{reason}: {}", folder.display())]
    Unreadable {
        /// What is wrong with it.
        reason: String,
        /// Where.
        folder: PathBuf,
    },
    /// Another program listens there.
    #[error("port {} of {} is in use: give another with --port, or leave it out for any that is free", address.port(), address.ip())]
    PortInUse {
        /// Where.
        address: SocketAddr,
    },
    /// The operating system refuses to listen.
    #[error("cannot listen at {address}: {cause}")]
    Listen {
        /// Where.
        address: SocketAddr,
        /// Why not.
        cause: io::Error,
    },
    /// The operating system gives no threads.
    #[error("cannot start: {0}")]
    Start(io::Error),
}
