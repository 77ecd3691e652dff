//! What differs between the receivers: which words they know, and what those mean.

use super::number::SCALE;

/// How a receiver reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rules {
    /// G functions.
    pub words: Words,
    /// A line `O0001` in front of the program names it.
    pub named: bool,
    /// What G4 counts its wait in, and in units of what.
    pub dwell: (u8, i64),
    /// Arcs take their number of turns.
    pub turns: bool,
    /// The address of the lead of a thread. An F is the lead along the one axis that moves, and no feed behind it.
    pub lead: u8,
    /// X words are diameters, always.
    pub diameters: bool,
    /// T0101 changes the tool: this many digits each for the tool and its offset.
    pub turret: Option<u32>,
    /// G40, G41 and G42 change the side in a straight move in the plane only.
    pub side_moves: bool,
    /// G43 stands in a move along Z only: alone it would move by the length.
    pub length_moves: bool,
    /// What its tapping cycles want.
    pub taps: Taps,
    /// Words say how corners are taken.
    pub corners: bool,
    /// G68.2, G53.1 and G69 say how the working plane is tilted, in one block with P0 or without it.
    pub tilts: Option<bool>,
    /// Rapid traverse goes at the last F, so that each such move has to have this one; negative where nobody said which.
    pub rapid_feed: Option<i64>,
}

/// How a drilling cycle taps in step with the spindle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Taps {
    /// It does not, or its words are others.
    No,
    /// M29 announces it; F is the pitch under a feed per revolution, pitch times speed otherwise; P is a dwell.
    Announced,
    /// It always does, and F is pitch times speed; J is a factor on the speed of the way back.
    Plain,
    /// G84.2 and G84.3 do, and F is the pitch.
    ByPitch,
}

/// Families of G functions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Words {
    /// LinuxCNC and what follows it.
    Rs274,
    /// Mills that read as Fanuc does.
    FanucMill,
    /// Fanuc lathes: absolute by letters, G98 and G99 for feeds, G50 for the largest speed.
    LatheA,
    /// Fanuc lathes with G90, G94, G95 and G92 for the largest speed.
    LatheB,
    /// The same with G70 and G71 for the units.
    LatheC,
    /// SINUMERIK: names of several letters, numbers behind `=`, comments behind `;`.
    Siemens,
    /// Mach3 and UCCNC.
    Mach,
    /// Okuma mills: G15 for work offsets, G56 for lengths.
    Okuma,
    /// HEIDENHAIN Klartext: blocks that begin with what they do.
    Dialog,
    /// Klipper and Marlin: a line is one command and its parameters.
    Command,
}

pub(super) const RS274: Rules = Rules {
    words: Words::Rs274,
    named: false,
    dwell: (b'P', 1),
    turns: true,
    lead: b'K',
    diameters: false,
    turret: None,
    side_moves: false,
    length_moves: false,
    taps: Taps::No,
    corners: true,
    tilts: None,
    rapid_feed: None,
};

/// Parts of a second that a wait may count.
const THOUSANDTHS: i64 = 1000;

const FANUC: Rules = Rules {
    words: Words::FanucMill,
    named: true,
    dwell: (b'P', THOUSANDTHS),
    turns: false,
    lead: b'F',
    diameters: false,
    turret: None,
    side_moves: true,
    length_moves: true,
    taps: Taps::Announced,
    corners: true,
    tilts: None,
    rapid_feed: None,
};

const LATHE: Rules = Rules { words: Words::LatheA, diameters: true, turret: Some(2), length_moves: false, ..FANUC };

const MACH: Rules = Rules { words: Words::Mach, turns: false, side_moves: true, ..RS274 };

const OKUMA: Rules = Rules { words: Words::Okuma, taps: Taps::No, dwell: (b'F', 1), corners: false, ..FANUC };

const DIALOG: Rules = Rules { words: Words::Dialog, turns: false, ..RS274 };

