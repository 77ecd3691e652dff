//! Contour definitions: lines by angle, alone or in pairs.
//!
//! Source: S 2.10 and 2.11 (docs/sources.md).

use crate::diag::{self, Diagnostic, Label, codes};
use crate::geo::open::{Coord, Data, Fault, NOT_FIXED, Rules, Start, solve};
use crate::geo::{Deg, Plane, Point2, SAME_POINT};
use crate::ir::contour::{Coords, Corner, Move, Path};
use crate::ir::{Function, Origin, Pos, Side};
use crate::machine::{Axis, AxisSet};
use crate::sema::chain::Angles;
use crate::sema::common::position::Position;
use crate::sema::run::Where;
use crate::text::{Loc, Span};

use super::g_groups::GCode;
use super::offsets::Outer;
use super::vocabulary::Address;
use super::words::{Mode, Words};
use super::{Channel, Core, Outcome, Reported, State};

/// By how much a line may run backwards: what rounding makes of none, in mm.
const BACK: f64 = 1e-9;

/// Two lines by their angles, or one and a coordinate: one solution, or none.
const RULES: Rules = Rules {
    agrees: f64::INFINITY,
    touch: SAME_POINT,
    smooth_touch: SAME_POINT,
    reach: |_| SAME_POINT,
    chord: None,
    one_coordinate: false,
    leaves_along: false,
};

fn line(angle: Deg) -> Data {
    Data { entry: Some(Angles::FromPlus.entry(angle)), ..Data::default() }
}

/// Where the line ends.
fn ended(at: Point2, data: &Data, next: Option<&Data>) -> Result<Point2, Fault> {
    let among = solve(&Start { at, dir: None, goes_on: false }, data, [next, None], &RULES)?;
    among.single().map(|solution| solution.solved.to).ok_or(NOT_FIXED)
}

/// First line of a pair: its end comes with the next block.
#[derive(Debug, Clone)]
struct FirstLine {
    angle: Deg,
    plane: Plane,
    rest: Pos,
    path: Path,
    side: Side,
    corner: Option<Corner>,
    origin: Origin,
    /// What the program did since; it comes behind the line.
    functions: Vec<(Function, Origin)>,
}

/// The two lines of a contour definition, of which the first waits for the second.
#[derive(Debug, Clone, Default)]
pub(super) struct Pair {
    first: Option<Box<FirstLine>>,
    /// The first line was refused.
    lost: bool,
}

impl Pair {
    #[inline]
    pub fn is_open(&self) -> bool {
        self.first.is_some()
    }

    /// The first line does not count, for a reason that was reported.
    pub fn drop_first(&mut self) {
        self.first = None;
    }

    /// A line with an angle was refused.
    pub fn lose(&mut self) {
        self.lost = true;
    }

    /// The first line is refused: where it stands.
    pub fn refuse_first(&mut self) -> Option<Origin> {
        let first = self.first.take()?;
        self.lost = true;
        Some(first.origin)
    }

    /// Refuses the first line for what `found` says of it.
    fn refuse(&mut self, core: &Core<'_>, position: &mut Position, found: impl FnOnce(Loc) -> Diagnostic) -> Outcome {
        let Some(first) = self.first.take() else { return Ok(()) };
        position.lose(AxisSet::MAIN);
        core.report(found(first.origin.loc));
        Err(Reported)
    }

    /// An interpolation that is no line behind the first line.
    pub fn only_lines(&mut self, core: &Core<'_>, position: &mut Position, span: Span) -> Outcome {
        self.refuse(core, position, |first| {
            let found = codes::S2070::second_line_of_pair_is_no_straight().at(core.loc(span));
            found.also(first, Label::FirstLine).help("program G0 or G1 in both blocks of a pair")
        })
    }

    /// Something that cannot stand between the two lines.
    pub fn must_be_done(&mut self, core: &Core<'_>, position: &mut Position, place: Where) -> Outcome {
        self.lost |= self.is_open();
        self.refuse(core, position, |first| {
            let found = codes::S2070::second_line_of_pair_is_missing().at(first);
            let found = found.also(core.loc(place), Label::ComesBefore);
            found.help("write the second line after the first: X… Y… ANG=…")
        })
    }

    /// The modal call belongs behind the first line, whose end is not known before the second.
    pub fn under_no_modal_call(&mut self, core: &Core<'_>, position: &mut Position) -> Outcome {
        self.lost |= self.is_open();
        self.refuse(core, position, |first| {
            let found = codes::S2070::first_line_of_pair_stands_under_mcall().at(first);
            found.help("program the end of the line, or end the modal call before by MCALL")
        })
    }

    /// Holds a function back while the first line waits for its end.
    pub fn holds(&mut self, function: &Function, origin: Origin) -> bool {
        let Some(first) = &mut self.first else { return false };
        first.functions.push((function.clone(), origin));
        true
    }

    /// From where increments of the second line count, from the start of the first or from the corner, is not confirmed.
    fn takes_no_increments(&mut self, core: &Core<'_>, g91: bool, w: &Words, axes: [Axis; 2]) -> Outcome {
        for given in axes.into_iter().filter_map(|axis| w.axis(axis)) {
            let incremental = match given.mode {
                Mode::Plain => g91,
                mode => matches!(mode, Mode::Ic | Mode::Dic | Mode::Ric),
            };
            if incremental {
                self.first = None;
                return core.refuse(given.span, codes::S2070::second_line_of_pair_is_programmed());
            }
        }
        Ok(())
    }
}

