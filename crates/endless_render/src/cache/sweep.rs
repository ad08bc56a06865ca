//! Light of vehicle lamps that sweeps the static scene.

use super::gbuffer_shading::gbuffer_bsdf;
use super::pixel_centre::{BLOCK, CentreBlock, PixelCentre};
use super::tile::Bounds3;
use super::tile_context::{PixelSamples, TileContext};
use super::tile_work::BeamSweep;
use crate::accel::{Ray, RayStream};
use crate::light::VehicleBeam;
use crate::material::{Bsdf, Bsdf8};
use crate::sampling::SAMPLES;
use crate::scene::{FrameScene, ShadingPoint, SurfaceInteraction};
use crate::shade::Tracer;
use crate::vec3x8::{Vec3x8, normalize};
use endless_world::PinholeCamera;
use glam::Vec3A;
use std::cell::OnceCell;
use wide::f32x8;

/// Illuminance, dimmed by the air before it, below which a vehicle light is not seen, klx.
const UNSEEN_KLX: f32 = 8.0e-4;

/// Light of vehicle lamps on those samples of a pixel that nothing that moves covers, fog included: the sum.
pub(super) fn beams_on_samples(context: &TileContext<'_>, samples: &PixelSamples<'_>) -> Vec3A {
    let TileContext { tracer, frame, work, pixel_angle } = *context;
    let PixelSamples { rays, still, found } = *samples;
    if work.beams.is_empty() {
        return Vec3A::ZERO;
    }
    let open = |s: usize| found.primary[s].is_none() && !still.is_sky(s);
    let facets: [Option<ShadingPoint>; SAMPLES] = std::array::from_fn(|s| open(s).then(|| still.facet(&rays[s], s)));
    let transmittance = facets.map(|f| f.map_or(0.0, |f| seen_through(tracer, rays[0].origin, &f)));
    let mut bsdfs: [Option<Bsdf>; SAMPLES] = [const { None }; SAMPLES];
    let mut sums = [Vec3A::ZERO; SAMPLES];
    for sweep in &work.beams {
        let beam = &frame.beams[usize::from(sweep.beam)];
        let mut arriving = [(Vec3A::ZERO, Vec3A::Z); SAMPLES];
        let mut active = 0u8;
        for (s, facet) in facets.iter().enumerate() {
            let Some(facet) = facet else { continue };
            arriving[s] = beam.illuminance_at(facet.position);
            let (illuminance, direction) = arriving[s];
            let lit = illuminance.x * transmittance[s] > UNSEEN_KLX && facet.geometric_normal.dot(direction) > 0.0;
            active |= u8::from(lit) << s;
        }
        if active == 0 {
            continue;
        }
        let asks = |s: usize| facets.get(s).copied().flatten().map_or(Vec3A::ZERO, |facet| facet.ray_origin());
        let to_lamp: [Ray; 8] = std::array::from_fn(|s| beam.shadow_ray(asks(s)));
        let hidden = match sweep.crossed {
            true => tracer.occluded8(&to_lamp, active),
            false => tracer.still.accel.occluded8(&to_lamp, active),
        };
        active &= !hidden;
        for s in (0..SAMPLES).filter(|s| active >> s & 1 == 1) {
            let Some(hit) = still.hit(s) else { continue };
            let bsdf = bsdfs[s].get_or_insert_with(|| {
                let point = SurfaceInteraction::new(&tracer.still.instances, &rays[s], &hit);
                gbuffer_bsdf(&point, tracer.environment, s, pixel_angle)
            });
            let (illuminance, direction) = arriving[s];
            sums[s] += bsdf.lit_by(illuminance, direction, -rays[s].direction);
        }
    }
    (0..SAMPLES).map(|s| sums[s] * transmittance[s]).sum()
}

/// Share of light from a surface that comes through the air to `eye`.
fn seen_through(tracer: &Tracer<'_>, eye: Vec3A, facet: &ShadingPoint) -> f32 {
    tracer.environment.fog.transmittance(eye, facet.direction, facet.distance)
}

