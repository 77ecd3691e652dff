//! The cases of the golden books under `tests/golden`. `tests/golden/README.md` describes the format.

pub mod read;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use partc::internals::machine::Settings;
use partc::internals::text::{FileError, Files, Memory, Opened, Request, Within};

use super::common::{Compiled, compile_bytes, compile_checked, settings};

/// A case: a program, the programs that it calls, and its configuration.
#[derive(Debug, Default, Clone)]
pub struct Case {
    /// Folder below `tests/golden`, and the behaviour: `sinumerik/drilling/cycle83_amount`, in whichever book of
    /// the folder it stands.
    pub name: String,
    /// Path of the book below `tests/golden`, without its extension.
    pub book: String,
    /// Title of the chapter; the first word is the code in books of diagnostic codes.
    pub chapter: String,
    pub heading: String,
    /// The heading of the table, and the row: its value, or name and value.
    pub table: Option<(String, String)>,
    pub dialect: String,
    /// Name of the program's file.
    pub file: String,
    pub program: Vec<u8>,
    /// The text of a `partc.toml`; empty where there is none.
    pub config: String,
    /// Called programs, by name.
    pub called: BTreeMap<String, Vec<u8>>,
    /// What the program has to do, worked out by hand (`tests/suite/wanted.rs`).
    pub wanted: Vec<String>,
}

impl Case {
    /// The program, if it is UTF-8.
    pub fn text(&self) -> Option<&str> {
        std::str::from_utf8(&self.program).ok()
    }

    pub fn settings(&self) -> Settings {
        settings(&self.config)
    }

    pub fn compile(&self) -> Compiled {
        // What rules find, and what is said of suppressions, is found by a check.
        let code = self.chapter.split(' ').next().unwrap_or_default();
        if self.name.starts_with("errors/") && (code.starts_with('L') || code.starts_with("P80")) {
            return compile_checked(&self.file, &self.program, &self.dialect, &self.settings(), self);
        }
        compile_bytes(&self.file, self.program.clone(), &self.dialect, &self.settings(), self)
    }

    /// Compiles another program in place of this one.
    pub fn compile_instead(&self, program: &str) -> Compiled {
        compile_bytes(&self.file, program.as_bytes().to_vec(), &self.dialect, &self.settings(), self)
    }

    /// Name of the program without its extension.
    pub fn stem(&self) -> &str {
        self.file.rsplit_once('.').map_or(&self.file, |(stem, _)| stem)
    }
}

/// The folders of a backup that stand beside that of the main program, and those of the control that they are.
const BESIDE: [(&str, &str); 3] =
    [("../SPF.DIR", "/_N_SPF_DIR"), ("../CMA.DIR", "/_N_CMA_DIR"), ("../DEF.DIR", "/_N_DEF_DIR")];

/// The folder of the control that a folder of a case is.
fn control_folder(of_case: &str) -> &str {
    BESIDE.iter().find(|(copy, _)| *copy == of_case).map_or(of_case, |(_, control)| control)
}

