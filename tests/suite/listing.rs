//! The text of a golden book: what people wrote, and right of it what partc makes of each line.

mod short;

use std::collections::BTreeMap;

use super::book::read::{Entry, SEPARATOR, THEN, WANTED, is_comment};
use super::book::{self, Case};
use super::common::{Compiled, Line};

/// What partc makes begins right of this column, or of a longer line.
const COLUMN: usize = 44;

/// Lines that hold more than one piece of output are no longer.
const WIDTH: usize = 140;

/// A block, what it printed, and what was found in it.
struct Listed {
    /// File and line.
    at: (u16, u32),
    source: String,
    outputs: Vec<String>,
    findings: Vec<String>,
}

impl Listed {
    /// Outputs in short, and findings.
    fn made(&self) -> Vec<String> {
        let mut made = short::outputs(&self.source, &self.outputs);
        made.extend(self.findings.iter().cloned());
        made
    }
}

/// What partc makes of an entry.
#[derive(Default)]
struct Made {
    /// By part and line.
    beside: BTreeMap<(usize, usize), Vec<String>>,
    /// Blocks from the first one that runs again, out of order or in another file.
    then: Vec<Listed>,
}

/// The text of a book, made of what people wrote.
pub fn of(book: &str, inputs: &str) -> String {
    let mut text = String::new();
    for entry in book::entries(book, inputs) {
        let made = match (entry.rows, &entry.cases[..]) {
            (Some(rows), cases) => table(&entry, rows, cases),
            (None, [case]) => single(&entry, case),
            (None, _) => Made::default(),
        };
        write(&entry, &made, &mut text);
    }
    text
}

fn write(entry: &Entry<'_>, made: &Made, text: &mut String) {
    for (at, part) in entry.parts.iter().enumerate() {
        for line in std::iter::once(&part.mark).chain(&part.wanted) {
            *text += &format!("{line}\n");
        }
        for (line, content) in part.content().iter().enumerate() {
            put(text, content, made.beside.get(&(at, line)).map_or(&[], Vec::as_slice));
        }
        if at + 1 == entry.parts.len() && !made.then.is_empty() {
            *text += &format!("{THEN}\n");
            for block in &made.then {
                let source: String = block.source.chars().map(|c| if c.is_control() { '·' } else { c }).collect();
                // A line without text is layout.
                put(text, if source.is_empty() { "·" } else { &source }, &block.made());
            }
        }
        part.lines[part.content().len()..].iter().for_each(|line| *text += &format!("{line}\n"));
    }
}

/// Writes a line and what partc makes of it: beside it, and below where there is no room. A finding has a line of its own
/// unless it is all that there is.
fn put(text: &mut String, line: &str, made: &[String]) {
    let mut rows = vec![line.to_owned()];
    // The end of a line that ends with blanks would not be seen.
    let beside = !line.is_empty() && line.trim_end() == line;
    for (at, piece) in made.iter().enumerate() {
        let last = rows.last_mut().expect("the line");
        let width = last.chars().count() + piece.chars().count() + 3;
        if at == 0 && beside {
            *last = format!("{last:COLUMN$} {SEPARATOR} {piece}");
        } else if at > 0 && width <= WIDTH && !piece.starts_with("!!") {
            *last += &format!(" {SEPARATOR} {piece}");
        } else {
            rows.push(format!("    {SEPARATOR} {piece}"));
        }
    }
    rows.iter().for_each(|row| *text += &format!("{row}\n"));
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

/// How many blocks stand in the main program in its order, each once, on lines that show them. The program has as many lines as it
/// is written in.
fn in_order(case: &Case, written: usize, blocks: &[Listed]) -> usize {
    let program = String::from_utf8_lossy(&case.program);
    let lines: Vec<&str> = program.lines().collect();
    let mut before = 0;
    let fits = |block: &&Listed| {
        let (file, line) = block.at;
        let here = file == 0 && line > before;
        before = line;
        here && lines.get(line as usize - 1).is_some_and(|text| text.trim() == block.source)
    };
    if lines.len() == written { blocks.iter().take_while(fits).count() } else { 0 }
}

fn single(entry: &Entry<'_>, case: &Case) -> Made {
    let mut blocks = blocks(case);
    let then = blocks.split_off(in_order(case, entry.parts[entry.program].content().len(), &blocks));
    let beside = blocks.iter().map(|block| ((entry.program, block.at.1 as usize - 1), block.made())).collect();
    Made { beside, then }
}

/// What all rows have in common stands beside the program; what is different, beside the row.
fn table(entry: &Entry<'_>, rows: usize, cases: &[Case]) -> Made {
    let template = entry.parts[entry.program].content();
    let comments_at = template.iter().position(|line| *line == "{comments}");
    let written = entry.parts[rows].content();
    let starts = (0..written.len()).filter(|at| !is_comment(written[*at]) && !written[*at].starts_with(WANTED));
    let mut beside: BTreeMap<(usize, usize), Vec<String>> = BTreeMap::new();
    // Of each row: where it stands, what each line of the template makes, and what comes of blocks out of order.
    let mut results = Vec::new();
    for (case, row) in cases.iter().zip(starts) {
        let comments = written[row + 1..].iter().take_while(|line| is_comment(line)).count();
        // The line of the template, or of the comments under the row.
        let place = |block: &Listed| {
            let line = block.at.1 as usize - 1;
            match comments_at {
                Some(at) if line >= at + comments => Ok(line + 1 - comments),
                Some(at) if line >= at => Err(row + 1 + line - at),
                _ => Ok(line),
            }
        };
        let mut blocks = blocks(case);
        let lines = comments_at.map_or(template.len(), |_| template.len() - 1 + comments);
        let then = blocks.split_off(in_order(case, lines, &blocks));
        let mut made = vec![Vec::new(); template.len()];
        for block in &blocks {
            match place(block) {
                Ok(line) => made[line] = block.made(),
                Err(line) => drop(beside.insert((rows, line), block.made())),
            }
        }
        results.push((row, made, then.iter().flat_map(Listed::made).collect::<Vec<_>>()));
    }
    for line in 0..template.len() {
        if results.iter().all(|(_, made, _)| made[line] == results[0].1[line]) {
            beside.insert((entry.program, line), results[0].1[line].clone());
        } else {
            for (row, made, _) in &results {
                beside.entry((rows, *row)).or_default().extend(made[line].iter().cloned());
            }
        }
    }
    for (row, _, then) in results {
        beside.entry((rows, row)).or_default().extend(then);
    }
    Made { beside, then: Vec::new() }
}
