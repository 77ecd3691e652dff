//! Diameters and radii of the diameter axis: DIAMON, DIAMOF, DIAM90.

/// How values of the diameter axis count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Diameter {
    Off,
    /// Absolute and incremental values are diameters.
    On,
    /// Absolute values are diameters, increments radii.
    Absolute,
}
