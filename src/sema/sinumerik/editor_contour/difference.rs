//! What to say where the blocks of a stored contour and its records differ: both values, and how far they lie apart.

use crate::diag::{Fault, codes};
use crate::geo::{Point2, distance};

use super::compare::Difference;
use super::made::{Contour, ContourBlock, CornerWord, Written};

/// The two halves of a contour, and how their numbers are written.
#[derive(Debug)]
pub(super) struct Told<'a> {
    /// Letters of abscissa and ordinate.
    pub axes: (u8, u8),
    pub written: Written,
    pub start: Point2,
    pub blocks: &'a [ContourBlock],
    pub made: &'a Contour,
}

impl Told<'_> {
    /// The block it is about, and what is wrong.
    pub fn difference(&self, difference: Difference) -> (Option<usize>, Fault) {
        let (at, fault) = match difference {
            Difference::Start => {
                let (there, here) = (self.start, self.made.start);
                let way = self.way(distance(there, here));
                (None, Some(codes::S8026::contour_starts_at(&self.point(there), &self.point(here), &way)))
            }
            Difference::Count => (None, None),
            Difference::End(i) => (Some(i), self.both(i).map(|(there, here)| self.end(i + 1, there.end, here.end))),
            Difference::Arc(i) => (Some(i), self.both(i).map(|(there, here)| self.arc(i + 1, there, here))),
            Difference::Corner(i) => (
                Some(i),
                self.both(i).map(|(there, here)| {
                    let (there, here) = (self.word(there.corner), self.word(here.corner));
                    codes::S8026::corner_after_element_has(&(i + 1), &there, &here)
                }),
            ),
        };
        let count = || codes::S8026::contour_has_elements(&self.blocks.len(), &self.made.blocks.len());
        (at, fault.unwrap_or_else(count))
    }

    /// The record it is about.
    pub fn record(&self, difference: Difference) -> Option<usize> {
        match difference {
            Difference::Start => Some(self.made.start_record),
            Difference::Count => None,
            Difference::End(i) | Difference::Arc(i) => self.made.blocks.get(i).map(|block| block.record),
            Difference::Corner(i) => self
                .made
                .blocks
                .get(i)
                .map(|block| if block.corner.is_some() { block.corner_record } else { block.record }),
        }
    }

    /// The block, and what the records make in its place.
    fn both(&self, i: usize) -> Option<(&ContourBlock, &ContourBlock)> {
        Some((self.blocks.get(i)?, self.made.blocks.get(i)?))
    }

    fn end(&self, number: usize, there: Point2, here: Point2) -> Fault {
        let way = self.way(distance(there, here));
        codes::S8026::element_ends_at(&number, &self.point(there), &self.point(here), &way)
    }

    fn arc(&self, number: usize, there: &ContourBlock, here: &ContourBlock) -> Fault {
        let (told, made) = (self.shape(there), self.shape(here));
        match (there.arc, here.arc) {
            (Some((_, ccw)), Some((center, sense))) if ccw == sense && there.radius.is_some() => {
                let radius = self.length(distance(center, here.end));
                codes::S8026::element_has_another_radius(&number, &told, &made, &radius)
            }
            (Some((a, ccw)), Some((b, sense))) if ccw == sense => {
                codes::S8026::element_is_about_another_centre(&number, &told, &made, &self.way(distance(a, b)))
            }
            _ => codes::S8026::element_is(&number, &told, &made),
        }
    }

    fn shape(&self, block: &ContourBlock) -> String {
        match (block.arc, block.radius) {
            (None, _) => "a straight line".to_owned(),
            (Some((_, ccw)), Some(radius)) => format!("G{} with CR={}", if ccw { 3 } else { 2 }, self.length(radius)),
            (Some((center, ccw)), None) => format!("G{} about {}", if ccw { 3 } else { 2 }, self.point(center)),
        }
    }

    fn point(&self, p: Point2) -> String {
        let scale = if self.written.diameter { 2.0 } else { 1.0 };
        format!("{}{} {}{}", self.axes.0 as char, self.length(p.x), self.axes.1 as char, self.length(scale * p.y))
    }

    /// A length as the program writes it.
    fn length(&self, mm: f64) -> String {
        number(mm / self.written.unit)
    }

    fn way(&self, mm: f64) -> String {
        format!("{} {}", self.length(mm), if self.written.unit == 1.0 { "mm" } else { "in" })
    }

    fn word(&self, corner: Option<CornerWord>) -> String {
        match corner {
            None => "no transition".to_owned(),
            Some(CornerWord::Radius(radius)) => format!("RND={}", self.length(radius)),
            Some(CornerWord::Chamfer(leg)) => format!("CHR={}", self.length(leg)),
            Some(CornerWord::Undercut(_)) => "an undercut".to_owned(),
        }
    }
}

/// Four places, without zeros at the end: what is compared has three.
fn number(value: f64) -> String {
    let text = format!("{value:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
