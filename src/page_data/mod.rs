//! Everything that a page shows of a program, as bytes for scripts of a browser.
//!
//! In: a session. Out: parts, of which the first is JSON and names the others. Two calls, so that a page has its picture before
//! the rules have looked on: [`made`] gives text, path and figures, [`checked`] findings and the places behind the blocks.
//! Nothing here changes what is printed.

mod answer;
mod packed;
mod path;

use std::cell::Cell;
use std::fmt::Write as _;

use serde_json::{Value, json};

use crate::block_ends::BlockEnds;
use crate::diag::{CallPath, Diags, Finding, Trail, codes};
use crate::dialect::Dialect;
use crate::driver::{Failure, Session};
use crate::emit::LineMap;
use crate::emit::stats::{Counter, Model, SMOOTH_DEG};
use crate::ir::motion::{Move, Sink};
use crate::ir::{Blank, Function, Origin, Pos};
use crate::machine::keys::choices;
use crate::machine::tools::{Tool, ToolKey};
use crate::machine::{MachineKind, Settings};
use crate::text::{FileId, Files, Sources};

pub use answer::answer;
use packed::Packed;
use path::Recorder;

/// Compiles the main program of a session: `about`, code, path, and the block of each line.
///
/// With an error among the findings there is no code, and the path says from which move on it is not whole.
///
/// # Errors
/// As [`Session::compile`].
pub fn made(session: &Session, dialect: &Dialect, settings: &Settings, files: &dyn Files) -> Result<Vec<u8>, Failure> {
    made_unless(session, dialect, settings, files, &|session| session.diags.has_errors())
}

/// The same; with findings that `fails` does not let pass there is no code.
///
/// # Errors
/// As [`Session::compile`].
pub fn made_unless(
    session: &Session,
    dialect: &Dialect,
    settings: &Settings,
    files: &dyn Files,
    fails: &dyn Fn(&Session) -> bool,
) -> Result<Vec<u8>, Failure> {
    let mut code = Vec::new();
    let printed = Cell::new(0);
    let mut lines = Lines { blocks: Blocks::new(&session.trail), printed: &printed, lines: Vec::new() };
    let mut look = Look {
        recorder: Recorder::new(Blocks::new(&session.trail), &printed),
        counter: Counter::new(Model::default()),
    };
    session.compile_beside(dialect, settings, files, &mut code, Some(&mut lines), Some(&mut look))?;
    let Look { recorder, counter } = look;
    let failed = fails(session);
    if failed {
        code.clear();
        lines.lines.clear();
    }
    let mut path = recorder.finish();
    if failed {
        path.without_code();
    }
    let settings = dialect.settings(settings);
    let target = settings.output.target;
    let lathe = settings.machine.kind == MachineKind::Lathe;
    let tools: Vec<Value> = path.tools.iter().map(|number| tool(*number, &settings)).collect();
    let model = Model::default();
    let mut about = json!({
        "version": env!("CARGO_PKG_VERSION"),
        "name": name(&session.sources),
        "dialect": dialect.id,
        "target": target.name,
        "extension": target.extension,
        "lathe": lathe,
        "diameter": settings.machine.shown_diameter().map(|axis| axis.letter().to_string()),
        "failed": failed,
        "findings": findings(&session.diags, &session.sources, &session.trail),
        "dropped": session.diags.dropped(),
        "tools": tools,
        "left_out": path.left_out,
        "origin": path.origin,
        "known": path.known,
        "incomplete": incomplete(session, &path),
        "blank": path.blank.as_ref().map(blank),
        "model": { "rapid": model.rapid, "acceleration": model.acceleration, "smooth": SMOOTH_DEG },
    });
    about["stats"] = if failed { Value::Null } else { counter.finish().object() };
    let mut packed = Packed::default();
    packed.part("code", code);
    packed.words("lines", &lines.lines);
    path.pack(&mut packed);
    Ok(packed.bytes(about))
}

/// The first error, and the first move behind it: none where no move follows.
fn incomplete(session: &Session, path: &path::Path) -> Option<Value> {
    let found = session.first_error()?;
    let own = found.file == session.sources.name(FileId(0));
    let file = found.file.rsplit(['/', '\\']).next().unwrap_or(&found.file);
    Some(json!({ "code": found.code, "file": file, "own": own, "line": found.line, "from": path.broken_from }))
}

fn blank(blank: &Blank) -> Value {
    match blank {
        Blank::Cuboid { low, high } => json!({ "low": low, "high": high }),
        Blank::Round { axis, radius, bore, low, high } => {
            json!({ "axis": axis.index(), "radius": radius, "bore": bore, "low": low, "high": high })
        }
    }
}