const COMMAND: Rules = Rules {
    words: Words::Command,
    dwell: (b'P', THOUSANDTHS),
    turns: false,
    corners: false,
    rapid_feed: Some(-1),
    ..RS274
};

const SIEMENS: Rules = Rules { words: Words::Siemens, dwell: (b'F', 1), turns: false, side_moves: true, ..RS274 };

impl Rules {
    /// Those of a receiver by its name.
    pub fn of(target: &str) -> Rules {
        match target {
            "fanuc" => Rules { tilts: Some(false), ..FANUC },
            "haas" => Rules { taps: Taps::Plain, ..FANUC },
            "mazak" => Rules { taps: Taps::ByPitch, tilts: Some(true), ..FANUC },
            "centroid" => Rules { dwell: (b'P', 1), taps: Taps::No, corners: false, ..FANUC },
            "grbl" | "grblhal" => Rules { corners: false, ..RS274 },
            "fanuc-lathe" => LATHE,
            "fanuc-lathe-b" => Rules { words: Words::LatheB, taps: Taps::No, ..LATHE },
            "fanuc-lathe-c" => Rules { words: Words::LatheC, taps: Taps::No, ..LATHE },
            "sinumerik" => SIEMENS,
            "heidenhain" => DIALOG,
            "mach3" => MACH,
            "uccnc" => Rules { dwell: (b'P', THOUSANDTHS), ..MACH },
            "okuma" => OKUMA,
            "klipper" | "marlin" => COMMAND,
            _ => RS274,
        }
    }

    /// The same where a setting says that waits count milliseconds.
    pub fn in_milliseconds(self, milliseconds: bool) -> Rules {
        let (letter, parts) = self.dwell;
        Rules { dwell: (letter, if milliseconds { THOUSANDTHS } else { parts }), ..self }
    }

    /// The same with the feed in mm/min at which rapid traverse goes.
    pub fn at_rapid(self, feed: Option<u32>) -> Rules {
        let feed = feed.map(|feed| i64::from(feed) * SCALE);
        Rules { rapid_feed: self.rapid_feed.and(feed).or(self.rapid_feed), ..self }
    }

    /// The end of the text is the end of the program.
    pub fn ends_with_text(&self) -> bool {
        self.words == Words::Command
    }

