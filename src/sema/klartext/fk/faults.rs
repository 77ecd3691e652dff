//! What is said of a free contour that has no solution, or more than one.

use crate::diag::{Diagnostic, Label, codes};
use crate::geo::open::Solved;
use crate::geo::open::window::{Fault, Item, Place, Serial, Shape};
use crate::geo::{Point2, distance};

use super::super::{Core, Reported};
use super::{Free, Kind, Waiting};

/// Solutions that are printed.
const MOST_SHOWN: usize = 6;
/// A word that tells two solutions apart differs by this at least, in mm.
const APART: f64 = 0.01;

fn item(waiting: &Waiting) -> Item {
    match waiting.kind {
        Kind::Element { item, .. } => item,
        Kind::Corner { .. } | Kind::Functions => Item::default(),
    }
}

fn name(item: &Item) -> &'static str {
    match (item.shape, item.smooth) {
        (Shape::Line, false) => "FL",
        (Shape::Line, true) => "FLT",
        (Shape::Arc(_), false) => "FC",
        (Shape::Arc(_), true) => "FCT",
    }
}

/// The first two lines in a row that lie on one straight, and of whose joint nothing is said.
fn open_joint(free: &Free) -> Option<[&Waiting; 2]> {
    let mut elements = free.queue.iter().filter(|waiting| matches!(waiting.kind, Kind::Element { .. }));
    let mut first = elements.next()?;
    for second in elements {
        let (a, b) = (item(first), item(second));
        let straight = a.shape == Shape::Line && b.shape == Shape::Line && b.smooth;
        let open = a.end == Place::default() && a.length.is_none() && a.closes.is_none() && b.length.is_none();
        if straight && open {
            return Some([first, second]);
        }
        first = second;
    }
    None
}

/// What is said of a free contour, in the letters of its plane.
pub(super) struct Told<'t, 'a> {
    pub core: &'t Core<'a>,
    pub letters: [char; 2],
}

impl Told<'_, '_> {
    /// A point as a program writes it, in the unit of the program.
    pub(super) fn shown(&self, p: Point2) -> String {
        let [first, second] = self.letters;
        let mm = self.core.mm();
        // No minus in front of nothing.
        let digits = |value: f64| format!("{:.4}", (value / mm * 1e4).round() / 1e4 + 0.0);
        format!("{first}{} {second}{}", digits(p.x), digits(p.y))
    }

    fn say(&self, free: &Free, waiting: &Waiting, found: Diagnostic) {
        let first = free.queue.iter().find(|waiting| matches!(waiting.kind, Kind::Element { .. }));
        let found = match first {
            Some(first) if !std::ptr::eq(first, waiting) => {
                found.also(first.here.loc(&self.core.job, first.span), Label::SolvedTogether)
            }
            _ => found,
        };
        self.core.job.diags.push(found.called(waiting.here.origin.call));
    }

    /// Reports why the contour has no solution.
    pub(super) fn fk_fault(&self, free: &Free, fault: &Fault) -> Reported {
        let waiting = free.waiting(fault.serial()).or(free.queue.back());
        let Some(waiting) = waiting else { return Reported };
        if matches!(fault, Fault::Open { missing: 0, .. })
            && let Some(joint) = open_joint(free)
        {
            return self.joint_is_open(free, joint);
        }
        let item = item(waiting);
        let (name, loc) = (name(&item), waiting.here.loc(&self.core.job, waiting.span));
        let found = match *fault {
            Fault::Open { missing: 0, .. } if item.center.radius.is_some() && item.center.angle.is_none() => {
                codes::K9002::has_ccpr_lacks_ccpa(&name).at(loc)
            }
            Fault::Open { missing: 0, .. } => {
                codes::K9002::blocks_behind_have_data_enough(&name).at(loc).help(self.wanted(&item))
            }
            Fault::Open { missing: 1, .. } => {
                codes::K3001::one_datum_is_missing(&name).at(loc).help(self.wanted(&item))
            }
            Fault::Open { missing, .. } => {
                codes::K3001::data_are_missing(&name, &missing).at(loc).help(self.wanted(&item))
            }
            Fault::Impossible { why, miss, .. } => {
                let by = miss.map(|miss| format!(", by {} mm", rounded(miss))).unwrap_or_default();
                codes::K3003::no_fits_its_data(&name, &why, &by).at(loc)
            }
            Fault::TooMany { .. } => codes::K9002::too_many_blocks(&name).at(loc),
        };
        self.say(free, waiting, found);
        Reported
    }

