//! The text of a document, and places in it as an editor counts them.

use lsp_types::{Position, PositionEncodingKind, Range};

use crate::text::Span;

/// What a column counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Columns {
    Utf8,
    #[default]
    Utf16,
}

impl Columns {
    /// The best of those that a client offers.
    pub fn of(offered: &[PositionEncodingKind]) -> Columns {
        if offered.contains(&PositionEncodingKind::UTF8) { Columns::Utf8 } else { Columns::Utf16 }
    }

    pub fn kind(self) -> PositionEncodingKind {
        match self {
            Columns::Utf8 => PositionEncodingKind::UTF8,
            Columns::Utf16 => PositionEncodingKind::UTF16,
        }
    }
}

/// A document with the places where its lines begin.
#[derive(Debug, Clone)]
pub struct Text {
    text: String,
    /// Where each line begins, the first at 0.
    lines: Vec<u32>,
    columns: Columns,
}

impl Text {
    pub fn new(text: String, columns: Columns) -> Text {
        let lines = lines(&text);
        Text { text, lines, columns }
    }

    pub fn as_str(&self) -> &str {
        &self.text
    }

    pub fn bytes(&self) -> &[u8] {
        self.text.as_bytes()
    }

    /// The place of a byte; one within a character is that of the character.
    pub fn position(&self, offset: u32) -> Position {
        let offset = (offset as usize).min(self.text.len());
        let line = self.lines.partition_point(|start| *start as usize <= offset) - 1;
        let start = self.lines[line] as usize;
        let end = self.text.floor_char_boundary(offset);
        let front = self.text.get(start..end).unwrap_or_default();
        let character = match self.columns {
            Columns::Utf8 => front.len(),
            Columns::Utf16 => front.encode_utf16().count(),
        };
        Position { line: line as u32, character: character as u32 }
    }

    pub fn range(&self, span: Span) -> Range {
        let end = self.text.ceil_char_boundary((span.end as usize).min(self.text.len()));
        Range { start: self.position(span.start), end: self.position(end as u32) }
    }

    /// The byte at a place; behind the end of a line it is the end of the line, behind the last line that of the text.
    pub fn offset(&self, position: Position) -> usize {
        let Some(&start) = self.lines.get(position.line as usize) else { return self.text.len() };
        let line = self.line(position.line as usize);
        let mut column = 0;
        let width = |c: char| if self.columns == Columns::Utf8 { c.len_utf8() } else { c.len_utf16() };
        for (at, c) in line.char_indices() {
            if column >= position.character as usize {
                return start as usize + at;
            }
            column += width(c);
        }
        start as usize + line.len()
    }

    /// A line without its end; empty where there is none.
    pub fn line(&self, number: usize) -> &str {
        let Some(&start) = self.lines.get(number) else { return "" };
        let end = self.lines.get(number + 1).map_or(self.text.len(), |end| *end as usize);
        self.text.get(start as usize..end).unwrap_or_default().trim_end_matches(['\r', '\n'])
    }

    /// Puts `new` in the place of a range, or of everything.
    pub fn change(&mut self, range: Option<Range>, new: &str) {
        match range {
            None => new.clone_into(&mut self.text),
            Some(range) => {
                let start = self.offset(range.start);
                let end = self.offset(range.end).max(start);
                self.text.replace_range(start..end, new);
            }
        }
        self.lines = lines(&self.text);
    }
}

/// Where lines begin: behind a line feed, a carriage return, or both.
fn lines(text: &str) -> Vec<u32> {
    let bytes = text.as_bytes();
    let ends = memchr::memchr2_iter(b'\n', b'\r', bytes);
    let ends = ends.filter(|at| bytes[*at] == b'\n' || bytes.get(at + 1) != Some(&b'\n'));
    std::iter::once(0).chain(ends.map(|at| at as u32 + 1)).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn at(line: u32, character: u32) -> Position {
        Position { line, character }
    }

    #[test]
    fn columns_count_what_was_agreed() {
        let text = "X1\r\nä😀Y\rZ\n".to_owned();
        let utf16 = Text::new(text.clone(), Columns::Utf16);
        let utf8 = Text::new(text, Columns::Utf8);
        assert_eq!((utf16.lines.len(), utf16.line(1), utf16.line(2), utf16.line(3)), (4, "ä😀Y", "Z", ""));
        // Y stands behind two bytes of the one and four of the other.
        assert_eq!((utf8.position(10), utf16.position(10)), (at(1, 6), at(1, 3)));
        assert_eq!((utf8.offset(at(1, 6)), utf16.offset(at(1, 3))), (10, 10));
        // Beyond the end of a line, and of the text.
        assert_eq!((utf16.offset(at(0, 99)), utf16.offset(at(99, 0))), (2, 14));
    }

    #[test]
    fn changes_replace_a_range() {
        let mut text = Text::new("L X+1\nL Y+2\n".to_owned(), Columns::Utf16);
        text.change(Some(Range { start: at(0, 4), end: at(1, 2) }), "5\nM3 ");
        assert_eq!(text.as_str(), "L X+5\nM3 Y+2\n");
        text.change(None, "L Z+1");
        assert_eq!((text.as_str(), text.lines.len()), ("L Z+1", 1));
        // A range that runs backwards inserts.
        text.change(Some(Range { start: at(0, 5), end: at(0, 1) }), " M2");
        assert_eq!(text.as_str(), "L Z+1 M2");
    }

    proptest! {
        #[test]
        fn places_lead_back_to_their_bytes(text in "[a😀ä\r\n]{0,24}", offset in 0usize..60, utf8: bool) {
            let columns = if utf8 { Columns::Utf8 } else { Columns::Utf16 };
            let text = Text::new(text, columns);
            let offset = text.as_str().floor_char_boundary(offset);
            let back = text.offset(text.position(offset as u32));
            // A place between the two bytes of a line end is the end of the line.
            let between = text.bytes().get(back..offset).is_some_and(|rest| rest.iter().all(|b| *b == b'\r'));
            prop_assert!(back == offset || between, "{offset} {back}");
        }
    }
}
