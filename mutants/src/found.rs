//! What can be changed in a text, and into what.

use proc_macro2::LineColumn;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Attribute, Expr, Pat};

/// A change of a source.
#[derive(Debug)]
pub struct Mutant {
    pub line: usize,
    pub function: String,
    /// What stands there, and what it becomes, for people.
    pub was: String,
    pub becomes: String,
    /// The bytes that it is about.
    pub from: usize,
    pub to: usize,
    pub change: Change,
}

/// How the text changes.
#[derive(Debug)]
pub enum Change {
    /// Another expression.
    Instead(String),
    /// The function ends at once with this.
    Return(String),
    /// The guard of an arm holds always, or never.
    Guard(bool),
    /// The arm whose pattern ends here is left out.
    NoArm,
}

/// What stands instead of an operator.
const OPERATORS: &[(&str, &[&str])] = &[
    ("==", &["!="]),
    ("!=", &["=="]),
    ("<", &[">", "<="]),
    (">", &["<", ">="]),
    ("<=", &[">", "<"]),
    (">=", &["<", ">"]),
    ("&&", &["||"]),
    ("||", &["&&"]),
    ("+", &["-"]),
    ("-", &["+"]),
    ("*", &["/"]),
    ("/", &["*"]),
    ("%", &["/"]),
    ("&", &["|"]),
    ("|", &["&"]),
    ("^", &["|"]),
    ("<<", &[">>"]),
    (">>", &["<<"]),
    ("+=", &["-="]),
    ("-=", &["+="]),
    ("|=", &["&="]),
    ("&=", &["|="]),
];
const COMPARISONS: &[&str] = &["==", "!=", "<=", ">="];

/// What a function gives back instead, by its type.
const PLAIN: &[(&str, &[&str])] = &[
    ("", &[""]),
    ("()", &["()"]),
    ("bool", &["true", "false"]),
    ("String", &["String::new()"]),
    ("&str", &["\"\""]),
    ("&'static str", &["\"\""]),
    ("Text", &["Text::default()"]),
    ("u8", &["0", "1"]),
    ("u16", &["0", "1"]),
    ("u32", &["0", "1"]),
    ("u64", &["0", "1"]),
    ("usize", &["0", "1"]),
    ("i32", &["0", "1"]),
    ("i64", &["0", "1"]),
];

/// All mutants of a source, tests, constants and the insides of macros left alone.
pub fn mutants(text: &str) -> syn::Result<Vec<Mutant>> {
    let tree = syn::parse_file(text)?;
    let lines = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
    let mut finder = Finder { text, lines, functions: Vec::new(), found: Vec::new() };
    finder.visit_file(&tree);
    Ok(finder.found)
}

struct Finder<'a> {
    text: &'a str,
    /// Where each line begins.
    lines: Vec<usize>,
    functions: Vec<String>,
    found: Vec<Mutant>,
}

impl Finder<'_> {
    fn at(&self, place: LineColumn) -> usize {
        let begins = self.lines[place.line - 1];
        let line = &self.text[begins..];
        begins + line.char_indices().nth(place.column).map_or(line.len(), |(at, _)| at)
    }

    fn range(&self, node: &impl Spanned) -> (usize, usize) {
        let span = node.span();
        (self.at(span.start()), self.at(span.end()))
    }

    fn source(&self, node: &impl Spanned) -> &str {
        let (from, to) = self.range(node);
        &self.text[from..to]
    }

    fn add(&mut self, line: usize, (from, to): (usize, usize), [was, becomes]: [&str; 2], change: Change) {
        let short = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let function = self.functions.join("::");
        let (was, becomes) = (short(was), short(becomes));
        self.found.push(Mutant { line, function, was, becomes, from, to, change });
    }

    fn instead(&mut self, node: &impl Spanned, other: String) {
        let (line, range, was) = (node.span().start().line, self.range(node), self.source(node).to_owned());
        self.add(line, range, [&was, &other.clone()], Change::Instead(other));
    }

    fn function(&mut self, attributes: &[Attribute], signature: &syn::Signature, block: &syn::Block) {
        if is_test(attributes) || signature.constness.is_some() {
            return;
        }
        self.functions.push(signature.ident.to_string());
        let given = match &signature.output {
            syn::ReturnType::Default => String::new(),
            syn::ReturnType::Type(_, kind) => self.source(kind).split_whitespace().collect::<Vec<_>>().join(" "),
        };
        let open = self.at(block.brace_token.span.open().end());
        let stands = match &block.stmts[..] {
            [only] => Some(self.source(only).to_owned()),
            _ => None,
        };
        for plain in plain(&given).into_iter().filter(|plain| !block.stmts.is_empty() && stands.as_ref() != Some(plain))
        {
            let (was, becomes) = (format!("{}()", signature.ident), format!("{{ {plain} }}"));
            self.add(signature.span().start().line, (open, open), [&was, &becomes], Change::Return(plain));
        }
        visit::visit_block(self, block);
        self.functions.pop();
    }
}

