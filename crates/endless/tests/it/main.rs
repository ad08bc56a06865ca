//! Integration tests of `endless`, in one binary: a module a subject.

mod bad_input;
mod build_identity;
mod cache;
mod cluster;
mod contents;
mod docs;
mod export;
mod imported_assets;
mod imported_maps;
mod program;
mod real_city;
mod scaling;
mod shards;
mod simulate;
mod statistics;
mod storage;
mod threads;
mod view;
