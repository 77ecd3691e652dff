//! Checkstyle XML.

use crate::diag::Severity;

use super::{Checked, Document, full_text, path_of, xml};

/// In front of the findings of a called file: the program that calls it.
pub(super) const PROGRAM: &str = "<?partc program=\"";

#[derive(Debug, Default)]
pub struct Checkstyle(String);

impl Document for Checkstyle {
    fn program(&mut self, checked: &Checked) {
        // A program that is called has elements of its own.
        for same_file in checked.findings.chunk_by(|a, b| a.file == b.file) {
            // Shards are put together by their programs; receivers pass over an instruction that is none for them.
            if same_file[0].file != checked.file {
                self.0 += &format!("  {PROGRAM}{}\"?>\n", xml::escaped(&path_of(&checked.file)));
            }
            self.0 += &format!("  <file name=\"{}\">\n", xml::escaped(&path_of(&same_file[0].file)));
            for found in same_file {
                let severity = match found.severity {
                    Severity::Error => "error",
                    Severity::Warning => "warning",
                    Severity::Note => "info",
                };
                self.0 += &format!(
                    "    <error line=\"{}\" column=\"{}\" severity=\"{severity}\" message=\"{}\" source=\"partc.{}\"/>\n",
                    found.line,
                    found.column,
                    xml::escaped(&full_text(found)),
                    found.code
                );
            }
            self.0 += "  </file>\n";
        }
    }

    fn finish(self: Box<Self>, _: &[String]) -> String {
        format!("{}<checkstyle version=\"8.0\">\n{}</checkstyle>\n", xml::HEAD, self.0)
    }
}
