//! A contour as a roughing tool sees it: one wall that falls towards the side where the cuts begin.

use crate::geo::wall::{NoWall, Wall, quarters};
use crate::geo::{Element, Point2, Vec2};

/// Heights closer than this are one, mm.
const LEVEL: f64 = 1e-6;

/// Why a contour is no slope.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoSlope {
    /// A part falls away from the cut.
    Falls,
    /// A part leans over.
    Leans,
    /// An arc that meets a bridge cannot be cut there.
    Broken,
}

/// The wall chain, falling towards +x.
#[derive(Debug, Clone, PartialEq)]
pub struct Slope {
    chain: Vec<Element>,
    /// Height at its end and at its start.
    pub floor: f64,
    pub top: f64,
}

/// The element run through backwards.
pub fn reversed(element: &Element) -> Element {
    match *element {
        Element::Line { from, to } => Element::Line { from: to, to: from },
        Element::Arc { from, to, center, sweep } => Element::Arc { from: to, to: from, center, sweep: -sweep },
    }
}

impl Slope {
    /// The slope that `contour` makes, given in the view with the cuts beginning at greater x; it may run
    /// either way. With `bridge`, parts that fall away from the cut are bridged level, and what an overhang
    /// shades is left standing.
    ///
    /// # Errors
    /// See [`NoSlope`].
    pub fn new(contour: &[Element], bridge: bool) -> Result<Slope, NoSlope> {
        let (Some(first), Some(last)) = (contour.first(), contour.last()) else { return Err(NoSlope::Leans) };
        // From the side where the cuts begin.
        let rising: Vec<Element> = if first.from().x >= last.to().x {
            contour.iter().flat_map(quarters).collect()
        } else {
            contour.iter().rev().map(reversed).flat_map(|e| quarters(&e)).collect()
        };
        let mut chain = Climb { list: Vec::with_capacity(rising.len()), at: None, bridge };
        for element in &rising {
            chain.element(element)?;
        }
        let mut list: Vec<Element> = chain.list.iter().rev().map(reversed).collect();
        list.retain(|e| e.from() != e.to());
        let (Some(start), Some(end)) = (list.first(), list.last()) else { return Err(NoSlope::Leans) };
        let (top, low) = (start.from().y, end.to().y);
        // A level floor may be off by what arithmetic loses; the wall begins at its highest point.
        let level = |y: &f64| *y <= low + LEVEL;
        let floor = list.iter().rev().map(|e| e.from().y).take_while(level).fold(low, f64::max);
        Wall::new(&list, 0.0).map_err(|why| match why {
            NoWall::Rises | NoWall::Gap | NoWall::Empty => NoSlope::Leans,
        })?;
        Ok(Slope { chain: list, floor, top })
    }

    /// The chain, falling towards +x.
    pub fn chain(&self) -> &[Element] {
        &self.chain
    }

    /// The wall for a nose of `radius`, moved by `oversize`.
    pub fn wall(&self, radius: f64, oversize: Vec2) -> Result<Wall, NoWall> {
        let moved: Vec<Element> = self.chain.iter().map(|e| shifted(e, oversize)).collect();
        Wall::new(&moved, radius)
    }
}

fn shifted(element: &Element, by: Vec2) -> Element {
    match *element {
        Element::Line { from, to } => Element::Line { from: from + by, to: to + by },
        Element::Arc { from, to, center, sweep } => {
            Element::Arc { from: from + by, to: to + by, center: center + by, sweep }
        }
    }
}

/// Follows the contour upwards; what falls is bridged at the height reached.
struct Climb {
    list: Vec<Element>,
    /// End of the list.
    at: Option<Point2>,
    bridge: bool,
}

impl Climb {
    fn element(&mut self, element: &Element) -> Result<(), NoSlope> {
        let at = *self.at.get_or_insert(element.from());
        let (from, to) = (element.from(), element.to());
        if from.y >= at.y - LEVEL && to.y >= from.y - LEVEL {
            return self.rise(*element);
        }
        if !self.bridge {
            return Err(NoSlope::Falls);
        }
        if to.y > at.y + LEVEL {
            let meet = level_point(element, at.y).ok_or(NoSlope::Broken)?;
            self.push(Element::Line { from: at, to: meet });
            return self.rise(element.starting_at(meet));
        } else if to.x < at.x {
            self.push(Element::Line { from: at, to: Point2::new(to.x, at.y) });
        }
        Ok(())
    }

