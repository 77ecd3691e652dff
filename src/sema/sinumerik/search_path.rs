//! Which program a call means: the folders of the control in their order, whether they come from the `;$PATH=` lines of an
//! archive, from the folder of the main program, or from the include roots.
//!
//! Of a name alone: the folder in which the *selected main program* lies, whoever calls; `/_N_SPF_DIR`; what CALLPATH names;
//! `/_N_CUS_DIR`, `/_N_CMA_DIR`, `/_N_CST_DIR`. Other workpieces are never searched. A path means that folder alone.
//! Nothing is reported here, and nothing is added to the files of the run. Source: S 5.6 (docs/sources.md).

use crate::machine::options::sinumerik::CalledFirst;
use crate::sema::Job;
use crate::text::{FileError, FileId, Opened, Request, Within};

use super::control_folders::TwoPlaces;
use super::control_folders::{control_path, names_below, path_line, path_line_on_top};
use super::programs::{UnitKind, Units, bare_name, header_name, without_extension};

/// Where programs lie whose folder no line names.
const MAIN_PROGRAMS: &str = "/_N_MPF_DIR";
/// Global subprograms.
const SUBPROGRAMS: &str = "/_N_SPF_DIR";
/// Cycles of the user, of the machine builder and of the control, in the order of the search.
const CYCLES: [&str; 3] = ["/_N_CUS_DIR", "/_N_CMA_DIR", "/_N_CST_DIR"];

/// What is searched for one call.
pub(super) struct SearchPath<'r, 'a> {
    pub job: &'r Job<'a>,
    pub units: &'r Units,
    /// The files whose programs are known: that of the main program, and that of the caller. Their programs are listed.
    pub files: [(usize, FileId); 2],
    /// The folder that CALLPATH adds.
    pub call_path: Option<&'r str>,
}

/// Where a program is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum At {
    /// One of the programs that are known.
    Unit(usize),
    File(FileAt),
}

/// A file as it is asked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct FileAt {
    pub name: String,
    pub within: Within,
    /// Its name for people.
    pub shown: String,
    identity: String,
    /// The folder of the control, where a root stands for it.
    pub folder: Option<String>,
}

/// What came of the search.
#[derive(Debug)]
pub(super) enum Found {
    One(At),
    /// The path names a folder that nothing is known of; the program of this name has no folder, and is taken.
    Unplaced(usize, String),
    /// By its own `;$PATH=` line the file lies in this folder, where nothing looks; it lies beside the main program, which names no
    /// folder, and is taken.
    BesideByLine(FileAt, String),
    /// The name of a folder of this computer and a `;$PATH=` line place a program in two folders of the control.
    TwoPlaces(TwoPlaces),
    /// Programs of one rank.
    Several(Vec<At>),
    /// NAME_SPF and NAME_MPF beside each other.
    BothKinds(At, At),
    /// One is found, but behind the folder that CALLPATH names, of which nothing is known.
    BehindUnknown(String),
    Nowhere(Nowhere),
    /// What is found cannot be opened: under this name.
    Fails(FileError, String),
}

/// A program that is not found.
#[derive(Debug, Default)]
pub(super) struct Nowhere {
    /// Files that were looked for.
    pub tried: Vec<String>,
    /// A file with a similar name.
    pub like: Option<String>,
    /// Programs of this name where the control does not look.
    pub elsewhere: Vec<String>,
}

/// The ending of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Ending {
    /// A file without an ending; no control has one.
    None,
    Sub,
    Main,
}

#[derive(Debug, Clone)]
struct Candidate {
    ending: Ending,
    at: At,
}

/// A name as a call writes it.
struct Called {
    /// Upper case, without folder, `_N_` and ending.
    bare: String,
    /// The ending that it says.
    ending: Option<Ending>,
    /// A path of the control, or one from where the program is.
    folder: Option<String>,
}

