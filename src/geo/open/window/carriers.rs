//! The line or circle that an element lies on.

use crate::geo::{Point2, SAME_DIRECTION, Vec2, arc, direction, distance, left, turned};

use super::joints::{self, Locus};
use super::state::{Fact, View};
use super::{AGREES, Made, ONE};

/// Conditions that differ by less say the same.
const DEPENDENT: f64 = 1e-7;

/// Something that a carrier touches in its direction of travel: a circle with its radius by sense, a point with radius 0.
#[derive(Debug, Clone, Copy)]
struct Contact {
    at: Point2,
    rho: f64,
    /// Its other side as well.
    either: bool,
}

impl Contact {
    fn point(at: Point2) -> Contact {
        Contact { at, rho: 0.0, either: false }
    }

    fn circle((at, rho): (Point2, f64)) -> Contact {
        Contact { at, rho, either: false }
    }

    fn beside((at, distance): (Point2, f64)) -> Contact {
        Contact { at, rho: distance, either: distance > 0.0 }
    }

    fn sides(self) -> impl Iterator<Item = f64> {
        std::iter::once(self.rho).chain(self.either.then_some(-self.rho))
    }
}

/// The radius of an arc.
pub(super) fn radius(view: &View<'_>, node: usize) -> Made {
    let (of, item) = (view.node(node), view.item(node));
    if of.rho.is_some() || view.is_line(node) {
        return Ok(Vec::new());
    }
    let by_chord = || {
        let (entry, exit, length) = (of.entry?, of.exit?, item.length?);
        // Half of the chord over the sine of half the sweep.
        let sweep = arc::sweep(Point2::origin() + entry, Point2::origin() + exit, Point2::origin(), of.ccw);
        let sine = libm::sin(sweep / 2.0).abs();
        (sine > ONE).then(|| length / (2.0 * sine))
    };
    let radius = item.radius.or_else(by_chord);
    Ok(radius.map(|radius| Fact::Radius(if of.ccw { radius } else { -radius })).into_iter().collect())
}

pub(super) fn carrier(view: &View<'_>, node: usize) -> Made {
    if view.is_line(node) { line(view, node) } else { circle(view, node) }
}

fn line(view: &View<'_>, node: usize) -> Made {
    let of = view.node(node);
    if of.on.is_some() {
        return Ok(Vec::new());
    }
    let contacts = contacts_of_line(view, node);
    if let Some(u) = of.entry {
        // C − ρ·left(u) lies on it.
        let found = |contact: &Contact| contact.sides().map(|rho| Fact::Line(contact.at - left(u) * rho, u)).collect();
        return Ok(contacts.first().map(found).unwrap_or_default());
    }
    let mut far = contacts.iter().enumerate().flat_map(|(i, a)| contacts[i + 1..].iter().map(move |b| (a, b)));
    let Some((a, b)) = far.find(|(a, b)| distance(a.at, b.at) > AGREES) else { return Ok(Vec::new()) };
    let mut facts = Vec::new();
    let mut miss = f64::INFINITY;
    for ra in a.sides() {
        for rb in b.sides() {
            tangents(a.at, ra, b.at, rb, &mut facts, &mut miss);
        }
    }
    if facts.is_empty() { Err(("no line touches both", Some(miss))) } else { Ok(facts) }
}

/// The lines with `left(u)·(B − A) = rb − ra`.
fn tangents(a: Point2, ra: f64, b: Point2, rb: f64, facts: &mut Vec<Fact>, miss: &mut f64) {
    let (apart, step) = (distance(a, b), rb - ra);
    if step.abs() > apart + AGREES {
        *miss = miss.min(step.abs() - apart);
        return;
    }
    let Some(way) = direction(b - a, 0.0) else { return };
    let aside = libm::asin((step / apart).clamp(-1.0, 1.0));
    for angle in [aside, core::f64::consts::PI - aside] {
        let u = if aside == 0.0 { if angle == 0.0 { way } else { -way } } else { turned(way, -angle) };
        facts.push(Fact::Line(a - left(u) * ra, u));
        if step.abs() >= apart {
            return;
        }
    }
}

