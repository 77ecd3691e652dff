//! Which of several solutions the program asks for.
//!
//! The order in which controls number solutions is not documented. In a few situations it was observed in printed programs
//! whose drawings leave no doubt about the solution that is meant; in all others a number says nothing here.

use crate::geo::{Point2, Vec2, cross};

use super::state::{State, View};
use super::{ONE, Shape, Window};

impl Window {
    /// Keeps the states that the first choice of the program asks for; true if that leaves fewer.
    pub(super) fn choose_first(&mut self) -> bool {
        for node in 0..self.items.len() {
            let Some(wanted) = self.items[node].select else { continue };
            let numbers: Vec<Option<u32>> =
                self.states.iter().map(|state| number(&View { window: self, state }, node)).collect();
            let first = numbers.first().copied().flatten();
            if numbers.iter().any(Option::is_none) || numbers.iter().all(|number| *number == first) {
                continue;
            }
            // The numbers say something only where all states agree up to here, and one has the number.
            let agree = self.states.iter().all(|state| self.states[0].agrees(state, node));
            if !agree || !numbers.contains(&Some(wanted)) {
                return false;
            }
            let mut numbers = numbers.into_iter();
            self.states.retain(|_| numbers.next().flatten() == Some(wanted));
            self.observed.push(self.first + node);
            return true;
        }
        false
    }
}

impl State {
    /// Is everything in front of the start of this element the same?
    fn agrees(&self, other: &State, node: usize) -> bool {
        let near =
            |a: Option<Point2>, b: Option<Point2>| a.zip(b).is_some_and(|(a, b)| crate::geo::distance(a, b) <= ONE);
        let ends = node.saturating_sub(1);
        self.nodes.iter().zip(&other.nodes).take(ends).all(|(a, b)| near(a.end, b.end))
    }
}

/// The number of the solution of an element, counted as it was observed; `None` where nothing is known.
fn number(view: &View<'_>, node: usize) -> Option<u32> {
    let item = view.item(node);
    let before = node.checked_sub(1);
    if item.shape != Shape::Line {
        // A known line, then a circle: the far intersection is the first.
        let (_, u) = before.and_then(|before| view.line(before)).filter(|_| !item.smooth)?;
        let fixed = item.center.count() == 2;
        let (center, _) = view.circle(node).filter(|_| fixed)?;
        return Some(if (view.start(node)? - center).dot(&u) > 0.0 { 1 } else { 2 });
    }
    let (_, u) = view.line(node)?;
    let start = view.start(node)?;
    if let Some((of, None)) = item.parallel {
        // The same sense is the first.
        return Some(if view.exit_of(of)?.dot(&u) > 0.0 { 1 } else { 2 });
    }
    if let (Some(p), true, None) = (item.through[0], item.length.is_some(), item.angle) {
        // Towards the point.
        return Some(if (p - start).dot(&u) > 0.0 { 1 } else { 2 });
    }
    // A known arc, then one of two parallels: those with the point on their left first, the far intersection first.
    let (p, _) = item.beside.filter(|_| item.angle.is_some() && !item.smooth)?;
    let (center, _) = view.circle(before?)?;
    let right = cross(u, p - start) < 0.0;
    let far = along(start, center, u) > 0.0;
    Some(1 + 2 * u32::from(right) + u32::from(!far))
}

/// Where the point lies along the direction, from the foot of the centre.
fn along(p: Point2, center: Point2, u: Vec2) -> f64 {
    (p - center).dot(&u)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geo::left;

    #[test]
    fn a_point_is_placed_along_a_direction_from_the_foot_of_the_centre() {
        // Along (3 4)/5: the foot of (10 5) lies level with it, whatever the line.
        let (center, u) = (Point2::new(10.0, 5.0), Vec2::new(0.6, 0.8));
        for (way, aside) in [(7.0, 0.0), (7.0, 3.0), (-4.0, -2.5)] {
            let p = center + u * way + left(u) * aside;
            assert!((along(p, center, u) - way).abs() < 1e-12, "{way} {aside}");
        }
    }
}
