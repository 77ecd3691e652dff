//! The words of a tilted working plane.

/// How a tilted working plane is said.
#[derive(Debug, Clone, Copy)]
pub enum TiltWords {
    /// One block states the plane, the next one turns the rotary axes.
    Euler(&'static EulerWords),
    /// One call of a cycle does both.
    Swivel(&'static SwivelWords),
    /// Blocks of a dialog.
    Dialog(&'static PlaneWords),
}

/// A plane by its zero point and the angles about Z, the new X and the new Z.
#[derive(Debug)]
pub struct EulerWords {
    /// States the plane.
    pub on: &'static str,
    /// Says which angles follow, where the target knows several kinds.
    pub mode: Option<&'static str>,
    /// Addresses of the angles, in their order.
    pub angles: [u8; 3],
    /// Turns the rotary axes until the tool stands along Z of the plane.
    pub turn: &'static str,
    /// Ends it.
    pub off: &'static str,
}

/// A plane by a call: its zero point, then the angles about Z, the new Y and the new X.
#[derive(Debug)]
pub struct SwivelWords {
    /// In front of the name of the swivel record.
    pub begin: &'static str,
    /// Behind that name: a plane of its own; the zero point and the angles follow.
    pub into: &'static str,
    /// The same of no plane at all, the numbers among it.
    pub back: &'static str,
    /// In front of each number.
    pub between: u8,
    /// What stands between the angles and the direction, which is 1 or -1.
    pub direction: &'static str,
    /// Ends the call.
    pub end: &'static str,
    /// The call that ends the plane and moves nothing.
    pub off: &'static str,
}

/// A plane by the angles about the fixed axes X, Y and Z. Its zero point is a shift before it.
#[derive(Debug)]
pub struct PlaneWords {
    /// Begins the blocks of the shift.
    pub shift: &'static str,
    /// One block of it for each axis, up to the letter.
    pub shift_axes: [&'static str; 3],
    /// Begins the plane.
    pub on: &'static str,
    /// In front of each angle.
    pub angles: [&'static str; 3],
    /// Turns the rotary axes.
    pub turn: &'static str,
    /// The axis next to the tool gets a positive angle, or a negative one.
    pub primary: [&'static str; 2],
    /// An axis parallel to the tool stays, and the coordinates turn.
    pub free: &'static str,
    /// Ends the plane; the rotary axes stay.
    pub off: &'static str,
    /// Ends it; they turn back.
    pub back: &'static str,
}
