//! Diameters and radii of the diameter axis: DIAMON, DIAMOF, DIAM90.

use crate::diag::{Answer, codes};
use crate::machine::Axis;
use crate::text::Span;

use super::vocabulary::Indexed;
use super::{Core, Outcome};

/// How values of the diameter axis count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Diameter {
    Off,
    /// Absolute and incremental values are diameters.
    On,
    /// Absolute values are diameters, increments radii.
    Absolute,
}

impl Core<'_> {
    #[inline]
    pub(super) fn is_diameter_axis(&self, axis: Axis) -> bool {
        self.job.settings.machine.diameter_axis == Some(axis)
    }

    pub(super) fn no_diameter_axis<T>(&self, span: Span) -> Outcome<T> {
        if let Some(axis) = self.job.settings.machine.diameter_axis {
            return self.refuse(span, codes::S2060::only_counts_in_diameters(&axis.letter()));
        }
        self.refuse(
            span,
            codes::S2060::no_diameter_axis_is_configured().answer(Answer::key("machine", "diameter_axis")),
        )
    }
}

/// DIAMONA[X] and its kin: how the values of the axis count, where not as the codes say.
pub(super) fn diameter_of(core: &Core<'_>, indexed: Indexed, axis: Axis, span: Span) -> Outcome<Option<Diameter>> {
    if !core.is_diameter_axis(axis) {
        return core.no_diameter_axis(span);
    }
    Ok(match indexed {
        Indexed::DiameterOn => Some(Diameter::On),
        Indexed::Diameter90 => Some(Diameter::Absolute),
        Indexed::DiameterOff => Some(Diameter::Off),
        _ => None,
    })
}
