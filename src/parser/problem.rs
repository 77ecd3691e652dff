//! What is wrong with the form of a block, and repairs that every dialect makes.

use crate::diag::{Code, Fault, Help, Parts, Raised};
use crate::text::Span;

/// A finding about one block; spans count from its start.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    pub code: &'static Code,
    /// The number that the control itself shows.
    pub alarm: Option<u32>,
    pub span: Span,
    pub message: String,
    pub help: Option<Help>,
}

impl Problem {
    pub fn new(code: impl Into<Raised>, span: Span, message: impl Into<String>) -> Problem {
        let Raised { code, alarm } = code.into();
        Problem { code, alarm, span, message: message.into(), help: None }
    }

    /// Names the alarm that the control itself raises.
    pub fn alarm(mut self, number: u32) -> Problem {
        self.alarm = Some(number);
        self
    }

    pub fn raised(&self) -> Raised {
        Raised { code: self.code, alarm: self.alarm }
    }

    pub fn help(mut self, help: impl Into<Help>) -> Problem {
        self.help = Some(help.into());
        self
    }

    /// What is wrong, without its place.
    pub fn fault(self) -> Fault {
        let fault = Fault::new(self.raised(), self.message);
        match self.help {
            Some(help) => fault.help(help),
            None => fault,
        }
    }
}

impl Fault {
    /// The problem of words of a block.
    pub fn among(self, span: Span) -> Problem {
        let Parts { raised: Raised { code, alarm }, message, help } = self.into_parts();
        Problem { code, alarm, span, message, help }
    }
}

/// A copy of the code of a block in which dashes of printed text are minus signs; spans stay as they are.
/// `None` if there are none. `from` is where the code starts, a `;` outside a text ends it.
pub fn without_printed_dashes(
    text: &[u8],
    from: usize,
    code: &'static Code,
    problems: &mut Vec<Problem>,
) -> Option<Vec<u8>> {
    let end = text.iter().position(|b| *b == b';').unwrap_or(text.len());
    let words = text.get(from..end)?;
    if words.is_ascii() || words.contains(&b'"') {
        return None;
    }
    let mut copy = None;
    for (at, window) in words.windows(3).enumerate() {
        if matches!(window, [0xe2, 0x80, 0x93] | [0xe2, 0x88, 0x92]) {
            let copy = copy.get_or_insert_with(|| text.to_vec());
            copy[from + at..from + at + 3].copy_from_slice(b"-  ");
            let span = Span::at((from + at) as u32, 3);
            problems.push(Problem::new(code, span, "a printed dash is read as `-`").help("replace it by `-`"));
        }
    }
    copy
}

/// The characters that a span holds a part of, where the text is UTF-8.
pub(super) fn whole_character(span: Span, text: &[u8]) -> Span {
    let follows = |at: u32| text.get(at as usize).is_some_and(|b| b & 0xc0 == 0x80);
    let Span { mut start, mut end } = span;
    while follows(start) && start > 0 && span.start - start < 3 {
        start -= 1;
    }
    while follows(end) && end - span.end < 3 {
        end += 1;
    }
    let wider = Span { start, end };
    if std::str::from_utf8(wider.of(text)).is_ok() { wider } else { span }
}
