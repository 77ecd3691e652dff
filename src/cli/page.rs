//! `partc report`: one page with what came of a program.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::driver::{Failure, Session};
use crate::page_data;
use crate::text::{FileId, Memory, Opened, Span};

use super::answers::{Needs, requests};
use super::args::Page;
use super::closure::Targets;
use super::disk::file_name;
use super::inputs::Input;
use super::made::{Made, Replaces, is_foreign};
use super::need::Form;
use super::output::{Destination, ignore_closed_pipe};
use super::paths::{real, same_file};
use super::program::{LARGEST_TRIED, Loaded, load};
use super::progress::Ticker;
use super::report::{Reporter, Stdout};
use super::trial::requests_of;
use super::{Exit, Trouble};

/// The page that `web/build.mjs` makes, with a place for the result.
const PAGE: &str = include_str!("../../web/dist/report.html");
const RESULT: &str = "@@RESULT@@";

/// Writes the page of one program. That of a program with errors shows the path up to the first one; neither it nor one with
/// findings that `--fail-on` does not let pass has code.
pub(super) fn report(args: &Page) -> Result<Exit, Trouble> {
    let target = target(args);
    let shown = target.display().to_string();
    let trouble = |error: io::Error| format!("{shown}: {error}");
    if same_file(&args.input, &target) {
        return Err(format!("{shown}: the report would replace the program"));
    }
    let is_page = |extension: &OsStr| ["html", "htm"].iter().any(|known| extension.eq_ignore_ascii_case(known));
    if target.extension().is_some_and(|extension| !is_page(extension)) {
        return Err(format!("{shown}: a report is .html or .htm; name another file"));
    }
    if is_foreign(&target, Made::Report) && !args.force {
        return Err(format!("{shown}: not written by partc; use --force to replace it, or another name"));
    }
    let Loaded { session, dialect, settings, files, place } = load(&args.input, &args.common)?;
    let stdout = if target == Path::new("-") { Stdout::Taken } else { Stdout::Free };
    let mut reporter = Reporter::new(&args.common, &args.findings, stdout, None);
    reporter.spares(&[Input::named(&args.input)], &BTreeSet::from([real(&target)]))?;
    args.deps.spares(&[&args.input], &BTreeSet::from([real(&target)]), &reporter)?;
    let targets = Targets::new([target.as_path()].into_iter().chain(reporter.files()).chain(args.deps.file()));
    let mut out = Destination::open_for(&target, Replaces::by(Made::Report, args.force)).map_err(trouble)?;
    let ticker = Ticker::start(true, &place);
    let made = page_data::made_unless(&session, dialect, &settings, &files, &|session| reporter.look().fails(session));
    // Standard input is read once.
    let size = u32::try_from(session.sources.size(FileId(0))).unwrap_or(u32::MAX);
    let source = session.sources.bytes(FileId(0), Span { start: 0, end: size });
    let (name, identity) = (session.sources.name(FileId(0)), session.sources.identity(FileId(0)));
    let again = Session::new(Opened { name, identity, text: Box::new(Memory::new(source.as_slice())) });
    let checked = page_data::checked(&again, dialect, &settings, &files);
    let paste = to_paste(&again, args);
    drop(ticker);
    targets.spare(&args.input, &args.common, &files)?;
    match made {
        Ok(made) => {
            write(&mut out, &[("source", &source), ("made", &made), ("checked", &checked), ("paste", paste.as_bytes())])
                .and_then(|()| out.commit())
                .or_else(ignore_closed_pipe)
                .map_err(trouble)?
        }
        Err(Failure::Output(error)) => return Err(trouble(error)),
        Err(failure @ Failure::Mismatch(_)) => {
            reporter.say(&format!("partc: internal error: {}: {failure}", args.input.display()));
            reporter.internal();
        }
    }
    let rule = args.deps.rule(&args.input, &args.common, &files, &[&target])?;
    reporter.session(session);
    let exit = reporter.finish()?;
    args.deps.write(rule.into_iter().collect(), exit)
}

/// Lines of `partc.toml` that would answer errors.
fn to_paste(session: &Session, args: &Page) -> String {
    let mut asked = requests(session, &|_| None);
    // A program goes on as far as it can, so that all keys show that it needs; standard input is read once.
    if !asked.is_empty()
        && args.input != Path::new("-")
        && session.sources.size(FileId(0)) <= LARGEST_TRIED
        && let Ok(all) = requests_of(&args.input, &args.common)
    {
        asked = all;
    }
    // The folder a program lies in is of no interest to who gets the page.
    for request in &mut asked {
        let file = &mut request.place.file;
        *file = file.rsplit(['/', '\\']).next().unwrap_or(file).to_owned();
    }
    let mut needs = Needs::default();
    needs.take("", &asked);
    if needs.is_empty() {
        return String::new();
    }
    needs.toml(Form::Lines, &BTreeSet::new(), &|_, _| Vec::new())
}

fn target(args: &Page) -> PathBuf {
    match (&args.output, &args.common.stdin_filename) {
        (Some(output), _) => output.clone(),
        (None, Some(name)) if args.input == Path::new("-") => PathBuf::from(file_name(name)).with_extension("html"),
        (None, _) if args.input == Path::new("-") => PathBuf::from("-"),
        (None, _) => args.input.with_extension("html"),
    }
}

/// The page with its parts, each in an element of its own that no browser runs.
fn write(out: &mut dyn Write, parts: &[(&str, &[u8])]) -> io::Result<()> {
    let (front, back) = PAGE.split_once(RESULT).unwrap_or((PAGE, ""));
    out.write_all(front.as_bytes())?;
    for (name, bytes) in parts {
        writeln!(out, "<script type=\"text/plain\" id=\"{name}\">")?;
        base64(out, bytes)?;
        writeln!(out, "</script>")?;
    }
    out.write_all(back.as_bytes())
}

/// Writes bytes as letters (RFC 4648), in one line.
fn base64(out: &mut dyn Write, bytes: &[u8]) -> io::Result<()> {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let letter = |bits: u32| LETTERS.get((bits & 63) as usize).copied().unwrap_or(b'=');
    let mut line = Vec::with_capacity(4 * 4096);
    for part in bytes.chunks(3 * 4096) {
        for three in part.chunks(3) {
            let at = |i: usize| u32::from(three.get(i).copied().unwrap_or(0));
            let bits = at(0) << 16 | at(1) << 8 | at(2);
            line.extend([18, 12, 6, 0].map(|shift| letter(bits >> shift)));
            let missing = 3 - three.len();
            let end = line.len();
            line[end - missing..].fill(b'=');
        }
        out.write_all(&line)?;
        line.clear();
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::made::REPORT_MARK;
    use super::*;

    #[test]
    fn letters_of_bytes() {
        for (bytes, letters) in [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")] {
            let mut out = Vec::new();
            base64(&mut out, bytes.as_bytes()).expect("memory takes everything");
            assert_eq!(String::from_utf8(out).expect("letters"), letters);
        }
    }

    #[test]
    fn the_page_has_one_place_for_the_result() {
        assert!(PAGE.starts_with(REPORT_MARK) && PAGE.matches(RESULT).count() == 1);
        assert!(PAGE.contains("connect-src 'none'") && !PAGE.contains("http-equiv=\"refresh\""));
    }
}
