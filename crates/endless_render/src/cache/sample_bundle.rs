//! Samples between the centres of pixels that must be traced: 32 at a time, looked at eight by eight.

use super::bake_pass::BakePass;
use super::packed_hit::PackedHit;
use super::pieces8::Pieces8;
use super::primary_hits::PackedNormals;
use super::sparse_centre::{Centre, ROWS, SunSeen};
use super::sun_rays::{LitPlaces, faces8};
use crate::accel::{Hit, Ray, RayStream, StreamHits, lanes};
use crate::light::Sun;
use crate::octahedron::{self, pack8, unpack8};
use crate::scene::{Instance, normals_of_hits};
use crate::vec3x8::lane_of;
use endless_scene::Surface;
use glam::Vec3A;
use wide::f32x8;

/// How many go together.
const LANES: usize = 8 * ROWS;

/// Samples of a row that wait for their rays.
pub(super) struct SampleBundle {
    rays: RayStream<ROWS>,
    /// Pixel of the row, and sample.
    places: [(usize, usize); LANES],
    /// Where the centres of their pixels lie.
    centres: [[f32x8; ROWS]; 3],
    count: usize,
}

/// What is known of the row's pixels.
#[derive(Clone, Copy)]
pub(super) struct RowCentres<'a> {
    pub(super) centres: &'a [Centre],
    /// Of the rows above and below, if there are such.
    pub(super) beside: [Option<&'a [Centre]>; 2],
    /// Which are near the edge of a shadow, of eight that follow each other a bit each.
    pub(super) edges: &'a [u8],
}

impl<'a> RowCentres<'a> {
    /// The centre of the neighbour towards which a sample of a pixel lies.
    fn towards(&self, x: usize, sample: usize) -> Option<&'a Centre> {
        let [above, below] = self.beside;
        match sample {
            1 => self.centres.get(x + 1),
            2 => below.map(|row| &row[x]),
            _ => above.map(|row| &row[x]),
        }
    }
}

/// What eight samples met: where it was nothing, what one of the others met.
struct Hits8 {
    hits: [Hit; 8],
    /// Those that met anything, a bit each.
    met: u32,
}

/// What a sample sees.
#[derive(Clone, Copy)]
pub(super) struct SampleSeen {
    pub(super) distance: f32,
    pub(super) hit: PackedHit,
    pub(super) normals: PackedNormals,
    /// It lies on the flat piece of its pixel's centre.
    pub(super) goes_on: bool,
    /// From where a ray tells whether it sees the sun; none where its pixel tells that, now or later, or a neighbour.
    pub(super) asks_sun_from: Option<Vec3A>,
    /// Whether it sees the sun, if a neighbour tells that.
    pub(super) is_lit_as_beside: Option<bool>,
}

impl SampleSeen {
    const NOTHING: Self = Self {
        distance: f32::MAX,
        hit: PackedHit::NONE,
        normals: PackedNormals::NONE,
        goes_on: false,
        asks_sun_from: None,
        is_lit_as_beside: None,
    };
}

impl SampleBundle {
    pub(super) fn none() -> Self {
        Self { rays: RayStream::NONE, places: [(0, 0); LANES], centres: [[f32x8::ZERO; ROWS]; 3], count: 0 }
    }

    pub(super) fn is_full(&self) -> bool {
        self.count == LANES
    }

    /// Adds a sample of a pixel whose centre lies at `centre`.
    pub(super) fn push(&mut self, place: (usize, usize), ray: &Ray, centre: Vec3A) {
        self.rays.set(self.count, ray);
        let (row, column) = (self.count / 8, self.count % 8);
        for (all, own) in self.centres.iter_mut().zip(centre.to_array()) {
            all[row].as_mut_array()[column] = own;
        }
        self.places[self.count] = place;
        self.count += 1;
    }

    /// Traces them all and tells by pixel and sample what each sees, if anything.
    pub(super) fn trace(
        &mut self,
        pass: &BakePass<'_>,
        known: RowCentres<'_>,
        mut tell: impl FnMut(usize, usize, Option<&SampleSeen>),
    ) {
        let count = std::mem::take(&mut self.count);
        if count == 0 {
            return;
        }
        let still = pass.tracer.still;
        let found = still.accel.closest_by_rows(&self.rays, ((1u64 << count) - 1) as u32);
        let sun = pass.tracer.environment.sun.as_ref();
        let (mut seen, mut met) = ([SampleSeen::NOTHING; LANES], 0);
        for (row, seen) in seen.as_chunks_mut().0.iter_mut().enumerate() {
            let Some(hits) = Hits8::new(&found, row) else { continue };
            met |= hits.met << (8 * row);
            self.look_at(row, &hits, &still.instances, known, sun, seen);
        }
        for (lane, (&(x, sample), seen)) in self.places[..count].iter().zip(&seen).enumerate() {
            tell(x, sample, (met >> lane & 1 == 1).then_some(seen));
        }
    }

