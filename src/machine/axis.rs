//! Axis names and sets of axes.

/// An axis of the output.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum Axis {
    X,
    Y,
    Z,
    A,
    B,
    C,
    U,
    V,
    W,
}

/// Number of axes.
pub const AXES: usize = 9;

impl Axis {
    pub const ALL: [Axis; AXES] = [Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B, Axis::C, Axis::U, Axis::V, Axis::W];

    #[inline]
    pub fn index(self) -> usize {
        self as usize
    }

    #[inline]
    pub fn letter(self) -> char {
        b"XYZABCUVW"[self.index()] as char
    }

    /// The axis with this letter, upper or lower case.
    pub fn of(letter: u8) -> Option<Axis> {
        Some(match letter.to_ascii_uppercase() {
            b'X' => Axis::X,
            b'Y' => Axis::Y,
            b'Z' => Axis::Z,
            b'A' => Axis::A,
            b'B' => Axis::B,
            b'C' => Axis::C,
            b'U' => Axis::U,
            b'V' => Axis::V,
            b'W' => Axis::W,
            _ => return None,
        })
    }

    /// Measured in degrees.
    pub fn is_rotary(self) -> bool {
        matches!(self, Axis::A | Axis::B | Axis::C)
    }

    /// X, Y or Z.
    pub fn is_main(self) -> bool {
        matches!(self, Axis::X | Axis::Y | Axis::Z)
    }
}

/// A set of axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct AxisSet(u16);

impl AxisSet {
    pub const EMPTY: AxisSet = AxisSet(0);
    /// X, Y and Z.
    pub const MAIN: AxisSet = AxisSet(0b111);
    /// Every axis.
    pub const ALL: AxisSet = AxisSet(0b1_1111_1111);

    #[inline]
    pub fn of(axis: Axis) -> AxisSet {
        AxisSet(1 << axis.index())
    }

    #[inline]
    pub fn contains(self, axis: Axis) -> bool {
        self.0 & (1 << axis.index()) != 0
    }

    #[inline]
    pub fn insert(&mut self, axis: Axis) {
        self.0 |= 1 << axis.index();
    }

    pub fn remove(&mut self, axis: Axis) {
        self.0 &= !(1 << axis.index());
    }

    #[inline]
    pub fn union(self, other: AxisSet) -> AxisSet {
        AxisSet(self.0 | other.0)
    }

    #[inline]
    pub fn common(self, other: AxisSet) -> AxisSet {
        AxisSet(self.0 & other.0)
    }

    #[inline]
    pub fn without(self, other: AxisSet) -> AxisSet {
        AxisSet(self.0 & !other.0)
    }

    #[inline]
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    pub fn len(self) -> u32 {
        self.0.count_ones()
    }

    /// A bit for each axis, X first.
    #[inline]
    pub fn bits(self) -> u16 {
        self.0
    }

    /// The axes in order.
    #[inline]
    pub fn iter(self) -> AxisIter {
        AxisIter(self.0)
    }
}

impl FromIterator<Axis> for AxisSet {
    fn from_iter<I: IntoIterator<Item = Axis>>(axes: I) -> AxisSet {
        let mut set = AxisSet::EMPTY;
        for axis in axes {
            set.insert(axis);
        }
        set
    }
}

/// Iterates over an [`AxisSet`].
#[derive(Debug, Clone, Copy)]
pub struct AxisIter(u16);

impl Iterator for AxisIter {
    type Item = Axis;

    #[inline]
    fn next(&mut self) -> Option<Axis> {
        let at = self.0.trailing_zeros() as usize;
        self.0 &= self.0.wrapping_sub(1);
        Axis::ALL.get(at).copied()
    }
}
