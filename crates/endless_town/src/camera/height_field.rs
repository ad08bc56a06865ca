//! The town as a field of heights with a kind of ground in each cell: what rays of sight are tested against.

use super::raster::cells_in;
use crate::geometry::unit;
use endless_road::RoadNetwork;
use endless_scene::Mesh;
use endless_world::ClassTag;
use glam::{Affine3A, DVec2, Vec2, Vec3};
use rayon::prelude::*;
use std::borrow::Borrow;

/// What lies on top at a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum TopSurface {
    /// Outside the field.
    Beyond,
    /// Grass, earth, fields.
    Green,
    /// Yards and squares.
    Ground,
    /// Sidewalks.
    Walk,
    /// Asphalt outside junctions.
    Road,
    /// Asphalt inside junctions.
    Junction,
    /// Water.
    Water,
    /// A building, or a tree that was there before the cameras.
    Solid,
}

/// Most cells of a field; large towns get coarser ones.
const MOST_CELLS: f64 = 3.0e6;
/// Side of the finest cells, metres.
const FINEST_M: f64 = 0.5;
/// Ground around the road network that belongs to the field, metres.
const MARGIN_M: f64 = 45.0;

/// Heights and kinds on a grid.
#[derive(Debug, Clone)]
pub(crate) struct HeightField {
    low: Vec2,
    cell: f32,
    width: usize,
    height: usize,
    cells: Vec<(f32, TopSurface)>,
}

impl HeightField {
    /// Of a town's own meshes, with the junctions of its network.
    pub(crate) fn new<M: Borrow<Mesh> + Sync>(network: &RoadNetwork, meshes: &[(M, Affine3A)]) -> Self {
        let points = network.lanes.iter().flat_map(|l| l.centerline.points()).map(|p| p.truncate());
        let (low, high) =
            points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
        let (low, high) = if low.x <= high.x { (low, high) } else { (DVec2::ZERO, DVec2::ZERO) };
        let (low, high) = (low - MARGIN_M, high + MARGIN_M);
        let size = high - low;
        let cell = (size.x * size.y / MOST_CELLS).sqrt().max(FINEST_M);
        let (width, height) = ((size.x / cell).ceil() as usize, (size.y / cell).ceil() as usize);
        let mut cells = vec![(f32::MIN, TopSurface::Beyond); width * height];
        let mut relief = Self { low: low.as_vec2(), cell: cell as f32, width, height, cells: Vec::new() };
        // Each thread has some rows to itself, and looks at all meshes.
        let rows = height.div_ceil(rayon::current_num_threads());
        cells.par_chunks_mut((rows * width).max(1)).enumerate().for_each(|(i, cells)| {
            let mut band = HeightFieldRows { relief: &relief, first: i * rows, cells };
            meshes.iter().for_each(|(mesh, place)| band.lay(mesh.borrow(), *place));
        });
        relief.cells = cells;
        relief.mark_junctions(network);
        relief
    }

    fn mark_junctions(&mut self, network: &RoadNetwork) {
        for lane in network.lanes.iter().filter(|l| l.junction.is_some()) {
            let steps = lane.centerline.length().ceil() as usize;
            for i in 0..=steps {
                let place = lane.centerline.at(i as f64);
                let across = unit(place.heading_rad).perp();
                for k in -3..=3 {
                    let p = place.position.truncate() + across * (f64::from(k) * lane.width_m / 6.0);
                    if let Some(cell) = self.index(p.as_vec2()).map(|i| &mut self.cells[i])
                        && cell.1 == TopSurface::Road
                    {
                        cell.1 = TopSurface::Junction;
                    }
                }
            }
        }
    }

    /// A tree or another column that was there before: its crown hides what is behind.
    pub(crate) fn add_column(&mut self, at: DVec2, radius: f64, height: f32) {
        let n = (radius / f64::from(self.cell)).ceil() as i32;
        for dy in -n..=n {
            for dx in -n..=n {
                let step = DVec2::new(f64::from(dx), f64::from(dy)) * f64::from(self.cell);
                if step.length() <= radius
                    && let Some(i) = self.index((at + step).as_vec2())
                {
                    let ground = self.cells[i].0.max(-1000.0);
                    self.cells[i] = (ground + height, TopSurface::Solid);
                }
            }
        }
    }

    fn index(&self, p: Vec2) -> Option<usize> {
        let q = (p - self.low) / self.cell;
        let inside = q.x >= 0.0 && q.y >= 0.0 && q.x < self.width as f32 && q.y < self.height as f32;
        inside.then(|| q.y as usize * self.width + q.x as usize)
    }

