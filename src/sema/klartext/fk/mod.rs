//! Free contours: FPOL, FL, FLT, FC, FCT and FSELECT.
//!
//! An element goes out as soon as it is the same in every solution that is left; until then it waits, and with it the
//! chamfers, roundings and M functions between the elements. A block that is not of the contour ends it: what is still
//! open then is an error. Source: K 2.11 and FK part A (docs/sources.md).

mod faults;
mod words;

use std::collections::VecDeque;

use crate::diag::{Answer, codes};
use crate::geo::open::window::{Closed, EndAngle, Item, MOST_BACK, Serial, Settled, Window};
use crate::geo::{Plane, Point2, distance};
use crate::ir::Pos;
use crate::machine::{Axis, AxisSet};
use crate::parser::klartext::ast::{Addr, Block, FkHead, PathFn, Stmt};
use crate::sema::run::{Site, Where};
use crate::text::{Loc, Span};

use super::path::{Motion, corner_head, corner_words};
use super::words::{Admits, Words};
use super::{Core, Outcome, Reported, Run};
use faults::Told;
use words::Elements;

/// Chamfers, roundings and blocks of M functions that may wait with the elements.
const MOST_BETWEEN: usize = 256;
/// How far apart two readings of CCA end that are one, in mm.
const SAME_READING: f64 = 0.001;

/// What is known of free contours from block to block.
#[derive(Debug)]
pub(super) struct Free {
    window: Window,
    /// Blocks that wait, in their order.
    queue: VecDeque<Waiting>,
    /// Block numbers of the elements that data can refer to.
    numbers: VecDeque<(u32, Serial, Loc)>,
    pole: Option<Point2>,
    /// The element with CLSD+ that no CLSD- has closed, and the word.
    closes: Option<(Serial, Loc)>,
    /// The coordinate system that all this counts in.
    system: u32,
}

#[derive(Debug)]
struct Waiting {
    kind: Kind,
    words: Box<Words>,
    here: Site,
    span: Span,
}

#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "most of what waits are elements")]
enum Kind {
    Element { serial: Serial, item: Item },
    Corner { rounding: bool },
    Functions,
}

impl Free {
    fn new(system: u32) -> Free {
        Free {
            window: Window::new(Point2::origin(), None),
            queue: VecDeque::new(),
            numbers: VecDeque::new(),
            pole: None,
            closes: None,
            system,
        }
    }

    /// A block that waits; false where too many do.
    fn wait(&mut self, waiting: Waiting) -> bool {
        let room = self.queue.len() < MOST_BETWEEN;
        if room {
            self.queue.push_back(waiting);
        }
        room
    }

    /// FSELECT chooses a solution of the element in front.
    fn select(&mut self, core: &Core<'_>, number: Option<f64>) -> Outcome {
        let number = number.filter(|number| number.fract() == 0.0 && (1.0..=99.0).contains(number));
        let Some(number) = number else {
            return core.refuse(Where::Block, codes::P1004::fselect_needs_number_of_solution());
        };
        if self.window.next_serial() == 0 {
            return core.refuse(Where::Block, codes::K3004::fselect_chooses_solution_of_element_in_front());
        }
        self.window.select(number as u32);
        let last = self.queue.iter_mut().rev().find_map(|waiting| match &mut waiting.kind {
            Kind::Element { item, .. } => Some(item),
            Kind::Corner { .. } | Kind::Functions => None,
        });
        if let Some(item) = last {
            item.select = Some(number as u32);
        }
        Ok(())
    }

    /// FPOL
    fn set_pole(&mut self, core: &Core<'_>, w: &Words, plane: Plane) -> Outcome {
        let whole = w.axes.known().len() == 2 && w.incremental.is_empty();
        self.pole = w.axes.in_plane(plane).filter(|_| whole);
        if self.pole.is_some() {
            return Ok(());
        }
        core.refuse(Where::Block, codes::P1004::fpol_needs_both_axes_of_working_plane())
    }

    /// Nothing closes a contour any more that began with CLSD+.
    fn warn_of_unclosed(&mut self, core: &Core<'_>) {
        if let Some((_, loc)) = self.closes.take() {
            let found = codes::K8025::no_clsd_closes_contour_that_begins_here().at(loc);
            core.report(found.help("write CLSD- in the last element, or remove CLSD+"));
        }
    }

    fn serial_of(&self, number: u32) -> Option<Serial> {
        let found = self.numbers.iter().rev().find(|(of, ..)| *of == number);
        found.map(|(_, serial, _)| *serial).filter(|serial| self.window.knows(*serial))
    }

    /// Elements stand in front, and none of them has a number.
    fn has_no_numbers(&self) -> bool {
        self.numbers.is_empty() && self.window.next_serial() > 1
    }

    /// Have several blocks of elements this number? One block may come again and again.
    fn is_twice(&self, number: u32) -> bool {
        let mut places = self.numbers.iter().filter(|(of, ..)| *of == number).map(|(_, _, loc)| (loc.file, loc.line));
        let first = places.next();
        places.any(|place| Some(place) != first)
    }

