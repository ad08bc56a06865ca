//! Underbones: the motorcycle of most of South-East Asia, stepped through, on thin wheels as large as a bicycle's rims allow.

use super::*;

const FRONT: f32 = 0.62;
const REAR: f32 = -0.62;
const R: f32 = 0.275;

fn blueprint() -> VehicleBlueprint {
    VehicleBlueprint::new(size([0.915, -0.965], 0.70, 1.265, [FRONT, REAR], R), underbone_parts)
}

/// With room for two.
pub(crate) fn underbone(draw: &DesignDraw) -> VehicleBlueprint {
    let basket = draw.chance("basket", 0.35);
    framed(draw, blueprint().with(move |a| a.body.add(if basket { front_basket() } else { Sculpt::new() })))
}

/// With goods where the passenger would sit.
pub(crate) fn underbone_delivery(draw: &DesignDraw) -> VehicleBlueprint {
    let goods = loaded(draw, v(-0.62, 0.0, 0.83));
    framed(draw, blueprint().with(goods).with(|a| a.fit = a.fit.map(|f| RiderFit { pillion: None, ..f })))
}

/// Wire before the leg shield.
fn front_basket() -> Sculpt {
    let mut s = Sculpt::new();
    let (low, high) = (v(0.50, -0.14, 0.66), v(0.72, 0.14, 0.86));
    for z in [low.z, high.z] {
        let rim = [v(low.x, low.y, z), v(high.x, low.y, z), v(high.x, high.y, z), v(low.x, high.y, z)];
        for k in 0..4 {
            s.add(rod(rim[k], rim[(k + 1) % 4], 0.007, paint::STEEL));
        }
    }
    for i in 0..=3 {
        let t = i as f32 / 3.0;
        let y = low.y + t * (high.y - low.y);
        let x = low.x + t * (high.x - low.x);
        s.add(rod(v(high.x, y, low.z), v(high.x, y, high.z), 0.004, paint::STEEL));
        s.add(rod(v(low.x, y, low.z), v(high.x, y, low.z), 0.004, paint::STEEL));
        s.add(rod(v(x, high.y, low.z), v(x, high.y, high.z), 0.004, paint::STEEL).both_sides());
    }
    s
}

