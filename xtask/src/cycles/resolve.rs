//! Where what a module names is defined.

use super::module_tree::{CrateModule, ModuleTree};
use super::tokens::Import;

/// What a path leads to.
#[derive(Debug, Clone, Copy)]
enum PathTarget {
    Module(usize),
    /// Something that is defined in a file.
    DefinedIn(usize),
}

/// Imports of imports are followed this far: they may go round in a circle.
const DEEPEST: u32 = 32;

/// Every use of something of this crate: the using file, a name, the defining file.
pub(super) fn uses(tree: &ModuleTree) -> Vec<(usize, String, usize)> {
    let mut found = Vec::new();
    for (number, module) in tree.modules.iter().enumerate() {
        let mut add = |name: &str, target: Option<PathTarget>| {
            if let Some(PathTarget::DefinedIn(definer)) = target {
                found.push((module.file, name.to_owned(), definer));
            }
        };
        for import in &module.imports {
            match &import.name {
                Some(name) if is_used(module, import, name) => add(name, resolve(tree, number, &import.path, 0)),
                Some(_) => {}
                None => {
                    if let Some(PathTarget::Module(all)) = resolve(tree, number, &import.path, 0) {
                        module.names.iter().for_each(|name| add(name, look_up(tree, all, name, 0)));
                    }
                }
            }
        }
        for path in &module.paths {
            add(item_of(path), resolve(tree, number, path, 0));
        }
    }
    found
}

/// The name of the item in a path that may go on to its variants and functions: the first type, or the last name.
fn item_of(path: &[String]) -> &str {
    let item = path.iter().find(|name| name.starts_with(|c: char| c.is_uppercase())).or(path.last());
    item.map_or("", String::as_str)
}

/// What is only passed on is not used.
fn is_used(module: &CrateModule, import: &Import, name: &str) -> bool {
    !import.exported || module.names.contains(name)
}

/// Follows a path from a module on; `None` if it leads out of the crate.
fn resolve(tree: &ModuleTree, from: usize, path: &[String], depth: u32) -> Option<PathTarget> {
    let (first, rest) = path.split_first()?;
    let start = match first.as_str() {
        "crate" => PathTarget::Module(0),
        "self" => PathTarget::Module(from),
        "super" => PathTarget::Module(tree.modules[from].parent?),
        name => look_up(tree, from, name, depth)?,
    };
    let mut target = start;
    for name in rest {
        let PathTarget::Module(module) = target else { break };
        target = match name.as_str() {
            "super" => PathTarget::Module(tree.modules[module].parent?),
            // What cannot be found in a module is what a macro has defined there.
            name => look_up(tree, module, name, depth).unwrap_or(PathTarget::DefinedIn(tree.modules[module].file)),
        };
    }
    Some(target)
}

/// What a name means in a module.
fn look_up(tree: &ModuleTree, module: usize, name: &str, depth: u32) -> Option<PathTarget> {
    if depth > DEEPEST {
        return None;
    }
    let CrateModule { file, children, items, imports, .. } = &tree.modules[module];
    if let Some(child) = children.get(name) {
        return Some(PathTarget::Module(*child));
    }
    if items.contains(name) {
        return Some(PathTarget::DefinedIn(*file));
    }
    // An import of a name by that name (`use anyhow;`) leads out of the crate.
    let named = imports.iter().filter(|i| i.name.as_deref() == Some(name) && i.path.first().is_some_and(|f| f != name));
    let named = named.filter_map(|import| resolve(tree, module, &import.path, depth + 1));
    let globs = imports.iter().filter(|import| import.name.is_none());
    let globs = globs.filter_map(|import| match resolve(tree, module, &import.path, depth + 1)? {
        PathTarget::Module(all) if all != module => look_up(tree, all, name, depth + 1),
        _ => None,
    });
    named.chain(globs).next()
}
