//! Random contours of lines and arcs, described by random data: what is solved is the contour that was described, or it is
//! said that the data leaves several.

use super::*;
use crate::geo::{Deg, cross, left, turned};

/// Contours of the test, each described several times.
const CONTOURS: usize = 8_000;
/// What double arithmetic loses, and data that may disagree by 0.001 mm where contours nearly touch, in mm.
const NEAR: f64 = 0.05;

/// Reproducible, without a seed from outside.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.next()
    }

    fn below(&mut self, n: usize) -> usize {
        ((self.next() * n as f64) as usize).min(n - 1)
    }

    fn chance(&mut self, share: f64) -> bool {
        self.next() < share
    }
}

/// An element of the contour that is described.
#[derive(Debug, Clone, Copy)]
struct Whole {
    solved: Solved,
    entry: Vec2,
    exit: Vec2,
    smooth: bool,
    radius: f64,
    sweep: f64,
}

fn contour(random: &mut Random) -> Vec<Whole> {
    let mut at = Point2::new(random.between(-50.0, 50.0), random.between(-50.0, 50.0));
    let mut dir = Deg(random.between(0.0, 360.0)).unit();
    let count = 1 + random.below(5);
    let mut list = Vec::new();
    for i in 0..count {
        let smooth = i > 0 && random.chance(0.4);
        let entry = if smooth { dir } else { turned(dir, random.between(-2.8, 2.8)) };
        let straight = if smooth { list.last().is_some_and(|last: &Whole| last.solved.arc.is_some()) } else { true };
        if straight && random.chance(0.5) {
            let to = at + entry * random.between(2.0, 60.0);
            let solved = Solved::line(at, to);
            list.push(Whole { solved, entry, exit: entry, smooth, radius: 0.0, sweep: 0.0 });
            (at, dir) = (to, entry);
            continue;
        }
        let (radius, ccw) = (random.between(2.0, 40.0), random.chance(0.5));
        let sweep = random.between(0.2, 5.8);
        let turn = if ccw { sweep } else { -sweep };
        let center = at + left(entry) * if ccw { radius } else { -radius };
        let to = center + turned(at - center, turn);
        let exit = turned(entry, turn);
        list.push(Whole {
            solved: Solved { from: at, to, arc: Some((center, ccw)) },
            entry,
            exit,
            smooth,
            radius,
            sweep,
        });
        (at, dir) = (to, exit);
    }
    list
}

fn zero(value: f64) -> Option<Given> {
    Some(Given { value, from: Base::Zero })
}

/// One more datum of the element, if it has not got it; true if it was new.
fn add(item: &mut Item, whole: &Whole, before: &[Whole], random: &mut Random) -> bool {
    let (from, to) = (whole.solved.from, whole.solved.to);
    let pole = item.pole;
    let count = item.equations();
    let base = |random: &mut Random| match random.below(4) {
        0 => (Base::Start, from),
        1 if !before.is_empty() => {
            let of = random.below(before.len());
            (Base::Element(of), before[of].solved.to)
        }
        _ => (Base::Zero, Point2::origin()),
    };
    let angle_of = |v: Vec2| Deg::of(v).0;
    match random.below(if whole.solved.arc.is_some() { 14 } else { 10 }) {
        0 if item.end.x.is_none() => {
            let (base, at) = base(random);
            item.end.x = Some(Given { value: to.x - at.x, from: base });
        }
        1 if item.end.y.is_none() => {
            let (base, at) = base(random);
            item.end.y = Some(Given { value: to.y - at.y, from: base });
        }
        2 if item.end.radius.is_none() && random.chance(0.5) => item.end.radius = zero(distance(to, pole)),
        3 if item.end.angle.is_none() && random.chance(0.5) => item.end.angle = zero(angle_of(to - pole)),
        4 | 5 if item.angle.is_none() => {
            item.angle = match before.last() {
                Some(last) if random.chance(0.3) => {
                    let turn = libm::atan2(cross(last.exit, whole.entry), last.exit.dot(&whole.entry));
                    Some(Given { value: Deg::from_radians(turn).0, from: Base::Start })
                }
                _ => zero(angle_of(whole.entry)),
            };
        }
        6 if item.length.is_none() => item.length = Some(distance(from, to)),
        7 if item.through[0].is_none() => {
            item.through[0] = Some(match whole.solved.arc {
                Some((center, _)) => center + Deg(random.between(0.0, 360.0)).unit() * whole.radius,
                None => from + whole.entry * random.between(5.0, 80.0),
            });
        }
        8 if item.beside.is_none() => {
            let apart = random.between(1.0, 15.0);
            let p = match whole.solved.arc {
                Some((center, _)) => {
                    let out = if random.chance(0.5) || apart >= whole.radius { apart } else { -apart };
                    center + Deg(random.between(0.0, 360.0)).unit() * (whole.radius + out)
                }
                None => {
                    let side = if random.chance(0.5) { apart } else { -apart };
                    from + whole.entry * random.between(-20.0, 80.0) + left(whole.entry) * side
                }
            };
            item.beside = Some((p, apart));
        }
        9 if item.end.x.is_none() && item.end.y.is_none() && random.chance(0.5) => {
            (item.end.x, item.end.y) = (zero(to.x), zero(to.y));
        }
        10 if item.radius.is_none() => item.radius = Some(whole.radius),
        11 if item.end_angle.is_none() => {
            let (center, _) = whole.solved.arc.expect("an arc");
            item.end_angle = Some(if random.chance(0.7) {
                EndAngle::At(angle_of(to - center))
            } else {
                EndAngle::Swept(Deg::from_radians(whole.sweep).0)
            });
        }
        12 if item.center.count() == 0 => {
            let (center, _) = whole.solved.arc.expect("an arc");
            match random.below(4) {
                0 => item.center.x = zero(center.x),
                1 => item.center.y = zero(center.y),
                2 => item.center.angle = zero(angle_of(center - pole)),
                _ => item.center.radius = zero(distance(center, pole)),
            }
        }
        13 if item.center.count() == 0 => {
            let (center, _) = whole.solved.arc.expect("an arc");
            let (base, at) = if random.chance(0.3) { (Base::Start, from) } else { (Base::Zero, Point2::origin()) };
            item.center.x = Some(Given { value: center.x - at.x, from: base });
            item.center.y = Some(Given { value: center.y - at.y, from: base });
        }
        _ => {}
    }
    item.equations() > count
}

