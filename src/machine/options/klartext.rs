//! HEIDENHAIN Klartext: what the manuals and the machine leave to the user to say.

/// HEIDENHAIN control generations, in order of age.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum Generation {
    Tnc426,
    #[default]
    Itnc530,
    Tnc640,
    Tnc7,
}

/// How the tool axis moves in APPR and DEP.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ApproachDepth {
    /// Alone, at PH of an approach and at PN of a departure.
    Staged,
    /// Together with the axes of the plane.
    Together,
}

/// What a missing coordinate of a CC block is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CcMissing {
    #[default]
    Position,
    Previous,
}

/// What a missing PR or PA is after a block that was not polar.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PolarMissing {
    /// From the position, and refused where PA about a new pole is missing.
    #[default]
    SamePole,
    Position,
    Programmed,
}

/// Along which axes a datum shift counts while a rotation, mirror or scaling is active.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ShiftAxes {
    #[default]
    Original,
    Transformed,
}

/// What happens when IPA and DR of a CP block disagree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CpSign {
    #[default]
    Refuse,
    Dr,
}

/// What `%` of a formula gives where an operand is negative.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Modulo {
    #[default]
    Refuse,
    /// The sign of the left operand: -400 % 360 = -40.
    Truncate,
    /// The sign of the right operand: -400 % 360 = 320.
    Floor,
}

/// What CALL LBL REP makes of a number with decimals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RepeatCount {
    #[default]
    Refuse,
    Truncate,
    Round,
}

/// Klartext: what the machine or the manuals leave to the user to say.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct KlartextChoices {
    /// END PGM inside a called label ends the program file instead of being refused.
    pub open_subprogram_ends: bool,
    /// Probing cycles are left out instead of being refused.
    pub probing_left_out: bool,
    /// The probe of MEAS and MEAW touches nothing.
    pub never_touches: bool,
    /// Where probing cycles are left out, the datum that they set is there on the target (true), or they are refused (false);
    /// `None` where nobody said.
    pub probing_datum: Option<bool>,
    /// FN 18 reads lengths in mm in INCH programs, too (true), or in the unit of the program; `None` where nobody said.
    pub system_in_mm: Option<bool>,
    /// Angles of cycle 19 are positions of the rotary axes, not space angles.
    pub cycle_19_axes: bool,
    /// M98 is refused instead of being a line between both sides of the corner.
    pub open_corners_refused: bool,
    /// RND beside the block that begins or ends the compensation rounds the programmed corner instead of being refused.
    pub rounded_approach: bool,
    /// How the tool axis moves in APPR and DEP; `None` for what the control generation does.
    pub approach_depth: Option<ApproachDepth>,
    /// CCA of a free contour is the swept angle; `None` where nobody said.
    pub fk_cca_swept: Option<bool>,
    /// FSELECT decides nothing.
    pub fselect_refused: bool,
}

/// Klartext: further readings that manuals leave open.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct KlartextReadings {
    /// CYCL CALL PAT and CYCL CALL POS without F go at rapid traverse, not at the last feed.
    pub pattern_at_rapid: bool,
    /// The mirror acts on what cycle 10 has turned.
    pub mirror_last: bool,
    /// A cycle 26 without a centre keeps the one before.
    pub keep_scaling_center: bool,
}
