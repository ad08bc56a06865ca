//! Which file uses which, and what of it.

use std::{
    collections::{BTreeMap, BTreeSet},
    path::PathBuf,
};

/// The files of a crate and what they use of each other.
#[derive(Debug)]
pub(super) struct FileGraph {
    files: Vec<PathBuf>,
    /// By the using file and the used: names of what is used.
    edges: BTreeMap<(usize, usize), BTreeSet<String>>,
}

impl FileGraph {
    /// Without uses.
    pub(super) fn new(files: Vec<PathBuf>) -> Self {
        Self { files, edges: BTreeMap::new() }
    }

    /// One file uses what another defines.
    pub(super) fn add(&mut self, user: usize, name: String, definer: usize) {
        if user != definer {
            self.edges.entry((user, definer)).or_default().insert(name);
        }
    }

    /// Groups of files each of which reaches all others of its group, described: the files, and who uses what.
    pub(super) fn cycles(&self) -> Vec<String> {
        let reached: Vec<BTreeSet<usize>> = (0..self.files.len()).map(|file| self.reached(file)).collect();
        let mut told = BTreeSet::new();
        let mut cycles = Vec::new();
        for file in 0..self.files.len() {
            if told.contains(&file) || !reached[file].contains(&file) {
                continue;
            }
            let group: BTreeSet<usize> =
                reached[file].iter().copied().filter(|f| reached[*f].contains(&file)).collect();
            cycles.push(self.describe(&group));
            told.extend(group);
        }
        cycles
    }

    /// Every file that is used by this one, directly or through others.
    fn reached(&self, from: usize) -> BTreeSet<usize> {
        let mut reached = BTreeSet::new();
        let mut open = vec![from];
        while let Some(file) = open.pop() {
            let used = self.edges.range((file, 0)..=(file, usize::MAX)).map(|((_, used), _)| *used);
            open.extend(used.filter(|used| reached.insert(*used)));
        }
        reached
    }

    fn describe(&self, group: &BTreeSet<usize>) -> String {
        let mut lines = vec![format!("a circle of {} files:", group.len())];
        for ((user, definer), names) in &self.edges {
            if group.contains(user) && group.contains(definer) {
                let names: Vec<&str> = names.iter().map(String::as_str).collect();
                let (user, definer) = (self.files[*user].display(), self.files[*definer].display());
                lines.push(format!("  {user} uses {} of {definer}", names.join(", ")));
            }
        }
        lines.join("\n")
    }
}
