//! What all milling cycles take: plane, heights, cutter, feeds, and the digits that recur in their codes.
//!
//! Source: M 1.2, 1.3 and 7 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::Plane;
use crate::ir::Feed;
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill, MillFault};
use crate::ir::function::Turn;
use crate::machine::Axis;

use super::call::CycleCall;
use super::names::{AMODE, CDIR, DMODE, DP, DPR, F, FALD, FFD, FFP1, FZ, MID, RFP, RP, RTP, SC, SDIS, UZ, Z0, Z1};
use crate::sema::cycle::call::{Kind, Made, Refusal};
use crate::sema::cycle::row::Name;

/// The plane infeed as a part of the diameter of the cutter, where none is given.
pub(super) const USUAL_WIDTH: f64 = 0.8;

/// More mm per revolution were probably meant per minute.
const LARGE_PER_REVOLUTION: f64 = 10.0;
/// No machine travels faster, in units of the feed.
const LARGEST_FEED: f64 = 999_999.999;

/// Where a cycle has what all milling cycles take.
#[derive(Debug, Clone, Copy)]
pub(super) struct Names {
    pub retract: Name,
    pub reference: Name,
    pub clearance: Name,
    pub depth: Name,
    pub step: Name,
    pub floor: Name,
    pub feed: Name,
    /// As `feed` where the cycle has none.
    pub depth_feed: Name,
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

impl CycleCall<'_> {
    /// What every milling cycle takes; everything that recurs in the codes is checked here.
    pub(super) fn mill(&self, names: &Names) -> Made<Mill> {
        let given = self.given;
        self.digits_of_are_known(DMODE)?;
        self.frame_is_not_scaled()?;
        let plane = self.plane_of_mode()?;
        self.frame_keeps_the_tool_axis(plane)?;
        let (first, second, third) = plane.axes();
        for axis in [first, second, third] {
            self.no_diameters(Axis::ALL[axis], given.place)?;
        }
        let radius = self.cutter()?;
        let heights = self.mill_heights(names)?;
        let feeds = self.mill_feeds(names)?;
        let mill = Mill { plane, heights, radius, feeds };
        match mill.check() {
            Ok(()) if third == Axis::Z.index() && heights.outward() < 0.0 && !self.st.machine.lathe => {
                let (name, place) = (given.written(names.retract), given.argument(names.retract));
                self.refuse_argument(names.retract, codes::P2090::retraction_plane_lies_below_surface(&name, &place))
            }
            Ok(()) => self.levels_are_meant(names, mill),
            Err(fault) => self.mill_fault(names, fault),
        }
    }

    /// The plane that `_DMODE` names.
    fn plane_of_mode(&self) -> Made<Plane> {
        match self.given.digit(DMODE, 0) {
            0 => Ok(self.st.plane()),
            1 => Ok(Plane::Xy),
            2 => Ok(Plane::Zx),
            3 => Ok(Plane::Yz),
            _ => self.refuse_argument(DMODE, codes::S9015::this_plane_units_of_dmode_is_not()),
        }
    }

    /// The heights of the cycle lie along the tool axis of the machine, and its way out of the workpiece is the tool's.
    fn frame_keeps_the_tool_axis(&self, plane: Plane) -> Made {
        if self.st.ctx.frame.keeps_axis_across(plane) {
            return Ok(());
        }
        self.refuse_as_said(self.given.place, codes::S9015::frame_mirrors_or_tilts_tool_axis(&self.given.called))
    }

    /// The radius of the active tool.
    fn cutter(&self) -> Made<f64> {
        let given = self.given;
        let (number, edge) = self.active_edge()?;
        match self.known_radius() {
            Some(radius) if radius > 0.0 => {
                self.corners_of_cutter(radius);
                Ok(radius)
            }
            known => {
                let what = if known.is_some() { "is not above 0" } else { "is not known" };
                self.refuse_as_said(
                    given.place,
                    codes::P2004::radius_of_tool(&given.called, &number, &what, &edge)
                        .answer(Answer::tool(number, "radius")),
                )
            }
        }
    }

    /// The paths are those of a cutter with sharp corners.
    fn corners_of_cutter(&self, radius: f64) {
        let rounding =
            self.st.active_tool(self.settings).and_then(|tool| tool.corner_radius).filter(|rounding| *rounding > 0.0);
        let Some(rounding) = rounding else { return };
        let flat = 2.0 * (radius - rounding).max(0.0);
        let fault = codes::P8102::corner_radius_mm_of_cutter(&self.given.called, &rounding, &radius, &flat);
        self.note(self.given.place, fault, Kind::Once);
    }

    fn mill_heights(&self, names: &Names) -> Made<Heights> {
        let (retract, reference) = (self.given.length(names.retract), self.given.length(names.reference));
        let depth = self.mill_depth(names, retract, reference)?;
        Ok(Heights {
            retract,
            reference,
            clearance: self.given.magnitude(names.clearance),
            depth,
            step: self.given.magnitude(names.step),
            division: Division::Even,
            allowance: self.given.magnitude(names.floor),
        })
    }

