//! The log on stderr: warnings, and with `-v` stages and their times. Libraries have no part in it: nobody reads what they say, and
//! those that speak to servers may say what is secret.

use tracing::Level;
use tracing_subscriber::{filter::Targets, layer::SubscriberExt, util::SubscriberInitExt};

/// Listens from here on.
pub(crate) fn start(verbose: u8) {
    let level = match verbose {
        0 => Level::WARN,
        1 => Level::DEBUG,
        _ => Level::TRACE,
    };
    let subscriber = tracing_subscriber::fmt().with_max_level(level).with_target(false).with_ansi(false).without_time();
    subscriber.with_writer(std::io::stderr).finish().with(Targets::new().with_target("endless", level)).init();
}
