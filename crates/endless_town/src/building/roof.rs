//! Roofs: flat with parapet and plant, gabled, hipped; chimneys.

use super::wall::{Wall, walls};
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::{ClassTag, Stream};
use glam::{Vec2, Vec3};

const PLANT: Material = Material::new(Surface::Painted, [0.45, 0.46, 0.46], ClassTag::Buildings);
const DARK: Material = Material::new(Surface::Painted, [0.10, 0.10, 0.11], ClassTag::Buildings);
const CHIMNEY: Material = Material::new(Surface::Brick, [0.32, 0.14, 0.09], ClassTag::Buildings);
const FELT: Material = Material::new(Surface::FlatRoof, [0.20, 0.20, 0.195], ClassTag::Buildings);

/// A box given by its ranges.
pub(crate) fn boxed(mesh: &mut MeshBuilder, x: [f32; 2], y: [f32; 2], z: [f32; 2], material: Material) {
    mesh.cuboid(Vec3::new(x[0], y[0], z[0]), Vec3::new(x[1], y[1], z[1]), material);
}

/// A flat roof at height `z` behind a parapet, with a cornice in front.
pub(crate) fn flat(
    mesh: &mut MeshBuilder,
    (x, y): ([f32; 2], [f32; 2]),
    z: f32,
    parapet: f32,
    (wall, trim): (Material, Material),
) {
    let t = 0.25;
    let (xi, yi) = ([x[0] + t, x[1] - t], [y[0] + t, y[1] - t]);
    let p = |x: f32, y: f32, z: f32| Vec3::new(x, y, z);
    mesh.quad(
        [p(xi[0], yi[0], z), p(xi[1], yi[0], z), p(xi[1], yi[1], z), p(xi[0], yi[1], z)],
        [p(xi[0], yi[0], 0.0), p(xi[1], yi[0], 0.0), p(xi[1], yi[1], 0.0), p(xi[0], yi[1], 0.0)].map(Vec3::truncate),
        FELT,
    );
    let top = z + parapet;
    for (outer, inner) in walls(x, y, z).iter().zip(walls(xi, yi, z)) {
        outer.panel(mesh, [0.0, outer.width], [0.0, parapet], 0.0, wall);
        // The inner face looks the other way.
        let back = Wall::upright(inner.origin + inner.right * inner.width, -inner.right, inner.width);
        back.panel(mesh, [0.0, back.width], [0.0, parapet], 0.0, wall);
        let (a, b) = (outer.origin, outer.origin + outer.right * outer.width);
        let (c, d) = (inner.origin + inner.right * inner.width, inner.origin);
        let lift = Vec3::Z * (top - z);
        mesh.quad(
            [a + lift, b + lift, c + lift, d + lift],
            [[0.0, 0.0], [outer.width, 0.0], [outer.width, t], [0.0, t]].map(Vec2::from_array),
            trim,
        );
    }
}

/// Air conditioners, a stair head and vents on a flat roof.
pub(crate) fn plant(mesh: &mut MeshBuilder, (x, y): ([f32; 2], [f32; 2]), z: f32, stream: &mut Stream) {
    let (w, d) = (x[1] - x[0], y[1] - y[0]);
    if w > 9.0 && d > 9.0 && stream.chance(0.7) {
        let (cx, cy) = (x[0] + w * stream.range_f32(0.3, 0.7), y[0] + d * stream.range_f32(0.55, 0.7));
        boxed(mesh, [cx - 1.6, cx + 1.6], [cy - 1.4, cy + 1.4], [z, z + 2.5], PLANT);
    }
    for k in 0..stream.below(4) + 1 {
        let cx = x[0] + w * (0.15 + 0.18 * k as f32) + stream.range_f32(-0.2, 0.2);
        let cy = y[0] + d * stream.range_f32(0.2, 0.42);
        boxed(mesh, [cx - 0.5, cx + 0.5], [cy - 0.4, cy + 0.4], [z + 0.1, z + 0.95], PLANT);
        boxed(mesh, [cx - 0.38, cx + 0.38], [cy - 0.42, cy - 0.4], [z + 0.2, z + 0.85], DARK);
    }
}

