//! A small reader of our own output, written without the printer: what the machine does, in order.

use partc::internals::machine::axis::AXES;

use super::meant::{BEFORE, Cutter, Does, Found, How, Kind, Way, is_of_spindle};

/// Position in units of 1e-7, so that nothing is rounded twice, halved diameters neither.
type Units = [i64; AXES];

/// Letters of the axes, in order.
const LETTERS: &str = "XYZABCUVW";
/// Units in a millimetre.
const UNIT: f64 = 1e7;
/// G33.1 as the number of a move.
const TAP: u8 = 133;

struct Reader {
    at: Units,
    plane: [usize; 3],
    diameter: bool,
    feed: f64,
    kind: Kind,
    cutter: Cutter,
    offset: u8,
    length: u32,
    constant_cut: Option<f64>,
    /// Speed and sense of the first spindle.
    spindle: (f64, i8),
    /// How far corners may be rounded off.
    corners: Option<f64>,
    /// Largest difference of the radii of an arc, in units.
    radii: f64,
    list: Vec<Found>,
}

/// Reads a program printed with so many decimals. Fails on any word that a plain program does not have.
pub fn read(program: &str, decimals: u8) -> Result<Vec<Found>, String> {
    let mut reader = Reader {
        at: BEFORE.map(|mm| (mm * UNIT) as i64),
        plane: [0, 1, 2],
        diameter: false,
        feed: 0.0,
        kind: Kind::PerMinute,
        cutter: Cutter::default(),
        offset: 1,
        length: 0,
        constant_cut: None,
        spindle: (0.0, 0),
        corners: None,
        radii: 1.5 * UNIT * 0.1f64.powi(i32::from(decimals)),
        list: Vec::new(),
    };
    for line in program.lines() {
        if line.is_empty() || line == "%" || line.starts_with('(') {
            continue;
        }
        if reader.line(line, decimals).map_err(|why| format!("{line}: {why}"))? {
            break;
        }
    }
    Ok(reader.list)
}

/// The words of one line.
#[derive(Default)]
struct Line {
    motion: Option<u8>,
    ends: Vec<(usize, i64)>,
    offset: [Option<i64>; 3],
    tool: Option<u32>,
    speed: Option<f64>,
    spindle: u8,
    p: Option<f64>,
    d: Option<f64>,
    r: Option<f64>,
    h: Option<u32>,
    dwell: bool,
    blends: bool,
    side: Option<(i8, bool)>,
    cut: Option<bool>,
    m: Option<u32>,
    machine: bool,
}

impl Reader {
    /// True at the end of the program.
    fn line(&mut self, text: &str, decimals: u8) -> Result<bool, String> {
        let mut line = Line::default();
        let mut own_feed = false;
        for word in text.split(' ') {
            let (letter, value) = word.split_at_checked(1).ok_or("two blanks")?;
            if letter == "G" {
                self.code(value, &mut line)?;
                continue;
            }
            // A bound of corners has as many places as are read.
            let places = if letter == "P" && line.blends { 6 } else { decimals };
            let number = units(value, places)?;
            let real = number as f64 / UNIT;
            match letter {
                "T" => line.tool = Some(whole(value)?),
                "H" => line.h = Some(whole(value)?),
                "M" => line.m = Some(whole(value)?),
                "$" => line.spindle = value.parse().map_err(|e| format!("{word}: {e}"))?,
                "S" => line.speed = Some(real),
                "F" => (self.feed, own_feed) = (real, true),
                "P" => line.p = Some(real),
                "D" => line.d = Some(real),
                // Position of the edge behind the diameter of its nose.
                "L" => drop(whole(value)?),
                "R" => line.r = Some(real),
                "I" | "J" | "K" => line.offset["IJK".find(letter).unwrap_or(0)] = Some(number),
                _ => {
                    let axis = LETTERS.find(letter).ok_or_else(|| format!("unknown word {word}"))?;
                    line.ends.push((axis, if axis == 0 && self.diameter { number / 2 } else { number }));
                }
            }
        }
        self.modes(&line);
        if self.kind == Kind::Inverse && matches!(line.motion, Some(1..=3)) && !own_feed {
            return Err("a move by time without its F".to_owned());
        }
        if line.motion.is_some() {
            self.moves(&line)?;
        } else if !line.ends.is_empty() {
            return Err("axes without a move".to_owned());
        }
        Ok(self.ends(&line))
    }

