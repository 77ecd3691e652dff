//! The printer core: modal words, one concern a line, arcs on the printed numbers. All words are the target's.

mod carried;
mod corners;
mod dialog;
mod dialog_taps;
#[cfg(test)]
pub mod disturb;
mod functions;
mod grid;
mod head;
mod keys;
mod measures;
mod moves;
mod path_control;
mod refusals;
mod straight;
mod taps;
mod tilt;
mod told_plane;
pub(crate) mod winding;

use std::io;

use crate::diag::{Answer, Diags, Fault, codes};
use crate::geo::Plane;
use crate::ir::function::{CutterData, Turn};
use crate::ir::motion::{Move, Path, Place, Sink};
use crate::ir::{Function, Origin, Pos, Side, Tap};
use crate::machine::axis::AXES;
use crate::machine::settings::Machine;
use crate::machine::{Axis, AxisSet, MachineKind, OutputSettings, Settings, Tools};
use crate::target::{CompensationWords, Form, Target};
use crate::text::Loc;

use super::compensation::{Compensation, Preparation, Way};
use super::line_writer::LineWriter;
use super::modal::{FeedKind, Modal};
use super::number::Places;
use super::{LineMap, Output};
use corners::Corners;
use measures::Measures;
use winding::{LEAST, Winding};

/// Prints motion items for one target.
pub struct Printer<'a> {
    target: &'static Target,
    settings: &'a OutputSettings,
    tools: &'a Tools,
    /// X words are diameters.
    diameter: bool,
    /// Places of the coordinates of each axis.
    by_axis: [Places; AXES],
    places: Places,
    measures: Measures,
    diags: &'a Diags,
    lines: LineWriter<'a>,
    /// Where the hash of the source stands in the output.
    hash_at: u64,
    modal: Modal,
    /// Axes that the target has, and those whose lack was reported.
    axes: AxisSet,
    compensation: Compensation,
    corners: Corners,
    spindle: HandChange,
    length: ToolLength,
    /// Where the last thread ended, and behind how many lines.
    thread: Option<([i64; AXES], u64)>,
    /// A straight move needs a closer look: inches, all words in each block, another form.
    special: bool,
    /// Name of the main program as comments have it.
    source: String,
    /// The last line of the frame.
    last: Option<String>,
    ended: bool,
    /// That work offsets are not confirmed was said.
    doubted: bool,
    /// What the spindle and the coolant do, where a speed stands with the start, and no word ends both with the program.
    running: Running,
    /// What the target was told of its spindle.
    stated: SpindleStated,
    machine: &'a Machine,
    tilting: told_plane::ToldPlane,
}

/// The spindle, as far as a tool change by hand stops it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum HandChange {
    /// The program stopped it, or did not start it yet.
    Stands,
    Turns,
    /// It turned until this change.
    Stopped(Loc),
}

/// What was said of spindle and coolant.
#[derive(Debug, Clone, Copy, Default)]
struct Running {
    speed: Option<i64>,
    turn: Option<Turn>,
    coolant: bool,
}

/// The length of the tool, where the target takes it with a move along Z.
#[derive(Debug, Clone, Copy, Default)]
struct ToolLength {
    tool: u32,
    /// The next such move states it.
    waits: bool,
    /// One was stated by such a move, and not ended since.
    counts: bool,
    /// The largest speed under constant cutting speed was stated.
    limited: bool,
}

/// What the target was told of the spindle.
#[derive(Debug, Clone, Copy, Default)]
struct SpindleStated {
    /// In units of the last place.
    speed: Option<i64>,
    turn: Option<Turn>,
    /// A tap said that speed, and nothing of the spindle was said since.
    by_tap: bool,
}

impl std::fmt::Debug for Printer<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Printer").field("modal", &self.modal).finish_non_exhaustive()
    }
}