/// Programs that are called lie in one place, whatever folder is asked for; where one of them has a path of the control,
/// `/_N_SPF_DIR/X.SPF` or `../SPF.DIR/X.SPF`, each lies in its own folder, and those without a path beside the main program.
impl Files for Case {
    fn open(&self, request: &Request<'_>) -> Result<Opened, FileError> {
        let placed = self.called.keys().any(|name| name.starts_with('/') || name.starts_with("../"));
        let (folder, last) = request.name.rsplit_once(['/', '\\']).unwrap_or(("", request.name));
        let extended = request.extensions.iter().map(|extension| format!("{last}.{extension}"));
        let names: Vec<String> = std::iter::once(last.to_owned()).chain(extended).collect();
        let is_there = |key: &&String| match (placed, key.rsplit_once('/')) {
            (false, _) => true,
            (true, None) => folder.is_empty(),
            (true, Some((of_key, _))) => {
                control_folder(of_key) == folder || folder.is_empty() && request.within == Within::Anywhere
            }
        };
        for name in &names {
            let fits = |key: &&String| key.rsplit('/').next() == Some(name.as_str());
            if let Some((key, bytes)) = self.called.iter().find(|(key, _)| is_there(key) && fits(key)) {
                let text = Box::new(Memory::new(bytes.clone()));
                return Ok(Opened { name: key.clone(), identity: key.clone(), text });
            }
        }
        let knows = |key: &String| key.rsplit_once('/').is_some_and(|(of_key, _)| control_folder(of_key) == folder);
        if placed && folder.starts_with('/') && !self.called.keys().any(knows) {
            return Err(FileError::NoRoot { prefix: folder.to_owned() });
        }
        Err(FileError::NotFound { tried: vec![last.to_owned()], similar: Vec::new() })
    }

    fn copy_of(&self, folder: &str) -> Option<(String, &'static str)> {
        let (copy, control) = BESIDE.iter().find(|(_, control)| *control == folder)?;
        let holds = |key: &String| key.rsplit_once('/').is_some_and(|(of_key, _)| of_key == *copy);
        self.called.keys().any(holds).then(|| ((*copy).to_owned(), *control))
    }
}

pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden")
}

/// All files of a kind below `tests/golden`, as paths below it without the extension.
pub fn files(extension: &str) -> Vec<String> {
    let root = root();
    let (mut folders, mut found) = (vec![root.clone()], Vec::new());
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a readable folder") {
            let path = entry.expect("a readable entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|found| found == extension) {
                let inside = path.strip_prefix(&root).expect("below the root").with_extension("");
                found.push(
                    inside.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/"),
                );
            }
        }
    }
    found.sort();
    found
}

/// Paths of all books below `tests/golden`, without the extension.
pub fn names() -> Vec<String> {
    files("snap")
}

/// What people wrote of a book.
pub fn inputs(book: &str) -> String {
    let text = fs::read_to_string(root().join(format!("{book}.snap"))).unwrap_or_else(|_| panic!("no book {book}"));
    read::inputs(&text)
}

/// The entries of a book.
pub fn entries<'t>(book: &str, inputs: &'t str) -> Vec<read::Entry<'t>> {
    let config = |name: &str| {
        fs::read_to_string(root().join(format!("configs/{name}.toml")))
            .unwrap_or_else(|_| panic!("no configuration {name}"))
    };
    read::book(book, inputs, &config)
}

/// All cases, those of one book together.
fn books() -> &'static [Case] {
    static ALL: OnceLock<Vec<Case>> = OnceLock::new();
    let cases = |book: &String| -> Vec<Case> {
        entries(book, &inputs(book)).into_iter().flat_map(|entry| entry.cases).collect()
    };
    ALL.get_or_init(|| names().iter().flat_map(cases).collect())
}

/// The cases of a book, in the order of the book.
pub fn of(book: &str) -> Vec<&'static Case> {
    books().iter().filter(|case| case.book == book).collect()
}

/// The cases below a folder, ordered by name. Those for other targets than the first stand alone: what reads outputs reads LinuxCNC's.
pub fn cases(under: &str) -> Vec<&'static Case> {
    let below = |name: &str, folder: &str| name.strip_prefix(folder).is_some_and(|rest| rest.starts_with('/'));
    let inside = |case: &&Case| match under {
        "" => !below(&case.name, "targets") && !case.config.contains("target = \""),
        folder => below(&case.name, folder),
    };
    let mut found: Vec<&Case> = books().iter().filter(inside).collect();
    found.sort_by_key(|case| (case.name.rsplit_once('/').map(|(folder, _)| folder), &case.file));
    found
}

/// The case of a name.
pub fn find(name: &str) -> Option<&'static Case> {
    books().iter().find(|case| case.name == name)
}
