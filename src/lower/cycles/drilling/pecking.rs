//! Steps of a hole: where they end, and what the tool does between them.

use crate::geo::parts::NOTHING;
use crate::ir::cycle::drilling::{
    AdvancedStop, Breaks, Degression, DrillingFault, Levels, MOST_PECKS, Pecking, Removal, usual_ahead,
};

use super::hole::Hole;

/// Depths of the steps of a hole, the last one at the bottom.
///
/// # Errors
/// `TooManyPecks`.
pub(super) fn steps(levels: &Levels, peck: &Pecking) -> Result<Vec<f64>, DrillingFault> {
    if matches!(peck.breaks, Breaks::Every(way) if levels.way() / way > MOST_PECKS as f64) {
        return Err(DrillingFault::TooManyPecks);
    }
    let begin = Levels { reference: levels.reference - peck.from * levels.outward(), ..*levels };
    depths(&begin, peck.first, peck.degression)
}

/// Depths of the steps, the last one at the bottom. The last two are made alike where the rest would be shorter
/// than the least step (standard cycle CYCLE83, V06.02.09).
///
/// # Errors
/// `TooManyPecks`.
pub(super) fn depths(levels: &Levels, first: f64, degression: Degression) -> Result<Vec<f64>, DrillingFault> {
    let total = levels.way();
    let mut step = first.min(total);
    let mut done = step;
    let mut list = Vec::new();
    // A rest of nothing is no step of its own.
    while total - done > NOTHING {
        list.push(done);
        if list.len() >= MOST_PECKS {
            return Err(DrillingFault::TooManyPecks);
        }
        let rest = total - done;
        let next = match degression {
            Degression::Factor { factor, least } => {
                step = (step * factor).max(least);
                let next = done + step;
                if next > total + NOTHING {
                    total
                } else if (total - next).max(0.0) < least {
                    done + rest / 2.0
                } else {
                    next
                }
            }
            Degression::Plain { less, least } => {
                step = (step - less).max(least);
                if done + step + NOTHING >= total { total } else { done + step }
            }
            Degression::Even { .. } if done + step + NOTHING >= total => total,
            Degression::Even { least } if total - (done + step) < least => done + rest / 2.0,
            Degression::Even { .. } => done + step,
            Degression::Amount(amount) => {
                step = (step - amount).max(amount);
                let whole = rest - step >= amount;
                match (whole, rest > 2.0 * amount) {
                    (true, true) => done + step,
                    (true, false) if rest > amount => done + rest / 2.0,
                    (false, true) if rest > step + NOTHING => total - amount,
                    (false, false) if rest > step + NOTHING => done + rest / 2.0,
                    _ => total,
                }
            }
        };
        if next <= done {
            return Err(DrillingFault::TooManyPecks);
        }
        done = next;
    }
    list.push(total);
    let out = levels.outward();
    // The bottom is the programmed number, not a sum.
    Ok(list.into_iter().map(|way| if way >= total { levels.depth } else { levels.reference - way * out }).collect())
}

impl Hole<'_> {
    pub(super) fn peck(&mut self, peck: &Pecking, depths: &[f64]) {
        let out = self.levels.outward();
        let feed = self.drilling.feed;
        let mut from = self.levels.reference - peck.from * out;
        let mut broken = 0;
        for (at, &depth) in depths.iter().enumerate() {
            let feed = if at == 0 { feed.with_value(feed.value() * peck.first_feed) } else { feed };
            if let Breaks::Every(way) = peck.breaks {
                while (from - depth) * out > way + NOTHING {
                    from -= way * out;
                    self.cut(from, feed);
                    self.rapid(from + out * peck.way);
                }
            }
            self.cut(depth, feed);
            from = depth;
            let last = at + 1 == depths.len();
            self.dwell(if last { peck.dwell_at_bottom } else { peck.dwell });
            if last {
                break;
            }
            let breaks = match peck.breaks {
                Breaks::Never | Breaks::Every(_) => false,
                Breaks::Always => true,
                Breaks::Times(times) => broken < times,
            };
            if breaks {
                broken += 1;
                self.rapid(depth + out * peck.way);
                continue;
            }
            broken = 0;
            self.leave(peck.removal.back);
            self.dwell(peck.removal.dwell);
            // Never above the start plane: the tool stands there already.
            let ahead = self.ahead(&peck.removal, depth, (at, depths.len()));
            self.rapid(depth + out * ahead.min((self.levels.start_plane() - depth) * out));
        }
        if let Some(feed) = peck.removal.last {
            self.leave(feed);
        }
    }

    /// Distance in front of `depth`, at which step `at` of `count` ended.
    fn ahead(&self, removal: &Removal, depth: f64, (at, count): (usize, usize)) -> f64 {
        match removal.ahead {
            AdvancedStop::ByDepth => usual_ahead((self.levels.reference - depth).abs()),
            AdvancedStop::Evenly([first, last]) => {
                let share = if count > 2 { at as f64 / (count - 2) as f64 } else { 0.0 };
                first + share * (last - first)
            }
        }
    }
}
