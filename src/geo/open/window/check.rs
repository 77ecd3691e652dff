//! A complete element against all of its data.

use crate::geo::{Point2, SAME_POINT, Vec2, arc, cross, distance};

use super::joints::{Locus, written};
use super::state::{Fact, View, spun};
use super::{AGREES, AGREES_TURN, EndAngle, Made, ONE};

type Checked = Result<(), (&'static str, Option<f64>)>;

/// Marks an element of which everything is known, if it meets its data.
pub(super) fn complete(view: &View<'_>, node: usize) -> Made {
    let of = view.node(node);
    // Without the direction in front nobody knows yet whether a smooth one agrees.
    let goes_on = !view.item(node).smooth || view.before(node).is_some();
    if of.checked || !goes_on || !view.has_references(node) {
        return Ok(Vec::new());
    }
    let (Some(start), Some(end), Some(_), Some(_)) = (view.start(node), view.end(node), of.entry, of.exit) else {
        return Ok(Vec::new());
    };
    if let Some((on, u)) = view.line(node) {
        line(view, node, (start, end), (on, u))?;
    } else if let Some(circle) = view.circle(node) {
        circle_of(view, node, (start, end), circle)?;
    } else {
        return Ok(Vec::new());
    }
    Ok(vec![Fact::Checked])
}

fn within(miss: f64, why: &'static str) -> Checked {
    if miss <= AGREES { Ok(()) } else { Err((why, Some(miss))) }
}

/// Do two directions agree, over an element of this length?
fn aims(u: Vec2, wanted: Vec2, over: f64, why: &'static str) -> Checked {
    let turn = libm::atan2(cross(u, wanted), u.dot(&wanted)).abs();
    if turn <= AGREES_TURN || turn * over <= AGREES && turn < 0.1 { Ok(()) } else { Err((why, None)) }
}

fn line(view: &View<'_>, node: usize, (start, end): (Point2, Point2), (on, u): (Point2, Vec2)) -> Checked {
    let item = view.item(node);
    let way = end - start;
    let length = distance(start, end);
    if length <= ONE || way.dot(&u) <= 0.0 {
        return Err(("it would run backwards", None));
    }
    within(cross(u, start - on).abs().max(cross(u, end - on).abs()), "its ends do not lie on its line")?;
    let along = way / length;
    shared(view, node, end, along, length)?;
    if let Some((of, apart)) = item.parallel
        && let (Some(other), Some(at)) = (view.exit_of(of), view.point_of(of))
    {
        let same = if along.dot(&other) < 0.0 { -other } else { other };
        aims(along, same, length, "it is not parallel to the element of PAR")?;
        if let Some(apart) = apart {
            within((cross(along, at - start).abs() - apart).abs(), "DP is missed")?;
        }
    }
    for p in item.through.iter().flatten() {
        within(cross(along, p - start).abs(), "it does not lead through its auxiliary point")?;
    }
    if let Some((p, apart)) = item.beside {
        within((cross(along, p - start).abs() - apart).abs(), "the distance D is missed")?;
    }
    Ok(())
}

fn circle_of(view: &View<'_>, node: usize, (start, end): (Point2, Point2), (center, rho): (Point2, f64)) -> Checked {
    let (of, item) = (view.node(node), view.item(node));
    let radius = rho.abs();
    let off = |p: Point2| (distance(p, center) - radius).abs();
    within(off(start).max(off(end)), "its ends do not lie on its circle")?;
    if radius <= SAME_POINT {
        return Err(("its radius is nothing", None));
    }
    let tangent = |at| arc::tangent_at(at, center, of.ccw).ok_or(("its radius is nothing", None));
    let (entry, exit) = (tangent(start)?, tangent(end)?);
    shared(view, node, end, entry, radius)?;
    if let Some(wanted) = of.exit {
        aims(exit, wanted, radius, "the direction at its end does not agree")?;
    }
    match item.end_angle {
        Some(EndAngle::At(angle)) => {
            aims((end - center) / radius, spun(Vec2::x(), angle), radius, "CCA is missed at its end")?;
        }
        Some(EndAngle::Swept(angle)) => {
            let wanted = spun(entry, if of.ccw { angle } else { -angle });
            aims(exit, wanted, radius, "CCA is missed at its end")?;
        }
        None => {}
    }
    if let Some(wanted) = item.radius {
        within((radius - wanted).abs(), "R is missed")?;
    }
    placed(&view.known_center(node), item.pole, center, "the centre is missed")?;
    for p in item.through.iter().flatten() {
        within(off(*p), "it does not lead through its auxiliary point")?;
    }
    if let Some((p, apart)) = item.beside {
        within((off(p) - apart).abs(), "the distance D is missed")?;
    }
    Ok(())
}

/// Data that lines and arcs share.
fn shared(view: &View<'_>, node: usize, end: Point2, entry: Vec2, over: f64) -> Checked {
    let item = view.item(node);
    placed(&view.known_end(node), item.pole, end, "the end point is missed")?;
    if item.closes.is_some() {
        placed(&view.written_end(node), item.pole, end, "CLSD- ends elsewhere than its coordinates say")?;
    }
    if let Some(wanted) = view.node(node).entry {
        aims(entry, wanted, over, "the direction at its start does not agree")?;
    }
    if let Some(wanted) = view.written_direction(node) {
        aims(entry, wanted, over, "the angle is missed")?;
    }
    if item.smooth
        && let Some(before) = view.before(node)
    {
        aims(entry, before, over, "it does not go on tangentially")?;
    }
    if let (Some(length), Some(start)) = (item.length, view.start(node)) {
        within((distance(start, end) - length).abs(), "LEN is missed")?;
    }
    Ok(())
}

fn placed(known: &super::state::Known, pole: Point2, p: Point2, why: &'static str) -> Checked {
    let mut loci: Vec<Locus> = Vec::new();
    written(known, pole, &mut loci);
    within(loci.iter().map(|locus| locus.miss(p)).fold(0.0, f64::max), why)
}
