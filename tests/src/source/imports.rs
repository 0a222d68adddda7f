//! Which file of a crate names items of which other file.
//!
//! File A imports file B if code of A, without its tests, names an item that B defines, by an
//! imported name or by a path. A name is followed through re-exports to the file that defines the
//! item, so that `crate::problem::Problem` counts as an import of the file with `struct Problem`
//! and not of the files on the way. `mod child;` and a re-export (`pub use child::Item;`) alone are
//! no imports: a `mod.rs` that declares and re-exports its children does not depend on them, and
//! its children may name what it defines. If the code of that `mod.rs` also calls an item of a
//! child, that is an import.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{Item, UseTree, Visibility};

use super::{CrateSource, SourceFile};

/// The names of a path.
type Names = Vec<String>;

/// Imports between the files of a crate.
pub struct Imports {
    paths: Vec<String>,
    /// For each file the files that it imports, each with a path by which it does.
    edges: Vec<BTreeMap<usize, String>>,
}

/// A module: the file in which it stands, what it defines, and what it imports.
struct Module {
    file: usize,
    /// Names of items that it defines, child modules excepted.
    items: BTreeSet<String>,
    children: BTreeSet<String>,
    /// Imported names and what they stand for, as written.
    uses: Vec<Import>,
}

/// `use path as name;`
struct Import {
    /// `*` for a glob import.
    name: String,
    path: Names,
}

/// All modules of a crate by the names that lead to them.
struct Modules(BTreeMap<Names, Module>);

impl Imports {
    /// Of all files of a crate.
    pub fn of(source: &CrateSource) -> Self {
        let mut modules = Modules(BTreeMap::new());
        for (at, file) in source.files.iter().enumerate() {
            modules.add(at, file.module.clone(), &file.items);
        }
        let edges = source.files.iter().enumerate().map(|(at, file)| modules.imports_of(at, file)).collect();
        let paths = source.files.iter().map(|file| file.path.display().to_string()).collect();
        Self { paths, edges }
    }

    /// The number of pairs of files of which one imports the other.
    pub fn count(&self) -> usize {
        self.edges.iter().map(BTreeMap::len).sum()
    }

    /// Whether the first file imports the second, by their paths.
    pub fn has(&self, from: &str, to: &str) -> bool {
        let at = |path: &str| self.paths.iter().position(|found| found == path);
        at(from).zip(at(to)).is_some_and(|(from, to)| self.edges[from].contains_key(&to))
    }

    /// One shortest circle of imports for each set of files that all import each other, directly or
    /// not. Empty if there is an order of the files in which each imports only files before it.
    pub fn circles(&self) -> Vec<String> {
        let reach: Vec<BTreeSet<usize>> = (0..self.paths.len()).map(|from| self.reachable(from)).collect();
        let mut seen: BTreeSet<usize> = BTreeSet::new();
        let mut circles = Vec::new();
        for from in 0..self.paths.len() {
            if seen.contains(&from) || !reach[from].contains(&from) {
                continue;
            }
            let members: Vec<usize> = reach[from].iter().copied().filter(|&to| reach[to].contains(&from)).collect();
            seen.extend(members.iter().copied());
            let shortest = members.iter().map(|&member| self.shortest_circle(member)).min_by_key(Vec::len);
            circles.push(self.describe(&members, &shortest.unwrap_or_default()));
        }
        circles
    }

    /// The files that a file imports, directly or not.
    fn reachable(&self, from: usize) -> BTreeSet<usize> {
        let mut reached = BTreeSet::new();
        let mut open = vec![from];
        while let Some(at) = open.pop() {
            open.extend(self.edges[at].keys().filter(|&&to| reached.insert(to)));
        }
        reached
    }

