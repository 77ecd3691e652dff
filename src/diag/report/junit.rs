//! JUnit XML: each program is a test case, which fails with its findings.

use crate::diag::{Finding, Severity};

use super::{Checked, Document, full_text, path_of, xml};

#[derive(Debug)]
pub struct JUnit {
    fails: Severity,
    cases: String,
    tests: u32,
    failures: u32,
}

impl JUnit {
    pub fn new(fails: Severity) -> JUnit {
        JUnit { fails, cases: String::new(), tests: 0, failures: 0 }
    }
}

impl Document for JUnit {
    fn program(&mut self, checked: &Checked) {
        self.tests += 1;
        let name = xml::escaped(&path_of(&checked.file));
        self.cases += &format!("    <testcase classname=\"partc\" name=\"{name}\">\n");
        let (bad, rest): (Vec<&Finding>, Vec<&Finding>) =
            checked.findings.iter().partition(|found| found.severity >= self.fails);
        let failing = checked.counts.at_least(self.fails);
        if failing > 0 {
            self.failures += 1;
            let first = bad.first().map_or_else(|| format!("{failing} findings"), |found| full_text(found));
            let kind = bad.first().map_or("", |found| found.code);
            self.cases += &format!("      <failure message=\"{}\" type=\"{kind}\">", xml::escaped(&first));
            self.cases += &format!("{}</failure>\n", lines(&bad));
        }
        if !rest.is_empty() {
            self.cases += &format!("      <system-out>{}</system-out>\n", lines(&rest));
        }
        self.cases += "    </testcase>\n";
    }

    fn finish(self: Box<Self>, troubles: &[String]) -> String {
        let errors: String = troubles
            .iter()
            .map(|trouble| {
                let text = xml::escaped(trouble);
                // The file in front of what is said of it.
                let name = xml::escaped(trouble.split_once(": ").map_or(trouble, |(file, _)| file));
                format!(
                    "    <testcase classname=\"partc\" name=\"{name}\">\n      <error message=\"{text}\"/>\n    </testcase>\n"
                )
            })
            .collect();
        let (tests, failures) = (self.tests as usize + troubles.len(), self.failures);
        let counts = format!("tests=\"{tests}\" failures=\"{failures}\" errors=\"{}\"", troubles.len());
        format!(
            "{}<testsuites {counts}>\n  <testsuite name=\"partc\" {counts}>\n{}{errors}  </testsuite>\n</testsuites>\n",
            xml::HEAD,
            self.cases
        )
    }
}

fn lines(findings: &[&Finding]) -> String {
    let mut text = String::new();
    for found in findings {
        let severity = found.severity.word();
        let line = format!(
            "{}:{}:{}: {severity}[{}]: {}",
            path_of(&found.file),
            found.line,
            found.column,
            found.code,
            full_text(found)
        );
        text += "\n";
        text += &xml::escaped(&line);
    }
    text
}
