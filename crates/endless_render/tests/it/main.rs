//! Integration tests of `endless_render`, in one binary: a module a subject. Towns are rendered in `endless_city`'s.

mod boxes;
mod flow;
mod shadow;
