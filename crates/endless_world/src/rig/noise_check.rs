//! Checks that settings of sensors share.

/// Fails with the name of the first value that is not finite and at least 0.
pub(super) fn at_least_0(values: &[(&str, f64)]) -> Result<(), String> {
    let wrong = values.iter().find(|(_, value)| !(value.is_finite() && *value >= 0.0));
    wrong.map_or(Ok(()), |(name, value)| Err(format!("{name} is {value}: use a number of at least 0")))
}

/// Fails with the name of the first value that is not finite.
pub(super) fn finite(values: &[(&str, f64)]) -> Result<(), String> {
    let wrong = values.iter().find(|(_, value)| !value.is_finite());
    wrong.map_or(Ok(()), |(name, value)| Err(format!("{name} is {value}: use a number")))
}
