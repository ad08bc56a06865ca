//! The identity of this build, from the build script.

use endless_dataset::{BuildIdentity, Manifest};
use std::sync::LazyLock;

/// What identifies this build.
pub fn this_build() -> BuildIdentity {
    let commit = env!("ENDLESS_COMMIT");
    BuildIdentity {
        version: env!("CARGO_PKG_VERSION").into(),
        commit: (!commit.is_empty()).then(|| commit.into()),
        sources: env!("ENDLESS_SOURCES").into(),
    }
}

/// What `endless --version` says.
pub(crate) static VERSION: LazyLock<String> =
    LazyLock::new(|| format!("{}, format {}", this_build(), Manifest::FORMAT));
