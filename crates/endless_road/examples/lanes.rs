//! Lists the lanes of OpenDRIVE files, tab-separated: `lanes FILE...`. A line a lane: file, id, junction (`-` outside,
//! `loop` for those added where roads end), metres, width, successors, points. `scripts/judge_opendrive.py` compares it
//! with what SUMO reads.
#![expect(clippy::print_stdout, reason = "a program")]

use endless_road::{LaneId, Turn, opendrive};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    for file in std::env::args().skip(1) {
        let map = opendrive::read(&std::fs::read_to_string(&file)?).map_err(|error| format!("{file}: {error}"))?;
        for lane in &map.network.lanes {
            let turns_back = |id: &LaneId| map.network.lane(*id).turn == Turn::UTurn;
            let junction = match lane.junction {
                None => "-".to_owned(),
                Some(j) if map.network.junctions[j.index()].lanes.iter().all(turns_back) => "loop".to_owned(),
                Some(j) => j.0.to_string(),
            };
            let length = lane.centerline.length();
            let next: Vec<String> = lane.successors.iter().map(|next| next.0.to_string()).collect();
            let points: Vec<String> =
                lane.centerline.points().iter().map(|p| format!("{:.2},{:.2}", p.x, p.y)).collect();
            let (id, width, next, points) = (lane.id.0, lane.width_m, next.join(","), points.join(" "));
            println!("{file}\t{id}\t{junction}\t{length:.3}\t{width:.2}\t{next}\t{points}");
        }
    }
    Ok(())
}
