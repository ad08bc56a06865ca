//! Integration tests of `endless_statistics`, in one binary: a module a subject.

mod compared;
mod counted;
mod faults;
mod hand_made;
mod page;
