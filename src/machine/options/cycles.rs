//! `[cycles]`: what a control decides inside its machining cycles. docs/cycles.md says what each key changes.

use super::klartext_cycles::KlartextCycles;

/// Stock removal in layers.
#[derive(Debug, Clone, PartialEq)]
pub struct LayerCycles {
    /// CYCLE95 roughs by the programmed tip; `None` as the model of the control does.
    pub rough_by_tip: Option<bool>,
    pub cuts_at_edges: bool,
    /// Lift in mm (SD 55581).
    pub release: f64,
    /// Lift of CYCLE951; `None` for its safety distance (SD 55505, 55506).
    pub release_outside: Option<f64>,
    pub release_inside: Option<f64>,
    /// In front of the blank (SD 55584).
    pub blank_offset: f64,
    pub finish_feed_percent: f64,
}

impl Default for LayerCycles {
    fn default() -> LayerCycles {
        LayerCycles {
            rough_by_tip: None,
            cuts_at_edges: false,
            release: 1.0,
            release_outside: Some(1.0),
            release_inside: Some(0.5),
            blank_offset: 1.0,
            finish_feed_percent: 100.0,
        }
    }
}

/// What a cut-off puts at its programmed Z.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutOffReference {
    /// The corner of the tool that lies on the side of the workpiece.
    Workpiece,
    /// The programmed point of the tool.
    Tip,
}

/// Which zones CYCLE82 drills slowly where one digit of `_VARI` is set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DrillingZones {
    #[default]
    Both,
    /// The thousands are through-drilling, the ten thousands predrilling.
    ThousandsThrough,
    /// The other way round.
    ThousandsPredrill,
}

/// How faces and mantles are printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Transmit {
    #[default]
    Refuse,
    /// In the axes that the program sees.
    Cartesian,
    /// In the axes of the machine.
    Polar,
}

/// What the size of a round spigot is in the old form of its cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpigotSize {
    Diameter,
    Radius,
}

/// How the side of the cutter is seen on a contour that runs backwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BackwardSide {
    Travel,
    Contour,
}

/// What of a multi-edge lies on its first axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MultiEdgeStart {
    /// The middle of an edge.
    Edge,
    Corner,
}

/// `[cycles]`
#[derive(Debug, Clone, PartialEq)]
pub struct Cycles {
    pub transmit: Transmit,
    /// A groove cycle with a dwell of its own waits at the floor.
    pub groove_dwell: bool,
    /// Turns of the spindle that it waits (SD 55510).
    pub groove_dwell_revolutions: f64,
    /// `None`: nobody said, so the corner on the side of the workpiece is taken, and a program that depends on it is told so.
    pub cutoff_reference: Option<CutOffReference>,
    pub drilling_zones: DrillingZones,
    /// The part catcher of a cut-off is left out.
    pub ignores_gripper: bool,
    pub layers: LayerCycles,
    /// `None` refuses the old form.
    pub spigot_size: Option<SpigotSize>,
    /// `None` refuses contours that are milled backwards on a side.
    pub backward_side: Option<BackwardSide>,
    /// The digits for sense and hand of a milled thread are read.
    pub thread_digits: bool,
    /// `None` refuses multi-edges.
    pub multi_edge_start: Option<MultiEdgeStart>,
    pub klartext: KlartextCycles,
}

impl Default for Cycles {
    fn default() -> Cycles {
        Cycles {
            transmit: Transmit::Refuse,
            groove_dwell: true,
            groove_dwell_revolutions: 1.0,
            cutoff_reference: None,
            drilling_zones: DrillingZones::Both,
            ignores_gripper: false,
            spigot_size: None,
            backward_side: None,
            thread_digits: false,
            multi_edge_start: None,
            klartext: KlartextCycles::default(),
            layers: LayerCycles::default(),
        }
    }
}
