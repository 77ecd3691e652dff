//! Radius compensation that the compiler computes: what the codes of the program say about the path of the centre.
//!
//! Comes in: G40 to G42 with the data of the edge, OFFN, DISC, and the codes of groups 17, 18, 21, 23, 40 and 48. Goes out:
//! the rules beside each move ([`crate::ir::Compensation`]). The path itself is computed behind the frames (`docs/compensation.md`).
//!
//! Source: S 2.12, S 2.13 (docs/sources.md); docs/compensation.md.

use crate::diag::{Answer, codes};
use crate::geo::{Plane, Vec2};
use crate::ir::{Function, Side};
use crate::machine::Compensation;
use crate::sema::common::compensation::{compensate, edge_direction};
use crate::sema::run::Where;
use crate::text::Span;

use super::g_groups::{ActiveCodes, GCode, Group};
use super::value::whole;
use super::vocabulary::Address;
use super::words::{Given, Words};
use super::{Core, Outcome, State};

/// Types of tools from here on have cutting edges that are known by their position.
const TURNING_TOOLS: f64 = 500.0;

/// How the radius compensation begins and ends.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct CompensationState {
    /// G40, G41 or G42 waits for its move.
    starts: bool,
    /// The side that G40 ended, and whether its offset still waits for a move in the plane.
    leaving: Side,
    leaving_open: bool,
    /// G41 or G42 of the block, until its D is known.
    open: Option<Span>,
}

impl CompensationState {
    /// G41 or G42 of the block, once its D is known.
    pub fn take_open(&mut self, waits: bool) -> Option<Span> {
        self.open.take_if(|_| !waits)
    }

    /// Blocks stand where the compensation would start.
    pub fn begins_no_more(&mut self) {
        self.starts = false;
    }

    /// The side that G40 ended.
    pub fn left(&self) -> Side {
        self.leaving
    }

    /// A move in machine coordinates has ended the contour.
    pub fn is_over(&mut self) {
        (self.starts, self.leaving_open) = (false, false);
    }

    /// G40, G41 or G42 waits for its move or its D.
    pub fn waits(&self) -> bool {
        self.starts || self.leaving_open || self.open.is_some()
    }

    /// The side on which a move is printed under `side`: behind G40 the one of before, until a move in the plane takes
    /// the offset off.
    #[inline]
    pub fn side_of_move(&self, side: Side) -> Side {
        if self.leaving_open { self.leaving } else { side }
    }

    /// G40 waits for a move in the plane.
    #[inline]
    pub fn is_leaving(&self) -> bool {
        self.leaving_open
    }

    /// It is over without its move.
    pub fn end(&mut self, codes_on: &mut ActiveCodes) {
        codes_on.activate(GCode::G40);
        self.starts = false;
    }

    /// The block of a G41 or G42 has failed in front of its D: no later block stands for it.
    pub fn end_unselected(&mut self, codes_on: &mut ActiveCodes) {
        if self.take_open(false).is_some() {
            self.end(codes_on);
        }
    }

    /// G40, G41 or G42 waits for its move.
    pub fn is_starting(&self) -> bool {
        self.starts
    }

    /// G40, G41 or G42. `computed`: the path of the compensation that is on is computed.
    pub fn select(
        &mut self,
        core: &Core<'_>,
        codes_on: &mut ActiveCodes,
        computed: bool,
        code: GCode,
        span: Span,
    ) -> Outcome {
        if code != GCode::G40 {
            if core.resolves() {
                self.begin_again(core, codes_on, computed, code, span)?;
            }
            if codes_on.of(Group::CompensationType).index > 2 {
                let kind = codes_on.of(Group::CompensationType).word();
                return core.refuse(span, codes::P9013::under_radius_is_compensated_in_space(&kind));
            }
            self.open = Some(span);
            if !core.resolves() {
                // The target rounds corners, enters and leaves the contour in its own way.
                let shapes = [Group::Approach, Group::Corner, Group::Collision, Group::CompensationEnds];
                let said = shapes.into_iter().map(|group| codes_on.of(group)).find(|code| code.index != 1);
                if let Some(code) = said {
                    core.says_shape(span, &code.word());
                }
            }
        } else {
            self.open = None;
        }
        if code != GCode::G40 && self.leaving_open {
            return core.refuse(span, codes::S2080::side_stands_behind_g40_without_move());
        }
        if code == GCode::G40 && codes_on.side() != Side::None {
            self.leaving = codes_on.side();
        }
        let waits = self.starts || self.leaving_open;
        self.starts = !codes_on.is(code) || waits;
        codes_on.activate(code);
        Ok(())
    }

