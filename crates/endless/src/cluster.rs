//! `endless cluster`: scripts and manifests for the schedulers of others.

mod kubernetes;
mod slurm;

use crate::args::{ClusterArgs, ClusterEngine, ShardsArgs};
use anyhow::{Context, Result};
use endless_dataset::RecipeDraft;
use endless_pipeline::read_recipe;
use std::{io::Write, path::Path, process::ExitCode};

pub(crate) fn run(args: &ClusterArgs) -> Result<ExitCode> {
    let text = match &args.engine {
        ClusterEngine::Slurm(args) => {
            read(&args.shards)?;
            slurm::script(args, &absolute(&args.shards.recipe)?, &place(&args.shards.out)?)
        }
        ClusterEngine::Kubernetes(args) => {
            let recipe = read(&args.shards)?;
            for (option, file) in [("assets", &recipe.assets), ("traffic", &recipe.traffic)] {
                if let Some(file) = file {
                    let file = file.display();
                    eprintln!("warning: {option} of the recipe, {file}, must be in the image or on the volume");
                }
            }
            let path = &args.shards.recipe;
            let text = std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
            kubernetes::manifest(args, &text)
        }
    };
    std::io::stdout().lock().write_all(text.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}

/// The recipe, so that a mistake in it is told before it waits in a queue.
fn read(args: &ShardsArgs) -> Result<RecipeDraft> {
    Ok(read_recipe(&args.recipe)?)
}

fn absolute(path: &Path) -> Result<String> {
    let absolute = std::path::absolute(path).with_context(|| format!("there is no place {}", path.display()))?;
    let text = absolute.to_str().map(str::to_owned);
    text.with_context(|| format!("this path is no text, which a script could name: {}", absolute.display()))
}

/// An address as it is, a folder from the root.
fn place(out: &str) -> Result<String> {
    if out.contains("://") { Ok(out.to_owned()) } else { absolute(Path::new(out)) }
}

/// A word of a shell's command that means this text.
fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./:=@%+,".contains(c);
    if !text.is_empty() && text.chars().all(plain) {
        return text.to_owned();
    }
    format!("'{}'", text.replace('\'', r"'\''"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_a_shell_mean_the_text() {
        for text in ["/a/b.toml", "", "it's here", "$HOME `x` \"y\" \\ \n!", "s3://bucket/a b"] {
            let said = std::process::Command::new("bash").args(["-c", &format!("printf %s {}", quoted(text))]).output();
            assert_eq!(said.expect("bash").stdout, text.as_bytes(), "{text}");
        }
        assert_eq!(quoted("/a/b.toml"), "/a/b.toml");
    }
}