    /// The block of an element that waits.
    fn waiting(&self, serial: Serial) -> Option<&Waiting> {
        self.queue.iter().find(|waiting| matches!(waiting.kind, Kind::Element { serial: of, .. } if of == serial))
    }

    /// The next block that waits, if no element of it is open.
    fn next_between(&mut self) -> Option<Waiting> {
        match self.queue.front()?.kind {
            Kind::Element { .. } => None,
            Kind::Corner { .. } | Kind::Functions => self.queue.pop_front(),
        }
    }
}

/// May the block stand between elements of a free contour that wait for each other?
pub(super) fn goes_on(block: &Block, changing: &[u32]) -> bool {
    match block.stmt {
        Stmt::Functions => !block
            .words
            .iter()
            .any(|word| matches!(word.addr, Addr::M(n) if matches!(n, 2 | 6 | 30 | 89 | 99) || changing.contains(&n))),
        Stmt::Empty
        | Stmt::Fk(_)
        | Stmt::Rounding
        | Stmt::Chamfer
        | Stmt::Label(_)
        | Stmt::CallLabel { .. }
        | Stmt::Assign(_)
        | Stmt::AssignText(_)
        | Stmt::Fn { .. }
        | Stmt::If { .. }
        | Stmt::FnOther { .. } => true,
        _ => false,
    }
}

impl<'a> Run<'a> {
    /// Does an element of a free contour wait for others?
    #[inline]
    pub(super) fn contour_waits(&self) -> bool {
        self.free.as_ref().is_some_and(|free| !free.queue.is_empty())
    }

    pub(super) fn fk_block(&mut self, head: FkHead, block: &Block, text: &[u8]) -> Outcome {
        let system = self.st.frames.system();
        let mut free = match self.free.take() {
            Some(free) if free.system == system => free,
            before => {
                before.into_iter().for_each(|mut free| free.warn_of_unclosed(&self.core));
                Box::new(Free::new(system))
            }
        };
        let result = match head {
            FkHead::Pole => {
                let w = self.gather(block, "FPOL", Admits::AXES);
                w.and_then(|w| free.set_pole(&self.core, &w, self.st.plane()))
            }
            FkHead::Select => {
                let w = self.gather(block, "FSELECT", Admits::NUMBER);
                w.and_then(|w| free.select(&self.core, w.number))
            }
            FkHead::Line { .. } | FkHead::Arc { .. } => self.element(&mut free, head, block, text),
        };
        self.free = Some(free);
        let ends = block.words.iter().any(|word| matches!(word.addr, Addr::M(2 | 30 | 89 | 99)));
        let result = result.and_then(|()| if ends { self.close_contour() } else { self.flush() });
        if result.is_err() {
            self.give_up();
        }
        result
    }

    /// An element: it waits, or goes out at once.
    fn element(&mut self, free: &mut Free, head: FkHead, block: &Block, text: &[u8]) -> Outcome {
        let (name, plane, letters) = (words::name(head), self.st.plane(), self.letters());
        self.st.polar.forget_pole();
        let direction = if self.approach.is_some() { None } else { self.st.last_direction() };
        if free.queue.is_empty() {
            free.window.restart(self.view().start_in(plane, name)?, direction);
        }
        let (rest, said) = words::keys(self.reading(), letters, head, block, text)?;
        let words = self.gather(&rest, name, words::admits(head))?;
        words.forbid_m(&self.core, name, &[91, 92])?;
        let elements = Elements { core: &self.core, plane, letters, direction };
        let item = elements.item(free, head, &words, &said)?;
        let serial = free.window.next_serial();
        if let Some(number) = block.number {
            if free.numbers.len() == MOST_BACK {
                free.numbers.pop_front();
            }
            free.numbers.push_back((number, serial, self.core.here.origin.loc));
        }
        let waiting =
            Waiting { kind: Kind::Element { serial, item }, words, here: self.core.here, span: self.core.block_span() };
        free.queue.push_back(waiting);
        free.window.push(item).map_err(|fault| self.told().fk_fault(free, &fault))
    }

    /// RND (true) or CHF, or a block of M functions: behind an element that waits it waits, too.
    pub(super) fn corner_block(&mut self, rounding: bool, block: &Block) -> Outcome {
        let w = self.gather(block, corner_head(rounding), corner_words(rounding))?;
        if self.contour_waits() {
            self.wait_between(Kind::Corner { rounding }, w);
            return Ok(());
        }
        let result = self.make_corner(rounding, &w);
        self.words = Some(w);
        result
    }

    /// A block that holds M functions or a feed only.
    pub(super) fn functions_block(&mut self, block: &Block) -> Outcome {
        let w = self.gather(block, "", Admits::PATH)?;
        if self.contour_waits() {
            self.wait_between(Kind::Functions, w);
            return Ok(());
        }
        self.run_motion(Motion::Programmed(PathFn::Line), &w)
    }

    fn wait_between(&mut self, kind: Kind, words: Box<Words>) {
        let (here, span) = (self.core.here, self.core.block_span());
        let Some(free) = &mut self.free else { return };
        if !free.wait(Waiting { kind, words, here, span }) {
            self.core.say(span, codes::K9002::too_many_blocks_stand_between_elements());
            self.abandon_contour();
            self.st.lose_all(&mut self.core);
        }
    }

