//! The modules of a crate, found from its root on.

use super::tokens::{Import, ModuleText};
use anyhow::{Context, Result, bail};
use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};

/// A module: a file, or a part of one.
#[derive(Debug)]
pub(super) struct CrateModule {
    /// The file that it stands in.
    pub(super) file: usize,
    pub(super) parent: Option<usize>,
    pub(super) children: BTreeMap<String, usize>,
    pub(super) items: BTreeSet<String>,
    pub(super) imports: Vec<Import>,
    pub(super) paths: Vec<Vec<String>>,
    pub(super) names: BTreeSet<String>,
}

/// All modules of a crate; the first is its root.
#[derive(Debug)]
pub(super) struct ModuleTree {
    pub(super) files: Vec<PathBuf>,
    pub(super) modules: Vec<CrateModule>,
}

impl ModuleTree {
    /// Reads a crate from its `lib.rs` or `main.rs`.
    pub(super) fn read(root: &Path) -> Result<Self> {
        let mut tree = Self { files: Vec::new(), modules: Vec::new() };
        let folder = root.parent().unwrap_or(Path::new(".")).to_owned();
        tree.add_file(root, &folder, None)?;
        Ok(tree)
    }

    /// Adds a file whose own modules lie in a folder.
    fn add_file(&mut self, path: &Path, folder: &Path, parent: Option<usize>) -> Result<usize> {
        let source = fs::read_to_string(path).with_context(|| path.display().to_string())?;
        let tokens = source.parse().map_err(|e| anyhow::anyhow!("{}: {e}", path.display()))?;
        self.files.push(path.to_owned());
        self.add_module(ModuleText::read(tokens), self.files.len() - 1, folder, parent)
    }

    fn add_module(&mut self, text: ModuleText, file: usize, folder: &Path, parent: Option<usize>) -> Result<usize> {
        let this = self.modules.len();
        let ModuleText { items, imports, file_modules, inline_modules, paths, names } = text;
        self.modules.push(CrateModule { file, parent, children: BTreeMap::new(), items, imports, paths, names });
        for name in file_modules {
            let inside = folder.join(&name);
            let candidates = [folder.join(format!("{name}.rs")), inside.join("mod.rs")];
            let Some(path) = candidates.iter().find(|path| path.is_file()) else {
                bail!("{}: there is no file of the module {name}", self.files[file].display());
            };
            let child = self.add_file(path, &inside, Some(this))?;
            self.modules[this].children.insert(name, child);
        }
        for (name, text) in inline_modules {
            let child = self.add_module(text, file, &folder.join(&name), Some(this))?;
            self.modules[this].children.insert(name, child);
        }
        Ok(this)
    }
}
