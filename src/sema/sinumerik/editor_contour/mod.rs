//! Contours of the contour editor: the NC blocks are what runs, the hidden records behind them are checked against
//! them. Where the NC blocks are missing they are made from the records.
//!
//! Source: C 1 (docs/sources.md).

mod compare;
mod difference;
mod generate;
mod made;
mod material;
mod rebuild;
mod solve;
mod stored;

use crate::diag::{Answer, Diagnostic, Help, Label, codes};
use crate::ir::undercut::usual_pitch;
use crate::machine::undercut::Undercuts;
use crate::parser::sinumerik::records::{Record, is_spoiled, read};
use crate::text::Loc;

use crate::sema::run::Where;

use super::{Channel, Outcome, Reported};
use compare::compare;
use difference::Told;
use generate::{MOST_RECORDS, outline, solve};
use made::{Contour, NoUndercut, Unsolved, Written};
use stored::MOST_BLOCKS;
pub(super) use stored::Stored;

/// How far blocks and records may differ, in the unit of the program.
const TOLERANCE: f64 = 0.001;

impl Channel<'_> {
    /// A comment line: perhaps a record. `text` is without its semicolon.
    pub(super) fn stored_record(&mut self, text: &[u8]) -> Outcome {
        if self.st.stored.is_none() && !text.starts_with(b"#") {
            return Ok(());
        }
        let line = [b";", text].concat();
        let record = read(&line).or_else(|| {
            let spoiled = self.st.stored.is_some() && is_spoiled(text);
            spoiled.then(|| Record::Unknown(String::from_utf8_lossy(text).trim().to_owned()))
        });
        match record {
            Some(Record::Begin) => {
                let (core, position) = (&self.core, &mut self.st.position);
                let result = self.st.stored.take().map_or(Ok(()), |stored| stored.has_no_end(core, position));
                self.st.stored = Some(Box::new(Stored {
                    start: None,
                    blocks: Vec::new(),
                    places: Vec::new(),
                    centre: None,
                    rapid: None,
                    records: Vec::new(),
                    record_places: Vec::new(),
                    begin: self.core.here.origin.loc,
                    written: Written { diameter: false, unit: 1.0 },
                    diameter_said: false,
                }));
                result
            }
            Some(Record::End) => match self.st.stored.take() {
                Some(stored) => self.check_stored(&stored),
                None => Ok(()),
            },
            Some(record) => {
                // One more than can be solved is enough to know that there are too many.
                if let Some(stored) = self.st.stored.as_mut().filter(|stored| stored.records.len() <= MOST_RECORDS) {
                    stored.records.push(record);
                    stored.record_places.push(self.core.here.origin.loc);
                }
                Ok(())
            }
            None => Ok(()),
        }
    }

    fn check_stored(&mut self, stored: &Stored) -> Outcome {
        // Blocks that were refused are not there to be compared.
        if self.core.errors() > 0 {
            return Ok(());
        }
        let written = if stored.start.is_some() { stored.written } else { self.st.written_now(&self.core) };
        let [first, second, _] = self.st.roles();
        let here = (first.letter() as u8, second.letter() as u8);
        let named = stored.records.iter().find_map(|record| match record {
            Record::Header { axes, .. } => *axes,
            _ => None,
        });
        let other_plane = named.is_some_and(|axes| axes != here);
        if other_plane && stored.start.is_none() {
            return self
                .core
                .refuse(Where::Block, codes::S9019::contour_has_no_blocks_and_its_records_are_for_another());
        }
        if other_plane {
            self.core.report(codes::S8027::records_of_this_contour_are_for_another().at(stored.begin));
            return Ok(());
        }
        if stored.start.is_none() {
            self.can_be_rebuilt(stored)?;
            return match outline(&stored.records, written, &self.core.job.settings.undercut) {
                Ok(made) => self.rebuild(&made, stored, written.unit),
                Err(why) => {
                    let (place, what, help) = stored.unsolved(&why, &self.core.job.settings.undercut);
                    self.core.report(codes::S9019::contour_has_no_blocks(&what).at(place).help(help));
                    Err(Reported)
                }
            };
        }
        for found in stored.faults_of_blocks(written, here, &self.core.job.settings.undercut) {
            self.core.report(found);
        }
        Ok(())
    }
}

