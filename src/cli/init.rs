//! `partc init`: reads programs and writes the configuration that they need, as far as they tell.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use crate::diag::codes;
use crate::text::decode::harmless_lines;

use super::answers::Needs;
use super::args::Init;
use super::ask::{Shop, ask};
use super::closure::Targets;
use super::inputs::{Input, inputs, no_program};
use super::listing::print;
use super::made::is_output;
use super::need::{Form, Place};
use super::options::Common;
use super::output::Destination;
use super::pool::in_order;
use super::program::is_program;
use super::report::{Reporter, Stdout, counted};
use super::tool_hints::Hint;
use super::trial::{Base, Called, Lists, Trial, Tried, index, offset};
use super::update::merged;
use super::{Exit, Trouble, config};

/// Codes of what is left that are listed.
const MOST_LEFT: usize = 12;
/// Programs named for one such code.
const MOST_NAMED: usize = 3;

/// `partc init`
pub(super) fn init(args: &Init) -> Result<Exit, Trouble> {
    let target = target(args)?;
    let is_there = target != Path::new("-") && target.exists();
    if is_there && !args.force && !args.update {
        return Err(format!(
            "{}: exists; use --update to add what is new, --force to write over it, or `-o -` to see what would be written",
            target.display()
        ));
    }
    let shown = target.display();
    let trouble = |error: std::io::Error| format!("{shown}: {error}");
    let old = if args.update && is_there { Some(std::fs::read_to_string(&target).map_err(trouble)?) } else { None };
    let targets = Targets::new([target.as_path()]);
    let found = inputs(&args.paths, &args.many, &|path| is_program(path, &args.common) && !is_output(path))?;
    let mut reporter = Reporter::new(&args.common, &super::options::Findings::SHOWN, Stdout::Taken, None);
    found.troubles.into_iter().for_each(|trouble| reporter.trouble(trouble));
    let (mut trials, inputs) = (Vec::new(), found.list);
    let beside = if target == Path::new("-") { usual(args)? } else { target.clone() };
    let folder = beside.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let hidden = (is_there && old.is_none()).then(|| target.clone());
    let base = Base { folder: folder.to_path_buf(), lies_in: index(folder), hidden };
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
            Ok(trial) => trials.push(trial),
            Err(trouble) => reporter.trouble(trouble),
        }
    });
    let mut all = Programs::of(trials);
    if args.common.config.is_none() && !args.common.isolated {
        all.extends = config::above(folder);
    }
    if all.count == 0 {
        return Err(if all.foreign.is_empty() {
            no_program(&args.paths)
        } else {
            format!("no part program of a control that partc reads: {}", listed(&all.foreign))
        });
    }
    if args.interactive {
        let shop = Inputs { list: &inputs, base: &base, common: &args.common };
        let (compiling, count) = (std::mem::take(&mut all.compiling), all.count);
        let (mut input, mut out) = (std::io::stdin().lock(), std::io::stderr().lock());
        ask(&mut all.needs, compiling, count, &shop, &mut input, &mut out).map_err(|error| error.to_string())?;
    }
    // Names of files and texts of programs stand in comments.
    let text = match old {
        Some(old) => {
            let text = merged(&old, &harmless(&all.asked()));
            if crate::machine::tree::parse(&text, &shown.to_string()).is_err() {
                return Err(format!(
                    "{shown}: what is asked for does not fit in: a table stands there in one line or by dotted keys; write it as \
                     `[tools]`, `[output]` and so on with a line for each key, and try again"
                ));
            }
            text
        }
        None => harmless(&all.toml()),
    };
    if target == Path::new("-") {
        print(text.as_bytes())?;
    } else {
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

fn harmless(text: &str) -> String {
    text.lines().map(|line| harmless_lines(line) + "\n").collect()
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

/// The programs, while their values are asked for.
struct Inputs<'a> {
    list: &'a [Input],
    base: &'a Base,
    common: &'a Common,
}

impl Inputs<'_> {
    fn tried(&self, program: &str) -> Option<Tried<'_>> {
        let input = self.list.iter().find(|input| input.path.display().to_string() == program)?;
        Tried::new(&input.path, self.base, self.common).ok()
    }
}

