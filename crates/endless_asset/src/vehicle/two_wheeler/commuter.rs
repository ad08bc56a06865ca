//! The motorcycle that most people ride to work.

use super::*;

fn blueprint() -> VehicleBlueprint {
    VehicleBlueprint::new(size([0.975, -0.99], 0.78, 1.32, [0.66, -0.65], 0.295), commuter_parts)
}

/// With a round headlamp and an air-cooled engine.
pub(crate) fn commuter(draw: &DesignDraw) -> VehicleBlueprint {
    framed(draw, blueprint())
}

/// The same as it is ridden where it is a family's vehicle.
pub(crate) fn commuter_for_two(draw: &DesignDraw) -> VehicleBlueprint {
    let pillion = PillionFit { share: 0.38, seat: v(-0.57, 0.0, 0.88), foot: v(-0.40, 0.20, 0.375), helmet: 0.55 };
    framed(draw, for_two(blueprint(), 0.78, pillion))
}

/// The same with a box behind.
pub(crate) fn delivery(draw: &DesignDraw) -> VehicleBlueprint {
    framed(draw, blueprint().with(delivery_box(draw, v(-0.72, 0.0, 0.915))))
}

fn commuter_parts() -> Assembly {
    let r = 0.295;
    let (front, rear) = (0.66, -0.65);
    let mut s = Sculpt::new();
    // Fork, with its headlamp and clocks.
    let head = v(0.40, 0.0, 0.92);
    s.add(rod(v(front, 0.075, r), v(0.425, 0.075, 0.90), 0.024, paint::STEEL).both_sides());
    s.add(rod(v(front, 0.075, r), v(0.545, 0.075, 0.60), 0.031, paint::ENGINE).both_sides());
    s.add(Sculpt::cuboid(head - v(0.04, 0.11, 0.03), head + v(0.05, 0.11, 0.02), 0.015, paint::ENGINE));
    let mut lamp = Sculpt::ellipsoid(v(0.50, 0.0, 0.86), v(0.10, 0.095, 0.095), 16, paint::BODY);
    lamp.paint(&Region::all().beyond(Vec3::X, 0.535), paint::HEAD);
    s.add(lamp);
    s.add(hull(
        &[(v(0.52, 0.0, 0.94), 0.07, 0.02), (v(0.44, 0.0, 1.02), 0.10, 0.03), (v(0.38, 0.0, 1.03), 0.08, 0.02)],
        paint::TRIM,
    ));
    s.add(mudguard(v(front, 0.0, r), r + 0.04, 0.062, 25.0, 165.0, paint::BODY));
    mirrors_and_bars(&mut s, head + v(-0.02, 0.0, 0.06), v(0.28, 0.34, 1.04));
    indicators(&mut s, v(0.44, 0.17, 0.84));
    // Frame, engine, exhaust.
    s.add(Sculpt::tube(
        &[(head, 0.024), (v(0.30, 0.0, 0.60), 0.020), (v(0.22, 0.0, 0.26), 0.020), (v(-0.20, 0.0, 0.24), 0.020)],
        8,
        paint::CHASSIS,
    ));
    s.add(Sculpt::tube(&[(head, 0.028), (v(0.05, 0.0, 0.78), 0.024), (v(-0.55, 0.0, 0.74), 0.018)], 8, paint::CHASSIS));
    s.add(Sculpt::cuboid(v(-0.20, -0.13, 0.24), v(0.16, 0.13, 0.44), 0.05, paint::ENGINE));
    s.add(Sculpt::ellipsoid(v(-0.07, 0.0, 0.34), v(0.13, 0.165, 0.11), 12, paint::ENGINE));
    for i in 0..7 {
        let z = 0.44 + 0.03 * i as f32;
        let x = 0.10 + 0.01 * i as f32;
        s.add(Sculpt::cuboid(v(x - 0.09, -0.085, z), v(x + 0.08, 0.085, z + 0.016), 0.0, paint::ENGINE));
    }
    s.add(Sculpt::cuboid(v(0.04, -0.06, 0.42), v(0.16, 0.06, 0.66), 0.02, paint::CHASSIS));
    let pipe = [
        (v(0.20, -0.05, 0.55), 0.022),
        (v(0.30, -0.10, 0.42), 0.022),
        (v(0.18, -0.13, 0.24), 0.022),
        (v(-0.25, -0.16, 0.22), 0.024),
    ];
    s.add(Sculpt::tube(&pipe, 8, paint::STEEL));
    s.add(Sculpt::tube(
        &[
            (v(-0.25, -0.16, 0.22), 0.030),
            (v(-0.34, -0.17, 0.25), 0.048),
            (v(-0.82, -0.18, 0.36), 0.052),
            (v(-0.86, -0.18, 0.37), 0.03),
        ],
        12,
        paint::CHROME,
    ));
    // Tank, side panels, seat, tail.
    s.add(hull(
        &[
            (v(0.36, 0.0, 0.83), 0.07, 0.05),
            (v(0.28, 0.0, 0.85), 0.125, 0.095),
            (v(0.12, 0.0, 0.855), 0.145, 0.105),
            (v(-0.04, 0.0, 0.83), 0.12, 0.085),
            (v(-0.14, 0.0, 0.80), 0.08, 0.05),
        ],
        paint::BODY,
    ));
    s.add(Sculpt::post(v(0.14, 0.0, 0.955), 0.014, 0.035, 0.03, 12, paint::CHROME));
    s.add(hull(
        &[(v(0.0, 0.0, 0.66), 0.10, 0.09), (v(-0.2, 0.0, 0.66), 0.115, 0.08), (v(-0.42, 0.0, 0.70), 0.09, 0.05)],
        paint::BODY,
    ));
    s.add(hull(
        &[
            (v(-0.08, 0.0, 0.80), 0.07, 0.03),
            (v(-0.18, 0.0, 0.785), 0.12, 0.045),
            (v(-0.40, 0.0, 0.79), 0.135, 0.05),
            (v(-0.62, 0.0, 0.83), 0.11, 0.045),
            (v(-0.74, 0.0, 0.85), 0.07, 0.03),
        ],
        paint::SEAT,
    ));
    s.add(hull(
        &[(v(-0.35, 0.0, 0.715), 0.10, 0.045), (v(-0.62, 0.0, 0.755), 0.09, 0.04), (v(-0.84, 0.0, 0.80), 0.055, 0.028)],
        paint::BODY,
    ));
    s.add(
        Sculpt::tube(
            &[(v(-0.45, 0.13, 0.80), 0.011), (v(-0.80, 0.11, 0.90), 0.011), (v(-0.86, 0.0, 0.91), 0.011)],
            6,
            paint::CHROME,
        )
        .both_sides(),
    );
    s.add(Sculpt::cuboid(v(-0.90, -0.07, 0.735), v(-0.83, 0.07, 0.80), 0.02, paint::TAIL));
    s.add(mudguard(v(rear, 0.0, r), r + 0.05, 0.07, 60.0, 165.0, paint::TRIM));
    s.add(Sculpt::cuboid(v(-0.945, -0.09, 0.50), v(-0.925, 0.09, 0.66), 0.0, paint::PLATE));
    indicators(&mut s, v(-0.84, 0.15, 0.71));
    // Swing arm, shock absorbers, chain case, pegs, stand.
    s.add(rod(v(-0.14, 0.07, 0.38), v(rear, 0.09, r), 0.022, paint::CHASSIS).both_sides());
    s.add(rod(v(rear, 0.12, r), v(-0.45, 0.12, 0.72), 0.030, paint::CHROME).both_sides());
    s.add(Sculpt::cuboid(v(rear - 0.02, 0.085, r - 0.045), v(-0.15, 0.105, r + 0.085), 0.015, paint::CHASSIS));
    s.add(rod(v(-0.02, 0.12, 0.29), v(-0.02, 0.27, 0.29), 0.014, paint::RUBBER).both_sides());
    s.add(rod(v(-0.42, 0.12, 0.36), v(-0.42, 0.23, 0.36), 0.012, paint::RUBBER).both_sides());
    let mut a = Assembly::new(s, wheel(r, 0.10, 0.80, Rim::Alloy(6), paint::DARK_ALLOY), r);
    a.single(front, true);
    a.single(rear, false);
    a.headlights = vec![v(0.59, 0.0, 0.86)];
    a.fit = Some(RiderFit {
        seat: v(-0.22, 0.0, 0.835),
        grip: v(0.27, 0.34, 1.045),
        foot: v(0.0, 0.20, 0.30),
        right_foot: Vec3::ZERO,
        lean_rad: 0.16,
        helmet: 0.97,
        helmets: HelmetKind::Full,
        outfit: Outfit::Fair,
        standing: false,
        pillion: None,
    });
    a
}