    /// A G function, in tenths, as RS274 numbers what it does.
    pub(super) fn function(&self, tenths: i64) -> Option<G> {
        let g = |tenths| Some(G::Rs274(tenths));
        let common = matches!(
            tenths,
            0 | 10
                | 20
                | 30
                | 40
                | 170
                | 180
                | 190
                | 400
                | 410
                | 420
                | 530
                | 540
                | 550
                | 560
                | 570
                | 580
                | 590
                | 800
                | 960
                | 970
        );
        if !self.corners && matches!(tenths, 600 | 610 | 611 | 640 | 6410 | 6420) {
            return None;
        }
        if self.tilts.is_some() {
            match tenths {
                682 => return Some(G::Tilt(TiltWord::Stated)),
                531 => return Some(G::Tilt(TiltWord::Turns)),
                690 => return Some(G::Tilt(TiltWord::Off)),
                _ => {}
            }
        }
        match self.words {
            // Other receivers have other words for these.
            Words::Rs274 if matches!(tenths, 600 | 6410 | 6420) => None,
            Words::Rs274 => g(tenths),
            Words::Dialog => None,
            Words::Command => match tenths {
                0 | 10 | 20 | 30 | 40 | 170 | 180 | 190 | 210 | 900 | 910 => g(tenths),
                _ => None,
            },
            Words::Mach | Words::Okuma if matches!(tenths, 530 | 960 | 970) => None,
            Words::Okuma => match tenths {
                150 => Some(G::OffsetByNumber(b'H', 0)),
                560 => g(430),
                0 | 10 | 20 | 30 | 40 | 170 | 180 | 190 | 200 | 210 | 400 | 410 | 420 | 800 | 900 | 940 => g(tenths),
                _ => None,
            },
            Words::Siemens => match tenths {
                0 | 10 | 20 | 30 | 40 | 170 | 180 | 190 | 330 | 400 | 410 | 420 | 540 | 550 | 560 | 570 | 600 | 640
                | 900 | 910 | 940 | 950 | 3310 | 3320 | 6410 | 6420 => g(tenths),
                5050..=5990 if tenths % 10 == 0 => Some(G::Offset((tenths / 10 - 500) as u8)),
                7000 => g(200),
                7100 => g(210),
                _ => None,
            },
            _ if common => g(tenths),
            Words::Mach => match tenths {
                200 | 210 | 430 | 490 | 610 | 640 | 900 | 910 | 911 | 940 => g(tenths),
                _ => None,
            },
            Words::FanucMill => match tenths {
                200 | 210 | 430 | 490 | 610 | 640 | 900 | 910 | 940 | 950 => g(tenths),
                740 | 840 if matches!(self.taps, Taps::Announced | Taps::Plain) => g(tenths),
                842 if self.taps == Taps::ByPitch => g(840),
                843 if self.taps == Taps::ByPitch => g(740),
                990 if self.taps != Taps::No => g(tenths),
                920 => Some(G::SpeedLimit),
                // Haas has G154 for it.
                541 | 1540 => Some(G::OffsetByNumber(b'P', 6)),
                _ => None,
            },
            Words::LatheA => match tenths {
                200 | 210 | 610 | 640 => g(tenths),
                320 => g(330),
                840 if self.taps == Taps::Announced => g(tenths),
                500 => Some(G::SpeedLimit),
                980 => g(940),
                990 => g(950),
                _ => None,
            },
            Words::LatheB | Words::LatheC => match (tenths, self.words) {
                (200 | 210, Words::LatheB) | (330 | 610 | 640 | 900 | 910 | 940 | 950, _) => g(tenths),
                (700, Words::LatheC) => g(200),
                (710, Words::LatheC) => g(210),
                (920, _) => Some(G::SpeedLimit),
                _ => None,
            },
        }
    }

    /// The modes that hold without a word for them.
    pub(super) fn fixes(&self) -> Fixed {
        let lathe = matches!(self.words, Words::LatheA | Words::LatheB | Words::LatheC);
        let dialog = self.words == Words::Dialog;
        let command = self.words == Words::Command;
        Fixed {
            centers: !matches!(self.words, Words::Rs274 | Words::Mach),
            absolute: self.words == Words::LatheA || dialog,
            // A turret brings the length with the tool.
            no_length: lathe || dialog || command || self.words == Words::Okuma,
            // SINUMERIK has no G80: cycles are calls.
            no_cycles: lathe || self.words == Words::Siemens || dialog || command,
            // What a TNC selects anew begins so.
            per_minute: dialog || command,
            no_cutter: dialog || command,
        }
    }

    /// A wait in seconds.
    pub(super) fn seconds(&self, units: i64) -> Option<i64> {
        let (_, parts) = self.dwell;
        // Milliseconds are whole.
        (parts == 1 || units % SCALE == 0).then_some(units / parts)
    }
}

/// What a G function does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum G {
    /// What the function of this number, in tenths, does in RS274.
    Rs274(i64),
    /// S is the largest speed.
    SpeedLimit,
    /// Selects the work offset of this number.
    Offset(u8),
    /// This letter has the number of a work offset, counted on from so many.
    OffsetByNumber(u8, u8),
    /// Says something of a tilted plane.
    Tilt(TiltWord),
}

/// What a word says of a tilted plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TiltWord {
    /// G68.2: how it lies.
    Stated,
    /// G53.1: the axes turn.
    Turns,
    /// G69
    Off,
}

/// Modes that no word states.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fixed {
    /// Where centres count from: in words from the start of the arc, in a dialog from the zero point.
    pub centers: bool,
    pub absolute: bool,
    pub no_length: bool,
    pub no_cycles: bool,
    pub per_minute: bool,
    pub no_cutter: bool,
}
