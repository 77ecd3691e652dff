//! A program that `partc init` tries: what it asks for gets some value, so that the run goes on to what else is missing.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use crate::diag::{Answer, Diagnostic, Severity, codes};
use crate::dialect::{self, Dialect};
use crate::driver::Session;
use crate::machine::tree::{Table, Value, overlay, parse};
use crate::machine::{MachineKind, Settings};
use crate::text::FileId;

use super::answers::{Needs, Request, requests};
use super::inputs::{Ignored, walk};
use super::need::{Form, Place, can_be_tried};
use super::options::Common;
use super::program::{Loaded, load_with};
use super::tool_hints::Hint;
use super::{Trouble, config};

/// Most times that a program is tried: what is answered lets the run go on to what else is missing.
const MOST_ROUNDS: usize = 8;
/// Most choices of keys that are tried besides the first ones.
const MOST_CHOICES: usize = 12;
/// What a program may ask for in all: more of it is one fault, or none that anybody answers, and each round would find as much again.
const MOST_ASKED: usize = 1000;
/// Steps of a trial: what runs longer is cut off.
const STEPS: u64 = 200_000;
/// What a program asks for once all that it asks for is answered.
pub(super) fn requests_of(path: &Path, common: &Common) -> Result<Vec<Request>, Trouble> {
    let base = Base { folder: PathBuf::from("."), lies_in: BTreeMap::new(), hidden: None };
    Ok(Trial::of(path, &base, common)?.requests)
}

/// Where the new configuration lies, and the files below it.
pub(super) struct Base {
    pub folder: PathBuf,
    /// Folders of the files, by upper-case name.
    pub lies_in: BTreeMap<String, BTreeSet<PathBuf>>,
    /// An older configuration, of which nothing stays.
    pub hidden: Option<PathBuf>,
}

impl Base {
    /// The folder that holds this file, and the key of a root for it: the only one, or the one that a SINUMERIK searches
    /// first.
    fn root_of(&self, file: &str) -> Option<(String, String)> {
        let folders = self.lies_in.get(&file.to_uppercase())?;
        let (_, extension) = file.rsplit_once('.')?;
        let extension = extension.to_ascii_lowercase();
        let below = |folder: &Path| folder.to_string_lossy().replace('\\', "/");
        // Definitions count in one folder of the control only.
        let searched = match &extension[..] {
            "spf" => SEARCHED,
            "def" => DEFINITIONS,
            _ => &[],
        };
        // Of two copies of one folder nobody knows which is meant.
        let copies = |path: &str| folders.iter().filter(|folder| is_copy_of(folder, path)).collect::<Vec<_>>();
        if let Some((path, list)) = searched.iter().map(|path| (path, copies(path))).find(|(_, list)| !list.is_empty())
        {
            let [folder] = list[..] else { return None };
            return Some(((*path).to_owned(), below(folder)));
        }
        let mut folders = folders.iter();
        let (Some(folder), None) = (folders.next(), folders.next()) else { return None };
        let name = folder.file_name()?.to_string_lossy().to_uppercase();
        let root = match (&extension[..], searched.first()) {
            ("h", _) => format!("TNC:/{}", below(folder)),
            // No workpiece is searched for a subprogram, and a folder that stands for another one stays what it is.
            (_, Some(_)) if name.ends_with(".WPD") || name.ends_with("_WPD") => return None,
            (_, Some(first)) if self.holds_copy_of(first) => return None,
            (_, Some(first)) => (*first).to_owned(),
            ("mpf", None) => return None,
            (_, None) => format!("/_N_{}_DIR", name.strip_suffix(".DIR").unwrap_or(&name)),
        };
        Some((root, below(folder)))
    }

    /// Is one of the folders a copy of this one of the control?
    fn holds_copy_of(&self, path: &str) -> bool {
        self.lies_in.values().flatten().any(|folder| is_copy_of(folder, path))
    }
}

/// Folders in which a SINUMERIK looks for a subprogram beside that of the main program, in its order.
const SEARCHED: &[&str] = &["/_N_SPF_DIR", "/_N_CUS_DIR", "/_N_CMA_DIR", "/_N_CST_DIR"];
/// The one in which it looks for definitions.
const DEFINITIONS: &[&str] = &["/_N_DEF_DIR"];

/// Is the folder called as a copy of this one of the control is?
fn is_copy_of(folder: &Path, path: &str) -> bool {
    let name = folder.file_name().map(|folder| folder.to_string_lossy()).unwrap_or_default();
    let mut known = dialect::ALL.iter().flat_map(|dialect| dialect.folders);
    known.any(|folder| folder.path == path && folder.is_copied_as(&name))
}

