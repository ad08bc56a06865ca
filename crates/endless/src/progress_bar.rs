//! Bars of progress on stderr.

use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;

/// A bar that counts these; hidden where stderr is no terminal.
pub(crate) fn bar_of(things: &str) -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(0);
    match ProgressStyle::with_template(&format!("[{{bar:30}}] {{pos}}/{{len}} {things}, {{eta}} left")) {
        Ok(style) => bar.with_style(style),
        Err(_its_own_style) => bar,
    }
}
