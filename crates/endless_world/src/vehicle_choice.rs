//! Which vehicle stands or drives somewhere.

use crate::{Stream, VehicleModelId, VehicleSpec};

/// A model drawn in proportion to the frequencies given with the models, in the order of the catalogue; `None` if none
/// is positive.
///
/// Each model is drawn by its own [`VehicleSpec::key`]: a design more in the catalogue changes only those draws that it
/// wins ([`Stream::weighted_by_key`]). Takes one number from the stream.
pub fn choose_vehicle<'a>(
    stream: &mut Stream,
    models: impl IntoIterator<Item = (&'a VehicleSpec, f64)>,
) -> Option<VehicleModelId> {
    let choices = models.into_iter().map(|(spec, frequency)| (spec.key(), frequency));
    stream.weighted_by_key(choices).map(VehicleModelId::from_index)
}
