//! The program that a call names: found, opened, or reported with what stands in the way.
//!
//! Source: S 5.6 (docs/sources.md).

use std::rc::Rc;

use crate::diag::{Answer, Diagnostic, Help, Label, codes};
use crate::machine::StandIn;
use crate::sema::run::{Wanted, Where, no_root, not_opened, open_program};
use crate::text::{FileError, Loc, Request, Span, Within};

use super::control_folders::{TwoPlaces, control_path};
use super::levels::unit;
use super::programs::{Skeleton, Unit, UnitKind, Units, bare_name, without_extension};
use super::search_path::{At, FileAt, Found, Nowhere, SearchPath};
use super::{Core, Outcome, Reported};

/// Why a program is not found.
pub(super) enum Missing {
    Reported,
    Nowhere(Nowhere),
}

impl Units {
    /// Finds the program `name` and reports one that is nowhere.
    pub(super) fn find_program(&mut self, core: &mut Core<'_>, name: &str, span: Span) -> Outcome<usize> {
        self.look_for(core, name, span).or_else(|missing| match missing {
            Missing::Reported => Err(Reported),
            Missing::Nowhere(nowhere) => {
                let help = "put the program beside this one or into an include root; or correct the word";
                self.program_missing(core, &called_name(name), nowhere, help, span)
            }
        })
    }

    /// Looks for the program `name` along the search path of the control; for the one that `[programs]` gives in its place,
    /// where it is nowhere there.
    pub(super) fn look_for(&mut self, core: &mut Core<'_>, name: &str, span: Span) -> Result<usize, Missing> {
        let file = self.list[unit(&core.levels)].file;
        // What cannot be listed was reported when it was opened.
        let _ = self.list_beside(core, file);
        let key = (file, name.to_owned());
        if let Some(&unit) = self.found.get(&key) {
            return Ok(unit);
        }
        if self.missing.contains(&key) {
            let again = codes::S2002::there_is_no_program(&name).at(core.loc(span));
            if core.job.diags.knows(&again) {
                core.report(again);
                core.go_on_in_doubt();
                return Err(Missing::Reported);
            }
        }
        let plain = called_name(name);
        let found = match self.file_in_place_of(core, without_extension(&plain)) {
            Some(stand_in) => self.open_stand_in(core, &stand_in, &plain, span),
            None => self.found_at(core, name, span),
        };
        match found {
            Ok(unit) => drop(self.found.insert(key, unit)),
            Err(Missing::Nowhere(_)) => drop(self.missing.insert(key)),
            Err(Missing::Reported) => {}
        }
        found
    }

    fn found_at(&mut self, core: &mut Core<'_>, name: &str, span: Span) -> Result<usize, Missing> {
        let found = self.search(core, |path| path.look(name));
        let loc = core.loc(span);
        let said = match found {
            Found::One(At::Unit(unit)) => return Ok(unit),
            Found::One(At::File(file)) => {
                return self.open_file(core, &file.name, file.within, Some((name, &file)), span);
            }
            Found::Unplaced(unit, folder) => {
                let program = &self.list[unit].name;
                core.report(codes::P0107::no_folder_is_known(&folder, &program).at(loc));
                return Ok(unit);
            }
            Found::BesideByLine(file, folder) => {
                core.report(codes::P0107::by_its_path_line_lies(&file.shown, &folder).at(loc));
                return self.open_file(core, &file.name, file.within, Some((name, &file)), span);
            }
            Found::Nowhere(nowhere) => return Err(Missing::Nowhere(nowhere)),
            Found::Fails(FileError::NotFound { tried, similar }, _) => {
                let like = similar.into_iter().next();
                return Err(Missing::Nowhere(Nowhere { tried, like, elsewhere: Vec::new() }));
            }
            Found::Fails(error, asked) => {
                core.report(not_opened(error, &asked, loc));
                core.stop_run();
                return Err(Missing::Reported);
            }
            Found::TwoPlaces(places) => in_two_places(&places, loc),
            Found::Several(places) => self.several(core, name, &places, loc),
            Found::BothKinds(sub, main) => self.both_kinds(core, name, [&sub, &main], loc),
            Found::BehindUnknown(folder) => {
                let found = no_root(&folder, loc);
                found.here(format!("CALLPATH names the folder: it may have `{}`, too", called_name(name)))
            }
        };
        core.report(said);
        core.go_on_in_doubt();
        Err(Missing::Reported)
    }

