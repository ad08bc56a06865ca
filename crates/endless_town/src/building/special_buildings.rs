//! Buildings that are more than walls with windows: churches, petrol stations, parking decks.

use super::dimensions::{BuildingDimensions, FacadeRhythm};
use super::finish::BuildingFinish;
use super::opening::WindowDetail;
use super::opening::{WindowNumbers, door, shop_front, window};
use super::ornament::letters;
use super::roof::{boxed, flat, gabled};
use super::rooftop::drum;
use super::wall::{Wall, WallOpening, walls};
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::{ClassTag, Stream};
use glam::{Vec2, Vec3};

const fn of(surface: Surface, color: [f32; 3]) -> Material {
    Material::new(surface, color, ClassTag::Buildings)
}

/// A nave with buttresses and pointed windows behind a tower with a spire.
pub(super) fn church(
    mesh: &mut MeshBuilder,
    dimensions: &BuildingDimensions,
    finish: &BuildingFinish,
    numbers: &mut WindowNumbers,
) {
    let half = (dimensions.width / 2.0).min(6.0);
    let (tower, eaves) = (half * 0.46, 6.5 + 0.1 * dimensions.depth);
    let (x, y) = ([-half, half], [2.0 * tower * 0.8, dimensions.depth]);
    for (side, wall) in walls(x, y, 0.0).iter().enumerate() {
        let count = if side % 2 == 1 { (wall.width / 3.4).floor().max(1.0) as usize } else { 0 };
        let pitch = wall.width / count.max(1) as f32;
        let holes: Vec<WallOpening> = (0..count)
            .map(|k| {
                let middle = pitch * (k as f32 + 0.5);
                WallOpening { u: [middle - 0.55, middle + 0.55], v: [2.0, eaves - 1.4] }
            })
            .collect();
        wall.pierced(mesh, [0.0, eaves], &holes, finish.wall);
        for hole in &holes {
            window(mesh, wall, hole, &finish.joinery, WindowDetail::Full, numbers);
            pointed(mesh, wall, hole, finish);
        }
        for k in 0..=count {
            if count > 0 {
                let u = (pitch * k as f32 - 0.3).clamp(0.0, wall.width - 0.6);
                wall.block(mesh, [u, u + 0.6], [0.0, eaves - 2.2], [0.0, 0.7], finish.base);
                wall.block(mesh, [u, u + 0.6], [eaves - 2.2, eaves - 1.0], [0.0, 0.35], finish.base);
            }
        }
    }
    let rise = half * 1.25;
    gabled(mesh, (x, y), eaves, rise, (false, 0.35, 0.2), (finish.roof, finish.wall));
    let shaft = eaves + rise + 3.0;
    let (tx, ty) = ([-tower, tower], [0.0, 2.0 * tower]);
    for (side, wall) in walls(tx, ty, 0.0).iter().enumerate() {
        let middle = wall.width / 2.0;
        let bell = WallOpening { u: [middle - 0.6, middle + 0.6], v: [shaft - 3.2, shaft - 1.0] };
        let entrance = WallOpening { u: [middle - 0.9, middle + 0.9], v: [0.05, 2.9] };
        let low: &[WallOpening] = if side == 0 { &[entrance] } else { &[] };
        wall.pierced(mesh, [0.0, eaves], low, finish.base);
        wall.pierced(mesh, [eaves, shaft], &[bell], finish.wall);
        wall.reveal(mesh, &bell, 0.4, finish.wall);
        wall.panel(mesh, bell.u, bell.v, -0.4, of(Surface::Painted, [0.03; 3]));
        for k in 0..7 {
            let v = bell.v[0] + 0.1 + 0.3 * k as f32;
            wall.block(
                mesh,
                [bell.u[0], bell.u[1]],
                [v, v + 0.08],
                [-0.3, -0.05],
                of(Surface::Wood, [0.14, 0.10, 0.07]),
            );
        }
        pointed(mesh, wall, &bell, finish);
        if side == 0 {
            door(mesh, wall, &entrance, &finish.joinery, numbers);
            pointed(mesh, wall, &entrance, finish);
            clock(mesh, wall, middle, shaft - 4.3);
        }
        wall.block(mesh, [0.0, wall.width], [shaft - 0.3, shaft], [0.0, 0.2], finish.accent);
        for u in [0.0, wall.width - 0.5] {
            wall.block(mesh, [u, u + 0.5], [0.0, shaft - 4.0], [0.0, 0.09], finish.base);
        }
    }
    spire(mesh, tower, shaft, finish);
}

