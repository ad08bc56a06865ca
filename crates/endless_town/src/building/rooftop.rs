//! Rooftop parts: tanks, aerials, skylights, solar panels, dormers, gutters.

use super::opening::WindowNumbers;
use super::roof::boxed;
use super::wall::{Wall, WallOpening};
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::{ClassTag, Stream};
use glam::{Vec2, Vec3};

const fn of(surface: Surface, color: [f32; 3]) -> Material {
    Material::new(surface, color, ClassTag::Buildings)
}

const ZINC: Material = of(Surface::Metal, [0.36, 0.37, 0.38]);
const STEEL: Material = of(Surface::Metal, [0.30, 0.30, 0.31]);
const RUST: Material = of(Surface::Metal, [0.17, 0.08, 0.05]);
const PANEL: Material = of(Surface::CarGlass, [0.03, 0.05, 0.12]);
const GLASS: Material = of(Surface::WindowGlass, [0.05, 0.06, 0.07]);

/// An upright cylinder with its lid.
pub(super) fn drum(mesh: &mut MeshBuilder, base: Vec3, radius: f32, height: f32, material: Material) {
    const SIDES: u32 = 12;
    let rim = |k: u32, z: f32| {
        let (sin, cos) = endless_world::math::sin_cos(std::f32::consts::TAU * k as f32 / SIDES as f32);
        base + Vec3::new(radius * cos, radius * sin, z)
    };
    let side = std::f32::consts::TAU * radius / SIDES as f32;
    for k in 0..SIDES {
        let uv = [[0.0, 0.0], [side, 0.0], [side, height], [0.0, height]].map(Vec2::from_array);
        mesh.quad([rim(k, 0.0), rim(k + 1, 0.0), rim(k + 1, height), rim(k, height)], uv, material);
        let top = [base + Vec3::Z * (height + 0.12 * radius), rim(k, height), rim(k + 1, height)];
        mesh.triangle(top, [Vec2::ZERO, Vec2::X, Vec2::ONE], material);
    }
}

/// A plastic tank for water on a stand of blocks.
pub(super) fn water_tank(mesh: &mut MeshBuilder, at: Vec3, stream: &mut Stream) {
    let colors = [[0.02, 0.02, 0.022], [0.03, 0.14, 0.40], [0.45, 0.42, 0.36]];
    let plastic = of(Surface::Plastic, *stream.pick(&colors));
    let stand = stream.range_f32(0.2, 1.1);
    boxed(
        mesh,
        [at.x - 0.6, at.x + 0.6],
        [at.y - 0.6, at.y + 0.6],
        [at.z, at.z + stand],
        of(Surface::Brick, [0.34, 0.17, 0.11]),
    );
    drum(mesh, at + Vec3::Z * stand, 0.55, 1.15, plastic);
    drum(mesh, at + Vec3::Z * (stand + 1.15), 0.24, 0.12, plastic);
}

/// A barrel of staves on iron legs, as on the roofs of tenements.
pub(super) fn barrel(mesh: &mut MeshBuilder, at: Vec3) {
    let wood = of(Surface::Wood, [0.20, 0.15, 0.11]);
    for (x, y) in [(-1.0, -1.0), (0.9, -1.0), (0.9, 0.9), (-1.0, 0.9)] {
        boxed(mesh, [at.x + x, at.x + x + 0.1], [at.y + y, at.y + y + 0.1], [at.z, at.z + 2.4], STEEL);
    }
    boxed(mesh, [at.x - 1.3, at.x + 1.3], [at.y - 1.3, at.y + 1.3], [at.z + 2.4, at.z + 2.55], STEEL);
    drum(mesh, at + Vec3::Z * 2.55, 1.35, 2.6, wood);
    for z in [2.9, 3.7, 4.6] {
        drum(mesh, at + Vec3::Z * z, 1.37, 0.06, STEEL);
    }
    // The lid.
    for k in 0..3 {
        drum(mesh, at + Vec3::Z * (5.15 + 0.18 * k as f32), 1.45 - 0.45 * k as f32, 0.2, STEEL);
    }
}

