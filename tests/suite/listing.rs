//! The listing of a golden book: output beside the block that caused it, findings under the block they belong to.

use std::fmt::Write as _;

use super::book::Case;
use super::common::{Compiled, Line};

/// Width of the source column; longer blocks stand on a line of their own.
const WIDTH: usize = 44;

/// A block, what it printed, and what was found in it.
struct Listed {
    /// File and line.
    at: (u16, u32),
    source: String,
    outputs: Vec<String>,
    findings: Vec<String>,
}

/// The listings of the cases of a book, each under its heading.
pub fn of(cases: &[&Case]) -> String {
    let mut text = String::new();
    let mut chapter = "";
    for group in cases.chunk_by(|a, b| a.table.is_some() && a.chapter == b.chapter && head(a) == head(b)) {
        if group[0].chapter != chapter {
            chapter = &group[0].chapter;
            let _ = writeln!(text, "{}=== {chapter}", if text.is_empty() { "" } else { "\n" });
        }
        let _ = writeln!(text, "\n== {}", head(group[0]));
        match group {
            [case] if case.table.is_none() => {
                lines(&blocks(case)).iter().for_each(|line| text = text.clone() + line + "\n")
            }
            rows => table(rows, &mut text),
        }
    }
    text
}

fn head(case: &Case) -> &str {
    case.table.as_ref().map_or(&case.heading, |(heading, _)| heading)
}

fn blocks(case: &Case) -> Vec<Listed> {
    let compiled = case.compile();
    let mut blocks: Vec<Listed> = Vec::new();
    // The head and the frame come from no block.
    for (number, output) in (1..).zip(compiled.output.lines()) {
        let Some(Line { at, text, .. }) = compiled.lines.iter().find(|line| line.number == number) else { continue };
        match blocks.last_mut() {
            Some(last) if last.at == *at && last.source == *text => last.outputs.push(output.to_owned()),
            _ => blocks.push(Listed {
                at: *at,
                source: text.clone(),
                outputs: vec![output.to_owned()],
                findings: Vec::new(),
            }),
        }
    }
    add_findings(case, &compiled, &mut blocks);
    blocks
}

/// Puts each finding under the first listing of its block, and lists blocks that printed nothing where they stand.
fn add_findings(case: &Case, compiled: &Compiled, blocks: &mut Vec<Listed>) {
    let shown = compiled.rendered.iter().zip(&compiled.found_in);
    for (found, (shown, source)) in compiled.findings.iter().zip(shown) {
        let at = (found.label.loc.file.0, found.label.loc.line);
        let exact = blocks.iter().position(|block| block.at == at && block.source == *source);
        let place = exact.or_else(|| blocks.iter().position(|block| block.at == at)).unwrap_or_else(|| {
            let later = |block: &Listed| at.0 == 0 && block.at.0 == 0 && block.at.1 > at.1;
            let place = blocks.iter().position(later).unwrap_or(blocks.len());
            let source = source.clone();
            blocks.insert(place, Listed { at, source, outputs: Vec::new(), findings: Vec::new() });
            place
        });
        let shown = shown.strip_prefix(&format!("{}:", case.file)).unwrap_or(shown);
        blocks[place].findings.push(format!("!! {shown}"));
    }
}

fn lines(blocks: &[Listed]) -> Vec<String> {
    let mut lines = Vec::new();
    for block in blocks {
        let source: String = block.source.chars().map(|c| if c.is_control() { '·' } else { c }).collect();
        let mut left = source.as_str();
        if block.outputs.is_empty() || left.chars().count() > WIDTH {
            lines.push(left.to_owned());
            left = "";
        }
        for output in &block.outputs {
            lines.push(format!("{left:WIDTH$} | {output}"));
            left = "";
        }
        lines.extend(block.findings.iter().cloned());
    }
    lines
}

/// What all rows have in common stands once; what is different, in one line a row.
fn table(rows: &[&Case], text: &mut String) {
    let listed: Vec<Vec<String>> = rows.iter().map(|case| without_comments(case)).collect();
    let first = &listed[0];
    let same = |of: &dyn Fn(&Vec<String>, usize) -> Option<String>| {
        (0..first.len()).take_while(|&at| listed.iter().all(|row| of(row, at) == of(first, at))).count()
    };
    let before = same(&|row, at| row.get(at).cloned());
    let shortest = listed.iter().map(Vec::len).min().unwrap_or(0);
    let after = same(&|row, at| row.len().checked_sub(at + 1).map(|at| row[at].clone())).min(shortest - before);
    let all = first.iter().map(|line| line.as_str());
    all.clone().take(before).for_each(|line| *text += &format!("{line}\n"));
    for (case, row) in rows.iter().zip(&listed) {
        let own: Vec<&str> = row[before..row.len() - after].iter().filter_map(|line| result(line)).collect();
        let _ = writeln!(text, "{}: {}", case.table.as_ref().map_or("", |(_, row)| row), own.join("; "));
    }
    all.skip(first.len() - after).for_each(|line| *text += &format!("{line}\n"));
}

/// A line of a listing without its source.
fn result(line: &str) -> Option<&str> {
    line.split_once(" | ").map(|(_, output)| output).or_else(|| line.starts_with("!!").then_some(line))
}

/// The listing of a row without the comments that the row brings along.
fn without_comments(case: &Case) -> Vec<String> {
    let mut blocks = blocks(case);
    blocks.retain(|block| !block.source.starts_with([';', '[']) || !block.findings.is_empty());
    lines(&blocks)
}
