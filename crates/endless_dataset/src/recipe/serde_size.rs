//! Image sizes as text, `1280x720`.

use endless_world::ImageSize;
use serde::{Deserialize, Deserializer, Serializer, de::Error};

pub(super) fn serialize<S: Serializer>(size: &ImageSize, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(size)
}

pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<ImageSize, D::Error> {
    String::deserialize(deserializer)?.parse().map_err(D::Error::custom)
}
