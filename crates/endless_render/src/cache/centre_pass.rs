//! The rays through the centres of all pixels, and from there to the sun: 32 pixels at a time, of which those on one
//! triangle have their normals found together.

use super::bake_pass::BakePass;
use super::block_hits::BlockHits;
use super::centre_band::{CentreBand, Centres, SunBits};
use super::faint_ends::is_plain;
use super::packed_hit::PackedHit;
use super::primary_hits::PackedNormals;
use super::sparse_centre::{Centre, FIRST, ROWS, SunSeen};
use super::sun_bundle::SunBundle;
use super::sun_rays::LitPlaces;
use crate::accel::{RayStream, lanes};
use crate::camera_rays::{aims8, set_row};
use crate::octahedron::pack8;
use crate::scene::{Normals8, TriangleNormals};
use crate::vec3x8::{Vec3x8, splat};
use endless_scene::Surface;
use rayon::prelude::*;
use wide::f32x8;

impl BakePass<'_> {
    /// What the centres of all pixels show.
    pub(super) fn trace_centres(&self) -> Centres {
        let (width, height) = (self.width(), self.camera.size.height as usize);
        let bands = (0..height.div_ceil(ROWS)).into_par_iter().with_max_len(1).map(|band| {
            let y = ROWS * band;
            let mut band = CentreBand::of_sky(width, (height - y).min(ROWS));
            (0..width.div_ceil(8)).for_each(|block| self.trace_block(y, block, &mut band));
            band
        });
        Centres { width, height, bands: bands.collect() }
    }

    /// Up to eight columns of a band of rows, the first of which is given.
    fn trace_block(&self, y: usize, block: usize, band: &mut CentreBand) {
        let (width, first) = (self.width(), 8 * block);
        let (rows, columns) = (band.centres.len() / width, (width - first).min(8));
        let mut rays = RayStream::<ROWS>::NONE;
        rays.tmax = [f32x8::splat(f32::MAX); ROWS];
        for row in 0..rows {
            let (x0, x1) = (first as u32, (first + columns) as u32);
            set_row(self.camera, &mut rays, row, aims8(self.camera, x0, x1, (y + row) as u32, 0));
        }
        let own = ((1u16 << columns) - 1) as u8;
        let active = (0..rows).fold(0u32, |bits, row| bits | u32::from(own) << (8 * row));
        let hits = BlockHits::new(&self.tracer.still.accel.closest32(&rays, active), active);
        let sun = self.tracer.environment.sun.as_ref();
        let mut sun = sun.map(|sun| (SunBundle::new(sun), splat(sun.disc[0][FIRST])));
        let mut left = hits.met;
        while left != 0 {
            let alike = hits.on_triangle_of_first(left);
            left &= !alike;
            self.look_at_triangle(&rays, &hits, alike, sun.as_mut(), |row, column, centre| {
                band.centres[row * width + first + column] = centre;
            });
        }
        let Some((sun, _)) = sun else { return };
        let lit = sun.lit(&self.tracer.still.accel);
        for lane in lanes(sun.asked) {
            let seen = if lit >> lane & 1 == 1 { SunSeen::Lit } else { SunSeen::Shaded };
            band.centres[lane / 8 * width + first + lane % 8].sun = seen;
        }
        let (lit, shaded) = (lit.to_le_bytes(), (sun.asked & !lit).to_le_bytes());
        for row in 0..rows {
            band.sun[row * width.div_ceil(8) + block] = SunBits { lit: lit[row], shaded: shaded[row] };
        }
    }

    /// Tells by row and column what those lanes show that all met one triangle, and has them ask for the sun.
    fn look_at_triangle(
        &self,
        rays: &RayStream<ROWS>,
        hits: &BlockHits,
        alike: u32,
        mut sun: Option<&mut (SunBundle<'_>, Vec3x8)>,
        mut tell: impl FnMut(usize, usize, Centre),
    ) {
        let instances = &self.tracer.still.instances;
        let (instance, triangle) = hits.triangle(alike.trailing_zeros() as usize);
        let (material, kind) = instances[instance as usize].material_of(triangle);
        let is_lens = matches!(kind.surface, Surface::SignalLens(_));
        let is_leaf = kind.surface == Surface::Foliage;
        let is_plain = is_plain(kind.surface);
        let normals = TriangleNormals::new(&instances[instance as usize], triangle);
        for (row, own) in alike.to_le_bytes().into_iter().enumerate().filter(|(_, own)| *own != 0) {
            let (distances, weights) = (hits.distances[row], hits.weights[row]);
            let Normals8 { geometric, shading, .. } = normals.at(&rays.direction.map(|axis| axis[row]), weights);
            if let Some((sun, directions)) = &mut sun {
                let positions = rays.places(row, distances);
                let is_leaf = if is_leaf { u32::MAX } else { 0 };
                let lit = LitPlaces { positions, normals: geometric, distances, is_leaf };
                sun.ask(row, own.into(), &lit, directions);
            }
            let [second, third] = weights.map(PackedHit::weights8);
            let (geometric, shading, distances) = (pack8(&geometric), pack8(&shading), distances.to_array());
            for lane in lanes(own.into()) {
                let hit = PackedHit::of(instance, triangle, [second[lane], third[lane]]);
                let normals = PackedNormals { geometric: geometric[lane], shading: shading[lane] };
                let distance = distances[lane];
                let sun = SunSeen::Never;
                tell(row, lane, Centre { distance, hit, normals, material, is_lens, is_leaf, is_plain, sun });
            }
        }
    }
}
