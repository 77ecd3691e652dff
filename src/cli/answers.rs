//! Keys of `partc.toml` that findings ask for: gathered over programs, merged, and written as lines of the file.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use crate::diag::{Answer, Code, Severity, Values};
use crate::driver::Session;
use crate::machine::keys::SECTIONS;

use super::need::{FREE, Form, Need, Place, WIDTH, is_promise, line};
use super::tool_hints::Hint;
use super::tool_lines::{ToolLine, tool_lines};

/// Numbers handed out while a program is tried that calls tools by name.
const FIRST_TRIED: u32 = 9001;
/// Work offsets handed out while a program is tried, from the last on: programs name the first ones themselves.
const TRIED_OFFSETS: [&str; 9] = ["G59.3", "G59.2", "G59.1", "G59", "G58", "G57", "G56", "G55", "G54"];

/// A key, the finding that asks for it, and where.
#[derive(Debug, Clone)]
pub(super) struct Request {
    pub answer: Answer,
    /// `None` where no finding asks, but what the program looks like.
    pub code: Option<&'static Code>,
    pub place: Place,
}

/// What the errors of a session ask for. `folder_of` names the folder of a file, by the key of its root, where it is known.
pub(super) fn requests(session: &Session, folder_of: &dyn Fn(&str) -> Option<(String, String)>) -> Vec<Request> {
    let mut list = Vec::new();
    session.diags.each(|found| {
        if found.severity != Severity::Error {
            return;
        }
        let place = Place::new(found.label.loc, session);
        let request = |answer| Request { answer, code: Some(found.code), place: place.clone() };
        let folder = found.answers.iter().find_map(|answer| match &answer.values {
            Values::FolderOf(files) => files.iter().find_map(|file| folder_of(file)),
            _ => None,
        });
        match folder {
            Some((root, folder)) => {
                let folder = format!("\"{folder}\"");
                list.push(request(Answer::entry("include", "roots", root).one_of(&[folder])));
            }
            None => {
                // How far a run may go is no question of the machine, and a loop without an end asks for ever more.
                let is_asked =
                    |answer: &&Answer| !matches!(answer.values, Values::FolderOf(_)) && answer.section != "limits";
                let known = found.answers.iter().filter(is_asked);
                list.extend(known.cloned().map(request));
            }
        }
    });
    list
}

/// A key among those that are asked for: place of its section, and its path.
pub(super) type NeedKey = (usize, Vec<String>);

/// The keys that are asked for.
#[derive(Debug, Clone, Default)]
pub(super) struct Needs {
    map: BTreeMap<NeedKey, Need>,
    /// Choices that are tried, by key: others than the first.
    tried: BTreeMap<NeedKey, usize>,
    /// Values that the user gave, as TOML.
    given: BTreeMap<NeedKey, String>,
    /// Tools that are called by name, in the order in which they were met.
    names: Vec<String>,
    /// What programs say of tools, by number or name.
    hints: BTreeMap<String, Hint>,
}

/// A key, and what a user has to know to answer.
#[derive(Debug, Default)]
pub(super) struct Question {
    pub key: String,
    pub name: String,
    pub about: Vec<String>,
    /// The value that the program itself says, as TOML.
    pub offered: Option<String>,
    choices: Vec<String>,
    pub places: String,
}

impl Question {
    /// What somebody typed, as TOML: one of the choices may stand without its quotes.
    pub fn as_toml(&self, said: &str) -> String {
        let quoted = format!("\"{said}\"");
        if self.choices.contains(&quoted) { quoted } else { said.to_owned() }
    }
}

impl Needs {
    pub fn is_empty(&self) -> bool {
        self.map.is_empty()
    }

    pub fn len(&self) -> usize {
        self.map.len()
    }

