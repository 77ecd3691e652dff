//! Straight moves: where they end, how fast, on which side.

use crate::geo::tolerance;
use crate::ir::motion::{Move, Path};
use crate::ir::{Feed, Side};
use crate::read::{self, AXES, Act, FeedKind, SCALE};

use super::{Text, Validator, Why, is_rounding, plane};

/// The bit of Z.
const ALONG_Z: u16 = 0b100;

impl Validator {
    /// Is the text what this move asks for?
    #[inline(always)]
    pub(super) fn check_move(&mut self, mv: &Move, text: Text<'_>) -> Result<(), Why> {
        if self.in_full {
            self.before = *self.reader.at();
        }
        if !mv.machine {
            self.is_in_plane()?;
        }
        if matches!(mv.path, Path::Arc(..) | Path::Thread { .. } | Path::Carried { .. }) {
            return self.check_other(mv, text);
        }
        if text.end == 0 {
            return self.stays(mv);
        }
        match self.reader.straight(text.bytes, text.end) {
            Some(found) if found.len == text.end => self.is_line(mv, found),
            Some(found) => {
                let rest = Text { bytes: &text.bytes[found.len..], end: text.end - found.len };
                self.is_line(mv, found)?;
                self.no_act(rest)
            }
            None => self.check_by_words(mv, text),
        }
    }

    /// A line that says nothing but its axes and the feed.
    #[inline(always)]
    fn is_line(&mut self, mv: &Move, found: read::Straight) -> Result<(), Why> {
        match mv.path {
            Path::Line(feed) if found.cuts => self.same_feed(feed)?,
            Path::Rapid if !found.cuts => {}
            Path::Rapid | Path::Line(_) | Path::Arc(..) | Path::Carried { .. } | Path::Thread { .. } => {
                return Err(Why::new("another kind of move is meant"));
            }
        }
        if mv.machine {
            return Err(Why::new("machine and workpiece coordinates are mixed up"));
        }
        if self.length.is_some() {
            self.states_length(false, found.axes)?;
        }
        self.leads(mv, found.axes)?;
        self.same_side(mv)
    }

    /// A straight move in any other words.
    #[inline(never)]
    fn check_by_words(&mut self, mv: &Move, text: Text<'_>) -> Result<(), Why> {
        let Text { bytes: mut rest, mut end } = text;
        let Some(mut act) = self.reader.next(&mut rest, &mut end)? else { return self.stays(mv) };
        if act == Act::Tilt(read::Tilting::Off) {
            self.leaves_plane(mv.machine)?;
            act = self.reader.next(&mut rest, &mut end)?.ok_or_else(|| Why::new("a move is meant"))?;
        }
        let Act::Move(found) = act else { return Err(Why::new("a move is meant")) };
        match (found.path, mv.path) {
            (read::Path::Rapid, Path::Rapid) => {}
            (read::Path::Line, Path::Line(feed)) => self.same_feed(feed)?,
            _ => return Err(Why::new("another kind of move is meant")),
        }
        self.reaches(mv, &found)?;
        self.no_act(Text { bytes: rest, end })
    }

    #[inline(never)]
    fn check_other(&mut self, mv: &Move, text: Text<'_>) -> Result<(), Why> {
        match &mv.path {
            Path::Arc(arc, feed) => self.check_arc(mv, arc, *feed, text),
            Path::Thread { lead } => self.check_thread(mv, *lead, text),
            Path::Carried { feed, length } => self.check_carried(mv, *feed, *length, text),
            Path::Rapid | Path::Line(_) => unreachable!("straight moves are looked at in place"),
        }
    }

    /// The move ends where it is meant to, and goes as it is meant to.
    fn reaches(&mut self, mv: &Move, found: &read::Move) -> Result<(), Why> {
        if found.machine != mv.machine {
            return Err(Why::new("machine and workpiece coordinates are mixed up"));
        }
        self.leads(mv, found.axes)?;
        if self.length.is_some() {
            self.states_length(found.machine, found.axes)?;
        }
        if mv.machine {
            if found.axes != mv.axes.bits() {
                return Err(Why::new("a move in machine coordinates names other axes"));
            }
            // Nobody knows where they stand in the workpiece.
            self.stated &= !found.axes;
        }
        self.same_side(mv)
    }

