//! What is to be reported where the output is not what the program says: one file with all that shows it again.

use std::fs::File;
use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};

use crate::driver::Session;
use crate::text::{FileId, Span};
use crate::validate::Mismatch;

use super::disk::file_name;
use super::output::Destination;

/// How every bundle begins.
const MARK: &str = "partc report: the output is not what the program says\n";
/// Names tried for a bundle.
const NAMES: u32 = 100;
/// Most bytes of a program that are copied.
const MOST: u32 = 16 << 20;

/// Writes the bundle beside the output, or for streams into the folder for temporary files; where it is now.
pub(super) fn write(mismatch: &Mismatch, session: &Session, config: &str, output: &Path) -> io::Result<PathBuf> {
    let beside = if output == Path::new("-") { std::env::temp_dir().join("stdout") } else { output.to_path_buf() };
    let path = name(&beside).ok_or_else(|| io::Error::other("no name is left for the report"))?;
    let mut out = Destination::open(&path)?;
    out.write_all(text(mismatch, session, config).as_bytes())?;
    for file in (0..session.sources.len()).filter_map(|n| u16::try_from(n).ok()).map(FileId) {
        let name = session.sources.name(file);
        write!(out, "\n--- program {name}\n")?;
        out.write_all(&session.sources.bytes(file, Span { start: 0, end: MOST }))?;
    }
    out.commit()?;
    Ok(path)
}

/// A name that is free, or that an older bundle has.
fn name(beside: &Path) -> Option<PathBuf> {
    let stem = file_name(&beside.with_extension(""));
    let names = (0..NAMES).map(|n| if n == 0 { String::new() } else { format!(".{n}") });
    names.map(|n| beside.with_file_name(format!("{stem}.partc-report{n}.txt"))).find(|path| {
        let mut head = Vec::new();
        match File::open(path) {
            Ok(file) => file.take(MARK.len() as u64).read_to_end(&mut head).is_ok() && head == MARK.as_bytes(),
            Err(_) => path.symlink_metadata().is_err(),
        }
    })
}

fn text(mismatch: &Mismatch, session: &Session, config: &str) -> String {
    let Mismatch { origin, line, why, meant, printed } = mismatch;
    let version = env!("CARGO_PKG_VERSION");
    let block = session.sources.line(origin.loc);
    let calls: String = session
        .trail
        .sites(origin.call)
        .iter()
        .map(|site| format!("  called at {}:{}\n", session.sources.name(site.file), site.line))
        .collect();
    format!(
        "{MARK}\npartc {version}\n{why}\n\nblock: {}:{}: {}\n{calls}meant: {meant}\nprinted, up to line {line} of \
         the output:\n{printed}\n--- configuration\n{config}",
        session.sources.name(origin.loc.file),
        origin.loc.line,
        block.text.trim_end(),
    )
}

#[cfg(test)]
mod tests {
    use std::fs;

    use clap::Parser as _;

    use super::super::args::Args;
    use super::super::{Exit, dispatch};
    use super::*;
    use crate::emit::printer::disturb::DISTURBED;

    fn run(folder: &Path, option: &[&str]) -> Exit {
        let input = folder.join(DISTURBED).display().to_string();
        let args = ["partc", "compile", &input].into_iter().chain(option.iter().copied());
        dispatch(&Args::try_parse_from(args).unwrap()).unwrap()
    }

    #[test]
    fn a_wrong_output_is_not_written_and_can_be_reported() {
        let folder = std::env::temp_dir().join(format!("partc-bundle-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        let program = "0 BEGIN PGM A MM\n1 L X+10.25 Y+5 Z+2 R0 FMAX\n2 END PGM A MM\n";
        fs::write(folder.join(DISTURBED), program).unwrap();
        fs::write(folder.join("partc.toml"), "[output]\ncomments = false\n").unwrap();
        let [output, report] = ["DISTURBED.ngc", "DISTURBED.partc-report.txt"].map(|name| folder.join(name));
        assert_eq!(run(&folder, &[]), Exit::Internal);
        assert!(!output.exists());
        let text = fs::read_to_string(&report).unwrap();
        for part in
            ["an axis ends elsewhere", "DISTURBED.H:2: 1 L X+10.25", "G0 X10 Y5 Z2", "comments = false", program]
        {
            assert!(text.contains(part), "{part} is missing:\n{text}");
        }
        // The next report takes the place of this one, and of no other file.
        fs::write(&report, "mine").unwrap();
        assert_eq!(run(&folder, &[]), Exit::Internal);
        assert_eq!(fs::read_to_string(&report).unwrap(), "mine");
        assert!(folder.join("DISTURBED.partc-report.1.txt").exists());
        assert_eq!(run(&folder, &["--no-verify"]), Exit::Clean);
        assert!(fs::read_to_string(&output).unwrap().contains("G0 X10 Y5 Z2"));
        fs::remove_dir_all(&folder).unwrap();
    }
}
