//! The printer core: modal words, one concern a line, arcs on the printed numbers.

mod functions;

use std::io;

use crate::diag::{Code, Diagnostic, Diags, codes};
use crate::geo::{Plane, Point2, turned};
use crate::ir::function::CutterData;
use crate::ir::motion::{Arc, Move, Path, Sink};
use crate::ir::{Feed, Function, Origin, Pos, Side};
use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisSet, MachineKind, OutputSettings, Settings, Tools};
use crate::text::Loc;

use super::arc::{self, Printed};
use super::compensation::{Before, Compensation, Way};
use super::line::Text;
use super::number::Places;
use super::targets::Traits;
use super::{LineMap, Output, comment};

/// Bytes collected before they are written.
const CHUNK: usize = 1 << 20;
/// The first piece is smaller: who waits for the output sees it sooner.
const FIRST_CHUNK: usize = 1 << 14;
/// Digits of the hash in the head.
const HASH_DIGITS: usize = 16;
/// Most lines that replace an arc.
const MOST_CHORDS: f64 = 10_000.0;

/// Prints motion items for one target.
pub struct Printer<'a> {
    traits: &'static Traits,
    settings: &'a OutputSettings,
    tools: &'a Tools,
    /// X words are diameters.
    diameter: bool,
    places: Places,
    diags: &'a Diags,
    out: &'a mut dyn Output,
    map: Option<&'a mut dyn LineMap>,
    text: Text,
    /// Bytes after which the text is written.
    chunk: usize,
    lines: u64,
    most_lines: u64,
    hash_at: u64,
    /// Printed position in units, by axis.
    at: [i64; AXES],
    known: AxisSet,
    /// Axes that are printed again even if they do not change.
    stale: AxisSet,
    feed: Option<(FeedKind, i64)>,
    /// The feed that was asked for last, which `feed` is printed for.
    asked: Option<Feed>,
    feed_kind: FeedKind,
    /// Constant cutting speed is on.
    constant_cut: bool,
    plane: Plane,
    compensation: Compensation,
    /// Lead of the thread that is being printed.
    thread_lead: Option<i64>,
    /// The limit of lines is passed: what follows is not printed.
    full: bool,
    error: Option<io::Error>,
    ended: bool,
}

impl std::fmt::Debug for Printer<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Printer").field("lines", &self.lines).finish_non_exhaustive()
    }
}