fn underbone_parts() -> Assembly {
    let mut s = Sculpt::new();
    s.add(rod(v(FRONT, 0.07, R), v(0.42, 0.06, 0.78), 0.023, paint::STEEL).both_sides());
    s.add(rod(v(0.44, 0.0, 0.72), v(0.36, 0.0, 0.98), 0.03, paint::CHASSIS));
    s.add(mudguard(v(FRONT, 0.0, R), R + 0.035, 0.06, 15.0, 170.0, paint::BODY));
    // The shield before the shins, in two wings beside a dark spine.
    let wing = [
        (v(0.16, 0.17, 0.30), 0.06, 0.02),
        (v(0.28, 0.18, 0.40), 0.075, 0.028),
        (v(0.37, 0.165, 0.60), 0.085, 0.03),
        (v(0.38, 0.11, 0.78), 0.09, 0.03),
    ];
    s.add(hull(&wing, paint::BODY).both_sides());
    s.add(hull(
        &[(v(0.47, 0.0, 0.60), 0.10, 0.05), (v(0.45, 0.0, 0.76), 0.115, 0.06), (v(0.40, 0.0, 0.88), 0.09, 0.05)],
        paint::BODY,
    ));
    // Handlebar cowl with lamp and clocks.
    let mut cowl = hull(
        &[
            (v(0.49, 0.0, 0.93), 0.08, 0.06),
            (v(0.42, 0.0, 0.96), 0.125, 0.075),
            (v(0.33, 0.0, 0.97), 0.11, 0.045),
            (v(0.28, 0.0, 0.97), 0.05, 0.025),
        ],
        paint::BODY,
    );
    cowl.paint(&Region::all().beyond(Vec3::X, 0.44).facing(Vec3::X, 0.1).beyond(Vec3::Z, 0.90), paint::HEAD);
    s.add(cowl);
    mirrors_and_bars(&mut s, v(0.34, 0.0, 0.96), v(0.24, 0.31, 0.985));
    indicators(&mut s, v(0.45, 0.15, 0.82));
    // The tube to step over, the level engine under it.
    let spine = [
        (v(0.38, 0.0, 0.72), 0.05),
        (v(0.20, 0.0, 0.46), 0.055),
        (v(-0.02, 0.0, 0.44), 0.06),
        (v(-0.20, 0.0, 0.56), 0.06),
    ];
    s.add(Sculpt::tube(&spine, 10, paint::BODY));
    s.add(Sculpt::cuboid(v(-0.14, -0.12, 0.21), v(0.14, 0.12, 0.36), 0.04, paint::ENGINE));
    s.add(rod(v(0.10, 0.0, 0.29), v(0.28, 0.0, 0.31), 0.065, paint::ENGINE));
    s.add(Sculpt::ellipsoid(v(-0.04, 0.0, 0.28), v(0.10, 0.15, 0.085), 12, paint::ENGINE));
    let pipe = [(v(0.24, -0.04, 0.27), 0.018), (v(0.10, -0.12, 0.19), 0.02), (v(-0.22, -0.15, 0.21), 0.024)];
    s.add(Sculpt::tube(&pipe, 8, paint::STEEL));
    let silencer = [(v(-0.22, -0.15, 0.21), 0.032), (v(-0.32, -0.155, 0.25), 0.046), (v(-0.80, -0.16, 0.38), 0.048)];
    s.add(Sculpt::tube(&silencer, 12, paint::CHROME));
    // Flanks under the long seat.
    s.add(hull(
        &[
            (v(-0.10, 0.0, 0.55), 0.09, 0.11),
            (v(-0.24, 0.0, 0.59), 0.125, 0.12),
            (v(-0.50, 0.0, 0.66), 0.12, 0.075),
            (v(-0.76, 0.0, 0.73), 0.085, 0.045),
            (v(-0.88, 0.0, 0.76), 0.05, 0.03),
        ],
        paint::BODY,
    ));
    s.add(hull(
        &[
            (v(-0.02, 0.0, 0.70), 0.06, 0.025),
            (v(-0.14, 0.0, 0.715), 0.11, 0.045),
            (v(-0.38, 0.0, 0.735), 0.13, 0.05),
            (v(-0.64, 0.0, 0.775), 0.115, 0.042),
            (v(-0.78, 0.0, 0.79), 0.07, 0.025),
        ],
        paint::SEAT,
    ));
    let rail = [(v(-0.50, 0.13, 0.755), 0.011), (v(-0.82, 0.10, 0.84), 0.012), (v(-0.87, 0.0, 0.85), 0.012)];
    s.add(Sculpt::tube(&rail, 6, paint::STEEL).both_sides());
    s.add(Sculpt::cuboid(v(-0.935, -0.075, 0.70), v(-0.86, 0.075, 0.77), 0.02, paint::TAIL));
    indicators(&mut s, v(-0.86, 0.14, 0.70));
    s.add(mudguard(v(REAR, 0.0, R), R + 0.05, 0.06, 70.0, 165.0, paint::TRIM));
    s.add(Sculpt::cuboid(v(-0.945, -0.08, 0.46), v(-0.925, 0.08, 0.60), 0.0, paint::PLATE));
    s.add(rod(v(-0.12, 0.07, 0.33), v(REAR, 0.09, R), 0.022, paint::CHASSIS).both_sides());
    s.add(rod(v(REAR, 0.115, R), v(-0.48, 0.115, 0.66), 0.026, paint::CHROME).both_sides());
    s.add(rod(v(0.06, -0.25, 0.24), v(0.06, 0.25, 0.24), 0.014, paint::RUBBER));
    s.add(rod(v(-0.34, 0.11, 0.33), v(-0.34, 0.22, 0.33), 0.012, paint::RUBBER).both_sides());
    let mut a = Assembly::new(s, wheel(R, 0.08, 0.82, Rim::Alloy(5), paint::DARK_ALLOY), R);
    a.single(FRONT, true);
    a.single(REAR, false);
    a.headlights = vec![v(0.50, 0.0, 0.95)];
    a.fit = Some(RiderFit {
        seat: v(-0.19, 0.0, 0.785),
        grip: v(0.23, 0.31, 0.99),
        foot: v(0.08, 0.18, 0.255),
        right_foot: Vec3::ZERO,
        lean_rad: 0.06,
        helmet: 0.82,
        helmets: HelmetKind::Open,
        outfit: Outfit::Hot,
        standing: false,
        pillion: Some(PillionFit { share: 0.34, seat: v(-0.53, 0.0, 0.82), foot: v(-0.32, 0.19, 0.345), helmet: 0.6 }),
    });
    a
}
