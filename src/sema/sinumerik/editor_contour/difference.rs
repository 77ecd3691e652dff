//! What to say where the blocks of a stored contour and its records differ: both values, and how far they lie apart.

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
    /// The block it is about, and the message.
    pub fn difference(&self, difference: Difference) -> (Option<usize>, String) {
        match difference {
            Difference::Start => (None, self.start()),
            Difference::Count => (None, self.count()),
            Difference::End(i) => (Some(i), self.end(i)),
            Difference::Arc(i) => (Some(i), self.arc(i)),
            Difference::Corner(i) => (Some(i), self.corner(i)),
        }
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

    fn start(&self) -> String {
        let (there, here) = (self.start, self.made.start);
        format!(
            "the contour starts at {}, by the records of the contour editor at {}: {} apart",
            self.point(there),
            self.point(here),
            self.way(distance(there, here))
        )
    }

    fn count(&self) -> String {
        let (there, here) = (self.blocks.len(), self.made.blocks.len());
        format!("the contour has {there} elements, but the records of the contour editor make {here}")
    }

    fn end(&self, i: usize) -> String {
        let (Some(there), Some(here)) = (self.blocks.get(i), self.made.blocks.get(i)) else { return self.count() };
        format!(
            "element {} ends at {}, by the records of the contour editor at {}: {} apart",
            i + 1,
            self.point(there.end),
            self.point(here.end),
            self.way(distance(there.end, here.end))
        )
    }

    fn arc(&self, i: usize) -> String {
        let (Some(there), Some(here)) = (self.blocks.get(i), self.made.blocks.get(i)) else { return self.count() };
        let apart = match (there.arc, here.arc) {
            (Some((_, ccw)), Some((center, sense))) if ccw == sense && there.radius.is_some() => {
                format!(" with radius {}", self.length(distance(center, here.end)))
            }
            (Some((a, ccw)), Some((b, sense))) if ccw == sense => format!(": {} apart", self.way(distance(a, b))),
            _ => String::new(),
        };
        format!(
            "element {} is {}, by the records of the contour editor {}{apart}",
            i + 1,
            self.shape(there),
            self.shape(here)
        )
    }

    fn corner(&self, i: usize) -> String {
        let (Some(there), Some(here)) = (self.blocks.get(i), self.made.blocks.get(i)) else { return self.count() };
        format!(
            "the corner after element {} has {}, by the records of the contour editor {}",
            i + 1,
            self.word(there.corner),
            self.word(here.corner)
        )
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
