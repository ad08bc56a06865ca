//! `endless view`: a dataset in the browser.

use crate::{args::ViewArgs, storage};
use anyhow::Result;
use endless_view::{ViewSettings, Viewer};
use std::{
    io::{self, Write},
    process::{Command, ExitCode, Stdio},
};

pub(crate) fn run(args: &ViewArgs) -> Result<ExitCode> {
    let settings = ViewSettings { folder: storage::folder(&args.out)?, bind: args.bind, port: args.port };
    let viewer = Viewer::bind(&settings)?;
    let stopper = viewer.stopper();
    ctrlc::set_handler(move || stopper.stop())?;
    let address = viewer.address();
    let url = format!("http://{address}/");
    let mut out = io::stdout().lock();
    writeln!(out, "{url}")?;
    out.flush()?;
    eprintln!("Ctrl-C ends it");
    if !args.bind.is_loopback() {
        eprintln!("note: whoever reaches {address} can look at the dataset: there are no passwords");
    }
    if args.open {
        open(&url);
    }
    viewer.run()?;
    Ok(ExitCode::SUCCESS)
}

/// Asks the platform to show a page.
fn open(url: &str) {
    let mut opener = if cfg!(target_os = "macos") {
        Command::new("open")
    } else if cfg!(target_os = "windows") {
        Command::new("explorer")
    } else {
        Command::new("xdg-open")
    };
    let opener = opener.arg(url).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    match opener.spawn() {
        // Nobody else waits for it: without that it would stay in the list of processes.
        Ok(mut browser) => drop(std::thread::spawn(move || browser.wait())),
        Err(_no_opener) => eprintln!("note: no browser could be opened: open {url}"),
    }
}
