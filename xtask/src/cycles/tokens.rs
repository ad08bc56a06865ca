//! What the text of a module says: what it defines, what it imports, which paths and names it writes.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use std::collections::BTreeSet;

/// One name of a `use`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Import {
    /// As it is written, from `crate`, `self`, `super` or a name in scope on.
    pub(super) path: Vec<String>,
    /// The name that it has here; `None` for all that is there (`*`).
    pub(super) name: Option<String>,
    /// Whether it is passed on (`pub use`).
    pub(super) exported: bool,
}

/// The body of a module, tests left out.
#[derive(Debug, Default)]
pub(super) struct ModuleText {
    /// Names of what is defined.
    pub(super) items: BTreeSet<String>,
    pub(super) imports: Vec<Import>,
    /// Modules in files of their own.
    pub(super) file_modules: Vec<String>,
    pub(super) inline_modules: Vec<(String, ModuleText)>,
    /// Paths of two or more names, outside of imports.
    pub(super) paths: Vec<Vec<String>>,
    /// All names, outside of imports.
    pub(super) names: BTreeSet<String>,
}

/// Words that are followed by the name of what they define.
const DEFINING: [&str; 9] = ["struct", "enum", "union", "trait", "fn", "type", "const", "static", "macro_rules"];

impl ModuleText {
    /// Reads the tokens of a module.
    pub(super) fn read(tokens: TokenStream) -> Self {
        let mut text = Self::default();
        text.read_level(tokens, true);
        text
    }

    /// Reads tokens of the module itself, or of what lies in brackets there.
    fn read_level(&mut self, tokens: TokenStream, of_module: bool) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut at = 0;
        while at < tokens.len() {
            at = self.read_one(&tokens, at, of_module);
        }
    }

    /// Reads what begins at a token; where the next begins.
    fn read_one(&mut self, tokens: &[TokenTree], at: usize, of_module: bool) -> usize {
        match &tokens[at] {
            TokenTree::Punct(p) if p.as_char() == '#' && attribute(tokens, at).is_some_and(is_test) => {
                after_item(tokens, at + 2)
            }
            // A lifetime or a field is no name of an item.
            TokenTree::Punct(p) if matches!(p.as_char(), '\'' | '.') && word(tokens, at + 1).is_some() => at + 2,
            TokenTree::Group(group) => {
                self.read_level(group.stream(), false);
                at + 1
            }
            TokenTree::Ident(ident) => self.read_word(tokens, at, &ident.to_string(), of_module),
            _ => at + 1,
        }
    }

    fn read_word(&mut self, tokens: &[TokenTree], at: usize, text: &str, of_module: bool) -> usize {
        let next = word(tokens, at + 1);
        match (text, next) {
            ("use", _) if !punct(tokens, at + 1, '<') => {
                let end = (at..tokens.len()).find(|i| punct(tokens, *i, ';')).unwrap_or(tokens.len());
                let exported = is_exported(tokens, at);
                read_use(&tokens[at + 1..end], Vec::new(), exported, &mut self.imports);
                end + 1
            }
            ("mod", Some(name)) if of_module => match tokens.get(at + 2) {
                Some(TokenTree::Group(body)) => {
                    self.inline_modules.push((name, Self::read(body.stream())));
                    at + 3
                }
                _ => {
                    self.file_modules.push(name);
                    at + 3
                }
            },
            ("macro_rules", None) if of_module => {
                self.items.extend(word(tokens, at + 2));
                at + 3
            }
            (defining, Some(name))
                if of_module && DEFINING.contains(&defining) && !DEFINING.contains(&name.as_str()) =>
            {
                self.items.insert(name);
                at + 2
            }
            _ => self.read_path(tokens, at),
        }
    }

    /// Names joined by `::`.
    fn read_path(&mut self, tokens: &[TokenTree], at: usize) -> usize {
        let mut path: Vec<String> = word(tokens, at).into_iter().collect();
        let mut end = at + 1;
        while punct(tokens, end, ':') && punct(tokens, end + 1, ':') {
            let Some(name) = word(tokens, end + 2) else { break };
            path.push(name);
            end += 3;
        }
        self.names.extend(path.iter().cloned());
        if path.len() > 1 {
            self.paths.push(path);
        }
        end
    }
}

fn word(tokens: &[TokenTree], at: usize) -> Option<String> {
    match tokens.get(at) {
        Some(TokenTree::Ident(ident)) => Some(ident.to_string()),
        _ => None,
    }
}

fn punct(tokens: &[TokenTree], at: usize, wanted: char) -> bool {
    matches!(tokens.get(at), Some(TokenTree::Punct(p)) if p.as_char() == wanted)
}

fn attribute(tokens: &[TokenTree], at: usize) -> Option<&Group> {
    match tokens.get(at + 1) {
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Bracket => Some(group),
        _ => None,
    }
}

fn is_test(attribute: &Group) -> bool {
    let text: String = attribute.stream().to_string().split_whitespace().collect();
    text == "cfg(test)" || text == "test"
}

/// Where the item that begins here has ended.
fn after_item(tokens: &[TokenTree], at: usize) -> usize {
    let ends = |token: &TokenTree| match token {
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
        TokenTree::Punct(p) => p.as_char() == ';',
        _ => false,
    };
    tokens[at.min(tokens.len())..].iter().position(ends).map_or(tokens.len(), |length| at + length + 1)
}

/// Whether `pub` or `pub(…)` stands before a token.
fn is_exported(tokens: &[TokenTree], at: usize) -> bool {
    let before = |n: usize| at.checked_sub(n).and_then(|i| word(tokens, i));
    let group = at > 0 && matches!(tokens[at - 1], TokenTree::Group(_));
    before(1).is_some_and(|w| w == "pub") || group && before(2).is_some_and(|w| w == "pub")
}

/// A tree of a `use`: `a::b`, `a::{b, c}`, `a as b`, `a::*`.
fn read_use(tokens: &[TokenTree], mut path: Vec<String>, exported: bool, to: &mut Vec<Import>) {
    for (at, token) in tokens.iter().enumerate() {
        match token {
            TokenTree::Ident(ident) if *ident == "as" => {
                to.push(Import { path, name: word(tokens, at + 1), exported });
                return;
            }
            TokenTree::Ident(ident) => path.push(ident.to_string()),
            TokenTree::Punct(p) if p.as_char() == '*' => {
                to.push(Import { path, name: None, exported });
                return;
            }
            TokenTree::Group(group) => {
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                for branch in inner.split(|t| matches!(t, TokenTree::Punct(p) if p.as_char() == ',')) {
                    read_use(branch, path.clone(), exported, to);
                }
                return;
            }
            _ => {}
        }
    }
    // `use a::{self}` imports `a`.
    if path.len() > 1 && path.last().is_some_and(|last| last == "self") {
        path.pop();
    }
    if let Some(name) = path.last().cloned() {
        to.push(Import { path, name: Some(name), exported });
    }
}
