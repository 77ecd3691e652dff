//! What turning programs say of elements with missing data: rules, and the choice of two solutions by Q.
//!
//! Points are (Z, X) with X as a radius. A line stands at `A` to the negative Z axis: it leaves its start along
//! (-cos A, sin A) or the other way. Source: T 5 and 6.2, "Solving unknowns" (docs/sources.md).

use crate::diag::codes;
use crate::geo::open::{RADIUS_DIFFERS, Rules, Solution, Solutions, Start, TOO_MUCH};
use crate::geo::{SAME_POINT, distance};

pub(super) use crate::geo::open::{Center, Coord, Data, Fault, Solved};
pub(super) use crate::sema::chain::{Angles, Chain, Choice};

/// How far data that says the same twice may disagree, in mm: drawings round to 0.01 and less.
pub(super) const AGREES: f64 = 0.02;

pub(super) const RULES: Rules = Rules {
    agrees: AGREES,
    touch: SAME_POINT,
    smooth_touch: AGREES,
    reach: |_| SAME_POINT,
    chord: None,
    one_coordinate: false,
    leaves_along: false,
};

/// The fault in the words of these programs.
fn in_words(fault: Fault) -> Fault {
    match fault {
        RADIUS_DIFFERS => Fault::Contradiction("R is not the distance of the centre from the start"),
        TOO_MUCH => Fault::Contradiction("R and I or K cannot stand together"),
        other => other,
    }
}

/// What is said of an element that is not determined.
pub(super) fn not_determined(fault: Fault) -> crate::diag::Fault {
    match in_words(fault) {
        Fault::Open(why) => codes::T3001::element_is_not_determined(&why),
        Fault::Impossible(why) => codes::T3002::element_is_not_possible(&why),
        Fault::Contradiction(why) => codes::T3006::element_contradicts_itself(&why),
    }
}

/// Of two solutions the one nearer to the start, or the further one.
pub(super) fn by_distance(start: &Start, far: bool, among: &Solutions) -> Result<Solution, Fault> {
    if let Some(only) = among.single() {
        return Ok(only);
    }
    let way = |solution: &&Solution| distance(solution.solved.to, start.at);
    // The start itself is no solution.
    let mut others = among.iter().filter(|solution| way(solution) > SAME_POINT);
    match (others.next(), others.next()) {
        (None, _) => Err(Fault::Impossible("it ends where it starts")),
        (Some(a), None) => Ok(*a),
        (Some(a), Some(b)) => {
            let (near, other) = (way(&a), way(&b));
            if (near - other).abs() <= SAME_POINT && distance(a.solved.to, b.solved.to) > AGREES {
                return Err(Fault::Open("two solutions lie equally far from its start, so Q tells nothing"));
            }
            Ok(if (near <= other) == far { *b } else { *a })
        }
    }
}
