//! `partc diff`: two programs as motion.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::json;

use crate::compare::{Difference, Step, Steps, play, steps_of_text};
use crate::dialect;
use crate::driver::Session;
use crate::emit::is_printed;
use crate::emit::plot::{Options, Plot};
use crate::ir::motion::Sink;
use crate::ir::workpiece::InWorkpiece;
use crate::machine::Settings;
use crate::text::decode::{escaped_json, harmless_lines};

use super::args::Diff;
use super::closure::Targets;
use super::disk::{IncludeRoots, file_name, read_whole};
use super::listing::print;
use super::made::{Made, Replaces, is_foreign};
use super::options::{Common, Findings, Format};
use super::output::Destination;
use super::paths::same_file;
use super::program::{Loaded, load};
use super::report::{Reporter, Stdout};
use super::{Exit, Trouble, config, plot};

/// Extensions of plain G-code.
const PLAIN: [&str; 6] = ["ngc", "gcode", "nc", "tap", "cnc", "gc"];
/// Bytes looked at to tell plain G-code.
const HEAD: usize = 4096;

/// One of the programs.
enum Program {
    Part(Box<Loaded>),
    /// Plain G-code, and the settings for its place.
    Plain(Vec<u8>, Box<Settings>),
}

impl Program {
    fn load(path: &Path, common: &Common) -> Result<Program, Trouble> {
        if common.dialect == "auto" && is_plain(path) {
            let text = read_whole(path).map_err(|error| format!("{}: {error}", path.display()))?;
            return Ok(Program::Plain(text, Box::new(config::settings(path, common)?)));
        }
        Ok(Program::Part(Box::new(load(path, common)?)))
    }

    fn settings(&self) -> &Settings {
        match self {
            Program::Part(part) => &part.settings,
            Program::Plain(_, settings) => settings,
        }
    }

    /// Gives its motion to `sink`.
    fn play(&self, path: &Path, sink: &mut dyn Sink) -> Result<(), Trouble> {
        match self {
            Program::Part(part) => {
                let Loaded { session, dialect, settings, files, .. } = part.as_ref();
                session.lower(dialect, settings, files, sink);
                Ok(())
            }
            Program::Plain(text, _) => play(text, sink).map_err(|stop| format!("{}: {stop}", path.display())),
        }
    }

    fn steps(&self, path: &Path, tolerance: f64) -> Result<Vec<Step>, Trouble> {
        if let Program::Plain(text, _) = self {
            return steps_of_text(text, tolerance).map_err(|stop| format!("{}: {stop}", path.display()));
        }
        let mut steps = match self {
            Program::Part(part) => Steps::of_program(tolerance, &part.dialect.settings(&part.settings)),
            Program::Plain(..) => Steps::new(tolerance),
        };
        self.play(path, &mut steps)?;
        Ok(steps.finish())
    }

    fn session(self) -> Option<Session> {
        match self {
            Program::Part(part) => Some(part.session),
            Program::Plain(..) => None,
        }
    }
}

/// Plain G-code by its head, or by its extension where no language knows the program.
fn is_plain(path: &Path) -> bool {
    let name = path.to_string_lossy();
    let Ok(bytes) = fs::read(path) else { return false };
    let head = &bytes[..bytes.len().min(HEAD)];
    let made = is_printed(head);
    let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
    let named = extension.is_some_and(|extension| PLAIN.contains(&extension.as_str()));
    made || named && dialect::guess(&name, head).is_none_or(|dialect| dialect.id == "gcode")
}

/// `partc diff`
pub(super) fn diff(args: &Diff) -> Result<Exit, Trouble> {
    let format = args.common.report.format.unwrap_or(Format::Human);
    if !matches!(format, Format::Human | Format::Concise | Format::Json) {
        return Err("`partc diff` writes human, concise or json".to_owned());
    }
    if let Some(picture) = &args.plot {
        let shown = picture.display();
        if same_file(picture, &args.a) || same_file(picture, &args.b) {
            return Err(format!("{shown}: the picture would replace the program"));
        }
        if is_foreign(picture, Made::Picture) && !args.force {
            return Err(format!("{shown}: not drawn by partc; use --force to replace it, or another name"));
        }
    }
    let paths = [&args.a, &args.b];
    let programs = [Program::load(&args.a, &args.common)?, Program::load(&args.b, &args.common)?];
    let [a, b] = [0, 1].map(|i| programs[i].steps(paths[i], args.tolerance));
    let (a, b) = (a?, b?);
    let targets = Targets::new(args.plot.as_deref());
    for (program, path) in programs.iter().zip(paths) {
        match program {
            Program::Part(part) => targets.spare(path, &args.common, &part.files)?,
            Program::Plain(..) => {
                targets.spare(path, &args.common, &IncludeRoots::new(PathBuf::new(), BTreeMap::new()))?
            }
        }
    }
    let mut reporter = Reporter::new(&args.common, &Findings::SHOWN, Stdout::Taken, None);
    let failed = programs.iter().any(|program| match program {
        Program::Part(part) => reporter.look().fails(&part.session),
        Program::Plain(..) => false,
    });
    let drawn = match &args.plot {
        Some(picture) if !failed => draw(args, picture),
        _ => Ok(()),
    };
    for session in programs.into_iter().filter_map(Program::session) {
        reporter.session(session);
    }
    drawn?;
    // A document holds either findings or a comparison.
    if failed || format != Format::Json {
        let exit = reporter.finish()?;
        if failed {
            return Ok(exit);
        }
    }
    let shown = paths.map(|path| path.display().to_string());
    let [one, other] = paths.map(|path| file_name(path));
    // Of one name the paths tell which is which.
    let names = if one == other { [shown[0].as_str(), shown[1].as_str()] } else { [one.as_str(), other.as_str()] };
    let found = Difference::between(&a, &b, args.tolerance);
    if format == Format::Json {
        let mut report = found.json(&a, &b, [&shown[0], &shown[1]]);
        report["version"] = json!(1);
        print(escaped_json(&format!("{report}\n")).as_bytes())?;
    } else if !(args.common.report.quiet && found.is_same()) {
        let text = found.text(&a, &b, names);
        let text = if format == Format::Concise {
            text.lines().take(1).map(|line| format!("{line}\n")).collect()
        } else {
            text
        };
        print(harmless_lines(&text).as_bytes())?;
    }
    Ok(if found.is_same() { Exit::Clean } else { Exit::Errors })
}

/// Draws both paths; each program is run once more.
fn draw(args: &Diff, picture: &Path) -> Result<(), Trouble> {
    let options = Options { form: plot::form(picture)?, ..Options::default() };
    let trouble = |error: std::io::Error| format!("{}: {error}", picture.display());
    let mut out = Destination::open_for(picture, Replaces::by(Made::Picture, args.force)).map_err(trouble)?;
    let first = Program::load(&args.a, &args.common)?;
    let title = format!("{} and {}", file_name(&args.a), file_name(&args.b));
    let mut drawn = Plot::new(first.settings(), &title, options);
    for path in [&args.a, &args.b] {
        drawn.program(&file_name(path));
        let program = Program::load(path, &args.common)?;
        program.play(path, &mut InWorkpiece::new(&mut drawn))?;
        if let Program::Part(part) = &program {
            part.files.unchanged()?;
        }
    }
    drawn.finish(None, &mut out).map_err(trouble)?;
    out.commit().map_err(trouble)
}
