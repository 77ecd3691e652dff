//! PLANE functions and cycle 19, and what M128 does while no rotary axis moves.
//!
//! Source: K 3.4 and 2.14, M 2 (docs/sources.md). A tilt by nothing is how CAM posts write 3-axis work for a machine with
//! rotary axes; a turn about the tool axis Z stays in the plane. What tilts is carried out in [`super::tilt`].

use libm::atan2;
use nalgebra::{Matrix3, Vector3};

use crate::diag::{Answer, Fault, codes};
use crate::geo::{Deg, rotation};
use crate::ir::contour::Path;
use crate::ir::tilt::Solution;
use crate::lexer::klartext::{QKind, QRef};
use crate::machine::Axis;
use crate::parser::klartext::ast::Block;
use crate::sema::run::Where;
use crate::text::{Span, decode::readable};

use super::block_text::block_name;
use super::cycle_definition::{Labelled, Open};
use super::reading::signed_number;
use super::tilt::{self, Positioning};
use super::vars::Slot;
use super::{Outcome, Reported, Run};

/// What stands behind PLANE.
#[derive(Debug, Default, PartialEq)]
struct Plane {
    kind: String,
    /// Words with a number: the data of the plane.
    data: Vec<(String, f64)>,
    /// STAY, TURN or MOVE.
    positioning: Option<String>,
    /// MB: the tool is retracted before the axes turn, by a way in mm or as far as it goes.
    retract: Option<Retraction>,
    /// How the rotary axes go, as written; not STAY, which moves nothing, nor COORD ROT, which is what is compiled.
    ways: Vec<String>,
    /// A word that is not known.
    open: bool,
}

/// What MB asks for.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Retraction {
    /// Nothing is written behind MB.
    Open,
    By(f64),
    Max,
}

/// What a plane does to the one before.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Effect {
    /// Nothing is tilted; the axes stand at this angle about Z.
    Turned(f64),
    /// Turned on by this angle.
    TurnedBy(f64),
    /// The table turns, and nobody knows about what.
    Table,
    Tilted,
    /// Nothing is tilted, but no manual page at hand settles by what the plane turns.
    Unsettled,
    /// MB, a word that is missing or not known.
    Open,
}

impl Plane {
    /// Reads the block; `parameter` gives the value of a number or a parameter with its sign.
    fn read(code: &str, parameter: &mut dyn FnMut(&str) -> Option<f64>) -> Plane {
        let mut plane = Plane::default();
        for (at, word) in code.split_whitespace().enumerate() {
            let (name, rest) = word.split_at(end_of_name(word));
            match (at, name, rest) {
                (0, "PLANE", "") => {}
                (1, kind, "") => plane.kind = kind.to_owned(),
                (_, "STAY" | "TURN" | "MOVE", "") if plane.positioning.is_none() => {
                    plane.positioning = Some(name.to_owned());
                    plane.ways.extend((name != "STAY").then(|| name.to_owned()));
                }
                // How fast, about which point, which solution.
                (_, "COORD" | "ROT", "") => {}
                (_, "TABLE", "") => plane.ways.push("TABLE ROT".to_owned()),
                (_, "FMAX" | "FAUTO", "") | (_, "SEQ" | "SYM", "+" | "-") => plane.ways.push(word.to_owned()),
                (_, "F" | "DIST" | "ABST", number) if signed_number(number).is_some() => {
                    plane.ways.push(word.to_owned())
                }
                (_, "MB", "") if plane.retract.is_none() => plane.retract = Some(Retraction::Open),
                (_, "MB", rest) if plane.retract.is_none() && signed_number(rest).is_some() => {
                    plane.retract = signed_number(rest).map(Retraction::By);
                }
                (_, "MAX", "") if plane.retract == Some(Retraction::Open) => plane.retract = Some(Retraction::Max),
                (_, "", way) if plane.retract == Some(Retraction::Open) && signed_number(way).is_some() => {
                    plane.retract = signed_number(way).map(Retraction::By);
                }
                _ => match parameter(rest) {
                    Some(number) => plane.data.push((name.to_owned(), number)),
                    None => plane.open = true,
                },
            }
        }
        plane
    }

    fn of(&self, name: &str) -> Option<f64> {
        self.data.iter().find(|(found, _)| found == name).map(|(_, number)| *number)
    }

