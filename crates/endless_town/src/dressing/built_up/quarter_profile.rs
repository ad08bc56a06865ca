//! Profiles of quarters: which buildings stand where streets are dense or sparse, and how they are set back.

use crate::building::BuildingKind;

/// The buildings of a quarter: kinds by frequency, and storeys.
#[derive(Debug, Clone, Copy)]
pub(crate) struct QuarterProfile {
    pub(super) kinds: &'static [(BuildingKind, f64)],
    pub(super) storeys: (u32, u32),
    /// Share of lots left open.
    pub(super) open: f64,
}

/// Profiles by density of streets.
pub(super) const QUARTERS: [(f64, QuarterProfile); 4] = [
    (
        0.0,
        QuarterProfile { kinds: &[(BuildingKind::House, 4.0), (BuildingKind::Barn, 1.0)], storeys: (1, 2), open: 0.55 },
    ),
    (
        55.0,
        QuarterProfile {
            kinds: &[
                (BuildingKind::House, 4.0),
                (BuildingKind::Shop, 1.2),
                (BuildingKind::Flats, 1.0),
                (BuildingKind::Hall, 0.5),
            ],
            storeys: (2, 3),
            open: 0.2,
        },
    ),
    (
        125.0,
        QuarterProfile {
            kinds: &[
                (BuildingKind::Terrace, 4.0),
                (BuildingKind::Flats, 2.0),
                (BuildingKind::Shop, 1.4),
                (BuildingKind::House, 1.2),
            ],
            storeys: (2, 5),
            open: 0.1,
        },
    ),
    (
        235.0,
        QuarterProfile {
            kinds: &[
                (BuildingKind::Terrace, 2.5),
                (BuildingKind::Office, 3.0),
                (BuildingKind::Flats, 2.0),
                (BuildingKind::Tower, 1.2),
            ],
            storeys: (4, 8),
            open: 0.06,
        },
    ),
];

pub(super) const WORKS: QuarterProfile = QuarterProfile {
    kinds: &[(BuildingKind::Hall, 4.0), (BuildingKind::Shop, 0.7), (BuildingKind::Office, 0.5)],
    storeys: (1, 3),
    open: 0.2,
};

pub(super) const TRADE: QuarterProfile = QuarterProfile {
    kinds: &[
        (BuildingKind::Office, 2.0),
        (BuildingKind::Shop, 2.5),
        (BuildingKind::Terrace, 1.5),
        (BuildingKind::Flats, 0.7),
    ],
    storeys: (2, 5),
    open: 0.12,
};

pub(super) fn usual_quarter(density: f64) -> QuarterProfile {
    QUARTERS.iter().rev().find(|q| density >= q.0).unwrap_or(&QUARTERS[0]).1
}
