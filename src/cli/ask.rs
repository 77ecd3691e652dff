//! `partc init -i`: asks for the values one by one, and counts after each what compiles.

use std::collections::BTreeSet;
use std::io::{self, BufRead, Write};

use super::Trouble;
use super::answers::{NeedKey, Needs, Question};

/// What the conversation needs to know of the programs.
pub(super) trait Shop {
    /// Do the values go together? What is wrong with them, if not.
    fn refuses(&self, given: &Needs) -> Option<Trouble>;
    /// Does this program compile with nothing but what is given?
    fn compiles(&self, program: &str, given: &Needs) -> bool;
}

/// What the user says to a question.
enum Said {
    Value(String),
    Open,
    Enough,
}

/// Asks for all of `needs`, what most programs wait for first, and writes what is said into it.
///
/// # Errors
/// What standard input and output report.
pub(super) fn ask(
    needs: &mut Needs,
    mut compiling: BTreeSet<String>,
    count: u32,
    shop: &dyn Shop,
    input: &mut dyn BufRead,
    out: &mut dyn Write,
) -> io::Result<()> {
    let keys = needs.open();
    writeln!(out, "{} of {count} programs compile as they are; {} values are asked for.", compiling.len(), keys.len())?;
    writeln!(
        out,
        "Enter takes the value in brackets or leaves the question open, `-` leaves it open, `q` ends the questions."
    )?;
    for (at, key) in keys.iter().enumerate() {
        let question = needs.question(key);
        writeln!(out, "\n{} ({} of {})\n  {}", question.key, at + 1, keys.len(), question.places)?;
        for line in &question.about {
            writeln!(out, "  {line}")?;
        }
        match value(needs, key, &question, shop, input, out)? {
            Said::Enough => break,
            Said::Open => continue,
            Said::Value(value) => needs.give(key, value),
        }
        let given = needs.only_given();
        compiling.extend(needs.programs(key).iter().filter(|program| shop.compiles(program, &given)).cloned());
        writeln!(out, "  {} of {count} programs compile", compiling.len())?;
    }
    Ok(())
}

/// One answer; asked again while it is no value of the key.
fn value(
    needs: &Needs,
    key: &NeedKey,
    question: &Question,
    shop: &dyn Shop,
    input: &mut dyn BufRead,
    out: &mut dyn Write,
) -> io::Result<Said> {
    loop {
        let offered = question.offered.as_deref().map_or_else(String::new, |offered| format!(" [{offered}]"));
        write!(out, "  {}{offered}: ", question.name)?;
        out.flush()?;
        let mut line = String::new();
        if input.read_line(&mut line)? == 0 {
            return Ok(Said::Enough);
        }
        let value = match (line.trim(), &question.offered) {
            ("q", _) => return Ok(Said::Enough),
            ("-", _) | ("", None) => return Ok(Said::Open),
            ("", Some(offered)) => offered.clone(),
            (said, _) => question.as_toml(said),
        };
        let mut tried = needs.clone();
        tried.give(key, value.clone());
        match shop.refuses(&tried.only_given()) {
            None => return Ok(Said::Value(value)),
            Some(trouble) => writeln!(out, "  {trouble}")?,
        }
    }
}