impl Called {
    fn of(name: &str) -> Called {
        let name = name.replace('\\', "/");
        let (folder, last) = match name.rsplit_once('/') {
            Some((folder, last)) => (Some(folder), last),
            None => (None, name.as_str()),
        };
        let upper = last.to_ascii_uppercase();
        let ends =
            |ending: &str| upper.strip_suffix(ending).is_some_and(|stem| stem.ends_with(['_', '.']) && stem.len() > 1);
        let ending = if ends("SPF") { Some(Ending::Sub) } else { ends("MPF").then_some(Ending::Main) };
        let bare = without_extension(&bare_name(&upper).0).to_owned();
        Called { bare, ending, folder: folder.map(str::to_owned) }
    }

    fn takes(&self, ending: Ending) -> bool {
        self.ending.is_none_or(|said| said == ending)
    }

    /// The files that it may be.
    fn files(&self, endings: &[Ending]) -> Vec<(Ending, String)> {
        let of = |ending: &Ending| match ending {
            Ending::None => (*ending, self.bare.clone()),
            Ending::Sub => (*ending, format!("{}.SPF", self.bare)),
            Ending::Main => (*ending, format!("{}.MPF", self.bare)),
        };
        endings.iter().filter(|ending| self.takes(**ending)).map(of).collect()
    }
}

/// Endings in the folder of the main program, and in the others: what ends in `_MPF` is not looked for there.
const ALL: &[Ending] = &[Ending::None, Ending::Sub, Ending::Main];
const SUB: &[Ending] = &[Ending::None, Ending::Sub];

/// A search under way.
struct Search<'s, 'r, 'a> {
    path: &'s SearchPath<'r, 'a>,
    called: Called,
    /// The folder of the main program by its `;$PATH=` line.
    main: Option<&'s str>,
    /// Files beside the main program that lie in another folder by their own line.
    strays: Vec<(String, Candidate)>,
    /// The same beside a main program without such a line.
    placed: Vec<(String, FileAt)>,
    nowhere: Nowhere,
    failed: Option<(FileError, String)>,
}

impl SearchPath<'_, '_> {
    /// Looks for the program `name`.
    pub fn look(&self, name: &str) -> Found {
        let contradicted = self.main_in_two_places();
        let line = self.units.main().and_then(|unit| self.units.list[unit].folder.as_deref());
        let main = contradicted.as_ref().map_or(line, |places| Some(places.by_line.as_str()));
        let mut search = Search {
            path: self,
            called: Called::of(name),
            main,
            strays: Vec::new(),
            placed: Vec::new(),
            nowhere: Nowhere::default(),
            failed: None,
        };
        let found = match search.called.folder.clone() {
            None => search.by_name(),
            Some(_) if name.contains(':') => search.on_drive(name),
            Some(folder) if folder.starts_with('/') || folder.is_empty() => search.by_path(&control_path(&folder)),
            Some(folder) => search.by_relative_path(&folder),
        };
        match (found, search.failed.take()) {
            (Some(found), _) => self.unless_in_two_places(found, contradicted.as_ref()),
            (None, Some((error, name))) => Found::Fails(error, name),
            (None, None) => {
                search.look_elsewhere();
                Found::Nowhere(search.nowhere)
            }
        }
    }

    /// Is a program of this name there, however often?
    pub fn is_there(&self, name: &str) -> bool {
        match self.look(name) {
            Found::Nowhere(_) => false,
            // What cannot be opened is there.
            Found::Fails(error, _) => !matches!(error, FileError::NotFound { .. } | FileError::NoRoot { .. }),
            Found::One(_)
            | Found::Unplaced(..)
            | Found::BesideByLine(..)
            | Found::TwoPlaces(_)
            | Found::Several(_)
            | Found::BothKinds(..)
            | Found::BehindUnknown(_) => true,
        }
    }

    /// Is the folder known, by a root or by an archive?
    pub fn knows(&self, folder: &str) -> bool {
        let holds = self.units.list.iter().any(|unit| unit.folder.as_deref() == Some(folder));
        let ask = |name: &String| !matches!(self.open(name, Within::Main), Err(FileError::NoRoot { .. }));
        holds || names_below(folder, "").iter().any(ask)
    }

