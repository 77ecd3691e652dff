//! `[lint]`: which findings are reported, and how bad they are.

use super::key::{Key, Kind, key};
use crate::diag::selection::{Choice, Selector};
use crate::diag::{Severity, codes};
use crate::machine::axis::Axis;
use crate::machine::tree::{ConfigError, Node, Value, did_you_mean};
use crate::machine::values::{fits, put, range, table_of, text};

pub const KEYS: &[Key] = &[
    key(
        "select",
        Kind::Texts,
        "findings that are reported: codes, beginnings of codes, names, default, all",
        // The default is what holds without the key.
        |s, v| put(&mut s.lint.all.select, Some(selectors(v)?).filter(|list| *list != [Selector::Default])),
    )
    .or(r#"["default"]"#),
    key("ignore", Kind::Texts, "findings that are not reported; what is an error cannot be ignored", |s, v| {
        put(&mut s.lint.all.ignore, ignored(v)?)
    })
    .or("[]"),
    key(
        "severity",
        Kind::Free,
        "how bad findings are: P8140 = \"error\", K2 = \"note\"; errors stay errors",
        |s, v| put(&mut s.lint.all.severity, severities(v)?),
    ),
    key(
        "blank",
        Kind::Free,
        "blank where the program describes none: X = [0.0, 100.0], Y, Z; lathe: X is the diameters of bore and bar, and Z",
        |s, v| {
            for (name, node) in table_of(v) {
                s.blank.insert(blank_axis(name, node)?, range(node)?);
            }
            if s.blank.contains_key(&Axis::X) && s.blank.contains_key(&Axis::Z) {
                return Ok(());
            }
            Err(v.fail("a blank has X, Y and Z, or X and Z on a lathe"))
        },
    ),
    key("files", Kind::Free, "the same for files whose path fits: \"legacy/**\" = { ignore = [\"P8140\"] }", |s, v| {
        for (pattern, node) in table_of(v) {
            s.lint.files.push((pattern.clone(), choice(node)?));
        }
        Ok(())
    }),
];

/// The keys of `[lint.files."legacy/**"]`.
fn choice(node: &Node) -> Result<Choice, ConfigError> {
    let mut choice = Choice::default();
    let Value::Table(table) = &node.value else {
        return Err(node.fail("a pattern of files has a table: { ignore = [\"P8140\"] }"));
    };
    for (name, node) in table {
        let Some(key) = KEYS.iter().find(|key| key.name == name && !matches!(key.name, "files" | "blank")) else {
            let mut error = node.fail(format!("unknown key `{name}`"));
            let like = did_you_mean(name, ["select", "ignore", "severity"]);
            error.help = like.map(|like| format!("did you mean `{like}`?"));
            return Err(error);
        };
        fits(key, node)?;
        match key.name {
            "select" => choice.select = Some(selectors(node)?),
            "ignore" => choice.ignore = ignored(node)?,
            _ => choice.severity = severities(node)?,
        }
    }
    Ok(choice)
}

fn blank_axis(name: &str, node: &Node) -> Result<Axis, ConfigError> {
    match name {
        "X" => Ok(Axis::X),
        "Y" => Ok(Axis::Y),
        "Z" => Ok(Axis::Z),
        _ => Err(node.fail(format!("`{name}` is none of X, Y and Z"))),
    }
}

fn selectors(node: &Node) -> Result<Vec<Selector>, ConfigError> {
    let Value::List(items) = &node.value else { return Ok(Vec::new()) };
    items.iter().map(|item| selector(text(item), item)).collect()
}

fn selector(word: &str, at: &Node) -> Result<Selector, ConfigError> {
    Selector::named(word).ok_or_else(|| {
        let mut error = at.fail(format!("no finding has the code or name `{word}`"));
        let all = codes::all();
        let like = did_you_mean(word, all.iter().flat_map(|code| [code.id, code.name]));
        error.help =
            Some(like.map_or("`partc rules` lists them all".to_owned(), |like| format!("did you mean `{like}`?")));
        error
    })
}

fn ignored(node: &Node) -> Result<Vec<Selector>, ConfigError> {
    let list = selectors(node)?;
    for selector in &list {
        if let Selector::One(code) = selector
            && code.is_firm()
        {
            let why =
                if code.severity == Severity::Error { "is an error" } else { "says that the path is another one" };
            return Err(node.fail(format!("{} ({}) {why}, which cannot be ignored", code.id, code.name)));
        }
    }
    Ok(list)
}

fn severities(node: &Node) -> Result<Vec<(Selector, Severity)>, ConfigError> {
    let mut list = Vec::new();
    for (word, node) in table_of(node) {
        let selector = selector(word, node)?;
        let severity =
            [Severity::Error, Severity::Warning, Severity::Note].into_iter().find(|s| s.word() == text(node));
        let severity = severity.ok_or_else(|| node.fail(format!("`{word}` is \"error\", \"warning\" or \"note\"")))?;
        if let Selector::One(code) = &selector
            && code.is_firm()
            && severity < code.severity
        {
            let (id, is) = (code.id, code.severity.word());
            return Err(node.fail(format!("{id} ({}) stays {is}: it cannot be lowered", code.name)));
        }
        list.push((selector, severity));
    }
    Ok(list)
}

#[cfg(test)]
mod tests {
    use crate::machine::config::from_toml;

    fn error(text: &str) -> String {
        from_toml(text, "partc.toml").unwrap_err()[0].to_string()
    }

    #[test]
    fn the_section_of_the_contract() {
        let text = "[lint]\nselect = [\"default\", \"K8\"]\nignore = [\"cycle-depth-zero\"]\nseverity = { P8140 = \"error\" }\n\
                    [lint.files.\"legacy/**\"]\nignore = [\"P8140\"]\n";
        let lint = from_toml(text, "partc.toml").unwrap().lint;
        assert_eq!((lint.all.ignore.len(), lint.all.severity.len(), lint.files.len()), (1, 1, 1));
    }

    #[test]
    fn what_is_wrong_is_said() {
        for (text, wanted) in [
            ("[lint]\nselect = [\"K8O01\"]", "no finding has the code or name `K8O01`; did you mean"),
            ("[lint]\nignore = [\"K2101\"]", "K2101 (pole-missing) is an error, which cannot be ignored"),
            ("[lint]\nignore = [\"G3025\"]", "says that the path is another one, which cannot be ignored"),
            ("[lint]\nseverity = { K2101 = \"note\" }", "K2101 (pole-missing) stays error: it cannot be lowered"),
            ("[lint]\nseverity = { P8140 = \"off\" }", "`P8140` is \"error\", \"warning\" or \"note\""),
            ("[lint.files.\"a/*\"]\nignored = [\"K8\"]", "unknown key `ignored`; did you mean `ignore`?"),
            ("[lint.files.\"a/*\"]\nignore = \"K8\"", "`ignore` needs a list of texts"),
            ("[lint]\nblank = { X = [0, 100] }", "a blank has X, Y and Z, or X and Z on a lathe"),
            ("[lint]\nblank = { A = [0, 100] }", "`A` is none of X, Y and Z"),
            ("[lint]\nfiles = { \"a/*\" = 5 }", "a pattern of files has a table"),
        ] {
            let error = error(text);
            assert!(error.contains(wanted), "{error}");
        }
    }
}
