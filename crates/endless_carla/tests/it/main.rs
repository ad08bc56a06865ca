//! A server and clients that speak its protocol byte by byte.

mod cameras;
mod client;
mod sessions;
mod unbreakable;
