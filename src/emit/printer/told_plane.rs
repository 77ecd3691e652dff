//! What the target was told of its working plane, item by item.

/// What the target was told of its working plane.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ToldPlane {
    pub plane: Known,
    /// A shift of the zero point is in force.
    pub shifted: bool,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Known {
    #[default]
    None,
    Tilted,
    /// It ended before a move in machine coordinates, although the program has it still.
    Left,
}

impl ToldPlane {
    /// Has the plane ended before the program ends it?
    #[inline(always)]
    pub fn is_left(self) -> bool {
        self.plane == Known::Left
    }
}
