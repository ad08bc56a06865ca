//! Integration tests of `endless_pipeline`, in one binary: a module a subject.

mod bake_cache;
mod builds;
mod carriers;
mod changing;
mod city;
mod clone;
mod disk_full;
mod events;
mod fake;
mod flow;
mod golden;
mod happenings;
mod kill;
mod labels;
mod lenses;
mod live;
mod objects;
mod paper;
mod people_layers;
mod randomised;
mod record;
mod rig;
mod seen;
mod sensor_geometry;
mod streaming;
