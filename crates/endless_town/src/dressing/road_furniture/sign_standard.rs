//! Which signs stand where by the manner of a country.

/// Whose signs a town has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SignStandard {
    /// Convention on Road Signs and Signals (Vienna, 1968).
    Vienna,
    /// Manual on Uniform Traffic Control Devices (United States).
    Mutcd,
}

/// Codes of signs, by frequency.
pub(crate) type Codes = &'static [(&'static str, f64)];

impl SignStandard {
    pub(crate) const fn along_kerbs(self) -> Codes {
        match self {
            Self::Vienna => &[
                ("C,18", 3.0),
                ("C,19", 2.0),
                ("E,14", 3.0),
                ("A,12", 0.8),
                ("A,13", 0.6),
                ("A,32", 0.4),
                ("B,3", 0.6),
                ("D,4", 0.5),
            ],
            Self::Mutcd => &[("R7-1", 5.0), ("R2-1", 2.0), ("W11-2", 1.0), ("S1-1", 0.6), ("W1-2", 0.3)],
        }
    }

    /// None that forbids or demands a way: where vehicles go is up to the map.
    pub(crate) const fn before_junctions(self) -> Codes {
        match self {
            Self::Vienna => &[("C,18", 1.0), ("A,32", 1.0), ("E,14", 0.5), ("A,12", 0.5)],
            Self::Mutcd => &[("W2-1", 2.0), ("R7-1", 1.0), ("R2-1", 0.5)],
        }
    }

    pub(crate) const fn before_signals(self) -> Codes {
        match self {
            Self::Vienna => &[("A,17a", 2.0), ("C,18", 1.0), ("C,19", 1.0)],
            Self::Mutcd => &[("W3-3", 2.0), ("R7-1", 1.0)],
        }
    }

    /// "Pass this side".
    pub(crate) const fn on_medians(self) -> &'static str {
        match self {
            Self::Vienna => "D,2",
            Self::Mutcd => "R4-7",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dressing::road_furniture::post::sign_variant;

    #[test]
    fn every_code_has_a_face() {
        for standard in [SignStandard::Vienna, SignStandard::Mutcd] {
            let lists = [standard.along_kerbs(), standard.before_junctions(), standard.before_signals()];
            let codes = lists.into_iter().flatten().map(|code| code.0).chain([standard.on_medians()]);
            codes.for_each(|code| assert!(sign_variant(code).is_some(), "{code}"));
        }
    }
}