    /// G41 or G42 while one of them is on.
    fn begin_again(&self, core: &Core<'_>, codes_on: &ActiveCodes, computed: bool, code: GCode, span: Span) -> Outcome {
        let old = codes_on.of(Group::Compensation);
        if old == GCode::G40 {
            // G40 has had no move at all: the contour goes on.
            let open = self.waits() && computed;
            return if open { core.refuse(span, codes::S2080::g40_in_front_has_had_no_move()) } else { Ok(()) };
        }
        if self.waits() {
            return Ok(());
        }
        let fault = if old == code {
            codes::P9013::is_on_already(&code.word())
        } else {
            codes::P9013::follows_without_g40(&code.word(), &old.word())
        };
        core.refuse(span, fault)
    }

    /// Compensation starts and ends on a straight line.
    pub fn moves(&mut self, core: &Core<'_>, side: Side, code: GCode, in_plane: bool, span: Span) -> Outcome {
        if !self.starts {
            return Ok(());
        }
        let on = side != Side::None;
        let line = matches!(code, GCode::G0 | GCode::G1);
        if !on && line && !in_plane && !core.job.settings.control.sinumerik.g40_needs_motion {
            // The plane position does not change, so the offset can wait for the next move in the plane.
            self.leaving_open = true;
            if !core.resolves() && core.job.diags.first_time(codes::S8134, ()) {
                let found = codes::S8134::g40_stands_in_front_of_move().at(core.loc(span));
                core.report(found.help("program G40 with a move in the plane; some controls show alarm 10754 here"));
            }
            return Ok(());
        }
        (self.starts, self.leaving_open) = (false, false);
        if line && in_plane {
            return Ok(());
        }
        let alarm = if on { 10753 } else { 10754 };
        let what = if in_plane { "on an arc" } else { "without a move in the plane" };
        core.refuse(span, codes::S2080::radius_compensation(&(if on { "starts" } else { "ends" }), &what).alarm(alarm))
    }

    /// What ends the compensation on the target while the tool still stands beside the contour: its next move would go
    /// over the contour.
    pub fn leaves_before(&mut self, core: &Core<'_>, function: &Function) -> Outcome {
        let ends = match function {
            // The path was computed, and stays where it is.
            Function::ToolChange { .. } => !core.resolves(),
            _ => matches!(function, Function::WorkOffset(_) | Function::Plane(_) | Function::Transformation(_)),
        };
        if !ends || !self.leaving_open {
            return Ok(());
        }
        self.leaving_open = false;
        core.refuse(Where::Block, codes::S2080::g40_has_had_no_move_in_plane())
    }
}

/// The cutter whose radius is compensated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cutter {
    /// Radius of the edge with its wear in mm; below zero the side is swapped.
    pub radius: f64,
    /// Way from the programmed point to the centre of the nose, in the working plane.
    pub nose: Vec2,
}

/// What holds on about the computed path.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Path {
    /// The cutter of the last G41 or G42, if the compiler compensates.
    cutter: Option<Cutter>,
    /// OFFN: distance between the cutter and the contour, in mm.
    normal: f64,
    /// DISC
    overshoot: f64,
    /// The radius with OFFN is below zero.
    pub swaps: bool,
}

impl Path {
    /// The compiler computes the path of the compensation that is on.
    #[inline]
    pub fn is_computed(&self) -> bool {
        self.cutter.is_some()
    }

    /// DISC
    pub fn overshoot(&self) -> f64 {
        self.overshoot
    }

    /// OFFN, in mm.
    pub fn normal(&self) -> f64 {
        self.normal
    }

    /// Radius with OFFN, not below zero.
    pub fn radius(&self) -> f64 {
        self.cutter.map_or(0.0, |cutter| (cutter.radius + self.normal).abs())
    }

    /// OFFN and DISC; in front of G41 and G42 of the block. `is_on`: the path is compensated already.
    pub fn shape(&mut self, core: &Core<'_>, w: &mut Words, unit: f64, is_on: bool) -> Outcome {
        if let Some(offn) = w.take(Address::Offn) {
            self.set_normal(core, offn, offn.value * unit, is_on)?;
        }
        if let Some(disc) = w.take(Address::Disc) {
            if !(0.0..=100.0).contains(&disc.value) {
                return core.refuse(disc.span, codes::P1003::disc_lies_outside_0_to_100(&disc.value));
            }
            if core.resolves() {
                self.overshoot = disc.value;
            } else {
                core.says_shape(disc.span, "DISC=");
            }
        }
        Ok(())
    }

    fn set_normal(&mut self, core: &Core<'_>, offn: Given, value: f64, is_on: bool) -> Outcome {
        if !core.resolves() {
            if value == 0.0 {
                return Ok(());
            }
            return core.refuse(
                offn.span,
                codes::P9013::offset_of_tool_that_program_adds_cannot()
                    .answer(Answer::key("output", "compensation").one_of(&["\"resolve\""])),
            );
        }
        if value != self.normal && is_on {
            return core.refuse(offn.span, codes::P9013::offn_changes_while_radius_compensation());
        }
        self.normal = value;
        Ok(())
    }

