//! Checks that the triangles of a model form a surface.

use super::ImportError;
use super::model::SourceModel;
use glam::Vec3;

/// Edges that may join more than two faces, percent. Bodies that pass through each other have none of them; doubled
/// faces have nothing else.
const MOST_PERCENT: u32 = 25;

/// Refuses what is doubled all over.
///
/// # Errors
/// [`ImportError::NotASurface`].
pub(super) fn check(model: &SourceModel) -> Result<(), ImportError> {
    let place = |p: Vec3| (p + 0.0).to_array().map(f32::to_bits);
    let mut edges = Vec::new();
    for part in &model.parts {
        for t in &part.triangles {
            let [a, b, c] = t.map(|i| place(part.positions[i as usize]));
            edges.extend([(a, b), (b, c), (c, a)].map(|(p, q)| (p.min(q), p.max(q))));
        }
    }
    edges.sort_unstable();
    let (mut all, mut crowded) = (0u64, 0u64);
    for same in edges.chunk_by(|p, q| p == q) {
        all += 1;
        crowded += u64::from(same.len() > 2);
    }
    let share_percent = (100 * crowded).checked_div(all).unwrap_or(0) as u32;
    let most_percent = MOST_PERCENT;
    if share_percent > most_percent { Err(ImportError::NotASurface { share_percent, most_percent }) } else { Ok(()) }
}