    /// The first move along Z behind a change states the length of its tool.
    #[cold]
    fn states_length(&mut self, machine: bool, axes: u16) -> Result<(), Why> {
        if machine || axes & ALONG_Z == 0 {
            return Ok(());
        }
        let stated = self.reader.modes().length == self.length.take();
        if stated { Ok(()) } else { Err(Why::new("the length of another tool counts")) }
    }

    /// Axes that a move prints although they stand.
    #[inline(always)]
    pub(super) fn strays(&self, printed: u16, mv: &Move) -> bool {
        let strange = printed & !mv.axes.bits();
        strange != 0 && !(self.in_full && self.stand_still(strange))
    }

    #[cold]
    fn stand_still(&self, axes: u16) -> bool {
        axes & !self.stated == 0 && (0..AXES).all(|i| axes & (1 << i) == 0 || self.before[i] == self.reader.at()[i])
    }

    /// Every axis of the move stands where it is meant to; those not in `printed` since before.
    #[inline(always)]
    pub(super) fn leads(&mut self, mv: &Move, printed: u16) -> Result<(), Why> {
        if self.strays(printed, mv) {
            return Err(Why::new("an axis moves that shall stand"));
        }
        self.stated |= printed;
        let silent = mv.axes.bits() & !printed;
        if silent & !(self.stated & self.reader.known()) != 0 {
            return Err(Why::new("an axis is not printed, and where it stands is not certain"));
        }
        let looked_at = mv.axes.common(mv.end.known()).bits();
        // Most moves name main axes only.
        for axis in 0..3 {
            if looked_at & (1 << axis) != 0 && !self.stands(mv, axis) {
                return Err(Why::new("an axis ends elsewhere"));
            }
        }
        for axis in 3..AXES {
            if looked_at >> axis == 0 {
                break;
            }
            if looked_at & (1 << axis) != 0 && !self.stands(mv, axis) {
                return Err(Why::new("an axis ends elsewhere"));
            }
        }
        Ok(())
    }

    /// Does an axis stand where the move ends?
    #[inline(always)]
    fn stands(&self, mv: &Move, axis: usize) -> bool {
        let half = match axis {
            0 => self.half_of_x,
            3..6 => self.grain.angle,
            _ => self.half,
        };
        is_rounding(self.reader.at()[axis], mv.end.values()[axis], half)
    }

    /// Nothing is printed for a move that leads where the machine stands.
    #[inline(never)]
    fn stays(&mut self, mv: &Move) -> Result<(), Why> {
        if mv.machine {
            return Err(Why::new("a move is missing"));
        }
        self.leads(mv, 0).map_err(|_| Why::new("a move is missing"))
    }

    #[inline(always)]
    pub(super) fn same_side(&self, mv: &Move) -> Result<(), Why> {
        let side = self.reader.modes().cutter.map_or(0, |cutter| cutter.side);
        if mv.side == Side::None && side == 0 { Ok(()) } else { self.same_cutter(mv) }
    }

    /// The compensation of a move.
    #[cold]
    fn same_cutter(&self, mv: &Move) -> Result<(), Why> {
        let modes = self.reader.modes();
        let cutter = modes.cutter.unwrap_or_default();
        let side = match mv.side {
            Side::None => 0,
            Side::Left => 1,
            Side::Right => -1,
        };
        if cutter.side != side {
            return Err(Why::new("the tool is on another side"));
        }
        let same = match (self.cutter.radius, cutter.diameter) {
            (Some(radius), Some(diameter)) => {
                self.is_rounding(diameter, 2.0 * radius) && cutter.edge == self.cutter.edge
            }
            (None, None) => cutter.tool == self.cutter.number,
            _ => false,
        };
        if !same {
            return Err(Why::new("another tool radius is compensated"));
        }
        if modes.plane == Some(plane(mv.plane)) {
            Ok(())
        } else {
            Err(Why::new("the radius is compensated in another plane"))
        }
    }