fn contacts_of_line(view: &View<'_>, node: usize) -> Vec<Contact> {
    let item = view.item(node);
    let mut list: Vec<Contact> = Vec::new();
    list.extend(view.start(node).map(Contact::point));
    list.extend(view.end(node).map(Contact::point));
    list.extend(item.through.iter().flatten().copied().map(Contact::point));
    neighbours(view, node, &mut list);
    list.extend(item.beside.map(Contact::beside));
    if let Some(u) = view.node(node).entry {
        // An end somewhere on a line that runs along the element fixes it: `FL AN+0 Y+40`.
        let ends = [joints::border(view, node, true), joints::border(view, node, false)];
        list.extend(ends.iter().flatten().filter_map(|locus| match *locus {
            Locus::Line(at, w, _) if crate::geo::cross(u, w).abs() <= SAME_DIRECTION => Some(Contact::point(at)),
            _ => None,
        }));
    }
    if let Some((of, Some(apart))) = item.parallel
        && view.node(node).entry.is_some()
        && let Some(at) = view.point_of(of).filter(|_| view.exit_of(of).is_some())
    {
        list.push(Contact::beside((at, apart)));
    }
    list
}

/// Circles that the element goes over into, and those that go over into it.
fn neighbours(view: &View<'_>, node: usize, list: &mut Vec<Contact>) {
    let of = view.node(node);
    // Where the joint and the direction in it are known, the neighbour says nothing new.
    if view.item(node).smooth && !(view.start(node).is_some() && of.entry.is_some()) {
        list.extend(node.checked_sub(1).and_then(|before| view.circle(before)).map(Contact::circle));
    }
    if of.end.is_some() && of.exit.is_some() {
        return;
    }
    list.extend(view.smooth_next(node).and_then(|next| view.circle(next)).map(Contact::circle));
}

/// Conditions on centre and radius of a circle.
#[derive(Debug, Default)]
struct Conditions {
    /// `a·x + b·y + k·ρ = m`, independent of each other.
    rows: Vec<[f64; 4]>,
    contacts: Vec<Contact>,
    /// The centre lies on a circle.
    around: Option<(Point2, f64)>,
}

impl Conditions {
    fn row(&mut self, normal: Vec2, k: f64, m: f64) {
        let mut row = [normal.x, normal.y, k, m];
        // What the rows in front say already.
        for old in &self.rows {
            let pivot = pivot(old);
            let share = row[pivot] / old[pivot];
            for i in 0..4 {
                row[i] -= share * old[i];
            }
            row[pivot] = 0.0;
        }
        let size = row[..3].iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        if size > DEPENDENT {
            self.rows.push(row.map(|value| value / size));
        }
    }

    /// The centre is `at + ρ·left(u)`.
    fn normal_at(&mut self, at: Point2, u: Vec2) {
        let aside = left(u);
        self.row(Vec2::x(), -aside.x, at.x);
        self.row(Vec2::y(), -aside.y, at.y);
    }

    /// A border point of the arc, where it travels along `u`, lies on the locus.
    fn border(&mut self, locus: &Locus, u: Vec2, rho: Option<f64>) {
        match *locus {
            Locus::Point(at) => self.normal_at(at, u),
            Locus::Line(at, w, _) => {
                let normal = left(w);
                self.row(normal, -normal.dot(&left(u)), normal.dot(&at.coords));
            }
            Locus::Circle(at, radius) => {
                if let Some(rho) = rho {
                    self.around.get_or_insert((at + left(u) * rho, radius));
                }
            }
        }
    }