    /// Asks the search path, as it is for the program that runs.
    pub(super) fn search<T>(&mut self, core: &mut Core<'_>, ask: impl FnOnce(&SearchPath<'_, '_>) -> T) -> T {
        core.budget.search();
        let file = self.list[unit(&core.levels)].file;
        let core = &*core;
        let of = |file: usize| (file, core.programs.get(file).map_or(core.job.main, |program| program.source.file));
        let call_path = self.call_path.as_deref();
        ask(&SearchPath { job: &core.job, units: self, files: [of(0), of(file)], call_path })
    }

    /// Opens the file that `[programs]` gives.
    fn open_stand_in(&mut self, core: &mut Core<'_>, file: &str, name: &str, span: Span) -> Result<usize, Missing> {
        let request = Request { from: "", name: file, extensions: &[], within: Within::Configured };
        if let Err(FileError::NotFound { .. }) = core.job.files.open(&request) {
            core.report(codes::S2002::there_is_no_program_and_no(&name, &file).at(core.loc(span)));
            core.go_on_in_doubt();
            return Err(Missing::Reported);
        }
        self.open_file(core, file, Within::Configured, None, span)
    }

    /// Opens a file that was found, and says which of its programs the call means.
    fn open_file(
        &mut self,
        core: &mut Core<'_>,
        asked: &str,
        within: Within,
        found: Option<(&str, &FileAt)>,
        span: Span,
    ) -> Result<usize, Missing> {
        let loc = core.loc(span);
        let wanted = Wanted { name: asked, extensions: &[], within };
        let opened = open_program(&core.job, &wanted, loc, core.here.origin.call);
        let Some(file) = opened.and_then(|id| core.open(id, loc)) else {
            core.stop_run();
            return Err(Missing::Reported);
        };
        let first = self.first_of(&core.job, &core.programs, file);
        let file = self.list[first].file;
        if self.list_programs(core, file).is_err() {
            return Ok(first);
        }
        let Some((name, at)) = found else { return Ok(first) };
        if let Some(folder) = &at.folder {
            self.lie_in(file, folder);
            self.note_copy(core, folder, loc);
        }
        let plain = called_name(name);
        let named: Vec<usize> = self.of_file(file, without_extension(&plain)).collect();
        match named[..] {
            [] => Ok(first),
            [one] => Ok(one),
            _ => {
                let places: Vec<At> = named.into_iter().map(At::Unit).collect();
                core.report(self.several(core, name, &places, loc));
                core.go_on_in_doubt();
                Err(Missing::Reported)
            }
        }
    }

    /// Says once that a folder of this computer stands for one of the control because of its name.
    pub(super) fn note_copy(&mut self, core: &Core<'_>, folder: &str, loc: Loc) {
        let Some((copy, control)) = core.job.files.copy_of(folder) else { return };
        if self.copies.insert(control) {
            core.report(codes::S8039::stands_for_because_of_its_name(&copy, &control).at(loc));
        }
    }

    /// Programs of one rank.
    fn several(&self, core: &Core<'_>, name: &str, places: &[At], loc: Loc) -> Diagnostic {
        let files: Vec<&str> = places.iter().filter_map(file_name).collect();
        let all = places.len();
        let mut found = codes::S2046::programs_are_named(&all, &called_name(name)).at(loc);
        if !files.is_empty() {
            let files = files.join("` and `");
            found =
                found.here(if files.len() == all { format!("`{files}`") } else { format!("`{files}` is one of them") });
        }
        for unit in places.iter().filter_map(|at| self.unit_at(at)) {
            found = found.also(self.head_of(core, unit), folder_of(unit));
        }
        found.help(
            "delete or rename all but one, or call it by its path; a `;$PATH=` line after its head places a program",
        )
    }

