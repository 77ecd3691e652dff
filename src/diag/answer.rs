//! What of `partc.toml` answers a finding: the one source of `partc init`, of the lines to paste, and of the summary.

use std::borrow::Cow;
use std::fmt::Display;

/// A key that a finding asks for, and the values that would answer it.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Answer {
    /// Table of the file: `control`, `tools`.
    pub section: &'static str,
    /// Names below it, the key last: `["feed"]`, `["5", "radius"]`.
    pub path: Vec<String>,
    pub values: Values,
}

/// What may stand behind the key.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Values {
    /// Only the user knows; what kind of value it is, the key says.
    Open,
    /// Only the user knows; what the number means.
    Meaning(String),
    /// One more item of a list, as TOML.
    Item(String),
    /// One of these, as TOML; a single one is what the program itself says.
    OneOf(Vec<String>),
    /// The folder that holds one of these files.
    FolderOf(Vec<String>),
    /// Machine coordinates: `{ X = 0.0, Y = 0.0, Z = 0.0 }`.
    Coordinates,
}

impl Answer {
    /// A key whose value only the user knows.
    pub fn key(section: &'static str, key: impl Display) -> Answer {
        Answer { section, path: vec![key.to_string()], values: Values::Open }
    }

    /// A key of a table whose name the program says.
    pub fn entry(section: &'static str, name: impl Display, key: impl Display) -> Answer {
        Answer { section, path: vec![name.to_string(), key.to_string()], values: Values::Open }
    }

    /// The table and the key, as TOML writes them: `tools.5` and `radius`, `machine` and `axes.B1`.
    pub fn place(&self) -> (String, String) {
        match &self.path[..] {
            [name, key] if self.section == "tools" => (format!("tools.{}", toml_key(name)), toml_key(key)),
            path => (self.section.to_owned(), path.iter().map(|key| toml_key(key)).collect::<Vec<_>>().join(".")),
        }
    }

    /// Is it a field of one tool, and none of all of them?
    pub fn is_of_tool(&self) -> bool {
        self.section == "tools" && self.path.len() == 2
    }

    /// The value of a variable, and what it means on the control.
    pub fn variable(name: impl Display, meaning: impl Into<String>) -> Answer {
        let meaning = meaning.into();
        let values = if meaning.is_empty() { Values::Open } else { Values::Meaning(meaning) };
        Answer { values, ..Answer::key("variables", name) }
    }

    /// Where a datum lies, in machine coordinates.
    pub fn datum(name: impl Display) -> Answer {
        Answer { values: Values::Coordinates, ..Answer::key("datums", name) }
    }

    /// A field of a tool.
    pub fn tool(tool: impl Display, field: &'static str) -> Answer {
        Answer::entry("tools", tool, field)
    }

    /// The folder of a file that is called, under any of these names.
    pub fn folder_of(names: &[impl AsRef<str>]) -> Answer {
        let names: Vec<String> = names.iter().map(|name| name.as_ref().to_owned()).collect();
        let first = names.first().cloned().unwrap_or_default();
        Answer { values: Values::FolderOf(names), ..Answer::entry("include", "roots", first) }
    }

    /// An M function that is printed as it stands.
    pub fn pass_m(number: impl Display) -> Answer {
        Answer::item("output", "pass_m", number.to_string())
    }

    /// An M function that changes the tool.
    pub fn changing_m(number: impl Display) -> Answer {
        Answer::key("control", "tool_change_m").one_of(&[format!("[{number}]")])
    }

    /// One more item of a list.
    pub fn item(section: &'static str, key: &'static str, item: String) -> Answer {
        Answer { values: Values::Item(item), ..Answer::key(section, key) }
    }

    /// The value that answers, or one of several.
    pub fn one_of(mut self, values: &[impl AsRef<str>]) -> Answer {
        self.values = Values::OneOf(values.iter().map(|value| value.as_ref().to_owned()).collect());
        self
    }

    /// The help of a finding, in words.
    pub fn help(self, text: impl Into<String>) -> Help {
        Help { text: text.into(), answers: vec![self] }
    }
}

/// A key of TOML: bare where it can be.
fn toml_key(name: &str) -> String {
    let bare = !name.is_empty() && name.bytes().all(|b| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'-'));
    if bare {
        return name.to_owned();
    }
    let harmless: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    format!("\"{}\"", harmless.replace('\\', "\\\\").replace('"', "\\\""))
}

/// What to do about a finding: in words, and what of it a configuration can say.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Help {
    pub text: String,
    pub answers: Vec<Answer>,
}

impl Help {
    /// A further key that the finding needs.
    pub fn and(mut self, answer: Answer) -> Help {
        self.answers.push(answer);
        self
    }

    /// The text goes on: what else may be done.
    pub fn or(mut self, more: Help) -> Help {
        self.text += &more.text;
        self.answers.extend(more.answers);
        self
    }
}

impl From<String> for Help {
    fn from(text: String) -> Help {
        Help { text, answers: Vec::new() }
    }
}

impl From<&str> for Help {
    fn from(text: &str) -> Help {
        text.to_owned().into()
    }
}

impl From<&String> for Help {
    fn from(text: &String) -> Help {
        text.clone().into()
    }
}

impl From<Cow<'_, str>> for Help {
    fn from(text: Cow<'_, str>) -> Help {
        text.into_owned().into()
    }
}

impl From<&Help> for Help {
    fn from(help: &Help) -> Help {
        help.clone()
    }
}
