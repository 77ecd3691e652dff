//! The words of a target for what happens between moves: spindle, coolant, tools, dwells, stops, M functions.

#[derive(Debug)]
pub struct SpindleWords {
    pub clockwise: &'static str,
    pub counter_clockwise: &'static str,
    pub stop: &'static str,
    pub speed: u8,
    /// A speed is a part of the block that starts the spindle.
    pub speed_with_start: bool,
    pub cutting_speed: Option<CuttingSpeed>,
    /// Stop at an angle, and the address of the angle, where the word is not `SPOS=` itself.
    pub orient: Option<(&'static str, Option<u8>)>,
    /// Address that names another spindle, counted from 0.
    pub other: Option<u8>,
}

/// Constant cutting speed.
#[derive(Debug)]
pub struct CuttingSpeed {
    pub on: &'static str,
    pub off: &'static str,
    pub limit: Limit,
}

/// How the largest speed is said.
#[derive(Debug, Clone, Copy)]
pub enum Limit {
    /// This word in the block.
    Word(&'static str),
    /// A block in front, of this word and a speed; it holds until the next one.
    Block(&'static str),
}

#[derive(Debug)]
pub struct CoolantWords {
    pub mist: Option<&'static str>,
    pub flood: &'static str,
    pub off: &'static str,
}

#[derive(Debug)]
pub struct ToolWords {
    pub address: u8,
    /// Largest tool number.
    pub most: u32,
    /// Largest number of an offset that every receiver has, where the length and the radius of a tool are called by one and how
    /// many there are is an option.
    pub most_offset: Option<u32>,
    pub change: Option<Change>,
    /// A tool may be called without being changed.
    pub prepares: bool,
    pub length: Length,
}

/// How a tool comes into the spindle.
#[derive(Debug, Clone, Copy)]
pub enum Change {
    /// The tool and this word.
    Word(&'static str),
    /// `T0101`: the tool and its offset, in so many digits each.
    Turret { digits: usize },
    /// By its block in a dialog.
    Call,
}

/// Length of the tool from the table of the target.
#[derive(Debug, Clone, Copy)]
pub enum Length {
    /// The target has no such table.
    None,
    /// The change brings it.
    WithTool,
    Words(LengthWords),
}

#[derive(Debug, Clone, Copy)]
pub struct LengthWords {
    pub on: &'static str,
    pub number: LengthNumber,
    /// Where there is none, an empty spindle is not said.
    pub off: Option<&'static str>,
    /// The words stand in the next move along Z: alone, some controls move by the length.
    pub with_move: bool,
    /// They are printed unless the configuration says otherwise.
    pub usual: bool,
}

/// What follows the word for the length.
#[derive(Debug, Clone, Copy)]
pub enum LengthNumber {
    /// This address, with the number of the tool.
    Tool(u8),
    /// Nothing.
    None,
}

/// Waiting.
#[derive(Debug, Clone, Copy)]
pub struct Dwell {
    pub word: &'static str,
    pub address: u8,
    pub unit: DwellUnit,
    /// Longest wait of one block in seconds; a longer one takes several.
    pub most: f64,
    /// Under a feed per revolution the number may count revolutions: the feed per minute is switched on before.
    pub per_minute: bool,
}

/// What the number of a wait counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DwellUnit {
    Seconds,
    /// Whole milliseconds.
    Milliseconds,
    /// A setting of the receiver says which of them; so does the configuration.
    Setting,
}

/// Stops and the end of the program.
#[derive(Debug)]
pub struct Flow {
    pub stop: &'static str,
    pub optional_stop: &'static str,
    /// The receiver reads the optional stop and never stops there.
    pub optional_stop_is_idle: bool,
    /// `None` where the end of the text is the end of the program.
    pub end: Option<&'static str>,
    pub rewind: Option<&'static str>,
}

/// M functions that a program passes through.
#[derive(Debug)]
pub struct MFunctions {
    pub address: u8,
    /// Those that the target knows by itself, and what they do there.
    pub own: &'static [(u32, &'static str)],
    /// The machine builder may add M functions to those of the target.
    pub open: bool,
    /// Those of spindle, coolant and stops are matters of the machine, too: they are printed where `pass_m` lists them.
    pub listed: bool,
}