    /// A subprogram and a main program of one name in the folder of the main program.
    fn both_kinds(&self, core: &Core<'_>, name: &str, places: [&At; 2], loc: Loc) -> Diagnostic {
        let plain = called_name(name);
        let mut found = codes::S2047::spf_mpf_both_lie_in_folder(&plain).at(loc);
        let files: Vec<&str> = places.iter().filter_map(|at| file_name(at)).collect();
        if !files.is_empty() {
            found = found.here(format!("as `{}`", files.join("` and `")));
        }
        for unit in places.iter().filter_map(|at| self.unit_at(at)) {
            found = found.also(self.head_of(core, unit), Label::OneOfThem);
        }
        let answer = Answer::key("control", "called_first").one_of(&["\"spf\"", "\"mpf\""]);
        found.help(answer.help(format!(
            "write which one you mean: `CALL \"{plain}_SPF\"`; or say what your control runs: `[control] called_first = \"spf\"` or `\"mpf\"`"
        )))
    }

    fn unit_at(&self, at: &At) -> Option<&Unit> {
        match at {
            At::Unit(unit) => self.list.get(*unit),
            At::File(_) => None,
        }
    }

    /// The line that begins a program.
    fn head_of(&self, core: &Core<'_>, unit: &Unit) -> Loc {
        let file = core.programs.get(unit.file).map_or(core.job.main, |program| program.source.file);
        Loc { file, line: unit.start.line, span: Span::at(unit.start.at, 1) }
    }

    pub(super) fn program_missing<T>(
        &mut self,
        core: &mut Core<'_>,
        name: &str,
        nowhere: Nowhere,
        help: impl Into<Help>,
        span: Span,
    ) -> Outcome<T> {
        let Nowhere { tried, like, elsewhere } = nowhere;
        let found = codes::S2002::there_is_no_program(&name)
            .at(core.loc(span))
            .here(format!("looked for {}", tried.join(", ")));
        let known: Vec<&str> = self.list.iter().map(|unit| unit.name.as_str()).filter(|known| *known != name).collect();
        let like = like.or_else(|| crate::machine::tree::did_you_mean(name, known).map(str::to_owned));
        let unknown = self.call_path.as_deref().filter(|folder| !self.search_knows(core, folder));
        core.report(match (like, elsewhere.first()) {
            (_, Some(place)) => found.help(Answer::folder_of(&tried).help(format!(
                "there is one {place}, where the control does not look: it looks in the folder of the main program, \
                 SPF_DIR, CUS_DIR, CMA_DIR and CST_DIR; name that folder so under `[include] roots`, or write its path"
            ))),
            (Some(like), None) => found.help(format!("did you mean `{like}`?")),
            (None, None) if name.starts_with("F_") || name.starts_with("E_") => found.help(
                "names like this are steps of ShopMill and ShopTurn, which only the control runs; put the program out as G code",
            ),
            (None, None) => match unknown {
                Some(folder) => found.help(Answer::entry("include", "roots", folder).help(format!(
                    "CALLPATH names `{folder}`: name the folder of this computer under `[include] roots`"
                ))),
                None => found.help(help.into().and(Answer::folder_of(&tried))),
            },
        });
        core.go_on_in_doubt();
        Err(Reported)
    }

    fn search_knows(&self, core: &Core<'_>, folder: &str) -> bool {
        let main = (0, core.job.main);
        SearchPath { job: &core.job, units: self, files: [main, main], call_path: None }.knows(folder)
    }

    /// CALLPATH: one more folder is searched, up to the end of the program; without a name none.
    pub(super) fn extend_search(&mut self, core: &mut Core<'_>, folder: Option<String>, span: Span) {
        self.call_path = folder.map(|folder| control_path(&folder));
        self.found.clear();
        self.missing.clear();
        self.asked.clear();
        let _ = self.list_programs(core, 0);
        if let Some(folder) = self.call_path.clone().filter(|folder| !self.search_knows(core, folder)) {
            core.say_once(span, codes::S8037::no_folder_of_this_computer_stands(&folder));
        }
    }

    /// Lists the programs of a file.
    pub(super) fn list_programs(&mut self, core: &mut Core<'_>, file: usize) -> std::io::Result<()> {
        self.list_file(&core.job, &mut core.programs, file)
    }

    /// Lists the programs of the main file and of `file`.
    fn list_beside(&mut self, core: &mut Core<'_>, file: usize) -> std::io::Result<()> {
        self.list_programs(core, 0)?;
        self.list_programs(core, file)
    }

