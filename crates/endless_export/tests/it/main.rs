//! Integration tests of exports, in one binary: a module a subject.

mod damage;
