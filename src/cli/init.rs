//! `partc init`: reads programs and writes the configuration that they need, as far as they tell.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use crate::diag::{Severity, codes};
use crate::dialect::Dialect;
use crate::driver::Session;
use crate::machine::tree::{Table, overlay, parse};
use crate::machine::{MachineKind, Settings};
use crate::text::decode::harmless_lines;

use super::answers::{Form, Needs, Place, Request, requests};
use super::args::Init;
use super::closure::Targets;
use super::inputs::{Ignored, Input, inputs, walk};
use super::listing::print;
use super::options::Common;
use super::output::Destination;
use super::pool::in_order;
use super::report::{Reporter, Stdout, counted};
use super::run::{Loaded, is_output, is_program, load_with};
use super::{Exit, Trouble, config};

/// Most times that a program is tried: what is answered lets the run go on to what else is missing.
const MOST_ROUNDS: usize = 8;
/// What a program may ask for in all: more of it is one fault, or none that anybody answers, and each round would find as much again.
const MOST_ASKED: usize = 1000;
/// Steps of a trial: what runs longer is cut off.
const STEPS: u64 = 200_000;
/// Codes of what is left that are listed.
const MOST_LEFT: usize = 12;
/// Programs named for one such code.
const MOST_NAMED: usize = 3;

/// `partc init`
pub(super) fn init(args: &Init) -> Result<Exit, Trouble> {
    let target = target(args)?;
    if target != Path::new("-") && target.exists() && !args.force {
        return Err(format!(
            "{}: exists; use --force to write over it, or `-o -` to see what would be written",
            target.display()
        ));
    }
    let targets = Targets::new([target.as_path()]);
    let found = inputs(&args.paths, &args.many, &|path| is_program(path, &args.common) && !is_output(path))?;
    let mut reporter = Reporter::new(&args.common, &super::options::Findings::SHOWN, Stdout::Taken, None);
    found.troubles.into_iter().for_each(|trouble| reporter.trouble(trouble));
    let (mut all, inputs) = (Programs::default(), found.list);
    let beside = if target == Path::new("-") { usual(args)? } else { target.clone() };
    let folder = beside.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if args.common.config.is_none() && !args.common.isolated {
        all.extends = config::above(folder);
    }
    let base = Base { folder: folder.to_path_buf(), lies_in: index(folder) };
    // The older configuration is what `--force` is about.
    for input in &inputs {
        let read = config::read_for(&input.path, &args.common).map(|read| read.files).unwrap_or_default();
        let tables = read.into_iter().filter(|(what, _)| *what != "configuration").map(|(_, path)| path);
        targets.none_of(&input.path, tables.chain([input.path.clone()]))?;
    }
    let work = |input: &Input| Trial::of(&input.path, &base, &args.common);
    in_order(args.many.jobs, &inputs, work, |done, trial| {
        reporter.progress(done, inputs.len());
        match trial {
            Ok(trial) => all.take(trial),
            Err(trouble) => reporter.trouble(trouble),
        }
    });
    if all.count == 0 {
        return Err("no part program lies in the folders that are named".to_owned());
    }
    // Names of files and texts of programs stand in comments.
    let text: String = all.toml().lines().map(|line| harmless_lines(line) + "\n").collect();
    if target == Path::new("-") {
        print(text.as_bytes())?;
    } else {
        let shown = target.display();
        let trouble = |error: std::io::Error| format!("{shown}: {error}");
        let mut out = Destination::open(&target).map_err(trouble)?;
        out.write_all(text.as_bytes()).and_then(|()| out.commit()).map_err(trouble)?;
        let values = counted(all.needs.len() as u32, "value", "values");
        let after = all.at_once + all.after;
        reporter.say(&format!(
            "{shown}: {} read, {} now, {after} with {values} filled in",
            counted(all.count, "program", "programs"),
            counted(all.at_once, "compiles", "compile"),
        ));
    }
    Ok(if reporter.troubles().is_empty() { Exit::Clean } else { Exit::Usage })
}

