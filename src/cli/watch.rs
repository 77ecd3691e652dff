//! `partc watch`: checks again when a program, a file beside it or its configuration changes.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::{Duration, SystemTime};

use crate::dialect;

use super::args::Watch;
use super::backup::Backup;
use super::config;
use super::inputs::inputs;
use super::paths::TABLES;
use super::program::is_program;
use super::run::check;
use super::{Exit, Trouble, say};

/// Between two looks at the files.
const PAUSE: Duration = Duration::from_millis(400);

/// When each file was written last, and how large it is.
type State = BTreeMap<PathBuf, (Option<SystemTime>, u64)>;

/// `partc watch`; it ends when it is stopped.
pub(super) fn watch(args: &Watch) -> Result<Exit, Trouble> {
    let check_args = &args.check;
    if check_args.fix || check_args.diff || check_args.add_ignores {
        return Err("watch writes nothing: --fix, --diff and --add-ignores belong to check".to_owned());
    }
    if check_args.paths.iter().any(|path| path.as_os_str() == "-") || check_args.many.files_from.is_some() {
        return Err("watch needs files and folders: standard input does not change".to_owned());
    }
    // A name that is wrong from the start is a slip of the pen; what goes away later may come back.
    for path in &check_args.paths {
        fs::metadata(path).map_err(|error| format!("{}: {error}", path.display()))?;
    }
    let mut before = state(args)?;
    loop {
        if let Err(trouble) = check(check_args) {
            say(&format!("partc: {trouble}"));
        }
        say("partc: waits for changes; Ctrl-C ends");
        before = changed(args, before)?;
    }
}

/// Waits until something is different, and stays so for a pause: editors write in several steps.
fn changed(args: &Watch, before: State) -> Result<State, Trouble> {
    let mut last = before.clone();
    loop {
        sleep(PAUSE);
        let now = state(args)?;
        if now != before && now == last {
            return Ok(now);
        }
        last = now;
    }
}

fn state(args: &Watch) -> Result<State, Trouble> {
    let check = &args.check;
    let programs = inputs(&check.paths, &check.many, &|path| is_program(path, &check.common))?.list;
    let mut folders = BTreeSet::new();
    let mut files = State::new();
    for input in &programs {
        look_at(&mut files, &input.path);
        let folder = input.path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if folders.insert(folder.to_path_buf()) {
            config::files_above(folder, &check.common).iter().for_each(|file| look_at(&mut files, file));
            // Called programs may lie in the include roots.
            if let Ok(settings) = config::settings(&input.path, &check.common) {
                let roots = settings.include.roots;
                // Which language it is makes no difference to what may change.
                for dialect in dialect::ALL {
                    folders
                        .extend(Backup::around(folder, dialect.folders, roots.keys()).folders().map(Path::to_path_buf));
                }
                folders.extend(roots.into_values());
            }
        }
    }
    for folder in folders {
        let entries = fs::read_dir(&folder).into_iter().flatten().flatten();
        // Not what this or another command writes there.
        let counts = |path: &Path| {
            let extension =
                path.extension().map(|name| name.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
            let of_program = dialect::ALL.iter().any(|dialect| dialect.extensions.contains(&extension.as_str()));
            (of_program || TABLES.contains(&extension.as_str())) && args.check.output.as_deref() != Some(path)
        };
        entries.map(|entry| entry.path()).filter(|path| counts(path)).for_each(|path| look_at(&mut files, &path));
    }
    Ok(files)
}

fn look_at(files: &mut State, path: &Path) {
    if let Ok(known) = fs::metadata(path)
        && known.is_file()
    {
        files.insert(path.to_path_buf(), (known.modified().ok(), known.len()));
    }
}
