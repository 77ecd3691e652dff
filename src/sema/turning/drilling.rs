//! G71, G74 and G36: drilling and tapping along Z from where the tool stands.
//!
//! Source: T 9 (docs/sources.md).

use crate::diag::codes;
use crate::geo::Point2;
use crate::ir::Feed;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::drilling::{Breaks, Degression, Drilling, Levels, Method, Pecking, Tap};
use crate::ir::function::Spindle;
use crate::machine::Axis;

use super::chain::Coord;
use super::words::Words;
use super::{Outcome, Run};

impl Run<'_> {
    pub(super) fn drilling(&mut self, w: &Words, pecks: bool) -> Outcome {
        let at = self.stand()?;
        let span = self.block_span();
        let feed = self.cutting_feed()?;
        let bottom = self.bottom_of_hole(w, at)?;
        if let Some(num) = w.get(b'V').filter(|num| num.value != 0.0) {
            return self.refuse(num.span, codes::T9007::by_how_much_v_lowers_feed());
        }
        let dwell = self.not_negative(w, b'E')?;
        let out_at_feed = self.choice(w, b'D', 0, 1)? == 1;
        let method = match (pecks, out_at_feed) {
            (false, false) => Method::Drill { dwell },
            (false, true) => Method::Ream { dwell, back: feed },
            (true, false) => Method::Peck(self.pecks(w, at.x - bottom, dwell)?),
            (true, true) => {
                return self.refuse(w.span(b'D', span), codes::T9007::deep_hole_drilling_with_retraction_at_feed());
            }
        };
        self.send_drilling(at.x, bottom, feed, method);
        Ok(())
    }

    fn send_drilling(&mut self, start: f64, depth: f64, feed: Feed, method: Method) {
        let levels = Levels { retract: start, reference: start, clearance: 0.0, depth };
        self.send_cycle(&Cycle::Drilling(Drilling { axis: Axis::Z, levels, feed, entry: None, method }));
    }

    /// G36: the thread is cut with the spindle in step; it turns back on the way out.
    pub(super) fn tapping(&mut self, w: &Words) -> Outcome {
        let at = self.stand()?;
        let span = self.block_span();
        for (letter, what) in [(b'B', "run-in"), (b'Q', "spindle"), (b'H', "reference of the pitch")] {
            if let Some(num) = w.get(letter).filter(|num| num.value != 0.0) {
                return self.refuse(num.span, codes::T9007::of_g36_what_its_values_do_no(&(letter as char), &what));
            }
        }
        let bottom = self.bottom_of_hole(w, at)?;
        let pitch = self.needed(w, b'F', "the pitch of the thread", span)?;
        let lead = self.above_zero(pitch, "the pitch of the thread")?;
        let Some(turn) = self.st.spindle.turn() else {
            return self.refuse(span, codes::P1004::spindle_does_not_turn());
        };
        if self.st.spindle.is_cutting() {
            return self.refuse(span, codes::P1005::tapping_under_constant_cutting_speed());
        }
        let tap = Tap {
            rigid: true,
            lead: Some(lead),
            turn,
            dwell: 0.0,
            dwell_reversed: false,
            speed_in: None,
            speed_out: None,
            orient: None,
            step: None,
            after: Spindle::Start(turn),
            speed_after: None,
        };
        // The feed of the hole is not used; the pitch is.
        self.send_drilling(at.x, bottom, Feed::PerRevolution(lead), Method::Tap(tap));
        Ok(())
    }

    /// Z of the bottom; the tool stands over the hole, in front of it.
    fn bottom_of_hole(&self, w: &Words, at: Point2) -> Outcome<f64> {
        let span = self.block_span();
        match self.coord(w.get(b'X'), Axis::X) {
            Coord::Stay => {}
            Coord::At(x) if (x - at.y).abs() <= 1e-6 => {}
            _ => {
                return self.refuse(w.span(b'X', span), codes::T9007::drilling_along_x_is_not_supported());
            }
        }
        let bottom = match self.coord(w.get(b'Z'), Axis::Z) {
            Coord::At(z) => z,
            Coord::By(d) => at.x + d,
            _ => return self.refuse(span, codes::P1004::z_is_missing()),
        };
        if bottom >= at.x {
            return self.refuse(w.span(b'Z', span), codes::T1007::hole_does_not_lie_in_front());
        }
        Ok(bottom)
    }

    fn not_negative(&self, w: &Words, letter: u8) -> Outcome<f64> {
        match w.get(letter) {
            Some(num) if num.value < 0.0 => self.refuse(num.span, codes::T1007::is_not_negative(&(letter as char))),
            num => Ok(num.map_or(0.0, |num| num.value)),
        }
    }

    /// P, I, J and B: the steps of a deep hole.
    fn pecks(&self, w: &Words, depth: f64, dwell: f64) -> Outcome<Pecking> {
        let mm = self.st.mm();
        let first = match w.get(b'P') {
            Some(num) => self.above_zero(num, "the first depth")?.min(depth),
            None => depth,
        };
        let less = self.not_negative(w, b'I')? * mm;
        let least = match w.get(b'J') {
            Some(num) => self.above_zero(num, "the least depth")?,
            None => first / 10.0,
        };
        let degression = if less == 0.0 {
            Degression::Plain { less: 0.0, least: least.min(first) }
        } else if (less - least).abs() <= 1e-9 {
            Degression::Plain { less, least: least.min(first) }
        } else {
            return self.refuse(w.span(b'I', self.block_span()), codes::T9007::steps_that_become_shorter_by_i_down());
        };
        let (breaks, way) = match w.get(b'B') {
            Some(num) => (Breaks::Always, self.above_zero(num, "the return distance")?),
            None => (Breaks::Never, 0.0),
        };
        Ok(Pecking { dwell_at_bottom: dwell, breaks, way, ..Pecking::new(first, degression) })
    }
}