    /// A shortest way from a file back to itself, by breadth-first search. The file stands at both
    /// ends.
    fn shortest_circle(&self, start: usize) -> Vec<usize> {
        let mut before: BTreeMap<usize, usize> = BTreeMap::new();
        let mut open = VecDeque::from([start]);
        while let Some(at) = open.pop_front() {
            for &to in self.edges[at].keys() {
                if to == start {
                    let mut circle = vec![start, at];
                    while let Some(&previous) = circle.last().and_then(|last| before.get(last)) {
                        circle.push(previous);
                    }
                    circle.reverse();
                    circle.dedup();
                    return if circle.len() == 1 { vec![start, start] } else { circle };
                }
                if let Entry::Vacant(place) = before.entry(to) {
                    place.insert(at);
                    open.push_back(to);
                }
            }
        }
        Vec::new()
    }

    fn describe(&self, members: &[usize], circle: &[usize]) -> String {
        let steps = circle.windows(2).map(|step| {
            let [from, to] = [step[0], step[1]];
            format!("\n    {} names `{}` of {}", self.paths[from], self.edges[from][&to], self.paths[to])
        });
        let names: Vec<&str> = members.iter().map(|&at| self.paths[at].as_str()).collect();
        format!("{} files in a circle: {}{}", members.len(), names.join(", "), steps.collect::<String>())
    }
}

impl Modules {
    /// Enters a module of a file, and the modules inside of it.
    fn add(&mut self, file: usize, path: Names, items: &[Item]) {
        let mut module = Module { file, items: BTreeSet::new(), children: BTreeSet::new(), uses: Vec::new() };
        for item in items {
            match item {
                Item::Mod(child) => {
                    let name = child.ident.to_string();
                    if let Some((_, items)) = &child.content {
                        self.add(file, [&path[..], std::slice::from_ref(&name)].concat(), items);
                    }
                    module.children.insert(name);
                }
                Item::Use(import) => {
                    if import.leading_colon.is_none() {
                        flatten(&import.tree, Vec::new(), &mut module.uses);
                    }
                }
                _ => module.items.extend(defined_name(item)),
            }
        }
        // Two roots, of a library and of a program, are different crates: the library comes first.
        self.0.entry(path).or_insert(module);
    }

    /// The file that defines the item to which a path from the crate root leads; `None` if it leads
    /// to a module or out of the crate.
    fn resolve(&self, path: &[String], depth: usize) -> Option<usize> {
        let mut at = 0;
        while at < path.len() && self.0.contains_key(&path[..=at]) {
            at += 1;
        }
        let module = self.0.get(&path[..at])?;
        let name = path.get(at)?;
        if module.items.contains(name) {
            return Some(module.file);
        }
        // Re-exports of re-exports end, circles of them do not.
        if depth == 0 {
            return None;
        }
        let follow = |import: &Import, rest: &[String]| {
            let full = self.absolute(&path[..at], &[&import.path[..], rest].concat())?;
            self.resolve(&full, depth - 1)
        };
        if let Some(import) = module.uses.iter().find(|import| import.name == *name) {
            return follow(import, &path[at + 1..]);
        }
        module.uses.iter().filter(|import| import.name == "*").find_map(|import| follow(import, &path[at..]))
    }

    /// A path as it is written in a module, from the crate root; `None` if it begins in another
    /// crate.
    fn absolute(&self, module: &[String], path: &[String]) -> Option<Names> {
        let (first, rest) = path.split_first()?;
        match first.as_str() {
            "crate" => Some(rest.to_vec()),
            "self" => Some([module, rest].concat()),
            "super" => {
                let (_, parent) = module.split_last()?;
                match rest.first().map(String::as_str) {
                    Some("super") => self.absolute(parent, rest),
                    _ => Some([parent, rest].concat()),
                }
            }
            _ => {
                let here = self.0.get(module)?;
                let is_own = here.children.contains(first) || here.uses.iter().any(|import| import.name == *first);
                is_own.then(|| [module, path].concat())
            }
        }
    }

