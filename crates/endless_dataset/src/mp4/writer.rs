//! Writes an MP4 file with its index in front, in constant memory.

use super::{
    boxes::{Track, data_head, file_type, movie},
    nal_units,
};
use crate::{AtomicFile, DatasetError};
use endless_world::ImageSize;
use std::{
    fs::File,
    io::{self, BufWriter, Read, Seek, Write},
    path::{Path, PathBuf},
};

const SPS: u8 = 7;
const PPS: u8 = 8;
const KEY: u8 = 5;

/// Takes access units in order. They wait in a nameless temporary file until the index in front of them is known.
#[derive(Debug)]
pub struct Mp4Writer {
    path: PathBuf,
    size: ImageSize,
    fps: f64,
    waiting: PathBuf,
    data: BufWriter<File>,
    sps: Vec<u8>,
    pps: Vec<u8>,
    sample_sizes: Vec<u32>,
    key_samples: Vec<u32>,
}

impl Mp4Writer {
    /// A file of pictures of this size at this rate.
    ///
    /// # Errors
    /// When it cannot be created.
    pub fn create(path: &Path, size: ImageSize, fps: f64) -> Result<Self, DatasetError> {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let waiting = path.with_file_name(format!(".{name}.samples.tmp"));
        let file = File::options().read(true).write(true).create(true).truncate(true).open(&waiting);
        let file = file.map_err(|e| DatasetError::io("cannot write", path, e))?;
        Ok(Self {
            path: path.to_owned(),
            size,
            fps,
            waiting,
            data: BufWriter::new(file),
            sps: Vec::new(),
            pps: Vec::new(),
            sample_sizes: Vec::new(),
            key_samples: Vec::new(),
        })
    }

    /// Appends one picture, as an Annex B access unit.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn push(&mut self, access_unit: &[u8]) -> Result<(), DatasetError> {
        let mut length = 0;
        let mut key = false;
        for unit in nal_units(access_unit) {
            match unit[0] & 0x1f {
                SPS => self.sps = unit.to_vec(),
                PPS => self.pps = unit.to_vec(),
                kind => {
                    key |= kind == KEY;
                    length += 4 + unit.len() as u32;
                    let written = self.data.write_all(&(unit.len() as u32).to_be_bytes());
                    written.and_then(|()| self.data.write_all(unit)).map_err(|e| self.failed(e))?;
                }
            }
        }
        self.sample_sizes.push(length);
        if key {
            self.key_samples.push(self.sample_sizes.len() as u32);
        }
        Ok(())
    }

    /// Puts the index in front and gives the file its name.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn finish(mut self) -> Result<(), DatasetError> {
        self.data.flush().and_then(|()| self.data.rewind()).map_err(|e| self.failed(e))?;
        let length: u64 = self.sample_sizes.iter().map(|s| u64::from(*s)).sum();
        let track = Track {
            size: self.size,
            fps: self.fps,
            sps: &self.sps,
            pps: &self.pps,
            sample_sizes: &self.sample_sizes,
            key_samples: &self.key_samples,
        };
        let (head, data_head) = (file_type(), data_head(length));
        // The index is as long whatever offset it holds.
        let before_data = head.len() + movie(&track, 0).len() + data_head.len();
        let mut file = AtomicFile::create(&self.path)?;
        file.write(&head)?;
        file.write(&movie(&track, before_data as u32))?;
        file.write(&data_head)?;
        let mut piece = vec![0; 1 << 16];
        loop {
            let count = self.data.get_mut().read(&mut piece).map_err(|e| self.failed(e))?;
            if count == 0 {
                return file.finish();
            }
            file.write(&piece[..count])?;
        }
    }

    fn failed(&self, source: io::Error) -> DatasetError {
        DatasetError::io("cannot write", &self.path, source)
    }
}

impl Drop for Mp4Writer {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.waiting);
    }
}