/// A pointed arch of stone over an opening.
fn pointed(mesh: &mut MeshBuilder, wall: &Wall, hole: &WallOpening, finish: &BuildingFinish) {
    let ([u0, u1], v) = (hole.u, hole.v[1]);
    let middle = (u0 + u1) / 2.0;
    let tip = Vec2::new(middle, v + 0.9 * (u1 - u0));
    let fill = [wall.at(u0, v, 0.02), wall.at(u1, v, 0.02), wall.at(tip.x, tip.y, 0.02)];
    mesh.triangle(fill, [Vec2::ZERO, Vec2::X, Vec2::ONE], of(Surface::CarGlass, [0.06, 0.05, 0.07]));
    wall.bar(mesh, (Vec2::new(u0 - 0.08, v), tip), 0.18, [0.0, 0.09], finish.accent);
    wall.bar(mesh, (Vec2::new(u1 + 0.08, v), tip), 0.18, [0.0, 0.088], finish.accent);
    for u in [u0 - 0.16, u1] {
        wall.block(mesh, [u, u + 0.16], [hole.v[0], v], [0.0, 0.08], finish.accent);
    }
}

fn clock(mesh: &mut MeshBuilder, wall: &Wall, u: f32, v: f32) {
    const SIDES: u32 = 20;
    let rim = |k: u32, r: f32, out: f32| {
        let (sin, cos) = endless_world::math::sin_cos(std::f32::consts::TAU * k as f32 / SIDES as f32);
        wall.at(u + r * cos, v + r * sin, out)
    };
    let (gold, face) = (of(Surface::Painted, [0.55, 0.38, 0.06]), of(Surface::Painted, [0.72, 0.71, 0.66]));
    for (r, out, material) in [(0.78, 0.05, gold), (0.68, 0.06, face)] {
        for k in 0..SIDES {
            let uv = [Vec2::ZERO, Vec2::X, Vec2::ONE];
            mesh.triangle([wall.at(u, v, out), rim(k, r, out), rim(k + 1, r, out)], uv, material);
        }
    }
    let black = of(Surface::Painted, [0.02; 3]);
    for (dx, dy, w) in [(0.30, 0.22, 0.09), (-0.12, 0.52, 0.06)] {
        wall.bar(mesh, (Vec2::new(u, v), Vec2::new(u + dx, v + dy)), w, [0.06, 0.08], black);
    }
}

