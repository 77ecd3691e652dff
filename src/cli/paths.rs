//! Paths of files: which are one, and which hold a source.

use std::fs;
use std::path::{Path, PathBuf};

use crate::dialect;

/// Extensions of files with tools, datums, points and settings.
pub(super) const TABLES: [&str; 10] = ["t", "tbl", "d", "pr", "pnt", "ini", "toa", "ufr", "csv", "toml"];

/// The one path of a file that may not exist yet.
pub(super) fn real(path: &Path) -> PathBuf {
    if let Ok(path) = fs::canonicalize(path) {
        return path;
    }
    let folder = path.parent().filter(|dir| !dir.as_os_str().is_empty()).unwrap_or(Path::new("."));
    fs::canonicalize(folder).unwrap_or_else(|_| folder.to_path_buf()).join(path.file_name().unwrap_or(path.as_os_str()))
}

pub(super) fn same_file(a: &Path, b: &Path) -> bool {
    match (fs::canonicalize(a), fs::canonicalize(b)) {
        (Ok(a), Ok(b)) => a == b && a.is_file(),
        _ => false,
    }
}

/// Is this the name of a program, a table or a configuration? No report belongs there.
pub(super) fn is_source_name(file: &Path) -> bool {
    let extension = file.extension().map(|name| name.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
    TABLES.contains(&extension.as_str()) || dialect::guess(&file.to_string_lossy(), b"").is_some()
}