    /// The values of exactly these words; `None` where one is missing, stands twice, or another stands there.
    fn exactly<const N: usize>(&self, names: [&str; N]) -> Option<[f64; N]> {
        let mut values = [0.0; N];
        for (name, value) in names.iter().zip(&mut values) {
            *value = self.of(name)?;
        }
        (self.data.len() == N).then_some(values)
    }

    /// Why [`Plane::effect`] is [`Effect::Open`].
    fn why_open(&self, name: &str) -> Fault {
        match (self.open, self.retract, self.kind.as_str()) {
            (true, ..) => codes::K9004::holds_word_that_is_not_known(&name),
            (_, Some(Retraction::Open), _) => codes::K9004::retracts_tool_by_mb(&name),
            (.., "SPATIAL") => codes::K9004::needs_each_of_spa_spb_spc(&name),
            (.., "EULER") => codes::K9004::needs_each_of_eulpr_eulnu_eulrot(&name),
            _ => codes::K9004::does_not_hold_words_of_this_plane(&name),
        }
    }

    fn effect(&self) -> Effect {
        let turned = |tilts: bool, angle: f64| if tilts { Effect::Tilted } else { Effect::Turned(angle) };
        let known = match self.kind.as_str() {
            _ if self.open || self.retract == Some(Retraction::Open) => None,
            "RESET" => self.data.is_empty().then_some(Effect::Turned(0.0)),
            // Half a turn about X and one about Y make one about Z.
            "SPATIAL" => self.exactly(["SPA", "SPB", "SPC"]).map(|[a, b, c]| match (within_turn(a), within_turn(b)) {
                (180.0, 180.0) => Effect::Turned(c + 180.0),
                (a, b) => turned(a != 0.0 || b != 0.0, c),
            }),
            // About Z, about the new X, about the new Z.
            "EULER" => {
                self.exactly(["EULPR", "EULNU", "EULROT"]).map(|[pr, nu, rot]| turned(within_turn(nu) != 0.0, pr + rot))
            }
            "RELATIVE" => match self.data.as_slice() {
                [(name, angle)] if name == "SPC" => Some(Effect::TurnedBy(*angle)),
                [(name, angle)] if name == "SPA" || name == "SPB" => {
                    Some(if within_turn(*angle) == 0.0 { Effect::TurnedBy(0.0) } else { Effect::Tilted })
                }
                _ => None,
            },
            "AXIAL" => {
                let axes = self.data.iter().all(|(name, _)| matches!(name.as_str(), "A" | "B" | "C"));
                let moved = |name: &str| self.of(name).is_some_and(|angle| angle != 0.0);
                (axes && !self.data.is_empty()).then(|| match (moved("A") || moved("B"), moved("C")) {
                    (true, _) => Effect::Tilted,
                    (false, true) => Effect::Table,
                    _ => Effect::Turned(0.0),
                })
            }
            // X of the plane lies along B, its normal along N.
            "VECTOR" => self.exactly(["BX", "BY", "BZ", "NX", "NY", "NZ"]).map(|[bx, by, _, nx, ny, nz]| {
                // What B has along the normal does not count.
                let upright = (nx, ny) == (0.0, 0.0) && nz > 0.0 && (bx, by) != (0.0, 0.0);
                turned(!upright, if by == 0.0 && bx > 0.0 { 0.0 } else { atan2(by, bx).to_degrees() })
            }),
            "PROJECTED" => self.exactly(["PROPR", "PROMIN", "ROT"]).map(|[first, second, turn]| match turn {
                _ if first != 0.0 || second != 0.0 => Effect::Tilted,
                0.0 => Effect::Turned(0.0),
                _ => Effect::Unsettled,
            }),
            // X of the plane lies along P1 to P2; the tool comes from the positive side.
            "POINTS" => self.points().and_then(|[p, q, r]| {
                rotation::of_points([p, q, r])?;
                let along = q - p;
                let upright = p.z == q.z && q.z == r.z;
                Some(turned(
                    !upright,
                    if along.y == 0.0 && along.x > 0.0 { 0.0 } else { atan2(along.y, along.x).to_degrees() },
                ))
            }),
            _ => None,
        };
        known.unwrap_or(Effect::Open)
    }

    fn points(&self) -> Option<[Vector3<f64>; 3]> {
        let [a, b, c, d, e, f, g, h, i] =
            self.exactly(["P1X", "P1Y", "P1Z", "P2X", "P2Y", "P2Z", "P3X", "P3Y", "P3Z"])?;
        Some([Vector3::new(a, b, c), Vector3::new(d, e, f), Vector3::new(g, h, i)])
    }

