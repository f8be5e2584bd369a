//! Which file of a crate rests on which: a name is followed through the facades that hand it on to the file that has
//! it.

use std::collections::{BTreeMap, BTreeSet};

use tests::sources::Source;

use super::paths::{code, expanded, has_functions, has_word, named, taken_apart};

/// The path of a module, from the crate's root.
pub type Module = Vec<String>;

/// A name is handed on by at most so many facades.
const LONGEST_CHAIN: usize = 20;

/// A file outside the tests.
struct File {
    is_facade: bool,
    has_functions: bool,
    /// The absolute paths that its names stand for, its own and those that it hands on.
    names: BTreeMap<String, Module>,
    /// The absolute paths that its code mentions.
    mentions: Vec<Module>,
}

/// The files of a crate.
pub struct Files(BTreeMap<Module, File>);

/// Whether a file declares and re-exports what a folder has, by its name.
pub fn is_facade(path: &str) -> bool {
    ["mod.rs", "lib.rs", "main.rs"].contains(&path.rsplit('/').next().unwrap_or(path))
}

fn module(path: &str) -> Module {
    let mut parts: Module = path.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
    if is_facade(path) {
        parts.pop();
    }
    parts
}

/// A path as it is from the crate's root; `None` for what is of another crate.
fn absolute(path: &[String], own: &Module, modules: &BTreeSet<Module>) -> Option<Module> {
    let (mut base, mut rest) = match path.first()?.as_str() {
        "crate" => (Vec::new(), &path[1..]),
        "self" => (own.clone(), &path[1..]),
        "super" => (own.clone(), path),
        first => {
            let child: Module = own.iter().cloned().chain([first.to_owned()]).collect();
            modules.contains(&child).then(|| (own.clone(), path))?
        }
    };
    while rest.first().is_some_and(|part| part == "super") {
        base.pop();
        rest = &rest[1..];
    }
    Some(base.into_iter().chain(rest.iter().cloned()).collect())
}

impl Files {
    /// The files of a crate's folder, tests apart.
    pub fn new(sources: &[Source], folder: &str) -> Self {
        let inner = |source: &Source| source.path[folder.len() + 1..].to_owned();
        let library: Vec<&Source> = sources.iter().filter(|source| !source.is_test()).collect();
        let modules: BTreeSet<Module> = library.iter().map(|source| module(&inner(source))).collect();
        let file = |source: &&Source| {
            let own = module(&inner(source));
            let code = code(source);
            let (statements, rest) = taken_apart(&code);
            let (mut names, mut mentions) = (BTreeMap::new(), Vec::new());
            for statement in statements {
                let hands_on = statement.is_public && is_facade(&source.path);
                for import in expanded(statement.tree) {
                    let Some(path) = absolute(&import.path, &own, &modules) else { continue };
                    if !hands_on || has_word(&rest, &import.name) {
                        mentions.push(path.clone());
                    }
                    names.insert(import.name, path);
                }
            }
            for path in named(&rest) {
                mentions.extend(match names.get(&path[0]) {
                    Some(start) => Some(start.iter().chain(&path[1..]).cloned().collect()),
                    None => absolute(&path, &own, &modules),
                });
            }
            let file =
                File { is_facade: is_facade(&source.path), has_functions: has_functions(&code), names, mentions };
            (own, file)
        };
        Self(library.iter().map(file).collect())
    }

    /// The file that has what a path names.
    fn home(&self, path: &[String]) -> Option<&Module> {
        let mut path = path.to_vec();
        for _ in 0..LONGEST_CHAIN {
            let length = (0..=path.len()).rev().find(|length| self.0.contains_key(&path[..*length]))?;
            let (module, file) = self.0.get_key_value(&path[..length])?;
            let onward = path.get(length).and_then(|name| file.names.get(name)).filter(|next| **next != path);
            let Some(onward) = onward else { return Some(module) };
            path = onward.iter().chain(&path[length + 1..]).cloned().collect();
        }
        None
    }

    /// The files that each file rests on. A facade without functions rests on nothing: it says what its folder has. One
    /// with functions is a file like the others.
    pub fn uses(&self) -> BTreeMap<Module, BTreeSet<Module>> {
        let has_code = |module: &Module| !self.0[module].is_facade || self.0[module].has_functions;
        let of = |(own, file): (&Module, &File)| {
            let homes = file.mentions.iter().filter_map(|path| self.home(path));
            let others = homes.filter(|other| *other != own && (has_code(other) || !own.starts_with(other)));
            (own.clone(), others.cloned().collect())
        };
        self.0.iter().filter(|(module, _)| has_code(module)).map(of).collect()
    }

    /// Whether a module is a facade.
    pub fn is_facade(&self, module: &Module) -> bool {
        self.0.get(module).is_some_and(|file| file.is_facade)
    }
}