    /// Each other choice that could be tried, one key at a time.
    pub fn alternatives(&self) -> Vec<Needs> {
        let mut list = Vec::new();
        for (key, need) in &self.map {
            let now = self.tried.get(key).copied().unwrap_or(0);
            for at in (0..need.choices().len()).filter(|at| *at != now) {
                let mut other = self.clone();
                other.tried.insert(key.clone(), at);
                list.push(other);
            }
        }
        list
    }

    /// The keys without a value, what most programs ask for first.
    pub fn open(&self) -> Vec<NeedKey> {
        let mut keys: Vec<&NeedKey> = self.map.keys().filter(|key| !self.given.contains_key(*key)).collect();
        keys.sort_by_key(|key| std::cmp::Reverse(self.programs(key).len()));
        keys.into_iter().cloned().collect()
    }

    /// Programs that ask for a key.
    pub fn programs(&self, key: &NeedKey) -> &BTreeSet<String> {
        static NONE: BTreeSet<String> = BTreeSet::new();
        self.map.get(key).map_or(&NONE, |need| &need.programs)
    }

    pub fn give(&mut self, key: &NeedKey, value: String) {
        self.given.insert(key.clone(), value);
    }

    /// The keys that have a value of the user.
    pub fn only_given(&self) -> Needs {
        let mut given = self.clone();
        given.map.retain(|key, _| self.given.contains_key(key));
        given
    }

    /// Takes what a program says of a tool, unless another one said something before.
    pub fn hint(&mut self, tool: String, hint: Hint) {
        match self.hints.entry(tool) {
            Entry::Vacant(free) => drop(free.insert(hint)),
            Entry::Occupied(mut known) if known.get().words().is_empty() && !hint.words().is_empty() => {
                known.insert(hint);
            }
            Entry::Occupied(_) => {}
        }
    }

    /// What is said of the tool that a key belongs to. Edges of a tool are `5.2`.
    pub fn hint_of(&self, need: &Need) -> Option<&Hint> {
        let tool = need.answer.path.first().filter(|_| need.answer.is_of_tool())?;
        self.hints.get(tool).or_else(|| self.hints.get(tool.split_once('.')?.0))
    }

    /// What the user said of a field of a tool.
    pub fn of_tool(&self, need: &Need) -> Option<&str> {
        let found = self.given.iter().find(|(key, _)| key.1 == need.answer.path && self.map.contains_key(*key));
        found.map(|(_, value)| value.as_str()).filter(|_| need.answer.is_of_tool())
    }

    /// A key as it is asked for.
    pub fn question(&self, key: &NeedKey) -> Question {
        let Some(need) = self.map.get(key) else { return Question::default() };
        let (section, name) = match need.answer.is_of_tool() {
            true => (format!("tools.{}", need.answer.path[0]), need.answer.path[1].clone()),
            false => need.answer.place(),
        };
        let choices = need.choices();
        let mut about = Vec::new();
        match &choices[..] {
            [_, _, ..] => about.push(choices.join(" or ")),
            [only] if is_promise(need) => about.push(format!("{only}, if that is so")),
            _ => about.push(need.wanted().trim_end_matches("; ").to_owned()),
        }
        let hint = self.hint_of(need).filter(|_| section.starts_with("tools."));
        about.extend(hint.map(Hint::words).filter(|words| !words.is_empty()));
        let offered = match (&need.answer.values, &choices[..]) {
            (Values::Item(_), _) if self.doubted(need).is_empty() => Some(format!("[{}]", need.items().join(", "))),
            (_, [only]) if !is_promise(need) => Some(only.clone()),
            // What a comment says is a hint; what is offered would be a guess.
            _ => None,
        };
        Question { key: format!("[{section}] {name}"), name, about, offered, choices, places: need.places() }
    }

    /// Items of a list that may belong to another key: an M function that is passed, or changes the tool.
    fn doubted(&self, need: &Need) -> Vec<String> {
        let changing = self.map.values().find(|other| other.answer.path[0] == "tool_change_m");
        let (Some(changing), "pass_m") = (changing, need.answer.path[0].as_str()) else { return Vec::new() };
        let changing = changing.choices();
        need.items().into_iter().filter(|item| changing.contains(&format!("[{item}]"))).collect()
    }