    /// A G code.
    fn code(&mut self, value: &str, line: &mut Line) -> Result<(), String> {
        match value {
            "0" | "1" | "2" | "3" | "33" => line.motion = value.parse().ok(),
            "33.1" => line.motion = Some(TAP),
            "4" => line.dwell = true,
            "7" | "8" => self.diameter = value == "7",
            "17" => self.plane = [0, 1, 2],
            "18" => self.plane = [2, 0, 1],
            "19" => self.plane = [1, 2, 0],
            "40" => self.cutter = Cutter::default(),
            "41" | "41.1" => line.side = Some((1, value == "41.1")),
            "42" | "42.1" => line.side = Some((-1, value == "42.1")),
            "43" => {}
            "49" => line.h = Some(0),
            "53" => line.machine = true,
            "61" => self.corners = Some(0.0),
            "64" => line.blends = true,
            "21" | "90" | "91.1" | "80" => {}
            "54" | "55" | "56" | "57" | "58" | "59" | "59.1" | "59.2" | "59.3" => {
                let last = value.split('.').nth(1).and_then(|n| n.parse::<u8>().ok()).unwrap_or(0);
                let number = value[..2].parse::<u8>().map_err(|e| e.to_string())? - 53 + last;
                if std::mem::replace(&mut self.offset, number) != number {
                    self.does(Does::WorkOffset(number));
                }
            }
            "93" | "94" | "95" => {
                let kind = match value {
                    "93" => Kind::Inverse,
                    "94" => Kind::PerMinute,
                    _ => Kind::PerRevolution,
                };
                // A feed of another kind counts no longer.
                if std::mem::replace(&mut self.kind, kind) != kind {
                    self.feed = 0.0;
                }
            }
            "96" | "97" => line.cut = Some(value == "96"),
            _ => return Err(format!("unknown code G{value}")),
        }
        Ok(())
    }

    fn does(&mut self, does: Does) {
        self.list.push(Found::Does(does));
    }

    /// Tool, length, speed, compensation, dwell.
    fn modes(&mut self, line: &Line) {
        if line.blends {
            self.corners = Some(line.p.unwrap_or(f64::INFINITY));
        }
        if let Some(tool) = line.tool {
            self.does(Does::Select(tool));
        }
        if let Some(number) = line.h
            && std::mem::replace(&mut self.length, number) != number
        {
            self.does(Does::Length(number));
        }
        match line.cut {
            Some(true) => {
                let limit = line.d.unwrap_or(f64::INFINITY);
                self.constant_cut = Some(limit);
                self.does(Does::CuttingSpeed(true, limit));
            }
            Some(false) if self.constant_cut.take().is_some() => self.does(Does::CuttingSpeed(false, 0.0)),
            _ => {}
        }
        if let Some(speed) = line.speed {
            if line.spindle == 0 {
                self.spindle.0 = speed;
            }
            self.does(Does::Speed(line.spindle, speed));
        }
        if let Some((side, dynamic)) = line.side {
            let diameter = line.d.filter(|_| dynamic);
            let number = if dynamic { 0 } else { line.d.unwrap_or(0.0) as u32 };
            self.cutter = Cutter { side, number, diameter };
        }
        if line.dwell {
            self.does(Does::Dwell(line.p.unwrap_or(0.0)));
        }
    }

