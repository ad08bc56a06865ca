//! The build of the program that wrote a dataset.

use serde::{Deserialize, Serialize};
use std::fmt;

/// What tells one build of the program from another. Builds of the same sources make the same bytes of the same recipe;
/// others may make other ones.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct BuildIdentity {
    /// The program's version.
    pub version: String,
    /// The commit it was built from, with `-dirty` if its sources were changed since; for people to look up, absent
    /// where there was no repository.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub commit: Option<String>,
    /// Hash of all sources and of the list of libraries with their versions: what builds are compared by.
    pub sources: String,
}

impl BuildIdentity {
    /// The build of files that nothing tells the origin of. It is equal to no build.
    pub fn unknown() -> Self {
        Self { version: "unknown".into(), commit: None, sources: "unknown".into() }
    }

    /// Whether both make the same bytes of the same recipe.
    pub fn makes_same_bytes(&self, other: &Self) -> bool {
        self.sources == other.sources && self.sources != Self::unknown().sources
    }
}

/// As `endless --version` says it, without the format.
impl fmt::Display for BuildIdentity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} (", self.version)?;
        if let Some(commit) = &self.commit {
            write!(f, "commit {commit}, ")?;
        }
        write!(f, "sources {})", self.sources)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_decide_and_the_unknown_is_like_nothing() {
        let build = |commit: Option<&str>, sources: &str| BuildIdentity {
            version: "1.2.3".into(),
            commit: commit.map(str::to_owned),
            sources: sources.into(),
        };
        assert!(build(Some("abc"), "1f").makes_same_bytes(&build(None, "1f")));
        assert!(!build(Some("abc"), "1f").makes_same_bytes(&build(Some("abc"), "2f")));
        assert!(!BuildIdentity::unknown().makes_same_bytes(&BuildIdentity::unknown()));
        assert_eq!(build(Some("abc-dirty"), "1f").to_string(), "1.2.3 (commit abc-dirty, sources 1f)");
    }
}