/// The file to write.
fn target(args: &Init) -> Result<PathBuf, Trouble> {
    args.output.clone().map_or_else(|| usual(args), Ok)
}

/// The file that is written unless another one is named.
fn usual(args: &Init) -> Result<PathBuf, Trouble> {
    match args.paths.first() {
        Some(path) if path.is_dir() => Ok(path.join(config::NAME)),
        Some(path) if path.exists() => Ok(path.with_file_name(config::NAME)),
        Some(path) => Err(format!("{}: no such file or folder", path.display())),
        None => Ok(PathBuf::from(config::NAME)),
    }
}

/// What a program asks for once all that it asks for is answered.
pub(super) fn requests_of(path: &Path, common: &Common) -> Result<Vec<Request>, Trouble> {
    let base = Base { folder: PathBuf::from("."), lies_in: BTreeMap::new() };
    Ok(Trial::of(path, &base, common)?.requests)
}

/// Where the new configuration lies, and the files below it.
struct Base {
    folder: PathBuf,
    /// Folders of the files, by upper-case name.
    lies_in: BTreeMap<String, BTreeSet<PathBuf>>,
}

impl Base {
    /// The folder that holds this file, and the key of a root for it: the only one, or the one that a SINUMERIK searches
    /// first.
    fn root_of(&self, file: &str) -> Option<(String, String)> {
        let folders = self.lies_in.get(&file.to_uppercase())?;
        let (_, extension) = file.rsplit_once('.')?;
        let below = |folder: &Path| folder.to_string_lossy().replace('\\', "/");
        if extension.eq_ignore_ascii_case("spf") {
            let rank = |folder: &Path| SEARCHED.iter().position(|name| is_copy_of(folder, name));
            // Of two copies of one folder nobody knows which is meant.
            let copies = |at: usize| folders.iter().filter(move |folder| rank(folder) == Some(at)).collect::<Vec<_>>();
            if let Some((at, list)) = (0..SEARCHED.len()).map(|at| (at, copies(at))).find(|(_, list)| !list.is_empty())
            {
                let [folder] = list[..] else { return None };
                return Some((format!("/_N_{}_DIR", SEARCHED[at]), below(folder)));
            }
        }
        let mut folders = folders.iter();
        let (Some(folder), None) = (folders.next(), folders.next()) else { return None };
        let name = folder.file_name()?.to_string_lossy().to_uppercase();
        let root = match &extension.to_ascii_lowercase()[..] {
            "h" => format!("TNC:/{}", below(folder)),
            // No other folder and no workpiece is searched for a subprogram, and none for a main program.
            "spf" if !name.ends_with(".WPD") && !name.ends_with("_WPD") => format!("/_N_{}_DIR", SEARCHED[0]),
            "spf" | "mpf" => return None,
            _ => format!("/_N_{name}_DIR"),
        };
        Some((root, below(folder)))
    }
}

/// Folders in which a SINUMERIK looks for a subprogram beside that of the main program, in its order.
const SEARCHED: [&str; 4] = ["SPF", "CUS", "CMA", "CST"];

/// Is the folder called as a copy of `/_N_SPF_DIR` is, where the name is SPF?
fn is_copy_of(folder: &Path, name: &str) -> bool {
    let folder = folder.file_name().map(|folder| folder.to_string_lossy().to_uppercase()).unwrap_or_default();
    [format!("{name}.DIR"), format!("_N_{name}_DIR"), format!("{name}_DIR")].contains(&folder)
}

/// The files in folders below `folder`.
fn index(folder: &Path) -> BTreeMap<String, BTreeSet<PathBuf>> {
    let mut lies_in: BTreeMap<String, BTreeSet<PathBuf>> = BTreeMap::new();
    for path in walk(folder, &|_| true, Ignored::LeftOut).unwrap_or_default() {
        let below = path.strip_prefix(folder).unwrap_or(&path);
        if let (Some(name), Some(parent)) = (below.file_name(), below.parent())
            && !parent.as_os_str().is_empty()
        {
            lies_in.entry(name.to_string_lossy().to_uppercase()).or_default().insert(parent.to_path_buf());
        }
    }
    lies_in
}

