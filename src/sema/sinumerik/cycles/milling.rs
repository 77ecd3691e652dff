//! What all milling cycles take: plane, heights, cutter, feeds, and the digits that recur in their codes.
//!
//! Source: M 1.2, 1.3 and 7 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::Plane;
use crate::ir::Feed;
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill, MillFault};
use crate::ir::frame::PlaneMap;
use crate::ir::function::Turn;
use crate::machine::Axis;

use super::super::{Outcome, Reported};
use super::arguments::{
    AMODE, CDIR, DMODE, DP, DPR, F, FALD, FFD, FFP1, FZ, Key, MID, RFP, RP, RTP, SC, SDIS, UZ, Z0, Z1,
};
use super::call::CycleCall;

/// The plane infeed as a part of the diameter of the cutter, where none is given.
const USUAL_WIDTH: f64 = 0.8;

/// More mm per revolution were probably meant per minute.
const LARGE_PER_REVOLUTION: f64 = 10.0;
/// No machine travels faster, in units of the feed.
const LARGEST_FEED: f64 = 999_999.999;

/// Where a cycle has what all milling cycles take.
#[derive(Debug, Clone, Copy)]
pub(super) struct Names {
    pub retract: Key,
    pub reference: Key,
    pub clearance: Key,
    pub depth: Key,
    pub step: Key,
    pub floor: Key,
    pub feed: Key,
    /// As `feed` where the cycle has none.
    pub depth_feed: Key,
}

/// The names of the cycles that the old controls have, too.
pub(super) const CLASSIC: Names = Names {
    retract: RTP,
    reference: RFP,
    clearance: SDIS,
    depth: DP,
    step: MID,
    floor: FALD,
    feed: FFP1,
    depth_feed: FFD,
};

/// The names of the cycles along contours of CYCLE62.
pub(super) const ALONG_CONTOURS: Names =
    Names { retract: RP, reference: Z0, clearance: SC, depth: Z1, step: MID, floor: UZ, feed: F, depth_feed: FZ };

/// On which side of the tool the finished wall lies as it goes round.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Around {
    /// Inside a pocket.
    Inside,
    /// Around a spigot.
    Outside,
}

impl CycleCall<'_, '_> {
    /// What every milling cycle takes; everything that recurs in the codes is checked here.
    pub(super) fn mill(&mut self, names: &Names) -> Outcome<Mill> {
        let args = self.args;
        self.digits_are_known()?;
        self.digits_of_are_known(DMODE)?;
        self.frame_is_not_scaled()?;
        let plane = self.plane_of_mode()?;
        self.frame_keeps_the_tool_axis(plane)?;
        let (first, second, third) = plane.axes();
        for axis in [first, second, third] {
            self.no_diameters(args.name(), Axis::ALL[axis], args.span)?;
        }
        let radius = self.cutter()?;
        let heights = self.mill_heights(names)?;
        let feeds = self.mill_feeds(names)?;
        let mill = Mill { plane, heights, radius, feeds };
        match mill.check() {
            Ok(()) if third == Axis::Z.index() && heights.outward() < 0.0 && !self.st.machine.lathe => {
                let (name, place) = (args.written(names.retract), args.place(names.retract));
                self.refuse_cycle(
                    args.span_of(names.retract),
                    codes::P2090::retraction_plane_lies_below_surface(&name, &place),
                )
            }
            Ok(()) => self.levels_are_meant(names, mill),
            Err(fault) => self.mill_fault(names, fault),
        }
    }

    /// Cycles whose path does not count OFFN refuse it: the control selects compensation in them, with the radius that OFFN enlarges.
    pub(super) fn no_normal_offset(&self) -> Outcome {
        let normal = self.st.path.normal() / self.st.length_unit();
        if normal == 0.0 {
            return Ok(());
        }
        self.refuse(self.args.span, codes::S9015::offn_is_in_force(&self.args.name(), &normal))
    }

    /// The plane that `_DMODE` names.
    fn plane_of_mode(&self) -> Outcome<Plane> {
        match self.args.digit(DMODE, 0) {
            0 => Ok(self.st.plane()),
            1 => Ok(Plane::Xy),
            2 => Ok(Plane::Zx),
            3 => Ok(Plane::Yz),
            _ => self.refuse_argument(DMODE, codes::S9015::this_plane_units_of_dmode_is_not()),
        }
    }

    /// Mirrors and rotations are allowed: the shape is turned with its frame.
    pub(super) fn frame_is_not_scaled(&self) -> Outcome {
        if self.st.ctx.frame.uniform_scale().is_some_and(|scale| (scale - 1.0).abs() < 1e-9) {
            return Ok(());
        }
        self.refuse_cycle(self.args.span, codes::P2090::scaling_is_active())
    }

