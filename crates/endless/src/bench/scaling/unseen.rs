//! Vehicles that no camera sees grow, beside a few that are seen.

use super::setup::ScalingSetup;
use super::table::{Table, ratio};
use anyhow::Result;
use endless_dataset::RecipeDraft;
use endless_world::{Actor, PinholeCamera, WorldState};

/// Vehicles among which there are enough that no camera sees.
const CROWD: i64 = 1000;
/// Vehicles in sight and out of sight. Each pair of rows is compared.
const ROWS: [(usize, usize); 4] = [(0, 30), (0, 100), (10, 30), (10, 100)];

pub(super) fn run(setup: &ScalingSetup<'_>) -> Result<()> {
    let settings = setup.scene(RecipeDraft { vehicles: Some(CROWD), pedestrians: Some(0), ..setup.draft() })?;
    let (map, _) = setup.timer.load(&settings.map)?;
    let (mut session, _) = setup.timer.prepare(&map, &settings)?;
    let lenses: Vec<PinholeCamera> =
        settings.cameras.iter().map(|camera| PinholeCamera::new(&camera.site, settings.size)).collect();
    let mut counts = [(0, 0); ROWS.len()];
    // In turn, so that all rows show the same traffic.
    let turns = ROWS.len() as u32;
    let times_ms = setup.timer.render(&mut session, settings.frames * turns, |frame, state| {
        let row = (frame % turns) as usize;
        counts[row] = keep(state, &lenses, ROWS[row]);
    })?;
    let mean_ms = |row: usize| {
        let of_row = times_ms.iter().skip(row).step_by(ROWS.len());
        of_row.sum::<f64>() / f64::from(settings.frames) / lenses.len() as f64
    };
    let heads = ["in sight", "out of sight", "ms/camera frame", "frame ratio"];
    let mut table = Table::begin("vehicles out of sight", &heads)?;
    for (row, (seen, unseen)) in counts.iter().enumerate() {
        table.row([
            seen.to_string(),
            unseen.to_string(),
            format!("{:.2}", mean_ms(row)),
            ratio(mean_ms(row), mean_ms(row / 2 * 2)),
        ])?;
    }
    table.end("with traffic in sight, 100 vehicles out of sight shall cost less than 1.20 times as much as 30")?;
    Ok(())
}

/// Leaves so many of the actors that a camera sees, and so many that none does; tells how many there were.
fn keep(state: &mut WorldState, lenses: &[PinholeCamera], (seen, unseen): (usize, usize)) -> (usize, usize) {
    let actors = std::mem::take(&mut state.actors);
    let near = |actor: &Actor| lenses.iter().any(|lens| comes_near_the_picture(lens, actor));
    let (mut kept, mut others): (Vec<Actor>, Vec<Actor>) = actors.into_iter().partition(near);
    kept.truncate(seen);
    others.truncate(unseen);
    let counts = (kept.len(), others.len());
    state.actors = kept;
    state.actors.extend(others);
    state.actors.sort_by_key(|actor| actor.id);
    counts
}

/// Whether an actor stands in a picture or less than a quarter of a picture beside it: it may be seen in part, or throw a shadow
/// into the picture.
fn comes_near_the_picture(lens: &PinholeCamera, actor: &Actor) -> bool {
    let near = |place: f32, size: u32| (place / size as f32 - 0.5).abs() < 0.75;
    let projected = lens.project(actor.pose.position);
    projected.is_some_and(|(place, _)| near(place.x, lens.size.width) && near(place.y, lens.size.height))
}
