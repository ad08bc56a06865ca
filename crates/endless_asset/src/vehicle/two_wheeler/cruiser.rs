//! A cruiser: long fork, low seat, feet ahead.

use super::*;

pub(crate) fn cruiser(draw: &DesignDraw) -> VehicleBlueprint {
    let bags = draw.chance("saddle bags", 0.5);
    let blueprint = VehicleBlueprint::new(size([1.135, -1.10], 0.86, 1.28, [0.81, -0.78], 0.315), parts);
    let blueprint = blueprint.with(move |a| {
        if bags {
            let bag = Sculpt::cuboid(v(-0.98, 0.16, 0.34), v(-0.54, 0.33, 0.66), 0.06, paint::SEAT);
            a.body.add(bag.both_sides());
        }
    });
    framed(draw, blueprint)
}

fn parts() -> Assembly {
    let r = 0.315;
    let (front, rear) = (0.81, -0.78);
    let mut s = Sculpt::new();
    let head = v(0.42, 0.0, 0.88);
    s.add(rod(v(front, 0.09, r), v(0.44, 0.09, 0.92), 0.024, paint::CHROME).both_sides());
    s.add(mudguard(v(front, 0.0, r), r + 0.035, 0.075, 15.0, 165.0, paint::BODY));
    let mut lamp = Sculpt::ellipsoid(v(0.58, 0.0, 0.86), v(0.11, 0.09, 0.09), 16, paint::CHROME);
    lamp.paint(&Region::all().beyond(Vec3::X, 0.61), paint::HEAD);
    s.add(lamp);
    let grip = v(0.10, 0.38, 1.06);
    mirrors_and_bars(&mut s, head + v(0.0, 0.0, 0.04), grip);
    indicators(&mut s, v(0.52, 0.17, 0.74));
    // Frame, the two cylinders in a V, exhausts.
    s.add(Sculpt::tube(
        &[(head, 0.026), (v(0.36, 0.0, 0.28), 0.022), (v(-0.30, 0.0, 0.20), 0.022), (v(-0.42, 0.0, 0.55), 0.022)],
        8,
        paint::CHASSIS,
    ));
    s.add(Sculpt::tube(&[(head, 0.03), (v(0.0, 0.0, 0.66), 0.026), (v(-0.50, 0.0, 0.56), 0.02)], 8, paint::CHASSIS));
    s.add(Sculpt::cuboid(v(-0.28, -0.15, 0.18), v(0.24, 0.15, 0.40), 0.07, paint::ENGINE));
    for tilt in [-0.38f32, 0.42] {
        for i in 0..6 {
            let z = 0.40 + 0.036 * i as f32;
            let x = 0.0 + tilt * (z - 0.28) * 1.3;
            s.add(Sculpt::cuboid(v(x - 0.085, -0.09, z), v(x + 0.085, 0.09, z + 0.02), 0.0, paint::BRIGHT_STEEL));
        }
    }
    s.add(Sculpt::ellipsoid(v(0.02, -0.12, 0.48), v(0.09, 0.07, 0.07), 12, paint::CHROME));
    for z in [0.24, 0.33] {
        let pipe = [
            (v(0.16, -0.10, z + 0.16), 0.024),
            (v(0.10, -0.17, z), 0.026),
            (v(-0.30, -0.19, z), 0.042),
            (v(-0.95, -0.20, z + 0.02), 0.046),
        ];
        s.add(Sculpt::tube(&pipe, 10, paint::CHROME));
    }
    // Tank, saddle, tail.
    s.add(hull(
        &[
            (v(0.38, 0.0, 0.84), 0.06, 0.05),
            (v(0.24, 0.0, 0.83), 0.14, 0.10),
            (v(0.06, 0.0, 0.78), 0.145, 0.095),
            (v(-0.10, 0.0, 0.71), 0.07, 0.05),
        ],
        paint::BODY,
    ));
    s.add(hull(
        &[
            (v(-0.08, 0.0, 0.69), 0.08, 0.04),
            (v(-0.28, 0.0, 0.655), 0.175, 0.06),
            (v(-0.48, 0.0, 0.70), 0.15, 0.06),
            (v(-0.78, 0.0, 0.75), 0.11, 0.045),
        ],
        paint::SEAT,
    ));
    s.add(mudguard(v(rear, 0.0, r), r + 0.055, 0.10, 25.0, 170.0, paint::BODY));
    s.add(rod(v(-0.70, 0.0, 0.78), v(-0.92, 0.0, 1.06), 0.012, paint::CHROME));
    s.add(Sculpt::cuboid(v(-1.01, -0.06, 0.60), v(-0.95, 0.06, 0.70), 0.02, paint::TAIL));
    indicators(&mut s, v(-0.94, 0.17, 0.62));
    s.add(Sculpt::cuboid(v(-1.10, -0.10, 0.40), v(-1.085, 0.10, 0.56), 0.0, paint::PLATE));
    s.add(rod(v(-0.30, 0.10, 0.32), v(rear, 0.11, r), 0.026, paint::CHASSIS).both_sides());
    s.add(rod(v(rear, 0.14, r), v(-0.52, 0.14, 0.66), 0.03, paint::CHROME).both_sides());
    s.add(rod(v(0.34, 0.12, 0.30), v(0.34, 0.30, 0.30), 0.015, paint::RUBBER).both_sides());
    let mut a = Assembly::new(s, wheel(r, 0.14, 0.74, Rim::Wire, paint::CHROME), r);
    a.single(front, true);
    a.single(rear, false);
    a.headlights = vec![v(0.68, 0.0, 0.86)];
    a.fit = Some(RiderFit {
        seat: v(-0.28, 0.0, 0.715),
        grip,
        foot: v(0.34, 0.24, 0.31),
        right_foot: Vec3::ZERO,
        lean_rad: -0.02,
        helmet: 0.95,
        helmets: HelmetKind::Full,
        outfit: Outfit::Fair,
        standing: false,
        pillion: None,
    });
    a
}
