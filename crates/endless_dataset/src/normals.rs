//! The encoding of normals.

use endless_world::Image;

/// The normal of a pixel: camera frame, x right, y down, z forward; `None` for the sky.
pub(crate) fn normal_of(pixel: [u16; 3]) -> Option<[f32; 3]> {
    (pixel != [0; 3]).then(|| pixel.map(|value| f32::from(value) * (2.0 / 65_535.0) - 1.0))
}

/// Whether all normals are of unit length.
///
/// # Errors
/// How many are not.
pub(crate) fn check_normals(image: &Image<[u16; 3]>) -> Result<(), String> {
    /// Three steps of the encoding, and the rounding of single precision.
    const TOLERANCE: f32 = 2e-4;
    let odd = |normal: [f32; 3]| (normal.iter().map(|n| n * n).sum::<f32>() - 1.0).abs() > TOLERANCE;
    let count = image.data.iter().filter(|pixel| normal_of(**pixel).is_some_and(odd)).count();
    if count == 0 { Ok(()) } else { Err(format!("has {count} normals that are not of unit length")) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::ImageSize;

    #[test]
    fn lengths_are_checked() {
        let image = |pixel| Image::filled(ImageSize { width: 2, height: 1 }, pixel);
        for good in [[0; 3], [32_768, 32_768, 0], [65_535, 32_767, 32_768], [55_937, 9_598, 32_768]] {
            assert_eq!(check_normals(&image(good)), Ok(()), "{good:?}");
        }
        for bad in [[1, 1, 1], [32_768; 3], [65_535; 3], [50_000, 9_598, 32_768]] {
            assert_eq!(check_normals(&image(bad)), Err("has 2 normals that are not of unit length".to_owned()));
        }
    }
}
