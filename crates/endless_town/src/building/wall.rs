//! Walls with openings, and boxes that stand out from them.

use endless_scene::{Material, Mesh, MeshBuilder};
use glam::{Affine3A, Mat3A, Vec2, Vec3};

/// A rectangle seen from outside: `u` to the right, `v` up, `out` towards the viewer. Walls stand upright, slopes of
/// roofs lean.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wall {
    /// Lower left corner.
    pub(crate) origin: Vec3,
    /// Unit vector to the right.
    pub(crate) right: Vec3,
    /// Unit vector up along it.
    pub(crate) up: Vec3,
    pub(crate) width: f32,
}

/// A hole in a wall.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WallOpening {
    pub(crate) u: [f32; 2],
    pub(crate) v: [f32; 2],
}

impl Wall {
    /// An upright one.
    pub(crate) fn upright(origin: Vec3, right: Vec3, width: f32) -> Self {
        Self { origin, right, up: Vec3::Z, width }
    }

    pub(crate) fn at(&self, u: f32, v: f32, out: f32) -> Vec3 {
        self.origin + self.right * u + self.up * v + self.right.cross(self.up) * out
    }

    /// The same rectangle further back.
    pub(crate) fn behind(&self, depth: f32) -> Self {
        Self { origin: self.at(0.0, 0.0, -depth), ..*self }
    }

    /// A mesh whose +x looks at the viewer and whose +y is his right, its origin at a place of the wall.
    pub(crate) fn hang(&self, mesh: &mut MeshBuilder, thing: &Mesh, u: f32, v: f32, out: f32) {
        let axes = Mat3A::from_cols(self.right.cross(self.up).into(), self.right.into(), self.up.into());
        mesh.mesh(thing, Affine3A { matrix3: axes, translation: self.at(u, v, out).into() });
    }

    /// A bar of a width in the wall's plane from one place to another, between two distances from the wall.
    pub(crate) fn bar(
        &self,
        mesh: &mut MeshBuilder,
        (from, to): (Vec2, Vec2),
        width: f32,
        out: [f32; 2],
        material: Material,
    ) {
        let side = (to - from).perp().normalize_or(Vec2::Y) * (width / 2.0);
        let ring = [from - side, to - side, to + side, from + side];
        let front = ring.map(|p| self.at(p.x, p.y, out[1]));
        let back = ring.map(|p| self.at(p.x, p.y, out[0]));
        let (length, depth) = (from.distance(to), out[1] - out[0]);
        let uv = |a: f32, b: f32| [[0.0, 0.0], [a, 0.0], [a, b], [0.0, b]].map(Vec2::from_array);
        mesh.quad(front, uv(length, width), material);
        mesh.quad([back[1], back[0], back[3], back[2]], uv(length, width), material);
        for k in 0..4 {
            let next = (k + 1) % 4;
            mesh.quad([front[next], front[k], back[k], back[next]], uv(width, depth), material);
        }
    }

    /// A rectangle parallel to the wall; uv in metres.
    pub(crate) fn panel(&self, mesh: &mut MeshBuilder, u: [f32; 2], v: [f32; 2], out: f32, material: Material) {
        let uvs = [[u[0], v[0]], [u[1], v[0]], [u[1], v[1]], [u[0], v[1]]].map(Vec2::from_array);
        self.panel_uv(mesh, u, v, out, uvs, material);
    }

    pub(crate) fn panel_uv(
        &self,
        mesh: &mut MeshBuilder,
        u: [f32; 2],
        v: [f32; 2],
        out: f32,
        uvs: [Vec2; 4],
        material: Material,
    ) {
        if u[1] - u[0] < 1e-4 || v[1] - v[0] < 1e-4 {
            return;
        }
        let corners =
            [self.at(u[0], v[0], out), self.at(u[1], v[0], out), self.at(u[1], v[1], out), self.at(u[0], v[1], out)];
        mesh.quad(corners, uvs, material);
    }

    /// The wall between two heights, with holes that do not overlap, from left to right.
    pub(crate) fn pierced(&self, mesh: &mut MeshBuilder, v: [f32; 2], holes: &[WallOpening], material: Material) {
        let mut from = 0.0;
        for hole in holes {
            self.panel(mesh, [from, hole.u[0]], v, 0.0, material);
            self.panel(mesh, hole.u, [v[0], hole.v[0]], 0.0, material);
            self.panel(mesh, hole.u, [hole.v[1], v[1]], 0.0, material);
            from = hole.u[1];
        }
        self.panel(mesh, [from, self.width], v, 0.0, material);
    }