impl State {
    /// A line without an end waits for the line behind it.
    fn first_line(
        &mut self,
        core: &Core<'_>,
        angle: Deg,
        end: Pos,
        path: Path,
        corner: Option<&Corner>,
        span: Span,
    ) -> Outcome {
        let plane = self.plane();
        self.pair.lost = true;
        self.stands_in(core, plane, span)?;
        match self.offsets.outer() {
            Outer::Machine => {
                let message = "a contour definition cannot be printed in machine coordinates";
                return core.in_machine_only_lines(span, message);
            }
            Outer::Unrelated => return core.unrelated(span, "G500 stands beside"),
            Outer::Basic | Outer::Printed(_) => {}
        }
        self.pair.lost = false;
        self.pair.first = Some(Box::new(FirstLine {
            angle,
            plane,
            rest: end,
            path,
            side: self.side_of_move(),
            corner: corner.copied(),
            origin: core.here.origin,
            functions: Vec::new(),
        }));
        Ok(())
    }

    /// One end coordinate and the angle.
    fn one_coordinate(
        &self,
        core: &Core<'_>,
        end: &Pos,
        angle: Deg,
        plane: Plane,
        axes: [Axis; 2],
        span: Span,
    ) -> Outcome<Pos> {
        let start = self.stands_in(core, plane, span)?;
        let coord = |axis| end.get(axis).map_or(Coord::Open, Coord::At);
        let data = Data { x: coord(axes[0]), y: coord(axes[1]), ..line(angle) };
        let Ok(point) = ended(start, &data, None) else {
            return core.refuse(span, codes::S2070::end_coordinate_cannot_be_reached());
        };
        if (point - start).dot(&angle.unit()) < -BACK {
            return core.refuse(span, codes::S2070::end_coordinate_lies_behind_start());
        }
        let mut made = *end;
        made.set_in_plane(plane, point);
        Ok(made)
    }
}

impl Channel<'_> {
    /// A line with ANG, or the line behind one without an end.
    pub(super) fn angle_block(&mut self, w: &mut Words, path: Path, corner: Option<&Corner>) -> Outcome {
        let plane = self.st.plane();
        let [first, second, _] = self.st.roles();
        let named = [first, second].map(|axis| w.axes.contains(axis));
        let angle = w.take(Address::Ang);
        let lost = std::mem::take(&mut self.st.pair.lost);
        let Some(given) = angle else {
            let origin = self.st.pair.first.take().map(|pending| pending.origin);
            let found = codes::S2070::second_line_of_pair_has_no_ang().at(self.core.here.origin.loc);
            let found = match origin {
                Some(origin) => found.also(origin.loc, Label::FirstLine),
                None => found,
            };
            self.core.report(
                found.help("give the angle and both end coordinates of the second line, or the end of the first"),
            );
            return Err(Reported);
        };
        if self.st.pair.first.is_some() {
            self.st.pair.takes_no_increments(&self.core, self.st.is(GCode::G91), w, [first, second])?;
        }
        let end = self.st.targets(&self.core, w)?;
        let angle = Deg(given.value);
        match (named, self.st.pair.first.take()) {
            ([true, true], Some(pending)) => self.second_line(pending, angle, &end, path, given.span),
            (_, Some(pending)) => {
                let found = codes::S2070::second_line_of_pair_needs_both_end().at(self.core.loc(given.span));
                self.core.report(found.also(pending.origin.loc, Label::FirstLine));
                Err(Reported)
            }
            // The first line was refused.
            ([true, true], None) if lost => Err(Reported),
            ([true, true], None) => self.core.refuse(given.span, codes::S2070::both_end_coordinates()),
            ([false, false], None) => self.st.first_line(&self.core, angle, end, path, corner, given.span),
            _ => {
                let end = self.st.one_coordinate(&self.core, &end, angle, plane, [first, second], given.span)?;
                self.send(&end, path);
                Ok(())
            }
        }
    }

    fn second_line(&mut self, pending: Box<FirstLine>, angle: Deg, end: &Pos, path: Path, span: Span) -> Outcome {
        let refuse = |run: &Self, fault: diag::Fault| -> Outcome {
            run.core.report(fault.at(run.core.loc(span)).also(pending.origin.loc, Label::FirstLine));
            Err(Reported)
        };
        let (Some(start), Some(to)) = (self.st.position.in_plane(pending.plane), end.in_plane(pending.plane)) else {
            return Err(Reported);
        };
        let (u, v) = (pending.angle.unit(), angle.unit());
        let next = Data { x: Coord::At(to.x), y: Coord::At(to.y), ..line(angle) };
        let Ok(corner) = ended(start, &line(pending.angle), Some(&next)) else {
            return refuse(self, codes::S2070::two_lines_are_parallel());
        };
        let (first_way, second_way) = ((corner - start).dot(&u), (to - corner).dot(&v));
        if first_way < -BACK || second_way < -BACK {
            let which = if first_way < -BACK {
                "the first line would run backwards"
            } else {
                "the second line would run backwards"
            };
            return refuse(self, codes::S2070::lines_meet_behind_start(&which));
        }
        let mut first_end = pending.rest;
        first_end.set_in_plane(pending.plane, corner);
        let mv = Move { end: first_end, path: pending.path, side: pending.side, coords: Coords::Frame };
        self.core.send_move_of(&mv, &self.st.ctx, &pending.origin);
        self.st.position.move_to(&first_end);
        if let Some(corner) = &pending.corner {
            self.core.out.corner(corner, &self.st.ctx, &pending.origin);
        }
        for (function, origin) in &pending.functions {
            self.core.out.function(function, &self.st.ctx, origin);
        }
        self.send(end, path);
        Ok(())
    }
}
