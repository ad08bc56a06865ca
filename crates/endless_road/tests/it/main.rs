//! Integration tests of `endless_road`, in one binary: a module a subject.

mod faults;
mod grid;
mod network;
mod opendrive;
mod opendrive_files;
mod opendrive_spec;
mod osm;
