//! Images as they are stored.

use endless_world::Image;

/// An image as it is stored: 8-bit RGB, whatever it means.
pub type StoredImage = Image<[u8; 3]>;
