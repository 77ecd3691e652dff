//! Compile, check and trace a program that is held in memory, one call each. What streams or draws uses
//! [`Session`](crate::Session).

use std::fmt;
use std::io;

use crate::diag::Finding;
use crate::dialect::{self, Dialect};
use crate::driver::{Failure, Session};
use crate::machine::Settings;
use crate::text::{Files, Memory, Opened};
use crate::validate::Mismatch;

/// A part program with its name; the name decides, beside the text, which language it is in.
#[derive(Debug, Clone, Copy)]
pub struct Program<'a> {
    name: &'a str,
    text: &'a [u8],
    dialect: &'static Dialect,
}

/// Bytes looked at to tell the language.
const HEAD: usize = 64 * 1024;

impl<'a> Program<'a> {
    /// A program in the language that its text and the extension of `name` show.
    ///
    /// # Errors
    /// [`Trouble::Language`] where they show none, or several.
    pub fn new(name: &'a str, text: &'a [u8]) -> Result<Program<'a>, Trouble> {
        let head = &text[..text.len().min(HEAD)];
        let dialect = dialect::guess(name, head).ok_or_else(|| Trouble::Language(name.to_owned()))?;
        Ok(Program { name, text, dialect })
    }

    /// A program in the language `id`: `klartext`, `sinumerik`, `heidenhain-turning` or `mtc200`.
    ///
    /// # Errors
    /// [`Trouble::Language`] where no language has this name.
    pub fn in_language(id: &str, name: &'a str, text: &'a [u8]) -> Result<Program<'a>, Trouble> {
        let dialect = dialect::find(id).ok_or_else(|| Trouble::Language(id.to_owned()))?;
        Ok(Program { name, text, dialect })
    }

    fn session(&self) -> Session {
        let text = Box::new(Memory::new(self.text));
        Session::new(Opened { name: self.name.to_owned(), identity: self.name.to_owned(), text })
    }
}

/// What hinders a run before its first block; what is wrong with a program is a [`Finding`].
#[derive(Debug)]
pub enum Trouble {
    /// The language of the program is not known.
    Language(String),
    /// The output failed.
    Output(io::Error),
    /// What was printed, read back, is not what the program says: partc is at fault, and there is no output.
    Mismatch(Box<Mismatch>),
}

impl fmt::Display for Trouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Trouble::Language(name) => write!(f, "which language is `{name}`?"),
            Trouble::Output(error) => error.fmt(f),
            Trouble::Mismatch(mismatch) => mismatch.fmt(f),
        }
    }
}

impl std::error::Error for Trouble {}

impl From<Failure> for Trouble {
    fn from(failure: Failure) -> Trouble {
        match failure {
            Failure::Output(error) => Trouble::Output(error),
            Failure::Mismatch(mismatch) => Trouble::Mismatch(mismatch),
        }
    }
}

/// What [`compile`] and [`trace`] give.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Outcome {
    /// The text for the target, or the moves as JSON Lines; `None` with an error among the findings.
    pub text: Option<String>,
    /// In the order of their places.
    pub findings: Vec<Finding>,
}

/// Compiles a program for the target of the settings.
///
/// # Errors
/// An unknown target; findings are no errors.
pub fn compile(program: &Program<'_>, settings: &Settings, files: &dyn Files) -> Result<Outcome, Trouble> {
    let session = program.session();
    let mut out = Vec::new();
    session.compile(program.dialect, settings, files, &mut out, None)?;
    Ok(outcome(session, out))
}

/// The resolved moves of a program as JSON Lines.
///
/// # Errors
/// None today; findings are no errors.
pub fn trace(program: &Program<'_>, settings: &Settings, files: &dyn Files) -> Result<Outcome, Trouble> {
    let session = program.session();
    let mut out = Vec::new();
    session.trace(program.dialect, settings, files, &mut out).map_err(Trouble::Output)?;
    Ok(outcome(session, out))
}

/// Everything there is to say of a program, also of blocks that never run.
pub fn check(program: &Program<'_>, settings: &Settings, files: &dyn Files) -> Vec<Finding> {
    let session = program.session();
    session.check(program.dialect, settings, files);
    findings(session)
}

fn outcome(session: Session, out: Vec<u8>) -> Outcome {
    let text = if session.diags.has_errors() { None } else { String::from_utf8(out).ok() };
    Outcome { text, findings: findings(session) }
}

fn findings(session: Session) -> Vec<Finding> {
    let Session { sources, diags, trail } = session;
    diags.into_sorted().iter().map(|found| Finding::new(found, &sources, &trail)).collect()
}
