//! Units of length.

/// Unit of length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Unit {
    #[default]
    Mm,
    Inch,
}

impl Unit {
    /// Metres in a foot: the unit of cutting speeds in inch programs.
    pub const FOOT: f64 = 0.3048;

    /// Millimetres in one unit.
    pub fn mm(self) -> f64 {
        match self {
            Unit::Mm => 1.0,
            Unit::Inch => 25.4,
        }
    }
}
