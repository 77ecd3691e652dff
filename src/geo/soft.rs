//! Soft ways to and from a contour: a line, a quadrant or a semicircle that goes on in its direction.

use super::{Deg, Point2, Vec2, left};

/// What a way is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    Line,
    Quadrant,
    Semicircle,
}

/// Where a way touches a contour: its circle or line, seen from the contour and from the centre of the tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// Ends of the way away from the contour.
    pub contour: Point2,
    pub centre: Point2,
    pub circle: Option<Point2>,
}

/// The way of `size` at the point `at` of a contour, for a tool of `radius`. `away` leads along the contour away from the
/// point, backwards for an approach, and `side` is 1 where the tool lies to the left of it, -1 to the right.
///
/// `size` is the radius of the path of the centre; for a line the length that the edge of the tool keeps from the point.
pub fn touch(shape: Shape, size: f64, at: Point2, away: Vec2, side: f64, radius: f64) -> Touch {
    let m = left(away) * side;
    let edge = at + m * radius;
    match shape {
        Shape::Line => {
            let way = away * (size + radius);
            Touch { contour: at + way, centre: edge + way, circle: None }
        }
        Shape::Quadrant | Shape::Semicircle => {
            let out = if shape == Shape::Quadrant { away } else { m };
            let center = edge + m * size;
            Touch { contour: center + out * (size + radius), centre: center + out * size, circle: Some(center) }
        }
    }
}

/// A way on an arc of `radius` of the centre's path, by `sweep`, which touches the contour at the point; the rest as for [`touch`].
pub fn arc(radius: f64, sweep: Deg, at: Point2, away: Vec2, side: f64, tool: f64) -> Touch {
    let m = left(away) * side;
    let center = at + m * (tool + radius);
    let (sin, cos) = sweep.sin_cos();
    let out = away * sin - m * cos;
    Touch { contour: center + out * (radius + tool), centre: center + out * radius, circle: Some(center) }
}

/// A way of the centre that goes on in the direction of the contour.
pub fn tangent(length: f64, at: Point2, away: Vec2, side: f64, tool: f64) -> Touch {
    let way = away * length;
    Touch { contour: at + way, centre: at + left(away) * (side * tool) + way, circle: None }
}

/// A way of the centre at a right angle to the contour; of no length where the tool comes from above.
pub fn square(length: f64, at: Point2, away: Vec2, side: f64, tool: f64) -> Touch {
    Touch { contour: at, centre: at + left(away) * (side * (tool + length)), circle: None }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A contour that starts at X10 to +X, the tool of radius 5 on its right.
    fn approach(shape: Shape) -> Touch {
        touch(shape, 8.0, Point2::new(10.0, 0.0), Vec2::new(-1.0, 0.0), 1.0, 5.0)
    }

    #[test]
    fn ways_of_the_worked_examples() {
        let quadrant = approach(Shape::Quadrant);
        assert_eq!((quadrant.centre, quadrant.circle), (Point2::new(2.0, -13.0), Some(Point2::new(10.0, -13.0))));
        assert_eq!(approach(Shape::Semicircle).centre, Point2::new(10.0, -21.0));
        assert_eq!(approach(Shape::Line).centre, Point2::new(-3.0, -5.0));
    }

    #[test]
    fn quadrant_and_semicircle_are_arcs() {
        let near = |a: Touch, b: Touch| {
            let away = |a: Point2, b: Point2| crate::geo::distance(a, b);
            away(a.contour, b.contour) < 1e-12 && away(a.centre, b.centre) < 1e-12 && a.circle == b.circle
        };
        let by = |sweep| arc(8.0, Deg(sweep), Point2::new(10.0, 0.0), Vec2::new(-1.0, 0.0), 1.0, 5.0);
        assert!(near(by(90.0), approach(Shape::Quadrant)) && near(by(180.0), approach(Shape::Semicircle)));
        let (at, away) = (Point2::new(10.0, 0.0), Vec2::new(-1.0, 0.0));
        assert_eq!(tangent(13.0, at, away, 1.0, 5.0), approach(Shape::Line));
        assert_eq!(square(3.0, at, away, 1.0, 5.0).centre, Point2::new(10.0, -8.0));
    }
}