impl Stored {
    /// Compares the blocks of a contour with what its records say.
    fn faults_of_blocks(&self, written: Written, axes: (u8, u8), undercut: &Undercuts) -> Vec<Diagnostic> {
        let made = match solve(&self.records, written, undercut) {
            Ok(made) => made,
            Err(Unsolved::Unknown(_)) if self.agrees_without_unknown(written, undercut) => return Vec::new(),
            Err(why) => return vec![self.unchecked(&why, undercut)],
        };
        if self.blocks.len() > MOST_BLOCKS {
            return vec![self.unchecked(&Unsolved::TooLong, undercut)];
        }
        let start = self.start.unwrap_or(made.start);
        let mut compared = compare(start, &self.blocks, &made, TOLERANCE * written.unit);
        if compared.is_err() && written.unit != 1.0 && self.agrees_in_millimetres(written, undercut) {
            compared = Ok(());
        }
        let place_of = |at: Option<usize>| at.and_then(|at| self.places.get(at)).copied().unwrap_or(self.begin);
        match (compared, self.rapid) {
            (Ok(()), None) => Vec::new(),
            (Ok(()), Some(i)) => {
                vec![codes::S8026::element_runs_at_rapid_traverse(&(i + 1)).at(place_of(Some(i)))]
            }
            (Err(difference), _) => {
                let told = Told { axes, written, start, blocks: &self.blocks, made: &made };
                let (at, fault) = told.difference(difference);
                let found = fault.at(place_of(at));
                let record = told.record(difference).and_then(|at| self.record_places.get(at));
                vec![match record {
                    Some(record) => found.also(*record, Label::Typed),
                    None => found,
                }]
            }
        }
    }

    /// Do the blocks agree with the records that are known? What is left over is no element then, as the pole is none.
    fn agrees_without_unknown(&self, written: Written, undercut: &Undercuts) -> bool {
        let known: Vec<Record> = self
            .records
            .iter()
            .map(|record| match record {
                Record::Unknown(_) => Record::Header { axes: None, turned: None },
                known => known.clone(),
            })
            .collect();
        self.rapid.is_none() && self.agrees(solve(&known, written, undercut), written)
    }

    /// Are the records in millimetres though the blocks are in inches? No contour of inches was ever seen.
    fn agrees_in_millimetres(&self, written: Written, undercut: &Undercuts) -> bool {
        self.agrees(solve(&self.records, Written { unit: 1.0, ..written }, undercut), written)
    }

    fn agrees(&self, made: Result<Contour, Unsolved>, written: Written) -> bool {
        made.is_ok_and(|made| {
            let start = self.start.unwrap_or(made.start);
            compare(start, &self.blocks, &made, TOLERANCE * written.unit).is_ok()
        })
    }

    fn unchecked(&self, why: &Unsolved, undercut: &Undercuts) -> Diagnostic {
        let (place, what, _) = self.unsolved(why, undercut);
        codes::S8027::records_of_this_contour_cannot_be_checked(&what).at(place)
    }

