//! Integration tests of `endless_render`, in one binary: a module a subject.

mod exactness;
mod grain;
