//! What stands around the program: its name, who made it of what, the modes that hold, comments of the configuration.

use crate::diag::{Answer, codes};
use crate::machine::settings::{Quantity, Units};
use crate::target::{Form, ProgramName};
use crate::text::Loc;

use super::super::comment;
use super::Printer;

/// Digits of the hash in the head.
const HASH_DIGITS: usize = 16;
/// Most of the name of the source that is printed.
const NAME: usize = 40;

impl Printer<'_> {
    pub(super) fn head(&mut self, source: &str, lathe: bool) {
        let frame = &self.target.frame;
        if let Some(first) = frame.first {
            self.lines.plain(first.as_bytes());
        }
        if let Some(name) = self.program_name(source) {
            self.lines.plain(name.as_bytes());
        }
        let title = self.framed(&format!("partc {}, target {}", env!("CARGO_PKG_VERSION"), self.target.name));
        self.lines.plain(&title);
        let source = source.rsplit(['/', '\\']).next().unwrap_or(source);
        let mut name = comment::harmless(source.as_bytes(), &self.target.comments);
        name.truncate(NAME);
        let name = String::from_utf8_lossy(&name).into_owned();
        let text = self.framed(&format!("source {name}, hash {:0HASH_DIGITS$}", 0));
        self.lines.plain(&text);
        let behind = self.target.comments.close.len() + HASH_DIGITS + 1;
        self.hash_at = (self.lines.text.len() - behind) as u64;
        let lines = match frame.inch_head {
            Some(lines) if self.measures.inches => lines,
            None if self.measures.inches => {
                self.lacks_inches();
                frame.head
            }
            _ => frame.head,
        };
        for line in lines {
            self.lines.block(line.as_bytes());
        }
        let modes = match (lathe, self.diameter) {
            (false, _) => frame.mill,
            (true, false) => frame.lathe,
            (true, true) => frame.lathe_diameter.or_else(|| {
                if frame.lathe.is_some() {
                    self.lacks_diameters();
                }
                frame.lathe
            }),
        };
        match modes {
            Some(modes) => self.head_modes(modes, lathe),
            None => self.lacks_machine(lathe),
        }
        self.source = name;
        self.fixed_numbers();
        self.unused_keys(lathe);
        self.template(&self.settings.header);
    }

    /// The hash of the source as the head has it.
    pub(super) fn hash(&self, hash: u64) -> String {
        let digits = format!("{hash:0HASH_DIGITS$x}");
        if self.target.comments.upper { digits.to_uppercase() } else { digits }
    }

    fn program_name(&mut self, source: &str) -> Option<String> {
        let (letter, digits, most) = match self.target.frame.name {
            ProgramName::None => return None,
            ProgramName::Number { letter, digits, most } => (letter, digits, most),
            ProgramName::Text { front, most, marks } => return Some(self.text_name(source, front, most, marks)),
        };
        let number = self.settings.program_number;
        if number > most {
            let start = Loc { line: 1, ..Loc::default() };
            self.diags.push(
                codes::O9324::program_number(&number, &self.target.name, &most)
                    .answer(Answer::key("output", "program_number"))
                    .at(start),
            );
        }
        Some(format!("{}{number:0digits$}", letter as char))
    }

    /// The line with the name of the source. The last line of a dialog repeats it, and is kept.
    fn text_name(&mut self, source: &str, front: &str, most: usize, marks: &str) -> String {
        let file = source.rsplit(['/', '\\']).next().unwrap_or(source);
        let stem = file.split('.').find(|part| !part.is_empty()).unwrap_or(self.target.name);
        let known = |c: char| c.is_ascii_alphanumeric() || marks.contains(c);
        // What is no letter of a name becomes the first mark, or nothing.
        let letters = stem.chars().filter_map(|c| if known(c) { Some(c) } else { marks.chars().next() });
        let name: String = letters.map(|c| c.to_ascii_uppercase()).take(most).collect();
        let name = if name.is_empty() { "1".to_owned() } else { name };
        let Form::Dialog(dialog) = self.target.form else { return format!("{front}{name}") };
        let unit = dialog.units[usize::from(self.measures.inches)];
        self.last = Some(format!("{} {name} {unit}", dialog.end));
        format!("{} {name} {unit}", dialog.begin)
    }

    /// Wishes of the configuration that the numbers of the target cannot keep.
    fn fixed_numbers(&mut self) {
        let start = Loc { line: 1, ..Loc::default() };
        let target = self.target;
        let (places, most) = (self.settings.places(Quantity::Length), target.numbers.most);
        if places > most {
            self.diags
                .push(codes::O9326::decimals_target_reads_places_of_length(&target.name, &most, &places).at(start));
        }
        let (time, most) = (self.settings.places(Quantity::Time), target.numbers.time.unwrap_or(u8::MAX));
        if time > most {
            self.diags.push(codes::O9326::decimals_target_reads_places_of_wait(&target.name, &most, &time).at(start));
        }
    }

    /// A comment of the target.
    fn framed(&self, text: &str) -> Vec<u8> {
        let comments = &self.target.comments;
        let text = comment::harmless(text.as_bytes(), comments);
        [comments.open.as_bytes(), &text, comments.close.as_bytes()].concat()
    }

    /// Comments of the configuration, their fields filled in.
    pub(super) fn template(&mut self, lines: &[String]) {
        for line in lines {
            let units = if self.settings.units == Units::Inches { "inch" } else { "mm" };
            let text = line
                .replace("{source}", &self.source)
                .replace("{version}", env!("CARGO_PKG_VERSION"))
                .replace("{target}", self.target.name)
                .replace("{number}", &self.settings.program_number.to_string())
                .replace("{units}", units);
            let comments = &self.target.comments;
            for line in comment::lines(text.as_bytes(), comments, self.comment_room()) {
                let framed = [comments.open.as_bytes(), &line, comments.close.as_bytes()].concat();
                self.lines.plain(&framed);
            }
        }
    }

    /// Longest text of a comment.
    pub(super) fn comment_room(&self) -> usize {
        let comments = &self.target.comments;
        self.lines.room() - comments.open.len() - comments.close.len()
    }
}
