//! The viewer as a browser meets it, and as somebody who means harm does.

mod answers;
mod fixture;
mod growing;
mod hostile;
mod http;
mod start;