    fn imports_of(&self, at: usize, file: &SourceFile) -> BTreeMap<usize, String> {
        let mut named = Named { module: file.module.clone(), found: Vec::new() };
        file.items.iter().for_each(|item| named.visit_item(item));
        let mut edges = BTreeMap::new();
        for (module, path) in named.found {
            let target = self.absolute(&module, &path).and_then(|full| self.resolve(&full, DEEPEST));
            if let Some(to) = target
                && to != at
            {
                edges.entry(to).or_insert_with(|| path.join("::"));
            }
        }
        edges
    }
}

/// Re-exports that a name is followed through.
const DEEPEST: usize = 8;

/// Collects the paths that code names, each with the module in which it stands.
struct Named {
    module: Names,
    found: Vec<(Names, Names)>,
}

impl Named {
    fn add(&mut self, path: Names) {
        self.found.push((self.module.clone(), path));
    }

    /// The paths among the tokens of a macro call.
    fn add_tokens(&mut self, tokens: TokenStream) {
        let mut path: Names = Vec::new();
        // 2: after `::`; 1: after the first colon; 0: a name would begin a new path.
        let mut colons = 0;
        for token in tokens {
            match token {
                TokenTree::Ident(name) => {
                    if colons != 2 {
                        self.add(std::mem::take(&mut path));
                    }
                    path.push(name.to_string());
                    colons = 0;
                    continue;
                }
                TokenTree::Punct(punct) if punct.as_char() == ':' && !path.is_empty() && colons < 2 => {
                    colons += 1;
                    continue;
                }
                TokenTree::Group(group) => self.add_tokens(group.stream()),
                _ => {}
            }
            self.add(std::mem::take(&mut path));
            colons = 0;
        }
        self.add(path);
    }
}

/// Macros whose tokens are code of another crate.
const QUOTING: [&str; 4] = ["quote", "quote_spanned", "parse_quote", "format_ident"];

impl<'ast> Visit<'ast> for Named {
    fn visit_item_mod(&mut self, module: &'ast syn::ItemMod) {
        self.module.push(module.ident.to_string());
        visit::visit_item_mod(self, module);
        self.module.pop();
    }

    /// A private import is used, or the compiler would warn. A re-export alone is no import.
    fn visit_item_use(&mut self, import: &'ast syn::ItemUse) {
        let mut imports = Vec::new();
        if import.leading_colon.is_none() && matches!(import.vis, Visibility::Inherited) {
            flatten(&import.tree, Vec::new(), &mut imports);
        }
        imports.into_iter().for_each(|import| self.add(import.path));
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        if path.leading_colon.is_none() {
            self.add(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        }
        visit::visit_path(self, path);
    }

    /// `pub(in path)` and `pub(super)` name no item.
    fn visit_visibility(&mut self, _: &'ast Visibility) {}

    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}

    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        let name = call.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default();
        if !QUOTING.contains(&name.as_str()) {
            self.add_tokens(call.tokens.clone());
        }
        visit::visit_macro(self, call);
    }
}

fn flatten(tree: &UseTree, mut path: Names, found: &mut Vec<Import>) {
    let mut add = |name: String, path: Names| found.push(Import { name, path });
    match tree {
        UseTree::Path(step) => {
            path.push(step.ident.to_string());
            flatten(&step.tree, path, found);
        }
        UseTree::Group(group) => group.items.iter().for_each(|tree| flatten(tree, path.clone(), found)),
        UseTree::Glob(_) => add("*".to_owned(), path),
        UseTree::Name(name) if name.ident == "self" => add(path.last().cloned().unwrap_or_default(), path),
        UseTree::Name(name) => {
            let name = name.ident.to_string();
            add(name.clone(), [&path[..], &[name]].concat());
        }
        UseTree::Rename(rename) => {
            if rename.ident != "self" {
                path.push(rename.ident.to_string());
            }
            add(rename.rename.to_string(), path);
        }
    }
}

