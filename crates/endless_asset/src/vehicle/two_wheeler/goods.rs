//! What is carried behind the rider.

use super::*;
use crate::vehicle::freight::Freight;

/// The box of who delivers meals.
pub(super) fn delivery_box(draw: &DesignDraw, at: Vec3) -> impl FnOnce(&mut Assembly) + 'static {
    let color = draw.pick("box", &[paint::ORANGE, paint::RED, paint::YELLOW, paint::LIME, paint::TEAL, paint::TRIM]);
    let half = Vec3::new(0.20, draw.range("box width", 0.20, 0.235), draw.range("box height", 0.19, 0.23));
    move |a| {
        let middle = at + Vec3::Z * half.z;
        let mut case = Sculpt::cuboid(middle - half, middle + half, 0.03, color);
        let label = Region::all().within(Vec3::Z, at.z + 1.45 * half.z).beyond(Vec3::Z, at.z + 0.6 * half.z);
        for (face, along) in [(Vec3::Y, Vec3::X), (-Vec3::Y, Vec3::X), (-Vec3::X, Vec3::Y)] {
            let patch = label.clone().within(along, at.dot(along) + 0.13).beyond(along, at.dot(along) - 0.13);
            case.paint(&patch.facing(face, 0.9), paint::WHITE);
        }
        a.body.add(case);
        a.body.add(Sculpt::cuboid(
            at - Vec3::new(0.16, 0.12, 0.03),
            at + Vec3::new(0.16, 0.12, 0.01),
            0.0,
            paint::CHASSIS,
        ));
    }
}

/// A box as above, or crates, cartons or sacks on a rack, or panniers beside it.
pub(super) fn loaded(draw: &DesignDraw, at: Vec3) -> impl FnOnce(&mut Assembly) + 'static {
    let case = delivery_box(draw, at);
    let kind = draw.pick("goods", &[None, None, Some(Freight::Crates), Some(Freight::Cartons), Some(Freight::Sacks)]);
    let panniers = draw.chance("panniers", 0.3);
    let half = draw.range("goods width", 0.24, 0.34);
    let high = draw.range("goods height", 0.32, 0.42);
    let seed = draw.range("pieces", 0.0, 1e6) as u64;
    move |a| {
        match kind {
            None => case(a),
            Some(freight) => {
                let low = at - Vec3::new(0.25, half, 0.0);
                a.body.add(Sculpt::cuboid(low - Vec3::Z * 0.03, at + Vec3::new(0.20, half, 0.0), 0.0, paint::CHASSIS));
                a.body.add(freight.on(low, Vec2::new(at.x + 0.20, half), high, seed));
            }
        }
        if panniers {
            let low = at + Vec3::new(-0.24, 0.15, -0.40);
            let bag = Sculpt::cuboid(low, low + Vec3::new(0.40, 0.15, 0.34), 0.04, paint::TRIM);
            a.body.add(bag.both_sides());
        }
    }
}
