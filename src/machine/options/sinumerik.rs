//! SINUMERIK: machine and setting data that change what a program means.

/// SINUMERIK: machine and setting data that change what a program means.
#[derive(Debug, Clone, PartialEq)]
pub struct Sinumerik {
    /// The control (`802d`, `840dsl`), where a word means something else on it.
    pub model: String,
    /// An increment behind a change of the frame travels the change, too (SD 42440).
    pub frame_offset_incremental: Option<bool>,
    /// Largest difference of the radii at start and end of a circle: in mm, and as a part of the radius
    /// (MD 21000, MD 21010).
    pub circle_error: f64,
    pub circle_error_factor: f64,
    /// T changes the tool, not M6; `None` for what the kind of machine does.
    pub tool_change_by_t: Option<bool>,
    /// Bit 0 of MD 10617: SAVE brings back the frame that the work offset had at the call.
    pub save_restores_offset: Option<bool>,
    /// G40 in front of a move that leaves the plane alone is refused, as alarm 10754 has it.
    pub g40_needs_motion: bool,
    /// A frame stays where a transformation begins or ends (MD 10602).
    pub transformation_keeps_frame: bool,
    /// Variables of the main program are seen in subprograms (MD 11120).
    pub main_variables_visible: bool,
    /// Feed at the start of a program is per revolution (MD 20150).
    pub feed_per_revolution: Option<bool>,
    /// G53, G153 and SUPA suppress the length of the tool, too (MD 10760).
    pub machine_moves_without_tool: bool,
    /// An absolute position of a modulo axis takes the shortest way (MD 30455 bit 2).
    pub modulo_shortest: bool,
    /// A chamfer or rounding that does not fit is made as large as it fits.
    pub shorten_corners: bool,
    /// A chamfer beside an arc stands across the bisector of the corner.
    pub arc_chamfers: bool,
    /// What the machine says about the path of the tool centre.
    pub compensation: CentrePath,
    /// CYCLE86 lifts the tool off under `_GMODE` 1 and 2, or does not; `None` refuses them.
    pub cycle86_lift: Option<bool>,
    /// Which pass of a flank infeed stands at the programmed start.
    pub thread_flank: Option<FlankReference>,
    /// Which program runs where two of one name lie in the folder of the main program; `None` refuses the call.
    pub called_first: Option<CalledFirst>,
    /// What stands beside the path and is left out instead of being refused.
    pub beside: LeftOutBeside,
}

/// Words beside the path that are left out where nothing of them reaches it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LeftOutBeside {
    /// Synchronized actions.
    pub synchronized: bool,
    pub oscillation: bool,
    /// Couplings and curve tables.
    pub couplings: bool,
}

/// What a call of a name runs where a subprogram and a main program have it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CalledFirst {
    /// NAME_SPF.
    Sub,
    /// NAME_MPF.
    Main,
}

/// What the machine says about the path of the tool centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CentrePath {
    /// Largest turn of an outside corner in degrees that gets an intersection under G451 (MD 20210), and under G450
    /// (MD 20230).
    pub limit: Option<f64>,
    pub flat: Option<f64>,
    /// DISC above 0 makes circles.
    pub disc_as_circle: bool,
    /// F on arcs counts as the codes of the program say.
    pub curve_feed: bool,
    /// Blocks that are looked through where the path has no room (MD 20240).
    pub look_ahead: u32,
}

impl Default for CentrePath {
    fn default() -> CentrePath {
        CentrePath { limit: None, flat: None, disc_as_circle: false, curve_feed: false, look_ahead: 3 }
    }
}

/// From where the flank infeed of a thread cycle counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlankReference {
    /// The crest stands at the programmed start; the last pass is shifted most.
    Crest,
    /// The last pass stands there.
    Root,
}

impl Default for Sinumerik {
    fn default() -> Sinumerik {
        Sinumerik {
            model: String::new(),
            frame_offset_incremental: None,
            circle_error: 0.01,
            circle_error_factor: 0.001,
            tool_change_by_t: None,
            save_restores_offset: None,
            g40_needs_motion: false,
            transformation_keeps_frame: false,
            main_variables_visible: false,
            feed_per_revolution: None,
            machine_moves_without_tool: false,
            modulo_shortest: false,
            shorten_corners: false,
            arc_chamfers: false,
            compensation: CentrePath::default(),
            cycle86_lift: None,
            thread_flank: None,
            called_first: None,
            beside: LeftOutBeside::default(),
        }
    }
}
