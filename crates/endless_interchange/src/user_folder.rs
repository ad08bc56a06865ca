//! Where the platform keeps what belongs to the user.

use etcetera::BaseStrategy;
use std::path::PathBuf;

/// The folder of a name for data of the user of this machine; `None` where the platform has no such place. It need not exist.
pub fn user_data_folder(name: &str) -> Option<PathBuf> {
    Some(etcetera::choose_base_strategy().ok()?.data_dir().join("endless").join(name))
}
