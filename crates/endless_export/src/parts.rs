//! Which videos of a dataset are in which part.

use crate::{ExportError, SourceDataset, SplitBy, SplitShares};
use std::path::Path;

/// The parts of a dataset, with the names of the videos of each: those in which [`export`](crate::export) divides it.
///
/// # Errors
/// When the dataset cannot be read or cannot be divided so.
pub fn parts(
    root: &Path,
    shares: Option<&SplitShares>,
    by: SplitBy,
) -> Result<Vec<(String, Vec<String>)>, ExportError> {
    let dataset = SourceDataset::open(root, 1)?;
    let (shares, part_of) = divide(&dataset, shares, by)?;
    let videos_of = |part: usize| {
        let own = part_of.iter().zip(&dataset.sequences).filter(move |(of, _)| **of == part);
        let mut names: Vec<String> = own.map(|(_, sequence)| sequence.video.name.clone()).collect();
        names.dedup();
        names
    };
    Ok(shares.names().into_iter().enumerate().map(|(part, name)| (name, videos_of(part))).collect())
}

/// The shares, and the part of each sequence. Where nobody asked for shares and there are too few groups for the usual ones, all
/// is in `train`.
pub(crate) fn divide(
    dataset: &SourceDataset,
    shares: Option<&SplitShares>,
    by: SplitBy,
) -> Result<(SplitShares, Vec<usize>), ExportError> {
    let divided = |shares: SplitShares| {
        let part_of = shares.divide(&dataset.sequences, by, dataset.manifest.seed)?;
        Ok((shares, part_of))
    };
    match shares {
        Some(shares) => divided(shares.clone()),
        None => divided(SplitShares::default()).or_else(|_too_few_groups: ExportError| divided(SplitShares::whole())),
    }
}