    pub(super) fn open(&self, name: &str, within: Within) -> Result<Opened, FileError> {
        let from = self.job.sources.identity(self.files[1].1);
        self.job.files.open(&Request { from: &from, name, extensions: &[], within })
    }
}

impl Search<'_, '_, '_> {
    /// A name alone: along the search path.
    fn by_name(&mut self) -> Option<Found> {
        let current = self.current();
        if let Some(found) = self.pick(current) {
            let found = self.unless_rivalled(found);
            let found = self.unless_placed_elsewhere(found);
            return Some(self.unless_stray(found));
        }
        let mut unknown = None;
        let call_path = self.path.call_path;
        for folder in [SUBPROGRAMS].into_iter().chain(call_path).chain(CYCLES) {
            let candidates = self.of_folder(folder, SUB);
            if let Some(found) = self.pick(candidates) {
                return Some(unknown.map_or_else(|| self.unless_stray(found), Found::BehindUnknown));
            }
            if Some(folder) == call_path && !self.path.knows(folder) {
                unknown = Some(folder.to_owned());
            }
        }
        None
    }

    /// A path of the control: that folder alone.
    fn by_path(&mut self, folder: &str) -> Option<Found> {
        let mut candidates = self.of_folder(folder, ALL);
        if self.main == Some(folder) {
            candidates = self.current();
        }
        if let Some(found) = self.pick(candidates) {
            return Some(found);
        }
        if self.path.knows(folder) && matches!(self.failed, Some((FileError::NoRoot { .. }, _))) {
            self.failed = None;
        }
        let unplaced = self.units(|of_unit| of_unit.is_none());
        match self.pick(unplaced)? {
            Found::One(At::Unit(unit)) => {
                let default = match self.path.units.list[unit].kind {
                    UnitKind::Sub => SUBPROGRAMS,
                    UnitKind::Main | UnitKind::Other => MAIN_PROGRAMS,
                };
                Some(if folder == default {
                    Found::One(At::Unit(unit))
                } else if self.path.units.list.iter().any(|unit| unit.folder.is_some()) {
                    // An archive that names folders means them.
                    return None;
                } else {
                    Found::Unplaced(unit, folder.to_owned())
                })
            }
            found => Some(found),
        }
    }

    /// A path that does not begin at the root of the control: one of external memory.
    fn by_relative_path(&mut self, folder: &str) -> Option<Found> {
        let mut candidates = self.units(|of_unit| of_unit.is_none() || of_unit == self.main);
        for (ending, name) in self.called.files(ALL) {
            self.ask(ending, &format!("{folder}/{name}"), Within::Anywhere, None, &mut candidates);
        }
        self.pick(candidates)
    }

    fn on_drive(&mut self, name: &str) -> Option<Found> {
        let mut candidates = Vec::new();
        let folder = name.rsplit_once(['/', '\\']).map_or("", |(folder, _)| folder);
        for (ending, file) in self.called.files(ALL) {
            self.ask(ending, &format!("{folder}/{file}"), Within::Anywhere, None, &mut candidates);
        }
        self.pick(candidates)
    }

    /// What lies in the folder of the main program.
    fn current(&mut self) -> Vec<Candidate> {
        let main = self.main;
        let mut candidates = self.units(|of_unit| of_unit.is_none_or(|folder| folder == main.unwrap_or(MAIN_PROGRAMS)));
        let mut beside = Vec::new();
        for (ending, name) in self.called.files(ALL) {
            self.ask(ending, &name, Within::Main, None, &mut beside);
        }
        for candidate in beside {
            // The main program itself lies there.
            if matches!(&candidate.at, At::File(file) if self.is_known(file, &candidates)) {
                continue;
            }
            match self.own_line(&candidate) {
                Some(own) if main.is_some_and(|main| main != own) => self.strays.push((own, candidate)),
                Some(own) => {
                    if let (At::File(file), None) = (&candidate.at, main) {
                        self.placed.push((own, file.clone()));
                    }
                    add(candidate, &mut candidates);
                }
                None => add(candidate, &mut candidates),
            }
        }
        if let Some(folder) = main {
            self.of_roots(folder, ALL, &mut candidates);
        }
        candidates
    }

    /// The folder that the head of a file names.
    fn own_line(&self, candidate: &Candidate) -> Option<String> {
        let At::File(file) = &candidate.at else { return None };
        let head = self.path.head_of(file)?;
        if self.path.job.files.home().is_some() {
            return path_line_on_top(&head);
        }
        let mut lines = head.split(|b| matches!(b, b'\n' | b'\r')).filter(|line| !line.trim_ascii().is_empty());
        header_name(lines.next()?)?;
        path_line(lines.next()?)
    }

    /// What lies in another folder.
    fn of_folder(&mut self, folder: &str, endings: &[Ending]) -> Vec<Candidate> {
        let mut candidates = self.units(|of_unit| of_unit == Some(folder));
        candidates.retain(|candidate| endings.contains(&candidate.ending));
        let strays = self.strays.iter().filter(|(own, stray)| own == folder && endings.contains(&stray.ending));
        strays.for_each(|(_, stray)| add(stray.clone(), &mut candidates));
        self.of_roots(folder, endings, &mut candidates);
        candidates
    }

    fn of_roots(&mut self, folder: &str, endings: &[Ending], candidates: &mut Vec<Candidate>) {
        for (ending, name) in self.called.files(endings) {
            for name in names_below(folder, &name) {
                self.ask(ending, &name, Within::Main, Some(folder), candidates);
            }
        }
    }

    /// Programs of the known files.
    fn units(&self, is_there: impl Fn(Option<&str>) -> bool) -> Vec<Candidate> {
        let SearchPath { units, files, .. } = self.path;
        let mut candidates = Vec::new();
        for (at, unit) in units.list.iter().enumerate() {
            let ending = if unit.kind == UnitKind::Sub { Ending::Sub } else { Ending::Main };
            let fits = unit.kind != UnitKind::Other && unit.name == self.called.bare && self.called.takes(ending);
            if fits && files.iter().any(|(file, _)| *file == unit.file) && is_there(unit.folder.as_deref()) {
                candidates.push(Candidate { ending, at: At::Unit(at) });
            }
        }
        candidates
    }

    /// Asks for a file, also by the name that it has on the control: `_N_DRILL_SPF` is DRILL.SPF. Upper and lower case of its ending
    /// may matter to who keeps the files.
    fn ask(
        &mut self,
        ending: Ending,
        name: &str,
        within: Within,
        folder: Option<&str>,
        candidates: &mut Vec<Candidate>,
    ) {
        let (lower, of_control) = match ending {
            Ending::None => (None, None),
            Ending::Sub => (name.strip_suffix("SPF").map(|stem| format!("{stem}spf")), of_control(name)),
            Ending::Main => (name.strip_suffix("MPF").map(|stem| format!("{stem}mpf")), of_control(name)),
        };
        let mut is_found = false;
        for (name, is_usual) in [(Some(name.to_owned()), true), (lower, true), (of_control, false)] {
            let Some(name) = name.filter(|_| !(is_found && is_usual)) else { continue };
            match self.path.open(&name, within) {
                Ok(Opened { name: shown, identity, .. }) => {
                    is_found = true;
                    let folder = folder.map(str::to_owned);
                    let file = FileAt { name, within, shown, identity, folder };
                    if !self.is_stray(&file) && !self.is_known(&file, candidates) {
                        add(Candidate { ending, at: At::File(file) }, candidates);
                    }
                }
                Err(FileError::NotFound { .. }) if !is_usual => {}
                Err(FileError::NotFound { tried, similar }) => {
                    let tried = tried.iter().map(|name| name.rsplit('/').next().unwrap_or(name).to_owned());
                    let fresh: Vec<_> = tried.filter(|name| !self.nowhere.tried.contains(name)).collect();
                    self.nowhere.tried.extend(fresh);
                    self.nowhere.like = self.nowhere.like.take().or(similar.into_iter().next());
                }
                // Of the folders that are searched anyway not all need a root.
                Err(FileError::NoRoot { .. }) if self.called.folder.is_none() => return,
                Err(error) => {
                    let is_first = self.failed.is_none();
                    let replaces = matches!(self.failed, Some((FileError::NoRoot { .. }, _)));
                    if is_first || replaces && !matches!(error, FileError::NoRoot { .. }) {
                        self.failed = Some((error, name));
                    }
                    return;
                }
            }
        }
    }

    /// Does it lie in another folder by its own line? Who keeps all files in one place answers for any folder.
    fn is_stray(&self, file: &FileAt) -> bool {
        self.strays.iter().any(|(_, stray)| matches!(&stray.at, At::File(stray) if stray.identity == file.identity))
    }

    /// Is it the file of a program that is a candidate already?
    fn is_known(&self, file: &FileAt, candidates: &[Candidate]) -> bool {
        let SearchPath { job, units, files, .. } = self.path;
        candidates.iter().any(|candidate| {
            let At::Unit(unit) = candidate.at else { return false };
            let of_unit = files.iter().find(|(at, _)| *at == units.list[unit].file);
            of_unit.is_some_and(|(_, id)| job.sources.identity(*id) == file.identity)
        })
    }

    /// The one that runs of all that lie in one folder.
    fn pick(&mut self, candidates: Vec<Candidate>) -> Option<Found> {
        if matches!(
            self.failed,
            Some((FileError::Ambiguous { .. } | FileError::Io { .. } | FileError::Forbidden { .. }, _))
        ) {
            return self.failed.take().map(|(error, name)| Found::Fails(error, name));
        }
        if candidates.len() < 2 {
            return candidates.into_iter().next().map(|one| Found::One(one.at));
        }
        let of =
            |ending| candidates.iter().filter(move |one| one.ending == ending).map(|one| &one.at).collect::<Vec<_>>();
        let (none, sub, main) = (of(Ending::None), of(Ending::Sub), of(Ending::Main));
        let first = self.path.job.settings.control.sinumerik.called_first;
        Some(match (none.is_empty(), &sub[..], &main[..], first) {
            (true, [sub], [_, ..], Some(CalledFirst::Sub)) => Found::One((*sub).clone()),
            (true, [_, ..], [main], Some(CalledFirst::Main)) => Found::One((*main).clone()),
            (true, [sub], [main], None) => Found::BothKinds((*sub).clone(), (*main).clone()),
            _ => Found::Several(candidates.into_iter().map(|candidate| candidate.at).collect()),
        })
    }

    /// A program without a `;$PATH=` line lies in the folder of the main program, or where the control puts what has no
    /// line. Both readings have to lead to the same one.
    fn unless_rivalled(&self, found: Found) -> Found {
        let Found::One(At::Unit(unit)) = found else { return found };
        let chosen = &self.path.units.list[unit];
        if chosen.folder.is_some() {
            return found;
        }
        let is_rival = |folder: Option<&str>| match (folder, chosen.kind) {
            (Some(folder), UnitKind::Sub) => folder == SUBPROGRAMS,
            (Some(folder), _) => {
                self.main.is_some_and(|main| main != MAIN_PROGRAMS)
                    && (folder == SUBPROGRAMS || CYCLES.contains(&folder) || self.path.call_path == Some(folder))
            }
            (None, _) => false,
        };
        let mut all = vec![At::Unit(unit)];
        all.extend(self.units(is_rival).into_iter().map(|rival| rival.at));
        if all.len() > 1 { Found::Several(all) } else { Found::One(At::Unit(unit)) }
    }

    /// A file beside a main program without a `;$PATH=` line lies there, or in the folder that its own line names. Both readings have
    /// to lead to the same program.
    fn unless_placed_elsewhere(&mut self, found: Found) -> Found {
        let Found::One(At::File(file)) = found else { return found };
        let Some((own, _)) = self.placed.iter().find(|(_, placed)| placed.identity == file.identity).cloned() else {
            return Found::One(At::File(file));
        };
        let mut all = vec![Candidate { ending: Ending::None, at: At::File(file.clone()) }];
        let mut is_searched = own == MAIN_PROGRAMS;
        for folder in [SUBPROGRAMS].into_iter().chain(self.path.call_path).chain(CYCLES) {
            let others = self.of_folder(folder, SUB);
            others.into_iter().for_each(|other| add(other, &mut all));
            is_searched |= own == folder;
            if is_searched {
                break;
            }
        }
        match (all.len(), is_searched) {
            (1, true) => Found::One(At::File(file)),
            (1, false) => Found::BesideByLine(file, own),
            _ => Found::Several(all.into_iter().map(|candidate| candidate.at).collect()),
        }
    }

    /// A file beside the main program lies there, too, whatever folder its own line names: it may be no other one than the one that runs.
    fn unless_stray(&self, found: Found) -> Found {
        let Found::One(at) = found else { return found };
        let mut all = vec![Candidate { ending: Ending::None, at: at.clone() }];
        self.strays.iter().for_each(|(_, stray)| add(stray.clone(), &mut all));
        if all.len() > 1 {
            Found::Several(all.into_iter().map(|candidate| candidate.at).collect())
        } else {
            Found::One(at)
        }
    }

    /// Programs of this name where nothing looks.
    fn look_elsewhere(&mut self) {
        for candidate in self.units(|_| true) {
            if let At::Unit(unit) = candidate.at
                && let Some(folder) = &self.path.units.list[unit].folder
            {
                self.nowhere.elsewhere.push(format!("in `{folder}` of this archive"));
            }
        }
        for (own, stray) in &self.strays {
            if let At::File(file) = &stray.at {
                self.nowhere
                    .elsewhere
                    .push(format!("as `{}`, which by its `;$PATH=` line lies in `{own}`", file.shown));
            }
        }
        for (_, name) in self.called.files(ALL) {
            let names = match self.path.open(&name, Within::Anywhere) {
                Ok(opened) => vec![opened.name],
                Err(FileError::Ambiguous { names }) => names,
                Err(_) => Vec::new(),
            };
            self.nowhere.elsewhere.extend(names.iter().map(|name| format!("as `{name}`")));
        }
    }
}

