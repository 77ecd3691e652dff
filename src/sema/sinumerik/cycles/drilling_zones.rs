//! Zones of CYCLE82 that are drilled at a feed of their own: where the drill enters, and where it comes out.
//!
//! Source: C 6.1 (docs/sources.md). Which digit of `_VARI` is which zone is not confirmed: by default both are slow, so that
//! no zone is drilled faster than on the control.

use crate::diag::{Answer, Fault, codes};
use crate::ir::Feed;
use crate::ir::cycle::drilling::{Entry, Levels};
use crate::machine::options::cycles::DrillingZones;

use super::call::CycleCall;
use super::names::{S_FA, S_FD, S_ZA, S_ZD, VARI};
use crate::sema::cycle::call::{Kind, Made};
use crate::sema::cycle::given::Given;
use crate::sema::cycle::row::Name;

/// The hole in up to three parts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Zones {
    pub entry: Option<Entry>,
    /// Between both zones; where they overlap, the slower of both.
    pub feed: Feed,
    /// Where the last zone begins, and its feed.
    pub last: Option<(f64, Feed)>,
}

/// Does `_VARI` of CYCLE82 switch a zone on?
pub(in super::super) fn has_zones(given: &Given) -> bool {
    given.signature.name == "CYCLE82" && given.or_zero(VARI) != 0.0
}

impl CycleCall<'_> {
    /// The zones of a hole that is drilled at `feed`.
    pub(super) fn zones(&self, levels: &Levels, feed: Feed) -> Made<Zones> {
        let given = self.given;
        let digits = [given.digit(VARI, 3), given.digit(VARI, 4)];
        if digits.iter().any(|digit| *digit > 1) || (0..10).any(|at| !matches!(at, 3 | 4) && given.digit(VARI, at) != 0)
        {
            return self.refuse_argument(VARI, codes::S9015::another_digit_than_1_in_thousands());
        }
        let [thousands, ten_thousands] = digits.map(|digit| digit == 1);
        let (enters, comes_out) = match self.settings.cycles.drilling_zones {
            DrillingZones::Both => {
                if thousands != ten_thousands {
                    self.says_both_zones();
                }
                (true, true)
            }
            DrillingZones::ThousandsThrough => (ten_thousands, thousands),
            DrillingZones::ThousandsPredrill => (thousands, ten_thousands),
        };
        let way = levels.way();
        let (first, first_feed) = self.zone(enters, [S_ZA, S_FA], way, feed)?;
        let (last, last_feed) = self.zone(comes_out, [S_ZD, S_FD], way, feed)?;
        let height = |below: f64| levels.reference - below * levels.outward();
        let overlap = first + last > way;
        // From the surface: where the first zone ends alone, and where the last one is alone.
        let (upper, lower) = if overlap { (way - last, first) } else { (first, way - last) };
        let slower = if first_feed.value() < last_feed.value() { first_feed } else { last_feed };
        // Without a part between them the last zone follows the first.
        let touching = !overlap && lower - upper <= 1e-9;
        let middle = if overlap {
            slower
        } else if touching {
            last_feed
        } else {
            feed
        };
        Ok(Zones {
            entry: (upper > 0.0).then(|| Entry { height: height(upper), feed: Some(first_feed) }),
            feed: middle,
            last: (lower < way && !touching).then(|| (height(lower), last_feed)),
        })
    }

    /// Length and feed of a zone; one that is off has no length.
    fn zone(&self, on: bool, [length, percent]: [Name; 2], way: f64, feed: Feed) -> Made<(f64, Feed)> {
        let given = self.given;
        if !on {
            for key in [length, percent] {
                if given.or_zero(key) != 0.0 {
                    self.unused(key, "without its digit in `_VARI`");
                }
            }
            return Ok((0.0, feed));
        }
        let given = given.or_zero(percent);
        if given < 0.0 {
            return self.refuse_argument(percent, codes::P2090::feed_of_zone_is_below_0());
        }
        if given == 0.0 {
            self.reads_once(percent, codes::P8106::feed_of_0_percent_is_taken());
        }
        let part = if given == 0.0 { 1.0 } else { given / 100.0 };
        let way_in = self.given.length(length);
        if way_in < 0.0 {
            self.reads_once(length, codes::P8106::below_0_is_taken_without_its_sign(&self.given.written(length)));
        }
        let length = way_in.abs();
        Ok((length.min(way), feed.with_value(feed.value() * part)))
    }

    fn says_both_zones(&self) {
        let fault = codes::P8106::which_digit_of_vari_is_predrilling(&self.given.called)
            .answer(Answer::key("cycles", "cycle82_vari").one_of(&["\"thousands-through\"", "\"thousands-predrill\""]));
        self.note(self.given.place_of(VARI), fault, Kind::OnceHere);
    }

    fn reads_once(&self, name: Name, fault: Fault) {
        self.note(self.given.place_of(name), self.of_cycle(fault), Kind::OnceHere);
    }
}
