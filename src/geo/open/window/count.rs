//! What a window lacks: unknowns that are left against equations that are not used up.

use super::state::View;
use super::{EndAngle, Shape};

/// How many more data the elements from this one on need.
pub(super) fn missing(view: &View<'_>, from: usize) -> usize {
    let (mut unknowns, mut equations) = (0, 0);
    for node in from..view.window.items.len() {
        unknowns += unknowns_of(view, node);
        equations += border_equations(view, node) + word_equations(view, node);
    }
    unknowns.saturating_sub(equations)
}

/// Coordinates of its end, of its carrier, and the directions of an arc.
fn unknowns_of(view: &View<'_>, node: usize) -> usize {
    let of = view.node(node);
    let one = usize::from;
    let carrier = if view.is_line(node) {
        one(of.entry.is_none()) + one(of.on.is_none())
    } else {
        2 * one(of.center.is_none()) + one(of.rho.is_none()) + one(of.entry.is_none()) + one(of.exit.is_none())
    };
    carrier + 2 * one(of.end.is_none())
}

fn has_carrier(view: &View<'_>, node: usize) -> bool {
    view.line(node).is_some() || view.circle(node).is_some()
}

/// Both ends lie on the carrier, an arc has its directions there, and the element goes on as the one before ends.
fn border_equations(view: &View<'_>, node: usize) -> usize {
    let of = view.node(node);
    let known = has_carrier(view, node);
    let (start, end) = (view.start(node).is_some(), view.end(node).is_some());
    let one = |all: bool| usize::from(!all);
    let tangents = match view.item(node).shape {
        Shape::Line => 0,
        Shape::Arc(_) => one(known && start && of.entry.is_some()) + one(known && end && of.exit.is_some()),
    };
    let smooth = one(!view.item(node).smooth || of.entry.is_some() && view.before(node).is_some());
    one(known && start) + one(known && end) + tangents + smooth
}

fn word_equations(view: &View<'_>, node: usize) -> usize {
    let (of, item) = (view.node(node), view.item(node));
    let (start, end) = (view.start(node).is_some(), view.end(node).is_some());
    let count = |open: bool, words: usize| if open { words } else { 0 };
    let carrier = !has_carrier(view, node);
    let has = usize::from;
    let turn = match item.end_angle {
        Some(EndAngle::At(_)) => of.exit.is_none(),
        Some(EndAngle::Swept(_)) => of.exit.is_none() || of.entry.is_none(),
        None => false,
    };
    count(!end, item.end.count() + 2 * has(item.closes.is_some()))
        + count(of.center.is_none(), item.center.count())
        + count(of.entry.is_none(), has(item.angle.is_some()) + has(item.parallel.is_some()))
        + count(!(start && end), has(item.length.is_some()))
        + count(of.rho.is_none(), has(item.radius.is_some()))
        + has(turn)
        + count(carrier, item.through.iter().flatten().count() + has(item.beside.is_some()))
        + count(of.on.is_none(), has(item.parallel.is_some_and(|(_, apart)| apart.is_some())))
}
