//! Signatures as text: for the documentation, and beside a call in an editor.

use core::fmt::Write;

use super::row::{Kind, Parameter, Rule, Signature, Status};

impl Kind {
    /// What the value is, with its unit.
    pub fn text(self) -> &'static str {
        match self {
            Kind::Length => "length",
            Kind::Angle => "angle, degrees",
            Kind::Dwell => "dwell, seconds",
            Kind::Feed => "feed",
            Kind::Speed => "speed, turns a minute",
            Kind::Count => "whole number",
            Kind::Number => "number",
            Kind::Digits(_) => "digits",
            Kind::Text => "text",
            Kind::Either => "text or number",
        }
    }
}

impl Parameter {
    /// What the value has to be; empty for anything.
    pub fn rule_text(&self) -> String {
        let rule = match self.rule {
            Rule::Any => String::new(),
            Rule::Unsigned => "without sign".to_owned(),
            Rule::Above(_) | Rule::AboveOrEmpty(_) => "above 0".to_owned(),
            Rule::Size => "not 0".to_owned(),
            Rule::Below90 => "0 to below 90".to_owned(),
            Rule::OneOf(low, high) => format!("{low} to {high}"),
        };
        let needed = if self.needed { "needed" } else { "" };
        [needed, &rule].into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
    }
}

impl Signature {
    /// The cycle as a call, its meaning, and a line for each parameter.
    pub fn describe(&self) -> String {
        let names: Vec<String> = self.parameters.iter().map(|parameter| parameter.name.to_string()).collect();
        let mut shown = if names.is_empty() {
            format!("{}: {}", self.name, self.what)
        } else {
            format!("{}({}): {}", self.name, names.join(", "), self.what)
        };
        match self.status {
            Status::Built => {}
            Status::Checked { code, why } => {
                let _ = write!(shown, "\nnot supported ({code}): {why}");
            }
            Status::Refused { code } => {
                let _ = write!(shown, "\nnot supported ({code})");
            }
        }
        for parameter in self.parameters {
            let _ = write!(shown, "\n{}: {}", parameter.name, parameter.cells().join("; "));
        }
        shown
    }

    /// A section of the documentation with a table of the parameters.
    pub fn section(&self) -> String {
        let mut shown = format!("### {}: {}\n\n", self.name, self.what);
        if let Status::Checked { code, why } = self.status {
            let _ = writeln!(shown, "Not supported ({code}): {why}.\n");
        }
        if !self.source.is_empty() {
            let _ = writeln!(shown, "Source: {}.\n", self.source);
        }
        if !self.parameters.is_empty() {
            shown.push_str(
                "| place | parameter | meaning | kind | rule | left out |\n| --- | --- | --- | --- | --- | --- |\n",
            );
        }
        for (place, parameter) in (1..).zip(self.parameters) {
            let rule = parameter.rule_text();
            let (what, kind) = (parameter.meaning(), parameter.kind.text());
            let _ = writeln!(
                shown,
                "| {place} | `{}` | {what} | {kind} | {rule} | {} |",
                parameter.name, parameter.default
            );
        }
        shown
    }
}

impl Parameter {
    fn meaning(&self) -> String {
        match self.without_effect {
            Some(why) if self.what.is_empty() => format!("no effect: {why}"),
            Some(why) => format!("{} (no effect: {why})", self.what),
            None => self.what.to_owned(),
        }
    }

    fn cells(&self) -> Vec<String> {
        let left_out = if self.default.is_empty() { String::new() } else { format!("left out: {}", self.default) };
        [self.meaning(), self.kind.text().to_owned(), self.rule_text(), left_out]
            .into_iter()
            .filter(|cell| !cell.is_empty())
            .collect()
    }
}
