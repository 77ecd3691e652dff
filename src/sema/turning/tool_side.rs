//! On which side of the contour the tool is, and whether the recesses and undercuts in it lie there.

use crate::diag::codes;
use crate::geo::{Element, Vec2, cross};
use crate::ir::cycle::turning::Towards;

use super::outline::{Flaw, Outline};

impl Outline {
    /// All forms of a contour are cut from the same side.
    pub(super) fn one_sided(&self) -> Result<(), Flaw> {
        let mut forms = self.edges.iter().filter_map(|edge| edge.form);
        let Some(first) = forms.next() else { return Ok(()) };
        match forms.find(|form| form.left != first.left) {
            None => Ok(()),
            Some(other) => {
                let fault = codes::T3050::forms_lie_on_different_sides(&other.name(), &first.name(), &first.loc.line);
                Err(Flaw { loc: other.loc, fault })
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
