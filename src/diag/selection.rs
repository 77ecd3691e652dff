//! Which codes are reported, and how bad they are: what `[lint]` of a configuration says.
//!
//! The more exact selector wins: a code over a prefix, a longer prefix over a shorter one, any of them over `all` and
//! `default`; of two alike, leaving out wins. What is an error, and what says that the path is not the programmed one,
//! can only be raised.

use super::{Code, Severity, codes};

/// Codes, by one word of the user.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Selector {
    All,
    /// Those that are reported unless something else is said.
    Default,
    /// Letter and up to three digits, upper case.
    Prefix(String),
    One(&'static Code),
}

impl Selector {
    /// `all`, `default`, a code, its name, or the beginning of codes; `None` where nothing has such a name.
    pub fn named(text: &str) -> Option<Selector> {
        match text.to_ascii_lowercase().as_str() {
            "all" => return Some(Selector::All),
            "default" => return Some(Selector::Default),
            _ => {}
        }
        if let Some(code) = codes::find(text) {
            return Some(Selector::One(code));
        }
        let prefix = text.to_ascii_uppercase();
        let known = !prefix.is_empty() && codes::all().iter().any(|code| code.begins_with(&prefix));
        known.then_some(Selector::Prefix(prefix))
    }

    /// How exactly it names the code; `None` where it does not.
    fn rank(&self, code: &Code) -> Option<usize> {
        match self {
            Selector::All => Some(0),
            Selector::Default => code.on.then_some(0),
            Selector::Prefix(prefix) => code.begins_with(prefix).then_some(prefix.len()),
            Selector::One(one) => (one.id == code.id).then_some(code.id.len()),
        }
    }
}

fn rank(list: &[Selector], code: &Code) -> Option<usize> {
    list.iter().filter_map(|selector| selector.rank(code)).max()
}

/// What is said for all files, or for some of them.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Choice {
    /// `None` where nothing is said.
    pub select: Option<Vec<Selector>>,
    pub ignore: Vec<Selector>,
    pub severity: Vec<(Selector, Severity)>,
}

/// All that is said.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Selection {
    pub all: Choice,
    /// For the files whose path a pattern fits; a later one wins.
    pub files: Vec<(String, Choice)>,
}

impl Selection {
    /// What holds for a file of this path.
    pub fn of(&self, path: &str) -> Choice {
        let path = if cfg!(windows) { path.replace('\\', "/") } else { path.to_owned() };
        let mut choice = self.all.clone();
        for (_, more) in self.files.iter().filter(|(pattern, _)| fits(pattern, &path)) {
            if more.select.is_some() {
                choice.select.clone_from(&more.select);
            }
            choice.ignore.extend_from_slice(&more.ignore);
            // In front of what was said before: it wins against what is as exact.
            choice.severity.splice(0..0, more.severity.iter().cloned());
        }
        choice
    }
}

impl Choice {
    /// How bad a finding of this code is; `None` where it is not reported.
    pub fn level(&self, code: &Code) -> Option<Severity> {
        let selected = match &self.select {
            Some(list) => rank(list, code),
            None => code.on.then_some(0),
        };
        if !code.is_firm() && selected <= rank(&self.ignore, code) {
            return None;
        }
        let ranked = self.severity.iter().rev().filter_map(|(selector, said)| Some((selector.rank(code)?, *said)));
        let said = ranked.max_by_key(|(rank, _)| *rank).map_or(code.severity, |(_, said)| said);
        Some(if code.is_firm() { said.max(code.severity) } else { said })
    }
}

/// Does the pattern name this path? `*` and `?` stand for characters of one name, `**` for any number of folders.
pub fn fits(pattern: &str, path: &str) -> bool {
    let names: Vec<&str> = path.split('/').filter(|name| !name.is_empty() && *name != ".").collect();
    // Which numbers of names in front the patterns so far can stand for.
    let mut reached = vec![false; names.len() + 1];
    reached[0] = true;
    for part in pattern.split('/').filter(|part| !part.is_empty() && *part != ".") {
        let mut next = vec![false; names.len() + 1];
        for at in 0..=names.len() {
            next[at] = if part == "**" {
                reached[at] || at > 0 && next[at - 1]
            } else {
                at > 0 && reached[at - 1] && fits_name(part, names[at - 1])
            };
        }
        reached = next;
    }
    reached[names.len()]
}

