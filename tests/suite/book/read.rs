//! Reads the text of a golden book.

use std::collections::BTreeMap;

use super::Case;

/// A line that begins something, and the lines behind it.
struct Part<'t> {
    mark: &'t str,
    lines: Vec<&'t str>,
}

impl Part<'_> {
    /// The lines as a file; blank lines at the end are layout.
    fn text(&self) -> String {
        let end = self.lines.iter().rposition(|line| !line.is_empty()).map_or(0, |last| last + 1);
        self.lines[..end].iter().flat_map(|line| [line, "\n"]).collect()
    }
}

fn parts(text: &str) -> Vec<Part<'_>> {
    let mut parts: Vec<Part<'_>> = Vec::new();
    for line in text.lines() {
        if ["=== ", "== ", "-- "].iter().any(|mark| line.starts_with(mark)) {
            parts.push(Part { mark: line, lines: Vec::new() });
        } else if let Some(part) = parts.last_mut() {
            part.lines.push(line);
        } else {
            panic!("a book begins with `=== ` and its title");
        }
    }
    parts
}

/// What stands between `== ` and the next one.
#[derive(Default)]
struct Draft {
    heading: String,
    config: String,
    extension: Option<String>,
    program: Vec<u8>,
    called: BTreeMap<String, Vec<u8>>,
    /// Name, value and comments of each row.
    rows: Option<Vec<(String, String, Vec<String>)>>,
}

/// The cases of a book. `config` gives the text of a named configuration.
pub fn book(book: &str, text: &str, config: &dyn Fn(&str) -> String) -> Vec<Case> {
    let mut cases = Vec::new();
    let mut chapter = String::new();
    // Programs that all cases of the chapter may call.
    let mut shared: BTreeMap<String, Vec<u8>> = BTreeMap::new();
    let mut draft: Option<Draft> = None;
    for part in parts(text) {
        let body = part.text();
        let (mark, rest) = part.mark.split_once(' ').expect("a blank behind the mark");
        let (word, argument) = rest.split_once(' ').unwrap_or((rest, ""));
        match (mark, word, &mut draft) {
            ("===" | "==", ..) => {
                cases.extend(draft.take().into_iter().flat_map(|draft| draft.cases(book, &chapter, &shared)));
                if mark == "==" {
                    draft = Some(Draft { heading: rest.to_owned(), program: body.into_bytes(), ..Draft::default() });
                } else {
                    rest.clone_into(&mut chapter);
                    shared.clear();
                }
            }
            (_, "called", None) => drop(shared.insert(argument.to_owned(), body.into_bytes())),
            (_, "called", Some(case)) => drop(case.called.insert(argument.to_owned(), body.into_bytes())),
            (_, "config", Some(case)) if argument.is_empty() => case.config = body,
            (_, "config", Some(case)) => (case.config, case.program) = (config(argument), body.into_bytes()),
            (_, "extension", Some(case)) => {
                (case.extension, case.program) = (Some(argument.to_owned()), body.into_bytes());
            }
            (_, "program", Some(case)) => case.program = body.into_bytes(),
            (_, "escaped", Some(case)) => case.program = unescaped(&body),
            (_, "rows", Some(case)) => case.rows = Some(rows(&body)),
            _ => panic!("{book}: `{}` has no meaning here", part.mark),
        }
    }
    cases.extend(draft.into_iter().flat_map(|draft| draft.cases(book, &chapter, &shared)));
    cases
}

impl Draft {
    fn cases(self, book: &str, chapter: &str, shared: &BTreeMap<String, Vec<u8>>) -> Vec<Case> {
        let Some(rows) = &self.rows else {
            return vec![self.case(book, chapter, shared, &self.heading, self.program.clone())];
        };
        let template = std::str::from_utf8(&self.program).expect("a template is text");
        let of_row = |(name, value, comments): &(String, String, Vec<String>)| {
            let heading = self.heading.replace("{}", name);
            let comments_text: String = comments.iter().flat_map(|line| [line, "\n"]).collect();
            let program = template.replace("{comments}\n", &comments_text).replace("{}", value);
            let program = program.replace("{NAME}", &slug(&heading).to_uppercase());
            let mut case = self.case(book, chapter, shared, &heading, program.into_bytes());
            let row = if name == value { name.clone() } else { format!("{name} = {value}") };
            case.table = Some((self.heading.clone(), row));
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
        }
    }
}

/// The heading as a name of a file: its words and numbers in small letters.
fn slug(heading: &str) -> String {
    let words = heading.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_ascii_lowercase).collect::<Vec<_>>().join("_")
}

/// `value`, or `name = value`, each with comments behind it.
fn rows(body: &str) -> Vec<(String, String, Vec<String>)> {
    let mut rows: Vec<(String, String, Vec<String>)> = Vec::new();
    for line in body.lines() {
        match rows.last_mut() {
            Some((.., comments)) if line.starts_with([';', '[']) => comments.push(line.to_owned()),
            _ => {
                let (name, value) = line.split_once(" = ").unwrap_or((line, line));
                rows.push((name.to_owned(), value.to_owned(), Vec::new()));
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