/// The files in folders below `folder`.
pub(super) fn index(folder: &Path) -> BTreeMap<String, BTreeSet<PathBuf>> {
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

/// How a program calls a tool.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Called {
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
pub(super) struct Trial {
    pub name: String,
    pub dialect: &'static Dialect,
    pub needs: Needs,
    /// Its tools, with what they do.
    pub tools: Vec<(Called, Hint, String)>,
    pub offsets: Vec<(u8, Place)>,
    /// Called programs that no key stands for.
    pub missing: Vec<(String, Place)>,
    /// What it is, and what it calls: what tells files apart.
    pub identity: String,
    pub calls: Vec<String>,
    /// Errors of the last round, none for a program that compiles.
    pub left: Vec<(&'static str, Place)>,
    /// It asks for the name of a file, so that nobody knows what it comes to.
    pub is_open: bool,
    /// Why it was not tried to its end.
    pub cut_off: Option<String>,
    pub rounds: usize,
    /// What every round asked for.
    requests: Vec<Request>,
    pub lists: Lists,
}

impl Trial {
    /// Tries the program, answers what it asks for with some value, and tries it again, until it asks for nothing new. Where
    /// something is left then, other choices of its keys are tried.
    pub fn of(path: &Path, folder: &Base, common: &Common) -> Result<Trial, Trouble> {
        let tried = Tried::new(path, folder, common)?;
        let mut trial = tried.answered(Needs::default())?;
        let mut left = MOST_CHOICES;
        while !trial.left.is_empty() && trial.requests.len() < MOST_ASKED {
            let mut better = None;
            for needs in trial.needs.alternatives() {
                if left == 0 {
                    return Ok(trial);
                }
                left -= 1;
                // What does not go together is no answer.
                let Ok(other) = tried.answered(needs) else { continue };
                if other.left.len() < trial.left.len() {
                    better = Some(other);
                    break;
                }
            }
            let Some(other) = better else { break };
            let requests = std::mem::take(&mut trial.requests);
            trial = Trial { requests: requests.into_iter().chain(other.requests).collect(), ..other };
        }
        Ok(trial)
    }
}

/// A program that is tried.
pub(super) struct Tried<'a> {
    path: &'a Path,
    folder: &'a Base,
    common: &'a Common,
    tree: Table,
    /// Lists of its configuration that findings add to.
    lists: Lists,
}

pub(super) type Lists = BTreeMap<(String, String), Vec<String>>;

impl<'a> Tried<'a> {
    pub fn new(path: &'a Path, folder: &'a Base, common: &'a Common) -> Result<Tried<'a>, Trouble> {
        let tree = config::tree_beyond(folder.hidden.as_deref(), path, common)?;
        Ok(Tried { path, folder, common, lists: lists(&config::settings_of(&tree, common)?), tree })
    }

    /// What it comes to once all is answered that it asks for, beginning with `needs`.
    fn answered(&self, mut needs: Needs) -> Result<Trial, Trouble> {
        let name = self.path.display().to_string();
        let mut requests: Vec<Request> = Vec::new();
        let mut last: Option<Trial> = None;
        let mut not_found = None;
        for round in 0.. {
            let mut trial = match (self.once(&needs), last.take()) {
                (Ok(trial), _) => trial,
                // What was made up is no configuration: what the program came to before says as much as is known.
                (Err(trouble), Some(last)) => {
                    return Ok(Trial { needs, requests, cut_off: Some(trouble), lists: self.lists.clone(), ..last });
                }
                (Err(trouble), None) => return Err(trouble),
            };
            // What was not found at first is not there, whatever stands for it.
            match &not_found {
                Some(missing) => trial.missing = Vec::clone(missing),
                None => not_found = Some(trial.missing.clone()),
            }
            let is_new = needs.take(&name, &trial.requests);
            requests.extend(trial.requests.drain(..).map(|request| needs.by_its_name(request)));
            let is_enough = round + 1 == MOST_ROUNDS || requests.len() >= MOST_ASKED;
            if !is_new || trial.left.is_empty() || is_enough {
                return Ok(Trial { needs, requests, rounds: round, lists: self.lists.clone(), ..trial });
            }
            last = Some(trial);
        }
        Err("nothing was tried".to_owned())
    }

    /// One run with some value for each of `needs`.
    pub fn once(&self, needs: &Needs) -> Result<Trial, Trouble> {
        let settings = self.settings(needs)?;
        let Loaded { session, dialect, settings, files, .. } = load_with(self.path, self.common, settings)?;
        let uses = session.uses(dialect, &settings, &files);
        files.unchanged()?;
        let place = |loc| Place::new(loc, &session);
        let mut asked = requests(&session, &|file| self.folder.root_of(file));
        // A constant cutting speed looks like a lathe; only the user knows.
        let is_open = !said(&self.tree, "machine", "kind");
        if let Some(loc) = uses.cutting_speed
            && settings.machine.kind == MachineKind::Mill
            && !dialect.turns
            && is_open
        {
            let answer = Answer::key("machine", "kind").one_of(&["\"lathe\"", "\"mill\""]);
            asked.push(Request { answer, code: None, place: place(loc) });
        }
        let tools = uses.tools.iter().filter(|(number, _)| **number != 0).map(|(number, tool)| {
            let mut what: Vec<String> = tool.cycles.iter().map(|family| words(family)).collect();
            what.extend(tool.compensated.then(|| "radius compensation".to_owned()));
            let hint = Hint::new(*number, needs.name_of(*number), tool.first, &session);
            (Called::of(*number, needs), hint, what.join(", "))
        });
        let offsets = uses.offsets.iter().filter(|(number, _)| !needs.is_tried_offset(&offset(**number)));
        Ok(Trial {
            name: self.path.display().to_string(),
            dialect,
            needs: Needs::default(),
            tools: tools.collect(),
            offsets: offsets.map(|(number, loc)| (*number, place(*loc))).collect(),
            missing: missing(&session),
            identity: session.sources.identity(FileId(0)),
            calls: (1..session.sources.len()).map(|file| session.sources.identity(FileId(file as u16))).collect(),
            left: errors(&session),
            is_open: asks_for_a_name(&session),
            cut_off: None,
            rounds: 0,
            requests: asked,
            lists: Lists::new(),
        })
    }

    /// The settings with some value for all that is asked for.
    pub fn settings(&self, needs: &Needs) -> Result<Settings, Trouble> {
        let listed = |section: &str, key: &str| {
            self.lists.get(&(section.to_owned(), key.to_owned())).cloned().unwrap_or_default()
        };
        let text = needs.toml(Form::Tried, &BTreeSet::new(), &listed);
        let mut tree = self.tree.clone();
        let mut over = parse(&text, "what is tried").map_err(|error| error.to_string())?;
        config::make_absolute(&mut over, &self.folder.folder);
        overlay(&mut tree, over);
        let mut settings = config::settings_of(&tree, self.common)?;
        settings.limits.steps = settings.limits.steps.min(STEPS);
        Ok(settings)
    }
}

/// Lists of the configuration that findings add to.
fn lists(settings: &Settings) -> Lists {
    let m = settings.output.pass_m.iter().map(ToString::to_string).collect();
    BTreeMap::from([(("output".to_owned(), "pass_m".to_owned()), m)])
}

/// Does the configuration say this key?
fn said(tree: &Table, section: &str, key: &str) -> bool {
    matches!(tree.get(section).map(|node| &node.value), Some(Value::Table(table)) if table.contains_key(key))
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

/// Does an error ask for what no trial can make up?
fn asks_for_a_name(session: &Session) -> bool {
    session.diags.any(|found| found.severity == Severity::Error && is_untried(found))
}

/// Is it answered by nothing but what no trial can make up: the name of a file, a folder?
fn is_untried(found: &Diagnostic) -> bool {
    !found.answers.is_empty() && !found.answers.iter().any(can_be_tried)
}

/// Codes of the errors that no answer mends, as far as a trial shows, each once.
fn errors(session: &Session) -> Vec<(&'static str, Place)> {
    let mut list: Vec<(&'static str, Place)> = Vec::new();
    session.diags.each(|found| {
        let is_known = list.iter().any(|(code, _)| *code == found.code.id);
        // A trial is cut off early.
        if found.severity == Severity::Error && found.code.id != codes::P4001.id && !is_known && !is_untried(found) {
            list.push((found.code.id, Place::new(found.label.loc, session)));
        }
    });
    list
}

/// The word of a work offset, 1 (G54) to 9 (G59.3), and on.
pub(super) fn offset(number: u8) -> String {
    match number {
        1..=6 => format!("G{}", 53 + number),
        10.. => format!("G54.1 P{}", number - 6),
        n => format!("G59.{}", n.saturating_sub(6)),
    }
}
