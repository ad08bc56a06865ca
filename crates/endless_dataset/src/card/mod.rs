//! The cards of a dataset: what it is, for people and for catalogues of datasets. They follow from the manifest alone.

mod croissant;
mod facts;
mod hugging_face;
mod recipe_toml;
#[cfg(test)]
mod tests;
mod write;

pub use facts::{CardFacts, size_category};
pub use recipe_toml::recipe_toml;
pub use write::Card;