    /// What is said of a free contour.
    fn told(&self) -> Told<'_, 'a> {
        Told { core: &self.core, letters: self.letters() }
    }

    /// Letters of the working plane.
    fn letters(&self) -> [char; 2] {
        let (first, second, _) = self.st.plane().axes();
        [first, second].map(|axis| Axis::ALL[axis].letter())
    }

    /// Carries out the elements that are settled, and what stands behind them.
    fn flush(&mut self) -> Outcome {
        if let Some(free) = &self.free {
            self.told().warn_of_readings(free);
        }
        while let Some(free) = &mut self.free {
            if let Some(between) = free.next_between() {
                self.carry_out(between, None)?;
                continue;
            }
            let Some(settled) = free.window.settle() else { break };
            let Some(waiting) = free.queue.pop_front() else { break };
            self.carry_out(waiting, Some(&settled))?;
        }
        Ok(())
    }

    /// Carries out a block that waited, at its place.
    fn carry_out(&mut self, mut waiting: Waiting, settled: Option<&Settled>) -> Outcome {
        let here = std::mem::replace(&mut self.core.here, waiting.here);
        let w = &mut waiting.words;
        let result = match (waiting.kind, settled) {
            (Kind::Element { .. }, Some(Settled { solved, .. })) => {
                w.axes = Pos::UNKNOWN;
                w.axes.set_in_plane(self.st.plane(), solved.to);
                w.incremental = AxisSet::EMPTY;
                let motion = match solved.arc {
                    Some((center, ccw)) => Motion::Solved { center, ccw },
                    None => Motion::Programmed(PathFn::Line),
                };
                self.run_motion(motion, w)
            }
            (Kind::Corner { rounding }, _) => self.make_corner(rounding, w),
            (Kind::Functions | Kind::Element { .. }, _) => self.run_motion(Motion::Programmed(PathFn::Line), w),
        };
        self.core.here = here;
        self.words = Some(waiting.words);
        result
    }

    /// The contour ends here: what is open is decided now, or never.
    pub(super) fn close_contour(&mut self) -> Outcome {
        if !self.contour_waits() {
            return Ok(());
        }
        let observed = !self.core.job.settings.control.klartext_choices.fselect_refused;
        let Some(mut free) = self.free.take() else { return Ok(()) };
        let result = match free.window.close(observed) {
            Ok(Closed::One { observed }) => {
                observed.iter().for_each(|serial| self.told().warn_of_choice(&free, *serial));
                Ok(())
            }
            Ok(Closed::Several { serial, candidates }) => {
                self.told().ambiguous(&free, serial, &candidates);
                Err(Reported)
            }
            Err(fault) => {
                self.told().fk_fault(&free, &fault);
                Err(Reported)
            }
        };
        self.free = Some(free);
        let result = result.and_then(|()| self.flush());
        if result.is_err() {
            self.give_up();
        }
        result
    }

    /// The contour is refused; the element that an approach leads to is the one that was refused.
    fn give_up(&mut self) {
        self.abandon_contour();
        self.approach = None;
        self.st.lose_all(&mut self.core);
    }

    /// The run is over: nothing closes a contour any more.
    pub(super) fn warn_of_unclosed(&mut self) {
        self.free.iter_mut().for_each(|free| free.warn_of_unclosed(&self.core));
    }

    /// The contour is given up, which was reported: nobody knows where it leads.
    pub(super) fn abandon_contour(&mut self) {
        let Some(free) = &mut self.free else { return };
        if free.queue.is_empty() {
            return;
        }
        free.queue.clear();
        free.window.restart(Point2::origin(), None);
        self.st.lose_all(&mut self.core);
    }
}

impl Told<'_, '_> {
    /// CCA has two readings: says so where both fit and end in different places.
    fn warn_of_readings(&self, free: &Free) {
        if self.core.job.settings.control.klartext_choices.fk_cca_swept.is_some() {
            return;
        }
        let ready = free.window.ready();
        let elements = free.queue.iter().filter_map(|waiting| match waiting.kind {
            Kind::Element { serial, item } => Some((waiting, serial, item)),
            Kind::Corner { .. } | Kind::Functions => None,
        });
        for (waiting, serial, item) in elements.take(ready) {
            let Some(EndAngle::At(angle)) = item.end_angle else { continue };
            let (Some(to), Some(other)) = (
                free.window.ends_of(serial).first().copied(),
                free.window.read_otherwise(serial, EndAngle::Swept(angle)),
            ) else {
                continue;
            };
            if angle <= 0.0 || angle > 360.0 || distance(to, other) <= SAME_READING {
                continue;
            }
            let loc = waiting.here.loc(&self.core.job, waiting.span);
            let found = codes::K8023::cca_is_read_as_direction_of_end(&angle, &self.shown(to), &self.shown(other))
                .answer(Answer::key("control", "fk_cca"))
                .at(loc);
            self.core.job.diags.push(found.called(waiting.here.origin.call));
        }
    }
}
