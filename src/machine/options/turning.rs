//! HEIDENHAIN turning: what the manuals leave open. docs/turning.md says what each key decides.

/// Which of two solutions Q0 of an arc names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ArcChoice {
    #[default]
    ZeroIsNear,
    ZeroIsFar,
}

/// What a depth or height across the axis counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RecessDepth {
    #[default]
    Diameter,
    Radius,
}

/// Where the width of a recess with leaning flanks counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RecessWidth {
    /// At the element that it is cut into.
    #[default]
    Opening,
    Floor,
}

/// On which side of the programmed corner a recess of G86 lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RecessSide {
    /// Towards +Z.
    Plus,
    /// Towards -Z.
    Minus,
}

/// What turning programs leave to the control. `None`: nobody said, so the default holds and a program that depends on it is
/// told so.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Turning {
    /// Near, if nobody said.
    pub arc_choice: Option<ArcChoice>,
    /// What an incremental I of G22 counts: the diameter, if nobody said.
    pub recess_depth: Option<RecessDepth>,
    /// Clearance of cycles in mm where the program sets none.
    pub clearance: Option<f64>,
    /// Machine coordinates of the tool change point: X as a diameter, Z, in mm.
    pub change_point: Option<(f64, f64)>,
    /// Where a recess of G86 lies that is wider than the tool; `None` refuses it.
    pub recess_side: Option<RecessSide>,
    /// Where K of G23 counts: at the opening, if nobody said.
    pub recess_width: Option<RecessWidth>,
    /// What the infeed I of G81 counts: the radius, if nobody said.
    pub infeed: Option<RecessDepth>,
    /// A flank offset from the left (H1) starts a thread towards +Z, not towards -Z.
    pub left_is_plus: Option<bool>,
    /// What RI of G869 counts: the diameter, if nobody said.
    pub recess_blank: Option<RecessDepth>,
    /// G32, whose words no available manual lists, is refused.
    pub refuse_simple_thread: Option<bool>,
    /// A contour in the words of G80, which no available manual lists, is refused.
    pub refuse_contour_words: Option<bool>,
    /// Angles of lines count from +Z, not from -Z.
    pub angle_from_plus: Option<bool>,
    /// An undercut of G85 at exactly 18 or 80 mm takes the row above, not the one below.
    pub undercut_upper: Option<bool>,
    /// The face that a transverse thread is cut in is the one towards -Z. `None`: the tool tells.
    pub rear_face: Option<bool>,
    /// R or RB of G869 moves the tool towards the floor, not away from it.
    pub towards_floor: Option<bool>,
    /// B of G869 shortens the passes of one-way turning at their ends.
    pub offset_one_way: Option<bool>,
    /// The oversize of G86 is left on the floor alone, not on the walls.
    pub oversize_on_floor: Option<bool>,
    /// How far the radii at both ends of an arc may differ, in mm.
    pub arc_tolerance: Option<f64>,
}