fn described(list: &[Whole], random: &mut Random) -> Vec<Item> {
    let mut items = Vec::new();
    let mut owed = 0usize;
    for (i, whole) in list.iter().enumerate() {
        let shape = match whole.solved.arc {
            None => Shape::Line,
            Some((_, ccw)) => Shape::Arc(Some(ccw).filter(|_| random.chance(0.95))),
        };
        let pole = Point2::new(random.between(-20.0, 20.0), random.between(-20.0, 20.0));
        let mut item = Item { shape, smooth: whole.smooth, pole, ..Item::default() };
        let mut wanted = item.unknowns() + owed;
        owed = 0;
        if i + 1 < list.len() && wanted > 0 && random.chance(0.4) {
            (wanted, owed) = (wanted - 1, 1);
        }
        let most = wanted + usize::from(random.chance(0.1));
        for _ in 0..60 {
            if item.equations() >= most {
                break;
            }
            add(&mut item, whole, &list[..i], random);
        }
        items.push(item);
    }
    items
}

/// What came of a description.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Came {
    Solved,
    /// In this element.
    Several(usize),
    /// From this element on; so many data are missing.
    Open(usize, usize),
    TooMany,
}

/// Solves the description, and compares with the contour.
fn solve(list: &[Whole], items: &[Item]) -> Came {
    let what = || format!("of {items:#?}\n{list:#?}");
    let mut window = Window::new(list[0].solved.from, None);
    let mut found = Vec::new();
    let mut result = Ok(());
    for item in items {
        result = window.push(*item);
        found.extend(std::iter::from_fn(|| window.settle()).map(|next| next.solved));
        if result.is_err() {
            break;
        }
    }
    let closed = result.and_then(|()| window.close(false));
    found.extend(std::iter::from_fn(|| window.settle()).map(|next| next.solved));
    for (found, whole) in found.iter().zip(list) {
        let same = distance(found.to, whole.solved.to) < NEAR
            && match (found.arc, whole.solved.arc) {
                (None, None) => true,
                (Some((a, ccw)), Some((b, other))) => distance(a, b) < NEAR && ccw == other,
                _ => false,
            };
        assert!(same, "{found:?}\nis not {whole:?}\n{}", what());
    }
    match closed {
        Ok(Closed::One { .. }) => {
            assert_eq!(found.len(), list.len());
            Came::Solved
        }
        Ok(Closed::Several { serial, candidates }) => {
            let to = list[serial].solved.to;
            assert!(candidates.len() > 1, "{candidates:?}\n{}", what());
            let near = |one: &Solved| distance(one.to, to) < NEAR;
            assert!(candidates.iter().any(near), "{candidates:?}\nmiss {to:?}\n{}", what());
            Came::Several(serial)
        }
        Err(Fault::Open { serial, missing }) => Came::Open(serial, missing),
        Err(Fault::TooMany { .. }) => Came::TooMany,
        Err(why) => panic!("{why:?}\n{}", what()),
    }
}

/// Random descriptions of random contours; where one leaves something open, data is added until it is solved.
#[test]
fn what_is_solved_is_what_was_described() {
    let mut random = Random(20_261_122);
    let (mut described_so_far, mut solved, mut several, mut open, mut unconstructed) = (0, 0, 0, 0, 0);
    for _ in 0..CONTOURS {
        let list = contour(&mut random);
        let mut items = described(&list, &mut random);
        for _ in 0..20 {
            described_so_far += 1;
            let at = match solve(&list, &items) {
                Came::Solved => {
                    solved += 1;
                    break;
                }
                Came::Several(at) => {
                    several += 1;
                    at
                }
                Came::Open(at, missing) => {
                    open += 1;
                    unconstructed += usize::from(missing == 0);
                    at
                }
                Came::TooMany => 0,
            };
            for _ in 0..40 {
                if add(&mut items[at], &list[at], &list[..at], &mut random) {
                    break;
                }
            }
        }
    }
    let counts = format!(
        "{described_so_far} described: {solved} solved, {several} ambiguous, {open} open ({unconstructed} not constructed)"
    );
    eprintln!("{counts}");
    assert!(described_so_far >= 20_000 && solved * 10 >= CONTOURS * 9, "{counts}");
    // What could be constructed once can be: a rule that is lost asks for more data.
    assert!(solved == CONTOURS && described_so_far <= 24_915 && several <= 8_202 && open <= 8_713, "{counts}");
}