impl<'a> Printer<'a> {
    /// A printer that has printed the head. `source` is the name of the main program.
    pub fn new(
        traits: &'static Traits,
        settings: &'a Settings,
        source: &str,
        diags: &'a Diags,
        out: &'a mut dyn Output,
        map: Option<&'a mut dyn LineMap>,
    ) -> Printer<'a> {
        let lathe = settings.machine.kind == MachineKind::Lathe;
        let mut printer = Printer {
            traits,
            settings: &settings.output,
            tools: &settings.tools,
            diameter: lathe && settings.output.diameter,
            places: Places::new(settings.output.decimals),
            diags,
            out,
            map,
            text: Text::with_capacity(CHUNK + 4096),
            chunk: FIRST_CHUNK,
            lines: 0,
            most_lines: settings.limits.output_blocks,
            hash_at: 0,
            at: [0; AXES],
            known: AxisSet::EMPTY,
            stale: AxisSet::EMPTY,
            feed: None,
            asked: None,
            feed_kind: FeedKind::PerMinute,
            constant_cut: false,
            plane: if lathe { Plane::Zx } else { Plane::Xy },
            compensation: Compensation::default(),
            thread_lead: None,
            full: false,
            error: None,
            ended: false,
        };
        printer.head(source, lathe);
        printer
    }

    fn head(&mut self, source: &str, lathe: bool) {
        let (open, close) = self.traits.comment;
        self.plain(self.traits.frame.as_bytes());
        let title = format!("{open}partc {}, target {}{close}", env!("CARGO_PKG_VERSION"), self.traits.name);
        self.plain(title.as_bytes());
        let source = source.rsplit(['/', '\\']).next().unwrap_or(source);
        let mut name = comment::harmless(source.as_bytes());
        name.truncate(40);
        let mut text = format!("{open}source {}, hash ", String::from_utf8_lossy(&name)).into_bytes();
        self.hash_at = self.text.bytes().len() as u64 + text.len() as u64;
        text.extend_from_slice(&[b'0'; HASH_DIGITS]);
        text.extend_from_slice(close.as_bytes());
        self.plain(&text);
        let (last, lines) = self.traits.head.split_last().unwrap_or((&"", &[]));
        for line in lines {
            self.plain(line.as_bytes());
        }
        let last = if lathe { self.traits.lathe_head[usize::from(self.diameter)] } else { last };
        self.plain(last.as_bytes());
    }

    /// Ends the text: closing frame, hash of the source in the head.
    ///
    /// # Errors
    /// The first error of the output.
    pub fn finish(mut self, hash: u64) -> io::Result<()> {
        if !self.ended {
            self.plain(b"M2");
        }
        self.plain(self.traits.frame.as_bytes());
        self.write_out();
        if let Some(error) = self.error {
            return Err(error);
        }
        self.out.patch(self.hash_at, format!("{hash:016x}").as_bytes())
    }

    fn write_out(&mut self) {
        if self.error.is_none()
            && let Err(error) = self.out.append(self.text.bytes())
        {
            self.error = Some(error);
        }
        self.chunk = CHUNK;
        self.text.clear();
    }

    /// A line without a source.
    fn plain(&mut self, text: &[u8]) {
        self.text.raw(text).end_line();
        self.lines += 1;
        if self.lines > self.most_lines {
            let start = Loc { line: 1, ..Loc::default() };
            self.too_many(&Origin { loc: start, ..Origin::default() });
        }
    }

    /// Ends the line under construction.
    #[inline]
    fn end_line(&mut self, origin: &Origin) {
        if self.text.line().len() > self.traits.line_length {
            self.split_feed(origin);
        }
        self.count_line(origin);
        if self.text.bytes().len() >= self.chunk {
            self.write_out();
        }
    }

    #[inline]
    fn count_line(&mut self, origin: &Origin) {
        self.text.end_line();
        self.lines += 1;
        if let Some(map) = &mut self.map {
            map.line(self.lines, origin);
        }
        if self.lines > self.most_lines {
            self.too_many(origin);
        }
    }

    #[cold]
    fn too_many(&mut self, origin: &Origin) {
        if !std::mem::replace(&mut self.full, true) {
            let message = format!("the output has more than {} lines, head and end included", self.most_lines);
            let found = Diagnostic::new(codes::P4002, origin.loc, message).called(origin.call);
            self.diags.push(found.help("look for a loop that does not end, or raise `[limits] output_blocks`"));
        }
    }

    /// A line that is too long gives its feed word to a line in front of it.
    #[cold]
    fn split_feed(&mut self, origin: &Origin) {
        let line = self.text.line().to_vec();
        if let Some(at) = line.windows(2).rposition(|pair| pair == b" F") {
            self.text.drop_line();
            self.text.raw(&line[at + 1..]);
            self.count_line(origin);
            self.text.raw(&line[..at]);
        }
    }

    fn words(&mut self, words: &[u8], origin: &Origin) {
        self.text.word(words);
        self.end_line(origin);
    }

    #[cold]
    fn report(&self, code: &'static Code, origin: &Origin, message: &str) {
        self.diags.push(Diagnostic::new(code, origin.loc, message).called(origin.call));
    }

    // Moves.

    fn print_move(&mut self, mv: &Move, origin: &Origin) {
        if !self.compensation.is_idle(mv.side) {
            let way =
                Way { in_plane: self.changes_plane(mv), length: self.way_in_plane(mv), radius: self.known_radius() };
            match self.compensation.before(mv, origin, self.plane, self.traits.compensation_planes, way) {
                Before::Nothing => {}
                Before::Switch => self.switch_side(mv, origin),
                Before::Refuse(found) => {
                    if let Some(found) = found {
                        self.diags.push(*found);
                    }
                    return;
                }
            }
        }
        match &mv.path {
            Path::Rapid => self.straight(b"G0", mv, origin),
            Path::Line(_) => self.straight(b"G1", mv, origin),
            Path::Thread { lead } => self.thread(*lead, mv, origin),
            Path::Arc(arc, feed) => self.arc(arc, *feed, mv, origin),
        }
    }

    /// Does an axis of the working plane get another number?
    fn changes_plane(&self, mv: &Move) -> bool {
        let (first, second, _) = mv.plane.axes();
        matches!(mv.path, Path::Arc(..))
            || [first, second].iter().map(|i| Axis::ALL[*i]).filter(|axis| mv.axes.contains(*axis)).any(|axis| {
                let units = mv.end.get(axis).and_then(|value| self.places.units(value));
                !self.known.contains(axis) || units != Some(self.at[axis.index()])
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
            let to = self.places.units(end).filter(|_| self.known.contains(axis))?;
            *way = (to - self.at[i]) as f64 / self.places.scale();
        }
        Some(libm::hypot(way[0], way[1]))
    }

    /// Radius of the compensated tool, where anybody told it.
    fn known_radius(&self) -> Option<f64> {
        let CutterData { number, radius, known } = self.compensation.cutter;
        radius.or(known).or_else(|| self.tools.radius_of_printed(number))
    }

    fn switch_side(&mut self, mv: &Move, origin: &Origin) {
        if mv.side == Side::None {
            return self.end_compensation(origin);
        }
        self.select_plane(mv.plane, origin);
        let cutter = self.compensation.cutter;
        let word: &[u8] = match (mv.side, cutter.radius) {
            (Side::Left, None) => b"G41",
            (Side::Left, Some(_)) => b"G41.1",
            (_, None) => b"G42",
            (_, Some(_)) => b"G42.1",
        };
        self.text.word(word);
        match cutter.radius {
            None => {
                self.text.whole(b'D', u64::from(cutter.number));
            }
            Some(radius) => {
                let units = self.places.units(2.0 * radius).unwrap_or(0);
                self.text.number(b'D', units, self.places);
            }
        }
        self.end_line(origin);
        self.compensation.switched(mv.side);
    }

    fn end_compensation(&mut self, origin: &Origin) {
        self.words(b"G40", origin);
        self.compensation.switched(Side::None);
    }

    fn select_plane(&mut self, plane: Plane, origin: &Origin) {
        if plane != self.plane {
            self.plane = plane;
            self.words(plane_word(plane), origin);
        }
    }

    /// The axes of a straight move that change, or nothing.
    fn straight(&mut self, word: &[u8], mv: &Move, origin: &Origin) {
        let mut ends = [0; AXES];
        let mut changed = AxisSet::EMPTY;
        for axis in mv.axes.iter() {
            let Some(value) = mv.end.get(axis) else { continue };
            let Some(units) = self.places.units(value) else { return self.unprintable(origin) };
            ends[axis.index()] = units;
            let same = self.known.contains(axis) && self.at[axis.index()] == units && !self.stale.contains(axis);
            if !same || mv.machine {
                changed.insert(axis);
            }
        }
        if changed.is_empty() {
            return;
        }
        let feed = match mv.path.feed().map_or(Ok(None), |feed| self.feed_word(feed, origin)) {
            Ok(feed) => feed,
            Err(()) => return,
        };
        if mv.machine {
            self.text.word(b"G53");
        }
        self.text.word(word);
        for axis in changed.iter() {
            self.axis_word(axis, ends[axis.index()]);
        }
        if let Some(units) = self.thread_lead {
            self.text.number(b'K', units, self.places);
        }
        if let Some(units) = feed {
            self.text.number(b'F', units, self.places);
        }
        self.end_line(origin);
        self.compensation.straight();
        if mv.machine {
            self.known = self.known.without(changed);
            return;
        }
        for axis in changed.iter() {
            self.at[axis.index()] = ends[axis.index()];
        }
        self.known = self.known.union(changed);
        self.stale = self.stale.without(changed);
    }

    /// An axis with its coordinate in units.
    #[inline]
    fn axis_word(&mut self, axis: Axis, units: i64) {
        let units = if self.diameter && axis == Axis::X { 2 * units } else { units };
        self.text.number(axis.letter() as u8, units, self.places);
    }

    /// A line in step with the spindle.
    fn thread(&mut self, lead: f64, mv: &Move, origin: &Origin) {
        let lead = self.places.units(lead).filter(|units| *units > 0);
        let Some(lead) = lead else {
            return self.report(codes::O1003, origin, "the lead of this thread prints as zero or not at all");
        };
        let before = self.lines;
        self.thread_lead = Some(lead);
        self.straight(b"G33", mv, origin);
        self.thread_lead = None;
        if self.lines == before && !self.diags.has_errors() {
            self.report(codes::O1003, origin, "the thread has no length that can be printed");
        }
    }

    #[cold]
    fn unprintable(&mut self, origin: &Origin) {
        self.text.drop_line();
        self.report(codes::O1002, origin, "a number of this block is too large to print");
    }

    /// The F word where it changes; a change of its kind gets a line of its own.
    #[inline]
    fn feed_word(&mut self, feed: Feed, origin: &Origin) -> Result<Option<i64>, ()> {
        // Under G93 every line has its own F.
        let timed = matches!(feed, Feed::InverseTime(_));
        if self.asked == Some(feed) && !timed {
            return Ok(None);
        }
        let units = self.places.units(feed.value()).filter(|units| *units > 0);
        let Some(units) = units else {
            self.report(codes::O1001, origin, &format!("the feed {} prints as zero or not at all", feed.value()));
            return Err(());
        };
        let kind = FeedKind::of(feed);
        if kind != self.feed_kind {
            self.feed_kind = kind;
            self.words(kind.word(), origin);
        }
        let new = (kind, units);
        self.asked = Some(feed);
        let known = self.feed.replace(new) == Some(new) && !timed;
        Ok(if known { None } else { Some(units) })
    }

    fn arc(&mut self, arc: &Arc, feed: Feed, mv: &Move, origin: &Origin) {
        let (first, second, third) = arc.plane.axes();
        let scale = self.places.scale();
        let (x, y) = (Axis::ALL[first], Axis::ALL[second]);
        let (Some(to), true) = (mv.end.in_plane(arc.plane), self.known.contains(x) && self.known.contains(y)) else {
            // Only a refused block leaves an arc without a start, and that was reported.
            if !self.diags.has_errors() {
                self.report(codes::O1002, origin, "the start of this arc was not printed");
            }
            return;
        };
        let (Some(to_x), Some(to_y)) = (self.places.units(to.x), self.places.units(to.y)) else {
            return self.unprintable(origin);
        };
        let (Some(_), Some(_)) = (self.places.units(arc.center.x), self.places.units(arc.center.y)) else {
            return self.unprintable(origin);
        };
        let request = arc::Request {
            from: [self.at[first], self.at[second]],
            to: [to_x, to_y],
            center: Point2::new(arc.center.x * scale, arc.center.y * scale),
            sweep: arc.sweep,
            tolerance: self.traits.arc_tolerance,
            least_radius: self.traits.least_radius * scale,
        };
        let (offset, turns) = match arc::fit(&request) {
            Printed::Arc { offset, turns } => (offset, turns),
            Printed::Nothing => {
                self.report(codes::O4002, origin, "the arc is shorter than the last printed digit and is left out");
                let straight = Move { path: Path::Line(feed), ..*mv };
                return self.straight(b"G1", &straight, origin);
            }
            Printed::Lines => return self.chords(arc, feed, mv, origin),
        };
        self.select_plane(arc.plane, origin);
        let Ok(word) = self.feed_word(feed, origin) else { return };
        let mut ends = self.at;
        let mut printed = AxisSet::of(x).union(AxisSet::of(y));
        for axis in mv.axes.without(printed).iter() {
            let Some(units) = mv.end.get(axis).and_then(|value| self.places.units(value)) else {
                return self.unprintable(origin);
            };
            if !self.known.contains(axis) || self.at[axis.index()] != units || self.stale.contains(axis) {
                ends[axis.index()] = units;
                printed.insert(axis);
            }
        }
        (ends[first], ends[second]) = (to_x, to_y);
        let start = self.at;
        let blocks = if self.traits.turns_in_one_block { 1 } else { turns };
        if blocks > 1 && matches!(feed, Feed::InverseTime(_)) {
            return self.report(codes::O1001, origin, "the feed by time cannot be divided over the turns of a helix");
        }
        for block in 1..=blocks {
            let last = block == blocks;
            self.text.word(if arc.sweep > 0.0 { b"G3" } else { b"G2" });
            for axis in printed.iter() {
                let i = axis.index();
                // Whole turns in front end where they start; the other axes go along in proportion.
                let units = if last {
                    ends[i]
                } else if i == first || i == second {
                    start[i]
                } else {
                    let share = f64::from(block) * core::f64::consts::TAU / arc.sweep.abs();
                    start[i] + libm::round((ends[i] - start[i]) as f64 * share) as i64
                };
                self.axis_word(axis, units);
            }
            let mut offsets = [(first, offset[0]), (second, offset[1])];
            offsets.sort_by_key(|(axis, _)| *axis);
            for (axis, units) in offsets {
                self.text.number(b"IJK"[axis], units, self.places);
            }
            if self.traits.turns_in_one_block && turns > 1 {
                self.text.whole(b'P', u64::from(turns));
            }
            if let (1, Some(units)) = (block, word) {
                self.text.number(b'F', units, self.places);
            }
            self.end_line(origin);
        }
        self.at = ends;
        self.known = self.known.union(printed);
        self.stale = self.stale.without(printed);
        let _ = third;
    }

    /// Straight lines instead of an arc that does not fit the printed grid.
    #[cold]
    fn chords(&mut self, arc: &Arc, feed: Feed, mv: &Move, origin: &Origin) {
        self.report(codes::O4001, origin, "the arc is too small for its printed numbers and is printed as lines");
        let radius = crate::geo::distance(arc.from, arc.center);
        let unit = 1.0 / self.places.scale();
        // A chord leaves the arc by r·(1 - cos(a/2)).
        let step = 2.0 * libm::acos((1.0 - unit / (2.0 * radius)).max(0.0));
        let count = libm::ceil(arc.sweep.abs() / step.max(1e-6)).clamp(1.0, MOST_CHORDS);
        let (x, y, _) = arc.plane.axes();
        let (x, y) = (Axis::ALL[x], Axis::ALL[y]);
        let start: Vec<(Axis, i64)> = mv.axes.iter().map(|axis| (axis, self.at[axis.index()])).collect();
        for i in 1..=count as u32 {
            let t = f64::from(i) / count;
            let mut point = *mv;
            // Equal chords share the time.
            point.path = Path::Line(match feed {
                Feed::InverseTime(f) => Feed::InverseTime(f * count),
                Feed::PerMinute(_) | Feed::PerRevolution(_) => feed,
            });
            if t < 1.0 {
                let p = arc.center + turned(arc.from - arc.center, arc.sweep * t);
                for &(axis, from) in &start {
                    let from = from as f64 * unit;
                    let end = mv.end.get(axis).unwrap_or(from);
                    let value = if axis == x {
                        p.x
                    } else if axis == y {
                        p.y
                    } else {
                        from + (end - from) * t
                    };
                    point.end.set(axis, value);
                }
            }
            self.straight(b"G1", &point, origin);
        }
    }
}

