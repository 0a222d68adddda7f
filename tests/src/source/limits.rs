//! The sizes of functions.

use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{FnArg, Item, Signature};

/// A function or a method with a body.
pub struct Function {
    /// Its name.
    pub name: String,
    /// The line of its signature.
    pub line: usize,
    /// The lines from the signature to the closing brace. Attributes and doc comments do not count.
    pub lines: usize,
    /// The number of parameters. `self` does not count.
    pub parameters: usize,
}

/// All functions of items: free ones, methods, provided methods of traits, and those inside of
/// other functions. A closure belongs to the function in which it stands.
pub fn functions(items: &[Item]) -> Vec<Function> {
    let mut found = Functions(Vec::new());
    items.iter().for_each(|item| found.visit_item(item));
    found.0
}

struct Functions(Vec<Function>);

impl Functions {
    fn add(&mut self, visibility: Span, signature: &Signature, body: &syn::Block) {
        // The span of an inherited visibility is that of the call site, line 1.
        let line = match visibility.byte_range().is_empty() {
            true => signature.span().start().line,
            false => visibility.start().line,
        };
        let lines = body.brace_token.span.close().end().line + 1 - line;
        let parameters = signature.inputs.iter().filter(|input| matches!(input, FnArg::Typed(_))).count();
        self.0.push(Function { name: signature.ident.to_string(), line, lines, parameters });
    }
}

impl<'ast> Visit<'ast> for Functions {
    fn visit_item_fn(&mut self, function: &'ast syn::ItemFn) {
        self.add(function.vis.span(), &function.sig, &function.block);
        visit::visit_item_fn(self, function);
    }

    fn visit_impl_item_fn(&mut self, function: &'ast syn::ImplItemFn) {
        self.add(function.vis.span(), &function.sig, &function.block);
        visit::visit_impl_item_fn(self, function);
    }

    fn visit_trait_item_fn(&mut self, function: &'ast syn::TraitItemFn) {
        if let Some(body) = &function.default {
            self.add(Span::call_site(), &function.sig, body);
        }
        visit::visit_trait_item_fn(self, function);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CODE: &str = "\
/// A doc comment
/// of two lines.
#[inline]
pub fn free(
    a: u8,
    b: u8,
) -> u8 {
    fn nested() {}
    let closure = |x: u8, y: u8| x + y;
    closure(a, b)
}

trait Shape {
    fn area(&self) -> f64;
    fn twice(&self, times: f64) -> f64 {
        times * self.area()
    }
}

impl Shape for u8 {
    fn area(&self) -> f64 { 1.0 }
}
";

    #[test]
    fn lines_and_parameters_are_counted() {
        let functions = functions(&syn::parse_file(CODE).expect("Rust").items);
        let found: Vec<(&str, usize, usize, usize)> =
            functions.iter().map(|f| (f.name.as_str(), f.line, f.lines, f.parameters)).collect();
        assert_eq!(found, [("free", 4, 8, 2), ("nested", 8, 1, 0), ("twice", 15, 3, 1), ("area", 21, 1, 0)]);
    }
}