    /// The heights of the cycle lie along the tool axis of the machine, and its way out of the workpiece is the tool's.
    fn frame_keeps_the_tool_axis(&self, plane: Plane) -> Outcome {
        let (first, second, third) = plane.axes();
        let linear = self.st.ctx.frame.linear();
        let tilted =
            [first, second].iter().any(|a| linear[(third, *a)].abs() > 1e-9 || linear[(*a, third)].abs() > 1e-9);
        if !tilted && linear[(third, third)] > 0.0 {
            return Ok(());
        }
        self.refuse(self.args.span, codes::S9015::frame_mirrors_or_tilts_tool_axis(&self.args.name()))
    }

    /// The radius of the active tool.
    fn cutter(&self) -> Outcome<f64> {
        let args = self.args;
        let (number, edge) = self.active_edge()?;
        match self.known_radius() {
            Some(radius) if radius > 0.0 => {
                self.corners_of_cutter(radius);
                Ok(radius)
            }
            known => {
                let what = if known.is_some() { "is not above 0" } else { "is not known" };
                self.refuse(
                    args.span,
                    codes::P2004::radius_of_tool(&args.name(), &number, &what, &edge)
                        .answer(Answer::tool(number, "radius")),
                )
            }
        }
    }

    /// The paths are those of a cutter with sharp corners.
    fn corners_of_cutter(&self, radius: f64) {
        let rounding = self.active_tool().and_then(|tool| tool.corner_radius).filter(|rounding| *rounding > 0.0);
        let Some(rounding) = rounding else { return };
        self.report_once(
            codes::P8102::corner_radius_mm_of_cutter(
                &self.args.name(),
                &rounding,
                &radius,
                &(2.0 * (radius - rounding).max(0.0)),
            )
            .at(self.loc(self.args.span)),
        );
    }

    fn mill_heights(&mut self, names: &Names) -> Outcome<Heights> {
        let retract = self.needed_length(names.retract, "the retraction plane")?;
        let reference = self.needed_length(names.reference, "the reference plane")?;
        let depth = self.mill_depth(names, retract, reference)?;
        Ok(Heights {
            retract,
            reference,
            clearance: self.magnitude(names.clearance),
            depth,
            step: self.magnitude(names.step),
            division: Division::Even,
            allowance: self.magnitude(names.floor),
        })
    }

    /// The depth from one argument, absolute or incremental by the units of `_AMODE`, or from the pair DP and DPR.
    fn mill_depth(&mut self, names: &Names, retract: f64, reference: f64) -> Outcome<f64> {
        let args = self.args;
        let (mut absolute, mut relative) = (self.length_of(args, names.depth), None);
        if args.place(DPR) > 0 {
            relative = self.length_of(args, DPR);
            self.one_depth(self.depth_by(), &mut absolute, &mut relative)?;
            self.depths_agree(reference, retract, absolute, relative);
        } else if args.digit(AMODE, 0) == 1 {
            relative = absolute.take().or(Some(0.0));
        }
        match relative.filter(|way| *way != 0.0 || absolute.is_none()) {
            Some(_) if retract == reference => self.mill_fault(names, MillFault::ReferencePlane),
            Some(way) => Ok(reference - (retract - reference).signum() * way.abs()),
            None => Ok(absolute.unwrap_or(0.0)),
        }
    }

    fn depths_agree(&self, reference: f64, retract: f64, absolute: Option<f64>, relative: Option<f64>) {
        let args = self.args;
        let (Some(absolute), Some(way)) = (absolute, relative.filter(|way| *way != 0.0)) else { return };
        let by_way = reference - (retract - reference).signum() * way.abs();
        if absolute != 0.0 && (absolute - by_way).abs() > 1e-9 {
            let found = codes::S8018::dp_dpr_give_different_depths(&args.name()).at(self.loc(args.span_of(DP)));
            self.report(found.help("leave one of them out"));
        }
    }

    fn mill_feeds(&mut self, names: &Names) -> Outcome<Feeds> {
        let plane = self.mill_feed(names.feed)?;
        let depth = if self.args.place(names.depth_feed) > 0 { self.mill_feed(names.depth_feed)? } else { plane };
        Ok(Feeds { plane, depth })
    }

    /// A feed among the arguments, of the kind in force; the modal one where it is 0 or missing.
    pub(super) fn mill_feed(&mut self, key: Key) -> Outcome<Feed> {
        let args = self.args;
        let value = args.or_zero(key);
        if value > LARGEST_FEED {
            return self.refuse_cycle(
                args.span_of(key),
                codes::P2090::feed_is_out_of_all_range(&args.written(key), &args.place(key)),
            );
        }
        if value > 0.0 {
            let feed = self.st.feed_of(value);
            if matches!(feed, Feed::PerRevolution(way) if way > LARGE_PER_REVOLUTION) {
                self.leaves_open(codes::S8230::feed_is_read_as_way_per_revolution(&value));
            }
            return Ok(feed);
        }
        if value == 0.0 && self.st.feed.is_lost() {
            return Err(Reported);
        }
        match self.st.feed.word().filter(|_| value == 0.0) {
            Some(feed) => {
                self.feed_kind_is_said();
                Ok(feed)
            }
            None => {
                let (name, place) = (args.written(key), args.place(key));
                let what = if value < 0.0 { "is below 0" } else { "is missing, and no F stands before it" };
                self.refuse_cycle(args.span_of(key), codes::P2090::feed(&name, &place, &what))
            }
        }
    }