/// The same for the centres of a block of pixels, as a camera sees them: rays to one lamp are traced together. They leave
/// from `origins`.
pub(super) fn beams_on_block(
    tracer: &Tracer<'_>,
    frame: &FrameScene,
    beams: &[BeamSweep],
    camera: &PinholeCamera,
    block: &CentreBlock<'_>,
    origins: &RayStream<4>,
) -> [Vec3A; BLOCK] {
    let mut rows: [SweptRow<'_, '_>; 4] = std::array::from_fn(|row| SweptRow::new(&block[8 * row..][..8]));
    let mut rays = origins.clone();
    let mut points = Bounds3::EMPTY;
    block.iter().flatten().for_each(|place| points.add(place.facet.position));
    for sweep in beams {
        let beam = &frame.beams[usize::from(sweep.beam)];
        if !beam.reaches(points.low - 1e-3, points.high + 1e-3) {
            continue;
        }
        let strengths = rows.each_mut().map(|row| row.strengths(tracer, beam, camera));
        let lit = strengths.map(|(_, lit)| lit);
        let active = u32::from_le_bytes(lit);
        if active == 0 {
            continue;
        }
        rays.aim_at(beam.position);
        let hidden = match sweep.crossed {
            true => tracer.occluded32(&rays, active),
            false => tracer.still.accel.occluded32(&rays, active),
        };
        let open = (active & !hidden).to_le_bytes();
        for ((row, (strengths, _)), open) in rows.iter_mut().zip(strengths).zip(open).filter(|(_, open)| *open != 0) {
            row.add(beam, &strengths, open);
        }
    }
    let rows = rows.map(|row| row.light());
    std::array::from_fn(|i| rows[i / 8][i % 8])
}

/// Eight neighbouring pixels, and the light that has been summed for them. What few rows need is found when it is asked.
struct SweptRow<'b, 'a> {
    row: &'b [Option<PixelCentre<'a>>],
    positions: Vec3x8,
    transmittance: OnceCell<[f32; 8]>,
    bsdfs: OnceCell<Bsdf8>,
    sums: Vec3x8,
    shown: bool,
}

impl<'b, 'a> SweptRow<'b, 'a> {
    fn new(row: &'b [Option<PixelCentre<'a>>]) -> Self {
        let axis = |axis: usize| f32x8::new(std::array::from_fn(|i| row[i].map_or(0.0, |p| p.facet.position[axis])));
        let positions = [axis(0), axis(1), axis(2)];
        let (transmittance, bsdfs) = (OnceCell::new(), OnceCell::new());
        Self { row, positions, transmittance, bsdfs, sums: [f32x8::ZERO; 3], shown: false }
    }

    /// How strongly a lamp lights each pixel, and where that can be seen, a bit each.
    fn strengths(&self, tracer: &Tracer<'_>, beam: &VehicleBeam, camera: &PinholeCamera) -> ([f32; 8], u8) {
        let strengths = beam.strengths_at(self.positions);
        let mut lit = 0u8;
        for (i, place) in self.row.iter().enumerate() {
            let Some(PixelCentre { facet, .. }) = place else { continue };
            let shows = strengths[i] > UNSEEN_KLX
                && facet.geometric_normal.dot(beam.position - facet.position) > 0.0
                && strengths[i] * self.transmittance(tracer, camera)[i] > UNSEEN_KLX;
            lit |= u8::from(shows) << i;
        }
        (strengths, lit)
    }

    fn transmittance(&self, tracer: &Tracer<'_>, camera: &PinholeCamera) -> &[f32; 8] {
        self.transmittance.get_or_init(|| {
            let eye = |facet: &ShadingPoint| Vec3A::from(camera.eye_for(facet.position.into()));
            let through = |place: PixelCentre<'_>| seen_through(tracer, eye(&place.facet), &place.facet);
            std::array::from_fn(|i| self.row[i].map_or(0.0, through))
        })
    }

    /// Adds a lamp's light on the open pixels.
    fn add(&mut self, beam: &VehicleBeam, strengths: &[f32; 8], open: u8) {
        let bsdfs = self.bsdfs.get_or_init(|| {
            let seen = |place: &Option<PixelCentre<'a>>| place.and_then(|p| Some((p.bsdf?.get(), -p.facet.direction)));
            let seen: [_; 8] = std::array::from_fn(|i| seen(&self.row[i]));
            Bsdf8::new(&seen.each_ref().map(|seen| seen.as_ref().map(|(bsdf, view)| (bsdf, *view))))
        });
        let arriving = f32x8::new(std::array::from_fn(|i| if open >> i & 1 == 1 { strengths[i] } else { 0.0 }));
        let to_lamp = normalize([0, 1, 2].map(|k| f32x8::splat(beam.position[k]) - self.positions[k]));
        let lit = bsdfs.lit_by(&to_lamp);
        for k in 0..3 {
            self.sums[k] += lit[k] * arriving * f32x8::splat(beam.color()[k]);
        }
        self.shown = true;
    }

    /// The sum, as it is seen through the air.
    fn light(&self) -> [Vec3A; 8] {
        let Some(transmittance) = self.transmittance.get().filter(|_| self.shown) else { return [Vec3A::ZERO; 8] };
        let [x, y, z] = self.sums.map(f32x8::to_array);
        std::array::from_fn(|i| Vec3A::new(x[i], y[i], z[i]) * transmittance[i])
    }
}
