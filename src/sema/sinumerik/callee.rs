//! The program that a call names: found, opened, or reported with what stands in the way.
//!
//! Source: S 5.6 (docs/sources.md).

use crate::diag::{Answer, Diagnostic, Help, Label, codes};
use crate::sema::run::{Wanted, no_root, not_opened, open_program};
use crate::text::{FileError, Loc, Request, Span, Within};

use super::control_folders::TwoPlaces;
use super::programs::{Unit, bare_name, without_extension};
use super::search_path::{At, FileAt, Found, Nowhere, SearchPath};
use super::{Outcome, Reported, Run};

/// Why a program is not found.
pub(super) enum Missing {
    Reported,
    Nowhere(Nowhere),
}

impl Run<'_> {
    /// Finds the program `name` and reports one that is nowhere.
    pub(super) fn find_program(&mut self, name: &str, span: Span) -> Outcome<usize> {
        self.look_for(name, span).or_else(|missing| match missing {
            Missing::Reported => Err(Reported),
            Missing::Nowhere(nowhere) => {
                let help = "put the program beside this one or into an include root; or correct the word";
                self.program_missing(&called_name(name), nowhere, help, span)
            }
        })
    }

    /// Looks for the program `name` along the search path of the control; for the one that `[programs]` gives in its place,
    /// where it is nowhere there.
    pub(super) fn look_for(&mut self, name: &str, span: Span) -> Result<usize, Missing> {
        let file = self.units.list[self.unit()].file;
        // What cannot be listed was reported when it was opened.
        let _ = self.list_programs(0).and_then(|()| self.list_programs(file));
        let key = (file, name.to_owned());
        if let Some(&unit) = self.found.get(&key) {
            return Ok(unit);
        }
        if self.missing.contains(&key) {
            let again = codes::S2002::there_is_no_program(&name).at(self.channel.core.loc(span));
            if self.channel.core.job.diags.knows(&again) {
                self.channel.core.report(again);
                self.channel.core.go_on_in_doubt();
                return Err(Missing::Reported);
            }
        }
        let plain = called_name(name);
        let found = match self.file_in_place_of(without_extension(&plain)) {
            Some(stand_in) => self.open_stand_in(&stand_in, &plain, span),
            None => self.found(name, span),
        };
        match found {
            Ok(unit) => drop(self.found.insert(key, unit)),
            Err(Missing::Nowhere(_)) => drop(self.missing.insert(key)),
            Err(Missing::Reported) => {}
        }
        found
    }

    fn found(&mut self, name: &str, span: Span) -> Result<usize, Missing> {
        let found = self.search(|path| path.look(name));
        let loc = self.channel.core.loc(span);
        let said = match found {
            Found::One(At::Unit(unit)) => return Ok(unit),
            Found::One(At::File(file)) => return self.open_file(&file.name, file.within, Some((name, &file)), span),
            Found::Unplaced(unit, folder) => {
                let program = &self.units.list[unit].name;
                self.channel.core.report(codes::P0107::no_folder_is_known(&folder, &program).at(loc));
                return Ok(unit);
            }
            Found::BesideByLine(file, folder) => {
                self.channel.core.report(codes::P0107::by_its_path_line_lies(&file.shown, &folder).at(loc));
                return self.open_file(&file.name, file.within, Some((name, &file)), span);
            }
            Found::Nowhere(nowhere) => return Err(Missing::Nowhere(nowhere)),
            Found::Fails(FileError::NotFound { tried, similar }, _) => {
                let like = similar.into_iter().next();
                return Err(Missing::Nowhere(Nowhere { tried, like, elsewhere: Vec::new() }));
            }
            Found::Fails(error, asked) => {
                self.channel.core.report(not_opened(error, &asked, loc));
                self.channel.core.stop_run();
                return Err(Missing::Reported);
            }
            Found::TwoPlaces(places) => in_two_places(&places, loc),
            Found::Several(places) => self.several(name, &places, loc),
            Found::BothKinds(sub, main) => self.both_kinds(name, [&sub, &main], loc),
            Found::BehindUnknown(folder) => {
                let found = no_root(&folder, loc);
                found.here(format!("CALLPATH names the folder: it may have `{}`, too", called_name(name)))
            }
        };
        self.channel.core.report(said);
        self.channel.core.go_on_in_doubt();
        Err(Missing::Reported)
    }

    /// Asks the search path, as it is for the program that runs.
    pub(super) fn search<T>(&mut self, ask: impl FnOnce(&SearchPath<'_, '_>) -> T) -> T {
        self.channel.core.budget.search();
        let file = self.units.list[self.unit()].file;
        let core = &self.channel.core;
        let of = |file: usize| (file, core.programs.get(file).map_or(core.job.main, |program| program.source.file));
        let call_path = self.call_path.as_deref();
        ask(&SearchPath { job: &core.job, units: &self.units, files: [of(0), of(file)], call_path })
    }

    /// Opens the file that `[programs]` gives.
    fn open_stand_in(&mut self, file: &str, name: &str, span: Span) -> Result<usize, Missing> {
        let request = Request { from: "", name: file, extensions: &[], within: Within::Configured };
        if let Err(FileError::NotFound { .. }) = self.channel.core.job.files.open(&request) {
            self.channel
                .core
                .report(codes::S2002::there_is_no_program_and_no(&name, &file).at(self.channel.core.loc(span)));
            self.channel.core.go_on_in_doubt();
            return Err(Missing::Reported);
        }
        self.open_file(file, Within::Configured, None, span)
    }

    /// Opens a file that was found, and says which of its programs the call means.
    fn open_file(
        &mut self,
        asked: &str,
        within: Within,
        found: Option<(&str, &FileAt)>,
        span: Span,
    ) -> Result<usize, Missing> {
        let loc = self.channel.core.loc(span);
        let wanted = Wanted { name: asked, extensions: &[], within };
        let opened = open_program(&self.channel.core.job, &wanted, loc, self.channel.core.here.origin.call);
        let Some(file) = opened.and_then(|id| self.channel.core.open(id, loc)) else {
            self.channel.core.stop_run();
            return Err(Missing::Reported);
        };
        let first = self.units.first_of(&self.channel.core.job, &self.channel.core.programs, file);
        let file = self.units.list[first].file;
        if self.list_programs(file).is_err() {
            return Ok(first);
        }
        let Some((name, at)) = found else { return Ok(first) };
        if let Some(folder) = &at.folder {
            self.units.lie_in(file, folder);
            self.note_copy(folder, loc);
        }
        let plain = called_name(name);
        let named: Vec<usize> = self.units.of_file(file, without_extension(&plain)).collect();
        match named[..] {
            [] => Ok(first),
            [one] => Ok(one),
            _ => {
                let places: Vec<At> = named.into_iter().map(At::Unit).collect();
                self.channel.core.report(self.several(name, &places, loc));
                self.channel.core.go_on_in_doubt();
                Err(Missing::Reported)
            }
        }
    }

    /// Says once that a folder of this computer stands for one of the control because of its name.
    pub(super) fn note_copy(&mut self, folder: &str, loc: Loc) {
        let Some((copy, control)) = self.channel.core.job.files.copy_of(folder) else { return };
        if self.warned.copies.insert(control) {
            self.channel.core.report(codes::S8039::stands_for_because_of_its_name(&copy, &control).at(loc));
        }
    }

    /// Programs of one rank.
    fn several(&self, name: &str, places: &[At], loc: Loc) -> Diagnostic {
        let files: Vec<&str> = places.iter().filter_map(file_name).collect();
        let all = places.len();
        let mut found = codes::S2046::programs_are_named(&all, &called_name(name)).at(loc);
        if !files.is_empty() {
            let files = files.join("` and `");
            found =
                found.here(if files.len() == all { format!("`{files}`") } else { format!("`{files}` is one of them") });
        }
        for unit in places.iter().filter_map(|at| self.unit_at(at)) {
            found = found.also(self.head_of(unit), folder_of(unit));
        }
        found.help(
            "delete or rename all but one, or call it by its path; a `;$PATH=` line after its head places a program",
        )
    }

    /// A subprogram and a main program of one name in the folder of the main program.
    fn both_kinds(&self, name: &str, places: [&At; 2], loc: Loc) -> Diagnostic {
        let plain = called_name(name);
        let mut found = codes::S2047::spf_mpf_both_lie_in_folder(&plain).at(loc);
        let files: Vec<&str> = places.iter().filter_map(|at| file_name(at)).collect();
        if !files.is_empty() {
            found = found.here(format!("as `{}`", files.join("` and `")));
        }
        for unit in places.iter().filter_map(|at| self.unit_at(at)) {
            found = found.also(self.head_of(unit), Label::OneOfThem);
        }
        let answer = Answer::key("control", "called_first").one_of(&["\"spf\"", "\"mpf\""]);
        found.help(answer.help(format!(
            "write which one you mean: `CALL \"{plain}_SPF\"`; or say what your control runs: `[control] called_first = \"spf\"` or `\"mpf\"`"
        )))
    }

    fn unit_at(&self, at: &At) -> Option<&Unit> {
        match at {
            At::Unit(unit) => self.units.list.get(*unit),
            At::File(_) => None,
        }
    }

    /// The line that begins a program.
    fn head_of(&self, unit: &Unit) -> Loc {
        let file =
            self.channel.core.programs.get(unit.file).map_or(self.channel.core.job.main, |program| program.source.file);
        Loc { file, line: unit.start.line, span: Span::at(unit.start.at, 1) }
    }

    pub(super) fn program_missing<T>(
        &mut self,
        name: &str,
        nowhere: Nowhere,
        help: impl Into<Help>,
        span: Span,
    ) -> Outcome<T> {
        let Nowhere { tried, like, elsewhere } = nowhere;
        let found = codes::S2002::there_is_no_program(&name)
            .at(self.channel.core.loc(span))
            .here(format!("looked for {}", tried.join(", ")));
        let known: Vec<&str> =
            self.units.list.iter().map(|unit| unit.name.as_str()).filter(|known| *known != name).collect();
        let like = like.or_else(|| crate::machine::tree::did_you_mean(name, known).map(str::to_owned));
        let unknown = self.call_path.as_deref().filter(|folder| !self.search_knows(folder));
        self.channel.core.report(match (like, elsewhere.first()) {
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
        self.channel.core.go_on_in_doubt();
        Err(Reported)
    }

    fn search_knows(&self, folder: &str) -> bool {
        let core = &self.channel.core;
        let main = (0, core.job.main);
        SearchPath { job: &core.job, units: &self.units, files: [main, main], call_path: None }.knows(folder)
    }

    /// CALLPATH: one more folder is searched, up to the end of the program; without a name none.
    pub(super) fn extend_search(&mut self, folder: Option<String>, span: Span) {
        self.call_path = folder.map(|folder| super::control_folders::control_path(&folder));
        self.found.clear();
        self.missing.clear();
        self.units.asked.clear();
        let _ = self.list_programs(0);
        if let Some(folder) = self.call_path.clone().filter(|folder| !self.search_knows(folder)) {
            self.channel.core.say_once(span, codes::S8037::no_folder_of_this_computer_stands(&folder));
        }
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
