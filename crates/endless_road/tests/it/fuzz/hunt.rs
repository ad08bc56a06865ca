//! Changing files and reading them for as long as asked for.

use super::mutate;
use super::pbf;
use super::target::Target;
use endless_world::Stream;
use std::collections::BTreeSet;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// A small file must not keep a reader busy for longer than this, seconds: of the processor's time, which does not
/// depend on what else runs, or of ten times as much on the clock.
const SLOW_S: f64 = 10.0;
/// Nor take more memory than this, bytes.
const LARGE: usize = 1 << 30;
/// Larger files are not tried, nor kept.
const MOST_BYTES: usize = 96 << 10;
/// Files to go on from.
const MOST_KEPT: usize = 600;

/// All files of a folder, by name.
pub(crate) fn files(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let mut paths: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    paths.retain(|path| path.is_file());
    paths.sort();
    paths.into_iter().filter_map(|path| Some((path.clone(), fs::read(path).ok()?))).collect()
}

/// Reads changed files for some seconds.
///
/// # Panics
/// If something was found; the files lie in `target/fuzz`.
pub(crate) fn hunt(target: Target, corpus: Vec<(PathBuf, Vec<u8>)>, seconds: u64, seed: u64) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/fuzz").join(target.name());
    let kept = folder.join("kept");
    fs::create_dir_all(&kept).unwrap();
    let mut pool: Vec<Vec<u8>> = corpus.into_iter().chain(files(&kept)).map(|(_, bytes)| bytes).collect();
    let mut seen = BTreeSet::new();
    for file in &pool {
        seen.extend(target.run(file).unwrap_or_default());
    }
    let watch = Watch::start(folder.clone());
    let mut stream = Stream::named(seed, "fuzz", &[]);
    let (begin, mut tries, mut found) = (Instant::now(), 0u64, BTreeSet::new());
    let mut slowest = Duration::ZERO;
    std::panic::set_hook(Box::new(|_| {}));
    while begin.elapsed().as_secs() < seconds {
        let from = stream.pick(&pool);
        let file = match target {
            Target::Pbf => pbf::changed(from, &mut stream),
            _ => mutate::xml(from, &pool, &mut stream),
        };
        if file.len() > MOST_BYTES {
            continue;
        }
        tries += 1;
        watch.reads(&file);
        let start = Instant::now();
        let answer = catch_unwind(AssertUnwindSafe(|| target.run(&file))).unwrap_or_else(|panic| {
            let text = panic.downcast_ref::<String>().cloned();
            Err(format!(
                "panic: {}",
                text.or(panic.downcast_ref::<&str>().map(|s| (*s).to_owned())).unwrap_or_default()
            ))
        });
        watch.rests();
        if start.elapsed() > slowest {
            slowest = start.elapsed();
            fs::write(folder.join("slowest"), &file).unwrap();
        }
        match answer {
            Ok(kinds) => {
                let news = kinds.into_iter().filter(|kind| seen.insert(kind.clone())).count();
                if news > 0 && pool.len() < MOST_KEPT {
                    fs::write(kept.join(format!("{seed}-{tries}")), &file).unwrap();
                    pool.push(file);
                }
            }
            Err(wrong) => {
                let kind: String = wrong.chars().filter(|c| !c.is_ascii_digit()).take(60).collect();
                if found.insert(kind) {
                    let path = folder.join(format!("found-{seed}-{tries}"));
                    println!("{}: {wrong}", path.display());
                    fs::write(path, &file).unwrap();
                }
            }
        }
    }
    drop(std::panic::take_hook());
    println!(
        "{}: {tries} files in {} s, {} kinds of answers, {} files kept, the slowest {slowest:.2?}, {} findings",
        target.name(),
        begin.elapsed().as_secs(),
        seen.len(),
        pool.len(),
        found.len()
    );
    assert!(found.is_empty(), "findings: {found:?}");
}

/// A file that is being read, and since when, on the clock and in seconds of the processor.
type Reading = Mutex<Option<(Instant, f64, Vec<u8>)>>;

/// Looks at the clock and the memory while files are read; ends the program with the file kept when it takes too much
/// of either, because nothing else stops a reader that hangs.
struct Watch {
    reading: Arc<Reading>,
}

impl Watch {
    fn start(folder: PathBuf) -> Self {
        let reading: Arc<Reading> = Arc::default();
        let seen = Arc::clone(&reading);
        std::thread::spawn(move || {
            loop {
                std::thread::sleep(Duration::from_millis(100));
                let Ok(reading) = seen.lock() else { return };
                let Some((since, before, file)) = reading.as_ref() else { continue };
                let large = resident() > LARGE;
                let slow = busy_s() - before > SLOW_S || since.elapsed().as_secs_f64() > 10.0 * SLOW_S;
                if large || slow {
                    let path = folder.join(if large { "found-large" } else { "found-slow" });
                    let _ = fs::write(&path, file);
                    println!("{}: took too {}", path.display(), if large { "much memory" } else { "long" });
                    std::process::exit(1);
                }
            }
        });
        Self { reading }
    }

    fn reads(&self, file: &[u8]) {
        *self.reading.lock().unwrap() = Some((Instant::now(), busy_s(), file.to_vec()));
    }

    fn rests(&self) {
        *self.reading.lock().unwrap() = None;
    }
}

/// Bytes of memory in use; 0 where the system does not say.
fn resident() -> usize {
    let text = fs::read_to_string("/proc/self/statm").unwrap_or_default();
    text.split(' ').nth(1).and_then(|pages| pages.parse::<usize>().ok()).map_or(0, |pages| pages * 4096)
}

/// Seconds of the processor that this program has used; 0 where the system does not say.
fn busy_s() -> f64 {
    let text = fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // After the name in parentheses; user and system time are the 14th and 15th field, hundredths of a second.
    let fields = text.rsplit(')').next().unwrap_or_default().split_ascii_whitespace().skip(11).take(2);
    fields.filter_map(|ticks| ticks.parse::<f64>().ok()).sum::<f64>() / 100.0
}