/// Values that are easy to give back.
fn plain(given: &str) -> Vec<String> {
    let listed = |given: &str| PLAIN.iter().find(|row| row.0 == given).map(|row| row.1);
    if let Some(values) = listed(given) {
        return values.iter().map(|text| (*text).to_owned()).collect();
    }
    if let Some(inside) = inside(given, "Option<") {
        let some = listed(inside).unwrap_or_default().iter().filter(|value| **value != "()");
        return std::iter::once("None".to_owned()).chain(some.map(|value| format!("Some({value})"))).collect();
    }
    if let Some(inside) = inside(given, "Result<") {
        return plain(inside).into_iter().map(|value| format!("Ok({value})")).collect();
    }
    if given.starts_with("Vec<") { vec!["Vec::new()".to_owned()] } else { Vec::new() }
}

/// The first type between the angles.
fn inside<'a>(given: &'a str, outer: &str) -> Option<&'a str> {
    let inside = given.strip_prefix(outer)?.strip_suffix('>')?;
    let mut depth = 0;
    let end = inside.find(|c| {
        depth += match c {
            '<' | '(' | '[' => 1,
            '>' | ')' | ']' => -1,
            _ => 0,
        };
        c == ',' && depth == 0
    });
    Some(inside[..end.unwrap_or(inside.len())].trim())
}

fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        syn::Meta::List(list) => list.path.is_ident("cfg") && list.tokens.to_string().contains("test"),
        meta => meta.path().is_ident("test"),
    })
}

/// `if let … && …` is no expression that can be put elsewhere.
fn has_let(expression: &Expr) -> bool {
    match expression {
        Expr::Let(_) => true,
        Expr::Binary(binary) => has_let(&binary.left) || has_let(&binary.right),
        Expr::Paren(paren) => has_let(&paren.expr),
        _ => false,
    }
}

/// Whether nothing is left for the arms behind it.
fn catches_all(arm: &syn::Arm) -> bool {
    arm.guard.is_none()
        && match &arm.pat {
            Pat::Wild(_) => true,
            Pat::Ident(name) => name.subpat.is_none() && name.ident.to_string().starts_with(char::is_lowercase),
            Pat::Tuple(all) => all.elems.iter().all(|part| matches!(part, Pat::Wild(_))),
            _ => false,
        }
}

impl<'ast> Visit<'ast> for Finder<'_> {
    fn visit_item_mod(&mut self, node: &'ast syn::ItemMod) {
        if !is_test(&node.attrs) {
            visit::visit_item_mod(self, node);
        }
    }

    fn visit_item_impl(&mut self, node: &'ast syn::ItemImpl) {
        if !is_test(&node.attrs) {
            visit::visit_item_impl(self, node);
        }
    }

    fn visit_item_const(&mut self, _: &'ast syn::ItemConst) {}
    fn visit_item_static(&mut self, _: &'ast syn::ItemStatic) {}
    fn visit_impl_item_const(&mut self, _: &'ast syn::ImplItemConst) {}
    fn visit_expr_const(&mut self, _: &'ast syn::ExprConst) {}
    fn visit_attribute(&mut self, _: &'ast Attribute) {}
    fn visit_pat(&mut self, _: &'ast Pat) {}
    fn visit_type(&mut self, _: &'ast syn::Type) {}

    fn visit_item_fn(&mut self, node: &'ast syn::ItemFn) {
        self.function(&node.attrs, &node.sig, &node.block);
    }

    fn visit_impl_item_fn(&mut self, node: &'ast syn::ImplItemFn) {
        self.function(&node.attrs, &node.sig, &node.block);
    }

    fn visit_trait_item_fn(&mut self, node: &'ast syn::TraitItemFn) {
        if let Some(block) = &node.default {
            self.function(&node.attrs, &node.sig, block);
        }
    }

    fn visit_expr_binary(&mut self, node: &'ast syn::ExprBinary) {
        let operator = self.source(&node.op).to_owned();
        if !has_let(&node.left)
            && !has_let(&node.right)
            && let Some((_, others)) = OPERATORS.iter().find(|row| row.0 == operator)
        {
            let (left, right) = (self.source(&node.left).to_owned(), self.source(&node.right).to_owned());
            let assigns = operator.ends_with('=') && !COMPARISONS.contains(&operator.as_str());
            for other in *others {
                let left = if assigns { left.clone() } else { format!("({left})") };
                self.instead(node, format!("{left} {other} ({right})"));
            }
        }
        visit::visit_expr_binary(self, node);
    }

    fn visit_expr_unary(&mut self, node: &'ast syn::ExprUnary) {
        if matches!(node.op, syn::UnOp::Not(_) | syn::UnOp::Neg(_)) && !matches!(*node.expr, Expr::Lit(_)) {
            self.instead(node, self.source(&node.expr).to_owned());
        }
        visit::visit_expr_unary(self, node);
    }

    fn visit_expr_match(&mut self, node: &'ast syn::ExprMatch) {
        let has_rest = node.arms.iter().any(catches_all);
        for arm in &node.arms {
            let (line, pattern) = (arm.span().start().line, self.source(&arm.pat).to_owned());
            match &arm.guard {
                Some((_, guard)) if !has_let(guard) => {
                    let was = format!("{pattern} if {}", self.source(guard));
                    for always in [true, false] {
                        self.add(line, self.range(guard), [&was, &format!("if {always}")], Change::Guard(always));
                    }
                }
                None if has_rest && !catches_all(arm) => {
                    let to = self.range(&arm.pat).1;
                    self.add(line, (to, to), [&format!("{pattern} =>"), "no such arm"], Change::NoArm);
                }
                _ => {}
            }
        }
        visit::visit_expr_match(self, node);
    }
}
