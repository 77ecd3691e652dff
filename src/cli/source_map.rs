//! The source map: a JSON document with one object for each output line that a block caused.

use std::io::{self, BufWriter, Write as _};
use std::path::Path;

use serde_json::json;

use crate::driver::Session;
use crate::emit::LineMap;
use crate::ir::Origin;
use crate::text::decode::escaped_json;

use super::disk::file_name;
use super::made::{MAP_MARK, Made, Replaces};
use super::output::{Destination, ignore_closed_pipe};

pub(super) struct SourceMap<'a> {
    out: BufWriter<Destination>,
    session: &'a Session,
    first: bool,
    error: Option<io::Error>,
}

impl<'a> SourceMap<'a> {
    pub fn create(path: &Path, output: &Path, session: &'a Session, force: bool) -> io::Result<SourceMap<'a>> {
        let mut out = BufWriter::new(Destination::open_for(path, Replaces::by(Made::Map, force))?);
        let output = json!(file_name(output));
        let output = output.to_string();
        write!(out, "{MAP_MARK}{},\"lines\":[", escaped_json(&output))?;
        Ok(SourceMap { out, session, first: true, error: None })
    }

    fn write(&mut self, number: u64, origin: &Origin) -> io::Result<()> {
        let sources = &self.session.sources;
        let stack: Vec<_> = self
            .session
            .trail
            .sites(origin.call)
            .iter()
            .map(|site| json!({ "file": sources.name(site.file), "line": site.line }))
            .collect();
        let comma = if std::mem::take(&mut self.first) { "\n" } else { ",\n" };
        let file = sources.name(origin.loc.file);
        let line = json!({ "line": number, "file": file, "source_line": origin.loc.line, "stack": stack });
        write!(self.out, "{comma}{}", escaped_json(&line.to_string()))
    }

    pub fn finish(mut self) -> io::Result<Destination> {
        if let Some(error) = self.error {
            return Err(error);
        }
        writeln!(self.out, "\n]}}")?;
        self.out.into_inner().map_err(io::IntoInnerError::into_error)
    }
}

impl LineMap for SourceMap<'_> {
    fn line(&mut self, number: u64, origin: &Origin) {
        if self.error.is_none()
            && let Err(error) = self.write(number, origin)
        {
            self.error = Some(error);
        }
    }
}

/// Gives an output its name, and its map one behind it. In between there is no map, so that none tells of another output than
/// the one beside it, wherever the process is killed. `name_output` says whether the output has its name.
///
/// # Errors
/// What the system reports; a map that may not be replaced, and then nothing has a name.
pub(super) fn name_with(map: Destination, name_output: impl FnOnce() -> bool) -> io::Result<()> {
    map.clear_name()?;
    if name_output() { map.commit().or_else(ignore_closed_pipe) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    /// What a process leaves that is killed between two steps.
    #[test]
    fn a_map_never_tells_of_another_output() {
        let folder = std::env::temp_dir().join(format!("partc-map-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        let (output, path) = (folder.join("A.ngc"), folder.join("A.map"));
        let old = format!("{MAP_MARK}\"old\"}}");
        let new = format!("{MAP_MARK}\"new\"}}");
        for fails in [true, false] {
            fs::write(&output, "old").unwrap();
            fs::write(&path, &old).unwrap();
            let mut map = Destination::open_for(&path, Replaces::Ours(Made::Map)).unwrap();
            map.write_all(new.as_bytes()).unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), old);
            let named = name_with(map, || {
                assert!(!path.exists(), "the older map is still there");
                if !fails {
                    fs::write(&output, "new").unwrap();
                }
                assert!(!path.exists());
                !fails
            });
            named.unwrap();
            assert_eq!(fs::read_to_string(&path).ok(), (!fails).then(|| new.clone()));
        }
        fs::remove_dir_all(&folder).unwrap();
    }
}
