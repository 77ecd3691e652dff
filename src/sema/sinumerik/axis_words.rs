//! Words of axes by the names that a program gives them.

use crate::diag::{Answer, Fault, codes};
use crate::machine::Axis;

use super::axis_names::NamedAxis;
use super::words::{Given, MachineAxis, Words};
use super::{Channel, Outcome};

impl Channel<'_> {
    /// The word of an axis.
    #[inline]
    pub(super) fn axis_word(&mut self, words: &mut Words, named: NamedAxis, given: Given) -> Outcome {
        match self.printed_axis(named, given.span)? {
            Some(axis) => words.set_axis(&self.core, axis, given),
            None if words.beside.left_out.iter().any(|(known, _)| *known == named) => {
                self.core.refuse(given.span, codes::P1002::axis_stands_twice_in_block(&named.text()))
            }
            None => {
                words.beside.left_out.push((named, given.span));
                Ok(())
            }
        }
    }

    /// A cycle or program that runs behind each position, and a position of an axis that is left out.
    pub(super) fn left_out_under_modal_call(&self, w: &Words) -> Outcome {
        let Some((named, span)) = w.beside.left_out.first() else { return Ok(()) };
        if !self.st.modal_call.is_on() {
            return Ok(());
        }
        self.core.refuse(
            *span,
            codes::S9130::takes_modal_call_to_another_place(&named.text()).answer(
                Answer::entry("machine", "axes", named.text())
                    .one_of(&["\"A\"", "\"B\"", "\"C\"", "\"U\"", "\"V\"", "\"W\""]),
            ),
        )
    }

    /// The printed axis of a machine axis that G74 or G75 names: `X1` is the one of X.
    pub(super) fn machine_axis(&mut self, axis: MachineAxis) -> Outcome<Option<Axis>> {
        match self.axis_names.letter(axis.letter) {
            // What X1 is to X is no second name.
            Some(NamedAxis { axis: Some(printed), .. }) if axis.number == 1 => Ok(Some(printed)),
            Some(named) if axis.number == 1 => self.printed_axis(named, axis.span),
            _ => self.core.refuse(axis.span, axis.unnamed()),
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
