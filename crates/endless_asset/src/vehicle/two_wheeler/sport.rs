//! A sport motorcycle: fairing, low bars, high tail.

use super::*;

pub(crate) fn sport(draw: &DesignDraw) -> VehicleBlueprint {
    framed(draw, VehicleBlueprint::new(size([0.99, -0.99], 0.74, 1.16, [0.69, -0.69], 0.30), parts))
}

fn parts() -> Assembly {
    let r = 0.30;
    let (front, rear) = (0.69, -0.69);
    let mut s = Sculpt::new();
    s.add(rod(v(front, 0.085, r), v(0.49, 0.085, 0.86), 0.028, paint::BRIGHT_STEEL).both_sides());
    s.add(mudguard(v(front, 0.0, r), r + 0.03, 0.065, 40.0, 150.0, paint::BODY));
    // The fairing: nose with two lamps, a screen, and flanks down to the belly.
    let mut nose = hull(
        &[
            (v(0.80, 0.0, 0.86), 0.05, 0.04),
            (v(0.72, 0.0, 0.90), 0.13, 0.10),
            (v(0.58, 0.0, 0.93), 0.19, 0.13),
            (v(0.42, 0.0, 0.90), 0.205, 0.12),
        ],
        paint::BODY,
    );
    let lamp = Region::all().beyond(Vec3::X, 0.60).within(Vec3::Z, 0.90).beyond(Vec3::Z, 0.83);
    nose.paint(&lamp.clone().beyond(Vec3::Y, 0.025), paint::HEAD);
    nose.paint(&lamp.within(Vec3::Y, -0.025), paint::HEAD);
    s.add(nose);
    s.add(hull(
        &[(v(0.70, 0.0, 0.97), 0.06, 0.02), (v(0.58, 0.0, 1.06), 0.135, 0.03), (v(0.48, 0.0, 1.12), 0.10, 0.02)],
        paint::GLASS,
    ));
    s.add(hull(
        &[
            (v(0.50, 0.0, 0.62), 0.19, 0.22),
            (v(0.30, 0.0, 0.52), 0.205, 0.24),
            (v(0.05, 0.0, 0.42), 0.175, 0.20),
            (v(-0.18, 0.0, 0.34), 0.11, 0.12),
        ],
        paint::BODY,
    ));
    s.add(hull(
        &[(v(0.36, 0.0, 0.40), 0.207, 0.05), (v(0.12, 0.0, 0.36), 0.195, 0.05), (v(-0.05, 0.0, 0.34), 0.165, 0.04)],
        paint::TRIM,
    ));
    s.add(Sculpt::cuboid(v(-0.24, -0.14, 0.26), v(0.28, 0.14, 0.62), 0.05, paint::ENGINE));
    // Tank, seat, tail.
    s.add(hull(
        &[
            (v(0.40, 0.0, 0.84), 0.10, 0.07),
            (v(0.26, 0.0, 0.87), 0.155, 0.11),
            (v(0.06, 0.0, 0.86), 0.15, 0.10),
            (v(-0.12, 0.0, 0.80), 0.09, 0.06),
        ],
        paint::BODY,
    ));
    s.add(hull(
        &[(v(-0.06, 0.0, 0.79), 0.09, 0.04), (v(-0.26, 0.0, 0.80), 0.135, 0.045), (v(-0.42, 0.0, 0.84), 0.12, 0.04)],
        paint::SEAT,
    ));
    s.add(hull(
        &[
            (v(-0.20, 0.0, 0.72), 0.11, 0.06),
            (v(-0.50, 0.0, 0.82), 0.115, 0.06),
            (v(-0.76, 0.0, 0.91), 0.085, 0.045),
            (v(-0.92, 0.0, 0.96), 0.04, 0.02),
        ],
        paint::BODY,
    ));
    s.add(hull(&[(v(-0.50, 0.0, 0.90), 0.09, 0.02), (v(-0.72, 0.0, 0.955), 0.085, 0.022)], paint::SEAT));
    s.add(Sculpt::cuboid(v(-0.935, -0.06, 0.90), v(-0.86, 0.06, 0.95), 0.018, paint::TAIL));
    // Frame, swing arm, exhaust, bars.
    s.add(rod(v(0.42, 0.10, 0.84), v(-0.14, 0.12, 0.50), 0.035, paint::CHASSIS).both_sides());
    s.add(rod(v(-0.14, 0.10, 0.42), v(rear, 0.11, r), 0.03, paint::BRIGHT_STEEL).both_sides());
    let pipe = [
        (v(0.10, -0.08, 0.24), 0.04),
        (v(-0.25, -0.13, 0.26), 0.045),
        (v(-0.50, -0.19, 0.40), 0.06),
        (v(-0.80, -0.20, 0.56), 0.055),
    ];
    s.add(Sculpt::tube(&pipe, 12, paint::STEEL));
    let grip = v(0.40, 0.31, 0.90);
    s.add(rod(v(0.46, 0.08, 0.90), grip, 0.014, paint::CHASSIS).both_sides());
    s.add(rod(grip + v(0.01, -0.07, 0.0), grip + v(-0.02, 0.06, 0.0), 0.019, paint::RUBBER).both_sides());
    s.add(rod(v(0.60, 0.12, 1.0), v(0.50, 0.27, 1.10), 0.008, paint::TRIM).both_sides());
    s.add(Sculpt::ellipsoid(v(0.49, 0.29, 1.115), v(0.03, 0.075, 0.04), 10, paint::BODY).both_sides());
    indicators(&mut s, v(-0.82, 0.13, 0.80));
    indicators(&mut s, v(0.62, 0.21, 0.80));
    s.add(rod(v(-0.72, 0.0, 0.86), v(-0.94, 0.0, 0.62), 0.012, paint::TRIM));
    s.add(Sculpt::cuboid(v(-0.96, -0.09, 0.56), v(-0.945, 0.09, 0.70), 0.0, paint::PLATE));
    s.add(rod(v(-0.26, 0.11, 0.40), v(-0.26, 0.24, 0.40), 0.014, paint::RUBBER).both_sides());
    let mut a = Assembly::new(s, wheel(r, 0.15, 0.72, Rim::Alloy(5), paint::DARK_ALLOY), r);
    a.single(front, true);
    a.single(rear, false);
    a.headlights = vec![v(0.76, 0.0, 0.87)];
    a.fit = Some(RiderFit {
        seat: v(-0.26, 0.0, 0.84),
        grip,
        foot: v(-0.22, 0.18, 0.41),
        right_foot: Vec3::ZERO,
        lean_rad: 0.70,
        helmet: 0.98,
        helmets: HelmetKind::Full,
        outfit: Outfit::Fair,
        standing: false,
        pillion: None,
    });
    a
}