    /// G41 or G42 with its cutter.
    pub fn begin(&mut self, core: &Core<'_>, cutter: Cutter, span: Span) -> Outcome {
        let (radius, normal) = (cutter.radius, self.normal);
        if normal != 0.0 && (radius + normal) * radius < 0.0 {
            return core.refuse(span, codes::P9013::offn_is_larger_than_radius_of_tool(&normal, &radius));
        }
        self.cutter = Some(cutter);
        self.swaps = radius + normal < 0.0;
        Ok(())
    }
}

impl State {
    /// The program gives the compensation other rules, if it is computed.
    pub(super) fn rules_change(&mut self, core: &Core<'_>, w: &Words) -> Outcome {
        let (Some(cutter), true) = (self.path.cutter, core.resolves()) else { return Ok(()) };
        // The block of G40 is the last one that asks for them.
        if self.side() == Side::None && w.code_of(Group::Compensation).is_none() {
            return Ok(());
        }
        if let Some((code, span)) = w.code_of(Group::CompensationType).filter(|(code, _)| code.index > 2) {
            return core.refuse(span, codes::P9013::under_radius_is_compensated_in_space(&code.word()));
        }
        let place = w.codes.first().map_or(Where::Block, |(_, span)| (*span).into());
        corner_changes(core, self, w);
        match self.rules(cutter, core.job.settings) {
            Ok((rules, disc)) => {
                disc.into_iter().for_each(|fault| core.say_once(place, fault));
                compensate(&mut self.ctx, rules);
                Ok(())
            }
            Err(fault) => {
                self.compensation.end(&mut self.codes);
                self.path.cutter = None;
                core.refuse(place, fault)
            }
        }
    }
}

impl Core<'_> {
    /// Does the compiler compute the path?
    #[inline]
    pub(super) fn resolves(&self) -> bool {
        self.job.settings.output.compensation == Compensation::Resolve
    }

    pub(super) fn says_shape(&self, span: Span, word: &str) {
        self.say_once(span, codes::S8043::is_left_out(&word));
    }
}

/// Way from the tip to the centre of a nose of radius 1 along Z and X, by the position of the edge: seen with Z to the
/// right and X up.
pub(super) fn nose_of(position: f64) -> Option<Vec2> {
    let position = whole(position).and_then(|position| u8::try_from(position).ok())?;
    edge_direction(position).map(|to| Vec2::zeros() - to)
}

/// At which corner a change of G450 and G451 counts is not documented.
fn corner_changes(core: &Core<'_>, st: &State, w: &Words) {
    let Some((code, span)) = w.code_of(Group::Corner) else { return };
    let on = st.side() != Side::None && !st.compensation.waits();
    if !on || w.axes.is_empty() || !core.job.diags.first_time(codes::S8195, code.word()) {
        return;
    }
    let found = codes::S8195::stands_in_block_of_contour(&code.word()).at(core.loc(span));
    core.report(found.help("write it into a block without a move, before the element whose end it means"));
}

/// Where the centre of the nose lies from the point that is programmed. In the plane ZX of a lathe only: a milling
/// cutter is programmed by its centre.
pub(super) fn nose(core: &Core<'_>, st: &State, number: u32, edge: u32, radius: f64, span: Span) -> Outcome<Vec2> {
    let written = |parameter: u8| st.system.of_edge(parameter, number, edge);
    let tool = core.job.settings.tools.called(number).filter(|_| edge == 1);
    let turns = match (written(1), tool.and_then(|tool| tool.kind.as_deref())) {
        (Some(kind), _) => kind >= TURNING_TOOLS,
        (None, Some(kind)) => !matches!(kind, "mill" | "drill" | "tap"),
        (None, None) => st.machine.lathe && st.plane() == Plane::Zx,
    };
    if !turns || radius == 0.0 {
        return Ok(Vec2::zeros());
    }
    if st.plane() != Plane::Zx {
        return core.refuse(span, codes::P9013::t_is_turning_tool(&number));
    }
    let position = st.edge_position(core.job.settings, number, edge);
    let Some(way) = position.and_then(nose_of) else {
        let fault = match position {
            Some(position) => codes::P9013::is_no_position_of_edge(&position),
            None => {
                codes::P9013::position_of_edge_is_not_known(&number, &edge).answer(Answer::tool(number, "orientation"))
            }
        };
        return core.refuse(span, fault);
    };
    if way != Vec2::zeros() {
        let found = codes::S8194::cutting_edge_position(&position.unwrap_or(0.0), &(way.x * radius), &(way.y * radius))
            .at(core.loc(span));
        core.report_once(found.help("compare it with the position in the tool data of the control"));
    }
    Ok(way * radius)
}

/// Where an edge points to from the centre of its nose, along Z and X: what a target is told with the radius.
pub(super) fn edge_points_to(nose: Vec2) -> [i8; 2] {
    [nose.x, nose.y].map(|way| i8::from(way < 0.0) - i8::from(way > 0.0))
}
