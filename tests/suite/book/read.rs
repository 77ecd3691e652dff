//! Reads the text of a golden book.

use std::collections::BTreeMap;

use super::Case;

/// What stands right of it, partc makes; no program contains it.
pub const SEPARATOR: char = '│';

/// Begins the blocks of a case that run again or out of order, which partc writes.
pub const THEN: &str = "-- then";

/// The text that people write: without the head that insta puts in front, and without what partc makes.
pub fn inputs(text: &str) -> String {
    let mut lines = text.lines().peekable();
    if lines.next_if_eq(&"---").is_some() {
        lines.find(|line| *line == "---");
    }
    let (mut inputs, mut made) = (String::new(), false);
    for line in lines {
        made = if is_mark(line) { line == THEN } else { made && !line.is_empty() };
        let left = line.split_once(SEPARATOR).map(|(left, _)| left.trim_end());
        if !made && left != Some("") {
            inputs.extend([left.unwrap_or(line), "\n"]);
        }
    }
    inputs
}

fn is_mark(line: &str) -> bool {
    ["=== ", "== ", "-- "].iter().any(|mark| line.starts_with(mark))
}

/// Begins a line of what the case has to do, worked out by hand: below a mark, or below a row.
pub const WANTED: &str = "-> ";

/// A line that begins something, and the lines behind it.
pub struct Part<'t> {
    pub mark: &'t str,
    /// What is wanted of the case, in front of the other lines.
    pub wanted: Vec<&'t str>,
    pub lines: Vec<&'t str>,
}

impl<'t> Part<'t> {
    /// The lines up to the last one that is not blank; blank lines at the end are layout.
    pub fn content(&self) -> &[&'t str] {
        &self.lines[..self.lines.iter().rposition(|line| !line.is_empty()).map_or(0, |last| last + 1)]
    }

    fn text(&self) -> String {
        self.content().iter().flat_map(|line| [line, "\n"]).collect()
    }

    /// The characters that begin the mark, its word, and the rest of the line.
    fn words(&self) -> (&'t str, &'t str, &'t str) {
        let (kind, rest) = self.mark.split_once(' ').expect("a blank behind the mark");
        let (word, argument) = rest.split_once(' ').unwrap_or((rest, ""));
        (kind, word, argument)
    }

    fn heading(&self) -> &'t str {
        self.mark.split_once(' ').map_or("", |(_, heading)| heading)
    }
}

/// What stands between two headings.
pub struct Entry<'t> {
    pub parts: Vec<Part<'t>>,
    /// Position of the part with the program, and of that with the rows of a table.
    pub program: usize,
    pub rows: Option<usize>,
    /// None under the title of a chapter.
    pub cases: Vec<Case>,
}

fn entries(text: &str) -> Vec<Entry<'_>> {
    let mut entries: Vec<Entry<'_>> = Vec::new();
    for line in text.lines() {
        if line.starts_with('=') && is_mark(line) {
            entries.push(Entry { parts: Vec::new(), program: 0, rows: None, cases: Vec::new() });
        }
        let entry = entries.last_mut().expect("a book begins with `=== ` and its title");
        match entry.parts.last_mut() {
            Some(part) if part.lines.is_empty() && line.starts_with(WANTED) => part.wanted.push(line),
            Some(part) if !is_mark(line) => part.lines.push(line),
            _ => entry.parts.push(Part { mark: line, wanted: Vec::new(), lines: Vec::new() }),
        }
    }
    entries
}

/// What stands between `== ` and the next one.
#[derive(Default)]
struct Draft {
    heading: String,
    config: String,
    extension: Option<String>,
    program: Vec<u8>,
    called: BTreeMap<String, Vec<u8>>,
    wanted: Vec<String>,
    rows: Option<Vec<Row>>,
}

/// `value`, or `name = value`, and what stands behind it.
struct Row {
    name: String,
    value: String,
    comments: Vec<String>,
    wanted: Vec<String>,
}

/// The entries of a book with their cases. `config` gives the text of a named configuration.
pub fn book<'t>(book: &str, inputs: &'t str, config: &dyn Fn(&str) -> String) -> Vec<Entry<'t>> {
    let mut entries = entries(inputs);
    let mut chapter = "";
    // Programs that all cases of the chapter may call.
    let mut shared: BTreeMap<String, Vec<u8>> = BTreeMap::new();
    for entry in &mut entries {
        let mut draft = Draft::default();
        for (at, part) in entry.parts.iter().enumerate() {
            let text = part.text();
            draft.wanted.extend(part.wanted.iter().map(|line| line[WANTED.len()..].to_owned()));
            let program = match part.words() {
                ("===", ..) => {
                    chapter = part.heading();
                    shared.clear();
                    None
                }
                ("==", ..) => {
                    part.heading().clone_into(&mut draft.heading);
                    Some(text.into_bytes())
                }
                (_, "called", name) => {
                    let called = if draft.heading.is_empty() { &mut shared } else { &mut draft.called };
                    called.insert(name.to_owned(), text.into_bytes());
                    None
                }
                (_, "config", "") => {
                    draft.config = text;
                    None
                }
                (_, "config", name) => {
                    draft.config = config(name);
                    Some(text.into_bytes())
                }
                (_, "extension", extension) => {
                    draft.extension = Some(extension.to_owned());
                    Some(text.into_bytes())
                }
                (_, "program", _) => Some(text.into_bytes()),
                (_, "escaped", _) => Some(unescaped(&text)),
                (_, "rows", _) => {
                    draft.rows = Some(rows(&text));
                    entry.rows = Some(at);
                    None
                }
                _ => panic!("{book}: `{}` has no meaning here", part.mark),
            };
            if let Some(program) = program {
                (draft.program, entry.program) = (program, at);
            }
        }
        if !draft.heading.is_empty() {
            entry.cases = draft.cases(book, chapter, &shared);
        }
    }
    entries
}

