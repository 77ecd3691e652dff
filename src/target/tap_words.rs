//! The words of a target for tapping without a compensating chuck.

/// How a hole is tapped without a compensating chuck.
#[derive(Debug, Clone, Copy)]
pub enum RigidTap {
    /// A block that begins with `word`, goes to the depth and back to where it began, with the addresses of the `lead`
    /// along the path and of the `factor` on the speed of the way back. The spindle turns before it, and as before
    /// after it.
    Return { word: &'static str, lead: u8, factor: u8 },
    /// A drilling cycle along Z that ends in a word of its own.
    Cycle(TapCycle),
    /// A block in, which begins with `into`, and a block out with `out`. `ready` makes the spindle an axis and takes
    /// its angle; the addresses of the lead, `leads`, are those of X, Y and Z.
    InAndOut { ready: &'static str, into: &'static str, out: &'static str, leads: [u8; 3] },
    /// A cycle of a dialog, and its call.
    Dialog(&'static TapDialog),
}

/// A tapping cycle of drilling cycles in words.
#[derive(Debug, Clone, Copy)]
pub struct TapCycle {
    /// In a block of its own before the cycle, with the speed; `None` where the cycle needs none.
    pub ready: Option<&'static str>,
    /// Taps a right-hand thread.
    pub right: &'static str,
    /// Taps a left-hand thread; `None`: such a tap is refused.
    pub left: Option<&'static str>,
    /// States where the cycle returns to.
    pub level: Option<&'static str>,
    /// Ends the cycle.
    pub off: &'static str,
    /// Address of where the thread begins.
    pub begins: u8,
    /// That is the way from where the tool stands, not a coordinate.
    pub from_start: bool,
    /// What F is in the cycle.
    pub pitch: TapPitch,
    /// Address of the dwell at the bottom, in whole milliseconds; `None` leaves it out.
    pub dwell: Option<u8>,
    /// Address of a whole factor on the speed of the way back, 1 to 9; `None` leaves it out.
    pub factor: Option<u8>,
    /// While it is on, a depth alone taps on in the same hole.
    pub stays: bool,
    /// What lets the steps of one hole begin at the same angle of the spindle.
    pub meets: &'static str,
}

/// What F of a tapping cycle is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TapPitch {
    /// Pitch times speed, under a feed per minute.
    PerMinute,
    /// The pitch, under a feed per revolution.
    PerRevolution,
    /// Either of them, by the kind of feed that is in force.
    Either,
}

/// The tapping cycles of a dialog: in one go, and in steps with more of its parameters.
#[derive(Debug)]
pub struct TapDialog {
    /// Defines a tap in one go.
    pub plain: &'static str,
    /// Defines a tap in steps, or with an angle or a factor.
    pub stepped: &'static str,
    /// Calls the cycle where the tool stands.
    pub call: &'static str,
    /// Set-up clearance, depth, pitch, surface, second clearance; depth of a step, factor on the pitch for the way back, angle,
    /// factor on the speed: the parameter and what it is.
    pub parameters: [(&'static str, &'static str); 9],
    /// So many of them, from the first on, does the plain cycle take.
    pub of_plain: usize,
    /// Places of the factors that are printed.
    pub places: u8,
}