impl<'a> Printer<'a> {
    /// A printer that has printed the head. `source` is the name of the main program.
    pub fn new(
        settings: &'a Settings,
        source: &str,
        diags: &'a Diags,
        out: &'a mut dyn Output,
        map: Option<&'a mut dyn LineMap>,
    ) -> Printer<'a> {
        let target = settings.output.target;
        let lathe = settings.machine.kind == MachineKind::Lathe;
        let step = settings.output.line_numbers;
        let lines =
            LineWriter::new(target.line, step, target.feed.address, settings.limits.output_blocks, diags, out, map);
        let (places, measures) = Measures::of(&settings.output);
        let mut printer = Printer {
            target,
            settings: &settings.output,
            tools: &settings.tools,
            diameter: false,
            by_axis: [places; AXES],
            places,
            measures,
            diags,
            lines,
            hash_at: 0,
            modal: Modal::new(if lathe { Plane::Zx } else { Plane::Xy }),
            axes: target.axes.bytes().filter_map(Axis::of).collect(),
            compensation: Compensation::default(),
            corners: Corners::default(),
            spindle: HandChange::Stands,
            length: ToolLength::default(),
            special: !settings.output.modal
                || measures.inches
                || target.motion.rapid_at_feed
                || matches!(target.form, Form::Dialog(_)),
            thread: None,
            source: String::new(),
            last: target.frame.last.map(str::to_owned),
            ended: false,
            doubted: false,
            running: Running::default(),
            stated: SpindleStated::default(),
            machine: &settings.machine,
            tilting: told_plane::ToldPlane::default(),
        };
        // G96 outlives the program that programmed it: the first speed of a lathe says G97.
        printer.modal.cutting_speed = lathe;
        printer.set_places(places, lathe && settings.output.prints_diameters());
        printer.head(source, lathe);
        #[cfg(test)]
        if source.ends_with(disturb::DISTURBED) {
            printer.disturb(disturb::Disturbance::Decimals(0));
        }
        printer
    }

    /// From here on text stays until [`Printer::release`], so that somebody can read what an item became.
    pub fn hold(&mut self) {
        self.lines.hold();
    }

    /// What was printed since the last release: bytes, of which so many count. What stands behind them means nothing.
    #[inline]
    pub fn held(&self) -> (&[u8], usize) {
        self.lines.held()
    }

    /// What was printed so far may be written.
    #[inline]
    pub fn release(&mut self) {
        self.lines.release();
    }

    /// Prints what stands behind the last item.
    pub fn close(&mut self) {
        if !std::mem::replace(&mut self.ended, true) {
            self.template(&self.settings.footer);
            match self.target.flow.end {
                Some(end) => self.lines.block(end.as_bytes()),
                // Only a run that broke off has no end of its own.
                None => self.end(None, &Origin { loc: Loc { line: 1, ..Loc::default() }, ..Origin::default() }),
            }
        }
        if let Some(last) = self.last.take() {
            self.lines.plain(last.as_bytes());
        }
    }

    /// Ends the text: closing frame, hash of the source in the head.
    ///
    /// # Errors
    /// The first error of the output.
    pub fn finish(mut self, hash: u64) -> io::Result<()> {
        self.close();
        let hash = self.hash(hash);
        self.lines.finish(self.hash_at, &hash)
    }

    #[cold]
    fn say(&self, origin: &Origin, fault: Fault) {
        self.diags.push(fault.at(origin.loc).called(origin.call));
    }

    #[inline(always)]
    fn print_move(&mut self, mv: &Move, origin: &Origin) {
        if self.corners.in_doubt() {
            self.tell_of_corners(origin);
        }
        if self.tilting.is_left() && !mv.machine {
            self.lacks_plane(origin);
            return self.pretend(mv);
        }
        if !self.compensation.is_idle(mv.side) && !self.compensate(mv, origin) {
            return;
        }
        if let HandChange::Stopped(change) = self.spindle
            && !matches!(mv.path, Path::Rapid)
        {
            self.spindle_stands(change, origin);
        }
        let word = match &mv.path {
            Path::Rapid => self.target.motion.rapid,
            Path::Line(_) => self.target.motion.line,
            Path::Carried { feed, length } => return self.carried(*feed, *length, mv, origin),
            Path::Thread { lead } => return self.thread(*lead, mv, origin),
            Path::Arc(arc, feed) => return self.arc(arc, *feed, mv, origin),
        };
        self.straight_block(word, mv, None, origin);
    }

    /// Looks at the compensation in front of a move; false if the move is refused.
    #[cold]
    fn compensate(&mut self, mv: &Move, origin: &Origin) -> bool {
        let way = Way {
            in_plane: self.changes_plane(mv),
            length: self.way_in_plane(mv),
            radius: self.known_radius(),
            unit: 1.0 / self.places.scale(),
            in_doubt: self.diags.has_errors(),
        };
        let Some(words) = &self.target.compensation else {
            self.lacks_compensation(mv, origin);
            return false;
        };
        match self.compensation.before(mv, origin, self.modal.plane, words.planes, way) {
            Preparation::Nothing if words.with_move && mv.side != Side::None => {
                // Another kind of feed is a block in front of the move.
                let kind = mv.path.feed().map(FeedKind::of);
                let blocks =
                    u64::from(!way.in_plane) + u64::from(kind.is_some_and(|kind| !self.modal.has_feed_kind(kind)));
                if let Some(found) = self.compensation.stands(blocks, origin) {
                    self.diags.push(found);
                    return false;
                }
                if way.in_plane {
                    self.compensation.moves();
                }
            }
            Preparation::Nothing => {}
            Preparation::Switch => {
                self.begins_at_rapid(mv, origin);
                if words.with_move {
                    return self.switches_in_move(words, mv, origin);
                }
                self.switch_side(mv, origin);
            }
            Preparation::Refuse(found) => {
                if let Some(found) = found {
                    self.diags.push(*found);
                }
                return false;
            }
        }
        true
    }

    /// Does an axis of the working plane get another number?
    fn changes_plane(&self, mv: &Move) -> bool {
        let (first, second, _) = mv.plane.axes();
        matches!(mv.path, Path::Arc(..))
            || [first, second].iter().map(|i| Axis::ALL[*i]).filter(|axis| mv.axes.contains(*axis)).any(|axis| {
                let units = mv.end.get(axis).and_then(|value| self.places_of(axis).units(value));
                let place = self.modal.place(axis);
                place.is_none() || units != place
            })
    }

    /// Length of a straight move in its working plane as printed, in mm; `None` where its start was not printed.
    fn way_in_plane(&self, mv: &Move) -> Option<f64> {
        let (first, second, _) = mv.plane.axes();
        let mut way = [0.0; 2];
        for (way, i) in way.iter_mut().zip([first, second]) {
            let axis = Axis::ALL[i];
            let end = mv.end.get(axis).filter(|_| mv.axes.contains(axis));
            let Some(end) = end else { continue };
            let places = self.places_of(axis);
            let (to, from) = places.units(end).zip(self.modal.place(axis))?;
            *way = (to - from) as f64 / places.scale();
        }
        Some(libm::hypot(way[0], way[1]))
    }

    /// Radius of the compensated tool, where anybody told it.
    fn known_radius(&self) -> Option<f64> {
        let CutterData { number, radius, known, .. } = self.compensation.cutter;
        radius.or(known).or_else(|| self.tools.radius_of_printed(number))
    }

    fn switch_side(&mut self, mv: &Move, origin: &Origin) {
        if mv.side == Side::None {
            return self.end_compensation(origin);
        }
        let Some(words) = &self.target.compensation else { return };
        self.select_plane(mv.plane, origin);
        let cutter = self.compensation.cutter;
        match (words.by_diameter, words.tool, cutter.radius) {
            (Some([left, right]), Some(address), Some(radius)) => {
                let units = self.places.units(2.0 * radius).unwrap_or(0);
                let word = if mv.side == Side::Left { left } else { right };
                self.lines.text.word(word).number(address, units, self.places);
                if let Some(edge) = &words.edge
                    && cutter.edge != [0, 0]
                {
                    self.lines.text.whole(edge.address, u64::from(edge.number(cutter.edge)));
                }
            }
            _ => {
                self.compensation.side = mv.side;
                self.side_words();
            }
        }
        self.lines.end_line(origin);
        self.compensation.switched(mv.side);
    }

    /// The words of the side, and of the tool whose radius counts.
    pub(super) fn side_words(&mut self) {
        self.compensation.waits = false;
        let Some(words) = &self.target.compensation else { return };
        let (word, number) = match self.compensation.side {
            Side::None => (words.off, None),
            Side::Left => (words.left, words.tool),
            Side::Right => (words.right, words.tool),
        };
        self.lines.text.word(word);
        if let Some(address) = number {
            self.lines.text.whole(address, u64::from(self.compensation.cutter.number));
        }
    }

    /// The side changes in this straight move; false if the target cannot say so.
    #[cold]
    fn switches_in_move(&mut self, words: &CompensationWords, mv: &Move, origin: &Origin) -> bool {
        let CutterData { number, radius, .. } = self.compensation.cutter;
        let begins = mv.side != Side::None;
        let of_length = words.tool.is_none() && self.length.tool != number;
        if matches!(mv.path, Path::Carried { .. }) {
            self.deny(
                origin,
                codes::O9003::target_has_no_word_for_radius_compensation(&self.target.name)
                    .answer(Answer::key("output", "compensation")),
            );
            self.pretend(mv);
            return false;
        }
        if begins && (radius.is_some() || number == 0 || of_length) {
            self.lacks_radius(radius.is_some(), of_length, mv, origin);
            return false;
        }
        if let Some(letter) = words.tool.filter(|_| begins)
            && !self.has_offset(number, letter, origin)
        {
            self.compensation.refuse_contour();
            return false;
        }
        if self.length.waits && mv.axes.contains(Axis::Z) {
            self.lacks_form(mv, origin);
            return false;
        }
        self.select_plane(mv.plane, origin);
        self.compensation.moves();
        self.compensation.switched(mv.side);
        self.compensation.waits = true;
        true
    }

    /// A function became so many blocks of the compensated contour.
    #[cold]
    fn stands_in_contour(&mut self, words: &CompensationWords, function: &Function, blocks: u64, origin: &Origin) {
        let stops = matches!(function, Function::Stop | Function::OptionalStop);
        let found = match (stops && !words.reads_over_stops, words.with_move) {
            (true, _) => self.compensation.stops(self.target.name, origin),
            (false, true) => self.compensation.stands(blocks, origin),
            (false, false) => None,
        };
        if let Some(found) = found {
            self.diags.push(found);
        }
    }

    fn end_compensation(&mut self, origin: &Origin) {
        if self.target.compensation.as_ref().is_some_and(|words| words.with_move) {
            return self.lacks_end_of_compensation(origin);
        }
        if let Some(words) = &self.target.compensation {
            self.lines.words(words.off, origin);
        }
        self.compensation.switched(Side::None);
    }

    /// The pieces of a move whose text may be long; none where it is one block, or does not start at a known place.
    #[cold]
    pub(crate) fn winding(&self, mv: &Move) -> Option<Winding> {
        let Path::Arc(arc, feed) = mv.path else { return None };
        if self.target.arcs.turns.is_some() || arc.sweep.abs() < LEAST {
            return None;
        }
        let mut start = [0.0; AXES];
        for axis in mv.axes.iter() {
            start[axis.index()] = self.modal.place(axis)? as f64 / self.places_of(axis).scale();
        }
        Some(Winding::new(mv, arc, feed, start))
    }

    fn select_plane(&mut self, plane: Plane, origin: &Origin) {
        if plane != self.modal.plane {
            self.modal.plane = plane;
            if let Some(word) = self.target.motion.plane(plane) {
                self.lines.words(word, origin);
            }
        }
    }
}

