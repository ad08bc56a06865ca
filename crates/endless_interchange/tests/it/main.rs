//! Integration tests, in one binary.

mod imported_models;