    /// Takes what `program` asks for. True if one of it is new.
    pub fn take(&mut self, program: &str, requests: &[Request]) -> bool {
        let mut is_new = false;
        for request in requests {
            let answer = self.by_name(&request.answer);
            let section = SECTIONS.iter().position(|section| section.name == answer.section).unwrap_or(SECTIONS.len());
            let values = answer.values.clone();
            // A name that a variable without value stands for.
            if answer.path.iter().any(|name| name.trim_matches('"').is_empty()) {
                continue;
            }
            let need = self.map.entry((section, answer.path.clone())).or_insert_with(|| {
                is_new = true;
                Need {
                    answer,
                    values: BTreeSet::new(),
                    first: request.place.clone(),
                    programs: BTreeSet::new(),
                    codes: BTreeSet::new(),
                }
            });
            let more = matches!(need.answer.values, Values::Item(_)) || need.answer.section == "programs";
            is_new |= need.values.insert(values) && more;
            need.programs.insert(program.to_owned());
            need.codes.extend(request.code.map(|code| code.id));
        }
        is_new
    }

    /// Takes over what another list holds.
    pub fn join(&mut self, other: &Needs) {
        for (key, need) in &other.map {
            match self.map.get_mut(key) {
                Some(own) => {
                    own.values.extend(need.values.iter().cloned());
                    own.programs.extend(need.programs.iter().cloned());
                    own.codes.extend(need.codes.iter().copied());
                }
                None => {
                    self.map.insert(key.clone(), need.clone());
                }
            }
        }
        for (tool, hint) in &other.hints {
            self.hint(tool.clone(), hint.clone());
        }
        for name in &other.names {
            if !self.names.contains(name) {
                self.names.push(name.clone());
            }
        }
    }

    /// The tool that is called by name and was tried with this number, as TOML writes it.
    pub fn name_of(&self, number: u32) -> Option<&str> {
        self.names.get(number.checked_sub(FIRST_TRIED)? as usize).map(String::as_str)
    }

    /// Is this word one that a program was tried with?
    pub fn is_tried_offset(&self, word: &str) -> bool {
        let datums = |need: &&Need| {
            need.answer.section == "datums" && need.answer.values != Values::Coordinates && need.choices().is_empty()
        };
        let tried = self.map.values().filter(datums).count();
        TRIED_OFFSETS.iter().take(tried).any(|given| *given == word)
    }

    /// The request with the name of a tool in place of the number that it was tried with.
    pub fn by_its_name(&mut self, request: Request) -> Request {
        Request { answer: self.by_name(&request.answer), ..request }
    }

    /// A tool that is called by name is known by it: which number it gets, only the user says.
    fn by_name(&mut self, answer: &Answer) -> Answer {
        let mut answer = answer.clone();
        if !answer.is_of_tool() {
            return answer;
        }
        if let (Values::OneOf(values), Some("name")) = (&answer.values, answer.path.get(1).map(String::as_str)) {
            let name = values[0].clone();
            if !self.names.contains(&name) {
                self.names.push(name.clone());
            }
            answer.path[0] = name;
        } else if let Ok(number) = answer.path[0].parse::<u32>()
            && let Some(name) = self.name_of(number)
        {
            answer.path[0] = name.to_owned();
        }
        answer
    }

    /// The keys as a part of `partc.toml`. `taken` are numbers of tools that programs call, `listed` items that lists hold
    /// already.
    pub fn toml(&self, form: Form, taken: &BTreeSet<u32>, listed: &dyn Fn(&str, &str) -> Vec<String>) -> String {
        let mut text = String::new();
        for (at, section) in SECTIONS.iter().enumerate() {
            let needs: Vec<&Need> = self.map.iter().filter(|(key, _)| key.0 == at).map(|(_, need)| need).collect();
            if needs.is_empty() {
                continue;
            }
            let (of_tools, others): (Vec<&Need>, Vec<&Need>) =
                needs.into_iter().partition(|need| need.answer.is_of_tool());
            if !others.is_empty() {
                self.section(&mut text, form, (at, section.name), &others, listed);
            }
            if !of_tools.is_empty() {
                self.tools(&mut text, form, &of_tools, taken);
            }
        }
        text
    }