    /// Where the records stop making sense, why, and what mends it.
    fn unsolved(&self, why: &Unsolved, undercut: &Undercuts) -> (Loc, String, Help) {
        let place = why.record().and_then(|at| self.place_of_record(at)).unwrap_or(self.begin);
        let again = "open the contour in the editor of the control and accept it again";
        let (what, help): (String, Help) = match why {
            Unsolved::NoStart => ("they have no start point".to_owned(), again.into()),
            Unsolved::TooLong => ("there are too many of them".to_owned(), again.into()),
            Unsolved::Unknown(at) => match self.records.get(*at) {
                Some(Record::Unknown(text)) => (
                    format!("`{text}` is not known as a record"),
                    "accept the contour in the editor again, or write it as blocks; how poles and polar elements are \
                     stored is not published"
                        .into(),
                ),
                _ => ("a key or a value of this one is not known, or stands twice".to_owned(), again.into()),
            },
            Unsolved::Open(_) => ("this one does not determine its element".to_owned(), again.into()),
            Unsolved::Contradiction(_) => ("the values of this one contradict each other".to_owned(), again.into()),
            Unsolved::Undercut(_, why) => {
                let (what, help) = no_undercut(why, undercut);
                // A size that no table has is one of the user's own.
                let help = match why {
                    NoUndercut::Index(_) => Answer::key("undercut", "din509_in_editor").help(help),
                    NoUndercut::Pitch(_) => Answer::key("undercut", "din76").help(help),
                    _ => help.into(),
                };
                (what, help)
            }
        };
        (place, what, help)
    }

    /// Where a record stands.
    fn place_of_record(&self, record: usize) -> Option<Loc> {
        self.record_places.get(record).copied()
    }
}

/// Why an undercut cannot be made, and what mends it.
fn no_undercut(why: &NoUndercut, undercut: &Undercuts) -> (String, String) {
    let accept = "accept the contour in the editor again";
    match *why {
        NoUndercut::Place => {
            ("an undercut stands between two straight lines".to_owned(), "move or delete it".to_owned())
        }
        NoUndercut::Start => (
            "the line that leads to the undercut at the start of the contour has no direction".to_owned(),
            accept.to_owned(),
        ),
        NoUndercut::StartRounding => (
            "the undercut at the start of the contour begins with a rounding, and the line before it, on which that \
             would lie, is no part of the contour"
                .to_owned(),
            "begin the contour with the line before the undercut".to_owned(),
        ),
        NoUndercut::InchPitch => (
            "whether the pitch of a thread undercut is in inches or in millimetres is not known in a contour of inches"
                .to_owned(),
            "write the undercut as blocks, or by CYCLE940".to_owned(),
        ),
        NoUndercut::Corner => ("the corner does not take the undercut".to_owned(), accept.to_owned()),
        NoUndercut::Convex => (
            "the undercut stands at a convex edge: the contour reaches the turning centre, so the material lies on \
             the other side"
                .to_owned(),
            "move it into an inner corner, or delete it".to_owned(),
        ),
        NoUndercut::Contradicts => (
            "the undercuts contradict each other: one of them stands at a convex edge".to_owned(),
            "an undercut belongs into an inner corner; move or delete the other one".to_owned(),
        ),
        NoUndercut::Free => {
            ("how a free undercut is stored is not known".to_owned(), "write it as blocks, or by CYCLE940".to_owned())
        }
        NoUndercut::Index(index) => (
            format!("no size of DIN 509 has the index {index}"),
            "0 to 9, or as `[undercut] din509_in_editor` says".to_owned(),
        ),
        NoUndercut::PitchMissing { diameter, surface } => {
            let help = match usual_pitch(undercut, surface, diameter) {
                Some(pitch) => format!("the coarse pitch for {diameter} mm is {pitch}: give `P:{pitch}`"),
                None => format!("no coarse pitch belongs to {diameter} mm: give `P:` as the drawing says"),
            };
            ("the thread undercut has no pitch".to_owned(), help)
        }
        NoUndercut::Pitch(pitch) => {
            let help = match undercut.nearest_pitch(pitch) {
                Some(near) => format!("the nearest one is {near}; add others by `[undercut] din76`"),
                None => "add it by `[undercut] din76`".to_owned(),
            };
            (format!("DIN 76 has no undercut for the pitch {pitch}"), help)
        }
        NoUndercut::Entry(None) => ("the undercut has no entry angle".to_owned(), "give `ALFA:30`".to_owned()),
        NoUndercut::Entry(Some(angle)) => {
            (format!("the entry angle {angle} is out of range"), "it lies between 30 and 90 degrees".to_owned())
        }
    }
}

#[cfg(test)]
mod tests;
