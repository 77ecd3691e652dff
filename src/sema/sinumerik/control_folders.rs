//! Folders of the control: how they are written, and what they are called on this computer.
//!
//! Source: S 1.1 (docs/sources.md).

use crate::text::ControlFolder;

/// Definition files that a control reads at power-on, if they stand beside the program.
pub(super) const DEFINITION_FILES: &[&str] =
    &["SGUD", "MGUD", "UGUD", "GUD4", "GUD5", "GUD6", "GUD7", "GUD8", "GUD9", "SMAC", "MMAC", "UMAC"];

/// One folder of the root: its path, and the names of its copies.
macro_rules! folder {
    ($name:literal, $below:expr) => {
        ControlFolder {
            path: concat!("/_N_", $name, "_DIR"),
            copies: [concat!($name, ".DIR"), concat!("_N_", $name, "_DIR"), concat!($name, "_DIR"), $name],
            below: $below,
        }
    };
}

/// The folders of the control in which programs and definitions lie.
pub(crate) const FOLDERS: &[ControlFolder] = &[
    folder!("MPF", &[]),
    folder!("SPF", &[]),
    folder!("CUS", &[]),
    folder!("CMA", &[]),
    folder!("CST", &[]),
    folder!("DEF", &[]),
    folder!("WKS", &[".WPD", "_WPD"]),
];

/// A program in two folders of the control.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct TwoPlaces {
    /// Its name for people.
    pub shown: String,
    /// By the name of its folder here.
    pub by_name: String,
    pub by_line: String,
}

/// The folder that a `;$PATH=` line names.
pub(super) fn path_line(line: &[u8]) -> Option<String> {
    let (mark, path) = line.trim_ascii().split_at_checked(";$PATH=".len())?;
    let is_path = mark.eq_ignore_ascii_case(b";$PATH=") && path.starts_with(b"/");
    is_path.then(|| control_path(&String::from_utf8_lossy(path)))
}

/// The folder that a `;$PATH=` line names above the first block of a program, also where no head stands above it.
pub(super) fn path_line_on_top(text: &[u8]) -> Option<String> {
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let lines = text.split(|b| matches!(b, b'\n' | b'\r')).map(<[u8]>::trim_ascii);
    let mut top = lines.take_while(|line| line.is_empty() || line.starts_with(b";") || line.starts_with(b"%"));
    top.find_map(path_line)
}

/// The folder in which a program lies by the name of its folder on this computer: `SHAFT.WPD`, `_N_SHAFT_WPD` or `SHAFT_WPD`.
pub(super) fn home_path(home: &str) -> String {
    let path = control_path(home);
    match path.rsplit_once('/') {
        Some((above, last)) if !last.starts_with("_N_") => format!("{above}/_N_{last}"),
        _ => path,
    }
}

/// A folder of the control in one spelling: `/_N_WKS_DIR/_N_A_WPD`, which it may also call `/WKS.DIR/A.WPD`.
pub(super) fn control_path(path: &str) -> String {
    let upper = path.trim().to_ascii_uppercase().replace('\\', "/");
    let below = upper.strip_prefix("//NC:").unwrap_or(&upper);
    below.split('/').filter(|part| !part.is_empty()).fold(String::new(), |whole, part| match part.rsplit_once('.') {
        Some((stem, kind @ ("DIR" | "WPD"))) => format!("{whole}/_N_{stem}_{kind}"),
        _ => format!("{whole}/{part}"),
    })
}

/// The names under which a file of a folder of the control may lie on this computer: folders are copied as `_N_A_WPD` and
/// as `A.WPD`.
pub(super) fn names_below(folder: &str, file: &str) -> Vec<String> {
    let parts: Vec<&str> = folder.split('/').filter(|part| !part.is_empty()).collect();
    let short = |part: &str| -> String {
        let stem = part.strip_prefix("_N_").and_then(|part| part.rsplit_once('_'));
        stem.map_or_else(|| part.to_owned(), |(stem, kind)| format!("{stem}.{kind}"))
    };
    let named = |from: usize| {
        let part = |(at, part): (usize, &&str)| if at < from { (*part).to_owned() } else { short(part) };
        let folders: Vec<String> = parts.iter().enumerate().map(part).collect();
        format!("/{}/{file}", folders.join("/"))
    };
    let mut names: Vec<String> = (0..=parts.len()).rev().map(named).collect();
    names.dedup();
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_of_the_control_have_one_spelling() {
        for path in [
            "/_N_WKS_DIR/_N_A_WPD",
            "/_n_wks_dir/_N_A_WPD/",
            "/WKS.DIR/A.WPD",
            "\\WKS.DIR\\a.wpd",
            "//NC:/WKS.DIR/A.WPD",
        ] {
            assert_eq!(control_path(path), "/_N_WKS_DIR/_N_A_WPD", "{path}");
        }
        for folder in FOLDERS {
            assert!(folder.copies[..3].iter().all(|copy| {
                let path = format!("/_N_{copy}").replace("_N__N_", "_N_").replace('.', "_");
                path == folder.path
            }));
        }
        for home in ["/_N_WKS_DIR/A.WPD", "/_N_WKS_DIR/_N_A_WPD", "/_N_WKS_DIR/A_WPD"] {
            assert_eq!(home_path(home), "/_N_WKS_DIR/_N_A_WPD", "{home}");
        }
        assert_eq!(path_line_on_top(b"; a\n\n;$PATH=/SPF.DIR\nG0 X1\n").as_deref(), Some("/_N_SPF_DIR"));
        assert_eq!(path_line_on_top(b"G0 X1\n;$PATH=/SPF.DIR\n"), None);
        assert_eq!(path_line(b";$PATH=/_N_SPF_DIR\r").as_deref(), Some("/_N_SPF_DIR"));
        assert_eq!(
            (path_line(b"; $PATH=/_N_SPF_DIR"), path_line(b";$PATH=SPF"), path_line(b";$P")),
            (None, None, None)
        );
        assert_eq!(
            names_below("/_N_WKS_DIR/_N_A_WPD", "X.SPF"),
            ["/_N_WKS_DIR/_N_A_WPD/X.SPF", "/_N_WKS_DIR/A.WPD/X.SPF", "/WKS.DIR/A.WPD/X.SPF"]
        );
    }
}
