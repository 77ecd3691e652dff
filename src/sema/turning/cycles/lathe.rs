//! What a plan sees of the lathe, and what every family asks of a call.

use crate::diag::{Fault, Label, codes};
use crate::geo::Point2;
use crate::ir::Feed;
use crate::machine::Tool;
use crate::sema::cycle::call::{Call, Elsewhere, Kind, Made};
use crate::sema::cycle::row::Name;
use crate::sema::run::Where;
use crate::text::Loc;

use super::super::blank::Blank;
use super::super::chain::Coord;
use super::super::outline::Section;
use super::super::program_parts::Family;
use super::super::readings::Question;
use super::super::state::State;
use super::super::words::Fun;

/// Clearance where neither G47 nor the configuration sets one, in mm.
const CLEARANCE: f64 = 1.0;

/// Where and under what a cycle is called.
#[derive(Debug)]
pub(in super::super) struct Lathe<'c> {
    /// Number of the cycle.
    pub number: u16,
    pub modal: &'c State,
    pub family: Family,
    pub blank: Option<Blank>,
    /// Where the tool stands, as (Z, X).
    pub at: Point2,
    /// X and Z of the call in mm, X as a radius.
    pub x: Coord,
    pub z: Coord,
    /// The contour that the row asks for.
    pub contour: Option<Section>,
    /// G41 or G42 at the start of the contour.
    pub side: Option<Fun>,
}

/// A call of a cycle.
pub(in super::super) type CycleCall<'c> = Call<'c, Lathe<'c>>;

impl CycleCall<'_> {
    pub(super) fn feed(&self) -> Made<Feed> {
        match self.st.modal.feed.word() {
            Some(feed) => Ok(feed),
            None => self.refuse(codes::P2002::no_feed_is_programmed_before_this_cutting()),
        }
    }

    /// A feed of the cycle in the mode in force.
    pub(super) fn own_feed(&self, name: Name, active: Feed) -> Made<Feed> {
        match self.given.length_if(name) {
            None => Ok(active),
            Some(value) if value > 0.0 => Ok(active.with_value(value)),
            Some(_) => self.refuse_argument(name, codes::T1007::has_to_be_above_zero(&"a feed")),
        }
    }

    /// The point that X and Z name, as (Z, X).
    pub(super) fn corner(&self) -> Made<Point2> {
        let ordinate = |coord: Coord, from: f64| match coord {
            Coord::At(v) => Some(v),
            Coord::By(d) => Some(from + d),
            Coord::Stay | Coord::Open => None,
        };
        match (ordinate(self.st.x, self.st.at.y), ordinate(self.st.z, self.st.at.x)) {
            (Some(x), Some(z)) => Ok(Point2::new(z, x)),
            _ => self.refuse(codes::P1004::cycle_needs_x()),
        }
    }

    pub(super) fn clearance(&self) -> f64 {
        self.st.modal.clearance.or(self.settings.control.turning.clearance).unwrap_or(CLEARANCE)
    }

    pub(super) fn contour(&self) -> Made<&Section> {
        match &self.st.contour {
            Some(section) => Ok(section),
            None => self.refuse(codes::P1004::cycle_has_neither_ns_nor_contour()),
        }
    }

    /// What partc.toml says of the tool in the cutting position.
    pub(super) fn known_tool(&self) -> Option<&Tool> {
        self.st.modal.tool.as_ref()?.known(self.settings)
    }

    /// The oversize of the block at `place` does not fit.
    pub(super) fn no_oversize<T>(&self, place: Loc, fault: Fault) -> Made<T> {
        self.refuse_elsewhere(Elsewhere { place, fault, call: Label::Cycle })
    }

    /// The call depends on `question`: the first one of the program says so.
    pub(super) fn depends_on(&self, question: Question, place: Where) {
        if let Some(fault) = question.open(self.settings) {
            self.note(place, fault, Kind::Once);
        }
    }

    /// A fault of this call, or nothing.
    pub(super) fn no_fault<T>(&self, found: Result<T, Fault>) -> Made<T> {
        found.or_else(|fault| self.refuse(fault))
    }
}
