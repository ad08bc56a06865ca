//! Crops for re-identification: people as in Market-1501, vehicles as in VeRi-776.
//!
//! An identity is a look (`reid` of `actors.json`), the same in all videos. No identity of the training part is in another
//! part: of other parts, objects that look like one of the training part are left out. Left out are also those that the
//! picture's edge cuts, of which less than half can be seen, or that are small.

mod crops;
mod identities;
mod market;
mod veri;

pub(crate) use market::Market;
pub(crate) use veri::Veri;
