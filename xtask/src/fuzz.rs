//! `cargo xtask fuzz PARSER`: changes files at random and has them read.

use anyhow::{Context, Result, bail};
use std::{env, process::Command};

/// Parsers that can be fuzzed, and the crate that has each.
const PARSERS: &[(&str, &str)] = &[("opendrive", "endless_road"), ("osm", "endless_road"), ("pbf", "endless_road")];

/// What is asked for: `PARSER [--seconds 60] [--seed 1]`.
#[derive(Debug, PartialEq, Eq)]
struct FuzzOptions {
    parser: &'static str,
    package: &'static str,
    seconds: u64,
    seed: u64,
}

impl FuzzOptions {
    fn parse(args: &[String]) -> Result<Self> {
        let names: Vec<&str> = PARSERS.iter().map(|parser| parser.0).collect();
        let named = args.first().and_then(|name| PARSERS.iter().find(|parser| parser.0 == name));
        let Some(&(parser, package)) = named else { bail!("which parser? one of {}", names.join(", ")) };
        let mut options = Self { parser, package, seconds: 60, seed: 1 };
        for pair in args[1..].chunks(2) {
            let [option, value] = pair else { bail!("{} needs a number", pair[0]) };
            let number = value.parse().with_context(|| format!("{option} {value}"))?;
            match option.as_str() {
                "--seconds" => options.seconds = number,
                "--seed" => options.seed = number,
                other => bail!("unknown option {other}: use --seconds and --seed"),
            }
        }
        Ok(options)
    }
}

/// Runs the fuzzer of a parser. The readers are compiled as for tests: optimised, with the checks for overflow.
pub(crate) fn fuzz(args: &[String]) -> Result<()> {
    let FuzzOptions { parser, package, seconds, seed } = FuzzOptions::parse(args)?;
    let status = Command::new(env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned()))
        .args(["test", "--package", package, "--test", "it", "--", "--ignored", "--exact", "--nocapture", "fuzz::hunt"])
        .env("FUZZ_PARSER", parser)
        .env("FUZZ_SECONDS", seconds.to_string())
        .env("FUZZ_SEED", seed.to_string())
        .status()?;
    if status.success() { Ok(()) } else { bail!("found something: see target/fuzz/{parser}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_are_read_and_mistakes_are_told() {
        let parse = |text: &str| FuzzOptions::parse(&text.split(' ').map(str::to_owned).collect::<Vec<_>>());
        let osm = parse("osm --seed 7 --seconds 5").expect("valid");
        assert_eq!((osm.parser, osm.package, osm.seconds, osm.seed), ("osm", "endless_road", 5, 7));
        for wrong in ["png", "osm --seed", "osm --seed x", "osm --hours 3"] {
            assert!(parse(wrong).is_err(), "{wrong}");
        }
    }
}
