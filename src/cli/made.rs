//! What partc wrote is known again by how it begins: nothing else is replaced without being asked.

use std::fs::File;
use std::io::{self, Read as _, Seek as _, SeekFrom};
use std::path::Path;

use crate::emit::{is_printed, made_for, plot};
use crate::target::Target;

use super::regular::open_regular;

/// How every source map begins.
pub(super) const MAP_MARK: &str = "{\"version\":1,\"output\":";

/// How every report begins.
pub(super) const REPORT_MARK: &str = "<!doctype html>\n<!-- (partc report) -->\n";

/// How traces begin: moves as objects, as values behind their names, Arrow and Parquet.
const TRACE_MARKS: &[&[u8]] = &[b"{\"kind\":\"", b"kind,start_x,", b"ARROW1", b"PAR1"];

/// Forms that others write, too: their tables say that they are of partc.
const OF_MANY: &[&[u8]] = &[b"ARROW1", b"PAR1"];

/// What such a table says: the key of the version of the columns.
const TRACE_KEY: &[u8] = b"partc.trace";

/// Bytes at both ends of a table that hold what it says of itself.
const ABOUT: u64 = 1 << 18;

/// Bytes that tell what a file is.
const HEAD: u64 = 128;

/// What partc writes, and knows again.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Made {
    Program,
    Map,
    Picture,
    Report,
    Trace,
}

/// What a new file may take the place of, if it is there when the new one gets its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Replaces {
    Anything,
    /// What partc wrote.
    Ours(Made),
    /// The same, and the file that was there at the start, which somebody wants to be replaced.
    Forced(Made),
}

impl Replaces {
    pub(super) fn by(made: Made, force: bool) -> Replaces {
        if force { Replaces::Forced(made) } else { Replaces::Ours(made) }
    }
}

/// Would writing to `path` destroy a file that partc did not write? An empty file is nobody's.
pub(super) fn is_foreign(path: &Path, made: Made) -> bool {
    path.is_file() && head_of(path).is_none_or(|head| !head.is_empty() && !is_ours(path, &head, made))
}

/// Outputs that lie in a folder of programs are none.
pub(super) fn is_output(path: &Path) -> bool {
    path.metadata().is_ok_and(|meta| meta.len() > 0) && !is_foreign(path, Made::Program)
}

/// Did partc write the file that begins so?
pub(super) fn is_ours(path: &Path, head: &[u8], made: Made) -> bool {
    begins(head, made) && (made != Made::Trace || is_trace(path, head))
}

/// The target that the program in this file was made for, where partc made it.
pub(super) fn target_of(path: &Path) -> Option<&'static Target> {
    made_for(&head_of(path)?)
}

pub(super) fn head_of(path: &Path) -> Option<Vec<u8>> {
    let mut head = Vec::new();
    open_regular(path).and_then(|file| file.take(HEAD).read_to_end(&mut head)).ok().map(|_| head)
}

fn begins(head: &[u8], made: Made) -> bool {
    match made {
        Made::Program => is_printed(head),
        Made::Map => head.starts_with(MAP_MARK.as_bytes()),
        #[cfg(feature = "png")]
        Made::Picture if head.windows(plot::PNG_MARK.len()).any(|part| part == plot::PNG_MARK) => true,
        Made::Picture => head.starts_with(plot::MARK.as_bytes()),
        Made::Report => head.starts_with(REPORT_MARK.as_bytes()),
        Made::Trace => TRACE_MARKS.iter().any(|mark| head.starts_with(mark)),
    }
}

/// Is a file that begins as a trace one?
fn is_trace(path: &Path, head: &[u8]) -> bool {
    if head.starts_with(b"{") {
        let kind = head.strip_prefix(b"{\"kind\":\"").and_then(|rest| rest.split(|byte| *byte == b'"').next());
        if kind == Some(b"incomplete") {
            return head.starts_with(b"{\"kind\":\"incomplete\",\"code\":\"");
        }
        let known = [&b"rapid"[..], b"line", b"arc", b"thread"];
        return kind.is_some_and(|kind| known.contains(&kind) && head[9 + kind.len()..].starts_with(b"\",\"start\":{"));
    }
    if !OF_MANY.iter().any(|mark| head.starts_with(mark)) {
        return true;
    }
    let says = || -> io::Result<bool> {
        let (mut file, mut text) = (File::open(path)?, Vec::new());
        let length = file.metadata()?.len();
        (&mut file).take(ABOUT).read_to_end(&mut text)?;
        file.seek(SeekFrom::Start(length.saturating_sub(ABOUT)))?;
        file.take(ABOUT).read_to_end(&mut text)?;
        Ok(memchr::memmem::find(&text, TRACE_KEY).is_some())
    };
    says().unwrap_or(false)
}
