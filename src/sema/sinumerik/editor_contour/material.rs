//! On which side of a turned contour its material lies, told by the contour and by the undercuts in it.
//!
//! An undercut belongs into an inner corner, so its turn says on which side the material is taken to lie; the corner
//! alone does not prove it. Source: C 4.1 and 4.2 (docs/sources.md).

use crate::geo::{Point2, SAME_POINT, Vec2, cross};

use super::made::NoUndercut;
use super::solve::Solved;

/// What the whole contour tells: the material lies to its left, or to its right.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Told {
    /// It reaches the turning centre, and the part is held at its end towards -Z.
    Left(bool),
    /// It only rises or falls towards -Z, as the outside of a part or a bore mostly does.
    Perhaps(bool),
    Open,
}

/// The material beside a contour.
#[derive(Debug)]
pub(super) struct Material {
    told: Told,
    /// To the left by the undercuts so far.
    taken: Option<bool>,
}

impl Material {
    pub fn beside(elements: &[Solved]) -> Material {
        Material { told: told(elements), taken: None }
    }

    /// Takes an undercut between the directions `u` and `w`; `false` if nothing but the undercut itself says that
    /// its corner is an inner one.
    ///
    /// # Errors
    /// A convex edge.
    pub fn take(&mut self, u: Vec2, w: Vec2) -> Result<bool, NoUndercut> {
        let turn = cross(u, w);
        if turn == 0.0 {
            return Ok(true);
        }
        let left = turn < 0.0;
        if matches!(self.told, Told::Left(told) if told != left) {
            return Err(NoUndercut::Convex);
        }
        if self.taken.is_some_and(|taken| taken != left) {
            return Err(NoUndercut::Contradicts);
        }
        self.taken = Some(left);
        Ok(matches!(self.told, Told::Left(_)) || self.told == Told::Perhaps(left))
    }
}

fn told(elements: &[Solved]) -> Told {
    let (Some(first), Some(last)) = (elements.first(), elements.last()) else { return Told::Open };
    let (first, last) = (first.from, last.to);
    let any = |far: &dyn Fn(Point2) -> bool| far(first) || elements.iter().any(|element| far(element.to));
    let behind = any(&|point| point.y < -SAME_POINT);
    if behind && any(&|point| point.y > SAME_POINT) {
        return Told::Open;
    }
    // Behind the turning centre left and right change places.
    let left = |left: bool| left != behind;
    let central = |point: Point2| point.y.abs() <= SAME_POINT;
    let along = last.x - first.x;
    let rises = last.y.abs() - first.y.abs();
    match (central(first), central(last)) {
        // Away from the centre and back to it: the end towards +Z is the free one.
        (true, true) if along.abs() <= SAME_POINT => Told::Open,
        (true, true) => Told::Left(left(along < 0.0)),
        (true, false) => Told::Left(left(true)),
        (false, true) => Told::Left(left(false)),
        (false, false) if along.abs() <= SAME_POINT || rises.abs() <= SAME_POINT => Told::Open,
        (false, false) => Told::Perhaps(left(rises > 0.0)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UP: Vec2 = Vec2::new(0.0, 1.0);
    const BACK: Vec2 = Vec2::new(-1.0, 0.0);

    fn material(told: Told) -> Material {
        Material { told, taken: None }
    }

    #[test]
    fn undercuts_and_what_is_told() {
        // A cylinder towards -Z and its shoulder, then the edge of that shoulder.
        assert_eq!(material(Told::Left(true)).take(BACK, UP), Ok(true));
        assert_eq!(material(Told::Left(true)).take(UP, BACK), Err(NoUndercut::Convex));
        assert_eq!(material(Told::Perhaps(true)).take(BACK, UP), Ok(true));
        assert_eq!(material(Told::Perhaps(true)).take(UP, BACK), Ok(false));
        assert_eq!(material(Told::Open).take(UP, BACK), Ok(false));
        let mut both = material(Told::Open);
        assert_eq!((both.take(BACK, UP), both.take(UP, BACK)), (Ok(false), Err(NoUndercut::Contradicts)));
    }
}
