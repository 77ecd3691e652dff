//! What a circle tells of the order of the geometry axes.
//!
//! In: the words of a G2 or G3 that ends in two axes of which the working plane has one, with a centre that counts in the working
//! plane. Out: a refusal that names an order of the axes under which the circle closes, where it does not close as it is read. Decides
//! no path: which axes I, J and K belong to, the machine says (MD 20050).

use crate::diag::{Answer, codes};
use crate::geo::{Plane, Point2, distance};
use crate::ir::Pos;
use crate::machine::{Axis, AxisSet};

use super::circle::{CENTER, SAME, end_in};
use super::diameter::Diameter;
use super::vocabulary::Address;
use super::words::{Mode, Words};
use super::{Core, Outcome, Reported, State};

/// All orders that make a right-handed system.
const ORDERS: [[Axis; 3]; 3] = [[Axis::X, Axis::Y, Axis::Z], [Axis::Y, Axis::Z, Axis::X], [Axis::Z, Axis::X, Axis::Y]];

impl State {
    /// Refuses a circle that closes under another order of the geometry axes only.
    pub(super) fn order_of_axes_fits(&self, core: &Core<'_>, w: &Words, plane: Plane, end: &Pos) -> Outcome {
        let now = self.machine.geometry_axes;
        let mut named = w.axes.common(AxisSet::MAIN).iter();
        let (Some(a), Some(b), None) = (named.next(), named.next(), named.next()) else { return Ok(()) };
        let by_centre = [Address::Cr, Address::Ar, Address::Turn].iter().all(|word| w.get(*word).is_none());
        if holds(plane, a, b)
            || !by_centre
            || self.diameter_mode() != Diameter::Off
            || closes(core, self, w, now, plane, end)
        {
            return Ok(());
        }
        let planes = || [Plane::Xy, Plane::Zx, Plane::Yz].into_iter().filter(|plane| holds(*plane, a, b));
        let closes = |order: &[Axis; 3]| planes().any(|plane| closes(core, self, w, *order, plane, end));
        let Some(order) = ORDERS.into_iter().filter(|order| *order != now).find(closes) else { return Ok(()) };
        // One circle tells it for all.
        if !core.job.diags.first_time(codes::P3001, order) {
            return Err(Reported);
        }
        let names = |order: [Axis; 3]| order.map(|axis| format!("\"{}\"", axis.letter())).join(", ");
        let [fitting, current] = [order, now].map(|order| format!("[{}]", names(order)));
        let help = format!(
            "it closes if the first axis of the control is {}: say so by `[machine] geometry_axes = {fitting}`; or check \
             start, end and centre",
            order[0].letter()
        );
        let answer = Answer::key("machine", "geometry_axes").one_of(&[fitting, current]);
        let span = w.arc_span();
        core.refuse(span, codes::P3001::circle_ends(&a.letter(), &b.letter()).help(answer.help(help)))
    }
}

/// Are start and end equally far from the centre, with I, J and K along the axes of `order`?
fn closes(core: &Core<'_>, st: &State, w: &Words, order: [Axis; 3], plane: Plane, end: &Pos) -> bool {
    let Some(start) = st.position.in_plane(plane) else { return false };
    let (first, second, _) = plane.axes();
    let (mut center, mut any): (Point2, bool) = (start, false);
    for (address, axis) in CENTER.into_iter().zip(order) {
        let Some(given) = w.get(address) else { continue };
        let place = match axis.index() {
            index if index == first => &mut center.x,
            index if index == second => &mut center.y,
            _ => return false,
        };
        let value = given.value * st.length_unit();
        match given.mode {
            Mode::Plain | Mode::Ic => *place += value,
            Mode::Ac => *place = value,
            _ => return false,
        }
        any = true;
    }
    let to = end_in(end, plane, start);
    let (at_start, at_end) = (distance(start, center), distance(to, center));
    any && at_start > SAME && at_end > SAME && (at_start - at_end).abs() <= core.circle_tolerance(at_start) + 1e-9
}

fn holds(plane: Plane, a: Axis, b: Axis) -> bool {
    let (first, second, _) = plane.axes();
    [a, b].iter().all(|axis| [first, second].contains(&axis.index()))
}
