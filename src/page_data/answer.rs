//! What a page asks for: one request, one answer, both as bytes.
//!
//! A request is the length of its JSON (four bytes, the low one first), the JSON, and the files it names, behind each other:
//!
//! ```json
//! {"what": "make", "dialect": "auto", "target": "grbl", "config": "", "files": [["PART.H", 1200], ["SUB.H", 80]]}
//! ```
//!
//! The first file is the program, the others are those that it may call. `make` and `check` answer with [`made`] and
//! [`checked`], `about` with the names of targets and languages; what hinders a run is `{"trouble": "…"}`.

use serde::Deserialize;
use serde_json::json;

use crate::dialect::{ALL as DIALECTS, Dialect, find, read_as};
use crate::driver::Session;
use crate::machine::Settings;
use crate::machine::config::from_toml;
use crate::machine::tree::ConfigError;
use crate::target;
use crate::text::{Folder, Memory, Opened};

use super::{checked, made};

/// Bytes looked at to tell the language.
const HEAD: usize = 64 * 1024;

#[derive(Debug, Deserialize)]
struct Asked {
    what: String,
    #[serde(default)]
    dialect: String,
    #[serde(default)]
    target: String,
    #[serde(default)]
    config: String,
    #[serde(default)]
    files: Vec<(String, usize)>,
}

/// The answer to a request.
pub fn answer(request: &[u8]) -> Vec<u8> {
    tried(request).unwrap_or_else(|trouble| json!({ "trouble": trouble }).to_string().into_bytes())
}

fn tried(request: &[u8]) -> Result<Vec<u8>, String> {
    let short = || "the request is cut off".to_owned();
    let (length, rest) = request.split_first_chunk::<4>().ok_or_else(short)?;
    let length = u32::from_le_bytes(*length) as usize;
    let (asked, mut rest) = rest.split_at_checked(length).ok_or_else(short)?;
    let asked: Asked = serde_json::from_slice(asked).map_err(|error| error.to_string())?;
    if asked.what == "about" {
        return Ok(about());
    }
    let (mut folder, mut main) = (Folder::default(), None);
    for (name, length) in &asked.files {
        let (bytes, behind) = rest.split_at_checked(*length).ok_or_else(short)?;
        main.get_or_insert((name.as_str(), bytes));
        folder.add(name, bytes);
        rest = behind;
    }
    let (name, program) = main.ok_or_else(short)?;
    let settings = settings(&asked)?;
    let dialect = language(&asked.dialect, name, program)?;
    let text = Box::new(Memory::new(program));
    let session = Session::new(Opened { name: name.to_owned(), identity: name.to_owned(), text });
    match asked.what.as_str() {
        "make" => made(&session, dialect, &settings, &folder).map_err(|failure| failure.to_string()),
        "check" => Ok(checked(&session, dialect, &settings, &folder)),
        what => Err(format!("nobody knows how to {what}")),
    }
}

fn settings(asked: &Asked) -> Result<Settings, String> {
    let all = |errors: Vec<ConfigError>| errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n");
    let mut settings = from_toml(&asked.config, "partc.toml").map_err(all)?;
    if !asked.target.is_empty() {
        let target = target::find(&asked.target);
        settings.output.target = target.ok_or_else(|| format!("no target `{}`", asked.target))?;
    }
    Ok(settings)
}

fn language(said: &str, name: &str, program: &[u8]) -> Result<&'static Dialect, String> {
    if said.is_empty() || said == "auto" {
        let head = &program[..program.len().min(HEAD)];
        return read_as(name, head).ok_or_else(|| "which language is this? Choose it above".to_owned());
    }
    find(said).ok_or_else(|| format!("no language `{said}`"))
}

fn about() -> Vec<u8> {
    let targets: Vec<&str> = target::NAMES.to_vec();
    let dialects: Vec<&str> = DIALECTS.iter().map(|dialect| dialect.id).collect();
    json!({ "version": env!("CARGO_PKG_VERSION"), "targets": targets, "dialects": dialects }).to_string().into_bytes()
}
