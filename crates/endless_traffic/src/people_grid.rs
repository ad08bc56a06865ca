//! Who is near whom on foot, found by place, so that a crowd costs as much as its people and not as their pairs.

use glam::DVec2;

/// Distance within which people notice others, metres.
const SIGHT_M: f64 = 5.0;
/// Size of a cell, metres.
const CELL_M: f64 = 2.5;
/// So many of the nearest are noticed: those beyond them are hidden by them.
const MOST: usize = 20;

/// Somebody on foot, as others see them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Passer {
    pub(crate) at: DVec2,
    pub(crate) velocity: DVec2,
    /// The velocity that they would like to have, which others see from how they face.
    pub(crate) intent: DVec2,
    /// How many pieces of their way they have walked.
    pub(crate) passed: u32,
}

/// Numbers of people, by the cells in which they were at the beginning of a step.
#[derive(Debug)]
pub(crate) struct PeopleGrid {
    /// Column, row, number; in order.
    entries: Vec<(i32, i32, u32)>,
}

fn cell(at: DVec2) -> [i32; 2] {
    [(at.x / CELL_M).floor() as i32, (at.y / CELL_M).floor() as i32]
}

impl PeopleGrid {
    pub(crate) fn new(people: &[Passer]) -> Self {
        let entry = |(number, passer): (u32, &Passer)| {
            let [column, row] = cell(passer.at);
            (column, row, number)
        };
        let mut entries: Vec<(i32, i32, u32)> = (0..).zip(people).map(entry).collect();
        entries.sort_unstable();
        Self { entries }
    }

    /// Those whom somebody notices, the nearest first. They may have moved on by a step since the grid was made.
    pub(crate) fn nearest(&self, people: &[Passer], me: usize, into: &mut Vec<(f64, u32)>) {
        into.clear();
        let at = people[me].at;
        let ([left, bottom], [right, top]) = (cell(at - DVec2::splat(SIGHT_M)), cell(at + DVec2::splat(SIGHT_M)));
        for column in left..=right {
            let from = self.entries.partition_point(|&(x, y, _)| (x, y) < (column, bottom));
            let rows = self.entries[from..].iter().take_while(|&&(x, y, _)| (x, y) <= (column, top));
            let near = rows.filter(|(.., other)| *other as usize != me);
            let near = near.map(|&(.., other)| (people[other as usize].at.distance_squared(at), other));
            into.extend(near.filter(|(squared, _)| *squared < SIGHT_M * SIGHT_M));
        }
        let order = |a: &(f64, u32), b: &(f64, u32)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
        if into.len() > MOST {
            into.select_nth_unstable_by(MOST - 1, order);
            into.truncate(MOST);
        }
        into.sort_unstable_by(order);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::Stream;

    #[test]
    fn finds_whom_a_look_at_everybody_finds() {
        let mut stream = Stream::named(1, "test.people_grid", &[]);
        let mut place = || DVec2::new(stream.range_f64(-30.0, 30.0), stream.range_f64(-30.0, 30.0));
        let people: Vec<Passer> =
            (0..300).map(|_| Passer { at: place(), velocity: DVec2::ZERO, intent: DVec2::ZERO, passed: 0 }).collect();
        let grid = PeopleGrid::new(&people);
        let mut near = Vec::new();
        for (me, passer) in people.iter().enumerate() {
            let distance = |other: usize| people[other].at.distance_squared(passer.at);
            let mut all: Vec<usize> =
                (0..people.len()).filter(|&j| j != me && distance(j) < SIGHT_M * SIGHT_M).collect();
            all.sort_by(|&a, &b| distance(a).total_cmp(&distance(b)));
            all.truncate(MOST);
            grid.nearest(&people, me, &mut near);
            let found: Vec<usize> = near.iter().map(|(_, other)| *other as usize).collect();
            assert_eq!(found, all);
        }
    }
}
