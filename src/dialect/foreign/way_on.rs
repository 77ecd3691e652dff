//! What to do with a file that is in none of the languages.

use crate::machine::Settings;
use crate::sema::gcode;
use crate::text::Span;
use crate::text::decode::readable;

use super::{HEAD, SHOWN};

/// What to do with a file; `{pattern}` stands for the pattern of its name in `[dialects]`.
#[derive(Debug, Clone, Copy)]
pub enum WayOn {
    Said(&'static str),
    /// The reader of plain G-code is asked what it takes of the file.
    Tried {
        /// Where it takes all.
        taken: &'static str,
        /// Where it refuses a line, which is named behind it.
        refused: &'static str,
    },
    /// The same; a lathe counts X as a diameter, which is never advised to be read so.
    TriedOnMill {
        taken: &'static str,
        refused: &'static str,
    },
}

impl WayOn {
    /// In words, for a file with this head.
    pub fn text(self, file_name: &str, head: &[u8], turns: bool, settings: &Settings) -> String {
        let text = match self {
            WayOn::Said(text) => text.to_owned(),
            WayOn::TriedOnMill { refused, .. } if turns => {
                format!(
                    "{refused}; read as plain G-code, its X would be radii, and on a lathe of this kind they are diameters"
                )
            }
            WayOn::Tried { taken, refused } | WayOn::TriedOnMill { taken, refused } => tried(head, settings)
                .map_or_else(
                    || taken.to_owned(),
                    |line| format!("{refused}; read as plain G-code, {line} would be refused"),
                ),
        };
        let extension = file_name.rsplit_once('.').map_or("nc", |(_, extension)| extension);
        text.replace("{pattern}", &format!("**/*.{extension}"))
    }
}

/// The first line of the head that the reader of plain G-code refuses: "line 3, `G81 X1`".
fn tried(head: &[u8], settings: &Settings) -> Option<String> {
    let is_cut = head.len() >= HEAD as usize;
    let whole = head.iter().rposition(|b| *b == b'\n').filter(|_| is_cut).map_or(head.len(), |end| end + 1);
    let text = &head[..whole];
    let loc = gcode::first_refused(text, settings)?;
    let start = text[..loc.span.start as usize].iter().rposition(|b| matches!(b, b'\n' | b'\r')).map_or(0, |at| at + 1);
    let length = text[start..].iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(text.len() - start);
    let shown: String = readable(Span::at(start as u32, length as u32).of(text)).chars().take(SHOWN).collect();
    Some(format!("line {}, `{}`,", loc.line, shown.trim().replace('`', "'")))
}