/// Eight sides to a point, with a cross.
fn spire(mesh: &mut MeshBuilder, half: f32, base: f32, finish: &BuildingFinish) {
    let height = 4.2 * half;
    let tip = Vec3::new(0.0, half, base + height);
    let corners = [(-1.0f32, -1.0f32), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
        .map(|(x, y)| Vec3::new(x * (half + 0.2), half + y * (half + 0.2), base));
    for k in 0..4 {
        let uv = [[0.0, 0.0], [2.0 * half, 0.0], [half, height]].map(Vec2::from_array);
        mesh.triangle([corners[k], corners[(k + 1) % 4], tip], uv, finish.roof);
    }
    let gold = of(Surface::Metal, [0.55, 0.40, 0.10]);
    let y = half;
    boxed(mesh, [-0.05, 0.05], [y - 0.05, y + 0.05], [tip.z - 0.2, tip.z + 1.3], gold);
    boxed(mesh, [-0.35, 0.35], [y - 0.05, y + 0.05], [tip.z + 0.75, tip.z + 0.86], gold);
}

/// Pumps under a canopy before a shop.
pub(super) fn petrol_station(
    mesh: &mut MeshBuilder,
    dimensions: &BuildingDimensions,
    finish: &BuildingFinish,
    stream: &mut Stream,
    numbers: &mut WindowNumbers,
) {
    let half = dimensions.width / 2.0;
    let deep = dimensions.depth;
    let back = deep * 0.48;
    let high = 3.6;
    let (x, y) = ([-half, half], [back, deep]);
    for (side, wall) in walls(x, y, 0.0).iter().enumerate() {
        if side == 0 {
            let hole = WallOpening { u: [0.4, wall.width - 0.4], v: [0.02, 2.7] };
            wall.pierced(mesh, [0.0, high], &[hole], finish.base);
            shop_front(mesh, wall, &hole, &finish.joinery, numbers);
            wall.block(mesh, [0.0, wall.width], [2.85, 3.5], [0.0, 0.12], finish.sign);
            let ink = Material { base_color: [0.80, 0.78, 0.72], ..finish.sign };
            letters(mesh, wall, ([0.3, wall.width - 0.3], 3.17), 0.128, 0.42, "SHOP", ink);
        } else {
            wall.panel(mesh, [0.0, wall.width], [0.0, high], 0.0, finish.wall);
        }
    }
    flat(mesh, (x, y), high, 0.5, (finish.wall, finish.trim));
    // The canopy, its rim in the brand's colour.
    let white = of(Surface::Painted, [0.68, 0.68, 0.66]);
    let (cx, cy, under) = ([-half + 0.3, half - 0.3], [0.2, back + 0.4], 4.6);
    boxed(mesh, cx, cy, [under, under + 0.75], white);
    for wall in walls([cx[0] - 0.03, cx[1] + 0.03], [cy[0] - 0.03, cy[1] + 0.03], under + 0.05) {
        wall.block(mesh, [0.0, wall.width], [0.0, 0.62], [0.0, 0.04], finish.sign);
        wall.block(
            mesh,
            [0.0, wall.width],
            [0.22, 0.32],
            [0.0, 0.055],
            Material { base_color: [0.78; 3], ..finish.sign },
        );
    }
    let front = Wall::upright(Vec3::new(cx[0], cy[0] - 0.07, under), Vec3::X, cx[1] - cx[0]);
    let name = *stream.pick(&["OILA", "PETRON", "FUEL", "GAS GO"]);
    let ink = Material { base_color: [0.80, 0.79, 0.74], ..finish.sign };
    front.block(mesh, [0.2, 3.2], [-0.02, 0.74], [0.0, 0.06], finish.sign);
    letters(mesh, &front, ([0.2, 3.2], 0.36), 0.068, 0.48, name, ink);
    for k in 0..4 {
        let lx = cx[0] + (cx[1] - cx[0]) * (k as f32 + 0.5) / 4.0;
        boxed(
            mesh,
            [lx - 0.3, lx + 0.3],
            [cy[0] + 1.5, cy[0] + 2.1],
            [under - 0.02, under],
            Material { base_color: [0.8; 3], ..finish.sign },
        );
    }
    let middle = (cy[0] + cy[1]) / 2.0;
    let islands = ((cx[1] - cx[0]) / 5.5).floor().max(1.0) as usize;
    for k in 0..islands {
        let ix = cx[0] + (cx[1] - cx[0]) * (k as f32 + 0.5) / islands as f32;
        boxed(mesh, [ix - 0.5, ix + 0.5], [middle - 1.9, middle + 1.9], [0.0, 0.16], finish.trim);
        boxed(mesh, [ix - 0.17, ix + 0.17], [middle - 0.17, middle + 0.17], [0.16, under], white);
        for y in [middle - 1.15, middle + 1.15] {
            pump(mesh, Vec3::new(ix, y, 0.16), finish);
        }
        for y in [middle - 1.8, middle + 1.8] {
            drum(mesh, Vec3::new(ix, y, 0.16), 0.07, 0.8, of(Surface::Painted, [0.62, 0.42, 0.03]));
        }
    }
    pylon(mesh, Vec3::new(half - 0.8, 0.8, 0.0), finish);
}

/// A petrol pump: a cabinet with a display on either side and hoses.
fn pump(mesh: &mut MeshBuilder, at: Vec3, finish: &BuildingFinish) {
    let white = of(Surface::Painted, [0.62, 0.62, 0.60]);
    let (x, y, z) = (at.x, at.y, at.z);
    boxed(mesh, [x - 0.26, x + 0.26], [y - 0.42, y + 0.42], [z, z + 1.25], white);
    boxed(mesh, [x - 0.27, x + 0.27], [y - 0.43, y + 0.43], [z + 1.25, z + 1.75], finish.sign);
    let dark = of(Surface::CarGlass, [0.04; 3]);
    boxed(mesh, [x - 0.28, x + 0.28], [y - 0.28, y + 0.28], [z + 1.35, z + 1.62], dark);
    for k in 0..3 {
        let dy = -0.26 + 0.26 * k as f32;
        boxed(
            mesh,
            [x - 0.33, x + 0.33],
            [y + dy - 0.04, y + dy + 0.04],
            [z + 0.72, z + 1.0],
            of(Surface::Plastic, [0.02; 3]),
        );
    }
}

/// The board of prices.
fn pylon(mesh: &mut MeshBuilder, at: Vec3, finish: &BuildingFinish) {
    let wall = Wall::upright(at + Vec3::new(-0.7, -0.15, 0.0), Vec3::X, 1.4);
    boxed(
        mesh,
        [at.x - 0.7, at.x + 0.7],
        [at.y - 0.15, at.y + 0.15],
        [0.0, 5.4],
        of(Surface::Painted, [0.20, 0.21, 0.22]),
    );
    wall.block(mesh, [0.05, 1.35], [4.1, 5.3], [0.0, 0.03], finish.sign);
    let digits = Material::new(Surface::LitSign, [0.80, 0.55, 0.06], ClassTag::Buildings);
    for (k, price) in ["1-69", "1-82", "1-57"].into_iter().enumerate() {
        letters(mesh, &wall, ([0.1, 1.3], 3.6 - 0.75 * k as f32), 0.02, 0.48, price, digits);
    }
}

/// Decks behind parapets, open between, with columns, a stair and a ramp's shade within.
pub(super) fn parking_deck(
    mesh: &mut MeshBuilder,
    dimensions: &BuildingDimensions,
    finish: &BuildingFinish,
    rhythm: &FacadeRhythm,
) {
    let half = dimensions.width / 2.0;
    let (x, y) = ([-half, half], [0.0, dimensions.depth]);
    let height = rhythm.height(dimensions.storeys);
    let dark = of(Surface::Concrete, [0.10, 0.10, 0.098]);
    // What is seen inside is in the dark.
    let (ix, iy) = ([x[0] + 3.2, x[1] - 3.2], [y[0] + 3.2, y[1] - 3.2]);
    boxed(mesh, ix, iy, [0.0, height], dark);
    for storey in 0..=dimensions.storeys {
        let z = if storey == 0 { 0.0 } else { rhythm.ground + rhythm.storey * (storey - 1) as f32 };
        let low = if storey == 0 { 0.0 } else { z - 0.28 };
        boxed(mesh, x, y, [low, z + 0.02], finish.wall);
        if storey > 0 {
            for wall in walls(x, y, z) {
                wall.solid(mesh, [0.0, wall.width], [0.02, 1.02], [-0.16, 0.01], finish.accent);
            }
        } else {
            for (side, wall) in walls(x, y, z).iter().enumerate() {
                let gap =
                    if side == 0 { [wall.width / 2.0 - 3.2, wall.width / 2.0 + 3.2] } else { [wall.width, wall.width] };
                wall.solid(mesh, [0.0, gap[0]], [0.0, 1.0], [-0.16, 0.01], finish.accent);
                wall.solid(mesh, [gap[1], wall.width + 0.01], [0.0, 1.0], [-0.16, 0.01], finish.accent);
            }
        }
    }
    for wall in walls(x, y, 0.0) {
        let count = (wall.width / 5.0).round().max(1.0) as usize;
        for k in 0..=count {
            let u = (wall.width * k as f32 / count as f32 - 0.2).clamp(0.0, wall.width - 0.4);
            wall.solid(mesh, [u, u + 0.4], [0.0, height], [-0.5, 0.03], finish.wall);
        }
    }
    // Stair and lift.
    boxed(mesh, [x[1] - 4.2, x[1] - 0.2], [y[0] + 0.05, y[0] + 3.4], [0.0, height + 3.0], finish.wall);
    let front = Wall::upright(Vec3::new(x[1] - 4.2, y[0] + 0.05, 0.0), Vec3::X, 4.0);
    front.block(mesh, [1.4, 2.6], [0.0, height + 2.4], [0.0, 0.03], of(Surface::CarGlass, [0.07, 0.09, 0.10]));
    let blue = Material::new(Surface::LitSign, [0.02, 0.10, 0.42], ClassTag::Buildings);
    front.block(mesh, [0.2, 1.2], [height + 1.5, height + 2.6], [0.0, 0.1], blue);
    let white = Material { base_color: [0.80; 3], ..blue };
    letters(mesh, &front, ([0.2, 1.2], height + 2.05), 0.106, 0.8, "P", white);
    let entrance = Wall::upright(Vec3::new(-3.2, 0.0, 0.0), Vec3::X, 6.4);
    entrance.solid(
        mesh,
        [0.0, 6.4],
        [rhythm.ground - 0.6, rhythm.ground - 0.05],
        [0.0, 0.08],
        Material { base_color: [0.62, 0.42, 0.02], ..blue },
    );
    letters(
        mesh,
        &entrance,
        ([0.0, 3.2], rhythm.ground - 0.32),
        0.086,
        0.3,
        "IN 2-1",
        Material { base_color: [0.02; 3], ..blue },
    );
    letters(
        mesh,
        &entrance,
        ([3.2, 6.4], rhythm.ground - 0.32),
        0.086,
        0.3,
        "OUT",
        Material { base_color: [0.02; 3], ..blue },
    );
}