fn defined_name(item: &Item) -> Option<String> {
    let name = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Macro(item) => item.ident.as_ref()?,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        _ => return None,
    };
    Some(name.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A crate from paths and texts.
    fn imports(files: &[(&str, &str)]) -> Imports {
        let folder = tempfile::tempdir().expect("a folder");
        for (path, text) in files {
            let path = folder.path().join(path);
            std::fs::create_dir_all(path.parent().expect("a folder")).expect("created");
            std::fs::write(path, text).expect("written");
        }
        Imports::of(&CrateSource::read(folder.path()))
    }

    #[test]
    fn names_are_followed_to_the_file_that_defines_them() {
        let found = imports(&[
            ("lib.rs", "pub mod a;\nmod b;\nmod c;\npub use b::deep::Item as Renamed;\npub use a::*;\n"),
            ("a.rs", "use crate::{Renamed, c};\npub struct Own(Renamed);\nfn f() { c::g(); }\n"),
            ("b/mod.rs", "pub mod deep;\npub use deep::Item;\npub struct Here;\n"),
            ("b/deep.rs", "pub struct Item;\nfn f(_: super::Here) {}\n"),
            ("c.rs", "pub fn g() { println!(\"{:?}\", crate::Own::new(1)); let b = 1; let _ = b; }\n"),
        ]);
        for (from, to) in [("a.rs", "b/deep.rs"), ("a.rs", "c.rs"), ("b/deep.rs", "b/mod.rs"), ("c.rs", "a.rs")] {
            assert!(found.has(from, to), "{from} imports {to}");
        }
        // Declarations and re-exports are none, nor is a module that a re-export passes through.
        assert_eq!(found.count(), 4);
    }

    #[test]
    fn a_circle_is_found_and_described() {
        let found = imports(&[
            ("lib.rs", "mod a;\nmod b;\nmod c;\nmod d;\n"),
            ("a.rs", "use crate::b::f;\npub fn a() { f() }\n"),
            ("b.rs", "pub fn f() { super::c::g() }\n"),
            ("c.rs", "pub fn g() { vec![crate::a::a()]; }\n"),
            ("d.rs", "use crate::a;\nfn d() { a::a() }\n"),
        ]);
        let circles = found.circles();
        assert_eq!(circles.len(), 1, "{circles:?}");
        for part in ["3 files", "a.rs, b.rs, c.rs\n", "c.rs names `crate::a::a` of a.rs"] {
            assert!(circles[0].contains(part), "`{part}` is missing in {}", circles[0]);
        }
        assert!(!circles[0].contains("d.rs"), "{}", circles[0]);
    }

    /// A parent that calls a child and a child that names an item of the parent need each other.
    #[test]
    fn a_parent_that_uses_a_child_imports_it() {
        let child = ("p/child.rs", "pub fn f(_: super::Own) {}\n");
        let declares = imports(&[("lib.rs", "mod p;\n"), ("p/mod.rs", "pub mod child;\npub struct Own;\n"), child]);
        assert_eq!((declares.count(), declares.circles().len()), (1, 0));
        for call in
            ["fn g() { child::f(Own) }", "use child::f;\nfn g() { f(Own) }", "pub use child::f;\nfn g() { f(Own) }"]
        {
            let text = format!("pub mod child;\npub struct Own;\n{call}\n");
            let calls = imports(&[("lib.rs", "mod p;\n"), ("p/mod.rs", &text), child]);
            assert_eq!((calls.count(), calls.circles().len()), (2, 1), "{call}");
        }
    }

    #[test]
    fn tests_and_emitted_code_import_nothing() {
        let found = imports(&[
            ("lib.rs", "mod a;\nmod b;\n"),
            ("a.rs", "pub fn f() {}\n#[cfg(test)]\nmod tests { use crate::b::g; fn h() { g() } }\n"),
            ("b.rs", "/// [`crate::a::f`]\npub fn g() { quote! { crate::a::f() }; ::a::f(); pub(super) struct X; }\n"),
        ]);
        assert_eq!(found.count(), 0);
    }
}
