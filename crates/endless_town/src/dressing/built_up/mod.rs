//! What is built: buildings on known footprints and along the streets.

pub(crate) mod density;
pub(crate) mod footprint;
pub(crate) mod growth;
mod quarter_profile;
pub(crate) mod streets;