/// Something a program uses, with the place of its first use.
type Seen<K> = BTreeMap<K, (Place, u32)>;

/// How a program calls a tool.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Called {
    Number(u32),
    /// In quotes.
    Name(String),
}

impl Called {
    /// The tool that was printed as `number` when a program was tried with `needs`.
    fn of(number: u32, needs: &Needs) -> Called {
        needs.name_of(number).map_or(Called::Number(number), |name| Called::Name(name.to_owned()))
    }
}

impl std::fmt::Display for Called {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Called::Number(number) => write!(f, "{number}"),
            Called::Name(name) => f.write_str(name),
        }
    }
}

/// What one program came to.
struct Trial {
    dialect: &'static Dialect,
    needs: Needs,
    /// Its tools, with what they do.
    tools: Vec<(Called, Place, String)>,
    offsets: Vec<(u8, Place)>,
    cutting_speed: Option<Place>,
    /// Called programs that no key stands for.
    missing: Vec<(String, Place)>,
    /// Errors of the last round, none for a program that compiles.
    left: Vec<(&'static str, Place)>,
    rounds: usize,
    /// What every round asked for.
    requests: Vec<Request>,
    lists: BTreeMap<(String, String), Vec<String>>,
}

impl Trial {
    /// Tries the program, answers what it asks for with some value, and tries it again, until it asks for nothing new.
    fn of(path: &Path, folder: &Base, common: &Common) -> Result<Trial, Trouble> {
        let base = config::tree_for(path, common)?;
        let name = path.display().to_string();
        let mut needs = Needs::default();
        let lists = lists(&config::settings_of(&base, common)?);
        let (mut trial, mut all): (Option<Trial>, Vec<Request>) = (None, Vec::new());
        for round in 0..MOST_ROUNDS {
            let tried_with = needs.clone();
            let settings = tried(&base, &needs, &lists, folder, common)?;
            let Loaded { session, dialect, settings, files, .. } = load_with(path, common, settings)?;
            let uses = session.uses(dialect, &settings, &files);
            files.unchanged()?;
            let asked = requests(&session, &|file| folder.root_of(file));
            let is_new = needs.take(&name, &asked);
            all.extend(asked.into_iter().map(|request| needs.by_its_name(request)));
            let place = |loc| Place::new(loc, &session);
            let now = Trial {
                dialect,
                needs: Needs::default(),
                tools: uses
                    .tools
                    .iter()
                    .filter(|(number, _)| **number != 0)
                    .map(|(number, tool)| {
                        let mut what: Vec<String> = tool.cycles.iter().map(|family| words(family)).collect();
                        what.extend(tool.compensated.then(|| "radius compensation".to_owned()));
                        (Called::of(*number, &tried_with), place(tool.first), what.join(", "))
                    })
                    .collect(),
                offsets: uses
                    .offsets
                    .iter()
                    .filter(|(number, _)| !tried_with.is_tried_offset(&offset(**number)))
                    .map(|(number, loc)| (*number, place(*loc)))
                    .collect(),
                cutting_speed: uses
                    .cutting_speed
                    .filter(|_| settings.machine.kind == MachineKind::Mill && !dialect.turns)
                    .map(place),
                missing: missing(&session),
                left: errors(&session),
                rounds: round,
                requests: Vec::new(),
                lists: BTreeMap::new(),
            };
            let done = !is_new || now.left.is_empty() || all.len() >= MOST_ASKED;
            trial = Some(now);
            if done {
                break;
            }
        }
        let trial = trial.ok_or("nothing was tried")?;
        Ok(Trial { needs, lists, requests: all, ..trial })
    }
}

/// Lists of the configuration that findings add to.
fn lists(settings: &Settings) -> BTreeMap<(String, String), Vec<String>> {
    let m = settings.output.pass_m.iter().map(ToString::to_string).collect();
    BTreeMap::from([(("output".to_owned(), "pass_m".to_owned()), m)])
}

/// The settings with some value for all that is asked for.
fn tried(
    base: &Table,
    needs: &Needs,
    lists: &BTreeMap<(String, String), Vec<String>>,
    folder: &Base,
    common: &Common,
) -> Result<Settings, Trouble> {
    let listed =
        |section: &str, key: &str| lists.get(&(section.to_owned(), key.to_owned())).cloned().unwrap_or_default();
    let text = needs.toml(Form::Tried, &BTreeSet::new(), &listed);
    let mut tree = base.clone();
    let mut over = parse(&text, "what is tried").map_err(|error| error.to_string())?;
    config::make_absolute(&mut over, &folder.folder);
    overlay(&mut tree, over);
    let mut settings = config::settings_of(&tree, common)?;
    settings.limits.steps = settings.limits.steps.min(STEPS);
    Ok(settings)
}

/// `PathMilling` as words.
fn words(family: &str) -> String {
    let mut text = String::new();
    for c in family.chars() {
        if c.is_uppercase() && !text.is_empty() {
            text.push(' ');
        }
        text.extend(c.to_lowercase());
    }
    text
}

/// Called programs that are found nowhere and that no key stands for.
fn missing(session: &Session) -> Vec<(String, Place)> {
    let mut list = Vec::new();
    session.diags.each(|found| {
        if found.code.id == codes::P0101.id {
            list.push((found.message.clone(), Place::new(found.label.loc, session)));
        }
    });
    list
}

/// Codes of the errors, each once.
fn errors(session: &Session) -> Vec<(&'static str, Place)> {
    let mut list: Vec<(&'static str, Place)> = Vec::new();
    session.diags.each(|found| {
        let is_known = list.iter().any(|(code, _)| *code == found.code.id);
        // A trial is cut off early.
        if found.severity == Severity::Error && found.code.id != codes::P4001.id && !is_known {
            list.push((found.code.id, Place::new(found.label.loc, session)));
        }
    });
    list
}

/// What all programs came to.
#[derive(Default)]
struct Programs {
    /// The configuration that a new one would hide.
    extends: Option<String>,
    count: u32,
    /// Compile as they are.
    at_once: u32,
    /// Compile once the values are filled in.
    after: u32,
    dialects: BTreeMap<&'static str, u32>,
    needs: Needs,
    tools: BTreeMap<Called, (Place, BTreeSet<String>, u32)>,
    offsets: Seen<u8>,
    cutting_speed: Option<(Place, u32)>,
    missing: Seen<String>,
    left: BTreeMap<&'static str, (Vec<Place>, u32)>,
    lists: BTreeMap<(String, String), Vec<String>>,
}

impl Programs {
    fn take(&mut self, trial: Trial) {
        self.count += 1;
        *self.dialects.entry(trial.dialect.name).or_default() += 1;
        match (trial.left.is_empty(), trial.rounds) {
            (true, 0) => self.at_once += 1,
            (true, _) => self.after += 1,
            (false, _) => {}
        }
        self.needs.join(&trial.needs);
        for (called, place, what) in trial.tools {
            let tool = self.tools.entry(called).or_insert_with(|| (place, BTreeSet::new(), 0));
            tool.1.extend(what.split(", ").filter(|what| !what.is_empty()).map(str::to_owned));
            tool.2 += 1;
        }
        for (number, place) in trial.offsets {
            self.offsets.entry(number).or_insert_with(|| (place, 0)).1 += 1;
        }
        if let Some(place) = trial.cutting_speed {
            self.cutting_speed.get_or_insert((place, 0)).1 += 1;
        }
        for (name, place) in trial.missing {
            self.missing.entry(name).or_insert_with(|| (place, 0)).1 += 1;
        }
        for (code, place) in trial.left {
            let left = self.left.entry(code).or_default();
            left.1 += 1;
            if left.0.len() < MOST_NAMED {
                left.0.push(place);
            }
        }
        self.lists.extend(trial.lists);
    }

    /// The file.
    fn toml(&self) -> String {
        let mut text = self.head();
        if let Some(above) = &self.extends {
            text += &format!("\n# It held for these programs until now.\nextend = \"{above}\"\n");
        }
        self.seen(&mut text);
        let number = |called: &Called| match called {
            Called::Number(number) => Some(*number),
            Called::Name(_) => None,
        };
        let taken = self.tools.keys().filter_map(number).collect();
        let listed = |section: &str, key: &str| {
            self.lists.get(&(section.to_owned(), key.to_owned())).cloned().unwrap_or_default()
        };
        text += "\n";
        text += &self.needs.toml(Form::Commented, &taken, &listed);
        self.rest(&mut text);
        text
    }

    fn head(&self) -> String {
        let dialects: Vec<String> = self.dialects.iter().map(|(name, n)| format!("{n} {name}")).collect();
        let mut text = format!(
            "# Written by `partc init` from {}: {}.\n",
            counted(self.count, "program", "programs"),
            dialects.join(", ")
        );
        let after = self.at_once + self.after;
        let _ = writeln!(
            text,
            "# {} as it is, {after} once the values below are filled in.",
            counted(self.at_once, "compiles", "compile")
        );
        text += "# Lines with `#key =` wait for you: write the value and take the `#` away. Each names the block that asks for it.\n";
        text
    }

    /// What the programs use and what needs no answer.
    fn seen(&self, text: &mut String) {
        if let Some((place, programs)) = &self.cutting_speed {
            let others = more(*programs);
            let _ = writeln!(
                text,
                "#\n# Constant cutting speed, so a lathe: {}{others}; `[machine] kind = \"lathe\"` where that is so.",
                at(place)
            );
        }
        if !self.tools.is_empty() {
            *text += "#\n# Tools that are called:\n";
        }
        for (called, (place, what, programs)) in &self.tools {
            let what = what.iter().cloned().collect::<Vec<_>>().join(", ");
            let what = if what.is_empty() { "moves only".to_owned() } else { what };
            let _ = writeln!(text, "#   {called}: {what}; {}{}", at(place), more(*programs));
        }
        if !self.offsets.is_empty() {
            *text += "#\n# Work offsets that are selected; their values are set on the machine:\n";
        }
        for (number, (place, programs)) in &self.offsets {
            let _ = writeln!(text, "#   {}; {}{}", offset(*number), at(place), more(*programs));
        }
        if !self.missing.is_empty() {
            *text += "#\n# Programs that are called and not found: put them beside the programs, or name their folder under [include]:\n";
        }
        for (message, (place, programs)) in &self.missing {
            let _ = writeln!(text, "#   {message}; {}{}", at(place), more(*programs));
        }
    }

    /// What no value mends.
    fn rest(&self, text: &mut String) {
        if self.left.is_empty() {
            return;
        }
        *text += "\n# What is left whatever is filled in (`partc explain CODE` says why):\n";
        let mut left: Vec<_> = self.left.iter().collect();
        left.sort_by_key(|(code, (_, programs))| (std::cmp::Reverse(*programs), **code));
        for (code, (places, programs)) in left.iter().take(MOST_LEFT) {
            let title = codes::find(code).map_or("", |code| code.title);
            let named: Vec<String> = places.iter().map(|place| format!("{}:{}", place.file, place.line)).collect();
            let _ = writeln!(
                text,
                "#   {code} {title}: {}, {}",
                counted(*programs, "program", "programs"),
                named.join(", ")
            );
        }
        if left.len() > MOST_LEFT {
            let _ = writeln!(text, "#   … and {} more codes", left.len() - MOST_LEFT);
        }
    }
}

fn at(place: &Place) -> String {
    format!("{}:{} `{}`", place.file, place.line, place.block)
}

fn more(programs: u32) -> String {
    match programs {
        0 | 1 => String::new(),
        n => format!(", {n} programs"),
    }
}

/// The word of a work offset, 1 (G54) to 9 (G59.3), and on.
fn offset(number: u8) -> String {
    match number {
        1..=6 => format!("G{}", 53 + number),
        10.. => format!("G54.1 P{}", number - 6),
        n => format!("G59.{}", n.saturating_sub(6)),
    }
}
