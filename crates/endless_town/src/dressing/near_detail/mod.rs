//! What is seen from near by alone, put before the cameras that a scene has: lawns with tufts, beds and benches, their
//! frayed edges, maize.

mod detail_ground;
mod lawn;
mod lawn_edge;
mod maize;
mod source;

pub(crate) use detail_ground::DetailGround;
pub use source::DetailSource;