    /// Centre and radius, in up to two solutions a side.
    fn solve(mut self, ccw: bool) -> Made {
        // With a known radius a circle about a point is one that it touches.
        if let Some(known) = self.radius()
            && let Some((at, radius)) = self.around.take()
        {
            self.contacts.insert(0, Contact { at, rho: known - radius, either: false });
        }
        let needed = 3usize.saturating_sub(self.rows.len());
        self.contacts.sort_by_key(|contact| contact.either);
        let same = |a: &Contact, b: &Contact| distance(a.at, b.at) <= AGREES && (a.rho - b.rho).abs() <= AGREES;
        self.contacts.dedup_by(|a, b| same(a, b));
        let mut found = Vec::new();
        let mut miss = f64::INFINITY;
        if self.rows.len() == 3 {
            self.along(None, &mut found, &mut miss);
        } else if let Some((at, radius)) = self.around {
            self.on_circle(at, radius, &mut found, &mut miss)?;
        } else if self.contacts.len() >= needed {
            for sides in 0..1 << needed.min(3) {
                let chosen: Option<Vec<(Point2, f64)>> = (0..needed)
                    .map(|i| {
                        let contact = &self.contacts[i];
                        match sides >> i & 1 {
                            0 => Some((contact.at, contact.rho)),
                            _ => contact.either.then_some((contact.at, -contact.rho)),
                        }
                    })
                    .collect();
                if let Some(chosen) = chosen {
                    self.touching(&chosen, &mut found, &mut miss);
                }
            }
        } else {
            return Ok(Vec::new());
        }
        // Rows that a contact adds may not have been independent.
        if found.is_empty() && miss.is_infinite() {
            return Ok(Vec::new());
        }
        let turns = |(_, rho): &(Point2, f64)| if ccw { *rho > ONE } else { *rho < -ONE };
        let mut facts: Vec<(Point2, f64)> = Vec::new();
        for circle in found.into_iter().filter(turns) {
            if !facts.iter().any(|old| distance(old.0, circle.0) <= ONE && (old.1 - circle.1).abs() <= ONE) {
                facts.push(circle);
            }
        }
        if facts.is_empty() {
            return Err(("no arc that turns this way fits", Some(miss).filter(|miss| miss.is_finite() && *miss > 0.0)));
        }
        Ok(facts.into_iter().map(|(center, rho)| Fact::Circle(center, rho)).collect())
    }

    /// The radius, where a row says it alone.
    fn radius(&self) -> Option<f64> {
        self.rows.iter().find(|row| row[0] == 0.0 && row[1] == 0.0).map(|row| row[3] / row[2])
    }

    /// Circles that touch the first contact; the others become rows, by the difference of their equations.
    fn touching(&self, contacts: &[(Point2, f64)], found: &mut Vec<(Point2, f64)>, miss: &mut f64) {
        let mut rest = Conditions { rows: self.rows.clone(), ..Conditions::default() };
        let Some(&(p, r)) = contacts.first() else { return };
        for &(q, s) in &contacts[1..] {
            let way = q - p;
            let m = q.coords.dot(&q.coords) - p.coords.dot(&p.coords) - s * s + r * r;
            rest.row(way * 2.0, -2.0 * (s - r), m);
        }
        rest.along(Some((p, r)), found, miss);
    }

    /// What the rows leave: one circle, or a line of them of which those count that touch.
    fn along(&self, touch: Option<(Point2, f64)>, found: &mut Vec<(Point2, f64)>, miss: &mut f64) {
        let Some((at, free)) = self.line() else { return };
        let Some(free) = free else {
            found.push((Point2::new(at[0], at[1]), at[2]));
            *miss = 0.0;
            return;
        };
        let Some((p, r)) = touch else { return };
        let (from, way) = (Vec2::new(at[0] - p.x, at[1] - p.y), Vec2::new(free[0], free[1]));
        let (level, rise) = (at[2] - r, free[2]);
        let a = way.dot(&way) - rise * rise;
        let b = from.dot(&way) - level * rise;
        let c = from.dot(&from) - level * level;
        for t in roots(a, b, c, miss) {
            found.push((Point2::new(at[0] + t * free[0], at[1] + t * free[1]), at[2] + t * rise));
        }
    }

    /// The centre lies on a circle and on a line that says nothing of the radius; a contact gives the radius.
    fn on_circle(
        &self,
        at: Point2,
        radius: f64,
        found: &mut Vec<(Point2, f64)>,
        miss: &mut f64,
    ) -> Result<(), (&'static str, Option<f64>)> {
        let level = self.rows.iter().find(|row| row[2] == 0.0);
        let Some((row, contact)) = level.zip(self.contacts.first()) else { return Ok(()) };
        let normal = Vec2::new(row[0], row[1]);
        let size = normal.norm();
        let foot = Point2::from(normal * (row[3] / (size * size)));
        let Some(points) = crate::geo::intersect::line_circle(foot, left(normal) / size, at, radius, AGREES) else {
            return Err(("its centre cannot meet all of its data", None));
        };
        for center in points {
            for rho in contact.sides() {
                // |C − P| = |ρ − r|
                let apart = distance(center, contact.at);
                found.push((center, rho + apart));
                found.push((center, rho - apart));
            }
        }
        *miss = 0.0;
        Ok(())
    }