    fn how(&self, line: &Line) -> How {
        let feed = matches!(line.motion, Some(1..=3)).then_some((self.kind, self.feed));
        let lead = line.offset[2].filter(|_| line.motion == Some(33)).map(|lead| lead as f64 / UNIT);
        How { feed, lead, cutter: self.cutter, machine: line.machine, plane: Some(self.plane), corners: self.corners }
    }

    /// Down and back to where the axis stands.
    fn tap(&mut self, line: &Line) -> Result<(), String> {
        let (&[(axis, to)], Some(lead)) = (line.ends.as_slice(), line.offset[2]) else {
            return Err("a tap goes along one axis, with a lead".to_owned());
        };
        while self.list.last().is_some_and(|item| matches!(item, Found::Does(does) if is_of_spindle(does))) {
            self.list.pop();
        }
        let (speed, turn) = self.spindle;
        self.does(Does::Tap { axis, to: to as f64 / UNIT, lead: lead as f64 / UNIT, turn, speed });
        Ok(())
    }

    fn moves(&mut self, line: &Line) -> Result<(), String> {
        if line.motion == Some(TAP) {
            return self.tap(line);
        }
        let from = self.at;
        for (axis, units) in &line.ends {
            self.at[*axis] = *units;
        }
        let mm = |u: i64| u as f64 / UNIT;
        let end = self.at.map(mm);
        let how = self.how(line);
        let way = match line.motion {
            Some(0) => Way::Rapid(end),
            Some(1 | 33) => Way::Feed(end),
            _ => {
                let [a, b, _] = self.plane;
                let offset = |axis: usize| line.offset[axis].unwrap_or(0);
                let center = [from[a] + offset(a), from[b] + offset(b)];
                let radius = |p: Units| {
                    let (x, y) = (i128::from(p[a] - center[0]), i128::from(p[b] - center[1]));
                    ((x * x + y * y) as f64).sqrt()
                };
                let off = (radius(from) - radius(self.at)).abs();
                if off > self.radii {
                    return Err(format!("the radii differ by {off} units"));
                }
                let turns = line.p.unwrap_or(1.0) as i32;
                let turns = if line.motion == Some(3) { turns } else { -turns };
                Way::Arc { plane: self.plane, center: center.map(mm), turns, end }
            }
        };
        self.list.push(Found::Move(way, how));
        Ok(())
    }

    /// The M function, behind everything else; true at the end of the program.
    fn ends(&mut self, line: &Line) -> bool {
        let Some(m) = line.m else { return false };
        if line.spindle == 0 && matches!(m, 3..=5) {
            self.spindle.1 = [1, -1, 0][m as usize - 3];
        }
        self.does(match m {
            0 => Does::Stop,
            1 => Does::OptionalStop,
            2 | 30 => Does::End { rewind: m == 30 },
            3 => Does::Turns(line.spindle, 1),
            4 => Does::Turns(line.spindle, -1),
            5 => Does::Turns(line.spindle, 0),
            6 => Does::Change,
            7 => Does::Mist,
            8 => Does::Flood,
            9 => Does::CoolantOff,
            19 => Does::Orient(line.spindle, line.r.unwrap_or(0.0)),
            _ => Does::Aux(m),
        });
        matches!(m, 2 | 30)
    }
}

fn whole(text: &str) -> Result<u32, String> {
    text.parse().map_err(|e| format!("{text}: {e}"))
}

/// A decimal in units.
fn units(text: &str, decimals: u8) -> Result<i64, String> {
    let (sign, digits) = text.strip_prefix('-').map_or((1, text), |digits| (-1, digits));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let bare = fraction.is_empty() && digits.contains('.');
    if fraction.len() > usize::from(decimals) || text == "-0" || fraction.ends_with('0') || whole.is_empty() || bare {
        return Err(format!("{text} is not how numbers are printed"));
    }
    let number = format!("{whole}{fraction:0<7}").parse::<i64>().map_err(|e| format!("{text}: {e}"))?;
    Ok(sign * number)
}