    /// Reports that two lines on one straight meet anywhere on it, however much else is known.
    fn joint_is_open(&self, free: &Free, [first, second]: [&Waiting; 2]) -> Reported {
        let names = [first, second].map(|waiting| name(&item(waiting)));
        let [x, y] = self.letters;
        let found = codes::K3001::behind_it_lie_on_one_straight(&names[0], &names[1], &x, &y)
            .at(first.here.loc(&self.core.job, first.span))
            .also(second.here.loc(&self.core.job, second.span), Label::SameStraight);
        self.say(free, first, found);
        Reported
    }

    /// The words that are missing in the element.
    fn wanted(&self, item: &Item) -> String {
        let [first, second] = self.letters;
        let mut words: Vec<String> = Vec::new();
        let mut offer = |missing: bool, word: String| {
            if missing {
                words.push(word);
            }
        };
        offer(item.end.x.is_none(), format!("{first} of the end"));
        offer(item.end.y.is_none(), format!("{second} of the end"));
        offer(item.angle.is_none() && !item.smooth, "AN".to_owned());
        if item.shape == Shape::Line {
            offer(item.length.is_none(), "LEN".to_owned());
        } else {
            offer(item.radius.is_none(), "R".to_owned());
            offer(item.center.radius.is_some() && item.center.angle.is_none(), "CCPA".to_owned());
            offer(item.center.x.is_none() && item.center.radius.is_none(), format!("CC{first} and CC{second}"));
        }
        match words.pop() {
            Some(last) if words.is_empty() => format!("write {last}"),
            Some(last) => format!("write {} or {last}", words.join(", ")),
            None => "write a datum into one of the blocks after it".to_owned(),
        }
    }

    /// Reports that the data leaves several solutions.
    pub(super) fn ambiguous(&self, free: &Free, serial: Serial, candidates: &[Solved]) {
        let Some(waiting) = free.waiting(serial) else { return };
        let item = item(waiting);
        let mut ends: Vec<String> = Vec::new();
        let same_end = candidates.windows(2).all(|pair| distance(pair[0].to, pair[1].to) <= APART);
        for one in candidates.iter().take(MOST_SHOWN) {
            let about = |(center, ccw): (Point2, bool)| {
                format!("{} about {}, DR{}", self.shown(one.to), self.shown(center), if ccw { '+' } else { '-' })
            };
            ends.push(match one.arc.filter(|_| same_end) {
                Some(arc) => about(arc),
                None => self.shown(one.to),
            });
        }
        if candidates.len() > MOST_SHOWN {
            ends.push("further ones".to_owned());
        }
        let chosen = match item.select {
            Some(number) if number as usize > candidates.len() => {
                format!("; FSELECT {number} asks for more solutions than there are")
            }
            Some(number) => format!("; which of them FSELECT {number} means is not documented"),
            None => String::new(),
        };
        let found = codes::K3002::has_solutions_that_fit_all_data(
            &name(&item),
            &candidates.len(),
            &ends.join(", or "),
            &chosen,
            &self.deciding(&item, candidates),
        )
        .at(waiting.here.loc(&self.core.job, waiting.span));
        self.say(free, waiting, found);
    }

    /// The word that tells the solutions apart.
    fn deciding(&self, item: &Item, candidates: &[Solved]) -> String {
        let [first, second] = self.letters;
        let differs = |of: fn(&Solved) -> Option<f64>| {
            candidates.iter().enumerate().all(|(i, a)| {
                candidates[..i].iter().all(|b| of(a).zip(of(b)).is_some_and(|(a, b)| (a - b).abs() > APART))
            })
        };
        if item.end.x.is_none() && differs(|one| Some(one.to.x)) {
            format!("{first} of its end")
        } else if item.end.y.is_none() && differs(|one| Some(one.to.y)) {
            format!("{second} of its end")
        } else if differs(|one| one.arc.map(|(center, _)| center.x)) {
            format!("CC{first}")
        } else if differs(|one| one.arc.map(|(center, _)| center.y)) {
            format!("CC{second}")
        } else if item.shape == Shape::Arc(None) {
            "DR+ or DR-".to_owned()
        } else {
            format!("{first} and {second} of its end")
        }
    }

    /// Says that a choice of the program was taken as controls were seen to take it.
    pub(super) fn warn_of_choice(&self, free: &Free, serial: Serial) {
        let Some(waiting) = free.waiting(serial) else { return };
        let item = item(waiting);
        let found = codes::K8022::has_several_solutions(&name(&item), &item.select.unwrap_or_default())
            .at(waiting.here.loc(&self.core.job, waiting.span));
        self.core.job.diags.push(found.called(waiting.here.origin.call));
    }
}

/// A deviation with the digits that say something.
fn rounded(miss: f64) -> String {
    if miss < 0.01 { format!("{miss:.4}") } else { format!("{miss:.3}") }
}