/// A mast with the rods of an aerial.
pub(super) fn aerial(mesh: &mut MeshBuilder, at: Vec3, stream: &mut Stream) {
    let height = stream.range_f32(1.6, 2.8);
    boxed(mesh, [at.x - 0.02, at.x + 0.02], [at.y - 0.02, at.y + 0.02], [at.z, at.z + height], STEEL);
    let top = at.z + height - 0.15;
    boxed(mesh, [at.x - 0.6, at.x + 0.5], [at.y - 0.012, at.y + 0.012], [top, top + 0.025], STEEL);
    for k in 0..7 {
        let x = at.x - 0.55 + 0.16 * k as f32;
        let half = 0.34 - 0.03 * k as f32;
        boxed(mesh, [x, x + 0.012], [at.y - half, at.y + half], [top + 0.025, top + 0.037], STEEL);
    }
}

/// Bars of columns left bare for a storey to come.
pub(super) fn rebar(mesh: &mut MeshBuilder, (x, y): ([f32; 2], [f32; 2]), z: f32, stream: &mut Stream) {
    let (nx, ny) = (((x[1] - x[0]) / 3.2).ceil().max(1.0) as usize, ((y[1] - y[0]) / 3.6).ceil().max(1.0) as usize);
    for i in 0..=nx {
        for j in 0..=ny {
            let cx = x[0] + 0.2 + (x[1] - x[0] - 0.4) * i as f32 / nx as f32;
            let cy = y[0] + 0.2 + (y[1] - y[0] - 0.4) * j as f32 / ny as f32;
            let stub = stream.range_f32(0.0, 0.5);
            if stub > 0.2 {
                boxed(
                    mesh,
                    [cx - 0.13, cx + 0.13],
                    [cy - 0.13, cy + 0.13],
                    [z, z + stub],
                    of(Surface::Concrete, [0.42, 0.40, 0.37]),
                );
            }
            for (dx, dy) in [(-0.09, -0.09), (0.08, -0.09), (0.08, 0.08), (-0.09, 0.08)] {
                let top = z + stub + stream.range_f32(0.5, 0.9);
                boxed(mesh, [cx + dx, cx + dx + 0.016], [cy + dy, cy + dy + 0.016], [z, top], RUST);
            }
        }
    }
}

/// A half-round gutter, here square, along the foot of a slope.
pub(super) fn gutter(mesh: &mut MeshBuilder, slope: &Wall) {
    slope.block(mesh, [0.0, slope.width], [-0.13, 0.0], [-0.16, -0.02], ZINC);
}

/// A window in a slope.
pub(super) fn skylight(mesh: &mut MeshBuilder, slope: &Wall, u: f32, v: f32, numbers: &mut WindowNumbers) {
    slope.block(mesh, [u - 0.42, u + 0.42], [v, v + 1.15], [0.0, 0.07], of(Surface::Painted, [0.10, 0.10, 0.11]));
    slope.panel_uv(mesh, [u - 0.35, u + 0.35], [v + 0.07, v + 1.08], 0.075, numbers.next_square(), GLASS);
}

/// Solar panels in a row on a slope.
pub(super) fn solar(mesh: &mut MeshBuilder, slope: &Wall, from: f32, v: f32, count: usize) {
    for k in 0..count {
        let u = from + 1.08 * k as f32;
        slope.block(mesh, [u, u + 1.03], [v, v + 1.65], [0.05, 0.10], STEEL);
        slope.panel(mesh, [u + 0.03, u + 1.0], [v + 0.03, v + 1.62], 0.103, PANEL);
        for i in 1..5 {
            let y = v + 1.65 * i as f32 / 5.0;
            slope.panel(mesh, [u + 0.03, u + 1.0], [y - 0.008, y + 0.008], 0.105, STEEL);
        }
    }
}