/// The same for one name: after a mismatch the last `*` takes one character more.
fn fits_name(pattern: &str, name: &str) -> bool {
    let (pattern, name): (Vec<char>, Vec<char>) = (pattern.chars().collect(), name.chars().collect());
    let (mut p, mut n) = (0, 0);
    let mut star = None;
    while n < name.len() {
        match pattern.get(p) {
            Some('*') => {
                star = Some((p, n));
                p += 1;
            }
            Some(c) if *c == '?' || *c == name[n] => {
                p += 1;
                n += 1;
            }
            _ => {
                let Some((at, taken)) = star else { return false };
                star = Some((at, taken + 1));
                p = at + 1;
                n = taken + 1;
            }
        }
    }
    pattern[p..].iter().all(|c| *c == '*')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(words: &[&str]) -> Vec<Selector> {
        words.iter().map(|word| Selector::named(word).unwrap_or_else(|| panic!("{word}"))).collect()
    }

    fn level(choice: &Choice, code: &str) -> Option<Severity> {
        choice.level(codes::find(code).unwrap())
    }

    #[test]
    fn the_more_exact_selector_wins() {
        let choice = Choice { select: Some(list(&["all", "k8022"])), ignore: list(&["K8"]), ..Choice::default() };
        assert_eq!(level(&choice, "K8022"), Some(Severity::Warning));
        assert_eq!((level(&choice, "K8023"), level(&choice, "K2404")), (None, Some(Severity::Warning)));
        let both = Choice { select: Some(list(&["K8"])), ignore: list(&["K8"]), ..Choice::default() };
        assert_eq!((level(&both, "K8022"), level(&both, "K2404")), (None, None));
    }

    #[test]
    fn errors_and_what_moves_differently_stay() {
        let severity = vec![(Selector::All, Severity::Note)];
        let choice = Choice { select: Some(Vec::new()), ignore: list(&["all"]), severity };
        assert_eq!(level(&choice, "K2101"), Some(Severity::Error));
        assert_eq!(level(&choice, "G3025"), Some(Severity::Warning));
        assert_eq!(level(&choice, "K2404"), None);
        let raised = Choice { severity: vec![(Selector::All, Severity::Error)], ..Choice::default() };
        assert_eq!((level(&raised, "G3025"), level(&raised, "K2011")), (Some(Severity::Error), Some(Severity::Error)));
    }

    #[test]
    fn files_have_a_choice_of_their_own() {
        let one = |words: &[&str]| Choice { ignore: list(words), ..Choice::default() };
        let severity = vec![(Selector::All, Severity::Note)];
        let selection = Selection {
            all: Choice { severity, ..Choice::default() },
            files: vec![
                ("legacy/**".to_owned(), one(&["K2404"])),
                (
                    "legacy/new/*.H".to_owned(),
                    Choice { severity: vec![(Selector::All, Severity::Error)], ..Choice::default() },
                ),
            ],
        };
        let of = |path: &str| level(&selection.of(path), "cycle-depth-zero");
        assert_eq!((of("new/A.H"), of("legacy/a/b/C.H")), (Some(Severity::Note), None));
        assert_eq!(level(&selection.of("legacy/new/A.H"), "K8022"), Some(Severity::Error));
    }

    #[test]
    fn patterns_are_those_of_paths() {
        for (pattern, path, wanted) in [
            ("legacy/**", "legacy/a/B.H", true),
            ("legacy/**", "other/legacy/B.H", false),
            ("**/legacy/*.H", "a/b/legacy/B.H", true),
            ("*.H", "a/B.H", false),
            ("**", "B.H", true),
            ("a?c*e/*", "abcdde/x", true),
            ("./a/*", "/a/x", true),
            ("**/**/**/x", "a/b/c/y", false),
        ] {
            assert_eq!(fits(pattern, path), wanted, "{pattern} {path}");
        }
        // Many stars do not take time without end.
        assert!(!fits(&("a*".repeat(500) + "c"), &"ab".repeat(2500)));
    }

    #[test]
    fn words_that_name_nothing_select_nothing() {
        assert_eq!(Selector::named("X1"), None);
        assert_eq!(Selector::named(""), None);
        assert!(matches!(Selector::named("k8"), Some(Selector::Prefix(prefix)) if prefix == "K8"));
        assert!(matches!(Selector::named("P8140"), Some(Selector::One(code)) if code.id == "P8140"));
    }
}
