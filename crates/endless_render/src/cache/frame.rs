//! One frame: the still picture with everything that moves.

use super::affected::{Work, affected};
use super::bake::{CameraBake, planar_depth, still_sample};
use super::canvas::{Canvas, Pixel};
use super::centre::{CentreLight, Place, centre_lights};
use super::compose::{compose, sun_can_light, sun_origin};
use super::cover::Cover;
use super::covers::{Touched, covers};
use super::mirror::{Mirrored, mirrored, mirrored_row};
use super::row::{Found, Row};
use super::still_pixel::StillPixel;
use super::still_sample::{StillSample, share_lamp_light, still_light, still_look};
use super::sweep::beams_on_samples;
use super::tile::TILE;
use crate::accel::Ray;
use crate::film::{LEAST_PX, Streak};
use crate::light::HaloGrid;
use crate::sampling::SAMPLES;
use crate::scene::{FrameScene, StaticScene, SurfacePoint};
use crate::shade::{Seen, Tracer, shade_moving, shade_moving_together};
use endless_world::SensorFrame;
use glam::{Vec2, Vec3A};

impl CameraBake {
    /// What the camera sees at an instant.
    pub fn render(&self, still: &StaticScene, frame: &FrameScene) -> SensorFrame {
        let tracer = self.tracer(still, frame);
        let mut canvas = Canvas::new(self);
        let mut rows: Vec<Row<'_>> = (0..TILE).map(|_| Row::new(self)).collect();
        let mut traced = 0;
        for (tile, work) in affected(self, still, frame).iter().enumerate() {
            if !work.is_none() {
                traced += self.render_tile(&tracer, frame, work, tile as u32, &mut rows, &mut canvas);
            }
        }
        self.stats.add(traced);
        canvas.develop(self, frame.frame)
    }

    /// The same without the cache: every sample traced and shaded again, every moving thing asked everywhere. Slow; the
    /// oracle of [`Self::render`]. Needs [`super::RenderSettings::keep_irradiance`].
    ///
    /// # Panics
    /// If the bake did not keep its irradiance.
    pub fn render_uncached(&self, still: &StaticScene, frame: &FrameScene) -> SensorFrame {
        assert_eq!(self.irradiance.len(), self.samples.len(), "the bake kept no irradiance");
        let tracer = self.tracer(still, frame);
        let everything = Work::everything(self.environment.night, still, frame);
        let mut canvas = Canvas::new(self);
        for y0 in (0..self.camera.size.height).step_by(TILE as usize) {
            for x0 in (0..self.camera.size.width).step_by(TILE as usize) {
                self.retrace_tile(&tracer, frame, &everything, (x0, y0), &mut canvas);
            }
        }
        canvas.develop(self, frame.frame)
    }

