//! The source of the project's crates as syntax trees, for tests of its structure.

mod imports;
mod limits;

use std::fs;
use std::path::{Path, PathBuf};

pub use imports::Imports;
pub use limits::{Function, functions};
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Attribute, Item, Meta};

/// A file of a crate, without the code that only its tests compile.
pub struct SourceFile {
    /// The path from the crate's folder `src`.
    pub path: PathBuf,
    /// The modules that lead to it: `["problem", "parse"]`, empty for the crate root.
    pub module: Vec<String>,
    /// All lines, those of tests and comments included.
    pub lines: usize,
    /// The items that are compiled without `cfg(test)`.
    pub items: Vec<Item>,
}

/// All files of a crate that its library or its program compiles.
pub struct CrateSource {
    /// The files by path. `main.rs` is a root like `lib.rs`.
    pub files: Vec<SourceFile>,
    /// Files that only tests compile, such as the target of `#[cfg(test)] mod tests;`.
    pub tests: Vec<PathBuf>,
}

impl CrateSource {
    /// Follows the `mod` items from `lib.rs` and `main.rs` in the folder `src`.
    ///
    /// # Panics
    /// If a file cannot be read or parsed, or if no `mod` item leads to a file of the folder: such
    /// a file would escape every check.
    pub fn read(src: &Path) -> Self {
        let mut source = Self { files: Vec::new(), tests: Vec::new() };
        let all = rust_files(src);
        // Programs of `src/bin` are roots, too.
        let is_root = |path: &&PathBuf| {
            let relative = path.strip_prefix(src).expect("a file of the folder");
            relative == "lib.rs" || relative == "main.rs" || relative.starts_with("bin")
        };
        for root in all.iter().filter(is_root) {
            let folder = root.parent().expect("a file has a folder");
            // A program is a crate of its own. Its root gets a name that no path of the library
            // leads to.
            let stem = root.file_stem().unwrap_or_default().to_string_lossy();
            let module = if stem == "lib" { Vec::new() } else { vec![format!("program {stem}")] };
            source.follow(src, [root, folder], module, false);
        }
        for path in &all {
            let relative = path.strip_prefix(src).expect("a file of the folder");
            let known = source.files.iter().map(|file| &file.path).chain(&source.tests);
            assert!(known.into_iter().any(|path| path == relative), "no `mod` leads to {}", path.display());
        }
        source.files.sort_by(|a, b| a.path.cmp(&b.path));
        source.tests.sort();
        source
    }

    /// Reads one file and those that its `mod` items name. The second path is the folder of its
    /// children.
    fn follow(&mut self, src: &Path, [path, folder]: [&Path; 2], module: Vec<String>, only_tests: bool) {
        let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let file = syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        for item in &file.items {
            let Item::Mod(child) = item else { continue };
            if child.content.is_some() {
                continue;
            }
            let name = child.ident.to_string();
            let nested = folder.join(&name);
            let path =
                [folder.join(format!("{name}.rs")), nested.join("mod.rs")].into_iter().find(|path| path.exists());
            let path = path.unwrap_or_else(|| panic!("{}: no file for `mod {name}`", folder.display()));
            let only_tests = only_tests || is_test(&child.attrs);
            self.follow(src, [&path, &nested], [&module[..], &[name]].concat(), only_tests);
        }
        let path = path.strip_prefix(src).expect("a file of the folder").to_owned();
        match only_tests {
            true => self.tests.push(path),
            false => {
                let (lines, items) = (text.lines().count(), without_tests(file.items));
                self.files.push(SourceFile { path, module, lines, items });
            }
        }
    }
}

/// All files of a folder and its subfolders that end in `.rs`, by path.
pub fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// The items that are compiled without `cfg(test)`, in modules and `impl` blocks, too.
pub fn without_tests(items: Vec<Item>) -> Vec<Item> {
    let mut kept: Vec<Item> = items.into_iter().filter(|item| !is_test(attributes(item))).collect();
    for item in &mut kept {
        match item {
            Item::Mod(module) => {
                if let Some((_, items)) = &mut module.content {
                    *items = without_tests(std::mem::take(items));
                }
            }
            Item::Impl(block) => block.items.retain(|item| !is_test(member_attributes(item))),
            _ => {}
        }
    }
    kept
}

/// Whether the attributes make an item part of the tests: `#[test]`, or a `#[cfg(..)]` that demands
/// `test`.
fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("test")
            || attribute.path().is_ident("cfg")
                && matches!(&attribute.meta, Meta::List(list) if demands_test(list.tokens.clone()))
    })
}

