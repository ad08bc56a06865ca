//! Writes what was traced, for other ray tracers (`scripts/compare_embree.sh`). Little endian, floats of 32 bits.
//!
//! ```text
//! TOWN.scene  number of meshes; of each: numbers of vertices and triangles, vertices (x y z), triangles (three indices)
//!             number of instances; of each: its mesh, the columns of world_from_object (four times x y z)
//! TOWN.rays   number of sets; of each: name (16 bytes), whether any hit is enough, rays that hit, own Mrays/s
//!             (single, packets, bundles), number of packets;
//!             of each packet: mask of its rays, then by eights origin x y z, direction x y z, farthest distance
//! ```

use super::town::{BenchTown, Packet};
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// One set of rays, and what was found with it here.
pub(crate) struct MeasuredSet<'a> {
    pub(crate) name: &'a str,
    /// Any hit is enough: the rays ask whether something is in the way.
    pub(crate) any_hit: bool,
    pub(crate) packets: &'a [Packet],
    /// Rays that hit.
    pub(crate) hits: usize,
    /// Million rays a second of all threads: single rays, packets, bundles.
    pub(crate) rates: [f64; 3],
}

/// Writes `TOWN.scene` into a folder.
pub(crate) fn write_scene(folder: &Path, name: &str, town: &BenchTown) -> io::Result<()> {
    let mut out = create(folder, &format!("{name}.scene"))?;
    word(&mut out, town.meshes.len())?;
    for mesh in &town.meshes {
        word(&mut out, mesh.positions.len())?;
        word(&mut out, mesh.triangles.len())?;
        floats(&mut out, mesh.positions.iter().flat_map(glam::Vec3::to_array))?;
        for index in mesh.triangles.as_flattened() {
            out.write_all(&index.to_le_bytes())?;
        }
    }
    word(&mut out, town.instances.len())?;
    for (mesh, world_from_object) in &town.instances {
        word(&mut out, *mesh)?;
        floats(&mut out, world_from_object.to_cols_array())?;
    }
    out.flush()
}

/// Writes `TOWN.rays` into a folder.
pub(crate) fn write_rays(folder: &Path, name: &str, sets: &[MeasuredSet<'_>]) -> io::Result<()> {
    let mut out = create(folder, &format!("{name}.rays"))?;
    word(&mut out, sets.len())?;
    for set in sets {
        let mut padded = [0u8; 16];
        padded[..set.name.len()].copy_from_slice(set.name.as_bytes());
        out.write_all(&padded)?;
        word(&mut out, usize::from(set.any_hit))?;
        word(&mut out, set.hits)?;
        floats(&mut out, set.rates.map(|rate| rate as f32))?;
        word(&mut out, set.packets.len())?;
        for (rays, active) in set.packets {
            word(&mut out, usize::from(*active))?;
            for axis in 0..3 {
                floats(&mut out, rays.each_ref().map(|ray| ray.origin[axis]))?;
            }
            for axis in 0..3 {
                floats(&mut out, rays.each_ref().map(|ray| ray.direction[axis]))?;
            }
            floats(&mut out, rays.each_ref().map(|ray| ray.tmax))?;
        }
    }
    out.flush()
}

fn create(folder: &Path, name: &str) -> io::Result<BufWriter<File>> {
    std::fs::create_dir_all(folder)?;
    File::create(folder.join(name)).map(BufWriter::new)
}

fn word(out: &mut impl Write, number: usize) -> io::Result<()> {
    let number = u32::try_from(number).map_err(io::Error::other)?;
    out.write_all(&number.to_le_bytes())
}

fn floats(out: &mut impl Write, numbers: impl IntoIterator<Item = f32>) -> io::Result<()> {
    numbers.into_iter().try_for_each(|number| out.write_all(&number.to_le_bytes()))
}
