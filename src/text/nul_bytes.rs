//! Holes in a file: NUL or Ctrl-Z between the bytes of a program, where text was lost.

use memchr::memchr2;

use super::Place;

/// A byte that fills up a file: no line of a program holds one.
fn is_padding(b: u8) -> bool {
    matches!(b, 0 | 0x1a)
}

pub(super) fn is_empty(b: u8) -> bool {
    b.is_ascii_whitespace() || b == 0x0b || is_padding(b)
}

/// NUL or Ctrl-Z with a program before and after.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Hole {
    pub place: Place,
    /// Text of one line stands before and after it.
    pub inside: bool,
}

/// Looks for holes: in front of the program, behind it, and between the programs of an archive the same bytes are padding.
#[derive(Debug, Clone, Copy)]
pub(super) struct Holes {
    /// Text was seen, and text of this line.
    begun: bool,
    in_line: bool,
    /// First byte of padding that may be a hole, and whether it may be one inside a line.
    open: Option<(u64, bool)>,
    /// Offset of the first hole of each kind, in lines and between them; beyond every file if there is none.
    pub(super) found: [u64; 2],
    pub(super) said: [bool; 2],
}

impl Holes {
    pub(super) const NONE: Holes =
        Holes { begun: false, in_line: false, open: None, found: [u64::MAX; 2], said: [false; 2] };

    /// The file is read from its start once more; what was said is not said again.
    pub(super) fn begin_again(&mut self) {
        *self = Holes { said: self.said, ..Holes::NONE };
    }

    /// Looks through the next `bytes` of the file, which begin at `base`.
    pub(super) fn look(&mut self, bytes: &[u8], base: u64) {
        let clean = self.begun && self.open.is_none() && memchr2(0, 0x1a, bytes).is_none();
        if clean {
            self.in_line = ends_in_line(bytes).unwrap_or(self.in_line);
            return;
        }
        let mut at = 0;
        while at < bytes.len() {
            if let Some((hole, inside)) = &mut self.open {
                let next = bytes[at..].iter().position(|b| !is_empty(*b)).map_or(bytes.len(), |next| at + next);
                *inside &= !bytes[at..next].iter().any(is_line_end);
                if next == bytes.len() {
                    return;
                }
                let found = &mut self.found[usize::from(!*inside)];
                if self.begun && bytes[next] != b'%' && *found == u64::MAX {
                    *found = *hole;
                }
                self.open = None;
                at = next;
            }
            let next = memchr2(0, 0x1a, &bytes[at..]).map_or(bytes.len(), |next| at + next);
            self.begun |= bytes[at..next].iter().any(|b| !is_empty(*b));
            self.in_line = ends_in_line(&bytes[at..next]).unwrap_or(self.in_line);
            if next < bytes.len() {
                self.open = Some((base + next as u64, self.in_line));
            }
            at = next;
        }
    }
}

fn is_line_end(b: &u8) -> bool {
    matches!(b, b'\n' | b'\r')
}

/// Does text stand in the line in which `bytes` end? Unknown where they are blanks.
fn ends_in_line(bytes: &[u8]) -> Option<bool> {
    let line = bytes.iter().rposition(is_line_end);
    let tail = &bytes[line.map_or(0, |at| at + 1)..];
    if tail.iter().any(|b| !is_empty(*b)) { Some(true) } else { line.map(|_| false) }
}