/// What the printed F counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum FeedKind {
    PerMinute,
    PerRevolution,
    InverseTime,
}

impl FeedKind {
    fn of(feed: Feed) -> FeedKind {
        match feed {
            Feed::PerMinute(_) => FeedKind::PerMinute,
            Feed::PerRevolution(_) => FeedKind::PerRevolution,
            Feed::InverseTime(_) => FeedKind::InverseTime,
        }
    }

    fn word(self) -> &'static [u8] {
        match self {
            FeedKind::PerMinute => b"G94",
            FeedKind::PerRevolution => b"G95",
            FeedKind::InverseTime => b"G93",
        }
    }
}

impl Sink for Printer<'_> {
    fn movement(&mut self, mv: &Move, origin: &Origin) {
        if !self.full {
            self.print_move(mv, origin);
        }
    }

    fn function(&mut self, function: &Function, origin: &Origin) {
        if !self.full {
            self.print_function(function, origin);
        }
    }

    fn lost(&mut self, _: &Origin) {
        self.known = AxisSet::EMPTY;
    }

    fn begins_at(&mut self, at: &Pos) {
        for (axis, value) in at.iter() {
            if let Some(units) = self.places.units(value) {
                self.at[axis.index()] = units;
                self.known.insert(axis);
                // The target has not heard of it.
                self.stale.insert(axis);
            }
        }
    }

    fn full(&self) -> bool {
        self.full
    }
}

fn plane_word(plane: Plane) -> &'static [u8] {
    match plane {
        Plane::Xy => b"G17",
        Plane::Zx => b"G18",
        Plane::Yz => b"G19",
    }
}
