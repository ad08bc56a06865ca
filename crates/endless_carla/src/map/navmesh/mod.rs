//! The mesh on which pedestrians find their way, in the file format of Recast and Detour, which CARLA's client loads.
//!
//! Surfaces are laid on a grid, which joins what overlaps and keeps levels apart ([`grid`]). Its cells are split into
//! regions that have one run of cells in each row (the monotone partitioning of Recast; [`region`]), whose outlines are
//! simplified ([`contour`]), cut into triangles ([`triangulate`]) and joined to convex polygons ([`polygon_mesh`]).
//! Outlines of neighbours have the same corners, so that polygons meet edge to edge. [`tile`] writes them.

mod contour;
mod grid;
mod polygon_mesh;
mod region;
mod tile;
mod triangulate;
mod walk_area;

use super::surface::{Surface, SurfaceKind};
use polygon_mesh::PolygonMesh;

/// Sides of cells that are tried, metres: the first with which a mesh is not too large is taken.
const CELLS_M: [f64; 3] = [0.25, 0.5, 1.0];

/// A navigation mesh as a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NavigationMesh {
    /// Its name on the server: another one for other bytes, because clients keep files for ever.
    pub file_name: String,
    /// The file.
    pub bytes: Vec<u8>,
}

/// The mesh of a town; `None` where nobody can walk.
pub(super) fn build(town: &str, surfaces: &[Surface]) -> Option<NavigationMesh> {
    let bytes = tile::file(&mesh(surfaces)?);
    let hash = blake3::hash(&bytes).to_hex();
    let known = |c: char| if c.is_ascii_alphanumeric() || "-_.".contains(c) { c } else { '_' };
    let town: String = town.chars().map(known).collect();
    Some(NavigationMesh { file_name: format!("Nav/{town}-{}.bin", &hash[..16]), bytes })
}

/// The finest mesh that is not too large for the format: with roads, or else without.
fn mesh(surfaces: &[Surface]) -> Option<PolygonMesh> {
    let without_roads = || surfaces.iter().filter(|s| s.kind != SurfaceKind::Road).copied().collect::<Vec<_>>();
    let fits = |surfaces: &[Surface], cell_m: f64| Some(mesh_of(surfaces, cell_m)).filter(PolygonMesh::fits);
    let mesh =
        fits(surfaces, CELLS_M[0]).or_else(|| CELLS_M.iter().find_map(|&cell_m| fits(&without_roads(), cell_m)))?;
    (!mesh.polygons.is_empty()).then_some(mesh)
}

fn mesh_of(surfaces: &[Surface], cell_m: f64) -> PolygonMesh {
    let grid = grid::Grid::new(surfaces, cell_m);
    let regions = region::regions(&grid);
    let outlines = contour::contours(&grid, &regions);
    polygon_mesh::PolygonMesh::new(&outlines)
}

#[cfg(test)]
mod tests;
