//! A server and clients that speak its protocol byte by byte.

mod agreement;
mod cameras;
mod client;
mod dataset;
mod hiding;
mod opendrive;
mod proxy;
mod recordings;
mod sessions;
mod solid_things;
mod unbreakable;
mod vehicles;
mod world_queries;
