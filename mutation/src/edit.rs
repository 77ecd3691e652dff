//! A source text with its changes built in, each behind its number.
//!
//! An expression with a changed part becomes `(if on(7) { changed } else { as it was })`, and what is changed within it
//! stands in the second branch alone: one change is on at a time. A function that gives a fixed value returns it first.
//! Comments `/*<7*/ … /*7>*/` around each say whose text it is when it does not compile.

use std::collections::BTreeMap;
use std::ops::Range;

use proc_macro2::{LineColumn, Span};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

use super::Result;
use super::list::{Genre, Mutant};

/// What is done at a place.
enum Act<'a> {
    /// In front of the first statement.
    Return(&'a str),
    /// The part is replaced in one branch.
    Branch {
        part: Range<usize>,
        with: &'a str,
    },
    /// A guard for an arm without one.
    NewGuard,
    /// The guard, and a condition in front of it: the arm is never taken, or always.
    Never,
    Always,
}

struct Edit<'a> {
    at: Range<usize>,
    number: usize,
    act: Act<'a>,
}

/// The text with the changes in it, and the numbers of those that cannot be said so, with the reason.
pub fn apply(text: &str, mutants: &[&Mutant]) -> Result<(String, Vec<(usize, &'static str)>)> {
    let lines = Lines::of(text);
    let mut found = Found::of(&lines);
    found.visit_file(&syn::parse_file(text)?);
    let mut edits = Vec::new();
    let mut unsaid = Vec::new();
    for mutant in mutants {
        match edit(mutant, &lines, &found) {
            Ok((at, act)) => edits.push(Edit { at, number: mutant.number, act }),
            Err(why) => unsaid.push((mutant.number, why)),
        }
    }
    // What holds others comes before them.
    edits.sort_by_key(|edit| (edit.at.start, usize::MAX - edit.at.end, edit.number));
    Ok((rendered(text, 0..text.len(), &edits), unsaid))
}

/// Where a change stands and what is done there, or why it cannot be built in.
fn edit<'a>(
    mutant: &'a Mutant,
    lines: &Lines,
    found: &Found,
) -> std::result::Result<(Range<usize>, Act<'a>), &'static str> {
    let offset = |(line, column): (usize, usize)| lines.offset(line, column - 1).ok_or("no such place");
    let part = offset(mutant.start)?..offset(mutant.end)?;
    match mutant.genre {
        Genre::Body if mutant.is_opaque => Err("not said: a type that only the body says"),
        Genre::Body => Ok((part.start..part.start, Act::Return(&mutant.replacement))),
        Genre::Part => match found.wholes.get(&part.start) {
            Some(Some(whole)) => Ok((whole.clone(), Act::Branch { part, with: &mutant.replacement })),
            Some(None) => Err("no Rust: `||` beside `let`"),
            None => Err("not said: in a constant"),
        },
        Genre::Arm => match found.arms.get(&part.start).ok_or("not said: no such arm")? {
            (_, Some(guard)) => Ok((guard.clone(), Act::Never)),
            (pattern, None) => Ok((pattern.end..pattern.end, Act::NewGuard)),
        },
        Genre::Guard => Ok((part, if mutant.replacement == "true" { Act::Always } else { Act::Never })),
    }
}

/// The text of a range; the edits all lie in it, outer ones in front of inner ones.
fn rendered(text: &str, range: Range<usize>, edits: &[Edit]) -> String {
    let mut out = String::new();
    let mut at = range.start;
    let mut rest = edits;
    while let Some((edit, behind)) = rest.split_first() {
        out.push_str(&text[at..edit.at.start]);
        // An empty range holds nothing, but for those at the same place, which come one after the other.
        let within = behind.iter().take_while(|other| !edit.at.is_empty() && other.at.start < edit.at.end).count();
        let (inner, others) = behind.split_at(within);
        let as_it_was = rendered(text, edit.at.clone(), inner);
        let number = edit.number;
        let on = format!("crate::mutation::on({number})");
        let new = match &edit.act {
            Act::Return(value) => format!("if {on} {{ return {value}; }} "),
            Act::Branch { part, with } => {
                let changed = [&text[edit.at.start..part.start], with, &text[part.end..edit.at.end]].join(" ");
                format!("(if {on} {{ {changed} }} else {{ {as_it_was} }})")
            }
            Act::NewGuard => format!(" if !{on}"),
            Act::Never => format!("(!{on} && ({as_it_was}))"),
            Act::Always => format!("({on} || ({as_it_was}))"),
        };
        out.push_str(&format!("/*<{number}*/{new}/*{number}>*/"));
        at = edit.at.end;
        rest = others;
    }
    out.push_str(&text[at..range.end]);
    out
}

/// Whose text stands at an offset of a changed text: the innermost change around it.
pub fn owner(text: &str, at: usize) -> Option<usize> {
    let mut open = Vec::new();
    let mut from = 0;
    while let Some(mark) = text[from..].find("/*").map(|found| from + found) {
        if mark > at {
            break;
        }
        let end = text[mark..].find("*/").map(|found| mark + found)?;
        let inner = &text[mark + 2..end];
        if let Some(number) = inner.strip_prefix('<').and_then(|number| number.parse::<usize>().ok()) {
            open.push(number);
        } else if inner.strip_suffix('>').is_some_and(|number| number.parse::<usize>().is_ok()) {
            open.pop();
        }
        from = mark + 2;
    }
    open.last().copied()
}

/// Where lines begin.
pub struct Lines<'a> {
    text: &'a str,
    starts: Vec<usize>,
}