    /// Height and kind at a place.
    pub(crate) fn at(&self, p: DVec2) -> (f32, TopSurface) {
        self.index(p.as_vec2()).map_or((f32::MIN, TopSurface::Beyond), |i| self.cells[i])
    }

    /// What a ray meets within `reach` metres: its distance and kind; `None` for the sky or the far hills.
    pub(crate) fn cast(&self, from: Vec3, direction: Vec3, reach: f32) -> Option<(f32, TopSurface)> {
        let mut t = 0.6;
        while t < reach {
            let p = from + direction * t;
            let (z, top) = self.cells[self.index(p.truncate())?];
            if p.z <= z {
                return Some((t, top));
            }
            t += 0.45 + 0.012 * t;
        }
        None
    }

    /// Whether a point can be seen: nothing rises above the line to it, but for the last metre.
    pub(crate) fn sees(&self, from: Vec3, to: Vec3) -> bool {
        let between = to - from;
        let length = between.length();
        let direction = between / length.max(1e-6);
        self.cast(from, direction, length - 1.0).is_none()
    }
}

/// Some rows of a field that is being made.
struct HeightFieldRows<'a> {
    relief: &'a HeightField,
    /// The first row.
    first: usize,
    cells: &'a mut [(f32, TopSurface)],
}

impl HeightFieldRows<'_> {
    /// Rasterises a mesh from above; the highest face of each cell stays.
    fn lay(&mut self, mesh: &Mesh, place: Affine3A) {
        for (t, &m) in mesh.triangles.iter().zip(&mesh.triangle_materials) {
            let top = match mesh.materials[usize::from(m)].tag {
                ClassTag::Roads | ClassTag::RoadLines => TopSurface::Road,
                ClassTag::Sidewalks => TopSurface::Walk,
                ClassTag::Ground | ClassTag::Bridge => TopSurface::Ground,
                ClassTag::Water => TopSurface::Water,
                ClassTag::Buildings | ClassTag::Walls => TopSurface::Solid,
                ClassTag::Terrain => TopSurface::Green,
                _ => continue,
            };
            self.triangle(t.map(|i| place.transform_point3(mesh.positions[i as usize])), top);
        }
    }

    fn triangle(&mut self, corners: [Vec3; 3], top: TopSurface) {
        let HeightField { low, cell, width, .. } = *self.relief;
        let [a, b, c] = corners.map(|p| (p.truncate() - low) / cell);
        // What faces down is no top.
        if (b - a).perp_dot(c - a) <= 0.0 {
            return;
        }
        let rows = self.first..self.first + self.cells.len() / width;
        cells_in([a, b, c], width, rows, |x, y, [u, v]| {
            let z = corners[0].z * u + corners[1].z * v + corners[2].z * (1.0 - u - v);
            let cell = &mut self.cells[(y - self.first) * width + x];
            if z > cell.0 {
                *cell = (z, top);
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_road::{Lane, LaneId, Polyline};
    use endless_scene::{Material, MeshBuilder, Surface};
    use glam::DVec3;

    #[test]
    fn a_wall_hides_what_is_behind_it() {
        let lane = Lane::new(LaneId(0), Polyline::new([DVec3::ZERO, DVec3::new(40.0, 0.0, 0.0)]), 3.0, 10.0);
        let network = RoadNetwork { lanes: vec![lane], ..RoadNetwork::default() };
        let mut mesh = MeshBuilder::new();
        let flat = |tag| Material::new(Surface::Concrete, [0.5; 3], tag);
        mesh.cuboid(Vec3::new(-50.0, -50.0, -1.0), Vec3::new(90.0, 50.0, 0.0), flat(ClassTag::Roads));
        mesh.cuboid(Vec3::new(20.0, -5.0, 0.0), Vec3::new(24.0, 5.0, 6.0), flat(ClassTag::Buildings));
        let relief = HeightField::new(&network, &[(mesh.finish(), Affine3A::IDENTITY)]);
        let lens = Vec3::new(0.0, 0.0, 5.0);
        assert!(relief.sees(lens, Vec3::new(15.0, 0.0, 0.0)));
        assert!(!relief.sees(lens, Vec3::new(30.0, 0.0, 0.0)));
        assert!(relief.sees(lens, Vec3::new(30.0, 20.0, 0.0)));
        assert_eq!(relief.at(DVec2::new(22.0, 0.0)), (6.0, TopSurface::Solid));
        let (t, top) = relief.cast(lens, Vec3::new(1.0, 0.0, -0.5).normalize(), 100.0).expect("ground");
        assert!((t - 11.2).abs() < 1.0 && top == TopSurface::Road);
    }
}
