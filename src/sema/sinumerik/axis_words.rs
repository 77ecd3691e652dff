//! Words of axes by the names that a program gives them.

use crate::diag::{Answer, codes};
use crate::machine::Axis;

use super::axis_names::NamedAxis;
use super::words::{Given, MachineAxis, Words};
use super::{Channel, Core, Outcome};

impl Channel<'_> {
    /// The word of an axis.
    #[inline]
    pub(super) fn axis_word(&mut self, words: &mut Words, named: NamedAxis, given: Given) -> Outcome {
        match self.printed_axis(named, given.span)? {
            Some(axis) => words.set_axis(&self.core, axis, given),
            None if words.beside.left_out.iter().any(|(known, _)| *known == named) => {
                let message = format!("the axis {} stands twice in the block", named.text());
                self.fail_help(codes::S2007.alarm(12000), given.span, message, "delete one of the words")
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
        let message = format!("{} takes the modal call to another place, and is left out", named.text());
        let help = Answer::entry("machine", "axes", named.text())
            .one_of(&["\"A\"", "\"B\"", "\"C\"", "\"U\"", "\"V\"", "\"W\""])
            .help("print the axis (`[machine] axes`), or end the modal call before this block");
        self.fail_help(codes::S9130, *span, message, help)
    }

    /// The printed axis of a machine axis that G74 or G75 names: `X1` is the one of X.
    pub(super) fn machine_axis(&mut self, axis: MachineAxis) -> Outcome<Option<Axis>> {
        match self.axis_names.letter(axis.letter) {
            // What X1 is to X is no second name.
            Some(NamedAxis { axis: Some(printed), .. }) if axis.number == 1 => Ok(Some(printed)),
            Some(named) if axis.number == 1 => self.printed_axis(named, axis.span),
            _ => self.unnamed_axis(axis),
        }
    }
}

impl Core<'_> {
    /// `B1=90` without an entry in the configuration.
    pub(super) fn unnamed_axis<T>(&self, axis: MachineAxis) -> Outcome<T> {
        let name = format!("{}{}", axis.letter as char, axis.number);
        let message = format!("which axis {name} is, only the machine knows");
        let letter = axis.letter as char;
        let help = Answer::entry("machine", "axes", &name).one_of(&[format!("\"{letter}\""), "\"leave-out\"".to_owned()]).help(format!(
            "say it: `[machine] axes = {{ {name} = \"{letter}\" }}`, or \"leave-out\" for an axis that the target does not have"
        ));
        self.fail_help(codes::S2016.alarm(12050), axis.span, message, &help)
    }
}
