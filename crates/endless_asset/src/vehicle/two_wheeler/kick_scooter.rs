//! Electric kick scooters.

use super::*;

pub(crate) fn kick_scooter(draw: &DesignDraw) -> VehicleBlueprint {
    framed(draw, VehicleBlueprint::new(size([0.565, -0.58], 0.54, 1.18, [0.44, -0.44], 0.125), parts))
}

fn parts() -> Assembly {
    let r = 0.125;
    let (front, rear) = (0.44, -0.44);
    let mut s = Sculpt::new();
    let foot = v(0.40, 0.0, 0.24);
    let head = v(0.28, 0.0, 1.14);
    s.add(rod(v(front, 0.05, r), foot + v(0.0, 0.045, 0.02), 0.014, paint::BODY).both_sides());
    s.add(rod(foot, head, 0.022, paint::BODY));
    s.add(mudguard(v(front, 0.0, r), r + 0.02, 0.035, 30.0, 150.0, paint::TRIM));
    s.add(mudguard(v(rear, 0.0, r), r + 0.02, 0.035, 30.0, 165.0, paint::TRIM));
    let grip = head + v(-0.03, 0.22, 0.0);
    s.add(rod(head, grip, 0.014, paint::BODY).both_sides());
    s.add(rod(grip - v(0.0, 0.06, 0.0), grip + v(0.0, 0.05, 0.0), 0.017, paint::RUBBER).both_sides());
    s.add(rod(grip + v(0.04, -0.04, 0.0), grip + v(0.05, 0.04, -0.01), 0.005, paint::STEEL).both_sides());
    s.add(Sculpt::cuboid(head + v(-0.035, -0.035, -0.01), head + v(0.03, 0.035, 0.03), 0.01, paint::TRIM));
    // Deck with its grip tape and battery.
    let mut deck = Sculpt::cuboid(v(-0.34, -0.085, 0.11), v(0.30, 0.085, 0.175), 0.02, paint::BODY);
    deck.paint(&Region::all().facing(Vec3::Z, 0.9).within(Vec3::X, 0.26).beyond(Vec3::X, -0.30), paint::RUBBER);
    s.add(deck);
    s.add(rod(v(0.26, 0.0, 0.15), foot, 0.03, paint::BODY));
    s.add(rod(v(-0.30, 0.05, 0.145), v(rear, 0.055, r), 0.02, paint::BODY).both_sides());
    s.add(Sculpt::ellipsoid(v(0.35, 0.0, 0.98), v(0.035, 0.026, 0.024), 10, paint::WHITE));
    s.add(Sculpt::cuboid(v(-0.585, -0.03, 0.205), v(-0.565, 0.03, 0.235), 0.006, paint::TAIL));
    s.add(rod(v(-0.50, 0.0, 0.255), v(-0.575, 0.0, 0.22), 0.01, paint::TRIM));
    let mut a = Assembly::new(s, wheel(r, 0.05, 0.62, Rim::Alloy(5), paint::DARK_ALLOY), r);
    a.single(front, true);
    a.single(rear, false);
    let deck_top = 0.175;
    a.fit = Some(RiderFit {
        seat: v(-0.02, 0.0, deck_top),
        grip,
        foot: v(0.16, 0.035, deck_top),
        right_foot: v(-0.30, 0.0, 0.0),
        lean_rad: 0.06,
        helmet: 0.3,
        helmets: HelmetKind::Cycle,
        outfit: Outfit::Fair,
        standing: true,
        pillion: None,
    });
    a
}
