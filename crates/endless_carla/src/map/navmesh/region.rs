//! The monotone partitioning of Recast: regions of one area with a single run of cells in each row. They have no holes.

use super::grid::{Grid, NONE};
use super::walk_area::WalkArea;
use std::collections::HashMap;

/// The region of every span.
pub(super) fn regions(grid: &Grid) -> Vec<u32> {
    let mut region = vec![NONE; grid.spans.len()];
    let mut count = 0;
    let mut from = 0;
    while from < grid.spans.len() {
        let row = grid.spans[from].row;
        let to = from + grid.spans[from..].partition_point(|span| span.row == row);
        number_row(grid, from..to, &mut region, &mut count);
        from = to;
    }
    region
}

/// A run of cells of one row.
#[derive(Debug, Clone, Copy, Default)]
struct Run {
    /// The region south of it, and over how many cells; `None` if there is none, or there are several.
    south: Option<(u32, u32)>,
    several: bool,
}

fn number_row(grid: &Grid, row: std::ops::Range<usize>, region: &mut [u32], count: &mut u32) {
    let area = |i: usize| WalkArea::from(grid.spans[i].kind);
    let mut runs: Vec<Run> = Vec::new();
    let mut run_of: Vec<usize> = Vec::with_capacity(row.len());
    // Over how many cells of this row each region of the row before goes on.
    let mut over: HashMap<u32, u32> = HashMap::new();
    for i in row.clone() {
        let west = grid.spans[i].west();
        let joined = west != NONE && area(west as usize) == area(i);
        let run = if joined {
            run_of[west as usize - row.start]
        } else {
            runs.push(Run::default());
            runs.len() - 1
        };
        run_of.push(run);
        let south = grid.spans[i].south();
        if south != NONE && area(south as usize) == area(i) {
            let below = region[south as usize];
            *over.entry(below).or_default() += 1;
            let run = &mut runs[run];
            match &mut run.south {
                None => run.south = Some((below, 1)),
                Some((known, cells)) if *known == below => *cells += 1,
                Some(_) => run.several = true,
            }
        }
    }
    let numbers: Vec<u32> = runs
        .iter()
        .map(|run| match run.south {
            Some((below, cells)) if !run.several && over.get(&below) == Some(&cells) => below,
            _ => {
                *count += 1;
                *count - 1
            }
        })
        .collect();
    for (i, run) in row.zip(run_of) {
        region[i] = numbers[run];
    }
}