    /// A length that the manuals call unsigned, without its sign.
    pub(super) fn magnitude(&self, key: Key) -> f64 {
        self.length_of(self.args, key).unwrap_or(0.0).abs()
    }

    /// No infeed: one level, where the tool is long enough for it.
    fn levels_are_meant(&self, names: &Names, mill: Mill) -> Outcome<Mill> {
        let args = self.args;
        if mill.heights.step > 0.0 || args.place(names.step) == 0 {
            return Ok(mill);
        }
        let (name, place) = (args.written(names.step), args.place(names.step));
        let way = mill.heights.way();
        match self.active_tool().and_then(|tool| tool.length).filter(|length| *length > 0.0 && *length < way) {
            Some(length) => {
                self.refuse_cycle(args.span_of(names.step), codes::P2090::no_infeed_in_depth(&name, &place, &length))
            }
            None => {
                self.leaves_open(codes::S8230::no_infeed_in_depth(&name, &place, &way));
                Ok(mill)
            }
        }
    }

    /// The greatest plane infeed: mm, or percent of the diameter by the tens of `_AMODE`.
    pub(super) fn width(&self, key: Key, radius: f64) -> Outcome<f64> {
        let args = self.args;
        let (name, place) = (args.written(key), args.place(key));
        let width = if args.digit(AMODE, 1) == 1 {
            args.or_zero(key).abs() / 100.0 * 2.0 * radius
        } else {
            self.magnitude(key)
        };
        if width > 2.0 * radius + 1e-9 {
            return self.refuse_cycle(
                args.span_of(key),
                codes::P2090::infeed_in_plane_of_mm_is_larger(&name, &place, &width, &(2.0 * radius)),
            );
        }
        if width == 0.0 {
            self.leaves_open(codes::S8230::no_infeed_in_plane(&name, &place));
            return Ok(USUAL_WIDTH * 2.0 * radius);
        }
        Ok(width)
    }

    /// Does the tool go round counter-clockwise, by CDIR?
    pub(super) fn goes_counter_clockwise(&self, around: Around) -> Outcome<bool> {
        let args = self.args;
        let climb = match args.or_zero(CDIR) {
            2.0 => return Ok(false),
            3.0 => return Ok(true),
            0.0 => true,
            1.0 => false,
            _ => {
                return self.refuse_cycle(
                    args.span_of(CDIR),
                    codes::P2090::direction_is_0_to_3(&args.written(CDIR), &args.place(CDIR)),
                );
            }
        };
        let turn = self.st.spindles.turn();
        if turn.is_none() {
            self.leaves_open(codes::S8230::whether_spindle_turns_by_m3_or_m4());
        }
        if self.mirrors_the_plane() {
            let [asked, made] = if climb { ["climb", "conventional"] } else { ["conventional", "climb"] };
            self.leaves_open(codes::S8230::mirrored_frame_turns_sense_around(&asked, &made));
        }
        let usual = turn != Some(Turn::CounterClockwise);
        Ok((around == Around::Inside) == (climb == usual))
    }

    /// Does the frame change left and right in the plane of the cycle?
    fn mirrors_the_plane(&self) -> bool {
        let plane = self.plane_of_mode().unwrap_or(self.st.plane());
        matches!(self.st.ctx.frame.plane_map(plane), PlaneMap::Similar { flips: true, .. })
    }

    /// Refuses what makes no milling cycle.
    pub(super) fn mill_fault<T>(&self, names: &Names, fault: MillFault) -> Outcome<T> {
        let args = self.args;
        let (key, alarm, help) = match fault {
            MillFault::ReferencePlane => (
                names.depth,
                Some(61101),
                "the retraction plane lies on the far side of the surface, seen from the depth",
            ),
            MillFault::RetractBelowStart => {
                (names.retract, None, "partc wants the retraction plane above the surface plus the safety distance")
            }
            MillFault::FloorAllowance => (names.floor, Some(61010), "give a smaller allowance on the floor"),
            MillFault::TooManyLevels => (names.step, Some(61019), "give a larger infeed in depth"),
            MillFault::Feed => (names.feed, Some(61003), "give a feed above 0"),
            MillFault::Number | MillFault::Radius => (names.depth, Some(61019), "check the arguments of the cycle"),
        };
        self.refuse_cycle(
            args.span_of(key),
            codes::P2090::family_refuses(&fault, &args.written(key), &args.place(key)).help(help).alarm(alarm),
        )
    }
}
