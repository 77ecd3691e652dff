//! From which side the path is seen: a picture has two directions, each a sum of axes.

use crate::geo::{Plane, Point2, Vec2, cross};
use crate::ir::Pos;
use crate::machine::Axis;

/// What somebody asks to see.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    Xy,
    /// On a lathe Z to the right and X up, elsewhere X to the right and Z up.
    Xz,
    Yz,
    /// From the right in front and above, lengths along the axes true (ISO 5456-3).
    Iso,
}

/// Where X, Y and Z lead in the picture, each as a way to the right and up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct View {
    ways: [Vec2; 3],
    lathe: bool,
    /// Where no program says where Y is: turned parts lie in one plane.
    flat: bool,
}

/// Half the square root of 3.
const COS_30: f64 = 0.866_025_403_784_438_6;

impl View {
    /// The view that is asked for, or else that of the working plane; on a lathe Z to the right and X up.
    pub(super) fn new(asked: Option<Side>, plane: Plane, lathe: bool) -> View {
        let (right, up, none) = (Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0), Vec2::new(0.0, 0.0));
        let ways = match (asked, lathe) {
            (Some(Side::Xy), _) => [right, up, none],
            (Some(Side::Yz), _) => [none, right, up],
            (Some(Side::Xz), false) => [right, none, up],
            (Some(Side::Xz), true) | (None, true) => [up, none, right],
            (Some(Side::Iso), false) => [Vec2::new(COS_30, -0.5), Vec2::new(COS_30, 0.5), up],
            (Some(Side::Iso), true) => [up, Vec2::new(-COS_30, 0.5), Vec2::new(COS_30, 0.5)],
            (None, false) => match plane {
                Plane::Xy => [right, up, none],
                Plane::Zx => [up, none, right],
                Plane::Yz => [none, right, up],
            },
        };
        View { ways, lathe, flat: lathe }
    }

    /// The axes to the right and up, unless more than two are seen.
    pub(super) fn axes(self) -> Option<(Axis, Axis)> {
        let along = |way: Vec2| (0..3).find(|i| self.ways[*i] == way).map(|i| Axis::ALL[i]);
        if self.is_iso() { None } else { Some((along(Vec2::new(1.0, 0.0))?, along(Vec2::new(0.0, 1.0))?)) }
    }

    pub(super) fn is_iso(self) -> bool {
        self.ways.iter().all(|way| *way != Vec2::new(0.0, 0.0))
    }

    /// Z to the right and X, the radius of a turned part, up.
    pub(super) fn is_turning(self) -> bool {
        self.lathe && self.axes() == Some((Axis::Z, Axis::X))
    }

    /// Arcs of `plane` are arcs in the picture: 1 where they turn the same way, -1 where they are seen from behind.
    pub(super) fn turn(self, plane: Plane) -> Option<f64> {
        let (first, second, third) = plane.axes();
        let lies = self.ways[third] == Vec2::new(0.0, 0.0);
        lies.then(|| cross(self.ways[first], self.ways[second]))
    }

    /// A point of `plane` where [`turn`](View::turn) says that it lies in the picture.
    pub(super) fn in_plane(self, plane: Plane, p: Point2) -> Point2 {
        let (first, second, _) = plane.axes();
        Point2::from(self.ways[first] * p.x + self.ways[second] * p.y)
    }

    pub(super) fn point(self, pos: &Pos) -> Option<Point2> {
        let mut at = Vec2::new(0.0, 0.0);
        for (i, way) in self.ways.iter().enumerate() {
            if *way != Vec2::new(0.0, 0.0) {
                match pos.get(Axis::ALL[i]) {
                    Some(value) => at += way * value,
                    None if self.flat && Axis::ALL[i] == Axis::Y => {}
                    None => return None,
                }
            }
        }
        Some(Point2::from(at))
    }

    /// Where `length` along the axis leads.
    pub(super) fn way(self, axis: Axis) -> Vec2 {
        self.ways.get(axis.index()).copied().unwrap_or(Vec2::new(0.0, 0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arcs_are_seen_from_behind_in_the_front_view_of_a_mill() {
        // X to the right and Z up; G18 counts from Z to X.
        assert_eq!(View::new(Some(Side::Xz), Plane::Xy, false).turn(Plane::Zx), Some(-1.0));
        assert_eq!(View::new(Some(Side::Xz), Plane::Xy, true).turn(Plane::Zx), Some(1.0));
        assert_eq!(View::new(None, Plane::Xy, false).turn(Plane::Xy), Some(1.0));
        assert_eq!(View::new(Some(Side::Iso), Plane::Xy, false).turn(Plane::Xy), None);
        assert_eq!(View::new(Some(Side::Yz), Plane::Xy, false).turn(Plane::Xy), None);
    }

    #[test]
    fn an_axis_that_is_seen_must_be_known() {
        let mut pos = Pos::UNKNOWN;
        pos.set(Axis::X, 10.0);
        pos.set(Axis::Z, 4.0);
        assert_eq!(View::new(None, Plane::Xy, false).point(&pos), None);
        assert_eq!(View::new(Some(Side::Xz), Plane::Xy, false).point(&pos), Some(Point2::new(10.0, 4.0)));
        assert_eq!(View::new(Some(Side::Iso), Plane::Xy, false).point(&pos), None);
        // A lathe has no Y.
        assert!(View::new(Some(Side::Iso), Plane::Zx, true).point(&pos).is_some());
    }
}
