//! Blocks of words: modal codes, then technology, then the motion, then what acts behind it.
//!
//! Source: reference sections 0, 2.1, 2.6, 2.8 and 2.9.

use crate::diag::{Diagnostic, codes};
use crate::ir::contour::{Coords, EndPoint, Move, Path, Thread};
use crate::ir::{Feed, Pos, Side};
use crate::machine::{Axis, AxisSet};
use crate::parser::sinumerik::ast::{Block, Target};
use crate::text::Span;

use super::state::Diameter;
use super::vocabulary::{Address, Code};
use super::words::{Given, Mode, Words};
use super::{Outcome, Reported, Run};

/// Addresses that shape an arc.
const ARC_ADDRESSES: [Address; 9] = [
    Address::I,
    Address::J,
    Address::K,
    Address::I1,
    Address::J1,
    Address::K1,
    Address::Cr,
    Address::Ar,
    Address::Turn,
];

impl Run<'_> {
    pub(super) fn words_block(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let mut words = self.words.take().unwrap_or_else(|| Box::new(Words::new()));
        words.clear();
        let result = self.sort_words(&mut words, block, text).and_then(|()| {
            if words.is_empty() {
                return Ok(());
            }
            if words.call.is_some() || words.l.is_some() {
                return self.call_block(&mut words, block, text);
            }
            self.begins_executing();
            self.run_words_of(&mut words, block)
        });
        if result.is_err() {
            self.lose_block(&words, block);
        }
        self.words = Some(words);
        result
    }

    /// After an error nobody knows where the axes of the block are.
    fn lose_block(&mut self, words: &Words, block: &Block) {
        let mut axes = words.axes;
        for word in &block.words {
            match word.target {
                Target::Letter(letter) => {
                    if let Some(axis) = Axis::of(letter) {
                        axes.insert(axis);
                    }
                }
                Target::Indexed(..) => axes = axes.union(AxisSet::MAIN),
                _ => {}
            }
        }
        let more = [Address::Ap, Address::Rp, Address::Ang, Address::Ar, Address::F];
        if ARC_ADDRESSES.iter().chain(&more).any(|address| words.get(*address).is_some()) {
            axes = axes.union(AxisSet::MAIN);
        }
        if words.get(Address::F).is_some() {
            self.st.feed_lost = true;
        }
        self.pair_lost |= words.get(Address::Ang).is_some();
        if !axes.is_empty() {
            self.st.lose(axes);
            self.pending = None;
            self.lost();
        }
    }

    /// The words of a block that holds no call.
    pub(super) fn run_words_of(&mut self, w: &mut Words, block: &Block) -> Outcome {
        if !w.codes.is_empty() {
            self.check_codes(w)?;
            if let Some((code, span)) = w.code_of(2) {
                self.modal_codes(w)?;
                return self.special_block(code, span, w, block);
            }
            if let Some((code, span)) = w.code_of(3) {
                self.modal_codes(w)?;
                return self.frame_block(code, span, w, block);
            }
            self.modal_codes(w)?;
        }
        self.technology(w)?;
        self.early_functions(w)?;
        let corner_before = self.corner_open.map(|(loc, _)| loc);
        let moved = self.motion(w, block)?;
        if moved && self.corner_open.map(|(loc, _)| loc) == corner_before {
            self.corner_open = None;
        }
        self.block_behind_corner(moved)?;
        if let Some(left) = w.left() {
            return self.does_not_fit(left.span);
        }
        if let Some(span) = w.machine_axes.first().map(|(_, span)| *span) {
            return self.fail_help(
                codes::S2016,
                12050,
                span,
                "machine axes like X1 stand in G74 and G75 only",
                "name the geometry axis: X=10",
            );
        }
        if let Some(passes) = w.passes {
            return self.does_not_fit(passes.span);
        }
        self.late_functions(w)?;
        if moved && !self.ended.get() {
            self.call_modal()?;
        }
        Ok(())
    }

    pub(super) fn does_not_fit<T>(&self, span: Span) -> Outcome<T> {
        self.fail_help(
            codes::S2012,
            12110,
            span,
            "the word does not fit the other words of the block",
            "check which G code of group 1 is in force, and what it takes",
        )
    }

    pub(super) fn two_shapes(&self, a: Code, first: Span, b: Code, second: Span) -> Outcome {
        let (a, b) = (super::vocabulary::word(a), super::vocabulary::word(b));
        let message = format!("{a} and {b} cannot stand in one block (alarm 12070)");
        let found = Diagnostic::new(codes::S2009, self.loc(second), message);
        self.report(found.also(self.loc(first), "the other one").help("give each a block of its own"));
        Err(Reported)
    }

    /// Groups 1 to 4 shape the block: it takes one of them.
    fn check_codes(&mut self, w: &Words) -> Outcome {
        let mut shaping = w.codes.iter().filter(|(code, _)| code.group <= 4);
        if let (Some((a, first)), Some((b, second))) = (shaping.next(), shaping.next()) {
            return self.two_shapes(*a, *first, *b, *second);
        }
        Ok(())
    }

    /// The codes that hold on.
    pub(super) fn modal_codes(&mut self, w: &Words) -> Outcome {
        for at in 0..w.codes.len() {
            let (code, span) = w.codes[at];
            self.modal_code(code, span)?;
        }
        if let Some((indexed, axis, span)) = w.diameter {
            self.axis_diameter(indexed, axis, span)?;
        }
        if let Some(span) = w.dynamics {
            self.note_once(codes::S8002, span, "words that only shape speed and accuracy are left out");
        }
        Ok(())
    }

    fn modal_code(&mut self, code: Code, span: Span) -> Outcome {
        let old = self.st.groups[code.group as usize];
        match code.group {
            1 => {
                self.check_interpolation(code, span)?;
                self.st.groups[1] = code.index;
            }
            2 | 3 | 9 | 11 | 62 => {}
            6 => {
                self.st.groups[6] = code.index;
                if old != code.index {
                    self.plane_change(code.index, span)?;
                }
            }
            7 => self.compensation_code(code, span)?,
            8 => self.work_offset(code.index, span)?,
            15 => self.feed_code(code, span)?,
            29 => {
                if code != Code::DIAMOF && self.job.settings.machine.diameter_axis.is_none() {
                    return self.no_diameter_axis(span);
                }
                self.st.groups[29] = code.index;
                self.st.diameter = None;
            }
            10 | 12 | 21 | 24 | 30 | 34 | 39 | 57 | 59 => {
                self.st.groups[code.group as usize] = code.index;
                if !(code.group == 10 && code.index <= 2 || code.group == 12 || code.group == 30 && code.index == 1) {
                    self.note_once(codes::S8002, span, "words that only shape speed and accuracy are left out");
                }
            }
            _ => {
                self.refused_code(code, span)?;
                self.st.groups[code.group as usize] = code.index;
            }
        }
        Ok(())
    }

    fn plane_change(&mut self, index: u8, span: Span) -> Outcome {
        if self.st.side() != Side::None {
            return self.fail_help(
                codes::S2080,
                10757,
                span,
                "the plane changes while radius compensation is on",
                "program G40 in a block in front of it",
            );
        }
        self.plane_changes_in_a_pair(span)?;
        self.set_plane(index);
        let plane = self.st.plane();
        self.function(crate::ir::Function::Plane(plane));
        Ok(())
    }

    fn refused_code(&self, code: Code, span: Span) -> Outcome {
        let what = match (code.group, code.index) {
            (47, 2) => {
                return self.fail_help(
                    codes::S9003,
                    0,
                    span,
                    "G291 switches to ISO dialect",
                    "translate the ISO part, or compile it by itself",
                );
            }
            (49, i) if i > 1 => "point-to-point travel",
            (52, 2) => "a frame turned to the workpiece",
            (53, i) if i > 1 => "a frame turned to the tool",
            (42, i) if i > 1 => "an orientable tool carrier",
            (35, i) if i > 1 => "punching",
            (31 | 32, _) => "a code of the machine builder",
            (40, 2) => "compensation with a constant offset",
            (64, _) => "a grinding frame",
            _ => return Ok(()),
        };
        let message = format!("{} is {what}, which cannot be printed", super::vocabulary::word(code));
        self.fail_help(codes::S9001, 0, span, message, "leave it out, or replace it by plain moves")
    }

    // Motion.

    /// The motion of the block. True if axes moved along a path.
    fn motion(&mut self, w: &mut Words, block: &Block) -> Outcome<bool> {
        let interpolation = Code { group: 1, index: self.st.groups[1] };
        self.modal_contour_words(w)?;
        let suppressed = w.code_of(9).filter(|(code, _)| *code != Code::SUPD);
        let polar = w.get(Address::Ap).is_some() || w.get(Address::Rp).is_some();
        let round = matches!(interpolation, Code::G2 | Code::G3);
        let arc = round && ARC_ADDRESSES.iter().any(|address| w.get(*address).is_some());
        let moves = !w.axes.is_empty() || polar || arc || w.get(Address::Ang).is_some();
        if !w.positioning.is_empty() {
            self.positioning(w)?;
        }
        if !moves {
            if self.has_corner_words(w) {
                return self.no_corner(block.span);
            }
            return Ok(false);
        }
        if let Some((_, span)) = suppressed {
            return self.machine_move(w, interpolation, span).map(|()| true);
        }
        let in_plane = polar || w.get(Address::Ang).is_some() || {
            let [first, second, _] = self.st.roles();
            w.axes.contains(first) || w.axes.contains(second)
        };
        self.check_offsets(w)?;
        self.check_start_of_compensation(interpolation, in_plane, block.span)?;
        let corner = self.corner_words(w)?;
        if !matches!(interpolation, Code::G0 | Code::G1) {
            self.only_lines_by_angle(w, block.span)?;
        }
        match interpolation {
            Code::G0 | Code::G1 => self.line_block(w, interpolation, polar, corner.as_ref())?,
            Code::G2 | Code::G3 => self.circle_block(w, interpolation == Code::G3, polar)?,
            Code::CIP => self.via_block(w)?,
            Code::CT => self.tangent_block(w)?,
            Code::G33 => self.thread_block(w, block.span)?,
            _ => return self.check_interpolation(interpolation, block.span).and(Err(Reported)),
        }
        // The first line of a pair sends its corner when its end is known.
        if self.pending.is_none() {
            self.send_corner(corner);
        }
        Ok(true)
    }

    /// Under D0 the control counts from the spindle nose, which the target cannot say.
    fn check_offsets(&self, w: &Words) -> Outcome {
        // A contour is a shape: no tool follows it.
        let off = !self.is_capturing()
            && self.st.tool.edge == Some(0)
            && self.st.tool.active.is_some_and(|number| number != 0);
        if !off || self.st.machine_coordinates {
            return Ok(());
        }
        let [_, _, third] = self.st.roles();
        let lengths = if self.st.lathe { [Axis::X, Axis::Z] } else { [third, third] };
        match w.axes.iter().find(|axis| lengths.contains(axis)).and_then(|axis| w.axis(axis)) {
            Some(given) => self.fail_help(
                codes::S9016,
                0,
                given.span,
                "under D0 the position counts without the length of the tool",
                "program the retraction in machine coordinates (SUPA, G53), or select D1 before",
            ),
            None => Ok(()),
        }
    }

    pub(super) fn check_interpolation(&self, code: Code, span: Span) -> Outcome {
        let what = match code {
            Code::G0 | Code::G1 | Code::G2 | Code::G3 | Code::CIP | Code::CT | Code::G33 => return Ok(()),
            Code::G34 | Code::G35 => "a thread of changing lead",
            Code::G331 | Code::G332 => "rigid tapping",
            Code { index: 6..=9, .. } => "a spline or polynomial",
            Code { index: 18 | 19, .. } => "an involute",
            Code { index: 20 | 21, .. } => "a thread on an arc",
            _ => "an interpolation of the machine builder",
        };
        let message = format!("{} is {what}, which plain G-code cannot say", super::vocabulary::word(code));
        self.fail_help(codes::S9002, 0, span, message, "have the CAM system put out lines and arcs")
    }

    fn line_block(
        &mut self,
        w: &mut Words,
        code: Code,
        polar: bool,
        corner: Option<&crate::ir::contour::Corner>,
    ) -> Outcome {
        let feed = self.path_feed(w, code == Code::G0)?;
        let path = if code == Code::G0 { Path::Rapid } else { Path::Line };
        if w.get(Address::Ang).is_some() || self.pending.is_some() {
            return self.angle_block(w, path, feed, corner);
        }
        let end = if polar { self.polar_end(w)? } else { self.targets(w)? };
        self.send(&end, path, feed);
        Ok(())
    }

    /// The programmed end points of all axes of the block.
    #[inline]
    pub(super) fn targets(&mut self, w: &Words) -> Outcome<Pos> {
        let mut end = Pos::UNKNOWN;
        for axis in w.axes.iter() {
            if let Some(given) = w.axis(axis) {
                let value = self.target(axis, given)?;
                end.set(axis, value);
            }
        }
        Ok(end)
    }

    /// The end point of one axis in mm (radius) or degrees.
    #[inline]
    pub(super) fn target(&mut self, axis: Axis, given: Given) -> Outcome<f64> {
        if axis.is_rotary() {
            return self.rotary_target(axis, given);
        }
        let incremental = match given.mode {
            Mode::Plain => self.st.is(Code::G91),
            Mode::Ac | Mode::Dac | Mode::Rac => false,
            Mode::Ic | Mode::Dic | Mode::Ric => true,
            Mode::Dc | Mode::Acp | Mode::Acn => {
                let message = format!("{} is no rotary axis", axis.letter());
                return self.fail_help(codes::S2061, 16800, given.span, message, "DC, ACP and ACN are for rotary axes");
            }
            Mode::Quick => return self.does_not_fit(given.span),
        };
        let value = self.length(axis, given, incremental)?;
        if incremental { Ok(self.increment_base(axis, given.span)? + value) } else { Ok(value) }
    }

    /// A length along an axis as a radius in mm.
    #[inline]
    pub(super) fn length(&self, axis: Axis, given: Given, incremental: bool) -> Outcome<f64> {
        let value = given.value * self.st.length_unit();
        let diameter = match given.mode {
            Mode::Dac | Mode::Dic | Mode::Rac | Mode::Ric => {
                if !self.is_diameter_axis(axis) {
                    return self.no_diameter_axis(given.span);
                }
                matches!(given.mode, Mode::Dac | Mode::Dic)
            }
            _ if !self.is_diameter_axis(axis) => false,
            _ => match self.st.diameter_mode() {
                Diameter::Off => false,
                Diameter::On => true,
                Diameter::Absolute => !incremental,
            },
        };
        Ok(if diameter { value / 2.0 } else { value })
    }

    #[inline]
    pub(super) fn is_diameter_axis(&self, axis: Axis) -> bool {
        self.job.settings.machine.diameter_axis == Some(axis)
    }

    pub(super) fn no_diameter_axis<T>(&self, span: Span) -> Outcome<T> {
        self.fail_help(
            codes::S2060,
            16510,
            span,
            "no diameter axis is configured (MD 20100)",
            "set `[machine] diameter_axis = \"X\"`, and `kind = \"lathe\"` for a lathe",
        )
    }

    /// What an increment counts from: the value last programmed, or where the axis stands (SD 42440).
    fn increment_base(&mut self, axis: Axis, span: Span) -> Outcome<f64> {
        if self.st.lost.contains(axis) {
            return Err(Reported);
        }
        let Some(at) = self.st.pos.get(axis) else { return self.unknown_axis(axis, span) };
        let programmed = self.st.programmed.get(axis).unwrap_or(at);
        if (programmed - at).abs() <= 1e-9 {
            return Ok(at);
        }
        let with_offset = match self.system.get("$SC_FRAME_OFFSET_INCR_PROG").and_then(super::value::Val::truth) {
            Some(set) => set,
            None => self.job.settings.control.siemens.frame_offset_incremental.unwrap_or(true),
        };
        let chosen = if with_offset { programmed } else { at };
        if self.job.settings.control.siemens.frame_offset_incremental.is_some() {
            return Ok(chosen);
        }
        let found = Diagnostic::new(
            codes::S8007,
            self.loc(span),
            format!("the increment of {} follows a change of the frame", axis.letter()),
        );
        let how = if with_offset {
            "the frame is travelled, too (SD 42440 = 1)"
        } else {
            "only the increment is travelled (SD 42440 = 0)"
        };
        self.report(found.here(how).help("set `[control] sd42440`, or program the position absolutely"));
        Ok(chosen)
    }

    pub(super) fn unknown_axis<T>(&self, axis: Axis, span: Span) -> Outcome<T> {
        if self.st.lost.contains(axis) {
            return Err(Reported);
        }
        self.fail_help(
            codes::S2042,
            0,
            span,
            format!("where {} stands is not known", axis.letter()),
            "program the axis once in absolute coordinates in front of this block",
        )
    }

    fn rotary_target(&mut self, axis: Axis, given: Given) -> Outcome<f64> {
        let incremental = match given.mode {
            Mode::Plain => self.st.is(Code::G91),
            Mode::Ac => false,
            Mode::Ic => true,
            Mode::Dc | Mode::Acp | Mode::Acn => {
                if !(0.0..360.0).contains(&given.value) {
                    let message = format!("{} lies outside 0 to 359.999", given.value);
                    return self.fail(codes::S2061, 16830, given.span, message);
                }
                let Some(at) = self.st.pos.get(axis) else { return self.unknown_axis(axis, given.span) };
                let forward = given.value - at - 360.0 * libm::floor((given.value - at) / 360.0);
                return Ok(match given.mode {
                    Mode::Acp => at + forward,
                    Mode::Acn if forward == 0.0 => at,
                    Mode::Acn => at + forward - 360.0,
                    _ if forward > 180.0 => at + forward - 360.0,
                    _ => at + forward,
                });
            }
            _ => return self.no_diameter_axis(given.span),
        };
        if incremental { Ok(self.increment_base(axis, given.span)? + given.value) } else { Ok(given.value) }
    }

    /// Sends a move to the named axes of `end`.
    #[inline]
    pub(super) fn send(&mut self, end: &Pos, path: Path, feed: Option<Feed>) {
        self.send_end(EndPoint::Cartesian(*end), end, path, feed);
    }

    pub(super) fn send_end(&mut self, end_point: EndPoint, end: &Pos, path: Path, feed: Option<Feed>) {
        if self.st.machine_coordinates {
            return self.send_in_machine(end, path, feed);
        }
        if self.stored.is_some() {
            self.note_stored(end, &path);
        }
        let mv = Move { end: end_point, path, feed, side: self.st.side(), coords: Coords::Frame };
        self.out.movement(&mv, &self.st.ctx, &self.here.origin);
        self.moved_to(end);
    }

    #[inline]
    pub(super) fn moved_to(&mut self, end: &Pos) {
        self.st.pos.update(end);
        self.st.programmed.update(end);
        if !self.st.lost.is_empty() {
            self.st.lost = self.st.lost.without(end.known());
        }
    }

    /// G500 is in force: the coordinates are the machine's.
    fn send_in_machine(&mut self, end: &Pos, path: Path, feed: Option<Feed>) {
        if !matches!(path, Path::Rapid | Path::Line) {
            let _: Outcome = self.fail_help(
                codes::S9011,
                0,
                Span::default(),
                "under G500 only straight moves can be printed, in machine coordinates",
                "select G54, or say which work offset G500 is: `[datums] G500 = \"G54\"`",
            );
            return;
        }
        if !self.st.ctx.frame.is_shift() || self.st.side() != Side::None {
            let _: Outcome = self.fail(
                codes::S9011,
                0,
                Span::default(),
                "under G500 neither a rotated frame nor radius compensation can be printed",
            );
            return;
        }
        let machine = self.st.ctx.frame.apply(end);
        let mv = Move { end: EndPoint::Cartesian(machine), path, feed, side: Side::None, coords: Coords::Machine };
        self.out.movement(&mv, &self.st.ctx, &self.here.origin);
        self.moved_to(end);
    }

    /// A block under G53, G153 or SUPA.
    fn machine_move(&mut self, w: &mut Words, code: Code, span: Span) -> Outcome {
        self.pending_must_be_done(span)?;
        if !matches!(code, Code::G0 | Code::G1) || w.get(Address::Ap).is_some() || w.get(Address::Rp).is_some() {
            return self.fail_help(
                codes::S9011,
                0,
                span,
                "in machine coordinates only straight moves can be printed",
                "program G0 or G1 with axes in this block",
            );
        }
        if self.st.side() != Side::None {
            return self.fail(codes::S2080, 0, span, "a block in machine coordinates under radius compensation");
        }
        let feed = self.path_feed(w, code == Code::G0)?;
        let mut end = Pos::UNKNOWN;
        for axis in w.axes.iter() {
            let Some(given) = w.axis(axis) else { continue };
            let incremental = match given.mode {
                Mode::Plain => self.st.is(Code::G91),
                Mode::Ic | Mode::Dic | Mode::Ric => true,
                _ => false,
            };
            if incremental {
                return self.fail_help(
                    codes::S9011,
                    0,
                    given.span,
                    "an increment in machine coordinates starts from a place that only the machine knows",
                    "program the machine coordinate with AC(…) or under G90",
                );
            }
            let value = if axis.is_rotary() { given.value } else { self.length(axis, given, false)? };
            end.set(axis, value);
        }
        let path = if code == Code::G0 { Path::Rapid } else { Path::Line };
        let mv = Move { end: EndPoint::Cartesian(end), path, feed, side: Side::None, coords: Coords::Machine };
        self.out.movement(&mv, &self.st.ctx, &self.here.origin);
        for axis in w.axes.iter() {
            self.st.forget(axis);
        }
        Ok(())
    }

    /// `POS[X]=10 FA[X]=500`
    fn positioning(&mut self, w: &mut Words) -> Outcome {
        if !w.axes.is_empty() || w.get(Address::Ap).is_some() || w.get(Address::Rp).is_some() {
            let span = w.positioning[0].given.span;
            return self.fail_help(
                codes::S9008,
                0,
                span,
                "POS beside a path motion: the two run at the same time",
                "give POS a block of its own",
            );
        }
        for at in 0..w.positioning.len() {
            let positioning = w.positioning[at];
            let axis = positioning.axis;
            let value = self.target(axis, positioning.given)?;
            let feed = w.axis_feeds.iter().find(|(known, _)| *known == axis).map(|(_, feed)| *feed);
            let Some(feed) = feed.or_else(|| self.axis_feed.get(&axis).copied()) else {
                return self.fail_help(
                    codes::S2040,
                    10860,
                    positioning.given.span,
                    format!("the feed of {} as a positioning axis is a machine datum", axis.letter()),
                    "give it: FA[X]=500",
                );
            };
            let unit = if axis.is_rotary() { 1.0 } else { self.st.feed_unit() };
            self.axis_feed.insert(axis, feed);
            let mut end = Pos::UNKNOWN;
            end.set(axis, value);
            self.send(&end, Path::Line, Some(Feed::PerMinute(feed * unit)));
        }
        Ok(())
    }

    /// G33
    fn thread_block(&mut self, w: &mut Words, span: Span) -> Outcome {
        let end = self.targets(w)?;
        if let Some(start) = w.take(Address::Sf)
            && start.value != 0.0
        {
            return self.fail_help(
                codes::S9012,
                0,
                start.span,
                "a start angle of the thread cannot be printed",
                "shift the start point along the thread instead: lead · angle / 360",
            );
        }
        let [first, second, third] = self.st.geometry_axes;
        for (address, axis) in [(Address::I, first), (Address::J, second), (Address::K, third)] {
            if let Some(lead) = w.take(address) {
                if lead.value == 0.0 {
                    return self.fail(codes::S2081, 16720, lead.span, "the lead of the thread is 0");
                }
                self.lead = Some((axis, lead.value.abs() * self.st.length_unit()));
                if !w.axes.contains(axis) {
                    let message = format!("the lead counts along {}, which the block does not move", axis.letter());
                    return self.fail(codes::S2081, 16730, lead.span, message);
                }
            }
        }
        let Some((axis, lead)) = self.lead else {
            return self.fail_help(codes::S2081, 16720, span, "the thread has no lead", "program K along Z, I along X");
        };
        for axis in w.axes.iter().filter(|axis| axis.is_main()) {
            if self.st.pos.get(axis).is_none() {
                return self.unknown_axis(axis, span);
            }
        }
        let way = |axis: Axis| match (end.get(axis), self.st.pos.get(axis)) {
            (Some(to), Some(from)) => (to - from).abs(),
            _ => 0.0,
        };
        if let Some(longer) = AxisSet::MAIN.iter().find(|other| way(*other) > way(axis) + 1e-9) {
            let message = format!("the lead is given along {}, but {} moves further", axis.letter(), longer.letter());
            return self.fail_help(
                codes::S2081,
                16730,
                span,
                message,
                "give the lead along the axis that moves further",
            );
        }
        self.send(&end, Path::Thread(Thread { lead, along: Some(axis) }), None);
        Ok(())
    }
}
