//! Findings as text: for people, or one line each.

use std::fmt::Write as _;

use crate::text::Sources;
use crate::text::decode::harmless_lines;

use super::{Diagnostic, Trail};

/// `file:line:column: error[K1001]: message; help`
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
    use miette::{
        GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError, MietteSpanContents, SourceSpan, SpanContents,
    };

    use crate::diag::Severity;
    use crate::text::Loc;

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

    /// One line of source as miette wants it.
    #[derive(Debug)]
    struct Excerpt {
        name: String,
        text: String,
        number: usize,
        /// 1-based column of the finding, for the line above the excerpt.
        column: usize,
    }

    impl miette::SourceCode for Excerpt {
        fn read_span<'a>(
            &'a self,
            _: &SourceSpan,
            _: usize,
            _: usize,
        ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
            let whole = SourceSpan::from((0, self.text.len()));
            Ok(Box::new(MietteSpanContents::new_named(
                self.name.clone(),
                self.text.as_bytes(),
                whole,
                self.number.saturating_sub(1),
                self.column.saturating_sub(1),
                1,
            )))
        }
    }

    /// A finding, or one of its explaining places.
    #[derive(Debug)]
    struct Shown {
        title: String,
        severity: miette::Severity,
        help: Option<String>,
        excerpt: Excerpt,
        label: LabeledSpan,
        related: Vec<Shown>,
    }

    impl Shown {
        fn of(found: &Diagnostic, sources: &Sources, trail: &Trail) -> Shown {
            let (excerpt, label) = excerpt(found.label.loc, &found.label.text, sources);
            let mut title = format!("{}[{}]: {}", found.severity.word(), found.code.id, harmless_lines(&found.text()));
            if found.times > 1 {
                let _ = write!(title, " ({} times)", found.times);
            }
            let mut related: Vec<Shown> =
                found.more.iter().map(|label| Shown::place(label.loc, &label.text, sources)).collect();
            related.extend(
                trail.sites(found.call).iter().take(4).map(|site| Shown::place(*site, "called from here", sources)),
            );
            Shown {
                title,
                severity: match found.severity {
                    Severity::Error => miette::Severity::Error,
                    Severity::Warning => miette::Severity::Warning,
                    Severity::Note => miette::Severity::Advice,
                },
                help: found.help.as_deref().map(harmless_lines),
                excerpt,
                label,
                related,
            }
        }

        fn place(loc: Loc, text: &str, sources: &Sources) -> Shown {
            let (excerpt, label) = excerpt(loc, "", sources);
            Shown {
                title: text.to_owned(),
                severity: miette::Severity::Advice,
                help: None,
                excerpt,
                label,
                related: Vec::new(),
            }
        }
    }

    fn excerpt(loc: Loc, text: &str, sources: &Sources) -> (Excerpt, LabeledSpan) {
        let line = sources.line(loc);
        let label = (!text.is_empty()).then(|| harmless_lines(text));
        let (start, end) = line.marked;
        let span = LabeledSpan::new(label, start, end.saturating_sub(start).max(1));
        // A blank more, so that a mark at the end of the line has something under it.
        let text = if start < line.text.len() { line.text } else { format!("{} ", line.text) };
        let (number, column) = (line.number as usize, line.column as usize);
        (Excerpt { name: sources.shown(loc.file), text, number, column }, span)
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
            Some(Box::new(std::iter::once(self.label.clone())))
        }

        fn related<'a>(&'a self) -> Option<Box<dyn Iterator<Item = &'a dyn miette::Diagnostic> + 'a>> {
            (!self.related.is_empty())
                .then(|| Box::new(self.related.iter().map(|shown| shown as &dyn miette::Diagnostic)) as Box<_>)
        }
    }
}
