//! Holes that are tapped in step with the spindle, as each receiver says them: a block that comes back, a cycle, a block in
//! and a block out.

use super::act::{AXES, Act, FeedKind, LETTERS, Tap, Way};
use super::block::{Block, TAP_CYCLE, TAP_INTO, TAP_LEFT_CYCLE, TAP_RETURN};
use super::number::SCALE;
use super::rules::{Taps, Words};
use super::{Fault, Lack, Reader};

/// The M function of the spindle that turns right, and left.
const TURNS: [u32; 2] = [3, 4];

impl Reader {
    /// What the acts of a line make of the spindle.
    pub(super) fn spindle_hears(&mut self, act: &Act) {
        self.spindle.tapped &= !matches!(act, Act::Speed(_) | Act::M { .. });
        match *act {
            Act::Speed(speed) if speed.spindle == 0 => {
                self.spindle.speed = speed.constant_cut.is_none().then_some(speed.value);
            }
            Act::M { number: number @ (3..=5), spindle: 0, .. } => {
                self.spindle.turn = TURNS.contains(&number).then_some(number);
                self.spindle.is_axis = false;
            }
            Act::M { number: 19, spindle: 0, .. } => {
                self.spindle.turn = None;
                self.spindle.is_axis = true;
            }
            Act::M { number: 29, .. } => self.spindle.is_ready = true,
            Act::Move(_)
            | Act::Tap
            | Act::Select(_)
            | Act::Change
            | Act::Speed(_)
            | Act::M { .. }
            | Act::Dwell(_)
            | Act::Corners(_)
            | Act::Offset(_)
            | Act::Tilt(_) => {}
        }
    }

    /// A line of a tap.
    pub(super) fn taps(&mut self, block: &mut Block, motion: u8) -> Result<(), Fault> {
        if block.machine {
            return Err(Fault::new("a tap in machine coordinates"));
        }
        match self.modes.incremental {
            Some(false) => {}
            Some(true) => return Err(Fault::new("taps under G91 are not supported: write G90 and the depth itself")),
            None => return Err(Fault::unsaid("a tap, and neither G90 nor G91 was said before", Lack::Mode)),
        }
        if self.modes.constant_cut == Some(true) {
            return Err(Fault::new("a tap under a constant cutting speed"));
        }
        match motion {
            TAP_RETURN => self.tap_returns(block),
            TAP_CYCLE | TAP_LEFT_CYCLE => self.tap_cycle(block, motion == TAP_LEFT_CYCLE),
            _ => self.tap_one_way(block, motion == TAP_INTO),
        }
    }

    /// The one axis that the line names, where it stands, and where it goes.
    fn tap_axis(&mut self, block: &mut Block) -> Result<(usize, i64, i64), Fault> {
        let mut named = (0..3).filter(|axis| block.has(LETTERS[*axis]));
        let (Some(axis), None) = (named.next(), named.next()) else {
            return Err(Fault::new("a tap goes along one axis"));
        };
        let from = self.place(axis).ok_or_else(|| Fault::unsaid("a tap from an unknown place", Lack::Place(axis)))?;
        let number = block.take(LETTERS[axis]).unwrap_or_default();
        let mut to = self.length(number)?;
        if axis == 0 && self.modes.diameter == Some(true) {
            to /= 2;
        }
        if to == from {
            return Err(Fault::new("a tap without a depth"));
        }
        Ok((axis, from, to))
    }

    /// G33.1: to the depth and back, the spindle turning before.
    fn tap_returns(&mut self, block: &mut Block) -> Result<(), Fault> {
        let (axis, from, to) = self.tap_axis(block)?;
        let lead = block.take(b'K').ok_or_else(|| Fault::new("a tap without a lead"))?;
        if lead <= 0 {
            return Err(Fault::new("the lead K of a tap is not above zero: M3 or M4 before it says its hand"));
        }
        let lead = self.length(lead)?;
        let factor = block.take(b'I').unwrap_or(SCALE);
        let turn = self.spindle.turn.ok_or_else(|| Fault::new("the spindle does not turn before a tap"))?;
        if self.spindle.speed == Some(0) {
            return Err(Fault::new("a tap at a speed of 0"));
        }
        if factor <= 0 {
            return Err(Fault::new("a factor of the way back that is not above zero"));
        }
        let left = turn == TURNS[1];
        self.push_tap(Tap { axis, from, to, back: from, lead, left, factor, way: Way::Both, ..self.bare_tap() })?;
        // It is no mode: axes by themselves mean nothing behind it.
        self.modes.motion = None;
        Ok(())
    }

