//! Lists the lanes of OpenDRIVE files, tab-separated: `lanes FILE...`. A line a lane: file, id, junction or -, metres,
//! width, successors. `scripts/judge_opendrive.py` compares it with what SUMO reads.
#![expect(clippy::print_stdout, reason = "a program")]

use endless_road::opendrive;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    for file in std::env::args().skip(1) {
        let map = opendrive::read(&std::fs::read_to_string(&file)?).map_err(|error| format!("{file}: {error}"))?;
        for lane in &map.network.lanes {
            let junction = lane.junction.map_or("-".to_owned(), |junction| junction.0.to_string());
            let length = lane.centerline.length();
            let next: Vec<String> = lane.successors.iter().map(|next| next.0.to_string()).collect();
            println!("{file}\t{}\t{junction}\t{length:.3}\t{:.2}\t{}", lane.id.0, lane.width_m, next.join(","));
        }
    }
    Ok(())
}
