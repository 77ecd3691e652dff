//! Holes that are tapped in step with the spindle: each stroke goes where it is meant to, at the pitch, the hand and the speed
//! that are meant.

use crate::geo::tolerance;
use crate::ir::function::Turn;
use crate::ir::motion::Place;
use crate::ir::{Origin, Tap};
use crate::read::{self, Act, FeedKind, SCALE, Way};

use super::{Text, Validator, Why, is_rounding};

/// What a product of printed numbers loses, in units of the reader.
const LOST: f64 = 2.0;

/// How far the strokes of a tap were found in the text.
struct Found {
    /// Strokes that are complete.
    strokes: usize,
    /// The tool is at the depth of the next one.
    inside: bool,
    /// Seconds that were waited since the last move.
    waited: i64,
    angle: Option<i64>,
}

impl Validator {
    /// `bytes` up to `end` were printed for this tap.
    pub fn tap(&mut self, tap: &Tap, place: &Place, origin: &Origin, bytes: &[u8], end: usize) {
        if self.done {
            return;
        }
        let text = Text { bytes, end };
        let result = self.is_in_plane().and_then(|()| self.check_tap(tap, place, text));
        // Its F may have been a pitch.
        self.feed = None;
        self.judge(result, tap, origin, text);
    }

    fn check_tap(&mut self, tap: &Tap, place: &Place, text: Text<'_>) -> Result<(), Why> {
        let Text { bytes: mut rest, mut end } = text;
        let axis = tap.axis.index();
        if self.length.is_some() && axis == 2 {
            return Err(Why::new("the length of another tool counts"));
        }
        let mut found = Found { strokes: 0, inside: false, waited: 0, angle: None };
        let mut begun = false;
        while let Some(act) = self.reader.next(&mut rest, &mut end)? {
            match act {
                Act::Move(mv) if !begun && mv.path == read::Path::Rapid && mv.axes == 1 << axis && !mv.machine => {
                    self.stated |= mv.axes;
                }
                Act::Tap => {
                    if !begun {
                        self.begins_there(tap, axis)?;
                        self.same_angle(tap, &found)?;
                    }
                    begun = true;
                    self.stroke(tap, &mut found)?;
                }
                Act::Dwell(seconds) => found.waited = found.waited.saturating_add(seconds),
                Act::Speed(_) | Act::M { number: 29, .. } => {}
                Act::M { number: 19, spindle: 0, angle } if !begun => found.angle = angle,
                Act::M { number, spindle: 0, .. } if !begun && number == m_of(tap.turn) => {}
                Act::Move(_)
                | Act::M { .. }
                | Act::Select(_)
                | Act::Change
                | Act::Corners(_)
                | Act::Offset(_)
                | Act::Tilt(_) => {
                    return Err(Why::new("something happens in a tap that is not meant"));
                }
            }
        }
        let modes = self.reader.modes();
        if found.strokes != tap.strokes.len() || found.inside || found.waited != 0 {
            return Err(Why::new("the tap is not complete"));
        }
        if !modes.cycles_are_off {
            return Err(Why::new("the tapping cycle is still on"));
        }
        // What is printed for a move without a side holds here as well.
        self.same_side(&place.along(tap, tap.end(), crate::ir::motion::Path::Rapid))
    }

    /// The axis stands where the tap begins, and the target knows it.
    fn begins_there(&self, tap: &Tap, axis: usize) -> Result<(), Why> {
        let known = self.stated & self.reader.known() & (1 << axis) != 0;
        if known && self.is_height(self.reader.tap().from, tap.start) {
            Ok(())
        } else {
            Err(Why::new("the tap begins elsewhere, or it is not certain where"))
        }
    }

    fn same_angle(&self, tap: &Tap, found: &Found) -> Result<(), Why> {
        let read = found.angle.or(self.reader.tap().angle);
        let same = match (read, tap.orient) {
            (Some(read), meant) => is_rounding(read, meant.unwrap_or(0.0), self.grain.angle),
            // What has no word for it says so.
            (None, _) => true,
        };
        if same { Ok(()) } else { Err(Why::new("the tap begins at another angle of the spindle")) }
    }

    /// Half of the last place of a height along the axis of a tap.
    fn is_height(&self, read: i64, meant: f64) -> bool {
        let half = if self.reader.tap().axis == 0 { self.half_of_x } else { self.half };
        is_rounding(read, meant, half)
    }

