//! `endless serve`: our city as a CARLA server.

use crate::args::ServeArgs;
use anyhow::Result;
use endless_carla::server::{Server, ServerSettings, VERSION};
use endless_interchange::{MapLibrary, user_data_folder};
use std::process::ExitCode;

pub(crate) fn run(library: MapLibrary, args: &ServeArgs) -> Result<ExitCode> {
    let recordings = args.recordings.clone().or_else(|| user_data_folder("recordings"));
    let settings = ServerSettings {
        bind: args.bind,
        port: args.port,
        map: args.map.clone(),
        seed: args.seed,
        quality: args.quality_level,
        recordings,
    };
    let server = Server::bind(&settings, library)?;
    let address = server.address();
    eprintln!("CARLA {VERSION} at {address}, streams at the next port, map {}; Ctrl-C ends it", args.map);
    if !args.bind.is_loopback() {
        eprintln!(
            "note: whoever reaches {address} can load maps and take memory and computing time: \
             the protocol has no passwords"
        );
    }
    server.run();
    Ok(ExitCode::SUCCESS)
}