    /// An element that does not fall. Where it comes back towards the tool, what lies behind it is in its shadow.
    fn rise(&mut self, element: Element) -> Result<(), NoSlope> {
        let to = element.to();
        if !self.bridge || to.x <= element.from().x + LEVEL {
            self.push(element);
            return Ok(());
        }
        let mut foot = Point2::new(to.x, element.from().y);
        while let Some(last) = self.list.pop() {
            foot.y = last.from().y;
            if last.from().x >= to.x {
                foot = upright_point(&last, to.x).ok_or(NoSlope::Broken)?;
                self.list.push(last.ending_at(foot));
                break;
            }
        }
        self.push(Element::Line { from: foot, to });
        Ok(())
    }

    fn push(&mut self, element: Element) {
        self.at = Some(element.to());
        self.list.push(element);
    }
}

/// The point of `element`, which rises through height `y`, at that height.
fn level_point(element: &Element, y: f64) -> Option<Point2> {
    match *element {
        Element::Line { from, to } => Some(from + (to - from) * ((y - from.y) / (to.y - from.y))),
        Element::Arc { from, to, center, .. } => {
            let radius = crate::geo::distance(from, center);
            let up = y - center.y;
            let half = (radius * radius - up * up).max(0.0).sqrt();
            let inside = |x: &f64| *x <= from.x.max(to.x) + LEVEL && *x >= from.x.min(to.x) - LEVEL;
            [center.x - half, center.x + half].into_iter().find(inside).map(|x| Point2::new(x, y))
        }
    }
}

/// The point of `element`, which runs past the place `x`, at that place.
fn upright_point(element: &Element, x: f64) -> Option<Point2> {
    let turned = |p: Point2| Point2::new(p.y, p.x);
    let swapped = match *element {
        Element::Line { from, to } if from.x == to.x => return Some(to),
        Element::Line { from, to } => Element::Line { from: turned(from), to: turned(to) },
        Element::Arc { from, to, center, sweep } => {
            Element::Arc { from: turned(from), to: turned(to), center: turned(center), sweep: -sweep }
        }
    };
    level_point(&swapped, x).map(turned)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(points: &[(f64, f64)]) -> Vec<Element> {
        let point = |p: (f64, f64)| Point2::new(p.0, p.1);
        points.windows(2).map(|pair| Element::Line { from: point(pair[0]), to: point(pair[1]) }).collect()
    }

    #[test]
    fn either_direction_gives_the_same_slope() {
        let points = [(2.0, 15.0), (-20.0, 15.0), (-30.0, 20.0), (-30.0, 25.0)];
        let mut back = points;
        back.reverse();
        let slope = Slope::new(&lines(&points), false).expect("a slope");
        assert_eq!(Slope::new(&lines(&back), false), Ok(slope.clone()));
        assert_eq!((slope.floor, slope.top), (15.0, 25.0));
    }

    #[test]
    fn valleys_are_bridged_or_refused() {
        let points = [(0.0, 10.0), (-5.0, 10.0), (-8.0, 6.0), (-12.0, 6.0), (-18.0, 12.0), (-20.0, 12.0)];
        assert_eq!(Slope::new(&lines(&points), false), Err(NoSlope::Falls));
        let slope = Slope::new(&lines(&points), true).expect("a slope");
        let wall = slope.wall(0.0, Vec2::zeros()).expect("a wall");
        // The bridge at 10 meets the rising cone at -16.
        assert!((wall.touch(10.0) + 16.0).abs() < 1e-9 && (wall.touch(11.0) + 17.0).abs() < 1e-9);
        assert_eq!(Slope::new(&lines(&[(0.0, 1.0), (-5.0, 5.0), (-4.0, 6.0)]), false), Err(NoSlope::Leans));
    }

    #[test]
    fn what_lies_behind_an_overhang_is_in_its_shadow() {
        // A face that is relieved 2 deep from height 10 up to 14.
        let points = [(0.0, 10.0), (-10.0, 10.0), (-12.0, 11.0), (-10.0, 14.0), (-10.0, 20.0)];
        assert_eq!(Slope::new(&lines(&points), false), Err(NoSlope::Leans));
        let slope = Slope::new(&lines(&points), true).expect("a slope");
        let wall = slope.wall(0.0, Vec2::zeros()).expect("a wall");
        for height in [10.0, 11.0, 12.0, 14.0, 18.0] {
            assert!((wall.touch(height) + 10.0).abs() < 1e-9, "{height}");
        }
    }

    #[test]
    fn a_contour_that_falls_to_its_end_is_bridged_to_its_end() {
        let slope = Slope::new(&lines(&[(0.0, 10.0), (-5.0, 12.0), (-9.0, 8.0)]), true).expect("a slope");
        assert_eq!((slope.top, slope.chain.first().map(Element::from)), (12.0, Some(Point2::new(-9.0, 12.0))));
    }
}