impl Draft {
    fn cases(self, book: &str, chapter: &str, shared: &BTreeMap<String, Vec<u8>>) -> Vec<Case> {
        let Some(rows) = &self.rows else {
            return vec![self.case(book, chapter, shared, &self.heading, self.program.clone())];
        };
        let template = std::str::from_utf8(&self.program).expect("a template is text");
        let of_row = |row: &Row| {
            let heading = self.heading.replace("{}", &row.name);
            let comments: String = row.comments.iter().flat_map(|line| [line, "\n"]).collect();
            let program = template.replace("{comments}\n", &comments).replace("{}", &row.value);
            let program = program.replace("{NAME}", &slug(&heading).to_uppercase());
            let mut case = self.case(book, chapter, shared, &heading, program.into_bytes());
            let written =
                if row.name == row.value { row.name.clone() } else { format!("{} = {}", row.name, row.value) };
            case.table = Some((self.heading.clone(), written));
            case.wanted.extend(row.wanted.iter().cloned());
            case
        };
        rows.iter().map(of_row).collect()
    }

    fn case(
        &self,
        book: &str,
        chapter: &str,
        shared: &BTreeMap<String, Vec<u8>>,
        heading: &str,
        program: Vec<u8>,
    ) -> Case {
        let folders: Vec<&str> = book.split('/').collect();
        let (dialect, stem) = match folders[0] {
            // A chapter for each code.
            "errors" => {
                let code = chapter.split(' ').next().unwrap_or_default();
                (folders[1].to_owned(), format!("{code}_{}", slug(heading)))
            }
            "targets" => (folders[1].to_owned(), format!("{}_{}", slug(chapter), slug(heading))),
            // A chapter for each part, a case for each dialect.
            "same_part" => (slug(heading).replace('_', "-"), format!("{}_in_{}", slug(chapter), slug(heading))),
            folder => (folder.to_owned(), slug(heading)),
        };
        let extension = self.extension.as_deref().unwrap_or(match &dialect[..] {
            "klartext" => "H",
            "sinumerik" => "MPF",
            "mtc200" => "npg",
            "gcode" => "ngc",
            _ => "nc",
        });
        let mut called = shared.clone();
        called.extend(self.called.clone());
        Case {
            name: format!("{}/{stem}", folders[..2].join("/")),
            book: book.to_owned(),
            chapter: chapter.to_owned(),
            heading: heading.to_owned(),
            table: None,
            dialect,
            file: format!("{stem}.{extension}"),
            program,
            config: self.config.clone(),
            called,
            wanted: self.wanted.clone(),
        }
    }
}

/// The heading as a name of a file: its words and numbers in small letters.
fn slug(heading: &str) -> String {
    let words = heading.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_ascii_lowercase).collect::<Vec<_>>().join("_")
}

/// Whether a line among the rows is a comment of the row above.
pub fn is_comment(line: &str) -> bool {
    line.starts_with([';', '['])
}

fn rows(body: &str) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for line in body.lines() {
        match (rows.last_mut(), line.strip_prefix(WANTED)) {
            (Some(row), Some(wanted)) => row.wanted.push(wanted.to_owned()),
            (Some(row), _) if is_comment(line) => {
                assert!(row.wanted.is_empty(), "comments stand in front of what is wanted: {line}");
                row.comments.push(line.to_owned());
            }
            _ => {
                let (name, value) = line.split_once(" = ").unwrap_or((line, line));
                rows.push(Row {
                    name: name.to_owned(),
                    value: value.to_owned(),
                    comments: Vec::new(),
                    wanted: Vec::new(),
                });
            }
        }
    }
    rows
}

/// Bytes of an escaped program: `\r`, `\t`, `\xHH`, `\\`, and `\c` in front of a line end that is none.
fn unescaped(body: &str) -> Vec<u8> {
    let (mut bytes, mut rest) = (Vec::new(), body);
    while let Some((plain, escape)) = rest.split_once('\\') {
        bytes.extend_from_slice(plain.as_bytes());
        let (letter, behind) = escape.split_at_checked(1).expect("a letter behind the backslash");
        rest = behind;
        match letter {
            "r" => bytes.push(b'\r'),
            "t" => bytes.push(b'\t'),
            "\\" => bytes.push(b'\\'),
            "c" => rest = behind.strip_prefix('\n').expect("`\\c` ends its line"),
            "x" => {
                let (digits, behind) = behind.split_at_checked(2).expect("two digits behind `\\x`");
                bytes.push(u8::from_str_radix(digits, 16).expect("two hexadecimal digits"));
                rest = behind;
            }
            _ => panic!("`\\{letter}` has no meaning"),
        }
    }
    bytes.extend_from_slice(rest.as_bytes());
    bytes
}
