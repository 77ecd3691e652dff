//! Workflow commands of GitHub Actions.

use crate::diag::Severity;
use crate::text::decode::harmless_lines;

use super::{Checked, Document, full_text, path_of};

#[derive(Debug, Default)]
pub struct GitHub(String);

impl Document for GitHub {
    fn program(&mut self, checked: &Checked) {
        for found in &checked.findings {
            let kind = match found.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
                Severity::Note => "notice",
            };
            let mut place = format!("file={},line={}", property(&path_of(&found.file)), found.line);
            // Columns are taken within one line only.
            if found.end_line == found.line {
                place += &format!(",col={},endColumn={}", found.column, found.end_column);
            } else {
                place += &format!(",endLine={}", found.end_line);
            }
            let title = property(&format!("{} {}", found.code, found.name));
            self.0 += &format!("::{kind} {place},title={title}::{}\n", data(&full_text(found)));
        }
    }

    fn finish(self: Box<Self>, _: &[String]) -> String {
        self.0
    }
}

fn data(text: &str) -> String {
    harmless_lines(text).replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::super::tests::checked;
    use super::*;

    #[test]
    fn a_command_ends_where_it_shall() {
        let mut report = Box::<GitHub>::default();
        report.program(&checked());
        let text = report.finish(&[]);
        let first = "::error file=a b/PART%2C1.H,line=3,col=3,endColumn=9,title=K2101 pole-missing::no <pole> & \"none\" \
                     (2 times); program CC";
        assert_eq!(text.lines().next(), Some(first));
        assert_eq!(data("a\n::error::%"), "a%0A::error::%25");
    }
}
