//! Counting lines: who passes them, and to which side.

use endless_world::{InstanceId, ObjectClass, WorldState};
use glam::{DVec2, Vec3Swizzles as _};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A line on the ground of a map whose passers-by are counted.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CountingLine {
    /// The map on which it lies.
    pub map: String,
    /// Unique on the map.
    pub name: String,
    /// Its first end: east and north, metres.
    pub from: [f64; 2],
    /// Its second end.
    pub to: [f64; 2],
}

/// Numbers of objects by class.
pub type ClassCounts = BTreeMap<ObjectClass, u32>;

/// Who has passed a line since the video began, seen from its first end towards its second.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct LineCounts {
    /// The line.
    pub name: String,
    /// From its right to its left.
    pub to_left: ClassCounts,
    /// From its left to its right.
    pub to_right: ClassCounts,
}

/// Counts who passes lines, in world states that follow one another. Where objects are is where their origins are: on the
/// ground under their middles.
#[derive(Debug, Clone)]
pub struct LineCounter {
    lines: Vec<CountingLine>,
    counts: Vec<LineCounts>,
    places: BTreeMap<InstanceId, DVec2>,
}

impl LineCounter {
    /// With nobody counted yet.
    pub fn new(lines: Vec<CountingLine>) -> Self {
        let counts = lines.iter().map(|line| LineCounts { name: line.name.clone(), ..LineCounts::default() }).collect();
        Self { lines, counts, places: BTreeMap::new() }
    }

    /// The counts at this state.
    pub fn observe(&mut self, state: &WorldState) -> &[LineCounts] {
        for actor in &state.actors {
            let here = actor.pose.position.xy().as_dvec2();
            let Some(before) = self.places.insert(actor.id, here) else { continue };
            for (line, counts) in self.lines.iter().zip(&mut self.counts) {
                let side = match passed(line, before, here) {
                    Some(Side::Left) => &mut counts.to_left,
                    Some(Side::Right) => &mut counts.to_right,
                    None => continue,
                };
                *side.entry(actor.class).or_default() += 1;
            }
        }
        &self.counts
    }
}

/// A side of a line.
enum Side {
    Left,
    Right,
}

/// The side to which a way from one place to another leads over a line. A place on the line lies to its left.
fn passed(line: &CountingLine, before: DVec2, here: DVec2) -> Option<Side> {
    let (from, to) = (DVec2::from(line.from), DVec2::from(line.to));
    let along = to - from;
    let left = |place: DVec2| along.perp_dot(place - from);
    let (was, is) = (left(before), left(here));
    if (was >= 0.0) == (is >= 0.0) {
        return None;
    }
    let crossed = before + (here - before) * (was / (was - is));
    let share = (crossed - from).dot(along);
    (0.0..along.length_squared()).contains(&share).then_some(if is >= 0.0 { Side::Left } else { Side::Right })
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{Actor, Behaviour, Motion, Pose, VehicleModelId, VehicleMotion, VehicleRef, WorldState};
    use glam::Vec3;
    use proptest::prelude::*;

    fn state(places: &[[f32; 2]]) -> WorldState {
        let actor = |(id, &[x, y]): (u16, &[f32; 2])| Actor {
            id: InstanceId(id),
            rider_id: None,
            class: if id == 1 { ObjectClass::Car } else { ObjectClass::Bus },
            asset: VehicleRef { model: VehicleModelId(0), variant: 0 }.into(),
            pose: Pose::level(Vec3::new(x, y, 0.0), 0.0),
            velocity_mps: Vec3::ZERO,
            motion: Motion::Vehicle(VehicleMotion::default()),
            behaviour: Behaviour::default(),
            parked: false,
        };
        WorldState { frame: 0, time_s: 0.0, actors: (1..).zip(places).map(actor).collect(), signals: Vec::new() }
    }

    fn line() -> CountingLine {
        CountingLine { map: "Town01".into(), name: "gate".into(), from: [0.0, 0.0], to: [10.0, 0.0] }
    }

    #[test]
    fn each_is_counted_on_the_side_to_which_it_goes() {
        let mut counter = LineCounter::new(vec![line()]);
        for y in [-3.0, -1.0, 0.0, 2.0, 1.0, -2.0] {
            // A bus beside the line is not counted.
            counter.observe(&state(&[[4.0, y], [11.0, y]]));
        }
        let counts = counter.observe(&state(&[[4.0, -2.0], [11.0, -2.0]]));
        let car = |count: u32| ClassCounts::from([(ObjectClass::Car, count)]);
        assert_eq!(counts, [LineCounts { name: "gate".into(), to_left: car(1), to_right: car(1) }]);
    }

    proptest! {
        #[test]
        fn who_comes_back_has_passed_as_often_to_the_left_as_to_the_right(
            way in prop::collection::vec((-2.0f32..12.0, -3.0f32..3.0), 2..40),
        ) {
            let mut counter = LineCounter::new(vec![CountingLine { from: [-50.0, 0.0], to: [50.0, 0.0], ..line() }]);
            for &(x, y) in way.iter().chain(way.first()) {
                counter.observe(&state(&[[x, y]]));
            }
            let counts = &counter.observe(&state(&[]))[0];
            prop_assert_eq!(&counts.to_left, &counts.to_right);
        }
    }
}
