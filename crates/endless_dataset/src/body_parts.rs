//! The layer of people's parts.

use endless_world::{BodyPart, Image};

/// R = part, G = B = 0.
pub(crate) fn rgb_from_parts(parts: &Image<u8>) -> Image<[u8; 3]> {
    Image { size: parts.size, data: parts.data.iter().map(|&part| [part, 0, 0]).collect() }
}

/// Parts of an image; `None` where there are none.
///
/// # Errors
/// What is wrong with it.
pub(crate) fn parts_from_rgb(encoded: &Image<[u8; 3]>) -> Result<Vec<Option<BodyPart>>, String> {
    let part = |&[r, g, b]: &[u8; 3]| match (r, BodyPart::from_value(r), [g, b]) {
        (0, _, [0, 0]) => Ok(None),
        (_, Some(part), [0, 0]) => Ok(Some(part)),
        (_, None, [0, 0]) => Err(format!("has the part {r}: they end at {}", BodyPart::ALL.len())),
        _ => Err(format!("has green {g} and blue {b}: they are 0")),
    };
    encoded.data.iter().map(part).collect()
}

/// Every part in its colour, everything else black.
///
/// # Errors
/// What is wrong with the image.
pub(crate) fn body_parts_preview(encoded: &Image<[u8; 3]>) -> Result<Image<[u8; 3]>, String> {
    let parts = parts_from_rgb(encoded)?;
    Ok(Image { size: encoded.size, data: parts.iter().map(|part| part.map_or([0; 3], BodyPart::color)).collect() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::ImageSize;

    #[test]
    fn only_parts_are_legal() {
        let image = |pixel| Image::filled(ImageSize { width: 2, height: 1 }, pixel);
        assert_eq!(parts_from_rgb(&image([14, 0, 0])), Ok(vec![Some(BodyPart::Head); 2]));
        assert_eq!(parts_from_rgb(&image([0; 3])), Ok(vec![None; 2]));
        assert!(parts_from_rgb(&image([16, 0, 0])).is_err_and(|reason| reason.contains("16")));
        assert!(parts_from_rgb(&image([1, 2, 0])).is_err_and(|reason| reason.contains("green")));
    }
}
