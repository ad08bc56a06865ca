//! Vehicles, walkers and walls that meet.

use super::*;
use crate::physics::{Body, Contact, Mover, Obstacle, OrientedBox, Party, WalkerBody, step_bodies};
use crate::wire::{Vector3D, WalkerControl};
use glam::DVec2;

fn nothing(_: DVec2, _: DVec2, _: &mut Vec<Obstacle>) {}

fn wall_at(x: f64) -> impl Fn(DVec2, DVec2, &mut Vec<Obstacle>) {
    move |_, _, found| {
        let (centre, half) = (DVec2::new(x + 0.5, 0.0), DVec2::new(0.5, 20.0));
        let outline = OrientedBox { centre, half, along: DVec2::X, low_m: 0.0, high_m: 3.0 };
        found.push(Obstacle { id: 9, outline });
    }
}

/// Moves vehicles together; their actors are their places in the list.
fn step(
    vehicles: &mut [VehicleBody],
    control: &VehicleControl,
    obstacles: &dyn crate::physics::Obstacles,
) -> Vec<Contact> {
    let body = |(id, vehicle)| Body { id: id as u32, mover: Mover::Vehicle(vehicle, control) };
    let mut bodies: Vec<_> = vehicles.iter_mut().enumerate().map(body).collect();
    step_bodies(&mut bodies, FRAME_S, &flat, obstacles)
}

fn moving(shape: VehicleShape, place: Place, velocity: DVec3) -> VehicleBody {
    let mut body = VehicleBody::new(shape, place);
    body.step(&VehicleControl::default(), FRAME_S, &flat);
    body.set_target_velocity(velocity);
    body
}

fn momentum(vehicles: &[VehicleBody]) -> DVec3 {
    vehicles.iter().map(|vehicle| vehicle.velocity() * vehicle.mass_kg()).sum()
}

fn apart(vehicles: &[VehicleBody]) -> bool {
    let outlines: Vec<_> = vehicles
        .iter()
        .map(|vehicle| OrientedBox { half: vehicle.outline().half - 0.02, ..vehicle.outline() })
        .collect();
    outlines.iter().enumerate().all(|(index, a)| {
        outlines.iter().skip(index + 1).all(|b| {
            let corners = |of: &OrientedBox| {
                [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)]
                    .map(|(x, y)| of.centre + of.along * (x * of.half.x) + of.along.perp() * (y * of.half.y))
            };
            let inside = |point: DVec2, of: &OrientedBox| {
                (point - of.centre).dot(of.along).abs() < of.half.x
                    && (point - of.centre).dot(of.along.perp()).abs() < of.half.y
            };
            !corners(a).iter().any(|&point| inside(point, b)) && !corners(b).iter().any(|&point| inside(point, a))
        })
    })
}

#[test]
fn cars_that_crash_head_on_come_apart_and_keep_their_momentum() {
    let light = VehicleShape { mass_kg: Some(1000.0), ..hatchback() };
    let mut vehicles = [
        moving(VehicleShape::MODEL3, at(-5.0, 0.1, 0.0), DVec3::X * 14.0),
        moving(light, at(5.0, 0.0, std::f64::consts::PI), DVec3::X * -14.0),
    ];
    let before = momentum(&vehicles);
    let mut first = None;
    for frame in 0..40 {
        let contacts = step(&mut vehicles, &VehicleControl::default(), &nothing);
        if let (None, Some(&contact)) = (first, contacts.first()) {
            // Some wheels have rolled meanwhile, and turned aside the others cannot.
            let after = momentum(&vehicles);
            assert!((after - before).length() < 0.05 * before.length(), "{before} {after}");
            first = Some((frame, contact));
        }
    }
    let (frame, contact) = first.expect("they met");
    assert!((2..10).contains(&frame));
    assert_eq!((contact.a, contact.b), (Party::Body(0), Party::Body(1)));
    assert!(contact.normal.x > 0.99 && contact.impulse.x > 1e4 && contact.point.x.abs() < 3.0, "{contact:?}");
    assert!(apart(&vehicles));
    // The heavier one pushes the other back.
    assert!(vehicles[1].place().position.x - vehicles[0].place().position.x > 4.4);
}

#[test]
fn fast_cars_do_not_pass_through_each_other() {
    for aside in [0.0, 0.9, 1.5] {
        let mut vehicles = [
            moving(VehicleShape::MODEL3, at(-30.0, 0.0, 0.0), DVec3::X * 50.0),
            moving(VehicleShape::MODEL3, at(30.0, aside, std::f64::consts::PI), DVec3::X * -50.0),
        ];
        let met = (0..60).map(|_| step(&mut vehicles, &VehicleControl::default(), &nothing).len()).sum::<usize>();
        let [a, b] = &vehicles;
        assert!(met > 0 && apart(&vehicles), "{aside}");
        assert!(b.place().position.x - a.place().position.x > -4.0, "{aside}: {:?} {:?}", a.place(), b.place());
        assert!(a.velocity().length() < 40.0);
    }
}

#[test]
fn a_car_hits_a_wall_and_stays_before_it() {
    let mut vehicles = [moving(VehicleShape::MODEL3, at(0.0, 0.0, 0.2), DVec3::X * 10.0)];
    let wall = wall_at(10.0);
    let mut met = 0.0;
    for _ in 0..100 {
        let contacts = step(&mut vehicles, &control(0.5, 0.0, 0.0), &wall);
        for contact in contacts {
            assert_eq!((contact.a, contact.b), (Party::Body(0), Party::Obstacle(9)));
            met += contact.impulse.x;
        }
    }
    assert!(met > 0.8 * 18450.0, "{met}");
    let foremost = vehicles[0].outline().centre.x + vehicles[0].outline().half.dot(vehicles[0].outline().along.abs());
    assert!(foremost < 10.06, "{foremost}");
}