/// A gabled roof: ridge along x if `along_x`, eaves at `z`. The gables are walls of their own. Returns its two slopes,
/// that towards the front or the right first.
pub(crate) fn gabled(
    mesh: &mut MeshBuilder,
    (x, y): ([f32; 2], [f32; 2]),
    z: f32,
    rise: f32,
    (along_x, eaves, verge): (bool, f32, f32),
    (tiles, gable): (Material, Material),
) -> [Wall; 2] {
    // In the roof's own frame: `a` along the ridge, `b` across it; an even swap of axes keeps the winding.
    let (a, b) = if along_x { (x, y) } else { (y, [-x[1], -x[0]]) };
    let p = |pa: f32, pb: f32, pz: f32| if along_x { Vec3::new(pa, pb, pz) } else { Vec3::new(-pb, pa, pz) };
    let middle = (b[0] + b[1]) / 2.0;
    let half = (b[1] - b[0]) / 2.0;
    let slope = rise / half;
    let (a0, a1) = (a[0] - verge, a[1] + verge);
    let low = z - slope * eaves;
    let thick = 0.18;
    let length = (half + eaves) * (1.0 + slope * slope).sqrt();
    let (b0, b1, top) = (b[0] - eaves, b[1] + eaves, z + rise);
    let mut face = |corners: [Vec3; 4], u: f32, v: f32, material: Material| {
        mesh.quad(corners, [[0.0, 0.0], [u, 0.0], [u, v], [0.0, v]].map(Vec2::from_array), material);
    };
    let w = a1 - a0;
    let up = thick;
    face(
        [p(a0, b0, low + up), p(a1, b0, low + up), p(a1, middle, top + up), p(a0, middle, top + up)],
        w,
        length,
        tiles,
    );
    face(
        [p(a1, b1, low + up), p(a0, b1, low + up), p(a0, middle, top + up), p(a1, middle, top + up)],
        w,
        length,
        tiles,
    );
    // Undersides, eaves and verges close the roof.
    face([p(a1, b0, low), p(a0, b0, low), p(a0, middle, top), p(a1, middle, top)], w, length, gable);
    face([p(a0, b1, low), p(a1, b1, low), p(a1, middle, top), p(a0, middle, top)], w, length, gable);
    face([p(a0, b0, low), p(a1, b0, low), p(a1, b0, low + up), p(a0, b0, low + up)], w, up, gable);
    face([p(a1, b1, low), p(a0, b1, low), p(a0, b1, low + up), p(a1, b1, low + up)], w, up, gable);
    for (end, flip) in [(a0, false), (a1, true)] {
        for (from, to, zf, zt) in [(b0, middle, low, top), (middle, b1, top, low)] {
            let quad = [p(end, to, zt), p(end, from, zf), p(end, from, zf + up), p(end, to, zt + up)];
            let quad = if flip { [quad[1], quad[0], quad[3], quad[2]] } else { quad };
            face(quad, length, up, gable);
        }
    }
    for (end, flip) in [(a[0], false), (a[1], true)] {
        let mut corners = [p(end, b[1], z), p(end, b[0], z), p(end, middle, top)];
        if flip {
            corners.swap(0, 1);
        }
        mesh.triangle(corners, [[0.0, 0.0], [2.0 * half, 0.0], [half, rise]].map(Vec2::from_array), gable);
    }
    let slant =
        |foot: Vec3, right: Vec3, head: Vec3| Wall { origin: foot, right, up: (head - foot).normalize(), width: w };
    let along = (p(1.0, 0.0, 0.0) - p(0.0, 0.0, 0.0)).normalize();
    [
        slant(p(a0, b0, low + up), along, p(a0, middle, top + up)),
        slant(p(a1, b1, low + up), -along, p(a1, middle, top + up)),
    ]
}

/// A hipped roof over a volume at least as long in x as in y, or the other way round.
pub(crate) fn hipped(
    mesh: &mut MeshBuilder,
    (x, y): ([f32; 2], [f32; 2]),
    z: f32,
    rise: f32,
    (tiles, soffit): (Material, Material),
) {
    let eaves = 0.4;
    let (x, y) = ([x[0] - eaves, x[1] + eaves], [y[0] - eaves, y[1] + eaves]);
    let half = ((x[1] - x[0]).min(y[1] - y[0])) / 2.0;
    let centre = [(x[0] + x[1]) / 2.0, (y[0] + y[1]) / 2.0];
    let (rx, ry) = ((x[1] - x[0]) / 2.0 - half, (y[1] - y[0]) / 2.0 - half);
    // A ridge of no length would make triangles of no area.
    let (rx, ry) = if rx >= ry { (rx.max(0.3), 0.0) } else { (0.0, ry.max(0.3)) };
    let p = |x: f32, y: f32, z: f32| Vec3::new(x, y, z);
    let (r0, r1) = (p(centre[0] - rx, centre[1] - ry, z + rise), p(centre[0] + rx, centre[1] + ry, z + rise));
    let c = [p(x[0], y[0], z), p(x[1], y[0], z), p(x[1], y[1], z), p(x[0], y[1], z)];
    let slope = (half * half + rise * rise).sqrt();
    let uv4 = |w: f32, ridge: f32| {
        [[0.0, 0.0], [w, 0.0], [(w + ridge) / 2.0, slope], [(w - ridge) / 2.0, slope]].map(Vec2::from_array)
    };
    let uv3 = |w: f32| [[0.0, 0.0], [w, 0.0], [w / 2.0, slope]].map(Vec2::from_array);
    let (w, d) = (x[1] - x[0], y[1] - y[0]);
    if rx > 0.0 {
        mesh.quad([c[0], c[1], r1, r0], uv4(w, 2.0 * rx), tiles);
        mesh.quad([c[2], c[3], r0, r1], uv4(w, 2.0 * rx), tiles);
        mesh.triangle([c[1], c[2], r1], uv3(d), tiles);
        mesh.triangle([c[3], c[0], r0], uv3(d), tiles);
    } else {
        mesh.triangle([c[0], c[1], r0], uv3(w), tiles);
        mesh.triangle([c[2], c[3], r1], uv3(w), tiles);
        mesh.quad([c[1], c[2], r1, r0], uv4(d, 2.0 * ry), tiles);
        mesh.quad([c[3], c[0], r0, r1], uv4(d, 2.0 * ry), tiles);
    }
    mesh.quad([c[3], c[2], c[1], c[0]], [[0.0, d], [w, d], [w, 0.0], [0.0, 0.0]].map(Vec2::from_array), soffit);
}

/// A chimney stack through a roof.
pub(crate) fn chimney(mesh: &mut MeshBuilder, x: f32, y: f32, from: f32, to: f32) {
    boxed(mesh, [x - 0.35, x + 0.35], [y - 0.3, y + 0.3], [from, to], CHIMNEY);
    boxed(mesh, [x - 0.42, x + 0.42], [y - 0.37, y + 0.37], [to, to + 0.12], CHIMNEY);
    for side in [-0.17, 0.17] {
        boxed(mesh, [x + side - 0.1, x + side + 0.1], [y - 0.1, y + 0.1], [to + 0.12, to + 0.45], DARK);
    }
}
