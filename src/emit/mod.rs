//! Text for a target: one printer core; the words are those of a table in `target`.
//!
//! In: motion items. Out: bytes, and optionally the source of every line. Decides nothing about geometry:
//! it rounds, checks what it rounded, and prints.

#![cfg_attr(not(test), warn(clippy::wildcard_enum_match_arm))]

pub mod arc;
pub mod comment;
mod compensation;
pub mod line;
mod line_writer;
mod modal;
pub mod number;
pub mod plot;
pub mod printer;
pub mod spindle_and_tool;
pub mod stats;
pub mod trace;

use std::io;

use crate::ir::Origin;
#[cfg(feature = "cli")]
use crate::target;

pub use printer::Printer;
pub(crate) use printer::winding;

/// Is this how a printed program begins? Comments look as those of its target.
#[cfg(feature = "cli")]
pub fn is_printed(head: &[u8]) -> bool {
    // The frame and the name of the program stand in front.
    head.split(|b| *b == b'\n').take(MARKED).any(|line| begins(line, MADE))
}

/// The target that a printed program of this head was made for.
#[cfg(feature = "cli")]
pub fn made_for(head: &[u8]) -> Option<&'static target::Target> {
    let line = head.split(|b| *b == b'\n').take(MARKED).find(|line| begins(line, MADE))?;
    let line = String::from_utf8_lossy(line).to_ascii_lowercase();
    let (_, name) = line.split_once("target ")?;
    let end = name.find(|c: char| !c.is_ascii_alphanumeric() && c != '-').unwrap_or(name.len());
    target::ALL.iter().find(|target| target.name == &name[..end]).copied()
}

/// Does this line of a printed program name the version of partc, or the source and its hash?
#[cfg(feature = "cli")]
pub fn names_source(line: &[u8]) -> bool {
    [MADE, SOURCE].iter().any(|mark| begins(line, mark))
}

#[cfg(feature = "cli")]
fn begins(line: &[u8], mark: &[u8]) -> bool {
    target::ALL.iter().any(|target| {
        let mark = [target.comments.open.as_bytes(), mark].concat();
        // A block number stands in front.
        let digits = line.iter().take_while(|b| b.is_ascii_digit()).count();
        let line = line[digits..].trim_ascii_start();
        line.get(..mark.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(&mark))
    })
}

#[cfg(feature = "cli")]
const MADE: &[u8] = b"partc ";
#[cfg(feature = "cli")]
const SOURCE: &[u8] = b"source ";
/// Lines of which one says who made the program.
#[cfg(feature = "cli")]
const MARKED: usize = 3;

/// Where the program text goes. The head holds a hash that is known only at the end, hence `patch`.
pub trait Output {
    /// Appends.
    ///
    /// # Errors
    /// What the operating system reports.
    fn append(&mut self, bytes: &[u8]) -> io::Result<()>;

    /// Replaces bytes that were appended before.
    ///
    /// # Errors
    /// What the operating system reports.
    fn patch(&mut self, at: u64, bytes: &[u8]) -> io::Result<()>;
}

impl Output for Vec<u8> {
    fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.extend_from_slice(bytes);
        Ok(())
    }

    fn patch(&mut self, at: u64, bytes: &[u8]) -> io::Result<()> {
        let at = at as usize;
        match self.get_mut(at..at + bytes.len()) {
            Some(place) => place.copy_from_slice(bytes),
            None => return Err(io::Error::other("patch outside the output")),
        }
        Ok(())
    }
}

/// Learns where each printed line comes from.
pub trait LineMap {
    /// Line `number` (1-based) of the output was caused by `origin`.
    fn line(&mut self, number: u64, origin: &Origin);
}
