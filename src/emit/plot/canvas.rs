//! What a picture is made of, whatever file it becomes: paths and words, each of a class that says how it looks.

use crate::geo::Point2;

/// Colours of tools, in order of appearance: distinct on white and on black, also for the colour-blind.
pub(super) const COLOURS: [u32; 8] = [0x0b78c1, 0xd9480f, 0x2b8a3e, 0x9c36b5, 0xb8860b, 0x0c8599, 0xc2255c, 0x6b7a2f];

/// The same on a dark ground. The page has both, too (`web/src/style.css`).
pub(super) const ON_DARK: [u32; 8] = [0x5bb8ff, 0xff8f5e, 0x69d17a, 0xd9a3f0, 0xecc94b, 0x4fd1e0, 0xff7fa8, 0xb7cc6a];

/// The colour of a tool by its place in the list, which begins with no tool.
pub(super) fn shade(tool: usize) -> usize {
    (tool + COLOURS.len() - 1) % COLOURS.len()
}

/// A part of a path, in mm of the part with y upwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Part {
    Move(Point2),
    Line(Point2),
    /// An arc of at most a turn that begins where the part before ends, counter-clockwise positive.
    Arc {
        center: Point2,
        sweep: f64,
        to: Point2,
    },
    Close,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Class {
    Grid,
    Axis,
    /// The turning centre.
    Centre,
    Cut(usize),
    /// A tool in the legend.
    Key(usize),
    Rapid(usize),
    Thread(usize),
    Dot(usize),
    /// The programmed contour.
    Contour,
    /// Edges of a cut part.
    Edge,
    /// What is cut through.
    Hatch,
    /// Edges of the blank.
    Blank,
    Arrow(usize),
    /// Where the path begins.
    Start,
    /// Where it ends.
    End,
    Dimension,
    DimensionArrow,
}

/// How a class looks. Widths are pixels, whatever the size of the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Look {
    pub width: f64,
    /// Length of dashes and gaps, in pixels.
    pub dash: &'static [f64],
    pub ink: Ink,
    pub opacity: f64,
    pub round: bool,
    pub filled: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ink {
    Tool(usize),
    /// On a light ground and on a dark one.
    Fixed(u32, u32),
}

/// Widths of what the path is drawn with, in pixels: thin where there is much of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Widths {
    pub cut: f64,
    pub rapid: f64,
}

/// Share of the area of a path that its strokes may cover.
const COVER: f64 = 0.3;

impl Widths {
    /// For strokes of so many pixels on so many square pixels.
    pub(super) fn of(cut: f64, rapid: f64, area: f64) -> Widths {
        let fits = |length: f64, most: f64, least: f64| {
            let width = if length > 0.0 { COVER * area / length } else { most };
            // Steps, so that a small change of a program does not change the whole picture.
            libm::round(width.clamp(least, most) * 20.0) / 20.0
        };
        Widths { cut: fits(cut, 2.0, 0.35), rapid: fits(rapid, 1.0, 0.3) }
    }
}

impl Class {
    pub(super) fn look(self, widths: Widths) -> Look {
        let plain = Look {
            width: 1.0,
            dash: &[],
            ink: Ink::Fixed(0x555555, 0xaaaaaa),
            opacity: 1.0,
            round: false,
            filled: false,
        };
        let tool = |index: usize| Ink::Tool(shade(index));
        match self {
            Class::Grid => Look { width: 0.6, ink: Ink::Fixed(0x888888, 0x888888), opacity: 0.3, ..plain },
            Class::Axis => plain,
            Class::Centre => Look { dash: &[20.0, 5.0, 3.0, 5.0], ..plain },
            Class::Cut(i) => Look { width: widths.cut, ink: tool(i), round: true, ..plain },
            Class::Key(i) => Look { width: 3.0, ink: tool(i), ..plain },
            Class::Rapid(i) => Look { width: widths.rapid, dash: &[6.0, 4.0], ink: tool(i), opacity: 0.7, ..plain },
            Class::Thread(i) => Look { width: widths.cut, dash: &[2.5, 2.5], ink: tool(i), ..plain },
            Class::Dot(i) => {
                Look { width: if widths.cut < 1.0 { 4.0 } else { 7.0 }, ink: tool(i), round: true, ..plain }
            }
            Class::Contour => Look { ink: Ink::Fixed(0x888888, 0x888888), ..plain },
            Class::Edge => Look { width: 2.0, ink: Ink::Fixed(0x222222, 0xeeeeee), round: true, ..plain },
            Class::Hatch => Look { width: 0.7, ink: Ink::Fixed(0x777777, 0x999999), ..plain },
            Class::Blank => Look { dash: &[14.0, 4.0, 2.0, 4.0], ink: Ink::Fixed(0x8d5a2b, 0xd9a066), ..plain },
            Class::Arrow(i) => Look { ink: tool(i), filled: true, ..plain },
            Class::Start => Look { width: 2.0, ink: Ink::Fixed(0x111111, 0xffffff), ..plain },
            Class::End => Look { ink: Ink::Fixed(0x111111, 0xffffff), filled: true, ..plain },
            Class::Dimension => Look { width: 0.8, ink: Ink::Fixed(0x333333, 0xdddddd), ..plain },
            Class::DimensionArrow => Look { ink: Ink::Fixed(0x333333, 0xdddddd), filled: true, ..plain },
        }
    }
}

/// Where the words of a text stand from its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// Words of a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Words<'a> {
    /// On the line on which letters stand.
    pub at: Point2,
    pub anchor: Anchor,
    /// Height of the font, in mm of the part.
    pub font: f64,
    /// Read from the right: upwards.
    pub upright: bool,
    /// Nobody shall overlook them.
    pub loud: bool,
    pub text: &'a str,
}

/// Ink of loud words, on a light ground and on a dark one.
pub(super) const LOUD: (u32, u32) = (0xb3261e, 0xff8f86);

/// How much is seen of what is pale.
pub(super) const PALE: f64 = 0.35;

/// Takes a picture: first all paths, then all words.
pub(super) trait Canvas {
    /// A path; `title` is shown where somebody points at it.
    fn path(&mut self, class: Class, title: Option<&str>, parts: &[Part]);
    fn words(&mut self, words: &Words<'_>);
    /// What comes now is pale, or is not any more.
    fn pale(&mut self, _: bool) {}
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_has_the_same_colours() {
        let style = include_str!("../../../web/src/style.css");
        for (list, which) in [(COLOURS, 0), (ON_DARK, 1)] {
            let of = |i: usize| style.split(&format!("--t{i}: #")).nth(1 + which).and_then(|rest| rest.get(..6));
            let page: Vec<_> =
                (0..list.len()).map(|i| of(i).and_then(|hex| u32::from_str_radix(hex, 16).ok())).collect();
            assert_eq!(page, list.map(Some), "{list:06x?}");
        }
    }
}
