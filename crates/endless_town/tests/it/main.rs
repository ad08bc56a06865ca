//! Integration tests of `endless_town`, in one binary: a module a subject.

mod imported;
mod network;
mod opendrive;
mod parked;
mod scene;
