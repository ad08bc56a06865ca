//! Scooters with a floor to put the feet on.

use super::*;

fn blueprint() -> VehicleBlueprint {
    VehicleBlueprint::new(size([0.9, -0.95], 0.74, 1.30, [0.62, -0.64], 0.225), scooter_parts)
}

pub(crate) fn scooter(draw: &DesignDraw) -> VehicleBlueprint {
    framed(draw, blueprint())
}

/// The same as it is ridden where it is a family's vehicle.
pub(crate) fn scooter_for_two(draw: &DesignDraw) -> VehicleBlueprint {
    let pillion = PillionFit { share: 0.38, seat: v(-0.64, 0.0, 0.815), foot: v(-0.34, 0.22, 0.33), helmet: 0.6 };
    framed(draw, for_two(blueprint(), 0.80, pillion))
}

/// The same with a box behind.
pub(crate) fn moped_delivery(draw: &DesignDraw) -> VehicleBlueprint {
    framed(draw, blueprint().with(delivery_box(draw, v(-0.74, 0.0, 0.86))))
}

fn scooter_parts() -> Assembly {
    let r = 0.225;
    let (front, rear) = (0.62, -0.64);
    let mut s = Sculpt::new();
    s.add(rod(v(front, 0.065, r), v(0.47, 0.065, 0.62), 0.022, paint::STEEL).both_sides());
    s.add(rod(v(0.50, 0.0, 0.55), v(0.40, 0.0, 1.0), 0.03, paint::CHASSIS));
    s.add(mudguard(v(front, 0.0, r), r + 0.035, 0.075, 5.0, 165.0, paint::BODY));
    // Leg shield, from the floor up to the handlebar cowl.
    s.add(hull(
        &[
            (v(0.30, 0.0, 0.28), 0.17, 0.03),
            (v(0.40, 0.0, 0.36), 0.20, 0.05),
            (v(0.46, 0.0, 0.58), 0.215, 0.055),
            (v(0.45, 0.0, 0.76), 0.175, 0.06),
            (v(0.42, 0.0, 0.90), 0.09, 0.05),
        ],
        paint::BODY,
    ));
    s.add(hull(
        &[(v(0.36, 0.0, 0.35), 0.17, 0.03), (v(0.385, 0.0, 0.60), 0.19, 0.03), (v(0.37, 0.0, 0.80), 0.14, 0.03)],
        paint::TRIM,
    ));
    let mut cowl = hull(
        &[
            (v(0.50, 0.0, 0.96), 0.07, 0.05),
            (v(0.43, 0.0, 0.99), 0.14, 0.075),
            (v(0.34, 0.0, 1.0), 0.12, 0.05),
            (v(0.30, 0.0, 1.0), 0.06, 0.03),
        ],
        paint::BODY,
    );
    cowl.paint(&Region::all().beyond(Vec3::X, 0.455).facing(Vec3::X, 0.1).beyond(Vec3::Z, 0.93), paint::HEAD);
    s.add(cowl);
    mirrors_and_bars(&mut s, v(0.36, 0.0, 0.99), v(0.28, 0.32, 1.02));
    indicators(&mut s, v(0.49, 0.15, 0.78));
    // Floor, with the trim of its edges, and the belly.
    s.add(Sculpt::cuboid(v(-0.22, -0.20, 0.24), v(0.36, 0.20, 0.30), 0.03, paint::TRIM));
    s.add(Sculpt::cuboid(v(-0.20, -0.16, 0.17), v(0.30, 0.16, 0.25), 0.04, paint::ENGINE));
    // Seat body, bulging over the engine, and the seat.
    s.add(hull(
        &[
            (v(-0.16, 0.0, 0.47), 0.12, 0.20),
            (v(-0.26, 0.0, 0.50), 0.175, 0.22),
            (v(-0.50, 0.0, 0.56), 0.195, 0.16),
            (v(-0.74, 0.0, 0.63), 0.15, 0.10),
            (v(-0.90, 0.0, 0.68), 0.07, 0.05),
        ],
        paint::BODY,
    ));
    s.add(hull(
        &[
            (v(-0.10, 0.0, 0.72), 0.08, 0.03),
            (v(-0.22, 0.0, 0.735), 0.145, 0.05),
            (v(-0.48, 0.0, 0.745), 0.155, 0.05),
            (v(-0.72, 0.0, 0.775), 0.12, 0.04),
            (v(-0.80, 0.0, 0.785), 0.06, 0.02),
        ],
        paint::SEAT,
    ));
    s.add(Sculpt::cuboid(v(-0.34, 0.03, 0.16), v(-0.70, 0.15, 0.32).max(v(-0.30, 0.15, 0.32)), 0.04, paint::ENGINE));
    s.add(Sculpt::tube(
        &[
            (v(-0.30, -0.12, 0.22), 0.03),
            (v(-0.42, -0.16, 0.25), 0.055),
            (v(-0.80, -0.17, 0.32), 0.058),
            (v(-0.84, -0.17, 0.33), 0.03),
        ],
        12,
        paint::STEEL,
    ));
    s.add(rod(v(rear, 0.13, r), v(-0.62, 0.13, 0.55), 0.026, paint::STEEL).both_sides());
    s.add(Sculpt::cuboid(v(-0.96, -0.10, 0.63), v(-0.86, 0.10, 0.70), 0.025, paint::TAIL));
    indicators(&mut s, v(-0.88, 0.13, 0.66));
    s.add(
        Sculpt::tube(
            &[(v(-0.52, 0.15, 0.78), 0.012), (v(-0.84, 0.12, 0.84), 0.012), (v(-0.90, 0.0, 0.85), 0.012)],
            6,
            paint::CHROME,
        )
        .both_sides(),
    );
    s.add(mudguard(v(rear, 0.0, r), r + 0.05, 0.07, 80.0, 165.0, paint::TRIM));
    s.add(Sculpt::cuboid(v(-0.935, -0.09, 0.42), v(-0.92, 0.09, 0.57), 0.0, paint::PLATE));
    let mut a = Assembly::new(s, wheel(r, 0.11, 0.66, Rim::Alloy(5), paint::DARK_ALLOY), r);
    a.single(front, true);
    a.single(rear, false);
    a.headlights = vec![v(0.50, 0.0, 0.98)];
    a.fit = Some(RiderFit {
        seat: v(-0.32, 0.0, 0.785),
        grip: v(0.27, 0.32, 1.025),
        foot: v(0.16, 0.13, 0.30),
        right_foot: Vec3::ZERO,
        lean_rad: 0.02,
        helmet: 0.93,
        helmets: HelmetKind::Full,
        outfit: Outfit::Fair,
        standing: false,
        pillion: None,
    });
    a
}
