//! `endless bench`: one recipe, stage by stage.

use super::film::{draft, film};
use super::sensors;
use crate::args::BenchArgs;
use crate::memory;
use anyhow::Result;
use endless_dataset::{Layer, RecipeDraft};
use endless_pipeline::{Generated, MapSource, Simulator, read_rig};
use std::{io::Write, process::ExitCode, time::Duration};

pub(super) fn run<S: Simulator + MapSource>(simulator: &S, args: &BenchArgs, threads: usize) -> Result<ExitCode> {
    let asked = |list: &Option<Vec<String>>, default: &str| list.clone().or_else(|| Some(vec![default.into()]));
    let draft = RecipeDraft {
        weathers: asked(&args.weathers, "clear_sky"),
        times: asked(&args.times, "afternoon"),
        sensor: args.rig.as_deref().map(read_rig).transpose()?,
        ..draft(args)
    };
    let made = film(simulator, draft, threads)?;
    print(&made, threads)?;
    if args.rig.is_some() {
        sensors::print(&made, threads)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn print(made: &Generated, threads: usize) -> Result<()> {
    let mut out = std::io::stdout().lock();
    let t = &made.times;
    let frames = made.camera_frames as f64;
    writeln!(out, "stage            seconds   ms a camera frame")?;
    let once = [("load map", t.load_map), ("load scene", t.load_scene), ("bake (wall)", t.bake)];
    for (name, time) in once {
        writeln!(out, "{name:<14} {:>9.2}", time.as_secs_f64())?;
    }
    let each = [
        ("traffic", t.traffic),
        ("render", t.render),
        ("images", t.images),
        ("boxes", t.boxes),
        ("amodal", t.amodal),
        ("lines", t.lines),
        ("video", t.video),
    ];
    for (name, time) in each {
        writeln!(out, "{name:<14} {:>9.2}   {:>8.2}", time.as_secs_f64(), time.as_secs_f64() * 1e3 / frames)?;
    }
    for (layer, time) in Layer::ALL.iter().zip(t.layers).filter(|(_, time)| !time.is_zero()) {
        let name = format!("- {layer}");
        writeln!(out, "{name:<14} {:>9.2}   {:>8.2}", time.as_secs_f64(), time.as_secs_f64() * 1e3 / frames)?;
    }
    let rate = |count: f64, time: Duration| count / time.as_secs_f64().max(1e-9);
    writeln!(out, "recording (wall) {:.2} s on {threads} threads", t.record.as_secs_f64())?;
    writeln!(out, "camera frames    {frames}, {:.1} a second", rate(frames, t.record))?;
    writeln!(out, "bake             {:.1} Mrays/s", rate(t.renderer.bake_rays as f64 / 1e6, t.bake))?;
    writeln!(out, "render           {:.1} Mrays/s a thread", rate(t.renderer.frame_rays as f64 / 1e6, t.render))?;
    let megabytes = made.bytes as f64 / 1e6;
    writeln!(out, "written          {megabytes:.1} MB, {:.3} MB a camera frame", megabytes / frames)?;
    if let Some(peak) = memory::peak_megabytes() {
        writeln!(out, "peak memory      {peak:.0} MB")?;
    }
    Ok(())
}