    /// A section and its keys; `at` is its place among all.
    fn section(
        &self,
        text: &mut String,
        form: Form,
        (at, name): (usize, &str),
        needs: &[&Need],
        listed: &dyn Fn(&str, &str) -> Vec<String>,
    ) {
        let _ = writeln!(text, "{}[{name}]", if text.is_empty() { "" } else { "\n" });
        let mut offsets = TRIED_OFFSETS.iter().chain(std::iter::repeat(&"G54"));
        for need in needs {
            let is_given = self.given.contains_key(&(at, need.answer.path.clone()));
            let word = need.answer.values != Values::Coordinates && need.choices().is_empty() && !is_given;
            if form == Form::Tried && name == "datums" && word {
                let word = offsets.next().unwrap_or(&"G54");
                let _ = writeln!(text, "{} = \"{word}\"", need.answer.place().1);
                continue;
            }
            let key = (at, need.answer.path.clone());
            let choice = self.tried.get(&key).copied().unwrap_or(0);
            let given = self.given.get(&key).map(String::as_str);
            let doubted = if form == Form::Tried { Vec::new() } else { self.doubted(need) };
            line(text, form, need, (choice, given), (&doubted, &|key| listed(name, key)));
        }
    }

    fn tools<'n>(&'n self, text: &mut String, form: Form, needs: &[&'n Need], taken: &BTreeSet<u32>) {
        let mut by_tool: BTreeMap<(bool, u32, &str), Vec<&Need>> = BTreeMap::new();
        for need in needs {
            let tool = need.answer.path[0].as_str();
            by_tool.entry((tool.parse::<f64>().is_err(), tool.parse().unwrap_or(0), tool)).or_default().push(need);
        }
        let own: BTreeSet<u32> = by_tool.keys().filter(|key| !key.0).map(|key| key.1).collect();
        let mut free = (1..).filter(|n| !taken.contains(n) && !own.contains(n));
        let heads = by_tool.keys().map(|(named, _, tool)| match named {
            true => {
                let tried = self.names.iter().position(|name| name == tool).unwrap_or(0) as u32 + FIRST_TRIED;
                let number = if form == Form::Tried { tried } else { free.next().unwrap_or(tried) };
                (true, number.to_string())
            }
            false if tool.contains('.') => (false, format!("\"{tool}\"")),
            false => (false, (*tool).to_owned()),
        });
        let heads: Vec<(bool, String)> = heads.collect();
        if form == Form::Commented {
            let line = |((is_named, head), needs): ((bool, String), Vec<&'n Need>)| ToolLine {
                is_named,
                head,
                hint: self.hint_of(needs[0]),
                needs: needs.into_iter().map(|need| (need, self.of_tool(need))).collect(),
            };
            return tool_lines(text, heads.into_iter().zip(by_tool.into_values()).map(line).collect());
        }
        for ((is_named, head), ((_, _, tool), needs)) in heads.into_iter().zip(by_tool) {
            let _ = write!(text, "{}", if text.is_empty() { "" } else { "\n" });
            let head = format!("[tools.{head}]");
            match (is_named, form) {
                (true, Form::Tried) => drop(writeln!(text, "{head}\nname = {tool}")),
                (true, _) => drop(writeln!(text, "{head:WIDTH$} # {FREE}")),
                (false, _) => drop(writeln!(text, "{head}")),
            }
            for need in needs.into_iter().filter(|need| form != Form::Tried || need.answer.path[1] != "name") {
                line(text, form, need, (0, self.of_tool(need)), (&[], &|_| Vec::new()));
            }
        }
    }
}
