//! The three right-handed working planes.

/// A working plane. Angles count from its first axis towards its second, counter-clockwise seen against
/// the third.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Plane {
    /// G17: X, Y; tool axis Z.
    #[default]
    Xy,
    /// G18: Z, X; tool axis Y. The first axis is Z.
    Zx,
    /// G19: Y, Z; tool axis X.
    Yz,
}

impl Plane {
    /// Indices (X 0, Y 1, Z 2) of the first, second and third axis.
    #[inline]
    pub fn axes(self) -> (usize, usize, usize) {
        match self {
            Plane::Xy => (0, 1, 2),
            Plane::Zx => (2, 0, 1),
            Plane::Yz => (1, 2, 0),
        }
    }

    /// The plane that is normal to the axis with this index.
    pub fn normal_to(axis: usize) -> Option<Plane> {
        match axis {
            0 => Some(Plane::Yz),
            1 => Some(Plane::Zx),
            2 => Some(Plane::Xy),
            _ => None,
        }
    }

    /// The plane that two different axes span.
    pub fn spanned_by(a: usize, b: usize) -> Option<Plane> {
        (a != b && a < 3 && b < 3).then(|| 3 - a - b).and_then(Plane::normal_to)
    }
}
