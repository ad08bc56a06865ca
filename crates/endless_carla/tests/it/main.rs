//! A server and clients that speak its protocol byte by byte.

mod cameras;
mod client;
mod dataset;
mod proxy;
mod opendrive;
mod recordings;
mod sessions;
mod unbreakable;
mod world_queries;
