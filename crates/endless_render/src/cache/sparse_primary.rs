//! The first pass of a bake for one instant: all samples are traced only where that tells anything.
//!
//! Where the centre of a pixel and that of the neighbour towards which a sample lies are on one flat piece of one surface, so
//! is the sample: it is known without a ray. The sun's disc is asked by up to eight rays a pixel near the edges of shadows, by one
//! a sample among leaves there, and by one a pixel everywhere else.
//!
//! ```text
//! centres of all pixels ──► where surfaces end ──► samples that are not known
//!                      └──► where shadows end  ──► the rest of the sun's disc
//! ```

use super::bake_pass::BakePass;
use super::bake_stats::timed;
use super::centre_band::Centres;
use super::faint_ends::DayLight;
use super::primary_hits::RowSurfaces;
use super::shadow_edges::ShadowEdges;
use super::sparse_row::SparseRow;
use super::surface_ends::SurfaceEnds;
use crate::sampling::SAMPLES;
use crate::settings::PixelSamples;

impl BakePass<'_> {
    /// What can be told before any row is looked at alone.
    pub(super) fn trace_sparse(&self) -> SparsePrimary<'_> {
        let centres = timed("centres", || self.trace_centres());
        let light = DayLight::of(self.tracer.environment);
        let edges = (self.settings.samples == PixelSamples::Four).then(|| Edges {
            surfaces: timed("ends of surfaces", || SurfaceEnds::new(self.camera, &centres, light.as_ref())),
            shadows: timed("ends of shadows", || ShadowEdges::new(&centres, self.pixel_angle)),
        });
        self.stats.add(self.camera.size.pixels() as u64 * 2);
        SparsePrimary { pass: self, centres, edges }
    }
}

/// The centres of all pixels, and around which of them more must be traced.
pub(super) struct SparsePrimary<'a> {
    pass: &'a BakePass<'a>,
    centres: Centres,
    /// None where the centres of pixels tell all.
    edges: Option<Edges>,
}

/// Around which pixels' centres more must be traced.
struct Edges {
    surfaces: SurfaceEnds,
    shadows: ShadowEdges,
}

/// What is kept of a row of [`PrimaryHits`](super::primary_hits::PrimaryHits): nothing seen yet.
pub(super) struct KeptRow<'a> {
    pub(super) distances: &'a mut [[f32; SAMPLES]],
    pub(super) sun_free: &'a mut [[u8; SAMPLES]],
    pub(super) uniform: &'a mut [bool],
}

impl SparsePrimary<'_> {
    /// What [`BakePass::trace`] finds in a row, by fewer rays. Of the surfaces of uniform pixels it tells those of the centres.
    pub(super) fn trace_row(&self, y: usize, kept: KeptRow<'_>) -> RowSurfaces {
        let mut surfaces = RowSurfaces::nothing(self.pass.width());
        let (hits, normals) = (&mut surfaces.hits[..], &mut surfaces.normals[..]);
        let centres = self.centres.row(y);
        let edges = self.edges.as_ref().map(|edges| edges.shadows.row(y));
        let KeptRow { distances, sun_free, uniform } = kept;
        let row_at = |y: usize| (y < self.centres.height).then(|| self.centres.row(y));
        let beside = [y.checked_sub(1).and_then(row_at), row_at(y + 1)];
        let mut row =
            SparseRow { pass: self.pass, y, centres, beside, edges, distances, hits, normals, sun_free, uniform };
        row.fill(|x| self.edges.as_ref().map_or([true; SAMPLES], |edges| edges.surfaces.known(x, y)));
        surfaces
    }
}
