//! Findings as text: for people, or one line each.

use std::fmt::Write as _;

use crate::text::Sources;
use crate::text::decode::harmless_lines;

use super::{Diagnostic, Trail};

#[cfg(feature = "cli")]
mod excerpt;

/// `file:line:column: error[P1001]: message; help`
pub fn concise(found: &Diagnostic, sources: &Sources, trail: &Trail) -> String {
    one_line(found, found.help.as_deref(), sources, trail)
}

/// The same without the help.
pub fn brief(found: &Diagnostic, sources: &Sources, trail: &Trail) -> String {
    one_line(found, None, sources, trail)
}

fn one_line(found: &Diagnostic, help: Option<&str>, sources: &Sources, trail: &Trail) -> String {
    let line = sources.line(found.label.loc);
    let mut text = format!(
        "{}:{}:{}: {}[{}]: {}",
        sources.shown(found.label.loc.file),
        line.number,
        line.column,
        found.severity.word(),
        found.code.id,
        found.text()
    );
    if found.times > 1 {
        let _ = write!(text, " ({} times)", found.times);
    }
    if let Some(help) = help {
        let _ = write!(text, "; {help}");
    }
    if let Some(site) = trail.sites(found.call).first() {
        let _ = write!(text, " (called from {}:{})", sources.shown(site.file), site.line);
    }
    // Names of files stand in messages and helps, too.
    harmless_lines(&text)
}

/// Renders for a terminal through miette.
#[cfg(feature = "cli")]
pub mod terminal {
    use miette::{GraphicalReportHandler, GraphicalTheme, LabeledSpan};

    use crate::diag::Severity;
    use crate::text::Loc;

    use super::excerpt::Excerpt;
    use super::*;

    /// How findings look.
    #[derive(Debug)]
    pub struct Style(GraphicalReportHandler);

    impl Style {
        /// With or without colours, in lines of `width` characters.
        pub fn new(color: bool, width: usize) -> Style {
            let theme = if color { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
            Style(GraphicalReportHandler::new_themed(theme).with_width(width).with_links(false))
        }

        pub fn render(&self, found: &Diagnostic, sources: &Sources, trail: &Trail) -> String {
            let mut text = String::new();
            let shown = Shown::of(found, sources, trail);
            // Writing into a string cannot fail; a renderer that gives up leaves the short form.
            if self.0.render_report(&mut text, &shown).is_err() {
                text = concise(found, sources, trail);
            }
            let mut trimmed = String::with_capacity(text.len());
            for line in text.lines() {
                trimmed.push_str(line.trim_end());
                trimmed.push('\n');
            }
            trimmed
        }
    }

    /// A finding, or a place in another file that explains it.
    #[derive(Debug)]
    struct Shown {
        title: String,
        severity: miette::Severity,
        help: Option<String>,
        excerpt: Excerpt,
        related: Vec<Shown>,
    }

    /// Blocks of a call that are shown, the innermost first.
    const MOST_CALLS: usize = 4;

    impl Shown {
        fn of(found: &Diagnostic, sources: &Sources, trail: &Trail) -> Shown {
            let mut excerpt = Excerpt::new(found.label.loc, &found.label.text, sources);
            let mut title = format!("{}[{}]: {}", found.severity.word(), found.code.id, harmless_lines(&found.text()));
            if found.times > 1 {
                let _ = write!(title, " ({} times)", found.times);
            }
            let calls = trail.sites(found.call).into_iter().take(MOST_CALLS).map(|site| (site, "called from here"));
            let places = found.more.iter().map(|label| (label.loc, label.text.as_str())).chain(calls);
            let apart: Vec<(Loc, &str)> =
                places.filter(|(loc, text)| !excerpt.takes(found.label.loc, *loc, text, sources)).collect();
            Shown {
                title,
                severity: match found.severity {
                    Severity::Error => miette::Severity::Error,
                    Severity::Warning => miette::Severity::Warning,
                    Severity::Note => miette::Severity::Advice,
                },
                help: found.help.as_deref().map(harmless_lines),
                excerpt: excerpt.in_pieces(),
                related: apart.into_iter().map(|(loc, text)| Shown::place(loc, text, sources)).collect(),
            }
        }

        fn place(loc: Loc, text: &str, sources: &Sources) -> Shown {
            Shown {
                title: text.to_owned(),
                severity: miette::Severity::Advice,
                help: None,
                excerpt: Excerpt::new(loc, "", sources).in_pieces(),
                related: Vec::new(),
            }
        }
    }

    impl std::fmt::Display for Shown {
        fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
            f.write_str(&self.title)
        }
    }

    impl std::error::Error for Shown {}

    impl miette::Diagnostic for Shown {
        fn severity(&self) -> Option<miette::Severity> {
            Some(self.severity)
        }

        fn help<'a>(&'a self) -> Option<Box<dyn std::fmt::Display + 'a>> {
            self.help.as_ref().map(|help| Box::new(help) as Box<dyn std::fmt::Display>)
        }

        fn source_code(&self) -> Option<&dyn miette::SourceCode> {
            Some(&self.excerpt)
        }

        fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
            Some(Box::new(self.excerpt.labels()))
        }

        fn related<'a>(&'a self) -> Option<Box<dyn Iterator<Item = &'a dyn miette::Diagnostic> + 'a>> {
            (!self.related.is_empty())
                .then(|| Box::new(self.related.iter().map(|shown| shown as &dyn miette::Diagnostic)) as Box<_>)
        }
    }
}
