//! Programs of a backup that two things place: the name of their folder on this computer, and their own `;$PATH=` line.
//!
//! Where both name one folder of the control all is well. Otherwise nobody knows which of them is out of date: the call is refused.

use crate::text::Span;

use super::control_folders::{TwoPlaces, home_path, path_line_on_top};
use super::search_path::{At, FileAt, Found, SearchPath};

/// Bytes of a file in which its head stands.
const HEAD: u32 = 512;

impl SearchPath<'_, '_> {
    /// The main program, where its line names another folder than the one in which it is found.
    pub(super) fn main_in_two_places(&self) -> Option<TwoPlaces> {
        let by_name = home_path(self.job.files.home()?);
        let main = self.units.main()?;
        let is_first = self.units.list.iter().position(|unit| unit.file == self.units.list[main].file) == Some(main);
        let on_top = || {
            let text = self.job.sources.bytes(self.files[0].1, Span { start: 0, end: HEAD });
            path_line_on_top(&text).filter(|_| is_first)
        };
        let by_line = self.units.list[main].folder.clone().or_else(on_top)?;
        let shown = self.job.sources.name(self.files[0].1).to_string();
        (by_line != by_name).then_some(TwoPlaces { shown, by_name, by_line })
    }

    /// What is found, unless one of two things that place it, or the main program, has to be wrong.
    pub(super) fn unless_in_two_places(&self, found: Found, main: Option<&TwoPlaces>) -> Found {
        let places = match &found {
            Found::One(At::File(file)) if file.folder.is_some() && main.is_some() => main.cloned(),
            Found::One(At::File(file)) => self.in_two_places(file),
            Found::BesideByLine(file, own) => self.job.files.home().map(|home| TwoPlaces {
                shown: file.shown.clone(),
                by_name: home_path(home),
                by_line: own.clone(),
            }),
            _ => None,
        };
        places.map_or(found, Found::TwoPlaces)
    }

    /// A file in a folder that stands for one of the control because of its name.
    fn in_two_places(&self, file: &FileAt) -> Option<TwoPlaces> {
        let by_name = file.folder.clone()?;
        self.job.files.copy_of(&by_name)?;
        let by_line = path_line_on_top(&self.head_of(file)?)?;
        (by_line != by_name).then(|| TwoPlaces { shown: file.shown.clone(), by_name, by_line })
    }

    /// The first bytes of a file.
    pub(super) fn head_of(&self, file: &FileAt) -> Option<Vec<u8>> {
        let mut opened = self.open(&file.name, file.within).ok()?;
        let mut head = vec![0; HEAD as usize];
        let read = opened.text.read_at(0, &mut head).ok()?;
        head.truncate(read);
        Some(head)
    }
}
