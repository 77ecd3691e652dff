//! Section codes in the languages in which the controls print them.

/// A part of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Section {
    Head,
    Turret,
    Clamping,
    /// A group of contours: several parts on one bar.
    Contours,
    Blank,
    AuxiliaryBlank,
    Finished,
    AuxiliaryContour,
    /// Contours of the C or Y axis, by the word the program uses.
    Milling,
    Machining,
    Assignment,
    Names,
    Subprogram,
    Return,
    End,
}

/// Words of section codes, longest first where one begins another.
const WORDS: &[(&[u8], Section)] = &[
    (b"PROGRAM HEAD", Section::Head),
    (b"PROGRAMMKOPF", Section::Head),
    (b"HEADER", Section::Head),
    (b"TURRET", Section::Turret),
    (b"REVOLVER", Section::Turret),
    (b"TOOL CARRIER", Section::Turret),
    (b"MANUAL TOOL", Section::Turret),
    (b"MAGAZINE", Section::Turret),
    (b"MAGAZIN", Section::Turret),
    (b"WERKZEUGTRAEGER", Section::Turret),
    (b"HANDWERKZEUG", Section::Turret),
    (b"CLAMPING DEVICE", Section::Clamping),
    (b"CHUCKING EQUIPMENT", Section::Clamping),
    (b"CLAMPS", Section::Clamping),
    (b"SPANNMITTEL", Section::Clamping),
    (b"CONTOUR", Section::Contours),
    (b"KONTUR", Section::Contours),
    (b"BLANK", Section::Blank),
    (b"ROHTEIL", Section::Blank),
    (b"AUXIL_BLANK", Section::AuxiliaryBlank),
    (b"HILFSROHTEIL", Section::AuxiliaryBlank),
    (b"FINISHED PART", Section::Finished),
    (b"FINISHED", Section::Finished),
    (b"FERTIGTEIL", Section::Finished),
    (b"AUXILIARY CONTOUR", Section::AuxiliaryContour),
    (b"AUXIL_CONTOUR", Section::AuxiliaryContour),
    (b"HILFSKONTUR", Section::AuxiliaryContour),
    (b"FRONT END", Section::Milling),
    (b"FRONT_Y", Section::Milling),
    (b"FRONT", Section::Milling),
    (b"FACE_C", Section::Milling),
    (b"FACE_Y", Section::Milling),
    (b"STIRN_C", Section::Milling),
    (b"STIRN_Y", Section::Milling),
    (b"STIRN", Section::Milling),
    (b"REAR END", Section::Milling),
    (b"REAR SIDE", Section::Milling),
    (b"REAR_C", Section::Milling),
    (b"REAR_Y", Section::Milling),
    (b"RUECKSEITE_C", Section::Milling),
    (b"RUECKSEITE_Y", Section::Milling),
    (b"RUECKSEITE", Section::Milling),
    (b"CYLINDER SURFACE", Section::Milling),
    (b"SURFACE_Y", Section::Milling),
    (b"SURFACE", Section::Milling),
    (b"LATERAL_C", Section::Milling),
    (b"LATERAL_Y", Section::Milling),
    (b"LATERAL", Section::Milling),
    (b"MANTEL_C", Section::Milling),
    (b"MANTEL_Y", Section::Milling),
    (b"MANTEL", Section::Milling),
    (b"MACHINING", Section::Machining),
    (b"BEARBEITUNG", Section::Machining),
    (b"ASSIGNMENT", Section::Assignment),
    (b"ZUORDNUNG", Section::Assignment),
    (b"CONST", Section::Names),
    (b"VAR", Section::Names),
    (b"SUBPROGRAM", Section::Subprogram),
    (b"UNTERPROGRAMM", Section::Subprogram),
    (b"RETURN", Section::Return),
    (b"END", Section::End),
    (b"ENDE", Section::End),
];

/// The section code at the start of `text`, and its length.
pub fn section(text: &[u8]) -> Option<(Section, usize)> {
    WORDS.iter().find_map(|(word, section)| {
        let head = text.get(..word.len())?;
        let alone = text.get(word.len()).is_none_or(|b| !(b.is_ascii_alphanumeric() || *b == b'_'));
        (head.eq_ignore_ascii_case(word) && alone).then_some((*section, word.len()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_is_a_section_only_as_a_whole() {
        assert_eq!(section(b"FINISHED PART"), Some((Section::Finished, 13)));
        assert_eq!(section(b"Ende"), Some((Section::End, 4)));
        assert_eq!(section(b"FRONT Z0"), Some((Section::Milling, 5)));
        assert_eq!(section(b"TURRET 1"), Some((Section::Turret, 6)));
        assert_eq!(section(b"ENDIF"), None);
        assert_eq!(section(b"END_OF_UNIT"), None);
    }
}
