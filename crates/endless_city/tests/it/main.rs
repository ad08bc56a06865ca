//! Integration tests of `endless_city` and of the renderer in towns, in one binary: a module a subject.

mod changing;
mod clutter;
mod exactness;
mod grain;
mod hiding;
mod moving;
