//! The words of a target for what happens between moves: spindle, coolant, tools, dwells, stops, M functions.

/// Spindles and their speeds.
#[derive(Debug)]
pub struct SpindleWords {
    /// Starts the spindle: M3.
    pub clockwise: &'static str,
    /// Starts it in the other sense: M4.
    pub counter_clockwise: &'static str,
    /// Stops it.
    pub stop: &'static str,
    /// Address of a speed, in rev/min or m/min.
    pub speed: u8,
    /// A speed is a part of the block that starts the spindle.
    pub speed_with_start: bool,
    /// Constant cutting speed.
    pub cutting_speed: Option<CuttingSpeed>,
    /// Stop at an angle in degrees: a word, and the address of the angle, where the word does not take it itself as
    /// `SPOS=` does.
    pub orient: Option<(&'static str, Option<u8>)>,
    /// Address that names another spindle, counted from 0.
    pub other: Option<u8>,
}

/// Constant cutting speed.
#[derive(Debug)]
pub struct CuttingSpeed {
    /// A speed is a cutting speed in m/min from here on.
    pub on: &'static str,
    /// A speed counts turns a minute from here on.
    pub off: &'static str,
    /// How the largest speed is said, in rev/min.
    pub limit: Limit,
}

/// How the largest speed is said.
#[derive(Debug, Clone, Copy)]
pub enum Limit {
    /// This word in the block.
    Word(&'static str),
    /// A block before it, of this word and a speed; it holds until the next one.
    Block(&'static str),
}

/// Coolant on and off.
#[derive(Debug)]
pub struct CoolantWords {
    /// Mist on.
    pub mist: Option<&'static str>,
    /// Flood on.
    pub flood: &'static str,
    /// All coolant off.
    pub off: &'static str,
}

/// Tools, their change and their length.
#[derive(Debug)]
pub struct ToolWords {
    /// Address of a tool number; not used in a dialog.
    pub address: u8,
    /// Largest tool number.
    pub most: u32,
    /// Largest number of an offset that every receiver has, where the length and the radius of a tool are called by one and how
    /// many there are is an option.
    pub most_offset: Option<u32>,
    /// How a tool is changed; `None` for by hand alone.
    pub change: Option<Change>,
    /// A tool may be called without being changed.
    pub prepares: bool,
    /// Where the length of a tool comes from.
    pub length: Length,
}

/// How a tool comes into the spindle.
#[derive(Debug, Clone, Copy)]
pub enum Change {
    /// The tool and this word.
    Word(&'static str),
    /// `T0101`: the tool and its offset, in so many `digits` each; there is no tool 0.
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
    /// Words select it after the change.
    Words(LengthWords),
}

/// Words that select the length of a tool.
#[derive(Debug, Clone, Copy)]
pub struct LengthWords {
    /// Selects the length.
    pub on: &'static str,
    /// Which length, after that word.
    pub number: LengthNumber,
    /// Ends it, for an empty spindle; `None`: an empty spindle is refused.
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
    /// Begins the block.
    pub word: &'static str,
    /// Address of the time; a blank where the number follows the word.
    pub address: u8,
    /// What the number counts.
    pub unit: DwellUnit,
    /// Longest wait of one block in seconds; a longer one takes several.
    pub most: f64,
    /// Under a feed per revolution the number may count revolutions: the feed per minute is switched on before.
    pub per_minute: bool,
}

/// What the number of a wait counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DwellUnit {
    /// Seconds, in parts as well.
    Seconds,
    /// Whole milliseconds.
    Milliseconds,
    /// A setting of the receiver says which of them; so does the configuration.
    Setting,
}

/// Stops and the end of the program.
#[derive(Debug)]
pub struct Flow {
    /// Stops the program.
    pub stop: &'static str,
    /// Stops it where the operator has asked for it.
    pub optional_stop: &'static str,
    /// The receiver reads the optional stop and never stops there.
    pub optional_stop_is_idle: bool,
    /// Ends the program where it stands; `None` where the end of the text is its end.
    pub end: Option<&'static str>,
    /// Ends it and goes back to its start; `None` as for `end`.
    pub rewind: Option<&'static str>,
}

/// M functions that a program passes through.
#[derive(Debug)]
pub struct MFunctions {
    /// Address of the number.
    pub address: u8,
    /// Those that the target knows by itself, and what they do there.
    pub own: &'static [(u32, &'static str)],
    /// The machine builder may add M functions to those of the target.
    pub open: bool,
    /// Those of spindle, coolant and stops are matters of the machine, too: they are printed where `pass_m` lists them.
    pub listed: bool,
}