impl Shop for Inputs<'_> {
    fn refuses(&self, given: &Needs) -> Option<Trouble> {
        let first = self.list.first()?;
        Tried::new(&first.path, self.base, self.common).and_then(|tried| tried.settings(given)).err()
    }

    fn compiles(&self, program: &str, given: &Needs) -> bool {
        self.tried(program)
            .and_then(|tried| tried.once(given).ok())
            .is_some_and(|trial| trial.left.is_empty() && !trial.is_open)
    }
}

/// Something a program uses, with the place of its first use.
type Seen<K> = BTreeMap<K, (Place, u32)>;

/// What is left of one code: its places, each with the programs that come there, and all programs.
#[derive(Default)]
struct Left {
    places: Vec<(Place, u32)>,
    programs: u32,
}

impl Left {
    fn take(&mut self, place: Place) {
        self.programs += 1;
        // Programs that call the same file meet in one place.
        match self.places.iter_mut().find(|(known, _)| (&known.file, known.line) == (&place.file, place.line)) {
            Some((_, programs)) => *programs += 1,
            None => self.places.push((place, 1)),
        }
    }

    /// The first places, those of most programs in front.
    fn named(&self) -> String {
        let mut places: Vec<&(Place, u32)> = self.places.iter().collect();
        places.sort_by_key(|(_, programs)| std::cmp::Reverse(*programs));
        let all = places.len() == 1;
        let named = places.iter().take(MOST_NAMED).map(|(Place { file, line, .. }, programs)| match programs {
            2.. if !all => format!("{file}:{line} ({programs} programs)"),
            _ => format!("{file}:{line}"),
        });
        named.collect::<Vec<_>>().join(", ")
    }
}

/// What all programs came to.
#[derive(Default)]
struct Programs {
    /// The configuration that a new one would hide.
    extends: Option<String>,
    count: u32,
    /// Programs that others call: what is wrong with them shows there.
    called: u32,
    /// What is called like a program and is none of these controls, by its kind.
    foreign: BTreeMap<&'static str, u32>,
    /// Compile as they are.
    at_once: u32,
    compiling: BTreeSet<String>,
    /// Compile once the values are filled in.
    after: u32,
    /// Programs that were not tried to their ends, and why.
    cut_off: Vec<(String, String)>,
    dialects: BTreeMap<&'static str, u32>,
    needs: Needs,
    tools: BTreeMap<Called, (Hint, BTreeSet<String>, u32)>,
    offsets: Seen<u8>,
    missing: Seen<String>,
    left: BTreeMap<&'static str, Left>,
    lists: Lists,
}

impl Programs {
    /// All but those that others call; where each is called by another one, all.
    fn of(trials: Vec<Trial>) -> Programs {
        let (foreign, trials): (Vec<Trial>, Vec<Trial>) =
            trials.into_iter().partition(|trial| trial.dialect.is_foreign());
        let calls =
            |trial: &Trial| trial.calls.iter().filter(|file| **file != trial.identity).cloned().collect::<Vec<_>>();
        let called: BTreeSet<String> = trials.iter().flat_map(calls).collect();
        let (others, main): (Vec<Trial>, Vec<Trial>) =
            trials.into_iter().partition(|trial| called.contains(&trial.identity));
        let mut all = Programs::default();
        foreign.iter().for_each(|trial| *all.foreign.entry(trial.dialect.name).or_default() += 1);
        if main.is_empty() {
            others.into_iter().for_each(|trial| all.take(trial));
            return all;
        }
        all.called = others.len() as u32;
        main.into_iter().for_each(|trial| all.take(trial));
        all
    }

