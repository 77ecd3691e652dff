//! The side on which the radius of the tool is compensated.

use std::rc::Rc;

use crate::geo::Vec2;
use crate::ir::contour::{Ctx, CtxRef};
use crate::ir::{self, Side};
use crate::machine::Tool;

/// Where the edge in this cutting-edge position points to, as (Z, X); nowhere in position 9, whose programmed point is the
/// centre of the nose.
pub fn edge_direction(position: u8) -> Option<Vec2> {
    let (z, x) = match position {
        1 => (1.0, 1.0),
        2 => (-1.0, 1.0),
        3 => (-1.0, -1.0),
        4 => (1.0, -1.0),
        5 => (1.0, 0.0),
        6 => (0.0, 1.0),
        7 => (-1.0, 0.0),
        8 => (0.0, -1.0),
        9 => (0.0, 0.0),
        _ => return None,
    };
    Some(Vec2::new(z, x))
}

/// Radius of a cutter or a nose with its oversize in the table, and where its edge points to, as far as either is known.
pub fn nose_of(tool: Option<&Tool>) -> (Option<f64>, Option<Vec2>) {
    let radius = tool.and_then(|tool| tool.radius.map(|radius| radius + tool.deltas[1]));
    (radius, tool.and_then(|tool| tool.orientation).and_then(edge_direction))
}

/// The rules of a nose of this radius whose tip is programmed.
pub fn rules_of_nose(radius: f64, edge: Vec2) -> ir::Compensation {
    ir::Compensation { radius, nose: -edge * radius, ..Default::default() }
}

/// The compiler compensates by `rules` from here on.
pub fn compensate(ctx: &mut CtxRef, rules: ir::Compensation) {
    if ctx.compensation.as_deref() != Some(&rules) {
        *ctx = Rc::new(Ctx { compensation: Some(Rc::new(rules)), ..(**ctx).clone() });
    }
}

/// The side that is programmed, and the one that the moves so far were sent with.
#[derive(Debug, Clone, Copy, Default)]
pub struct Compensation {
    side: Side,
    sent: Side,
    /// The side changed, and nothing moved since.
    fresh: bool,
    /// A side was refused, which was reported.
    lost: bool,
}

impl Compensation {
    #[inline]
    pub fn side(&self) -> Side {
        self.side
    }

    #[inline]
    pub fn is_on(&self) -> bool {
        self.side != Side::None
    }

    /// A side was refused.
    pub fn is_lost(&self) -> bool {
        self.lost
    }

    pub fn is_fresh(&self) -> bool {
        self.fresh
    }

    /// Side of the last move that was sent.
    pub fn sent(&self) -> Side {
        self.sent
    }

    /// Is the next move the first on its side?
    #[inline]
    pub fn changes(&self) -> bool {
        self.side != self.sent
    }

    pub fn select(&mut self, side: Side) {
        self.fresh = side != self.side;
        self.side = side;
    }

    /// What ends the compensation without its word.
    pub fn end(&mut self) {
        self.side = Side::None;
    }

    /// A side was refused: a contour that lacks it is not worth another error.
    pub fn lose(&mut self) {
        self.lost = true;
    }

    /// The program says the side again.
    pub fn found(&mut self) {
        self.lost = false;
    }

    /// True once after a side was refused.
    pub fn take_lost(&mut self) -> bool {
        std::mem::take(&mut self.lost)
    }

    /// A move goes out that may change the side.
    #[inline]
    pub fn moves(&mut self) {
        self.fresh = false;
        self.sent = self.side;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_side_is_fresh_until_something_moves() {
        let mut compensation = Compensation::default();
        compensation.select(Side::Left);
        assert!(compensation.is_on() && compensation.is_fresh() && compensation.changes());
        compensation.moves();
        assert!(!compensation.is_fresh() && !compensation.changes());
        assert_eq!(compensation.sent(), Side::Left);
        compensation.select(Side::Left);
        assert!(!compensation.is_fresh());
        compensation.end();
        assert!(compensation.changes() && !compensation.is_on());
    }

    #[test]
    fn a_refused_side_is_worth_one_report() {
        let mut compensation = Compensation::default();
        compensation.lose();
        assert!(compensation.take_lost());
        assert!(!compensation.take_lost());
    }
}