    fn stroke(&mut self, tap: &Tap, found: &mut Found) -> Result<(), Why> {
        let read = *self.reader.tap();
        if read.axis != tap.axis.index() {
            return Err(Why::new("the tap goes along another axis"));
        }
        if read.left != (tap.turn == Turn::CounterClockwise) {
            return Err(Why::new("the tapped thread has the other hand"));
        }
        self.same_lead(tap, &read)?;
        let Some(stroke) = tap.strokes.get(found.strokes) else { return Err(Why::new("a stroke too many")) };
        match read.way {
            Way::Both => {
                self.same_speed(&read, tap.speed_in)?;
                self.waits(found, if found.strokes > 0 { tap.pause } else { 0.0 })?;
                if read.dwell != 0 && !is_rounding(read.dwell, stroke.dwell, self.grain.time) {
                    return Err(Why::new("the tap waits another time at its depth"));
                }
                let factor = read.factor as f64 / SCALE as f64;
                // What has no word for it says so.
                if read.factor != SCALE && (factor - tap.factor()).abs() > self.grain.lead / SCALE as f64 + 1e-9 {
                    return Err(Why::new("the tap goes out at another speed"));
                }
                if read.steps.is_some() {
                    return self.same_steps(tap, &read, found);
                }
                let returns = self.is_height(read.back, stroke.back) || self.is_height(read.back, tap.start);
                let last = found.strokes + 1 == tap.strokes.len();
                if !self.is_height(read.to, stroke.to) || !returns || last && !self.is_height(read.back, tap.end()) {
                    return Err(Why::new("a stroke of the tap leads elsewhere"));
                }
                found.strokes += 1;
            }
            Way::In => {
                let resumes = tap.resumes(found.strokes).filter(|_| !found.inside);
                if let Some(resumes) = resumes.filter(|to| self.is_height(read.to, *to)) {
                    let _ = resumes;
                    self.waits(found, tap.pause)?;
                    self.same_speed(&read, tap.speed_out.or(tap.speed_in))?;
                    return Ok(());
                }
                self.same_speed(&read, tap.speed_in)?;
                let above = self.is_height(read.from, tap.resumes(found.strokes).unwrap_or(f64::NAN));
                self.waits(found, if found.strokes > 0 && !above { tap.pause } else { 0.0 })?;
                if found.inside || !self.is_height(read.to, stroke.to) {
                    return Err(Why::new("a stroke of the tap leads elsewhere"));
                }
                found.inside = true;
            }
            Way::Out => {
                self.same_speed(&read, tap.speed_out.or(tap.speed_in))?;
                self.waits(found, stroke.dwell)?;
                if !std::mem::take(&mut found.inside) || !self.is_height(read.back, stroke.back) {
                    return Err(Why::new("a stroke of the tap comes back elsewhere"));
                }
                found.strokes += 1;
            }
        }
        Ok(())
    }

    /// The wait in front of a move of the tap.
    fn waits(&self, found: &mut Found, meant: f64) -> Result<(), Why> {
        let waited = std::mem::take(&mut found.waited);
        if is_rounding(waited, meant, self.grain.time) { Ok(()) } else { Err(Why::new("the tap waits another time")) }
    }

    fn same_speed(&self, read: &read::Tap, meant: Option<f64>) -> Result<(), Why> {
        match (read.speed, meant) {
            (Some(read), Some(meant)) if is_rounding(read, meant, self.grain.speed) => Ok(()),
            // The one that was said before holds.
            (_, None) => Ok(()),
            _ => Err(Why::new("the tap has another speed")),
        }
    }

    fn same_lead(&self, tap: &Tap, read: &read::Tap) -> Result<(), Why> {
        let off = (read.lead as f64 - tap.lead * SCALE as f64).abs();
        let turns = read.speed.map_or(1.0, |speed| speed as f64 / SCALE as f64).max(f64::MIN_POSITIVE);
        // F of a cycle is the pitch, or pitch times speed.
        let grain = match self.reader.modes().feed_kind {
            Some(FeedKind::PerRevolution) => self.grain.feed_per_revolution,
            Some(FeedKind::PerMinute | FeedKind::InverseTime) | None => self.grain.feed / turns,
        };
        let near = off <= grain.max(self.grain.lead) + LOST
            && off * tap.turns() <= tolerance::PITCH_LEAVES * SCALE as f64 + LOST;
        if near { Ok(()) } else { Err(Why::new("the tapped thread has another pitch")) }
    }

    /// A cycle that makes all steps by itself.
    fn same_steps(&self, tap: &Tap, read: &read::Tap, found: &mut Found) -> Result<(), Why> {
        let Some([surface, way, back]) = read.steps else { return Ok(()) };
        let sign = if tap.outward() > 0.0 { -1 } else { 1 };
        let last = tap.strokes.len().saturating_sub(1);
        let mut depth = surface;
        for (at, stroke) in tap.strokes.iter().enumerate() {
            depth = if at == last { read.to } else { depth.saturating_add(sign * way) };
            let returns = if at == last || back == 0 { read.back } else { depth.saturating_sub(sign * back) };
            // The way back is the product of two printed numbers.
            let product = self.half + self.grain.lead * 2.0;
            let near = (returns as f64 - stroke.back * SCALE as f64).abs() <= product;
            let deeper = at < last || (read.to - surface) * sign > way * last as i64;
            // It is the sum of two printed numbers, and may lie on the other side of a tie.
            let off = (depth as f64 - stroke.to * SCALE as f64).abs();
            if off > self.half + LOST + at as f64 || !near || !deeper {
                return Err(Why::new("a step of the tap leads elsewhere"));
            }
        }
        if (read.to - surface) * sign > way.saturating_mul(tap.strokes.len() as i64) {
            return Err(Why::new("the tap makes more steps"));
        }
        found.strokes = tap.strokes.len();
        Ok(())
    }
}

fn m_of(turn: Turn) -> u32 {
    match turn {
        Turn::Clockwise => 3,
        Turn::CounterClockwise => 4,
    }
}
