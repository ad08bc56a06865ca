//! Reads instance images one after another in memory that is kept: fresh memory for each takes longer than decoding it.

use crate::DatasetError;
use endless_world::{ClassTag, Image, ImageSize, InstanceId, InstancePixel};
use std::{fs, io::Cursor, path::Path};

/// Memory for instance images.
#[derive(Debug)]
pub struct InstanceReader {
    file: Vec<u8>,
    rgb: Vec<u8>,
    image: Image<InstancePixel>,
}

impl Default for InstanceReader {
    fn default() -> Self {
        let nothing = Image { size: ImageSize { width: 0, height: 0 }, data: Vec::new() };
        Self { file: Vec::new(), rgb: Vec::new(), image: nothing }
    }
}

impl InstanceReader {
    /// Reads an image, which must be of this size.
    ///
    /// # Errors
    /// When it cannot be read, is not such an image, or has a tag that there is not.
    pub fn read(&mut self, path: &Path, size: ImageSize) -> Result<&Image<InstancePixel>, DatasetError> {
        self.file.clear();
        fs::File::open(path)
            .and_then(|mut file| std::io::Read::read_to_end(&mut file, &mut self.file))
            .map_err(|e| DatasetError::io("cannot read", path, e))?;
        self.decode(size).map_err(|reason| DatasetError::malformed(path, reason))?;
        Ok(&self.image)
    }

    /// The image that was read last.
    pub fn image(&self) -> &Image<InstancePixel> {
        &self.image
    }

    fn decode(&mut self, size: ImageSize) -> Result<(), String> {
        let broken = |e: png::DecodingError| format!("does not decode ({e})");
        let mut reader = png::Decoder::new(Cursor::new(&self.file)).read_info().map_err(broken)?;
        let info = reader.info();
        if (info.color_type, info.bit_depth) != (png::ColorType::Rgb, png::BitDepth::Eight) {
            return Err(format!("is {:?} {:?} instead of 8-bit RGB", info.color_type, info.bit_depth));
        }
        if [info.width, info.height] != [size.width, size.height] {
            return Err(format!("is {}x{} instead of {size}", info.width, info.height));
        }
        self.rgb.resize(size.pixels() * 3, 0);
        reader.next_frame(&mut self.rgb).map_err(broken)?;
        // Reads the checksum of the data and the end mark, so that a cut file is noticed.
        reader.finish().map_err(broken)?;
        self.image.size = size;
        self.image.data.clear();
        self.image.data.reserve(size.pixels());
        let mut unknown = None;
        self.image.data.extend(self.rgb.as_chunks::<3>().0.iter().map(|&[r, g, b]| {
            let tag = ClassTag::from_value(r).unwrap_or_else(|| {
                unknown = Some(r);
                ClassTag::Unlabeled
            });
            InstancePixel { tag, id: InstanceId(u16::from_le_bytes([g, b])) }
        }));
        unknown.map_or(Ok(()), |tag| Err(format!("has the tag {tag}: they end at 28")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{encode_png, instance_from_rgb, rgb_from_instance, write_atomic};

    #[test]
    fn images_are_read_as_they_were_written_one_after_another() {
        let folder = tempfile::tempdir().expect("temp");
        let path = folder.path().join("a.png");
        let mut reader = InstanceReader::default();
        for width in [7, 40, 3] {
            let size = ImageSize { width, height: 5 };
            let pixel = |i: usize| InstancePixel { tag: ClassTag::ALL[i % 29], id: InstanceId(i as u16 * 300) };
            let image = Image { size, data: (0..size.pixels()).map(pixel).collect() };
            let rgb = rgb_from_instance(&image);
            write_atomic(&path, &encode_png(&rgb)).expect("writable");
            assert_eq!(reader.read(&path, size).expect("own output"), &image);
            assert_eq!(instance_from_rgb(&rgb).expect("tags"), image);
            let other = ImageSize { width: width + 1, height: 5 };
            assert!(reader.read(&path, other).expect_err("another size").to_string().contains("instead of"));
        }
        let wrong = Image { size: ImageSize { width: 1, height: 1 }, data: vec![[29, 0, 0]] };
        write_atomic(&path, &encode_png(&wrong)).expect("writable");
        assert!(reader.read(&path, wrong.size).expect_err("no tag").to_string().contains("has the tag 29"));
    }
}
