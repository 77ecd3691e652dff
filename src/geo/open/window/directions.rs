//! Directions of travel at the ends of elements.

use crate::geo::{Vec2, arc, direction, left};

use super::state::{Fact, View, spun};
use super::{Base, EndAngle, Made, ONE};

/// The direction in which an element begins; that of a line.
pub(super) fn entry(view: &View<'_>, node: usize) -> Made {
    if view.node(node).entry.is_some() {
        return Ok(Vec::new());
    }
    if view.is_line(node) {
        return of_line(view, node);
    }
    let (of, item) = (view.node(node), view.item(node));
    let smooth = || view.before(node).filter(|_| item.smooth);
    let from_center = || {
        let (center, _) = view.circle(node)?;
        arc::tangent_at(view.start(node)?, center, of.ccw)
    };
    let swept = || match item.end_angle? {
        EndAngle::Swept(angle) => of.exit.map(|exit| spun(exit, if of.ccw { -angle } else { angle })),
        EndAngle::At(_) => None,
    };
    let found = view.written_direction(node).or_else(smooth).or_else(from_center).or_else(swept);
    Ok(match (found, of.exit) {
        (Some(u), _) => vec![Fact::Entry(u)],
        (None, Some(exit)) => {
            chord_sweeps(view, node)?.into_iter().map(|sweep| Fact::Entry(crate::geo::turned(exit, -sweep))).collect()
        }
        (None, None) => Vec::new(),
    })
}

/// The direction in which an arc ends, or the one that a line takes from what is behind it.
pub(super) fn exit(view: &View<'_>, node: usize) -> Made {
    let of = view.node(node);
    if of.exit.is_some() {
        return Ok(Vec::new());
    }
    if view.is_line(node) {
        return Ok(of.entry.map(Fact::Exit).into_iter().collect());
    }
    let by_angle = || match view.item(node).end_angle? {
        EndAngle::At(angle) => {
            let out = left(spun(Vec2::x(), angle));
            Some(if of.ccw { out } else { -out })
        }
        EndAngle::Swept(angle) => of.entry.map(|entry| spun(entry, if of.ccw { angle } else { -angle })),
    };
    let from_center = || {
        let (center, _) = view.circle(node)?;
        arc::tangent_at(view.end(node)?, center, of.ccw)
    };
    let found = by_angle().or_else(from_center).or_else(|| from_behind(view, node));
    Ok(match (found, of.entry) {
        (Some(u), _) => vec![Fact::Exit(u)],
        (None, Some(entry)) => {
            chord_sweeps(view, node)?.into_iter().map(|sweep| Fact::Exit(crate::geo::turned(entry, sweep))).collect()
        }
        (None, None) => Vec::new(),
    })
}

fn of_line(view: &View<'_>, node: usize) -> Made {
    let item = view.item(node);
    let smooth = || view.before(node).filter(|_| item.smooth);
    if let Some(u) = view.written_direction(node).or_else(smooth) {
        return Ok(vec![Fact::Entry(u)]);
    }
    if let (Some(start), Some(end)) = (view.start(node), view.end(node)) {
        let u = direction(end - start, ONE).ok_or(("it has no length", None))?;
        return Ok(vec![Fact::Entry(u)]);
    }
    if let Some(u) = from_behind(view, node) {
        return Ok(vec![Fact::Entry(u)]);
    }
    let either = |u: Vec2| vec![Fact::Entry(u), Fact::Entry(-u)];
    if let Some(u) = item.parallel.and_then(|(of, _)| view.exit_of(of)) {
        return Ok(either(u));
    }
    let serial = view.window.first + node;
    let beside = view.window.items.iter().position(|other| other.parallel.is_some_and(|(of, _)| of == serial));
    Ok(beside.and_then(|other| view.node(other).entry).map(either).unwrap_or_default())
}

/// The direction at the end that later elements say.
fn from_behind(view: &View<'_>, node: usize) -> Option<Vec2> {
    let tangent = |next| {
        let (center, _) = view.circle(next)?;
        arc::tangent_at(view.end(node)?, center, view.node(next).ccw)
    };
    if let Some((next, item)) = view.next(node)
        && let Some(entry) = view.node(next).entry.or_else(|| tangent(next))
    {
        match item.angle {
            _ if item.smooth => return Some(entry),
            Some(given) if given.from == Base::Start => return Some(spun(entry, -given.value)),
            _ => {}
        }
    }
    let serial = Base::Element(view.window.first + node);
    let (other, angle) =
        view.window.items.iter().enumerate().find_map(|(other, item)| {
            item.angle.filter(|given| given.from == serial).map(|given| (other, given.value))
        })?;
    view.node(other).entry.map(|entry| spun(entry, -angle))
}

/// What an arc can sweep by its chord and radius, in rad with sign.
fn chord_sweeps(view: &View<'_>, node: usize) -> Result<Vec<f64>, (&'static str, Option<f64>)> {
    let (Some(length), Some(rho)) = (view.item(node).length, view.node(node).rho) else { return Ok(Vec::new()) };
    let share = length / (2.0 * rho.abs());
    if share > 1.0 {
        return Err(("LEN is longer than its diameter", Some(length - 2.0 * rho.abs())));
    }
    let half = libm::asin(share);
    let sign = rho.signum();
    Ok(vec![2.0 * half * sign, (core::f64::consts::TAU - 2.0 * half) * sign])
}