/// Whether a condition of `cfg` holds in tests only: `test`, or `all(..)` with such a condition.
fn demands_test(condition: TokenStream) -> bool {
    let tokens: Vec<TokenTree> = condition.into_iter().collect();
    match &tokens[..] {
        [TokenTree::Ident(name)] => name == "test",
        [TokenTree::Ident(name), TokenTree::Group(group)] if name == "all" => {
            let inner: Vec<TokenTree> = group.stream().into_iter().collect();
            let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',');
            inner.split(is_comma).any(|part| demands_test(part.iter().cloned().collect()))
        }
        _ => false,
    }
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::ExternCrate(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

fn member_attributes(item: &syn::ImplItem) -> &[Attribute] {
    match item {
        syn::ImplItem::Const(item) => &item.attrs,
        syn::ImplItem::Fn(item) => &item.attrs,
        syn::ImplItem::Type(item) => &item.attrs,
        _ => &[],
    }
}

/// The identifiers of items with their lines. Comments and strings hold none, doc comments
/// included.
pub fn identifiers(items: &[Item]) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    items.iter().for_each(|item| collect_identifiers(item.to_token_stream(), &mut found));
    found
}

fn collect_identifiers(tokens: TokenStream, found: &mut Vec<(usize, String)>) {
    for token in tokens {
        match token {
            TokenTree::Ident(name) => found.push((name.span().start().line, name.to_string())),
            TokenTree::Group(group) => collect_identifiers(group.stream(), found),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CODE: &str = r#"
//! Vec in a comment.
use a::b; // Box

#[cfg(test)]
use std::vec;

/// `Rc` in a doc comment, and "String" in a string.
fn before() -> &'static str { "format" }

#[cfg(test)]
mod tests {
    fn inner() { if true { unwrap() } }
}

#[cfg(all(test, feature = "std"))]
const BOX: Box<u8> = todo!();

#[cfg(not(test))]
fn kept() { expect() }

#[cfg(any(test, feature = "std"))]
fn also_kept() {}

struct After;

impl After {
    #[cfg(test)]
    fn helper() { panic!() }
    fn method(&self) { after(self) }
}

mod nested {
    #[test]
    fn check() { unreachable!() }
    fn last() { vec![1] }
}
"#;

    /// What stands behind a test module is read, and nothing of the module itself.
    #[test]
    fn tests_are_dropped_wherever_they_stand_and_nothing_else_is() {
        let items = without_tests(syn::parse_file(CODE).expect("Rust").items);
        let words: Vec<String> = identifiers(&items).into_iter().map(|(_, word)| word).collect();
        for word in ["a", "b", "before", "kept", "expect", "also_kept", "After", "method", "after", "last", "vec"] {
            assert!(words.iter().any(|found| found == word), "{word} is lost: {words:?}");
        }
        for word in
            ["Vec", "Box", "Rc", "String", "format", "tests", "inner", "unwrap", "BOX", "todo", "helper", "panic"]
        {
            assert!(words.iter().all(|found| found != word), "{word} is kept: {words:?}");
        }
        assert_eq!(words.iter().filter(|word| *word == "vec").count(), 1, "{words:?}");
        let line = CODE.lines().position(|line| line.contains("fn last")).expect("a line") + 1;
        assert!(identifiers(&items).contains(&(line, "last".to_owned())));
    }

    /// The crate's own source: the file behind `mod`, and no file that only tests compile.
    #[test]
    fn a_crate_is_read_along_its_modules() {
        let folder = tempfile::tempdir().expect("a folder");
        let write = |path: &str, text: &str| {
            let path = folder.path().join(path);
            fs::create_dir_all(path.parent().expect("a folder")).expect("created");
            fs::write(path, text).expect("written");
        };
        write("lib.rs", "mod a;\npub mod b;\n#[cfg(test)]\nmod checks;\nmod inline { pub fn f() {} }\n");
        write("a.rs", "fn f() {}\n#[cfg(test)]\nmod tests;\n");
        write("a/tests.rs", "fn g() {}\n");
        write("b/mod.rs", "mod c;\n");
        write("b/c.rs", "fn h() {}\n");
        write("checks.rs", "fn i() {}\n");
        let source = CrateSource::read(folder.path());
        let paths: Vec<&Path> = source.files.iter().map(|file| file.path.as_path()).collect();
        assert_eq!(paths, ["a.rs", "b/c.rs", "b/mod.rs", "lib.rs"].map(Path::new));
        assert_eq!(source.files[1].module, ["b", "c"]);
        assert_eq!(source.files[3].lines, 5);
        assert_eq!(source.tests, ["a/tests.rs", "checks.rs"].map(PathBuf::from));
        write("stray.rs", "fn j() {}\n");
        assert!(std::panic::catch_unwind(|| CrateSource::read(folder.path())).is_err(), "a stray file is accepted");
    }
}
