//! `cargo xtask cycles`: no two files of a crate use each other, directly or through others.
//!
//! A file uses another if it names something that is defined there, be it in a `use` or in a path. What a `mod.rs` or
//! `lib.rs` merely re-exports is followed to where it is defined, and re-exporting is not using. What only tests use is
//! left out.

mod graph;
mod module_tree;
mod resolve;
mod tokens;

use crate::manifests::crate_manifests;
use anyhow::{Result, bail};
use graph::FileGraph;
use module_tree::ModuleTree;
use std::path::Path;

pub(crate) fn check(root: &Path) -> Result<()> {
    let mut found = Vec::new();
    let mut folders: Vec<_> = crate_manifests(root)?.into_values().map(|manifest| manifest.folder).collect();
    folders.push(root.join("xtask"));
    for folder in folders {
        for crate_root in ["lib.rs", "main.rs"].map(|name| folder.join("src").join(name)) {
            if crate_root.is_file() {
                found.extend(file_graph(&crate_root)?.cycles());
            }
        }
    }
    if found.is_empty() { Ok(()) } else { bail!("{} circles of files:\n{}", found.len(), found.join("\n")) }
}

fn file_graph(crate_root: &Path) -> Result<FileGraph> {
    let tree = ModuleTree::read(crate_root)?;
    let mut graph = FileGraph::new(tree.files.clone());
    for (user, name, definer) in resolve::uses(&tree) {
        graph.add(user, name, definer);
    }
    Ok(graph)
}

#[cfg(test)]
mod tests;