    /// The point that three rows give, or a point and the direction of the line that two leave.
    fn line(&self) -> Option<([f64; 3], Option<[f64; 3]>)> {
        let [first, second, rest @ ..] = self.rows.as_slice() else { return None };
        let normal = |row: &[f64; 4]| nalgebra::Vector3::new(row[0], row[1], row[2]);
        let (n1, n2) = (normal(first), normal(second));
        let free = n1.cross(&n2);
        let third = rest.first().map_or((free, 0.0), |row| (normal(row), row[3]));
        let rows = nalgebra::Matrix3::from_rows(&[n1.transpose(), n2.transpose(), third.0.transpose()]);
        let at = rows.lu().solve(&nalgebra::Vector3::new(first[3], second[3], third.1))?;
        let free = rest.is_empty().then(|| free / free.norm());
        Some((at.into(), free.map(Into::into)))
    }
}

fn pivot(row: &[f64; 4]) -> usize {
    (0..3).max_by(|a, b| row[*a].abs().total_cmp(&row[*b].abs())).unwrap_or(0)
}

/// Roots of `a·t² + 2·b·t + c`; one where it only touches zero.
fn roots(a: f64, b: f64, c: f64, miss: &mut f64) -> Vec<f64> {
    if a.abs() <= 1e-12 {
        // The contact says what the rows say.
        if b.abs() <= DEPENDENT * c.abs().sqrt().max(1.0) {
            return Vec::new();
        }
        *miss = 0.0;
        return vec![-c / (2.0 * b)];
    }
    let square = b * b - a * c;
    let scale = (a.abs() * c.abs()).max(b * b).max(1e-12);
    if square < 0.0 {
        // How far the best one misses, as a length.
        let least = (square / a).abs();
        let short = least / (2.0 * c.abs().sqrt().max(ONE));
        *miss = miss.min(short);
        return if short <= AGREES || square >= -1e-14 * scale { vec![-b / a] } else { Vec::new() };
    }
    *miss = 0.0;
    let root = square.sqrt();
    // Without loss of digits where one root is next to nothing.
    let q = -(b + if b < 0.0 { -root } else { root });
    if q == 0.0 { vec![0.0] } else { vec![q / a, c / q] }
}

fn circle(view: &View<'_>, node: usize) -> Made {
    let (of, item) = (view.node(node), view.item(node));
    if of.center.is_some() {
        return Ok(Vec::new());
    }
    let mut all = Conditions::default();
    place(view, node, &mut all);
    if let Some(rho) = of.rho {
        all.row(Vec2::zeros(), 1.0, rho);
    }
    for (at, u, at_start) in [(view.start(node), of.entry, true), (view.end(node), of.exit, false)] {
        match (at, u) {
            (Some(at), Some(u)) => all.normal_at(at, u),
            (Some(at), None) => all.contacts.push(Contact::point(at)),
            (None, Some(u)) => {
                joints::border(view, node, at_start).iter().for_each(|locus| all.border(locus, u, of.rho));
            }
            (None, None) => {}
        }
    }
    for (neighbour, smooth) in
        [(node.checked_sub(1), item.smooth), (view.smooth_next(node), view.smooth_next(node).is_some())]
    {
        if let Some((at, u)) = neighbour.filter(|_| smooth).and_then(|neighbour| view.line(neighbour)) {
            let normal = left(u);
            all.row(normal, -1.0, normal.dot(&at.coords));
        }
    }
    all.contacts.extend(item.through.iter().flatten().copied().map(Contact::point));
    neighbours(view, node, &mut all.contacts);
    all.contacts.extend(item.beside.map(Contact::beside));
    all.solve(of.ccw)
}

/// What is written of the centre.
fn place(view: &View<'_>, node: usize, all: &mut Conditions) {
    let mut loci = Vec::new();
    joints::written(&view.known_center(node), view.item(node).pole, &mut loci);
    for locus in loci {
        match locus {
            Locus::Point(at) => {
                all.row(Vec2::x(), 0.0, at.x);
                all.row(Vec2::y(), 0.0, at.y);
            }
            Locus::Line(at, u, _) => {
                let normal = left(u);
                all.row(normal, 0.0, normal.dot(&at.coords));
            }
            Locus::Circle(at, radius) => all.around = Some((at, radius)),
        }
    }
}