    /// The axes of the plane, where those in force lie along `base`.
    ///
    /// # Errors
    /// Why what it says is no plane, or is one only at the machine.
    fn axes(&self, name: &str, base: &Matrix3<f64>) -> Result<Matrix3<f64>, Fault> {
        let words = || self.data.iter().map(|(name, value)| format!("{name}{value:+}")).collect::<Vec<_>>().join(" ");
        let none = || codes::K9004::data_are_no_plane(&name, &words());
        match self.kind.as_str() {
            "RESET" => Ok(Matrix3::identity()),
            "SPATIAL" => self.exactly(["SPA", "SPB", "SPC"]).map(rotation::spatial).ok_or_else(none),
            "EULER" => self.exactly(["EULPR", "EULNU", "EULROT"]).map(rotation::euler).ok_or_else(none),
            "RELATIVE" => match self.data.as_slice() {
                [(name, angle)] => {
                    let axis = ["SPA", "SPB", "SPC"].iter().position(|known| known == name).ok_or_else(none)?;
                    Ok(base * rotation::about(axis, Deg(*angle)))
                }
                _ => Err(none()),
            },
            "VECTOR" => {
                let [bx, by, bz, nx, ny, nz] = self.exactly(["BX", "BY", "BZ", "NX", "NY", "NZ"]).ok_or_else(none)?;
                let (base, normal) = (Vector3::new(bx, by, bz), Vector3::new(nx, ny, nz));
                let axes = rotation::of_vectors(base, normal).ok_or_else(none)?;
                // What a control makes of vectors at another angle differs by its generation.
                if (base.dot(&normal) / (base.norm() * normal.norm())).abs() > SQUARE {
                    return Err(codes::K9004::vectors_are_not_perpendicular(&name, &words()));
                }
                Ok(axes)
            }
            "POINTS" => self.points().and_then(rotation::of_points).ok_or_else(none),
            // The signs of the one, and the axes of the other, are known at the machine.
            _ => Err(codes::K9004::tilts_working_plane(&name, &words())),
        }
    }

    /// Which solution SEQ demands.
    ///
    /// # Errors
    /// SYM, whose sides lie about a point of the machine.
    fn solution(&self, name: &str) -> Result<Solution, Fault> {
        let has = |word: &str| self.ways.iter().any(|way| way == word);
        match (has("SEQ+"), has("SEQ-")) {
            _ if has("SYM+") || has("SYM-") => Err(codes::K9004::sym_counts_from_point_of_machine(&name)),
            (true, true) => Err(codes::K9004::does_not_hold_words_of_this_plane(&name)),
            (false, false) => Ok(Solution::Control),
            (positive, _) => Ok(Solution::Primary { positive }),
        }
    }

    /// What the rotary axes do.
    ///
    /// # Errors
    /// MOVE, or none of the three words.
    fn positioning(&self, name: &str) -> Result<Positioning, Fault> {
        match self.positioning.as_deref() {
            Some("STAY") => Ok(Positioning::Stay),
            Some("TURN") => Ok(Positioning::Turn),
            Some(_) => Err(codes::K9004::moves_tool_while_axes_turn(&name)),
            None => Err(codes::K9004::names_none_of_stay_turn_move(&name)),
        }
    }
}

/// Cosine of the angle between two vectors that count as perpendicular.
const SQUARE: f64 = 0.001;

/// 0 to 360, without whole turns.
fn within_turn(angle: f64) -> f64 {
    angle.rem_euclid(360.0)
}

/// `SPA` of `SPA+20`, `P1X` of `P1X+0`.
fn end_of_name(word: &str) -> usize {
    let letters =
        |from: usize| word[from..].find(|c: char| !c.is_ascii_alphabetic()).map_or(word.len(), |length| from + length);
    match word.as_bytes() {
        [b'P', b'1'..=b'3', b'X' | b'Y' | b'Z', ..] => letters(2),
        _ => letters(0),
    }
}

/// Would the block be refused for what it does to the plane?
pub(super) fn tilts(code: &[u8]) -> bool {
    let plane = Plane::read(&readable(code).to_ascii_uppercase(), &mut signed_number);
    match plane.effect() {
        Effect::Turned(_) | Effect::TurnedBy(_) => false,
        Effect::Tilted => {
            plane.axes("", &Matrix3::identity()).is_err()
                || plane.positioning("").is_err()
                || plane.solution("").is_err()
        }
        Effect::Table | Effect::Unsettled | Effect::Open => true,
    }
}