    fn take(&mut self, trial: Trial) {
        self.count += 1;
        *self.dialects.entry(trial.dialect.name).or_default() += 1;
        match (trial.left.is_empty(), trial.rounds) {
            (true, 0) if !trial.is_open => {
                self.at_once += 1;
                self.compiling.insert(trial.name.clone());
            }
            (true, _) if !trial.is_open => self.after += 1,
            _ => {}
        }
        self.cut_off.extend(trial.cut_off.map(|trouble| (trial.name, trouble)));
        self.needs.join(&trial.needs);
        for (called, hint, what) in trial.tools {
            self.needs.hint(called.to_string(), hint.clone());
            let tool = self.tools.entry(called).or_insert_with(|| (hint, BTreeSet::new(), 0));
            tool.1.extend(what.split(", ").filter(|what| !what.is_empty()).map(str::to_owned));
            tool.2 += 1;
        }
        for (number, place) in trial.offsets {
            self.offsets.entry(number).or_insert_with(|| (place, 0)).1 += 1;
        }
        for (name, place) in trial.missing {
            self.missing.entry(name).or_insert_with(|| (place, 0)).1 += 1;
        }
        for (code, place) in trial.left {
            self.left.entry(code).or_default().take(place);
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
        text += "\n";
        text += &self.asked();
        self.rest(&mut text);
        text
    }

    /// The keys that wait for a value.
    fn asked(&self) -> String {
        let number = |called: &Called| match called {
            Called::Number(number) => Some(*number),
            Called::Name(_) => None,
        };
        let taken = self.tools.keys().filter_map(number).collect();
        let listed = |section: &str, key: &str| {
            self.lists.get(&(section.to_owned(), key.to_owned())).cloned().unwrap_or_default()
        };
        self.needs.toml(Form::Commented, &taken, &listed)
    }

    fn head(&self) -> String {
        let mut text = format!(
            "# Written by `partc init` from {}: {}.\n",
            counted(self.count, "program", "programs"),
            listed(&self.dialects)
        );
        let after = self.at_once + self.after;
        let _ = writeln!(
            text,
            "# {} as it is, {after} once the values below are filled in.",
            counted(self.at_once, "compiles", "compile")
        );
        if self.called > 0 {
            let files = counted(self.called, "more file is", "more files are");
            let _ = writeln!(text, "# {files} called by these programs, and not counted.");
        }
        if !self.foreign.is_empty() {
            let kinds = listed(&self.foreign);
            let _ = writeln!(
                text,
                "# Not part programs of these controls, and not counted: {kinds} (`partc check` says which)."
            );
        }
        text += "# Lines with `#key =` wait for you: write the value and take the `#` away. Each names the block that asks for it.\n";
        text
    }

    /// What the programs use and what needs no answer.
    fn seen(&self, text: &mut String) {
        if !self.tools.is_empty() {
            *text += "#\n# Tools that are called:\n";
        }
        for (called, (hint, what, programs)) in &self.tools {
            let what = what.iter().cloned().collect::<Vec<_>>().join(", ");
            let what = if what.is_empty() { "moves only".to_owned() } else { what };
            let _ = writeln!(text, "#   {called}: {what}; {}{}", at(&hint.call), more(*programs));
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
        for (program, trouble) in &self.cut_off {
            let _ = writeln!(text, "\n# Not tried to its end: {program}: {trouble}");
        }
        if self.left.is_empty() {
            return;
        }
        *text += "\n# What is left whatever is filled in (`partc explain CODE` says why):\n";
        let mut left: Vec<_> = self.left.iter().collect();
        left.sort_by_key(|(code, left)| (std::cmp::Reverse(left.programs), **code));
        for (code, left) in left.iter().take(MOST_LEFT) {
            let title = codes::find(code).map_or("", |code| code.title);
            let programs = counted(left.programs, "program", "programs");
            let _ = writeln!(text, "#   {code} {title}: {programs}, {}", left.named());
        }
        if left.len() > MOST_LEFT {
            let _ = writeln!(text, "#   … and {} more codes", left.len() - MOST_LEFT);
        }
    }
}

/// `3 Fanuc or Haas, 1 C or C++`
fn listed(kinds: &BTreeMap<&'static str, u32>) -> String {
    let kinds: Vec<String> = kinds.iter().map(|(name, count)| format!("{count} {name}")).collect();
    kinds.join(", ")
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