/// A gabled dormer on a slope towards −y: its front upright at `y`, its foot at `z`.
pub(super) fn dormer(
    mesh: &mut MeshBuilder,
    (x, y, z): (f32, f32, f32),
    slope: f32,
    (wall, tiles, frame): (Material, Material, Material),
    numbers: &mut WindowNumbers,
) {
    let (half, high, ridge) = (0.75, 1.35, 0.5);
    let front = Wall::upright(Vec3::new(x - half, y, z), Vec3::X, 2.0 * half);
    let hole = WallOpening { u: [0.25, 2.0 * half - 0.25], v: [0.2, high - 0.1] };
    front.pierced(mesh, [0.0, high], &[hole], wall);
    front.reveal(mesh, &hole, 0.12, wall);
    front.block(mesh, hole.u, hole.v, [-0.12, -0.10], frame);
    front.panel_uv(
        mesh,
        [hole.u[0] + 0.06, hole.u[1] - 0.06],
        [hole.v[0] + 0.06, hole.v[1] - 0.06],
        -0.097,
        numbers.next_square(),
        GLASS,
    );
    // Where the eaves and the ridge meet the slope behind.
    let (back, top) = (high / slope, (high + ridge) / slope);
    let p = |dx: f32, dy: f32, dz: f32| Vec3::new(x + dx, y + dy, z + dz);
    let uv3 = [Vec2::ZERO, Vec2::X, Vec2::ONE];
    mesh.triangle([p(half, 0.0, 0.0), p(half, back, high), p(half, 0.0, high)], uv3, wall);
    mesh.triangle([p(-half, 0.0, 0.0), p(-half, 0.0, high), p(-half, back, high)], uv3, wall);
    mesh.triangle([p(-half, 0.0, high), p(half, 0.0, high), p(0.0, 0.0, high + ridge)], uv3, wall);
    let (e, o) = (half + 0.15, -0.2);
    let low = high - 0.15 * ridge / half;
    let uv = [[0.0, 0.0], [1.6, 0.0], [1.6, 0.9], [0.0, 0.9]].map(Vec2::from_array);
    let right = [
        p(e, o, low + 0.06),
        p(e, back + 0.1, low + 0.06),
        p(0.0, top, high + ridge + 0.06),
        p(0.0, o, high + ridge + 0.06),
    ];
    let left = right.map(|q| Vec3::new(2.0 * x - q.x, q.y, q.z));
    mesh.quad(right, uv, tiles);
    mesh.quad([left[1], left[0], left[3], left[2]], uv, tiles);
    let down = |q: Vec3| q - Vec3::Z * 0.06;
    mesh.quad([right[1], right[0], right[3], right[2]].map(down), uv, wall);
    mesh.quad(left.map(down), uv, wall);
}

/// Machines, ducts and vents of a large flat roof.
pub(super) fn machines(mesh: &mut MeshBuilder, (x, y): ([f32; 2], [f32; 2]), z: f32, stream: &mut Stream) {
    let grey = of(Surface::Painted, [0.47, 0.48, 0.48]);
    let (w, d) = (x[1] - x[0], y[1] - y[0]);
    if w < 7.0 || d < 7.0 {
        return;
    }
    let (cx, cy) = (x[0] + w * stream.range_f32(0.3, 0.5), y[0] + d * stream.range_f32(0.35, 0.5));
    boxed(mesh, [cx, cx + 2.2], [cy, cy + 1.2], [z + 0.25, z + 1.45], grey);
    for k in 0..2 {
        drum(mesh, Vec3::new(cx + 0.6 + k as f32, cy + 0.6, z + 1.45), 0.42, 0.12, of(Surface::Painted, [0.06; 3]));
    }
    boxed(mesh, [cx + 2.2, (cx + 2.2 + w * 0.25).min(x[1] - 0.6)], [cy + 0.35, cy + 0.85], [z + 0.4, z + 0.9], ZINC);
    for _ in 0..3 + stream.below(4) {
        let at = Vec3::new(x[0] + w * stream.range_f32(0.1, 0.9), y[0] + d * stream.range_f32(0.1, 0.9), z);
        drum(mesh, at, stream.range_f32(0.06, 0.16), stream.range_f32(0.4, 0.9), ZINC);
    }
}
