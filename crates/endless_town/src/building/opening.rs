//! What fills the holes in walls: windows, doors, shop fronts, gates.

use super::wall::{Wall, WallOpening};
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::ClassTag;
use glam::Vec2;

/// Hands out numbers to windows, so that each shows its own interior.
#[derive(Debug, Default)]
pub(crate) struct WindowNumbers(u32);

impl WindowNumbers {
    /// The uv square of the next pane.
    pub(super) fn next_square(&mut self) -> [Vec2; 4] {
        let n = self.0;
        self.0 += 1;
        let base = Vec2::new((n % 512) as f32, (n / 512) as f32);
        // A little inside, so that interpolation never slips into the neighbour's number.
        [[0.01, 0.01], [0.99, 0.01], [0.99, 0.99], [0.01, 0.99]].map(|f| base + Vec2::from_array(f))
    }
}

/// How much of a window is modelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum WindowDetail {
    /// Reveal, frame, cross-bar and sill.
    Full,
    /// The same with a sill that does not reach over to a neighbour.
    Beside,
    /// Reveal and pane with a frame drawn as its border.
    Plain,
}

/// Materials of openings of one building.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Joinery {
    pub(crate) wall: Material,
    pub(crate) frame: Material,
    pub(crate) sill: Material,
    pub(crate) door: Material,
    pub(crate) recess: f32,
}

const GLASS: Material = Material::new(Surface::WindowGlass, [0.05, 0.06, 0.07], ClassTag::Buildings);
const SHOP_GLASS: Material = Material::new(Surface::ShopGlass, [0.06, 0.07, 0.08], ClassTag::Buildings);
const FRAME_M: f32 = 0.07;

/// A border of `width` within a hole, at a depth; returns what is left inside.
fn border(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    hole: &WallOpening,
    width: f32,
    out: f32,
    material: Material,
) -> WallOpening {
    let inner = WallOpening { u: [hole.u[0] + width, hole.u[1] - width], v: [hole.v[0] + width, hole.v[1] - width] };
    wall.panel(mesh, hole.u, [hole.v[0], inner.v[0]], out, material);
    wall.panel(mesh, hole.u, [inner.v[1], hole.v[1]], out, material);
    wall.panel(mesh, [hole.u[0], inner.u[0]], inner.v, out, material);
    wall.panel(mesh, [inner.u[1], hole.u[1]], inner.v, out, material);
    inner
}

pub(crate) fn window(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    hole: &WallOpening,
    joinery: &Joinery,
    detail: WindowDetail,
    numbers: &mut WindowNumbers,
) {
    wall.reveal(mesh, hole, joinery.recess, joinery.wall);
    let inner = border(mesh, wall, hole, FRAME_M, -joinery.recess, joinery.frame);
    let square = numbers.next_square();
    if detail == WindowDetail::Plain {
        wall.panel_uv(mesh, inner.u, inner.v, -joinery.recess, square, GLASS);
        return;
    }
    // The pane lies behind its frame.
    let glass = joinery.recess + 0.03;
    let frame_hole = wall.behind(joinery.recess);
    frame_hole.reveal(mesh, &inner, 0.03, joinery.frame);
    wall.panel_uv(mesh, inner.u, inner.v, -glass, square, GLASS);
    let middle = (inner.u[0] + inner.u[1]) / 2.0;
    let front = -joinery.recess + 0.005;
    if inner.u[1] - inner.u[0] > 0.8 {
        wall.block(mesh, [middle - 0.03, middle + 0.03], inner.v, [-glass + 0.006, front], joinery.frame);
    }
    wall.block(
        mesh,
        [hole.u[0] - 0.06, hole.u[1] + 0.06],
        [hole.v[0] - 0.07, hole.v[0] - 0.005],
        [0.0, if detail == WindowDetail::Full { 0.09 } else { 0.035 }],
        joinery.sill,
    );
}

pub(crate) fn door(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    hole: &WallOpening,
    joinery: &Joinery,
    numbers: &mut WindowNumbers,
) {
    let depth = joinery.recess + 0.08;
    wall.reveal(mesh, hole, depth, joinery.wall);
    let light = hole.v[1] - hole.v[0] > 2.3;
    let leaf = if light { hole.v[1] - 0.4 } else { hole.v[1] };
    wall.panel(mesh, hole.u, [hole.v[0], leaf], -depth, joinery.door);
    let (u0, u1) = (hole.u[0], hole.u[1]);
    wall.block(mesh, [u0 + 0.15, u1 - 0.15], [hole.v[0] + 0.2, hole.v[0] + 0.9], [-depth, -depth + 0.02], joinery.door);
    wall.block(mesh, [u0 + 0.15, u1 - 0.15], [hole.v[0] + 1.05, leaf - 0.15], [-depth, -depth + 0.02], joinery.door);
    wall.block(
        mesh,
        [u1 - 0.14, u1 - 0.08],
        [hole.v[0] + 0.98, hole.v[0] + 1.04],
        [-depth, -depth + 0.06],
        joinery.sill,
    );
    if light {
        wall.panel_uv(mesh, hole.u, [leaf, hole.v[1]], -depth, numbers.next_square(), GLASS);
    }
}

/// A shop's front: panes between mullions over a low stall riser, with a door in one of them.
pub(crate) fn shop_front(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    hole: &WallOpening,
    joinery: &Joinery,
    numbers: &mut WindowNumbers,
) {
    let depth = 0.25;
    wall.reveal(mesh, hole, depth, joinery.frame);
    let width = hole.u[1] - hole.u[0];
    let panes = (width / 1.7).round().max(1.0) as usize;
    let pane = width / panes as f32;
    let door = panes / 2;
    for k in 0..panes {
        let u = [hole.u[0] + pane * k as f32, hole.u[0] + pane * (k + 1) as f32];
        let riser = if k == door { 0.03 } else { 0.4 };
        wall.panel(mesh, u, [hole.v[0], hole.v[0] + riser], -depth, joinery.frame);
        let bay = WallOpening { u, v: [hole.v[0] + riser, hole.v[1]] };
        let inner = border(mesh, wall, &bay, 0.05, -depth, joinery.frame);
        wall.panel_uv(mesh, inner.u, inner.v, -depth, numbers.next_square(), SHOP_GLASS);
        if k == door {
            let rail = hole.v[0] + 2.2;
            wall.block(mesh, inner.u, [rail, rail + 0.08], [-depth, -depth + 0.04], joinery.frame);
        }
    }
}

/// A gate of horizontal slats.
pub(crate) fn gate(mesh: &mut MeshBuilder, wall: &Wall, hole: &WallOpening, joinery: &Joinery) {
    let depth = 0.2;
    wall.reveal(mesh, hole, depth, joinery.wall);
    wall.panel(mesh, hole.u, hole.v, -depth, joinery.door);
    let slats = ((hole.v[1] - hole.v[0]) / 0.5) as usize;
    for k in 1..slats {
        let v = hole.v[0] + 0.5 * k as f32;
        wall.block(mesh, [hole.u[0] + 0.05, hole.u[1] - 0.05], [v, v + 0.04], [-depth, -depth + 0.03], joinery.frame);
    }
}
