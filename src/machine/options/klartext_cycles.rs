//! `[cycles]`: what a HEIDENHAIN control decides inside its machining cycles. docs/cycles.md says what each key changes.

/// What a place of a pattern is to the program of cycle 12.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PatternProgram {
    /// A further datum shift.
    Shift,
    /// Where the tool goes in front of the program.
    Position,
}

/// What the radius of a thread mill touches on an outside thread.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutsideThread {
    /// The nominal diameter: its tip reaches the core then.
    Nominal,
    /// The core: the radius is that of the tip.
    Core,
}

/// What HEIDENHAIN controls decide inside their machining cycles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KlartextCycles {
    /// Cycle 208 goes straight to the wall.
    pub straight_entry: bool,
    /// The helix of cycle 208 begins on the surface.
    pub helix_from_surface: bool,
    /// Cycle 208 makes large holes in several circles.
    pub bore_in_rings: bool,
    /// `None` refuses outside threads.
    pub outside_thread: Option<OutsideThread>,
    /// Width of a cut of the old pockets, in radii of the cutter.
    pub old_overlap: f64,
    /// Two strokes of a slot fall by its infeed; `None`: one does, which is said.
    pub strokes_in_pairs: Option<bool>,
    /// The outer paths of cycle 230 lie on the sides of the face.
    pub rows_on_edges: bool,
    /// What a place of a pattern is to the program of cycle 12; refused without it.
    pub pattern_program: Option<PatternProgram>,
}

impl Default for KlartextCycles {
    fn default() -> KlartextCycles {
        KlartextCycles {
            straight_entry: false,
            helix_from_surface: false,
            bore_in_rings: false,
            outside_thread: None,
            old_overlap: 1.2,
            strokes_in_pairs: None,
            rows_on_edges: false,
            pattern_program: None,
        }
    }
}
