//! Path milling: beside the contour down to the level, on a soft way to it, along it, and on a soft way from it.
//!
//! What lies between the two ways is made by the compensation pass, which also finds where the cutter has no room.

use crate::geo::tolerance;
use std::rc::Rc;

use crate::diag::{Fault, codes};
use crate::geo::soft::Touch;
use crate::geo::{Element, Point2, Vec2, arc, clearance, distance, left};
use crate::ir::compensation::{Compensation, FeedAt};
use crate::ir::cycle::milling::Place;
use crate::ir::cycle::path_milling::{Form, LevelChange, Lift};
use crate::ir::cycle::{Family, PathMilling};
use crate::ir::{Feed, Side};

use super::cutter::{Beside, Cutter, Way};
use super::{CycleItem, Expand, Start};

/// How much nearer than the radius a way may come, mm: what a contour of three decimals loses.
const NEARER: f64 = 2e-3;

impl Expand for PathMilling {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        self.check().map_err(|fault| codes::G3331::contour_makes_no_path(&fault))?;
        let levels = self.levels();
        let back = (self.alternates && levels.len() > 1).then(|| self.backwards());
        let Some(forth) = Travel::along(self) else { return Ok(()) };
        let back = back.as_ref().and_then(Travel::along);
        for travel in [Some(&forth), back.as_ref()].into_iter().flatten() {
            travel.path.ways_are_free(&travel.comes, &travel.goes)?;
        }
        if levels.len() > 1 {
            self.back_is_free(&back.as_ref().unwrap_or(&forth).comes, &forth.goes)?;
        }
        let cutter = Cutter::new(&self.mill, Place::HERE, start, out);
        let mut tool = Tool { travel: &forth, cutter };
        let mut from = self.mill.heights.reference;
        for (at, level) in levels.into_iter().enumerate() {
            if from != self.mill.heights.reference {
                tool.lift(from);
            }
            tool.travel = back.as_ref().filter(|_| at % 2 == 1).unwrap_or(&forth);
            tool.mill(from, level);
            from = level;
        }
        tool.cutter.retract();
        Ok(())
    }
}

impl PathMilling {
    /// The soft ways themselves must keep their distance from all of the contour.
    fn ways_are_free(&self, comes: &Touch, goes: &Touch) -> Result<(), Fault> {
        let (Some(first), Some(last)) = (self.contour.first(), self.contour.last()) else { return Ok(()) };
        if self.side == Side::None {
            return Ok(());
        }
        let beside =
            |at: Point2, heading: Option<Vec2>| heading.map(|heading| at + left(heading) * self.signed_distance());
        let start = beside(first.from(), first.start_direction());
        let end = beside(last.to(), last.end_direction());
        for (touch, at) in [(comes, start), (goes, end)] {
            let Some(at) = at else { continue };
            let way = match touch.circle {
                None => Element::Line { from: touch.centre, to: at },
                Some(center) => {
                    let leads_in = core::ptr::eq(touch, comes);
                    let (from, to) = if leads_in { (touch.centre, at) } else { (at, touch.centre) };
                    let sweep = arc::sweep(from, to, center, self.turns_counter_clockwise());
                    Element::Arc { from, to, center, sweep }
                }
            };
            let least = self.distance() - NEARER;
            if self.contour.iter().any(|element| clearance::between(&way, element) < least) {
                return Err(codes::G3331::way_to_contour());
            }
        }
        Ok(())
    }

    fn signed_distance(&self) -> f64 {
        if self.side == Side::Right { -self.distance() } else { self.distance() }
    }

    /// Does the tool go back to the start of the contour below the surface?
    fn goes_back_deep(&self) -> bool {
        match self.between.lift {
            Lift::Retract | Lift::Surface => false,
            // At rapid traverse it goes above the surface.
            Lift::Clearance => self.between.feed.is_some(),
            Lift::None => true,
        }
    }

    /// The straight way back must keep its distance from the contour.
    fn back_is_free(&self, comes: &Touch, goes: &Touch) -> Result<(), Fault> {
        let (from, to) = (goes.centre, comes.centre);
        if !self.goes_back_deep() || distance(from, to) <= tolerance::SAME {
            return Ok(());
        }
        let back = Element::Line { from, to };
        let free = self.side != Side::None
            && self
                .contour
                .iter()
                .all(|element| clearance::between(&back, element) >= self.distance() - tolerance::SAME);
        if free {
            return Ok(());
        }
        Err(codes::G3331::straight_way_back_to_start_of_contour())
    }
}

/// A contour in the sense in which it is travelled.
struct Travel<'a> {
    path: &'a PathMilling,
    /// None where the centre is on the contour itself.
    beside: Option<Beside>,
    /// The same on the ways to the contour and from it.
    on_the_way: Option<Beside>,
    comes: Touch,
    goes: Touch,
}