impl Sink for Printer<'_> {
    fn movement(&mut self, mv: &Move, origin: &Origin) {
        if matches!(&mv.path, Path::Arc(arc, _) if arc.sweep.abs() >= LEAST)
            && let Some(winding) = self.winding(mv)
        {
            return winding.pieces().for_each(|piece| self.movement(&piece, origin));
        }
        if !self.lines.full() {
            self.print_move(mv, origin);
        }
    }

    fn tap(&mut self, tap: &Tap, place: &Place, origin: &Origin) {
        if self.tilting.is_left() {
            self.lacks_plane(origin);
        } else if !self.lines.full() {
            self.print_tap(tap, place, origin);
        }
    }

    fn function(&mut self, function: &Function, origin: &Origin) {
        if self.lines.full() {
            return;
        }
        let before = self.lines.lines();
        self.print_function(function, origin);
        if self.compensation.side != Side::None
            && let Some(words) = &self.target.compensation
        {
            self.stands_in_contour(words, function, self.lines.lines() - before, origin);
        }
    }

    fn lost(&mut self, _: &Origin) {
        self.modal.forget_all();
    }

    fn begins_at(&mut self, at: &Pos) {
        for (axis, value) in at.iter() {
            if let Some(units) = self.places_of(axis).units(value) {
                // The target has not heard of it.
                self.modal.begins(axis, units);
            }
        }
    }

    fn full(&self) -> bool {
        self.lines.full()
    }
}
