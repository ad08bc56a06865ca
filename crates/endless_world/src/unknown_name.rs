//! The error of a word that is none of a list.

use std::fmt;

/// A name that is not in the list; its message lists the names that are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnknownName {
    /// The kind of name, e.g. "weather".
    pub what: &'static str,
    /// The name that was given.
    pub given: String,
    /// The names there are.
    pub known: Vec<&'static str>,
}

impl UnknownName {
    /// The error of a name that is that of none of `all`.
    pub fn new<T: Copy + Into<&'static str>>(what: &'static str, given: &str, all: &[T]) -> Self {
        Self { what, given: given.to_owned(), known: all.iter().map(|&one| one.into()).collect() }
    }
}

impl fmt::Display for UnknownName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unknown {} '{}': use one of {}", self.what, self.given, self.known.join(", "))
    }
}

impl std::error::Error for UnknownName {}