    /// The four inner sides of a hole, from the wall's face to `depth` behind it.
    pub(crate) fn reveal(&self, mesh: &mut MeshBuilder, hole: &WallOpening, depth: f32, material: Material) {
        let ([u0, u1], [v0, v1]) = (hole.u, hole.v);
        let p = |u: f32, v: f32, out: f32| self.at(u, v, out);
        let faces = [
            // Bottom, right, top, left, each seen from within the hole.
            ([p(u0, v0, 0.0), p(u1, v0, 0.0), p(u1, v0, -depth), p(u0, v0, -depth)], u1 - u0),
            ([p(u1, v0, 0.0), p(u1, v1, 0.0), p(u1, v1, -depth), p(u1, v0, -depth)], v1 - v0),
            ([p(u1, v1, 0.0), p(u0, v1, 0.0), p(u0, v1, -depth), p(u1, v1, -depth)], u1 - u0),
            ([p(u0, v1, 0.0), p(u0, v0, 0.0), p(u0, v0, -depth), p(u0, v1, -depth)], v1 - v0),
        ];
        for (corners, length) in faces {
            let uvs = [[0.0, 0.0], [length, 0.0], [length, depth], [0.0, depth]].map(Vec2::from_array);
            mesh.quad(corners, uvs, material);
        }
    }

    /// A box on the wall with all its sides.
    pub(crate) fn solid(&self, mesh: &mut MeshBuilder, u: [f32; 2], v: [f32; 2], out: [f32; 2], material: Material) {
        self.block(mesh, u, v, out, material);
        let back = Self { origin: self.at(self.width, 0.0, out[0]), right: -self.right, ..*self };
        let from = self.width;
        back.panel(mesh, [from - u[1], from - u[0]], v, 0.0, material);
    }

    /// A box on the wall; `out` from its back (left out if it touches the wall) to its front.
    pub(crate) fn block(&self, mesh: &mut MeshBuilder, u: [f32; 2], v: [f32; 2], out: [f32; 2], material: Material) {
        let ([u0, u1], [v0, v1], [o0, o1]) = (u, v, out);
        let p = |u: f32, v: f32, out: f32| self.at(u, v, out);
        let (w, h, d) = (u1 - u0, v1 - v0, o1 - o0);
        let mut faces = vec![
            ([p(u0, v0, o1), p(u1, v0, o1), p(u1, v1, o1), p(u0, v1, o1)], w, h),
            ([p(u1, v0, o1), p(u1, v0, o0), p(u1, v1, o0), p(u1, v1, o1)], d, h),
            ([p(u0, v0, o0), p(u0, v0, o1), p(u0, v1, o1), p(u0, v1, o0)], d, h),
            ([p(u0, v1, o1), p(u1, v1, o1), p(u1, v1, o0), p(u0, v1, o0)], w, d),
            ([p(u0, v0, o0), p(u1, v0, o0), p(u1, v0, o1), p(u0, v0, o1)], w, d),
        ];
        // Behind what touches the wall nobody looks.
        if o0 > 0.005 {
            faces.push(([p(u1, v0, o0), p(u0, v0, o0), p(u0, v1, o0), p(u1, v1, o0)], w, h));
        }
        for (corners, a, b) in faces {
            mesh.quad(corners, [[0.0, 0.0], [a, 0.0], [a, b], [0.0, b]].map(Vec2::from_array), material);
        }
    }
}

/// The four walls of a box-shaped volume: front (towards −y), right, back, left.
pub(crate) fn walls(x: [f32; 2], y: [f32; 2], z: f32) -> [Wall; 4] {
    let (w, d) = (x[1] - x[0], y[1] - y[0]);
    [
        Wall::upright(Vec3::new(x[0], y[0], z), Vec3::X, w),
        Wall::upright(Vec3::new(x[1], y[0], z), Vec3::Y, d),
        Wall::upright(Vec3::new(x[1], y[1], z), Vec3::NEG_X, w),
        Wall::upright(Vec3::new(x[0], y[1], z), Vec3::NEG_Y, d),
    ]
}
