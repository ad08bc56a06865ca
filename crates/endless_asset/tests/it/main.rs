//! Integration tests of `endless_asset`, in one binary: a module a subject.

mod catalogue;
mod choice;
mod furniture;
mod geometry;
mod plants;
mod soup;
