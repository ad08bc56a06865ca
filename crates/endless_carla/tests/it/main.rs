//! A server and clients that speak its protocol byte by byte.

mod cameras;
mod client;
mod dataset;
mod opendrive;
mod proxy;
mod recordings;
mod sessions;
mod solid_things;
mod unbreakable;
mod vehicles;
mod world_queries;
