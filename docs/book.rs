//! Writes what `mdbook build` makes the book of: the documents, and a page for each diagnostic code.
//!
//! `cargo run --example book -- FOLDER`

use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs, io};

use partc::internals::diag::codes::{self, Code};

/// Documents of the project that stand beside `docs`.
const BESIDE: &[&str] = &["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"];

/// What they link to and the book takes as it is.
const LICENCES: &[&str] = &["LICENSE-MIT", "LICENSE-APACHE"];

/// What the letter of a code says.
const LETTERS: &[(char, &str)] = &[
    ('P', "General"),
    ('K', "Klartext"),
    ('S', "SINUMERIK"),
    ('T', "HEIDENHAIN turning"),
    ('M', "MTC200"),
    ('G', "Geometry"),
    ('O', "Output"),
    ('L', "Lint"),
];

fn main() -> io::Result<()> {
    let folder = env::args().nth(1).ok_or_else(|| io::Error::other("the folder for the book is missing"))?;
    let (root, folder) = (Path::new(env!("CARGO_MANIFEST_DIR")), Path::new(&folder));
    let pages = folder.join("src");
    if pages.exists() {
        fs::remove_dir_all(&pages)?;
    }
    copied(&root.join("docs"), &pages)?;
    fs::rename(pages.join("book.toml"), folder.join("book.toml"))?;
    fs::remove_file(pages.join("book.rs"))?;
    for name in BESIDE {
        // From within the book the documents stand beside it.
        let text = fs::read_to_string(root.join(name))?.replace("](docs/", "](");
        fs::write(pages.join(name), text)?;
    }
    for name in LICENCES {
        fs::copy(root.join(name), pages.join(name))?;
    }
    let mut summary = fs::read_to_string(root.join("docs/SUMMARY.md"))?;
    fs::create_dir(pages.join("codes"))?;
    let all = codes::all();
    for (letter, title) in LETTERS {
        let of_letter: Vec<&Code> = all.iter().copied().filter(|code| code.id.starts_with(*letter)).collect();
        let _ = writeln!(summary, "- [{title}](codes/{letter}.md)");
        let mut list = format!("# {title}: findings\n\n| code | name | severity | |\n| --- | --- | --- | --- |\n");
        for code in of_letter {
            let severity = code.severity.word();
            let _ = writeln!(list, "| [{0}]({0}.md) | {1} | {severity} | {2} |", code.id, code.name, code.title);
            let _ = writeln!(summary, "  - [{}](codes/{}.md)", code.id, code.id);
            fs::write(pages.join(format!("codes/{}.md", code.id)), page(code))?;
        }
        fs::write(pages.join(format!("codes/{letter}.md")), list)?;
    }
    fs::write(pages.join("SUMMARY.md"), summary)
}

/// What `partc explain` says.
fn page(code: &Code) -> String {
    let mut text = format!("# {}: {}\n\n`{}`, {}", code.id, code.title, code.name, code.severity.word());
    if !code.on {
        text.push_str(", reported where it is selected");
    }
    let _ = write!(text, "\n\n{}\n", code.explain);
    if let Some(example) = code.example() {
        let _ = write!(text, "\n```text\n{}\n```\n", example.trim_end());
    }
    text
}

fn copied(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let (path, name) = entry.map(|entry| (entry.path(), entry.file_name()))?;
        if path.is_dir() {
            copied(&path, &to.join(name))?;
        } else {
            fs::copy(&path, to.join(name))?;
        }
    }
    Ok(())
}
