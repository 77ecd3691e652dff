//! Words of axes by the names that a program gives them.

use crate::diag::{Answer, Fault, codes};
use crate::machine::Axis;

use super::axis_names::{AxisNames, NamedAxis};
use super::words::{Given, MachineAxis, Words};
use super::{Core, Outcome};

impl Words {
    /// The word of an axis.
    #[inline]
    pub fn add_axis(&mut self, core: &Core<'_>, names: &mut AxisNames, named: NamedAxis, given: Given) -> Outcome {
        match names.printed(core, named, given.span)? {
            Some(axis) => self.set_axis(core, axis, given),
            None if self.beside.left_out.iter().any(|(known, _)| *known == named) => {
                core.refuse(given.span, codes::P1002::axis_stands_twice_in_block(&named.text()))
            }
            None => {
                self.beside.left_out.push((named, given.span));
                Ok(())
            }
        }
    }

    /// A cycle or program that runs behind each position, and a position of an axis that is left out.
    pub fn moves_what_is_left_out(&self, core: &Core<'_>) -> Outcome {
        let Some((named, span)) = self.beside.left_out.first() else { return Ok(()) };
        core.refuse(
            *span,
            codes::S9130::takes_modal_call_to_another_place(&named.text()).answer(
                Answer::entry("machine", "axes", named.text())
                    .one_of(&["\"A\"", "\"B\"", "\"C\"", "\"U\"", "\"V\"", "\"W\""]),
            ),
        )
    }
}

impl AxisNames {
    /// The printed axis of a machine axis that G74 or G75 names: `X1` is the one of X.
    pub(super) fn machine_axis(&mut self, core: &Core<'_>, axis: MachineAxis) -> Outcome<Option<Axis>> {
        match self.letter(axis.letter) {
            // What X1 is to X is no second name.
            Some(NamedAxis { axis: Some(printed), .. }) if axis.number == 1 => Ok(Some(printed)),
            Some(named) if axis.number == 1 => self.printed(core, named, axis.span),
            _ => core.refuse(axis.span, axis.unnamed()),
        }
    }
}

impl MachineAxis {
    /// `B1=90` without an entry in the configuration.
    pub(super) fn unnamed(&self) -> Fault {
        let name = format!("{}{}", self.letter as char, self.number);
        let letter = self.letter as char;
        codes::S2016::which_axis_is_only_machine_knows(&name, &letter).answer(
            Answer::entry("machine", "axes", &name).one_of(&[format!("\"{letter}\""), "\"leave-out\"".to_owned()]),
        )
    }
}
