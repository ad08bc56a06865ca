//! Chores of the repository: `cargo xtask rooms`, `cargo xtask fuzz PARSER --seconds N`.

use anyhow::{Context, Result, bail};
use std::{collections::BTreeMap, env, fs, path::Path, process::Command, process::ExitCode};

/// The rooms, lowest first: a crate may use only crates that stand before it, and never one of its own shelf.
const SHELVES: &[&[&str]] = &[
    &["endless_world"],
    &["endless_scene"],
    &["endless_road", "endless_asset", "endless_render"],
    &["endless_town", "endless_annotate"],
    &["endless_traffic", "endless_city", "endless_dataset"],
    &["endless_carla", "endless_interchange"],
    &["endless_pipeline"],
    &["endless"],
];

fn main() -> ExitCode {
    let args: Vec<String> = env::args().skip(1).collect();
    let result = match args.first().map(String::as_str) {
        Some("rooms") => rooms(Path::new(".")),
        Some("fuzz") => fuzz(&args[1..]),
        other => Err(anyhow::anyhow!("unknown chore {other:?}: use `cargo xtask rooms` or `cargo xtask fuzz`")),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

/// Parsers that can be fuzzed, and the crate that has each.
const PARSERS: &[(&str, &str)] = &[("opendrive", "endless_road"), ("osm", "endless_road"), ("pbf", "endless_road")];

/// Changes files at random and has them read: `fuzz PARSER [--seconds 60] [--seed 1]`. The readers are compiled as for
/// tests: optimised, with the checks for overflow.
fn fuzz(args: &[String]) -> Result<()> {
    let names: Vec<&str> = PARSERS.iter().map(|parser| parser.0).collect();
    let named = args.first().and_then(|name| PARSERS.iter().find(|parser| parser.0 == name));
    let Some((parser, package)) = named else { bail!("which parser? one of {}", names.join(", ")) };
    let (mut seconds, mut seed) = (60u64, 1u64);
    for pair in args[1..].chunks(2) {
        let [option, value] = pair else { bail!("{} needs a number", pair[0]) };
        let number = value.parse().with_context(|| format!("{option} {value}"))?;
        match option.as_str() {
            "--seconds" => seconds = number,
            "--seed" => seed = number,
            other => bail!("unknown option {other}: use --seconds and --seed"),
        }
    }
    let status = Command::new(env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned()))
        .args(["test", "--package", package, "--test", "it", "--", "--ignored", "--exact", "--nocapture", "fuzz::hunt"])
        .env("FUZZ_PARSER", parser)
        .env("FUZZ_SECONDS", seconds.to_string())
        .env("FUZZ_SEED", seed.to_string())
        .status()?;
    if status.success() { Ok(()) } else { bail!("found something: see target/fuzz/{parser}") }
}

/// Dependencies point down only, and every crate is in `ARCHITECTURE.md`.
fn rooms(root: &Path) -> Result<()> {
    let shelf_of: BTreeMap<&str, usize> =
        SHELVES.iter().enumerate().flat_map(|(i, shelf)| shelf.iter().map(move |name| (*name, i))).collect();
    let architecture = fs::read_to_string(root.join("ARCHITECTURE.md")).context("ARCHITECTURE.md")?;
    let mut wrong = Vec::new();
    for (name, uses) in dependencies(&root.join("crates"))? {
        let Some(shelf) = shelf_of.get(name.as_str()) else {
            wrong.push(format!("{name} has no place among the rooms: give it one in xtask"));
            continue;
        };
        if !architecture.contains(&format!("`{name}`")) {
            wrong.push(format!("ARCHITECTURE.md does not mention `{name}`"));
        }
        for used in uses {
            if shelf_of.get(used.as_str()).is_none_or(|below| below >= shelf) {
                wrong.push(format!("{name} must not use {used}: dependencies point down only"));
            }
        }
    }
    if wrong.is_empty() { Ok(()) } else { bail!("{}", wrong.join("\n       ")) }
}

/// Which of our crates each crate uses, tests included.
fn dependencies(crates: &Path) -> Result<BTreeMap<String, Vec<String>>> {
    let mut all = BTreeMap::new();
    for entry in fs::read_dir(crates)? {
        let path = entry?.path().join("Cargo.toml");
        if !path.is_file() {
            continue;
        }
        let text = fs::read_to_string(&path)?;
        let manifest: toml::Table = text.parse().with_context(|| path.display().to_string())?;
        let name = manifest.get("package").and_then(|p| p.get("name")).and_then(toml::Value::as_str);
        let tables = ["dependencies", "dev-dependencies", "build-dependencies"];
        let ours = tables
            .iter()
            .filter_map(|table| manifest.get(*table)?.as_table())
            .flat_map(toml::Table::keys)
            .filter(|used| used.starts_with("endless"))
            .cloned()
            .collect();
        all.insert(name.context("a crate without a name")?.to_owned(), ours);
    }
    Ok(all)
}
