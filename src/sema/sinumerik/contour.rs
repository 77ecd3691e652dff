//! Contour definitions: lines by angle, chamfers and roundings.
//!
//! Source: S 2.10 and 2.11 (docs/sources.md).

use crate::diag::{Diagnostic, codes};
use crate::geo::open::{Coord, Data, Fault, NOT_FIXED, Rules, Start, solve};
use crate::geo::{Deg, Plane, Point2, SAME_POINT};
use crate::ir::contour::{ArcChamfer, Blocks, Coords, Corner, CornerShape, LargeCorner, Move, Path};
use crate::ir::{Feed, Function, Origin, Pos, Side};
use crate::machine::{Axis, AxisSet};
use crate::sema::chain::Angles;
use crate::sema::common::corner::OpenCorner;
use crate::sema::run::Where;
use crate::text::Span;

use super::g_groups::Code;
use super::offsets::Outer;
use super::vocabulary::Address;
use super::words::{Mode, Words};
use super::{Outcome, Reported, Run};

/// Blocks without a move over which the control looks for the end of a corner (MD 20200).
const MOST_BETWEEN: u32 = 3;

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
struct Pending {
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
    first: Option<Box<Pending>>,
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
}

/// Chamfers and roundings.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Corners {
    /// RNDM in mm, 0 for none.
    rounding: f64,
    /// FRCM
    feed: Option<Feed>,
    /// A corner that waits for its second line.
    pub open: OpenCorner,
}

impl Corners {
    /// Radius of the rounding that holds on, in mm; 0 for none.
    pub fn rounding(&self) -> f64 {
        self.rounding
    }

    /// Feed of corners that holds on.
    pub fn feed(&self) -> Option<Feed> {
        self.feed
    }
}

