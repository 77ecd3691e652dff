//! A key of a `partc.toml`: its kind, its default, its meaning.

use crate::machine::settings::Settings;
use crate::machine::tree::{self, ConfigError, Node};

/// What may stand behind a key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Text,
    Flag,
    Number,
    Whole,
    Choice(&'static [&'static str]),
    /// List of whole numbers.
    Wholes,
    /// List of numbers from 0 to 9.
    Digits,
    /// List of texts.
    Texts,
    /// Table whose keys are names.
    Free,
    /// Number of decimal places, or table of them by quantity.
    Places,
    /// `"exact"`, `"none"`, or a table with a tolerance.
    Corners,
    /// List of names, or table of names and what is printed for them.
    Words,
    /// A number, or this text in its place.
    NumberOr(&'static str),
}

/// One key of the configuration.
#[derive(Debug)]
pub struct Key {
    pub name: &'static str,
    pub kind: Kind,
    pub doc: &'static str,
    /// TOML text of the value that holds without the key; empty where none does.
    pub default: &'static str,
    /// Without the key its default is a reading that warns; setting the key confirms it.
    pub warns: bool,
    /// Takes the value over into the settings.
    pub(in crate::machine) set: Set,
}

/// Takes the value of a key, which is of its kind, over into the settings.
pub(in crate::machine) type Set = fn(&mut Settings, &Node) -> Result<(), ConfigError>;

impl Key {
    /// The same key with the value that holds without it.
    pub(in crate::machine) const fn or(self, default: &'static str) -> Key {
        Key { default, ..self }
    }

    /// The same key with the reading that is taken, with a warning, without it.
    pub(in crate::machine) const fn or_warn(self, reading: &'static str) -> Key {
        Key { default: reading, warns: true, ..self }
    }

    /// The default as a node of the tree.
    pub fn default_node(&self) -> Option<Node> {
        let tree = tree::parse(&format!("x = {}", self.default), "default").ok()?;
        tree.into_values().next()
    }
}

/// A key with its kind, its meaning, and what takes its value over.
pub(in crate::machine) const fn key(name: &'static str, kind: Kind, doc: &'static str, set: Set) -> Key {
    Key { name, kind, doc, default: "", warns: false, set }
}

/// A key of a table whose names the user chose: whoever reads the table takes it.
pub(super) const fn part(name: &'static str, kind: Kind, doc: &'static str) -> Key {
    key(name, kind, doc, |_, _| Ok(()))
}
