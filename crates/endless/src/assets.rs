//! `endless assets`: lists, previews and exports the catalogue.

use crate::args::{AssetsArgs, AssetsCommand};
use crate::file::write;
use anyhow::Result;
use endless_asset::Catalogue;
use endless_interchange::{AssetFolder, MapLibrary, asset_gltf, asset_preview, list_assets};
use std::{io::Write, path::Path, process::ExitCode};

/// The library with the models of a folder, if one is named; warns of skipped models.
pub(crate) fn with_folder(library: MapLibrary, folder: Option<&Path>, skip_broken: bool) -> Result<MapLibrary> {
    let Some(folder) = folder else { return Ok(library) };
    let folder = AssetFolder::read(folder, skip_broken)?;
    for reason in &folder.skipped {
        eprintln!("warning: skipped {reason}");
    }
    Ok(library.with_assets(folder))
}

pub(crate) fn run(library: MapLibrary, args: AssetsArgs) -> Result<ExitCode> {
    let library = with_folder(library, args.assets.as_deref(), args.skip_broken)?;
    let catalogue = library.catalogue();
    match args.command.unwrap_or(AssetsCommand::List { filter: None }) {
        AssetsCommand::List { filter } => list(catalogue, filter.as_deref().unwrap_or_default())?,
        AssetsCommand::Preview { name, variant, out } => {
            let picture = asset_preview(catalogue, &name, variant)?;
            write(&out, &endless_dataset::encode_png(&picture))?;
        }
        AssetsCommand::Export { name, variant, out } => write(&out, &asset_gltf(catalogue, &name, variant)?)?,
    }
    Ok(ExitCode::SUCCESS)
}

fn list(catalogue: &Catalogue, filter: &str) -> Result<()> {
    let mut out = std::io::stdout().lock();
    let header = ["length m", "width m", "height m"];
    writeln!(
        out,
        "{:<32} {:<11} {:<13} {:<13} {:<13} triangles  draws",
        "name", "class", header[0], header[1], header[2]
    )?;
    let mut counts: Vec<(String, u32)> = Vec::new();
    for kind in list_assets(catalogue).iter().filter(|k| k.name.contains(filter) || k.class == filter) {
        let [length, width, height] = [kind.length_m, kind.width_m, kind.height_m].map(range);
        let draws = kind.draws.map_or("any".to_owned(), |n| n.to_string());
        writeln!(
            out,
            "{:<32} {:<11} {length:<13} {width:<13} {height:<13} {:>9}  {draws:>5}",
            kind.name, kind.class, kind.triangles
        )?;
        match counts.iter_mut().find(|c| c.0 == kind.class) {
            Some(count) => count.1 += 1,
            None => counts.push((kind.class.clone(), 1)),
        }
    }
    let told: Vec<String> = counts.iter().map(|(class, n)| format!("{n} {class}")).collect();
    eprintln!("{}", told.join(", "));
    Ok(())
}

fn range([low, high]: [f32; 2]) -> String {
    if high - low < 0.005 { format!("{high:.2}") } else { format!("{low:.2}-{high:.2}") }
}