    fn tracer<'a>(&'a self, still: &'a StaticScene, frame: &'a FrameScene) -> Tracer<'a> {
        Tracer {
            still,
            moving: Some(frame),
            environment: &self.environment,
            lamp_maps: &self.lamp_maps,
            probes: Some(&self.probes),
        }
    }

    /// A still sample from nothing but the scene and the baked irradiance.
    fn retrace(&self, tracer: &Tracer<'_>, x: u32, y: u32, sample: usize) -> StillSample {
        let ray = self.ray(x, y, sample);
        let hit = tracer.still.accel.closest(&ray);
        let mut sun_free = 0;
        if let (Some(hit), Some(sun)) = (&hit, &self.environment.sun) {
            let point = SurfacePoint::new(&tracer.still.instances, &ray, hit);
            if sun_can_light(&point, sun.direction) {
                let origin = sun_origin(&point.facet(), sun.direction);
                for (bit, &direction) in sun.disc[sample].iter().enumerate() {
                    let free = !tracer.still.accel.occluded(&Ray { origin, direction, tmax: f32::MAX });
                    sun_free |= u8::from(free) << bit;
                }
            }
        }
        let index = (y as usize * self.camera.size.width as usize + x as usize) * SAMPLES + sample;
        let irradiance = Vec3A::from(self.irradiance[index]);
        still_sample(tracer, &ray, hit.as_ref(), sun_free, irradiance, sample, self.pixel_angle)
    }

    /// Renders a tile; returns about how many rays that took.
    fn render_tile<'a>(
        &'a self,
        tracer: &Tracer<'_>,
        frame: &FrameScene,
        work: &Work,
        tile: u32,
        rows: &mut [Row<'a>],
        canvas: &mut Canvas,
    ) -> u64 {
        let (x0, y0) = (tile % self.tile_columns * TILE, tile / self.tile_columns * TILE);
        let (x1, y1) = self.tile_end(x0, y0);
        let count = (x1 - x0) as usize;
        let mut rays = 0;
        for (y, row) in (y0..y1).zip(rows.iter_mut()) {
            let first = (y * self.camera.size.width + x0) as usize;
            let uniform = &self.uniform[first..first + count];
            row.aim(x0, x1, y, !work.asks_rays() && uniform.iter().all(|u| *u));
            rays += row.find(frame, work);
        }
        let rows = &rows[..(y1 - y0) as usize];
        let covered = rows.iter().enumerate().flat_map(|(y, row)| {
            let seen = (0..count).filter(|&x| row.found[x].seen.iter().any(Option::is_some));
            seen.map(move |x| Touched { place: y * TILE as usize + x, rays: row.rays(x), found: &row.found[x] })
        });
        let covers = covers(
            self,
            frame,
            covered,
            |seen| shade_moving_together(tracer, seen, self.pixel_angle),
            |place, seen| self.halo((x0, y0), place, seen),
        );
        for ((y, row), covers) in (y0..).zip(rows).zip(covers.chunks(TILE as usize)) {
            let found = &row.found;
            let same = |i: usize| work.only_found() && found[i].is_nothing();
            if (0..count).all(same) {
                continue;
            }
            let lights = self.centre_lights(tracer, frame, work, row, count, found);
            let mirrors = mirrored_row(tracer, row, self.pixel_angle);
            for x in x0..x1 {
                let i = (x - x0) as usize;
                if same(i) {
                    continue;
                }
                let index = row.pixel(i);
                let light = Some(&lights[i]).filter(|_| self.uniform[index]);
                if light.is_some_and(CentreLight::is_nothing) && found[i].is_nothing() {
                    continue;
                }
                let still = (self.radiance[index], Vec3A::from(self.ambient[index]));
                if let Some(radiance) = undisturbed(still, light, &found[i]) {
                    canvas.set(self, x, y, &Pixel { radiance, covered: None, streak: None });
                    continue;
                }
                let samples = &self.samples[index * SAMPLES..][..SAMPLES];
                let rays = row.rays(i);
                let pixel = self.pixel(tracer, frame, work, &rays, samples, light, &found[i], mirrors[i], &covers[i]);
                canvas.set(self, x, y, &pixel);
            }
        }
        rays
    }

    /// The same from nothing but the scene and the baked irradiance, a ray at a time.
    fn retrace_tile(
        &self,
        tracer: &Tracer<'_>,
        frame: &FrameScene,
        everything: &Work,
        (x0, y0): (u32, u32),
        canvas: &mut Canvas,
    ) {
        let empty = Tracer { moving: None, ..*tracer };
        let (x1, y1) = self.tile_end(x0, y0);
        let places = (y0..y1).flat_map(|y| (x0..x1).map(move |x| (x, y)));
        let pixels: Vec<_> = places
            .map(|(x, y)| {
                let uniform = self.uniform[(y * self.camera.size.width + x) as usize];
                let mut samples: [StillSample; SAMPLES] = std::array::from_fn(|s| self.retrace(&empty, x, y, s));
                if self.environment.night && uniform {
                    share_lamp_light(&mut samples);
                }
                let rays = std::array::from_fn(|s| self.ray(x, y, s));
                let found = Found::one_by_one(self, frame, &rays, &samples, uniform);
                (x, y, samples, rays, found)
            })
            .collect();
        let asked = pixels.iter().map(|(x, y, _, rays, found)| Touched {
            place: ((y - y0) * TILE + x - x0) as usize,
            rays: *rays,
            found,
        });
        let covers = covers(
            self,
            frame,
            asked,
            |seen| seen.iter().map(|seen| shade_moving(tracer, seen, self.pixel_angle)).collect(),
            |place, seen| self.halo((x0, y0), place, seen),
        );
        for (x, y, samples, rays, found) in &pixels {
            let (x, y) = (*x, *y);
            let light = self.retraced_centre(tracer, frame, everything, x, y, samples);
            let still = still_light(samples, &self.environment);
            let pixel = match undisturbed(still, light.as_ref(), found) {
                Some(radiance) => Pixel { radiance, covered: None, streak: None },
                None => {
                    let cover = &covers[((y - y0) * TILE + x - x0) as usize];
                    let mirrors = mirrored(tracer, samples, rays, found, self.pixel_angle);
                    self.pixel(tracer, frame, everything, rays, samples, light.as_ref(), found, mirrors, cover)
                }
            };
            canvas.set(self, x, y, &pixel);
        }
    }

    /// Where a tile ends in the picture.
    fn tile_end(&self, x0: u32, y0: u32) -> (u32, u32) {
        ((x0 + TILE).min(self.camera.size.width), (y0 + TILE).min(self.camera.size.height))
    }

    /// Glow of lamps in the air before something that moves, at a place of a tile.
    fn halo(&self, (x0, y0): (u32, u32), place: usize, seen: &Seen<'_>) -> Vec3A {
        let place = place as u32;
        let at = |halos: &HaloGrid| halos.at(x0 + place % TILE, y0 + place / TILE, seen.point.distance);
        self.halos.as_ref().map_or(Vec3A::ZERO, at)
    }

    /// The light that the samples of each uniform pixel of a row share; pixels that something that moves covers wholly
    /// are left out.
    fn centre_lights(
        &self,
        tracer: &Tracer<'_>,
        frame: &FrameScene,
        work: &Work,
        row: &Row<'_>,
        count: usize,
        found: &[Found; TILE as usize],
    ) -> [CentreLight; TILE as usize] {
        let places: [Option<Place<'_>>; TILE as usize] = std::array::from_fn(|i| {
            let index = row.pixel(i);
            if i >= count || !self.uniform[index] || found[i].seen.iter().all(Option::is_some) {
                return None;
            }
            Some(self.pixels[index].place(&row.ray(i, 0), self.looks.get(index)))
        });
        centre_lights(tracer, Vec3A::from(self.camera.position), frame, work, &places)
    }

    /// The same for one pixel, from nothing but its retraced centre.
    fn retraced_centre(
        &self,
        tracer: &Tracer<'_>,
        frame: &FrameScene,
        work: &Work,
        x: u32,
        y: u32,
        samples: &[StillSample; SAMPLES],
    ) -> Option<CentreLight> {
        if !self.uniform[(y * self.camera.size.width + x) as usize] {
            return None;
        }
        let ray = self.ray(x, y, 0);
        let point = SurfacePoint::new(&tracer.still.instances, &ray, &samples[0].hit);
        let look = still_look(&point, &self.environment, 0, self.pixel_angle);
        let mut row = [None; 8];
        row[0] = Some(StillPixel::new(samples).place(&ray, Some(&look).filter(|_| self.environment.night)));
        Some(centre_lights(tracer, Vec3A::from(self.camera.position), frame, work, &row)[0])
    }

    /// One pixel, given its still samples, the light that these share if it is uniform, what rays towards what moves
    /// found, what its mirrors show of that, and the light of what of that covers it.
    fn pixel(
        &self,
        tracer: &Tracer<'_>,
        frame: &FrameScene,
        work: &Work,
        rays: &[Ray; SAMPLES],
        samples: &[StillSample],
        centre: Option<&CentreLight>,
        found: &Found,
        mut mirrored: Mirrored,
        cover: &Cover,
    ) -> Pixel {
        if cover.samples == SAMPLES {
            let radiance = cover.light / SAMPLES as f32;
            let streak = self.streak(frame, &rays[0], found, cover.way, radiance, 1.0, radiance);
            return Pixel { radiance, covered: cover.centre, streak };
        }
        // The samples of a uniform pixel share what their mirrors show in pairs.
        if centre.is_some() {
            for s in (1..SAMPLES).step_by(2) {
                mirrored[s] = mirrored[s - 1].filter(|_| samples[s].mirrors());
            }
        }
        let mut sum = cover.light;
        let open = (0..SAMPLES).filter(|&s| found.seen[s].is_none());
        for s in open {
            let (still, ray) = (&samples[s], &rays[s]);
            let moving = (still.sun_free & !found.sun_blocked[s], mirrored[s]);
            sum += compose(tracer, frame, work, centre, still, moving, ray, s, self.pixel_angle);
        }
        if centre.is_none() {
            let open = std::array::from_fn(|s| found.seen[s].is_none());
            sum += beams_on_samples(tracer, frame, &work.beams, samples, open, rays, self.pixel_angle);
        }
        let uncovered = SAMPLES - cover.samples;
        let swept = centre.map_or(Vec3A::ZERO, |light| light.swept * (uncovered as f32 / SAMPLES as f32));
        let radiance = sum / SAMPLES as f32 + swept;
        let share = cover.samples as f32 / SAMPLES as f32;
        let light = cover.light / SAMPLES as f32;
        let streak = self.streak(frame, &rays[0], found, cover.way, light, share, radiance);
        Pixel { radiance, covered: cover.centre, streak }
    }

    /// What moves in a pixel, if it moves far enough to blur: its `light` covers a share of the pixel.
    fn streak(
        &self,
        frame: &FrameScene,
        ray: &Ray,
        found: &Found,
        way: Vec2,
        light: Vec3A,
        cover: f32,
        radiance: Vec3A,
    ) -> Option<Streak> {
        if way.length_squared() < LEAST_PX * LEAST_PX {
            return None;
        }
        let nearest = found.seen.iter().flatten().min_by(|a, b| a.t.total_cmp(&b.t))?;
        let behind = (cover < 1.0).then(|| (radiance - light) / (1.0 - cover));
        let id = frame.instances[nearest.instance as usize].id;
        Some(Streak { id, light, cover, behind, way, depth: planar_depth(&self.camera, ray, nearest.t) })
    }
}

/// Radiance of a uniform pixel towards which nothing that moves was found and whose lamps are all free, from that of
/// the still picture and its ambient part.
fn undisturbed((radiance, ambient): (Vec3A, Vec3A), light: Option<&CentreLight>, found: &Found) -> Option<Vec3A> {
    let light = light.filter(|light| light.direct.is_none() && found.is_nothing())?;
    Some(radiance + ambient * (light.contact - 1.0) + light.swept)
}