    /// The feed that holds is the one that is meant.
    #[inline(always)]
    pub(super) fn same_feed(&mut self, meant: Feed) -> Result<(), Why> {
        let Some(read) = self.reader.feed() else { return Err(Why::new("there is no feed")) };
        if self.reader.modes().feed_kind != Some(kind(meant)) {
            return Err(Why::new("the feed is of another kind"));
        }
        if self.feed == Some((meant, read)) {
            return Ok(());
        }
        if !is_rounding(read, meant.value(), self.grain.feed(meant)) {
            return Err(Why::new("the feed is another one"));
        }
        self.feed = Some((meant, read));
        Ok(())
    }

    fn check_thread(&mut self, mv: &Move, lead: f64, text: Text<'_>) -> Result<(), Why> {
        let Text { bytes: mut rest, mut end } = text;
        let Some(Act::Move(found)) = self.reader.next(&mut rest, &mut end)? else {
            return Err(Why::new("a thread is missing"));
        };
        let read::Path::Thread(read) = found.path else { return Err(Why::new("a thread is meant")) };
        if !is_rounding(read, lead, self.grain.lead) {
            return Err(Why::new("the thread has another lead"));
        }
        if self.lead_is_feed && self.reader.modes().feed_kind != Some(FeedKind::PerRevolution) {
            return Err(Why::new("the lead of the thread is an F, and no feed per revolution is in force"));
        }
        if self.reader.feed().is_none() {
            self.feed = None;
        }
        self.reaches(mv, &found)?;
        self.no_act(Text { bytes: rest, end })
    }

    /// A part of `length` mm of a contour that is seen in other axes: what counts is the time it takes.
    fn check_carried(&mut self, mv: &Move, feed: f64, length: f64, text: Text<'_>) -> Result<(), Why> {
        let Text { bytes: mut rest, mut end } = text;
        let (mut printed, mut blocks) = (0, 0);
        let mut from = *self.reader.at();
        while let Some(act) = self.reader.next(&mut rest, &mut end)? {
            let Act::Move(found) = act else { return Err(Why::new("a move is meant")) };
            if found.path != read::Path::Line || found.machine || printed & found.axes != 0 {
                return Err(Why::new("another kind of move is meant"));
            }
            let to = *self.reader.at();
            let way = |axes: std::ops::Range<usize>| {
                let off = axes.filter(|axis| found.axes & (1 << axis) != 0).map(|i| (to[i] - from[i]) as f64);
                libm::sqrt(off.map(|off| off * off).sum::<f64>()) / SCALE as f64
            };
            let (linear, rotary) = (libm::hypot(way(0..3), way(6..9)), way(3..6));
            let meant = match (linear > 0.0, rotary > 0.0) {
                (_, false) => feed,
                (false, true) => feed * rotary / length,
                (true, true) => feed * linear / length,
            };
            // Where it is split, the linear part is too short to matter.
            blocks += 1;
            if blocks == 2 && linear > tolerance::STEP_ASIDE.max(self.unit / SCALE as f64) + tolerance::LOST {
                return Err(Why::new("a way is split that is too long for that"));
            }
            let read = self.reader.feed().ok_or_else(|| Why::new("there is no feed"))?;
            let near = (read as f64 - meant * SCALE as f64).abs()
                <= self.grain.feed + 1.1 + meant * SCALE as f64 * tolerance::LOST;
            if !near || self.reader.modes().feed_kind != Some(FeedKind::PerMinute) {
                return Err(Why::new("the contour is made at another feed"));
            }
            printed |= found.axes;
            from = to;
        }
        self.feed = None;
        self.leads(mv, printed)?;
        self.same_side(mv)
    }

    /// Nothing that happens stands in the text.
    pub(super) fn no_act(&mut self, text: Text<'_>) -> Result<(), Why> {
        let Text { bytes: mut rest, mut end } = text;
        match self.reader.next(&mut rest, &mut end)? {
            None => Ok(()),
            Some(_) => Err(Why::new("something happens that is not meant")),
        }
    }
}

pub(super) fn kind(feed: Feed) -> FeedKind {
    match feed {
        Feed::PerMinute(_) => FeedKind::PerMinute,
        Feed::PerRevolution(_) => FeedKind::PerRevolution,
        Feed::InverseTime(_) => FeedKind::InverseTime,
    }
}
