//! The dialects: one table each, registered by one line in [`ALL`].

pub mod foreign;
mod gcode;
mod klartext;
mod mtc200;
mod sinumerik;
mod turning;

use std::borrow::Cow;

use crate::ir::contour::Sink;
use crate::machine::{MachineKind, Settings};
use crate::sema::Job;
use crate::sema::cycle::row::Signature;
use crate::sema::run::survey::Survey;
use crate::text::ControlFolder;

/// What the rest of the compiler knows of a control's language.
pub struct Dialect {
    /// Name in `--dialect`.
    pub id: &'static str,
    pub name: &'static str,
    /// Extensions of its files, lower case, without the dot.
    pub extensions: &'static [&'static str],
    /// Do these first bytes of a file show the language beyond doubt?
    pub recognizes: fn(&[u8]) -> bool,
    /// A language of lathes: whatever `[machine] kind` says, the output is one for a lathe.
    pub turns: bool,
    /// Folders of the control, where copies of them are known by their names.
    pub folders: &'static [ControlFolder],
    /// Runs the main program; returns the hash of its text.
    pub run: fn(&Job<'_>, &mut dyn Sink) -> u64,
    /// Reads every block, whether it runs or not.
    pub check_form: fn(&Job<'_>),
    /// Looks at the blocks of which the run, which comes before, reported no error, and says what can be known without
    /// running them: an error where the control itself refuses the program, a warning where only partc would refuse
    /// the block if it ran. `None` where a dialect knows no more than the form.
    pub check_unexecuted: Option<fn(&Job<'_>)>,
    /// A comment at the end of a block with a list in brackets: what stands in front of it, around the list, and behind it.
    pub comment: [&'static str; 4],
    /// Are its blocks numbered 0, 1, 2, not by tens?
    pub numbers_by_one: bool,
    /// Leads rules on source text through a file.
    pub survey: Survey,
    /// What each of its cycles takes, built or not.
    pub cycles: fn() -> Vec<&'static Signature>,
}

impl Dialect {
    /// The settings of a run in this language.
    pub fn settings<'s>(&self, settings: &'s Settings) -> Cow<'s, Settings> {
        if !self.turns || settings.machine.kind == MachineKind::Lathe {
            return Cow::Borrowed(settings);
        }
        let mut settings = settings.clone();
        settings.machine.kind = MachineKind::Lathe;
        Cow::Owned(settings)
    }
}

impl Dialect {
    /// Does it stand for files of which partc says what they are, and no more?
    pub fn is_foreign(&self) -> bool {
        self.id == foreign::ID
    }

    /// The cycle that a program calls by this name: `CYCLE81`, `CYCL DEF 200`, `G869`.
    pub fn cycle(&self, name: &str) -> Option<&'static Signature> {
        (self.cycles)().into_iter().find(|cycle| cycle.name.eq_ignore_ascii_case(name.trim()))
    }
}

impl std::fmt::Debug for Dialect {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.id)
    }
}

/// All dialects.
pub const ALL: &[&Dialect] =
    &[&klartext::DIALECT, &sinumerik::DIALECT, &mtc200::DIALECT, &turning::DIALECT, &gcode::DIALECT];

/// The dialect of this name.
pub fn find(id: &str) -> Option<&'static Dialect> {
    ALL.iter().copied().find(|dialect| dialect.id == id)
}

/// Guesses by content, then by extension. `None` if that leaves more or less than one, or if the file is in none of the languages.
pub fn guess(file_name: &str, head: &[u8]) -> Option<&'static Dialect> {
    read_as(file_name, head).filter(|dialect| !dialect.is_foreign())
}

/// The same; a file that shows that it is in none of the languages is read as what it is: one finding says so ([`foreign`]).
pub fn read_as(file_name: &str, head: &[u8]) -> Option<&'static Dialect> {
    if foreign::is_container(head) {
        return foreign::guess(file_name, head);
    }
    let mut by_content = ALL.iter().copied().filter(|dialect| (dialect.recognizes)(head));
    if let (Some(dialect), None) = (by_content.next(), by_content.next()) {
        return Some(dialect);
    }
    if let Some(kind) = foreign::guess(file_name, head) {
        return Some(kind);
    }
    let extension = file_name.rsplit_once('.')?.1.to_ascii_lowercase();
    let named = |dialect: &&Dialect| dialect.extensions.contains(&extension.as_str());
    let mut by_extension = ALL.iter().copied().filter(named);
    match (by_extension.next(), by_extension.next()) {
        (Some(dialect), None) if dialect.turns && foreign::is_turning_by_numbers(file_name, head) => {
            Some(&turning::BY_NUMBERS)
        }
        (Some(dialect), None) => Some(dialect),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn guessed(name: &str, head: &str) -> Option<&'static str> {
        guess(name, head.as_bytes()).map(|dialect| dialect.id)
    }

    /// `.nc` is the name of programs of many controls: that of a turning control only where nothing speaks against it.
    #[test]
    fn a_file_nc_with_words_of_a_mill_is_no_turning_program() {
        assert_eq!(guessed("PART.nc", "N1 G0 X50 Z2\nN2 M30\n"), Some("heidenhain-turning"));
        assert_eq!(guessed("PART.nc", "%PART.nc\n[title]\nN1 T1 M6\n"), Some("heidenhain-turning"));
        assert_eq!(
            guessed("PART.nc", "N7 G40 G1 X60 Z-38\nN8 G20 X60 Z100\nN9 G21 X10\nN10 G80\n"),
            Some("heidenhain-turning")
        );
        for head in [
            "%\nO1000\nN1 G0 X50\n",
            "%\n:1000 (PART)\n",
            "G21 G90 G17\nG0 X1\n",
            "N10 G54 G90\n",
            "T1 M6\nG0 X1\n",
            "N5 T1 M06\n",
            "G0 G43 Z5. H1\n",
            "G0 X1\nG1 Z-1 F100\n",
            "N1 G0 X1\nN2 G1 Z-1 F100\n",
            "G0 X1 Y1\n",
            "G21\nG0 X1\n",
            "G17\nG0 X1\n",
        ] {
            assert_eq!(guessed("PART.nc", head), None, "{head}");
        }
    }

    /// What partc printed says for whom. A language of ours reads some of it; of the others the front end for plain G-code says
    /// what they are.
    #[test]
    fn the_head_of_an_output_names_its_language() {
        for (head, language) in [
            ("%\n(partc 0.1.0, target linuxcnc)\n", "gcode"),
            ("%\nO0001\n(PARTC 0.1.0, TARGET FANUC)\nG90 G21 G94\n", "gcode"),
            ("O0001\n(PARTC 0.1.0, TARGET MAZAK)\n", "gcode"),
            ("; partc 0.1.0, target sinumerik\n; source A.H\nG90 G710\n", "sinumerik"),
            ("0 BEGIN PGM A MM\n1 ; partc 0.1.0, target heidenhain\n", "klartext"),
        ] {
            assert_eq!(guessed("PART.nc", head), Some(language), "{head}");
        }
    }
}
