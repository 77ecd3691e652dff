//! Which family of controls a program was written for, and what its blocks are read as.

/// The two families of controls, which read the same words differently.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Family {
    /// MANUALplus 4110: no sections.
    Basic,
    /// CNC PILOT and MANUALplus 620: DIN PLUS and smart.Turn.
    DinPlus,
}

/// What the blocks are read as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum ProgramPart {
    /// No section yet: blocks are executed.
    #[default]
    Start,
    Head,
    Turret,
    /// Belongs to something that turning does not need.
    Unread,
    Names,
    Contour,
    Machining,
    /// Behind RETURN: a section has to follow.
    Between,
}

impl ProgramPart {
    /// Its blocks are executed.
    pub fn is_executed(self) -> bool {
        matches!(self, ProgramPart::Start | ProgramPart::Machining)
    }
}