    /// The main program of a file: an archive may begin with its subprograms.
    pub(super) fn main_of(&mut self, core: &mut Core<'_>, first: usize) -> usize {
        if self.list[first].kind == UnitKind::Main {
            return first;
        }
        let _ = self.list_programs(core, 0);
        let unit = self.list.iter().position(|unit| unit.kind == UnitKind::Main).unwrap_or(first);
        let _ = core.programs[0].source.cursor.seek(core.job.sources, self.list[unit].start);
        unit
    }

    /// The skeleton of any program.
    pub(super) fn skeleton_of(&mut self, core: &mut Core<'_>, unit: usize, place: Where) -> Outcome<Rc<Skeleton>> {
        let Core { job, programs, symbols, .. } = core;
        match self.skeleton(job, programs, unit, symbols) {
            Ok(made) => Ok(made),
            Err(error) => core.refuse(place, codes::P0105::file_cannot_be_read(&error)),
        }
    }

    /// A program of the user with the name of a cycle goes before it, and so does what `[programs]` gives in its place.
    pub(super) fn own_program(&mut self, core: &mut Core<'_>, name: &str) -> bool {
        core.job.settings.programs.contains_key(name) || self.is_here(core, name)
    }

    /// Is there a program of this name in the file, or beside it?
    pub(super) fn is_here(&mut self, core: &mut Core<'_>, name: &str) -> bool {
        let file = self.list[unit(&core.levels)].file;
        if let Some(here) = self.asked.get(&file).and_then(|names| names.get(name)) {
            return *here;
        }
        let here = self.list_beside(core, file).is_ok() && {
            let is_unit = [0, file].into_iter().any(|file| self.of_file(file, name).next().is_some());
            // A main program in a file of its own is none that goes before a cycle.
            self.search(core, |path| path.is_there(&format!("{name}_SPF")) || is_unit && path.is_there(name))
        };
        self.asked.entry(file).or_default().insert(name.to_owned(), here);
        here
    }

    /// The file that `[programs]` gives in place of `name`, unless there is a program of that name.
    fn file_in_place_of(&mut self, core: &mut Core<'_>, name: &str) -> Option<String> {
        match core.job.settings.programs.get(name) {
            Some(StandIn::File(file)) if !self.is_here(core, name) => Some(file.clone()),
            _ => None,
        }
    }

    /// What the call of `name` does by `[programs]`; `None` for a program that is looked for.
    pub(super) fn stand_in(&mut self, core: &mut Core<'_>, name: &str) -> Option<StandIn> {
        let stand_in = core.job.settings.programs.get(name).filter(|it| !matches!(it, StandIn::File(_)))?.clone();
        (!self.is_here(core, name)).then_some(stand_in)
    }

    /// ISFILE: is there a file or program of this name?
    pub(super) fn is_file(&mut self, core: &mut Core<'_>, wanted: &str) -> std::io::Result<bool> {
        let file = self.list[unit(&core.levels)].file;
        self.list_beside(core, file)?;
        // Of a folder that nothing is known of, what lies beside the main program is asked for.
        Ok(self.search(core, |path| {
            let folder = wanted.rsplit_once('/').map(|(folder, _)| control_path(folder));
            let plain = || wanted.rsplit('/').next().unwrap_or(wanted);
            path.is_there(wanted) || folder.is_some_and(|folder| !path.knows(&folder)) && path.is_there(plain())
        }))
    }
}

fn file_name(at: &At) -> Option<&str> {
    match at {
        At::Unit(_) => None,
        At::File(file) => Some(&file.shown),
    }
}

fn folder_of(unit: &Unit) -> Label {
    unit.folder.as_ref().map_or(Label::WithoutFolder, |folder| Label::InFolder(folder.clone()))
}

/// The name of a program without folder, `_N_` and `_SPF`.
pub(super) fn called_name(name: &str) -> String {
    let (bare, _) = bare_name(&name.to_ascii_uppercase());
    let last = bare.rsplit(['/', '\\']).next().unwrap_or(&bare);
    bare_name(last).0
}

/// A folder of a backup and a `;$PATH=` line that contradict each other.
fn in_two_places(places: &TwoPlaces, loc: Loc) -> Diagnostic {
    let TwoPlaces { shown, by_name, by_line } = places;
    codes::S2046::lies_in_by_name_of_its_folder(&shown, &by_name, &by_line).at(loc)
}