impl<'a> Lines<'a> {
    pub fn of(text: &'a str) -> Lines<'a> {
        let starts = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        Lines { text, starts }
    }

    /// The byte of a line from 1 and a column from 0, counted in characters.
    pub fn offset(&self, line: usize, column: usize) -> Option<usize> {
        let start = *self.starts.get(line.checked_sub(1)?)?;
        let rest = &self.text[start..];
        Some(start + rest.char_indices().nth(column).map_or(rest.len(), |(at, _)| at))
    }

    fn range(&self, span: Span) -> Range<usize> {
        let at = |place: LineColumn| self.offset(place.line, place.column).unwrap_or(0);
        at(span.start())..at(span.end())
    }
}

/// Where the expressions and arms stand.
struct Found<'a> {
    lines: &'a Lines<'a>,
    /// By the start of what is replaced: the whole expression; none where it binds by `let`.
    wholes: BTreeMap<usize, Option<Range<usize>>>,
    /// By the start of the arm: pattern and guard.
    arms: BTreeMap<usize, (Range<usize>, Option<Range<usize>>)>,
}

impl<'a> Found<'a> {
    fn of(lines: &'a Lines<'a>) -> Found<'a> {
        Found { lines, wholes: BTreeMap::new(), arms: BTreeMap::new() }
    }
}

/// `let` binds in chains of `&&`; such a chain cannot be put into parentheses.
fn binds(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::Let(_) => true,
        syn::Expr::Binary(binary) => binds(&binary.left) || binds(&binary.right),
        _ => false,
    }
}

impl<'ast> Visit<'ast> for Found<'_> {
    fn visit_expr_binary(&mut self, binary: &'ast syn::ExprBinary) {
        let whole = self.lines.range(binary.span());
        let binds = binds(&binary.left) || binds(&binary.right);
        self.wholes.insert(self.lines.range(binary.op.span()).start, (!binds).then_some(whole));
        visit::visit_expr_binary(self, binary);
    }

    fn visit_expr_unary(&mut self, unary: &'ast syn::ExprUnary) {
        let whole = self.lines.range(unary.span());
        self.wholes.insert(whole.start, Some(whole));
        visit::visit_expr_unary(self, unary);
    }

    fn visit_expr_struct(&mut self, expr: &'ast syn::ExprStruct) {
        for field in &expr.fields {
            self.wholes.insert(self.lines.range(field.span()).start, Some(self.lines.range(expr.span())));
        }
        visit::visit_expr_struct(self, expr);
    }

    fn visit_arm(&mut self, arm: &'ast syn::Arm) {
        let pattern = self.lines.range(arm.pat.span());
        let guard = arm.guard.as_ref().map(|(_, guard)| self.lines.range(guard.span()));
        self.arms.insert(self.lines.range(arm.span()).start, (pattern, guard));
        visit::visit_arm(self, arm);
    }

    // A constant asks for nothing at run time.
    fn visit_item_const(&mut self, _: &'ast syn::ItemConst) {}
    fn visit_item_static(&mut self, _: &'ast syn::ItemStatic) {}
    fn visit_impl_item_const(&mut self, _: &'ast syn::ImplItemConst) {}
    fn visit_trait_item_const(&mut self, _: &'ast syn::TraitItemConst) {}
}