    /// The depth from one argument, absolute or incremental by the units of `_AMODE`, or from the pair DP and DPR.
    fn mill_depth(&self, names: &Names, retract: f64, reference: f64) -> Made<f64> {
        let given = self.given;
        let (mut absolute, mut relative) = (given.length_if(names.depth), None);
        if given.argument(DPR) > 0 {
            relative = self.given.length_if(DPR);
            self.one_depth(self.depth_by(), &mut absolute, &mut relative)?;
            self.depths_agree(reference, retract, absolute, relative);
        } else if given.digit(AMODE, 0) == 1 {
            relative = absolute.take().or(Some(0.0));
        }
        match relative.filter(|way| *way != 0.0 || absolute.is_none()) {
            Some(_) if retract == reference => self.mill_fault(names, MillFault::ReferencePlane),
            Some(way) => Ok(reference - (retract - reference).signum() * way.abs()),
            None => Ok(absolute.unwrap_or(0.0)),
        }
    }

    fn depths_agree(&self, reference: f64, retract: f64, absolute: Option<f64>, relative: Option<f64>) {
        let given = self.given;
        let (Some(absolute), Some(way)) = (absolute, relative.filter(|way| *way != 0.0)) else { return };
        let by_way = reference - (retract - reference).signum() * way.abs();
        if absolute != 0.0 && (absolute - by_way).abs() > 1e-9 {
            self.note(given.place_of(DP), codes::S8018::dp_dpr_give_different_depths(&given.called), Kind::Each);
        }
    }

    fn mill_feeds(&self, names: &Names) -> Made<Feeds> {
        let plane = self.mill_feed(names.feed)?;
        let depth = if self.given.argument(names.depth_feed) > 0 { self.mill_feed(names.depth_feed)? } else { plane };
        Ok(Feeds { plane, depth })
    }

    /// A feed among the arguments, of the kind in force; the modal one where it is 0 or missing.
    pub(super) fn mill_feed(&self, key: Name) -> Made<Feed> {
        let given = self.given;
        let value = given.or_zero(key);
        if value > LARGEST_FEED {
            return self.refuse_argument(
                key,
                codes::P2090::feed_is_out_of_all_range(&given.written(key), &given.argument(key)),
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
            return Err(Refusal::Known);
        }
        match self.st.feed.word().filter(|_| value == 0.0) {
            Some(feed) => {
                self.takes_modal_feed.set(true);
                Ok(feed)
            }
            None => {
                let (name, place) = (given.written(key), given.argument(key));
                let what = if value < 0.0 { "is below 0" } else { "is missing, and no F stands before it" };
                self.refuse_argument(key, codes::P2090::feed(&name, &place, &what))
            }
        }
    }

    /// No infeed: one level, where the tool is long enough for it.
    fn levels_are_meant(&self, names: &Names, mill: Mill) -> Made<Mill> {
        let given = self.given;
        if mill.heights.step > 0.0 || given.argument(names.step) == 0 {
            return Ok(mill);
        }
        let (name, place) = (given.written(names.step), given.argument(names.step));
        let way = mill.heights.way();
        match self
            .st
            .active_tool(self.settings)
            .and_then(|tool| tool.length)
            .filter(|length| *length > 0.0 && *length < way)
        {
            Some(length) => self.refuse_argument(names.step, codes::P2090::no_infeed_in_depth(&name, &place, &length)),
            None => {
                self.leaves_open(codes::S8230::no_infeed_in_depth(&name, &place, &way));
                Ok(mill)
            }
        }
    }

    /// The greatest plane infeed: mm, or percent of the diameter by the tens of `_AMODE`.
    pub(super) fn width(&self, key: Name, radius: f64) -> Made<f64> {
        let given = self.given;
        let (name, place) = (given.written(key), given.argument(key));
        let width = if given.digit(AMODE, 1) == 1 {
            given.or_zero(key).abs() / 100.0 * 2.0 * radius
        } else {
            self.given.magnitude(key)
        };
        if width > 2.0 * radius + 1e-9 {
            return self.refuse_argument(
                key,
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
    pub(super) fn goes_counter_clockwise(&self, around: Around) -> Made<bool> {
        let given = self.given;
        let climb = match given.or_zero(CDIR) {
            2.0 => return Ok(false),
            3.0 => return Ok(true),
            0.0 => true,
            1.0 => false,
            _ => {
                return self.refuse_argument(
                    CDIR,
                    codes::P2090::direction_is_0_to_3(&given.written(CDIR), &given.argument(CDIR)),
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
        self.st.ctx.frame.flips(self.plane_of_mode().unwrap_or(self.st.plane()))
    }

    /// Refuses what makes no milling cycle.
    pub(super) fn mill_fault<T>(&self, names: &Names, fault: MillFault) -> Made<T> {
        let at = match fault {
            MillFault::ReferencePlane => {
                (names.depth, 61101, "the retraction plane lies on the far side of the surface, seen from the depth")
            }
            MillFault::RetractBelowStart => {
                (names.retract, 0, "partc wants the retraction plane above the surface plus the safety distance")
            }
            MillFault::FloorAllowance => (names.floor, 61010, "give a smaller allowance on the floor"),
            MillFault::TooManyLevels => (names.step, 61019, "give a larger infeed in depth"),
            MillFault::Feed => (names.feed, 61003, "give a feed above 0"),
            MillFault::Number | MillFault::Radius => (names.depth, 61019, "check the arguments of the cycle"),
        };
        self.unsound(at, &fault)
    }
}
