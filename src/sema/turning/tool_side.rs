//! On which side of the contour the tool is, and whether the recesses and undercuts in it lie there.

use crate::diag::{Diagnostic, codes};
use crate::geo::{Element, Vec2, cross};
use crate::ir::cycle::turning::Towards;

use super::outline::{Flaw, Outline, Section};
use super::sides::FormKind;
use super::{Outcome, Reported, Run};

impl Outline {
    /// All forms of a contour are cut from the same side.
    pub(super) fn one_sided(&self) -> Result<(), Flaw> {
        let mut forms = self.edges.iter().filter_map(|edge| edge.form);
        let Some(first) = forms.next() else { return Ok(()) };
        match forms.find(|form| form.left != first.left) {
            None => Ok(()),
            Some(other) => {
                let message = format!(
                    "this {} and the {} in line {} lie on different sides of the contour: one of them stands in the air",
                    other.name(),
                    first.name(),
                    first.loc.line
                );
                Err(Flaw::new(codes::T3050, other.loc, message))
            }
        }
    }
}

/// Is the tool left of the contour, where it comes from the side opposite to `into`? `None` where the contour does
/// not lead across.
pub(super) fn tool_is_left(contour: &[Element], into: Towards) -> Option<bool> {
    let (first, last) = (contour.first()?, contour.last()?);
    let out: Vec2 = -into.unit();
    let side = cross(last.to() - first.from(), out);
    (side != 0.0).then_some(side > 0.0)
}

impl Run<'_> {
    /// The recesses and undercuts of the contour lie on the side of the tool.
    pub(super) fn check_forms(&self, section: &Section, tool_left: bool) -> Outcome {
        let wrong = section.edges.iter().filter_map(|edge| edge.form).find(|form| form.left != tool_left);
        let Some(form) = wrong else { return Ok(()) };
        let message = match form.kind {
            FormKind::Recess => {
                "the recess rises out of the material: on the side of the tool it would be a ring left standing"
            }
            FormKind::Undercut => {
                "the undercut stands at a convex edge: on the side of the tool it would be a bead left standing"
            }
        };
        let help = match form.kind {
            FormKind::Recess => "check the sign of I or K, and the floor, of this recess",
            FormKind::Undercut => "an undercut belongs into an inner corner: move it there, or remove it",
        };
        let found = Diagnostic::new(codes::T3050, form.loc, message);
        self.report(found.also(self.here.origin.loc, "the cycle that cuts it").help(help));
        Err(Reported)
    }
}
