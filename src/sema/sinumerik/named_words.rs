//! Words of axes and spindles with an index: `AX[Z]=`, `POS[X]=`, `SPOS[2]=`.
//!
//! Source: S 1.3 and 5.6 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::text::Span;

use super::axis_names::NamedAxis;
use super::vocabulary::{Address, Indexed};
use super::words::{Given, Positioning, Words};
use super::{Channel, Outcome, Reported};

impl Channel<'_> {
    /// A word with an axis in brackets, as far as it takes one, and its value.
    pub(super) fn indexed_address(
        &mut self,
        words: &mut Words,
        (indexed, span): (Indexed, Span),
        named: Option<NamedAxis>,
        given: Option<Given>,
    ) -> Outcome {
        match (indexed, named, given) {
            (Indexed::Ax, Some(named), Some(given)) => {
                if named.axis.is_some_and(|axis| words.axes.contains(axis)) {
                    let fault = codes::P1002::axis_stands_twice_in_block_so_delete_one(&named.text());
                    return self.core.refuse(given.span, fault);
                }
                return words.add_axis(&self.core, &mut self.axis_names, named, given);
            }
            (Indexed::Pos, Some(named), Some(given)) => match self.axis_names.printed(&self.core, named, given.span)? {
                Some(axis) => words.beside.positioning.push(Positioning { axis, given }),
                None => words.beside.left_out.push((named, given.span)),
            },
            (Indexed::Fa, Some(named), Some(given)) => {
                if given.value <= 0.0 {
                    let fault = codes::P2003::feed_of_positioning_axis_is_not_above(&given.value);
                    return self.core.refuse(given.span, fault);
                }
                words.beside.feeds.extend(named.axis.map(|axis| (axis, given.value)));
            }
            (Indexed::Override, _, given) => {
                if given.is_some_and(|given| given.value != 100.0) {
                    return self.core.refuse(span, codes::S9009::ovra_changes_feed_of_axis_or_speed());
                }
            }
            (Indexed::Dynamics, ..) => drop(words.dynamics.get_or_insert(span)),
            (
                Indexed::DiameterOn | Indexed::Diameter90 | Indexed::DiameterOff | Indexed::DiameterChannel,
                Some(named),
                _,
            ) => match named.axis {
                Some(axis) => words.diameter = Some((indexed, axis, span)),
                None => return self.core.no_diameter_axis(span),
            },
            // POSA moves its axis while the next blocks run.
            (Indexed::Posa, Some(named), _) => {
                if self.axis_names.printed(&self.core, named, span)?.is_some() {
                    let fault = codes::S9008::axis_that_moves_beside_path_cannot();
                    return self.core.refuse(span, fault.answer(Answer::key("machine", "axes")));
                }
                words.beside.left_out.push((named, span));
            }
            // SCC names the axis of the diameter, or nothing that can be printed.
            (Indexed::CutAxis, Some(named), _) => {
                if named.axis.is_none() || named.axis != self.core.job.settings.machine.diameter_axis {
                    let answer = Answer::key("machine", "diameter_axis");
                    return self.core.refuse(span, codes::S9132::scc_refers_g96(&named.text()).answer(answer));
                }
            }
            (Indexed::Polynomial, ..) => return self.core.refuse(span, codes::S9002::polynomials_cannot_be_printed()),
            (_, None, _) | (Indexed::Ax | Indexed::Pos | Indexed::Fa, _, None) => return Err(Reported),
        }
        Ok(())
    }

    /// LIMS, SPOS and SPOSA with the number of a spindle.
    pub(super) fn address_of_spindle(
        &mut self,
        words: &mut Words,
        address: Address,
        spindle: u8,
        given: Given,
    ) -> Outcome {
        if spindle == self.st.spindles.master() {
            return words.set_address(&self.core, address, given);
        }
        if address == Address::Lims {
            return self.st.spindles.speed_limit(&self.core, Some(spindle), given);
        }
        let turned = self.st.spindles.position_of(&self.core, spindle, given)?;
        self.function(turned);
        Ok(())
    }
}