    /// Tells what eight of them see, and which must ask for the sun.
    fn look_at(
        &self,
        row: usize,
        Hits8 { hits, met }: &Hits8,
        instances: &[Instance],
        known: RowCentres<'_>,
        sun: Option<&Sun>,
        seen: &mut [SampleSeen; 8],
    ) {
        let RowCentres { centres, edges, .. } = known;
        let places = &self.places[8 * row..][..8];
        let normals = normals_of_hits(instances, hits, &self.rays.direction.map(|axis| axis[row]));
        let distances = f32x8::new(hits.map(|hit| hit.t));
        let positions = self.rays.places(row, distances);
        let (geometric, shading) = (pack8(&normals.geometric), pack8(&normals.shading));
        let second = PackedHit::weights8(f32x8::new(hits.map(|hit| hit.u)));
        let third = PackedHit::weights8(f32x8::new(hits.map(|hit| hit.v)));
        let (mut is_leaf, mut may_go_on, mut by_leaf) = (0, 0, 0);
        let (mut by_light, mut by_shade, mut by_edge) = (0, 0, 0);
        for (lane, (hit, seen)) in hits.iter().zip(seen.iter_mut()).enumerate() {
            let (x, centre) = (places[lane].0, &centres[places[lane].0]);
            let (material, kind) = instances[hit.instance as usize].material_of(hit.triangle);
            seen.distance = hit.t;
            seen.hit = PackedHit::of(hit.instance, hit.triangle, [second[lane], third[lane]]);
            seen.normals = PackedNormals { geometric: geometric[lane], shading: shading[lane] };
            is_leaf |= u32::from(kind.surface == Surface::Foliage) << lane;
            may_go_on |= u32::from(centre.may_continue(&seen.hit, material)) << lane;
            by_light |= u32::from(centre.sun == SunSeen::Lit) << lane;
            by_shade |= u32::from(centre.sun == SunSeen::Shaded) << lane;
            by_edge |= u32::from(edges[x / 8] >> (x % 8) & 1) << lane;
            by_leaf |= u32::from(centre.is_leaf) << lane;
        }
        let by_centre: [PackedNormals; 8] = std::array::from_fn(|lane| centres[places[lane].0].normals);
        let by_centre_geometric = unpack8(&by_centre.map(|normals| normals.geometric));
        if let Some(sun) = sun {
            // Far from shadows' edges those count as lit whose pixel's centre is lit, and as shaded whose centre is shaded,
            // whatever the ray would say. Near them, those that face the sun ask its whole disc later, but for pixels of
            // leaves, where a ray a sample does.
            let later = by_edge & !by_leaf & faces8(&by_centre_geometric, sun) & faces8(&unpack8(&geometric), sun);
            let as_centre = by_light & !(by_edge & by_leaf) | by_shade & !by_edge;
            let lit = LitPlaces { positions, normals: normals.geometric, distances, is_leaf };
            let mut asking = met & !as_centre & !later & lit.can_be_lit_by(sun);
            // Among leaves of one plant light and shade mix everywhere alike.
            for lane in lanes(asking & is_leaf) {
                let (x, sample) = places[lane];
                let asked = |centre: &&Centre| {
                    centre.is_leaf && centre.sun != SunSeen::Never && centre.hit.is_on_instance_of(&seen[lane].hit)
                };
                let beside = known.towards(x, sample).filter(asked).or(Some(&centres[x]).filter(asked));
                if let Some(beside) = beside {
                    seen[lane].is_lit_as_beside = Some(beside.sun == SunSeen::Lit);
                    asking &= !(1 << lane);
                }
            }
            // A surface that goes on to the neighbour's centre is lit as it is there.
            for lane in lanes(asking & !is_leaf) {
                let (x, sample) = places[lane];
                let Some(beside) = known.towards(x, sample).filter(|beside| beside.sun != SunSeen::Never) else {
                    continue;
                };
                let (material, _) = instances[hits[lane].instance as usize].material_of(hits[lane].triangle);
                let normal = octahedron::unpack(beside.normals.geometric);
                if beside.may_continue(&seen[lane].hit, material) && normal.dot(lane_of(&normals.geometric, lane)) > 0.9
                {
                    seen[lane].is_lit_as_beside = Some(beside.sun == SunSeen::Lit);
                    asking &= !(1 << lane);
                }
            }
            if asking != 0 {
                let origins = lit.ray_origins(sun);
                lanes(asking).for_each(|lane| seen[lane].asks_sun_from = Some(lane_of(&origins, lane)));
            }
        }
        if may_go_on & met != 0 {
            let own = Pieces8 {
                positions: self.centres.map(|axis| axis[row]),
                geometric: by_centre_geometric,
                shading: unpack8(&by_centre.map(|normals| normals.shading)),
            };
            let others = Pieces8 { positions, geometric: normals.geometric, shading: unpack8(&shading) };
            let goes_on = may_go_on & u32::from(own.go_on_in(&others));
            for (lane, seen) in seen.iter_mut().enumerate() {
                seen.goes_on = goes_on >> lane & 1 == 1;
            }
        }
    }
}

impl Hits8 {
    /// Of a row of rays; `None` if none met anything.
    fn new(found: &StreamHits<ROWS>, row: usize) -> Option<Self> {
        let hits: [Option<Hit>; 8] = std::array::from_fn(|lane| found.get(8 * row + lane));
        let first = hits.into_iter().flatten().next()?;
        let met = hits.iter().enumerate().fold(0, |bits, (lane, hit)| bits | u32::from(hit.is_some()) << lane);
        Some(Self { hits: hits.map(|hit| hit.unwrap_or(first)), met })
    }
}