/// The name of a file as the control has it: `/_N_SPF_DIR/DRILL.SPF` is `/_N_SPF_DIR/_N_DRILL_SPF`.
fn of_control(name: &str) -> Option<String> {
    let (folder, last) = name.rsplit_once('/').map_or(("", name), |(folder, _)| name.split_at(folder.len() + 1));
    let (stem, ending) = last.rsplit_once('.')?;
    Some(format!("{folder}_N_{stem}_{ending}"))
}

/// A file may be reached by two names.
fn add(candidate: Candidate, candidates: &mut Vec<Candidate>) {
    let same = |known: &Candidate| match (&known.at, &candidate.at) {
        (At::File(known), At::File(file)) => known.identity == file.identity,
        (known, at) => known == at,
    };
    if !candidates.iter().any(same) {
        candidates.push(candidate);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_calls_are_read_apart() {
        for (name, bare, ending, folder) in [
            ("drill", "DRILL", None, None),
            ("DRILL_SPF", "DRILL", Some(Ending::Sub), None),
            ("_N_DRILL_MPF", "DRILL", Some(Ending::Main), None),
            ("drill.spf", "DRILL", Some(Ending::Sub), None),
            ("/_N_SPF_DIR/_N_DRILL_SPF", "DRILL", Some(Ending::Sub), Some("/_N_SPF_DIR")),
            ("SUB\\DRILL", "DRILL", None, Some("SUB")),
        ] {
            let called = Called::of(name);
            assert_eq!(
                (called.bare.as_str(), called.ending, called.folder.as_deref()),
                (bare, ending, folder),
                "{name}"
            );
        }
    }
}
