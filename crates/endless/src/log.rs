//! The log on stderr: warnings, and with `-v` stages and their times.

use tracing::Level;

/// Listens from here on.
pub(crate) fn start(verbose: u8) {
    let level = match verbose {
        0 => Level::WARN,
        1 => Level::DEBUG,
        _ => Level::TRACE,
    };
    let subscriber = tracing_subscriber::fmt().with_max_level(level).with_target(false).with_ansi(false).without_time();
    subscriber.with_writer(std::io::stderr).init();
}
