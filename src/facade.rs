//! Compile, check and trace a program that is held in memory, one call each. What streams or draws uses
//! [`Session`](crate::Session).

use std::fmt;
use std::io;

use crate::diag::Finding;
use crate::dialect::{self, Dialect};
use crate::driver::{Failure, Session};
use crate::emit::stats::Model;
use crate::machine::Settings;
use crate::machine::keys::choices;
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
    /// A program in the language that its text and the extension of `name` show. Where they show another language, one finding
    /// says which.
    ///
    /// # Errors
    /// [`Trouble::Language`] where they show none, or several.
    pub fn new(name: &'a str, text: &'a [u8]) -> Result<Program<'a>, Trouble> {
        let head = &text[..text.len().min(HEAD)];
        let dialect = dialect::read_as(name, head).ok_or_else(|| Trouble::Language(name.to_owned()))?;
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
    session.trace(program.dialect, settings, files, Model::default(), &mut out).map_err(Trouble::Output)?;
    Ok(outcome(session, out))
}

/// The resolved moves of a program as record batches of [`table::schema`](crate::table::schema), in order.
///
/// Each goes to `take`, which says whether it wants more. Batches come before the findings are known: with an error among
/// these none of them must be used.
#[cfg(feature = "arrow")]
pub fn trace_batches(
    program: &Program<'_>,
    settings: &Settings,
    files: &dyn Files,
    options: crate::table::Options,
    take: &mut crate::table::Take<'_>,
) -> Vec<Finding> {
    let session = program.session();
    session.trace_batches(program.dialect, settings, files, options, take);
    findings(session)
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

/// What was found, in the order of the places.
pub fn findings(session: Session) -> Vec<Finding> {
    let Session { sources, diags, trail } = session;
    diags.into_sorted().iter().map(|found| Finding::new(found, &sources, &trail, choices)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::config::from_toml;
    use crate::text::files::NoFiles;

    fn lines(program: &str, configuration: &str) -> Vec<String> {
        let settings = from_toml(configuration, "partc.toml").expect("a configuration");
        let program = Program::new("dir/A.H", program.as_bytes()).expect("a language");
        let outcome = compile(&program, &settings, &NoFiles).expect("an output");
        let text = outcome.text.unwrap_or_else(|| panic!("{:?}", outcome.findings));
        text.lines().map(str::to_owned).collect()
    }

    #[test]
    fn comments_of_the_configuration_have_their_fields_filled_in() {
        let program = "0 BEGIN PGM A MM\n1 L X+10 R0 F200\n2 END PGM A MM\n";
        for (units, word) in [("mm", "mm"), ("inch", "inch")] {
            let output = format!(
                "[output]\nunits = \"{units}\"\nprogram_number = 12\n\
                 header = [\"{{source}} {{target}} {{number}} {{units}}\"]\nfooter = [\"made by {{version}}\"]\n"
            );
            let lines = lines(program, &output);
            assert!(lines.contains(&format!("(A.H linuxcnc 12 {word})")), "{lines:?}");
            assert!(lines.contains(&concat!("(made by ", env!("CARGO_PKG_VERSION"), ")").to_owned()), "{lines:?}");
        }
    }

    #[test]
    fn coolant_stops_where_the_end_of_the_text_is_the_end_of_the_program() {
        let output = "[output]\ntarget = \"marlin\"\npass_m = [8, 9]\nrapid_feed = 3000\n";
        let coolant = |program: &str| {
            let lines = lines(program, output);
            lines.into_iter().filter(|line| ["M8", "M9"].contains(&line.as_str())).collect::<Vec<_>>()
        };
        let begin = "0 BEGIN PGM A MM\n1 L X+0 Y+0 R0 FMAX M8\n2 L IX+10 F200\n";
        assert_eq!(coolant(&format!("{begin}3 M30\n4 END PGM A MM\n")), ["M8", "M9"]);
        assert_eq!(coolant(&format!("{begin}3 M9\n4 L IX+1\n5 M30\n6 END PGM A MM\n")), ["M8", "M9"]);
    }
}
