//! Valid names of maps.

/// Longest name of a map.
const LONGEST_NAME: usize = 60;

/// The name of a map of which none is given: the file's without its endings, other characters replaced. A built-in
/// town's name is taken: `Town04.xodr` becomes `Town04_imported`.
pub(super) fn default_name(file: &str) -> String {
    let stem = file.split('.').find(|part| !part.is_empty()).unwrap_or_default();
    let stem: String =
        stem.chars().map(|c| if c.is_ascii_alphanumeric() || c == '_' || c == '-' { c } else { '_' }).collect();
    if is_built_in(&stem) { format!("{stem}_imported") } else { stem }
}

/// Whether a name, in whatever case, means a built-in town.
pub(super) fn is_built_in(name: &str) -> bool {
    let plain = name.strip_suffix("_Opt").unwrap_or(name);
    endless_town::NAMES.iter().any(|n| n.eq_ignore_ascii_case(plain))
}

/// Whether a map can be called so.
pub(super) fn is_name(name: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    (1..=LONGEST_NAME).contains(&name.len()) && name.chars().all(plain) && !name.starts_with('-')
}