#[test]
fn what_touches_at_rest_does_not_tremble() {
    // Bumper to bumper, against a wall, an eighth of a metre in each other.
    let mut vehicles = [0.0, 4.67, 9.34].map(|x| moving(VehicleShape::MODEL3, at(x, 0.0, 0.0), DVec3::ZERO));
    let wall = wall_at(11.7);
    let brake = control(0.0, 1.0, 0.0);
    for _ in 0..100 {
        step(&mut vehicles, &brake, &wall);
    }
    let before = vehicles.clone().map(|vehicle| vehicle.place());
    for _ in 0..100 {
        assert_eq!(step(&mut vehicles, &brake, &wall), []);
    }
    for (before, after) in before.iter().zip(&vehicles) {
        assert!((before.position - after.place().position).length() < 1e-3);
        assert_eq!(after.velocity(), DVec3::ZERO);
    }
    assert!(apart(&vehicles));
}

#[test]
fn a_car_knocks_a_walker_and_tells() {
    let mut car = moving(VehicleShape::MODEL3, Place::default(), DVec3::X * 10.0);
    let mut walker = WalkerBody::new(1.75, 0.25, at(6.0, 0.3, 0.0));
    let (drive, stand) = (VehicleControl::default(), WalkerControl::default());
    let mut contacts = Vec::new();
    for _ in 0..20 {
        let mut bodies = [
            Body { id: 5, mover: Mover::Vehicle(&mut car, &drive) },
            Body { id: 7, mover: Mover::Walker(&mut walker, &stand) },
        ];
        contacts.extend(step_bodies(&mut bodies, FRAME_S, &flat, &nothing));
    }
    let contact = contacts.first().expect("they met");
    assert_eq!((contact.a, contact.b), (Party::Body(5), Party::Body(7)));
    assert!(contact.impulse.x > 300.0);
    // Pushed ahead, while the car hardly slows down.
    assert!(walker.place().position.x > 9.0 && car.speed_mps() > 8.0, "{:?} {}", walker.place(), car.speed_mps());
}

#[test]
fn walkers_do_not_walk_through_cars() {
    let mut car = moving(VehicleShape::MODEL3, Place::default(), DVec3::ZERO);
    let mut walker = WalkerBody::new(1.75, 0.25, at(0.0, -4.0, 0.0));
    // North, which is where CARLA's y does not go.
    let walk = WalkerControl { direction: Vector3D { x: 0.0, y: -1.0, z: 0.0 }, speed: 1.4, jump: false };
    for _ in 0..200 {
        let stand = VehicleControl::default();
        let mut bodies = [
            Body { id: 1, mover: Mover::Walker(&mut walker, &walk) },
            Body { id: 2, mover: Mover::Vehicle(&mut car, &stand) },
        ];
        step_bodies(&mut bodies, FRAME_S, &flat, &nothing);
    }
    let y = walker.place().position.y;
    assert!((-1.5..-0.9).contains(&y), "{y}");
    assert!(car.place().position.length() < 0.05);
}

#[test]
fn what_does_not_collide_or_move_is_let_alone() {
    let mut vehicles = [
        moving(VehicleShape::MODEL3, at(-10.0, 0.0, 0.0), DVec3::X * 10.0),
        moving(VehicleShape::MODEL3, at(0.0, 0.0, 0.0), DVec3::ZERO),
    ];
    vehicles[1].set_collides(false);
    (0..20).for_each(|_| assert_eq!(step(&mut vehicles, &VehicleControl::default(), &nothing), []));
    assert!(vehicles[0].place().position.x > -3.0);

    vehicles[0] = moving(VehicleShape::MODEL3, at(-10.0, 0.0, 0.0), DVec3::X * 10.0);
    vehicles[1].set_collides(true);
    vehicles[1].set_simulated(false);
    let place = vehicles[1].place();
    let met: usize = (0..40).map(|_| step(&mut vehicles, &VehicleControl::default(), &nothing).len()).sum();
    assert!(met > 0 && vehicles[1].place() == place && vehicles[0].place().position.x < -4.7);
}

#[test]
fn crashes_never_add_energy() {
    let energy = |vehicles: &[VehicleBody]| -> f64 {
        vehicles
            .iter()
            .map(|v| v.mass_kg() * (v.velocity().length_squared() + 2.1 * v.angular_velocity().z.powi(2)))
            .sum()
    };
    for turn in 0..12 {
        let mut vehicles = [
            moving(VehicleShape::MODEL3, at(-8.0, 0.0, 0.0), DVec3::X * 15.0),
            moving(hatchback(), at(0.3 * f64::from(turn) - 2.0, 1.0, 0.5 * f64::from(turn)), DVec3::ZERO),
            moving(lorry(), at(9.0, -1.0, 2.0), DVec3::X * -5.0),
        ];
        for _ in 0..60 {
            let before = energy(&vehicles);
            step(&mut vehicles, &VehicleControl::default(), &nothing);
            assert!(energy(&vehicles) <= before * (1.0 + 1e-9) + 1e-9, "{turn}");
        }
    }
}