/// Checks the main program of a session: findings, and the place behind each block as lines of text with the number of the
/// block's line in front.
pub fn checked(session: &Session, dialect: &Dialect, settings: &Settings, files: &dyn Files) -> Vec<u8> {
    let mut seen = BlockEnds::default();
    session.check_seen(dialect, settings, files, Some(&mut seen), &|| true);
    let cut_off = session.diags.any(|found| found.code.id == codes::P4001.id);
    let mut places = String::new();
    for stop in seen.stops.iter().filter(|stop| stop.file == FileId(0)) {
        let _ = writeln!(places, "{}\t{}", stop.line, stop.place(cut_off, seen.diameter));
    }
    let about = json!({
        "findings": findings(&session.diags, &session.sources, &session.trail),
        "dropped": session.diags.dropped(),
    });
    let mut packed = Packed::default();
    packed.part("places", places.into_bytes());
    packed.bytes(about)
}

/// In the order of their places. The folder a program lies in is of no interest to who gets the page.
fn findings(diags: &Diags, sources: &Sources, trail: &Trail) -> Vec<Finding> {
    let mut list = Vec::new();
    diags.each(|found| {
        list.push(((found.label.loc.file, found.label.loc.span.start), Finding::new(found, sources, trail, choices)))
    });
    list.sort_by_key(|(at, _)| *at);
    let (main, name) = (sources.name(FileId(0)), name(sources));
    let shorten = |file: &mut String| {
        if *file == main {
            file.clone_from(&name);
        }
    };
    for (_, finding) in &mut list {
        shorten(&mut finding.file);
        finding.related.iter_mut().for_each(|related| shorten(&mut related.file));
        finding.stack.iter_mut().for_each(|site| shorten(&mut site.file));
    }
    list.into_iter().map(|(_, finding)| finding).collect()
}

/// The main program without its folder.
fn name(sources: &Sources) -> String {
    let name = sources.name(FileId(0));
    name.rsplit(['/', '\\']).next().unwrap_or(&name).to_owned()
}

/// What is known of a tool.
fn tool(number: Option<u32>, settings: &Settings) -> Value {
    let Some(number) = number else { return json!({ "number": null }) };
    let of_number = |(key, tool): &(&ToolKey, &Tool)| match key {
        ToolKey::Number(key, 0) => tool.number.unwrap_or(*key) == number,
        ToolKey::Number(..) => false,
        ToolKey::Name(_) => tool.number == Some(number),
    };
    let Some((key, tool)) = settings.tools.table.iter().find(of_number) else { return json!({ "number": number }) };
    let name = match key {
        ToolKey::Name(name) => Some(name),
        ToolKey::Number(..) => tool.name.as_ref(),
    };
    json!({
        "number": number,
        "name": name,
        "kind": tool.kind,
        "radius": tool.radius,
        "length": tool.length,
        "corner_radius": tool.corner_radius,
        "width": tool.width,
    })
}

/// Lines of the main program: of what a called program does, the line that calls it.
#[derive(Debug)]
pub(crate) struct Blocks<'a> {
    trail: &'a Trail,
    last: Option<(CallPath, u32)>,
}

impl<'a> Blocks<'a> {
    fn new(trail: &'a Trail) -> Blocks<'a> {
        Blocks { trail, last: None }
    }

    fn line(&mut self, origin: &Origin) -> u32 {
        if origin.loc.file == FileId(0) {
            return origin.loc.line;
        }
        if let Some((call, line)) = self.last
            && call == origin.call
        {
            return line;
        }
        let sites = self.trail.sites(origin.call);
        let line = sites.iter().rfind(|site| site.file == FileId(0)).map_or(0, |site| site.line);
        self.last = Some((origin.call, line));
        line
    }
}

/// Notes the block of each printed line.
struct Lines<'a> {
    blocks: Blocks<'a>,
    /// Number of the last line.
    printed: &'a Cell<u32>,
    /// The block of line 1, 2 …; 0 for none.
    lines: Vec<u32>,
}

impl LineMap for Lines<'_> {
    fn line(&mut self, number: u64, origin: &Origin) {
        self.lines.resize((number as usize).max(1) - 1, 0);
        self.lines.push(self.blocks.line(origin));
        self.printed.set(number as u32);
    }
}

/// Sees each item after it is printed.
struct Look<'a> {
    recorder: Recorder<'a>,
    counter: Counter,
}

impl Sink for Look<'_> {
    fn movement(&mut self, mv: &Move, origin: &Origin) {
        self.recorder.movement(mv, origin);
        self.counter.movement(mv, origin);
    }

    fn function(&mut self, function: &Function, origin: &Origin) {
        self.recorder.function(function);
        self.counter.function(function, origin);
    }

    fn lost(&mut self, origin: &Origin) {
        self.recorder.lost();
        self.counter.lost(origin);
    }

    fn begins_at(&mut self, at: &Pos) {
        self.recorder.begins_at(at);
        self.counter.begins_at(at);
    }
}
