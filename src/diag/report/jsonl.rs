//! One finding a line, each an object as in [`super::json`].

use serde_json::json;

use crate::text::decode::escaped_json;

use super::{Checked, Document};

#[derive(Debug, Default)]
pub struct JsonLines(String);

impl Document for JsonLines {
    fn program(&mut self, checked: &Checked) {
        for found in &checked.findings {
            self.0 += &escaped_json(&json!(found).to_string());
            self.0.push('\n');
        }
    }

    fn finish(self: Box<Self>, _: &[String]) -> String {
        self.0
    }
}