impl<'a> Travel<'a> {
    fn along(path: &'a PathMilling) -> Option<Travel<'a>> {
        let beside = |rules| (path.side != Side::None).then(|| Beside { side: path.side, rules: Rc::new(rules) });
        let way = Compensation { is_way: true, feed: FeedAt::Centre, ..path.rules };
        let (comes, goes) = (path.comes()?, path.goes()?);
        Some(Travel { path, beside: beside(path.rules), on_the_way: beside(way), comes, goes })
    }

    /// What the cutter is beside before it gets to the contour: on a line at a right angle to it nothing yet.
    fn before(&self) -> Option<&Beside> {
        self.on_the_way.as_ref().filter(|_| self.path.approach.form != Form::Square)
    }
}

struct Tool<'t, 'a> {
    travel: &'t Travel<'t>,
    cutter: Cutter<'a>,
}

impl Tool<'_, '_> {
    /// One level; everything down to `from` is cut beside the contour.
    fn mill(&mut self, from: f64, level: f64) {
        let Travel { path, comes, .. } = self.travel;
        let heights = path.mill.heights;
        let first = from == heights.reference;
        if first {
            self.cutter.rise();
        }
        let feed = match path.between {
            _ if first => None,
            between if between.lift == Lift::None => Some(path.mill.feeds.plane),
            between => between.feed,
        };
        // Over the point where the way to the contour begins.
        let beside = self.travel.before().is_some();
        let start = if beside { comes.contour } else { comes.centre };
        // No compensation begins on the spot: a tool that stands over the start goes beside the contour first.
        if first && beside && self.cutter.stands_at(start) {
            self.cutter.rapid(comes.centre);
        }
        self.come(Some(start), None, feed.map_or(Way::Rapid, Way::Line));
        self.down(heights.above_cleared(from), level);
        self.along_the_contour(level);
        // From here on the centre of the tool itself is meant.
        self.cutter.line(self.travel.goes.centre, path.mill.feeds.plane);
    }

    /// To where the way to the contour begins.
    fn come(&mut self, to: Option<Point2>, height: Option<f64>, way: Way) {
        self.go(self.travel.before(), (to, height), way);
    }

    fn go(&mut self, beside: Option<&Beside>, (to, height): (Option<Point2>, Option<f64>), way: Way) {
        if let Some(beside) = beside {
            return self.cutter.beside(beside, to, height, way);
        }
        match (way, to, height) {
            (Way::Arc { center, ccw, feed, .. }, Some(to), _) => self.cutter.arc(to, center, ccw, feed),
            (Way::Line(feed), Some(to), Some(height)) => {
                self.cutter.fall(&Element::Line { from: to, to }, height, feed);
            }
            (Way::Line(feed), Some(to), None) => self.cutter.line(to, feed),
            (Way::Line(_), None, Some(height)) => self.cutter.plunge(height),
            (Way::Rapid, Some(to), _) => self.cutter.rapid(to),
            (Way::Rapid, None, Some(height)) => self.cutter.lift(height),
            (_, None, _) => {}
        }
    }

    /// At rapid traverse down to what is free, then at the feed for the depth.
    fn down(&mut self, free: f64, level: f64) {
        let path = self.travel.path;
        let heights = &path.mill.heights;
        let floor = if path.approach.spatial { heights.above(level) } else { level };
        // A way in space begins above its level, also where the tool was not lifted: else it would cut deeper than the level.
        if path.approach.spatial && self.cutter.is_below(floor) {
            self.come(None, Some(floor), Way::Rapid);
        }
        let stop = if (floor - free) * heights.outward() > 0.0 { floor } else { free };
        if self.cutter.is_above(stop) {
            self.come(None, Some(stop), Way::Rapid);
        }
        if self.cutter.is_above(floor) {
            self.come(None, Some(floor), Way::Line(path.mill.feeds.depth));
        }
    }

    fn along_the_contour(&mut self, level: f64) {
        let Travel { path, comes, goes, .. } = self.travel;
        let feeds = path.mill.feeds;
        let Some(start) = path.contour.first().map(Element::from) else { return };
        let (falls, feed) = if path.approach.spatial { (Some(level), feeds.depth) } else { (None, feeds.plane) };
        if path.approach.form != Form::None {
            self.soft(comes.circle, start, falls, feed);
        }
        for element in &path.contour {
            self.element(element);
        }
        // Square off the contour goes the move that ends the compensation.
        if !matches!(path.leave.form, Form::None | Form::Square) {
            let rises = path.leave.spatial.then(|| path.mill.heights.above(level));
            let end = if self.travel.beside.is_some() { goes.contour } else { goes.centre };
            self.soft(goes.circle, end, rises, feeds.plane);
        }
    }

    fn soft(&mut self, circle: Option<Point2>, to: Point2, height: Option<f64>, feed: Feed) {
        let ccw = self.travel.path.turns_counter_clockwise();
        let way = circle.map_or(Way::Line(feed), |center| Way::Arc { center, ccw, tol: 0.0, feed });
        self.go(self.travel.on_the_way.as_ref(), (Some(to), height), way);
    }

    fn element(&mut self, element: &Element) {
        let feed = self.travel.path.mill.feeds.plane;
        let Some(beside) = &self.travel.beside else { return self.cutter.element(element, feed) };
        let way = match *element {
            Element::Line { .. } => Way::Line(feed),
            Element::Arc { from, to, center, sweep } => {
                let tol = (distance(from, center) - distance(to, center)).abs();
                Way::Arc { center, ccw: sweep > 0.0, tol, feed }
            }
        };
        self.cutter.beside(beside, Some(element.to()), None, way);
    }

    /// Off the level that is cut.
    fn lift(&mut self, level: f64) {
        let LevelChange { lift, feed } = self.travel.path.between;
        let heights = self.travel.path.mill.heights;
        match lift {
            Lift::Retract => self.cutter.lift(heights.retract),
            Lift::Clearance if feed.is_some() => self.cutter.lift(heights.above(level)),
            Lift::Surface | Lift::Clearance => self.cutter.lift(heights.safe()),
            Lift::None => {}
        }
    }
}