impl Run<'_> {
    /// A PLANE block. Nothing that tilts was active before.
    pub(super) fn plane_block(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let code = readable(block.span.of(text)).to_ascii_uppercase();
        let mut lost = false;
        let plane = Plane::read(&code, &mut |rest| match self.reading().written(rest, block.span)? {
            Ok(value) => Some(value),
            Err(Reported) => {
                lost = true;
                None
            }
        });
        if lost {
            self.st.lose_all(&mut self.core);
            return Err(Reported);
        }
        let (name, span) = block_name(block, text, 2);
        let effect = plane.effect();
        if let Some(way) = plane.retract.filter(|way| *way != Retraction::Open)
            && !matches!(effect, Effect::Open)
        {
            self.retract_before_plane(way, &plane, &name, span)?;
        }
        let tilts = matches!(effect, Effect::Tilted);
        if tilts || !self.st.tilt.is_upright() && !matches!(effect, Effect::Open) {
            return self.tilting_block(&plane, &name, span);
        }
        let angle = match effect {
            Effect::Turned(angle) => Ok(angle),
            Effect::TurnedBy(angle) => Ok(self.st.frames.transform().turn.0 + angle),
            Effect::Table => Err(codes::K9004::sets_rotary_table_to_angle(&name)),
            Effect::Unsettled => Err(codes::K9004::turns_plane_by_unsettled_words(&name)),
            Effect::Tilted | Effect::Open => Err(plane.why_open(&name)),
        };
        let angle = match angle {
            Ok(angle) => angle,
            Err(fault) => return self.st.refuse_motion(&mut self.core, span, fault),
        };
        let moves = plane.positioning.as_deref().is_some_and(|word| word != "STAY");
        self.turn_plane(&name, angle, (moves, plane.positioning.as_deref() == Some("TURN")), &plane.ways)
    }

    /// A PLANE block that tilts, or ends a plane that is tilted.
    fn tilting_block(&mut self, plane: &Plane, name: &str, span: Span) -> Outcome {
        let base = match self.st.tilt.plane() {
            Some(tilt) => tilt.axes,
            None => rotation::about(2, self.st.frames.transform().turn),
        };
        let what = plane.axes(name, &base).and_then(|axes| {
            // A plane that ends by RESET says how, and which solution does not matter.
            Ok((axes, plane.positioning(name)?, plane.solution(name)?))
        });
        let (axes, positioning, solution) = match what {
            Ok(what) => what,
            Err(fault) => return self.st.refuse_motion(&mut self.core, span, fault),
        };
        match tilt::upright(&axes) {
            Some(angle) => self.tilt_back(angle, positioning, span.into()),
            None => self.tilt_into(axes, solution, positioning, span.into()),
        }
    }

    /// MB: the tool goes back along its axis before rotary axes turn.
    fn retract_before_plane(&mut self, way: Retraction, plane: &Plane, name: &str, span: Span) -> Outcome {
        let what = format!("{name} … MB");
        let feed = plane.ways.iter().find_map(|way| way.strip_prefix('F')).map(str::to_owned);
        let path = match feed.as_deref() {
            Some("MAX") => Path::Rapid,
            Some(number) if signed_number(number).is_some_and(|feed| feed > 0.0) => {
                let feed = signed_number(number).unwrap_or_default();
                Path::Line(self.st.feed.counted(feed, self.core.unit()))
            }
            _ => return self.st.refuse_motion(&mut self.core, span, codes::K9004::retracts_at_open_feed(&name)),
        };
        let way = match way {
            Retraction::By(way) => Some(way * self.core.mm()),
            Retraction::Max | Retraction::Open => None,
        };
        self.retract_by(&what, way, path, span)
    }

    /// Cycle 19. Its angles are space angles, or those of rotary axes: what it is on this machine is configured.
    pub(super) fn tilt(&mut self, open: &Open) -> Outcome {
        let angle = |axis| open.axes.iter().find(|at| at.axis == axis).and_then(|at| at.value).unwrap_or(0.0);
        let tilted = open.axes.iter().any(|at| at.axis != Axis::C && at.value.unwrap_or(0.0) != 0.0);
        let turn = angle(Axis::C);
        if tilted || !self.st.tilt.is_upright() {
            return self.tilting_cycle(open, [angle(Axis::A), angle(Axis::B), turn]);
        }
        if turn != 0.0 {
            if self.core.job.settings.control.klartext_choices.cycle_19_axes {
                return self.core.refuse(Where::Block, codes::K9004::cycle_19_sets_rotary_table_to_angle());
            }
            let fault = codes::K8020::c_of_cycle_19_is_read(&turn).answer(Answer::key("control", "cycle_19"));
            self.core.note(Where::Block, fault);
        }
        // Whether the rotary axes are positioned at once is up to the machine; the tool does not follow them.
        let moves = turn != self.st.frames.transform().turn.0;
        let word = |value: &Labelled| match value.label.as_str() {
            "FMAX" => "FMAX".to_owned(),
            label => format!("{label}{}", value.value),
        };
        let ways: Vec<String> = open.values.iter().map(word).collect();
        self.turn_plane("cycle 19", turn, (moves, moves), &ways)
    }

    /// Cycle 19 that tilts, or ends a plane that is tilted: it defines the plane, and a block of its own turns the axes.
    fn tilting_cycle(&mut self, open: &Open, angles: [f64; 3]) -> Outcome {
        let [a, b, c] = angles;
        let all = [Axis::A, Axis::B, Axis::C].iter().all(|axis| open.axes.iter().any(|at| at.axis == *axis));
        let fault = if self.core.job.settings.control.klartext_choices.cycle_19_axes {
            Some(codes::K9004::cycle_19_tilts_working_plane_by_b(&a, &b, &c))
        } else if !(all || open.axes.is_empty()) {
            Some(codes::K9004::cycle_19_leaves_angle_open())
        } else if !open.values.is_empty() {
            Some(codes::K9004::cycle_19_turns_axes_by_itself())
        } else {
            None
        };
        if let Some(fault) = fault {
            return self.st.refuse_motion(&mut self.core, Where::Block, fault);
        }
        let axes = rotation::spatial(angles);
        match tilt::upright(&axes) {
            Some(angle) => self.tilt_back(angle, Positioning::Stay, Where::Block),
            None => self.tilt_into(axes, Solution::Control, Positioning::Stay, Where::Block),
        }
    }

    /// The working plane stands at `angle` about Z from here on. With `moves` the control may turn the table to it, and
    /// with `leaves` the tool does not follow; `ways` are the words that say how.
    fn turn_plane(&mut self, name: &str, angle: f64, (moves, leaves): (bool, bool), ways: &[String]) -> Outcome {
        let angle = if Deg(angle).normal().0 == 0.0 { 0.0 } else { angle };
        let before = self.st.frames.transform().turn.0;
        if moves || angle != 0.0 {
            if !self.st.rotary.stands_upright(&self.st.position, &self.st.ctx.frame) {
                let fault = codes::K9004::moves_rotary_axes_turned_by_program(&name);
                let span = self.core.block_span();
                return self.st.refuse_motion(&mut self.core, span, fault);
            }
            if angle == 0.0 && before == 0.0 {
                self.core.note(Where::Block, codes::K2512::rotary_axes_are_taken_to_stand());
            }
        }
        if angle != 0.0 && self.st.axis() != Axis::Z {
            let fault = codes::K9004::turns_about_z(&name, &self.st.axis().letter());
            let span = self.core.block_span();
            return self.st.refuse_motion(&mut self.core, span, fault);
        }
        let here = self.core.here.origin.loc;
        for number in 120..=122 {
            // Which axis takes the turn, or none, is known at the machine.
            let q = QRef { kind: QKind::Q, number };
            let slot = if angle == 0.0 { Slot::Number(0.0) } else { Slot::AtMachine(here) };
            self.vars.put(&mut self.core, q, slot);
        }
        if angle == before {
            return Ok(());
        }
        if let Err(fault) = self.st.frames.may_turn() {
            return self.st.refuse_motion(&mut self.core, Where::Block, fault);
        }
        self.st.refuse_compensated(&mut self.core, "the working plane turns");
        if self.st.compensation.is_on() {
            self.core.report(codes::P2041::turn_of_plane_ends_radius_compensation().at(here));
            self.st.end_compensation();
        }
        if angle != 0.0 {
            let ways = match ways {
                [] => String::new(),
                ways => {
                    format!("; {}, which tells the control how to turn its axes, has no effect here", ways.join(" "))
                }
            };
            self.core.report(codes::K2853::turns_coordinates_by_about_z(&name, &angle, &ways).at(here));
        }
        let mut next = self.st.frames.transform().clone();
        next.turn = Deg(angle);
        next.shifted_in_turn = false;
        self.set_transformation(next)?;
        if leaves {
            // The part turns away from under the tool, or not: both axes have to be named again.
            self.st.position.forget([Axis::X, Axis::Y].into_iter().collect());
            self.st.polar.forget_last();
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_that_tilt_nothing() {
        for code in [
            "PLANE SPATIAL SPA+0 SPB+0 SPC+0 STAY",
            "plane spatial spa+0 spb-0 spc+0,0 turn fmax seq- table rot",
            "PLANE VECTOR BX1 BY0 BZ0 NX0 NY0 NZ1 STAY SEQ- TABLE ROT",
            "PLANE EULER EULPR+0 EULNU+0 EULROT+0 MOVE DIST50 F800",
            "PLANE AXIAL B+0 STAY",
            "PLANE RELATIVE SPB+0 STAY",
            "PLANE RESET TURN FMAX",
            "PLANE PROJECTED PROPR+0 PROMIN+0 ROT+0 STAY",
        ] {
            assert!(!tilts(code.as_bytes()), "{code}");
        }
        for code in [
            "PLANE SPATIAL SPA+0 SPB+0 STAY",
            "PLANE AXIAL C+30 STAY",
            "PLANE SPATIAL SPA+0 SPB+0 SPC+Q1 STAY",
            "PLANE PROJECTED PROPR+0 PROMIN+0 ROT+5 STAY",
            "PLANE POINTS P1X+0 P1Y+0 P1Z+0 P2X+20 P2Y+0 P2Z+0 P3X+40 P3Y+0 P3Z+0 STAY",
        ] {
            assert!(tilts(code.as_bytes()), "{code}");
        }
        for code in [
            "PLANE SPATIAL SPA+0 SPB+10 SPC+0 STAY",
            "PLANE VECTOR BX1 BY0 BZ0 NX0 NY0 NZ-1 TURN FMAX",
            "PLANE POINTS P1X+0 P1Y+0 P1Z+0 P2X+20 P2Y+0 P2Z+5 P3X+0 P3Y+20 P3Z+0 STAY",
            "PLANE RESET TURN MB MAX FMAX",
        ] {
            assert!(!tilts(code.as_bytes()), "{code}");
        }
        for code in ["PLANE SPATIAL SPA+0 SPB+10 SPC+0 MOVE DIST50 F500", "PLANE SPATIAL SPA+0 SPB+10 SPC+0 TURN SYM+"]
        {
            assert!(tilts(code.as_bytes()), "{code}");
        }
    }

    #[test]
    fn turns_about_the_tool_axis() {
        let effect = |code: &str| Plane::read(code, &mut signed_number).effect();
        assert_eq!(effect("PLANE SPATIAL SPA+0 SPB+0 SPC+30 TURN FMAX"), Effect::Turned(30.0));
        assert_eq!(effect("PLANE SPATIAL SPA+360 SPB-360 SPC+30 STAY"), Effect::Turned(30.0));
        assert_eq!(effect("PLANE SPATIAL SPA-180 SPB+180 SPC+30 STAY"), Effect::Turned(210.0));
        assert_eq!(effect("PLANE EULER EULPR+50 EULNU+0 EULROT-20 STAY"), Effect::Turned(30.0));
        assert_eq!(effect("PLANE RELATIVE SPC-15 STAY"), Effect::TurnedBy(-15.0));
        assert_eq!(effect("PLANE VECTOR BX-1 BY0 BZ0 NX0 NY0 NZ1 STAY"), Effect::Turned(180.0));
        assert_eq!(effect("PLANE AXIAL C+30 STAY"), Effect::Table);
        let points = "PLANE POINTS P1X+5 P1Y+0 P1Z+2 P2X+5 P2Y+20 P2Z+2 P3X-15 P3Y+0 P3Z+2 STAY";
        assert_eq!(effect(points), Effect::Turned(90.0));
        assert_eq!(effect("PLANE PROJECTED PROPR+0 PROMIN+0 ROT+5 STAY"), Effect::Unsettled);
        assert_eq!(effect("PLANE AXIAL B+0 C+0 STAY"), Effect::Turned(0.0));
    }
}
