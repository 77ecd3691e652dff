//! What the cycles of the controls take: one row a cycle, one row a parameter, in every dialect.
//!
//! A dialect keeps its rows beside the plans that read them by name; the documentation, the parameter tests and hover
//! texts are made of the same rows ([`super::text`]).

use core::fmt;

use crate::diag::codes::told;

/// A cycle and its parameters, in the order of the call.
#[derive(Debug, Clone, Copy)]
pub struct Signature {
    /// As a program writes it: `CYCLE81`, `CYCL DEF 200`, `G869`.
    pub name: &'static str,
    /// What it is, in a few words.
    pub what: &'static str,
    pub status: Status,
    /// Manual and place that the list is from.
    pub source: &'static str,
    pub parameters: &'static [Parameter],
}

/// What partc does with a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    Built,
    /// Its arguments are read and checked, then it is refused.
    Checked {
        code: &'static str,
        why: &'static str,
    },
    /// Known by its name only.
    Refused {
        code: &'static str,
    },
}

/// How a parameter is called.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Name {
    Word(&'static str),
    /// `Q200`
    Q(u32),
    /// Part of a dotted cycle: the `.2` of `CYCL DEF 1.2`.
    Part(u32),
    /// A word in such a part: the `DR` of `CYCL DEF 4.6`.
    In(u32, &'static str),
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Name::Word(name) => f.write_str(name),
            Name::Q(number) => write!(f, "Q{number}"),
            Name::Part(part) => write!(f, ".{part}"),
            Name::In(part, word) => write!(f, ".{part} {word}"),
        }
    }
}

/// A parameter: its name in the manuals, what it is, what it may be.
#[derive(Debug, Clone, Copy)]
pub struct Parameter {
    pub name: Name,
    pub what: &'static str,
    pub kind: Kind,
    /// It has to be there.
    pub needed: bool,
    /// What it has to be where it is given.
    pub rule: Rule,
    /// Newer software has it, or a call may leave it out: what holds then.
    pub default: &'static str,
    /// Why nothing depends on it.
    pub without_effect: Option<&'static str>,
    /// The number that the control shows where it is missing or is not what it has to be; 0 for the usual one.
    pub alarm: u32,
    /// What to do then; empty for the usual advice.
    pub fix: &'static str,
}

/// What a value is, and in which unit.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// A length in the unit of the program.
    Length,
    /// Degrees.
    Angle,
    /// Seconds; below 0 turns of the spindle where the manual says so.
    Dwell,
    /// In the unit of the feed in force.
    Feed,
    /// Turns a minute.
    Speed,
    /// A whole number.
    Count,
    /// A number, or a choice by numbers.
    Number,
    /// A whole number whose decimal digits have a meaning each.
    Digits(&'static Digits),
    /// A text in quotation marks.
    Text,
    /// A text, or a number as its digits.
    Either,
}

/// Digits of a coded number.
#[derive(Debug)]
pub struct Digits {
    pub known: &'static [Digit],
    /// What another place with a digit is refused as; empty: by its place and value.
    pub other: &'static str,
    /// Places whose digit 1 is read in a way that is not confirmed, and the way.
    pub doubt: Option<(&'static [u32], &'static str)>,
    /// Are digits that are not known refused by the row?
    pub checked: bool,
}

/// One place of a coded number.
#[derive(Debug, Clone, Copy)]
pub struct Digit {
    /// From the right: 0 is the units.
    pub place: u32,
    /// Largest digit that is known.
    pub most: i32,
    /// What a larger digit is refused as.
    pub unknown: &'static str,
}

/// Digits of which none is looked at.
pub const ANY_DIGITS: Digits = Digits { known: &[], other: "", doubt: None, checked: false };

/// What a value has to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rule {
    Any,
    /// "Without sign": not below 0.
    Unsigned,
    /// Above 0; the number that the control shows, 0 for none.
    Above(u32),
    /// The same, where 0 is what a field of an editor becomes that was left empty.
    AboveOrEmpty(u32),
    /// A size, whose sign is left out, and which is not 0.
    Size,
    /// An angle of 0 to below 90 degrees.
    Below90,
    /// A whole number between the two.
    OneOf(i32, i32),
}

impl Parameter {
    pub const fn new(name: Name, kind: Kind, what: &'static str) -> Parameter {
        Parameter {
            name,
            what,
            kind,
            needed: false,
            rule: Rule::Any,
            default: "",
            without_effect: None,
            alarm: 0,
            fix: "",
        }
    }

    /// The same, and it has to be there.
    pub const fn needed(self) -> Parameter {
        Parameter { needed: true, ..self }
    }

    /// The same, without sign.
    pub const fn unsigned(self) -> Parameter {
        self.rule(Rule::Unsigned)
    }

    pub const fn rule(self, rule: Rule) -> Parameter {
        Parameter { rule, ..self }
    }

    /// The same, with what the control shows and what to do where it is not so.
    pub const fn or_else(self, alarm: u32, fix: &'static str) -> Parameter {
        Parameter { alarm, fix, ..self }
    }

    /// The same; `default` holds where it is left out.
    pub const fn default(self, default: &'static str) -> Parameter {
        Parameter { default: told(default), ..self }
    }

    /// The same, and nothing depends on it, because of `why`.
    pub const fn without_effect(self, why: &'static str) -> Parameter {
        Parameter { without_effect: Some(told(why)), ..self }
    }
}

pub const fn length(name: &'static str, what: &'static str) -> Parameter {
    Parameter::new(Name::Word(name), Kind::Length, what)
}

pub const fn angle(name: &'static str, what: &'static str) -> Parameter {
    Parameter::new(Name::Word(name), Kind::Angle, what)
}

pub const fn dwell(name: &'static str, what: &'static str) -> Parameter {
    Parameter::new(Name::Word(name), Kind::Dwell, what)
}

pub const fn feed(name: &'static str, what: &'static str) -> Parameter {
    Parameter::new(Name::Word(name), Kind::Feed, what)
}

pub const fn speed(name: &'static str, what: &'static str) -> Parameter {
    Parameter::new(Name::Word(name), Kind::Speed, what)
}

pub const fn count(name: &'static str, what: &'static str) -> Parameter {
    Parameter::new(Name::Word(name), Kind::Count, what)
}

pub const fn number(name: &'static str, what: &'static str) -> Parameter {
    Parameter::new(Name::Word(name), Kind::Number, what)
}

pub const fn digits(name: &'static str, digits: &'static Digits, what: &'static str) -> Parameter {
    Parameter::new(Name::Word(name), Kind::Digits(digits), what)
}

pub const fn words(name: &'static str, what: &'static str) -> Parameter {
    Parameter::new(Name::Word(name), Kind::Text, what)
}

pub const fn either(name: &'static str, what: &'static str) -> Parameter {
    Parameter::new(Name::Word(name), Kind::Either, what)
}