impl Run<'_> {
    /// A line with ANG, or the line behind one without an end.
    pub(super) fn angle_block(&mut self, w: &mut Words, path: Path, corner: Option<&Corner>) -> Outcome {
        let plane = self.st.plane();
        let [first, second, _] = self.st.roles();
        let named = [first, second].map(|axis| w.axes.contains(axis));
        let angle = w.take(Address::Ang);
        let lost = std::mem::take(&mut self.st.pair.lost);
        let Some(given) = angle else {
            let origin = self.st.pair.first.take().map(|pending| pending.origin);
            let found = Diagnostic::new(
                codes::S2070.alarm(10794),
                self.here.origin.loc,
                "the second line of the pair has no ANG",
            );
            let found = match origin {
                Some(origin) => found.also(origin.loc, "the first line"),
                None => found,
            };
            self.report(
                found.help("give the angle and both end coordinates of the second line, or the end of the first"),
            );
            return Err(Reported);
        };
        if self.st.pair.first.is_some() {
            self.pair_without_increments(w, [first, second])?;
        }
        let end = self.targets(w)?;
        let angle = Deg(given.value);
        match (named, self.st.pair.first.take()) {
            ([true, true], Some(pending)) => self.second_line(pending, angle, &end, path, given.span),
            (_, Some(pending)) => {
                let found = Diagnostic::new(
                    codes::S2070.alarm(10794),
                    self.loc(given.span),
                    "the second line of the pair needs both end coordinates",
                );
                self.report(found.also(pending.origin.loc, "the first line"));
                Err(Reported)
            }
            // The first line was refused.
            ([true, true], None) if lost => Err(Reported),
            ([true, true], None) => self.fail_help(
                codes::S2070.alarm(10795),
                given.span,
                "both end coordinates and an angle say too much",
                "leave ANG out; only the second line of a pair has all three",
            ),
            ([false, false], None) => {
                self.st.pair.lost = true;
                if self.st.position.in_plane(plane).is_none() {
                    let axis = if self.st.position.get(first).is_none() { first } else { second };
                    return self.unknown_axis(axis, given.span);
                }
                match self.st.offsets.outer() {
                    Outer::Machine => {
                        let message = "a contour definition cannot be printed in machine coordinates";
                        return self.in_machine_only_lines(given.span, message);
                    }
                    Outer::Unrelated => return self.unrelated(given.span, "G500 stands beside"),
                    Outer::Basic | Outer::Printed(_) => {}
                }
                self.st.pair.lost = false;
                self.st.pair.first = Some(Box::new(Pending {
                    angle,
                    plane,
                    rest: end,
                    path,
                    side: self.st.side_of_move(),
                    corner: corner.copied(),
                    origin: self.here.origin,
                    functions: Vec::new(),
                }));
                Ok(())
            }
            _ => {
                let end = self.one_coordinate(&end, angle, plane, [first, second], given.span)?;
                self.send(&end, path);
                Ok(())
            }
        }
    }

    /// From where increments of the second line count, from the start of the first or from the corner, is not confirmed.
    fn pair_without_increments(&mut self, w: &Words, axes: [Axis; 2]) -> Outcome {
        for given in axes.into_iter().filter_map(|axis| w.axis(axis)) {
            let incremental = match given.mode {
                Mode::Plain => self.st.is(Code::G91),
                mode => matches!(mode, Mode::Ic | Mode::Dic | Mode::Ric),
            };
            if incremental {
                self.st.pair.first = None;
                return self.fail_help(
                    codes::S2070,
                    given.span,
                    "the second line of the pair is programmed by increments, and from where they count is not documented",
                    "program its end point in absolute coordinates: G90, or AC(…)",
                );
            }
        }
        Ok(())
    }

    /// An interpolation that is no line behind the first line of a pair.
    pub(super) fn only_lines_in_a_pair(&mut self, span: Span) -> Outcome {
        let Some(pending) = self.st.pair.first.take() else { return Ok(()) };
        self.st.position.lose(AxisSet::MAIN);
        let message = "the second line of the pair is no straight line";
        let found = Diagnostic::new(codes::S2070.alarm(10792), self.loc(span), message);
        self.report(found.also(pending.origin.loc, "the first line").help("program G0 or G1 in both blocks of a pair"));
        Err(Reported)
    }

    /// One end coordinate and the angle.
    fn one_coordinate(&mut self, end: &Pos, angle: Deg, plane: Plane, axes: [Axis; 2], span: Span) -> Outcome<Pos> {
        let Some(start) = self.st.position.in_plane(plane) else {
            let axis = if self.st.position.get(axes[0]).is_none() { axes[0] } else { axes[1] };
            return self.unknown_axis(axis, span);
        };
        let coord = |axis| end.get(axis).map_or(Coord::Open, Coord::At);
        let data = Data { x: coord(axes[0]), y: coord(axes[1]), ..line(angle) };
        let Ok(point) = ended(start, &data, None) else {
            return self.fail_help(
                codes::S2070.alarm(10795),
                span,
                "the end coordinate cannot be reached at this angle",
                "the line runs at a right angle to the axis of the end coordinate",
            );
        };
        if (point - start).dot(&angle.unit()) < -BACK {
            return self.fail_help(
                codes::S2070.alarm(10795),
                span,
                "the end coordinate lies behind the start, seen along the angle",
                "turn the angle by 180 degrees, or check the end coordinate",
            );
        }
        let mut made = *end;
        made.set_in_plane(plane, point);
        Ok(made)
    }

    fn second_line(&mut self, pending: Box<Pending>, angle: Deg, end: &Pos, path: Path, span: Span) -> Outcome {
        let first = Diagnostic::new(codes::S2070.alarm(10791), self.loc(span), "");
        let refuse = |run: &Self, message: &str, help: &str| -> Outcome {
            let found = Diagnostic { message: message.to_owned(), ..first.clone() };
            run.report(found.also(pending.origin.loc, "the first line").help(help));
            Err(Reported)
        };
        let (Some(start), Some(to)) = (self.st.position.in_plane(pending.plane), end.in_plane(pending.plane)) else {
            return Err(Reported);
        };
        let (u, v) = (pending.angle.unit(), angle.unit());
        let next = Data { x: Coord::At(to.x), y: Coord::At(to.y), ..line(angle) };
        let Ok(corner) = ended(start, &line(pending.angle), Some(&next)) else {
            return refuse(self, "the two lines are parallel and have no corner", "check the two angles");
        };
        let (first_way, second_way) = ((corner - start).dot(&u), (to - corner).dot(&v));
        if first_way < -BACK || second_way < -BACK {
            let which = if first_way < -BACK {
                "the first line would run backwards"
            } else {
                "the second line would run backwards"
            };
            return refuse(
                self,
                &format!("the lines meet behind the start: {which}"),
                "turn that angle by 180 degrees, or check the end point",
            );
        }
        let mut first_end = pending.rest;
        first_end.set_in_plane(pending.plane, corner);
        let mv = Move { end: first_end, path: pending.path, side: pending.side, coords: Coords::Frame };
        self.core.out.movement(&mv, &self.st.ctx, &pending.origin);
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

    /// Something that cannot stand between the two lines of a pair.
    pub(super) fn pending_must_be_done(&mut self, place: impl Into<Where>) -> Outcome {
        self.stored_must_be_done()?;
        let Some(pending) = self.st.pair.first.take() else { return Ok(()) };
        self.st.pair.lost = true;
        let found =
            Diagnostic::new(codes::S2070.alarm(10793), pending.origin.loc, "the second line of the pair is missing");
        self.report(
            found
                .also(self.loc(place), "this comes before it")
                .help("write the second line behind the first: X… Y… ANG=…"),
        );
        self.st.position.lose(AxisSet::MAIN);
        Err(Reported)
    }

    /// The modal call belongs behind the first line of a pair, whose end is not known before the second.
    pub(super) fn no_pair_under_a_modal_call(&mut self) -> Outcome {
        let Some(pending) = self.st.pair.first.take() else { return Ok(()) };
        self.st.pair.lost = true;
        self.st.position.lose(AxisSet::MAIN);
        let message = "the first line of a pair stands under MCALL, and the call would come before its end is known";
        let found = Diagnostic::new(codes::S2070, pending.origin.loc, message);
        self.report(found.help("program the end of the line, or end the modal call before by MCALL"));
        Err(Reported)
    }

    /// Holds a function back while the first line of a pair waits for its end.
    pub(super) fn held_back(&mut self, function: &Function) -> bool {
        let origin = self.here.origin;
        match &mut self.st.pair.first {
            Some(pending) => {
                pending.functions.push((function.clone(), origin));
                true
            }
            None => false,
        }
    }

    // Corners.

    pub(super) fn has_corner_words(&self, w: &Words) -> bool {
        [Address::Rnd, Address::Chf, Address::Chr, Address::Frc].iter().any(|address| w.get(*address).is_some())
    }

    pub(super) fn no_corner(&self, span: Span) -> Outcome<bool> {
        self.fail_help(
            codes::S2071.alarm(10882),
            span,
            "a chamfer or rounding stands in a block that does not move",
            "write it into the block that leads to the corner",
        )
    }

    /// RNDM and FRCM.
    pub(super) fn modal_contour_words(&mut self, w: &mut Words) -> Outcome {
        if let Some(rndm) = w.take(Address::Rndm) {
            if rndm.value < 0.0 {
                return self.negative(rndm.span);
            }
            self.st.corners.rounding = rndm.value * self.st.length_unit();
        }
        if let Some(frcm) = w.take(Address::Frcm) {
            if frcm.value < 0.0 {
                return self.fail(codes::S2041.alarm(14800), frcm.span, "the feed FRCM= is negative");
            }
            self.st.corners.feed = (frcm.value > 0.0).then(|| self.st.feed_of(frcm.value));
        }
        Ok(())
    }

    fn negative<T>(&self, span: Span) -> Outcome<T> {
        self.fail(codes::S2071.alarm(16500), span, "a chamfer or rounding is negative")
    }

    /// The corner that the block asks for at its end.
    pub(super) fn corner_words(&mut self, w: &mut Words) -> Outcome<Option<Corner>> {
        if !self.has_corner_words(w) && self.st.corners.rounding == 0.0 {
            return Ok(None);
        }
        if self.st.is(Code::G93) {
            let corner = [Address::Rnd, Address::Chr, Address::Chf, Address::Frc].iter().find_map(|a| w.get(*a));
            let span = corner.map(|given| given.span).unwrap_or_default();
            return self.not_by_time(span, "a chamfer or rounding has no share of the time that G93 gives the blocks");
        }
        let (rnd, chr, chf, frc) =
            (w.take(Address::Rnd), w.take(Address::Chr), w.take(Address::Chf), w.take(Address::Frc));
        for given in [rnd, chr, chf].into_iter().flatten() {
            if given.value < 0.0 {
                return self.negative(given.span);
            }
        }
        let unit = self.st.length_unit();
        // A rounding goes before a chamfer in the same block.
        if let (Some(_), Some(other)) = (rnd, chr.or(chf)) {
            let found = Diagnostic::new(
                codes::S8008,
                self.loc(other.span),
                "RND and a chamfer stand in one block: only RND counts",
            );
            self.report(found.help("delete one of them"));
        }
        if let (Some(_), Some(chf)) = (chr, chf) {
            return self.fail_help(codes::S2071, chf.span, "CHR and CHF stand in one block", "keep one of them");
        }
        let explicit = rnd.is_some() || chr.is_some() || chf.is_some();
        let shape = match (rnd, chr, chf) {
            (Some(rnd), _, _) => CornerShape::Rounding { radius: rnd.value * unit },
            (None, Some(chr), _) => CornerShape::Chamfer { side: chr.value * unit },
            (None, None, Some(chf)) => CornerShape::ChamferLength { length: chf.value * unit },
            (None, None, None) => CornerShape::Rounding { radius: self.st.corners.rounding },
        };
        let feed = match frc {
            Some(frc) if frc.value > 0.0 => Some(self.st.feed_of(frc.value)),
            Some(frc) => return self.fail(codes::S2041.alarm(14800), frc.span, "the feed FRC= is not above 0"),
            None => self.modal_corner_feed()?,
        };
        if !explicit && self.st.corners.rounding == 0.0 {
            return self.fail_help(
                codes::S2071,
                frc.map(|given| given.span).unwrap_or_default(),
                "FRC= stands without a chamfer or rounding",
                "give RND=, CHR= or CHF= in the same block",
            );
        }
        let size = match shape {
            CornerShape::Rounding { radius } => radius,
            CornerShape::Chamfer { side } => side,
            CornerShape::ChamferLength { length } => length,
            CornerShape::Undercut(_) => 0.0,
        };
        let (large, at_arc, blocks) = (self.large_corner(), self.arc_chamfer(), Blocks::PassedOver);
        Ok((size > 0.0).then_some(Corner { shape, feed, early: true, modal: !explicit, large, at_arc, blocks }))
    }

    /// FRCM, which counts as the feeds did where it was programmed.
    pub(super) fn modal_corner_feed(&self) -> Outcome<Option<Feed>> {
        let fits = self.st.corners.feed.is_none_or(|feed| self.st.counts_as(feed));
        if fits {
            return Ok(self.st.corners.feed);
        }
        let message = "the kind of feed has changed since FRCM=, whose value counts in the other one";
        let help = "program FRCM= again behind G94, G95 and G96, or FRCM=0";
        self.fail_help(codes::S2040.alarm(10860), Where::Block, message, help)
    }

    /// What the control does with a corner that does not fit.
    pub(super) fn large_corner(&self) -> LargeCorner {
        if self.job.settings.control.siemens.shorten_corners { LargeCorner::Shorten } else { LargeCorner::Ask }
    }

    pub(super) fn arc_chamfer(&self) -> ArcChamfer {
        if self.job.settings.control.siemens.arc_chamfers { ArcChamfer::AcrossBisector } else { ArcChamfer::Ask }
    }

    pub(super) fn send_corner(&mut self, corner: Option<Corner>) {
        let Some(corner) = corner else { return };
        // A modal rounding is for moves that cut.
        if corner.modal && self.st.is(Code::G0) {
            return;
        }
        if self.st.stored.is_some() {
            self.st.note_stored_corner(&corner);
        }
        self.core.send_corner(&corner, &self.st.ctx);
        if !corner.modal {
            self.st.corners.open.open(self.here.origin.loc);
        }
    }

    /// A block without a move behind a corner: the control looks ahead over a few of them only (MD 20200).
    pub(super) fn block_behind_corner(&mut self, moved: bool) -> Outcome {
        if moved {
            return Ok(());
        }
        let Some(loc) = self.st.corners.open.wait(MOST_BETWEEN) else { return Ok(()) };
        let message = format!("more than {MOST_BETWEEN} blocks without a move stand behind the chamfer or rounding");
        let found = Diagnostic::new(codes::S2071.alarm(10880), loc, message);
        self.report(found.help("the control would leave the corner as it is: move the blocks away from it"));
        Err(Reported)
    }
}
