//! Progress of a run on stderr: a bar on a terminal, plain lines elsewhere.

use endless_pipeline::{Progress, ProgressEvent, human_bytes};
use indicatif::{ProgressBar, ProgressState, ProgressStyle};
use std::{
    fmt,
    io::IsTerminal,
    sync::atomic::{AtomicU64, Ordering},
    time::Instant,
};

/// Prints progress events.
#[derive(Debug)]
pub(crate) struct Reporter {
    /// Hidden where stderr is no terminal.
    bar: ProgressBar,
    terminal: bool,
    start: Instant,
    frames: AtomicU64,
    total: AtomicU64,
}

impl Reporter {
    pub(crate) fn new() -> Self {
        let terminal = std::io::stderr().is_terminal();
        let bar = if terminal { ProgressBar::new(0) } else { ProgressBar::hidden() };
        let template = "{prefix} [{bar:30}] {pos}/{len} camera frames, {rate}, {eta} left {msg}";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style.with_key("rate", |state: &ProgressState, to: &mut dyn fmt::Write| {
                // Nothing can be done about a terminal that takes no text.
                let _ = write!(to, "{:.1}/s", state.per_sec());
            }));
        }
        Self { bar, terminal, start: Instant::now(), frames: AtomicU64::new(0), total: AtomicU64::new(0) }
    }

    pub(crate) fn finish(&self) {
        self.bar.finish_and_clear();
    }

    fn line(&self, text: &str) {
        if self.terminal {
            self.bar.println(text);
        } else {
            eprintln!("[{:7.1} s] {text}", self.start.elapsed().as_secs_f64());
        }
    }

    fn frame(&self, cameras: u64) {
        self.bar.inc(cameras);
        let done = self.frames.fetch_add(cameras, Ordering::Relaxed) + cameras;
        let total = self.total.load(Ordering::Relaxed).max(1);
        // Ten lines a video.
        if !self.terminal && done * 10 / total != (done - cameras) * 10 / total {
            self.line(&format!("{done}/{total} camera frames"));
        }
    }
}

impl Progress for Reporter {
    fn event(&self, event: &ProgressEvent<'_>) {
        match *event {
            ProgressEvent::Video { name, place, of, camera_frames } => {
                self.frames.store(0, Ordering::Relaxed);
                self.total.store(camera_frames, Ordering::Relaxed);
                self.bar.reset();
                self.bar.set_length(camera_frames);
                self.bar.set_prefix(format!("{place}/{of} {name}"));
            }
            ProgressEvent::Baked { .. } => self.bar.reset_eta(),
            ProgressEvent::Frame { cameras, .. } => self.frame(cameras.into()),
            _ => {}
        }
        if let Some(line) = line_of(event) {
            self.line(&line);
        }
    }
}

/// What is said of an event; nothing of single frames.
pub fn line_of(event: &ProgressEvent<'_>) -> Option<String> {
    Some(match *event {
        ProgressEvent::Start { videos: 0, .. } | ProgressEvent::Frame { .. } => return None,
        ProgressEvent::Start { videos, complete, estimate, shard } => {
            let shard = shard.map(|shard| format!("shard {shard}: ")).unwrap_or_default();
            let done = if complete > 0 { format!(" ({complete} are complete)") } else { String::new() };
            format!(
                "{shard}{videos} videos to make{done}: {} camera frames, at most about {}, {} are free",
                estimate.camera_frames,
                human_bytes(estimate.bytes),
                human_bytes(estimate.free)
            )
        }
        ProgressEvent::NoLocks => {
            "warning: this file system knows no locks: see to it that no two processes make the same shard".to_owned()
        }
        ProgressEvent::LoadMap { map } => format!("loading {map}"),
        ProgressEvent::Video { name, place, of, .. } => format!("video {place} of {of}: {name}"),
        ProgressEvent::FewerSpawned { what, asked, placed, map } => {
            format!("warning: {map} has room for {placed} {what}, {asked} were asked for: going on with {placed}")
        }
        ProgressEvent::EventMissed { kind, map } => {
            format!("warning: no {kind} could be had where the cameras look in {map}: going on without")
        }
        ProgressEvent::Baked { seconds } => format!("cameras baked in {seconds:.1} s"),
        ProgressEvent::VideoAgain { name, reason } => format!("warning: {name} is begun again: {reason}"),
        ProgressEvent::VideoDone { name } => format!("complete: {name}"),
    })
}
