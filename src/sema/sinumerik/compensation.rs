//! Radius compensation that the compiler computes: what the codes of the program say about the path of the centre.
//!
//! Comes in: G40 to G42 with the data of the edge, OFFN, DISC, and the codes of groups 17, 18, 21, 23, 40 and 48. Goes out:
//! the rules beside each move ([`ir::Compensation`]). The path itself is computed behind the frames (`docs/compensation.md`).
//!
//! Source: S 2.12, S 2.13 (docs/sources.md); docs/compensation.md.

use crate::diag::{Answer, codes};
use crate::geo::{Plane, Vec2};
use crate::ir;
use crate::ir::Side;
use crate::machine::Compensation;
use crate::sema::common::compensation::{compensate, edge_direction};
use crate::sema::run::Where;
use crate::text::Span;

use super::g_groups::{GCode, Group};
use super::value::{Val, whole};
use super::vocabulary::Address;
use super::words::{Given, Words};
use super::{Channel, Core, Outcome};

/// Types of tools from here on have cutting edges that are known by their position.
const TURNING_TOOLS: f64 = 500.0;

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
}

impl Channel<'_> {
    /// OFFN and DISC; in front of G41 and G42 of the block.
    pub(super) fn shape_words(&mut self, w: &mut Words) -> Outcome {
        if let Some(offn) = w.take(Address::Offn) {
            self.normal_offset(offn)?;
        }
        if let Some(disc) = w.take(Address::Disc) {
            if !(0.0..=100.0).contains(&disc.value) {
                return self.core.refuse(disc.span, codes::P1003::disc_lies_outside_0_to_100(&disc.value));
            }
            if self.core.resolves() {
                self.st.path.overshoot = disc.value;
            } else {
                self.core.says_shape(disc.span, "DISC=");
            }
        }
        Ok(())
    }

    fn normal_offset(&mut self, offn: Given) -> Outcome {
        let value = offn.value * self.st.length_unit();
        if !self.core.resolves() {
            if value == 0.0 {
                return Ok(());
            }
            return self.core.refuse(
                offn.span,
                codes::P9013::offset_of_tool_that_program_adds_cannot()
                    .answer(Answer::key("output", "compensation").one_of(&["\"resolve\""])),
            );
        }
        if value != self.st.path.normal && self.st.side() != Side::None && !self.st.compensation.waits() {
            return self.core.refuse(offn.span, codes::P9013::offn_changes_while_radius_compensation());
        }
        self.st.path.normal = value;
        Ok(())
    }

    /// G41 or G42, once the edge is known: the radius, and where the centre lies.
    pub(super) fn compute_compensation(&mut self, number: u32, edge: u32, radius: Option<f64>, span: Span) -> Outcome {
        let listed = || {
            let tool = self.core.job.settings.tools.called(number).filter(|_| edge == 1)?;
            Some(tool.radius? + tool.deltas[1])
        };
        let Some(radius) = radius.or_else(listed) else {
            return self.core.refuse(
                span,
                codes::P9013::radius_of_t_d_is_not_known(&number, &edge).answer(Answer::tool(number, "radius")),
            );
        };
        let nose = self.nose(number, edge, radius, span)?;
        let normal = self.st.path.normal;
        if normal != 0.0 && (radius + normal) * radius < 0.0 {
            return self.core.refuse(span, codes::P9013::offn_is_larger_than_radius_of_tool(&normal, &radius));
        }
        self.st.path.cutter = Some(Cutter { radius, nose });
        self.st.path.swaps = radius + normal < 0.0;
        Ok(())
    }

    /// G41 or G42 while one of them is on.
    pub(super) fn begins_again(&mut self, code: GCode, span: Span) -> Outcome {
        let old = self.st.codes.of(Group::Compensation);
        if old == GCode::G40 {
            // G40 has had no move at all: the contour goes on.
            let open = self.st.compensation.waits() && self.st.path.is_computed();
            return if open { self.core.refuse(span, codes::S2080::g40_in_front_has_had_no_move()) } else { Ok(()) };
        }
        if self.st.compensation.waits() {
            return Ok(());
        }
        let fault = if old == code {
            codes::P9013::is_on_already(&code.word())
        } else {
            codes::P9013::follows_without_g40(&code.word(), &old.word())
        };
        self.core.refuse(span, fault)
    }

    /// The program gives the compensation other rules, if it is computed.
    pub(super) fn rules_change(&mut self, w: &Words) -> Outcome {
        let (Some(cutter), true) = (self.st.path.cutter, self.core.resolves()) else { return Ok(()) };
        // The block of G40 is the last one that asks for them.
        if self.st.side() == Side::None && w.code_of(Group::Compensation).is_none() {
            return Ok(());
        }
        if let Some((code, span)) = w.code_of(Group::CompensationType).filter(|(code, _)| code.index > 2) {
            return self.core.refuse(span, codes::P9013::under_radius_is_compensated_in_space(&code.word()));
        }
        let place = w.codes.first().map_or(Where::Block, |(_, span)| (*span).into());
        self.check_corner_change(w);
        match self.rules(cutter, place) {
            Ok(rules) => {
                compensate(&mut self.st.ctx, rules);
                Ok(())
            }
            Err(reported) => {
                self.st.codes.activate(GCode::G40);
                self.st.compensation.begins_no_more();
                self.st.path.cutter = None;
                Err(reported)
            }
        }
    }

    fn rules(&self, cutter: Cutter, place: Where) -> Outcome<ir::Compensation> {
        let (rules, disc) =
            self.st.rules(cutter, self.core.job.settings).or_else(|fault| self.core.refuse(place, *fault))?;
        if let Some(fault) = disc {
            self.core.say_once(place, fault);
        }
        Ok(rules)
    }

    /// At which corner a change of G450 and G451 counts is not documented.
    fn check_corner_change(&self, w: &Words) {
        let Some((code, span)) = w.code_of(Group::Corner) else { return };
        let on = self.st.side() != Side::None && !self.st.compensation.waits();
        if !on || w.axes.is_empty() || !self.core.job.diags.first_time(codes::S8195, code.word()) {
            return;
        }
        let found = codes::S8195::stands_in_block_of_contour(&code.word()).at(self.core.loc(span));
        self.core.report(found.help("write it into a block without a move, before the element whose end it means"));
    }

    /// Where the edge points to from the centre of its nose, along Z and X: what a target is told with the radius.
    pub(super) fn edge_points_to(&self, number: u32, edge: u32, radius: f64, span: Span) -> Outcome<[i8; 2]> {
        let nose = self.nose(number, edge, radius.abs(), span)?;
        let sign = |way: f64| i8::from(way < 0.0) - i8::from(way > 0.0);
        Ok([sign(nose.x), sign(nose.y)])
    }

    /// Where the centre of the nose lies from the point that is programmed. In the plane ZX of a lathe only: a milling
    /// cutter is programmed by its centre.
    fn nose(&self, number: u32, edge: u32, radius: f64, span: Span) -> Outcome<Vec2> {
        let written = |parameter: u8| {
            let key = format!("$TC_DP{parameter}[{number},{edge}]");
            self.st.system.get(&key).and_then(Val::number)
        };
        let tool = self.core.job.settings.tools.called(number).filter(|_| edge == 1);
        let turns = match (written(1), tool.and_then(|tool| tool.kind.as_deref())) {
            (Some(kind), _) => kind >= TURNING_TOOLS,
            (None, Some(kind)) => !matches!(kind, "mill" | "drill" | "tap"),
            (None, None) => self.st.machine.lathe && self.st.plane() == Plane::Zx,
        };
        if !turns || radius == 0.0 {
            return Ok(Vec2::zeros());
        }
        if self.st.plane() != Plane::Zx {
            return self.core.refuse(span, codes::P9013::t_is_turning_tool(&number));
        }
        let position = self.edge_position(number, edge);
        let Some(way) = position.and_then(nose_of) else {
            let fault = match position {
                Some(position) => codes::P9013::is_no_position_of_edge(&position),
                None => codes::P9013::position_of_edge_is_not_known(&number, &edge)
                    .answer(Answer::tool(number, "orientation")),
            };
            return self.core.refuse(span, fault);
        };
        if way != Vec2::zeros() {
            let found =
                codes::S8194::cutting_edge_position(&position.unwrap_or(0.0), &(way.x * radius), &(way.y * radius))
                    .at(self.core.loc(span));
            self.core.report_once(found.help("compare it with the position in the tool data of the control"));
        }
        Ok(way * radius)
    }
}

impl Core<'_> {
    /// Does the compiler compute the path?
    #[inline]
    pub(super) fn resolves(&self) -> bool {
        self.job.settings.output.compensation == Compensation::Resolve
    }
}

/// Way from the tip to the centre of a nose of radius 1 along Z and X, by the position of the edge: seen with Z to the
/// right and X up.
pub(super) fn nose_of(position: f64) -> Option<Vec2> {
    let position = whole(position).and_then(|position| u8::try_from(position).ok())?;
    edge_direction(position).map(|to| Vec2::zeros() - to)
}