    /// G84 and its like: down from R and back to it.
    fn tap_cycle(&mut self, block: &mut Block, left: bool) -> Result<(), Fault> {
        if !self.modes.cycles_are_off {
            return if block.motion.is_none() && self.rules.taps == Taps::Announced {
                self.tap_goes_on(block)
            } else {
                Err(Fault::new("a tapping cycle while another one is on"))
            };
        }
        if self.rules.taps == Taps::Announced && !std::mem::take(&mut self.spindle.is_ready) {
            return Err(Fault::new("a tapping cycle without M29 needs a compensating chuck"));
        }
        for (axis, letter) in LETTERS.iter().enumerate().take(2) {
            let Some(number) = block.take(*letter) else { continue };
            if self.place(axis) != Some(self.length(number)?) {
                return Err(Fault::new("a tapping cycle at another place than where the tool stands"));
            }
        }
        let (axis, from, to) = self.tap_axis(block)?;
        let level = block.take(b'R').ok_or_else(|| Fault::new("a tapping cycle without R"))?;
        let level = self.length(level)?;
        let from_start = !matches!(self.rules.words, Words::FanucMill);
        if axis != 2 || (if from_start { level != 0 } else { level != from }) || to > from {
            return Err(Fault::new("a tapping cycle that does not begin where the tool stands"));
        }
        let lead = self.lead_of_cycle()?;
        let by_letter = self.rules.taps == Taps::Announced;
        let dwell = if by_letter { block.take(b'P').unwrap_or(0) } else { 0 };
        let factor = if self.rules.taps == Taps::Plain { block.take(b'J').unwrap_or(SCALE) } else { SCALE };
        let dwell = self.rules.seconds(dwell).ok_or_else(|| Fault::new("a wait in parts of a millisecond"))?;
        self.push_tap(Tap {
            axis,
            from,
            to,
            back: from,
            lead,
            left,
            factor,
            dwell,
            way: Way::Both,
            ..self.bare_tap()
        })?;
        self.modes.cycles_are_off = false;
        // The control stops the spindle.
        self.spindle.turn = None;
        Ok(())
    }

    /// A depth alone while the cycle is on: the same hole, from where it began.
    fn tap_goes_on(&mut self, block: &mut Block) -> Result<(), Fault> {
        let (axis, from, to) = self.tap_axis(block)?;
        let last = self.tap;
        if axis != last.axis || from != last.back || to > from || block.has(b'R') || block.has(b'P') {
            return Err(Fault::new("a tapping cycle goes on elsewhere"));
        }
        let lead = self.lead_of_cycle()?;
        self.push_tap(Tap { from, to, lead, speed: self.spindle.speed, ..last })
    }

    /// What F and S make the pitch of a cycle.
    fn lead_of_cycle(&self) -> Result<i64, Fault> {
        let speed = self.spindle.speed.filter(|speed| *speed > 0);
        let speed = speed.ok_or_else(|| Fault::new("a tapping cycle without a speed"))?;
        let feed = self.feed.filter(|feed| *feed > 0).ok_or_else(|| Fault::new("a tapping cycle without F"))?;
        match (self.rules.taps, self.modes.feed_kind) {
            (Taps::Announced | Taps::Plain, Some(FeedKind::PerMinute)) => {
                Ok((i128::from(feed) * i128::from(SCALE) / i128::from(speed)) as i64)
            }
            (Taps::Announced | Taps::ByPitch, Some(FeedKind::PerRevolution)) => Ok(feed),
            _ => Err(Fault::new("what F of this tapping cycle is, nobody knows")),
        }
    }

    /// G331 in and G332 out, the spindle an axis.
    fn tap_one_way(&mut self, block: &mut Block, into: bool) -> Result<(), Fault> {
        if !self.spindle.is_axis {
            return Err(Fault::new("a tap while the spindle is no axis"));
        }
        let (axis, from, to) = self.tap_axis(block)?;
        let lead = block.take(b"IJK"[axis]).filter(|lead| *lead != 0);
        let lead = self.length(lead.ok_or_else(|| Fault::new("a tap without a lead"))?)?;
        let way = if into { Way::In } else { Way::Out };
        let (left, lead) = (lead < 0, lead.abs());
        self.push_tap(Tap { axis, from, to, back: to, lead, left, way, ..self.bare_tap() })
    }

    pub(super) fn bare_tap(&self) -> Tap {
        Tap { speed: self.spindle.speed, ..Tap::default() }
    }

    pub(super) fn push_tap(&mut self, tap: Tap) -> Result<(), Fault> {
        debug_assert!(tap.axis < AXES);
        self.stand(tap.axis, tap.back);
        self.tap = tap;
        self.spindle.tapped = true;
        self.push(Act::Tap)
    }
}
