//! The words of a block, sorted by what they mean.
//!
//! Source: S 1.2 and 1.3 (docs/sources.md).

use crate::diag::{Fault, Label, codes};
use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisSet};
use crate::parser::sinumerik::ast::{Args, Value, Word};
use crate::parser::symbols::Symbol;
use crate::text::Span;

use super::axis_names::NamedAxis;
use super::foreign_codes::in_place_of;
use super::g_groups::{GCode, GCodes, Group};
use super::probe_state::ProbeWord;
use super::value::whole;
use super::vocabulary::{ADDRESSES, Address, Indexed, Meaning};
use super::{Core, Outcome};

/// How a value is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Mode {
    /// As G90 or G91 say.
    #[default]
    Plain,
    Ac,
    Ic,
    Dc,
    Acp,
    Acn,
    Dac,
    Dic,
    Rac,
    Ric,
    /// `QU`: quick output of an auxiliary function.
    Quick,
    /// `PM`: a feed as under G94.
    PerMinute,
    /// `PR`: a feed as under G95.
    PerTurn,
}

impl Mode {
    fn is_feed(self) -> bool {
        matches!(self, Mode::PerMinute | Mode::PerTurn)
    }

    pub fn of(name: &str) -> Option<Mode> {
        Some(match name {
            "AC" => Mode::Ac,
            "IC" => Mode::Ic,
            "DC" => Mode::Dc,
            "ACP" => Mode::Acp,
            "ACN" => Mode::Acn,
            "DAC" => Mode::Dac,
            "DIC" => Mode::Dic,
            "RAC" => Mode::Rac,
            "RIC" => Mode::Ric,
            "QU" => Mode::Quick,
            "PM" => Mode::PerMinute,
            "PR" => Mode::PerTurn,
            _ => return None,
        })
    }
}

/// Is the name one of AC, IC, DC and their kin?
pub(super) fn is_modifier(name: &str) -> bool {
    Mode::of(name).is_some()
}

/// A number with its place.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Given {
    pub value: f64,
    pub mode: Mode,
    pub span: Span,
}

/// An M word; `spindle` is its extension.
#[derive(Debug, Clone, Copy)]
pub(super) struct MWord {
    pub spindle: Option<u8>,
    pub number: u32,
    pub span: Span,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct SWord {
    pub spindle: Option<u8>,
    pub value: f64,
    pub span: Span,
}

/// A machine axis: `X1`.
#[derive(Debug, Clone, Copy)]
pub(super) struct MachineAxis {
    pub letter: u8,
    pub number: u32,
    pub span: Span,
}

/// A call of a program or procedure by name.
#[derive(Debug, Clone, Copy)]
pub(super) struct CallWord {
    pub name: Symbol,
    pub meaning: Meaning,
    /// `None` for a bare name.
    pub args: Option<Args>,
    pub span: Span,
}

/// A positioning axis: `POS[X]=`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Positioning {
    pub axis: Axis,
    pub given: Given,
}

/// Words that call a program.
#[derive(Debug, Default)]
pub(super) struct CallWords {
    pub word: Option<CallWord>,
    /// Subprogram number, as written.
    pub number: Option<(String, Span)>,
    pub passes: Option<Given>,
    /// The program after SETINT.
    pub interrupt: Option<Span>,
}

/// Words of axes that stand beside the path.
#[derive(Debug, Default)]
pub(super) struct BesideWords {
    /// Machine axes `X1=0`, in G74 and G75 only.
    pub machine: Vec<MachineAxis>,
    /// Words of axes that the target does not have.
    pub left_out: Vec<(NamedAxis, Span)>,
    pub positioning: Vec<Positioning>,
    /// Feed of positioning axes.
    pub feeds: Vec<(Axis, f64)>,
}

/// ADIS and CTOL, in the unit of the program.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SmoothingWords {
    pub distance: Option<f64>,
    pub tolerance: Option<f64>,
}

impl SmoothingWords {
    pub fn is_given(self) -> bool {
        self.distance.is_some() || self.tolerance.is_some()
    }
}

/// The words of a block, sorted. Reused; what is stored for a word that is not given is never read.
#[derive(Debug)]
pub(super) struct Words {
    pub axes: AxisSet,
    axis_words: [Given; AXES],
    given: u64,
    addresses: Vec<Given>,
    pub codes: Vec<(GCode, Span)>,
    pub m: Vec<MWord>,
    pub s: Vec<SWord>,
    pub h: Option<Span>,
    /// F stands in the block.
    pub feed_given: bool,
    /// Tool by name.
    pub tool_name: Option<String>,
    pub calls: CallWords,
    pub beside: BesideWords,
    /// Words without any effect on the path.
    pub dynamics: Option<Span>,
    pub smoothing: SmoothingWords,
    pub diameter: Option<(Indexed, Axis, Span)>,
    /// D in the block of M6.
    pub edge_of_new_tool: Option<Given>,
    /// A word that measures while the block moves.
    pub probe: Option<ProbeWord>,
    /// An assignment, and a word that is none.
    assigned: Option<Span>,
    other: Option<Span>,
}

impl Words {
    pub fn new() -> Words {
        Words {
            axes: AxisSet::EMPTY,
            axis_words: [Given::default(); AXES],
            given: 0,
            addresses: vec![Given::default(); ADDRESSES],
            codes: Vec::new(),
            m: Vec::new(),
            s: Vec::new(),
            h: None,
            feed_given: false,
            tool_name: None,
            calls: CallWords::default(),
            beside: BesideWords::default(),
            dynamics: None,
            smoothing: SmoothingWords::default(),
            diameter: None,
            edge_of_new_tool: None,
            probe: None,
            assigned: None,
            other: None,
        }
    }

    pub fn clear(&mut self) {
        self.axes = AxisSet::EMPTY;
        self.given = 0;
        self.codes.clear();
        self.m.clear();
        self.s.clear();
        self.h = None;
        self.feed_given = false;
        self.tool_name = None;
        self.calls = CallWords::default();
        self.beside.machine.clear();
        self.beside.left_out.clear();
        self.beside.positioning.clear();
        self.beside.feeds.clear();
        self.dynamics = None;
        self.smoothing = SmoothingWords::default();
        self.diameter = None;
        self.edge_of_new_tool = None;
        self.probe = None;
        self.assigned = None;
        self.other = None;
    }

    #[inline]
    pub fn axis(&self, axis: Axis) -> Option<Given> {
        self.axes.contains(axis).then(|| self.axis_words[axis.index()])
    }

    #[inline]
    pub fn get(&self, address: Address) -> Option<Given> {
        (self.given & 1 << address as u64 != 0).then(|| self.addresses[address as usize])
    }

    /// Takes a word out, so that nobody finds it left over.
    pub fn take(&mut self, address: Address) -> Option<Given> {
        let found = self.get(address);
        self.given &= !(1 << address as u64);
        found
    }

    /// Addresses that nobody took.
    pub fn left(&self) -> Option<Given> {
        (self.given != 0).then(|| self.addresses[self.given.trailing_zeros() as usize])
    }

    /// A word of an axis besides its end point: a positioning axis, a machine axis, one that is left out.
    pub fn axis_word_left(&self) -> Option<Span> {
        let positioning = self.beside.positioning.first().map(|positioning| positioning.given.span);
        let left_out = self.beside.left_out.first().map(|(_, span)| *span);
        positioning.or(self.beside.machine.first().map(|axis| axis.span)).or(left_out)
    }

    pub fn has_addresses(&self) -> bool {
        self.given != 0
    }

    /// Code of a group, if the block has one.
    #[inline]
    pub fn code_of(&self, group: Group) -> Option<(GCode, Span)> {
        self.codes.iter().copied().find(|(code, _)| code.group == group)
    }

    /// Notes that a word stands in the block, and whether it is an assignment.
    #[inline]
    pub fn note(&mut self, assigned: bool, span: Span) {
        let seen = if assigned { &mut self.assigned } else { &mut self.other };
        seen.get_or_insert(span);
    }

    /// An assignment beside other words.
    pub fn mixed_assignment(&self) -> Option<Span> {
        self.assigned.filter(|_| self.other.is_some())
    }

    /// Nothing but assignments and comments.
    pub fn is_empty(&self) -> bool {
        self.other.is_none()
    }

    /// Words beside a call.
    pub fn has_other(&self) -> bool {
        !self.axes.is_empty()
            || !self.codes.is_empty()
            || !self.m.is_empty()
            || !self.s.is_empty()
            || self.has_addresses()
            || self.h.is_some()
            || self.axis_word_left().is_some()
            || self.diameter.is_some()
            || self.probe.is_some()
    }

    /// What no part of the block has taken belongs to another block.
    pub fn leftover(&self) -> Result<(), (Span, Fault)> {
        if let Some(left) = self.left() {
            return Err((left.span, self.misfit_of_motion()));
        }
        if let Some(axis) = self.beside.machine.first() {
            return Err((axis.span, axis.unnamed()));
        }
        match self.calls.passes {
            Some(passes) => Err((passes.span, misfit())),
            None => Ok(()),
        }
    }

    /// The same of a word that the motion does not take.
    pub fn misfit_of_motion(&self) -> Fault {
        let alarm = if self.code_of(Group::Motion).is_some() { 12110 } else { 15460 };
        codes::P1003::word_does_not_fit_other_words().alarm(alarm)
    }
}

/// Addresses that mean a place; which of the modifiers they take is decided where they are used.
fn takes_modifiers(address: Address) -> bool {
    use Address::{Ap, Discl, Disrp, I, I1, J, J1, K, K1, Rp, Spos, Sposa};
    matches!(address, I | J | K | I1 | J1 | K1 | Ap | Rp | Spos | Sposa | Discl | Disrp)
}

impl Words {
    pub fn set_subprogram(&mut self, core: &Core<'_>, word: &Word, given: Given) -> Outcome {
        let Value::Literal { digits, whole: true, value } = word.value else {
            return core.refuse(word.span, codes::P1001::subprogram_number_is_written_in_digits());
        };
        if self.calls.number.is_some() {
            return core.refuse(given.span, codes::P1002::l_stands_twice_in_block());
        }
        let width = usize::from(digits);
        self.calls.number = Some((format!("L{value:0width$}"), given.span));
        Ok(())
    }

    /// The word of a letter that names no axis.
    #[inline]
    pub fn set_letter(&mut self, core: &Core<'_>, gcodes: &GCodes, letter: u8, word: &Word, given: Given) -> Outcome {
        let address = match letter {
            b'G' => {
                return match gcodes.get(given.value) {
                    Some(code) => self.add_code(core, code, given.span),
                    None => {
                        let help = in_place_of(given.value);
                        core.refuse(given.span, codes::S2010::g_is_not_known(&given.value).help(help))
                    }
                };
            }
            b'M' => return self.add_m(core, None, given),
            b'F' => Address::F,
            b'S' if self.s.iter().any(|s| s.spindle.is_none()) => {
                return core.refuse(given.span, codes::P1002::s_stands_twice_in_block());
            }
            b'S' => {
                self.s.push(SWord { spindle: None, value: given.value, span: given.span });
                return Ok(());
            }
            b'T' => Address::T,
            b'D' => Address::D,
            b'I' => Address::I,
            b'J' => Address::J,
            b'K' => Address::K,
            b'H' => {
                self.h = Some(given.span);
                return Ok(());
            }
            b'P' if self.calls.passes.is_some() => {
                return core.refuse(given.span, codes::P1002::p_stands_twice_in_block());
            }
            b'P' => {
                self.calls.passes = Some(given);
                return Ok(());
            }
            b'L' => return self.set_subprogram(core, word, given),
            _ => {
                let help = match letter {
                    b'E' => "an exponent is written EX: 1EX5 for 1e5; axes are X Y Z A B C U V W",
                    _ => "check the letter; axes are X Y Z A B C U V W",
                };
                let fault = codes::S2016::address_is_not_known(&(letter as char)).help(help);
                return core.refuse(word.span, fault);
            }
        };
        self.set_address(core, address, given)
    }

    /// `S2=`, `M1=`, `H3=`, `X1=`
    pub fn set_numbered(&mut self, core: &Core<'_>, letter: u8, number: u32, given: Given) -> Outcome {
        let spindle = u8::try_from(number).ok();
        match letter {
            b'S' => return self.add_s(core, spindle, given),
            b'M' => return self.add_m(core, spindle, given),
            b'H' => self.h = Some(given.span),
            _ => self.beside.machine.push(MachineAxis { letter, number, span: given.span }),
        }
        Ok(())
    }

    /// `S[2]=`, `M[1]=`, `H[1]=`, `G[8]=`
    pub fn set_indexed(&mut self, core: &Core<'_>, letter: u8, index: i32, given: Given) -> Outcome {
        let spindle = u8::try_from(index).ok();
        match letter {
            b'S' => return self.add_s(core, spindle, given),
            b'M' => return self.add_m(core, spindle, given),
            b'H' => {
                self.h = Some(given.span);
                return Ok(());
            }
            _ => {}
        }
        let known = u8::try_from(index).ok().and_then(Group::of).filter(|group| group.takes_index());
        let Some(known) = known else {
            return core.refuse(given.span, codes::S2010::g_group_cannot_be_set_by_index(&index));
        };
        let size = known.size();
        match whole(given.value).and_then(|n| u8::try_from(n).ok()).filter(|n| (1..=size).contains(n)) {
            Some(code) => self.add_code(core, GCode::new(known, code), given.span),
            None => core.refuse(given.span, codes::S2011::g_group_has_indices_1(&index, &size, &given.value)),
        }
    }

    /// OVR, ADIS, CTOL and the like.
    pub fn set_dynamics(&mut self, name: &str, value: Option<f64>, span: Span) -> Result<(), Fault> {
        match name {
            "OVR" if value != Some(100.0) => return Err(codes::S9009::ovr_changes_every_feed_by_factor()),
            "ADIS" => self.smoothing.distance = value,
            "CTOL" => self.smoothing.tolerance = value,
            _ => drop(self.dynamics.get_or_insert(span)),
        }
        Ok(())
    }

    pub fn set_axis(&mut self, core: &Core<'_>, axis: Axis, given: Given) -> Outcome {
        if self.axes.contains(axis) {
            return core.refuse(given.span, codes::P1002::axis_stands_twice_in_block(&axis.letter()));
        }
        if given.mode.is_feed() {
            return core.refuse(given.span, misplaced_modifier());
        }
        self.axes.insert(axis);
        self.axis_words[axis.index()] = given;
        Ok(())
    }

    pub fn set_address(&mut self, core: &Core<'_>, address: Address, given: Given) -> Outcome {
        let fits = if given.mode.is_feed() { address == Address::Fad } else { takes_modifiers(address) };
        if given.mode != Mode::Plain && !fits {
            core.accept(given.span, given.no_modifier())?;
        }
        if self.given & 1 << address as u64 != 0 {
            return core.refuse(given.span, codes::P1002::address_stands_twice_in_block());
        }
        self.given |= 1 << address as u64;
        self.addresses[address as usize] = given;
        Ok(())
    }

    pub fn add_code(&mut self, core: &Core<'_>, code: GCode, span: Span) -> Outcome {
        if let Some((first, other)) = self.codes.iter().copied().find(|(known, _)| known.group == code.group) {
            if first == code {
                return Ok(());
            }
            if code.group.shapes_block() {
                return core.two_shapes(first, other, code, span);
            }
            let (a, b) = (first.word(), code.word());
            let found = codes::S2008::are_of_one_group(&a, &b).at(core.loc(span));
            core.report(
                found.also(core.loc(other), Label::OtherOne).help("delete one of them; the control takes the last"),
            );
            return Err(super::Reported);
        }
        self.codes.push((code, span));
        Ok(())
    }

    fn add_s(&mut self, core: &Core<'_>, spindle: Option<u8>, given: Given) -> Outcome {
        core.accept(given.span, given.no_modifier())?;
        self.s.push(SWord { spindle, value: given.value, span: given.span });
        Ok(())
    }

    pub fn add_m(&mut self, core: &Core<'_>, spindle: Option<u8>, given: Given) -> Outcome {
        core.accept(given.span, given.no_modifier())?;
        if given.value < 0.0 || given.value > 1e9 || given.value.fract() != 0.0 {
            return core.refuse(given.span, codes::P2007::m_is_no_m_function(&given.value));
        }
        let mut number = given.value as u32;
        // `M1=66` is a function of the spindle, whatever M66 is.
        if spindle.is_none() && core.job.settings.control.tool_change_m.contains(&number) {
            number = 6;
        }
        self.m.push(MWord { spindle, number, span: given.span });
        Ok(())
    }
}

impl Given {
    /// AC, IC and their kin stand where a place is meant.
    #[inline]
    pub fn no_modifier(self) -> Result<(), Fault> {
        if matches!(self.mode, Mode::Plain | Mode::Quick) { Ok(()) } else { Err(misplaced_modifier()) }
    }
}

#[cold]
pub(super) fn misplaced_modifier() -> Fault {
    codes::P1003::this_address_takes_no_such_modifier()
}

/// A word that does not fit the other words of its block. The control tells a code that is written from one that is modal.
pub(super) fn misfit() -> Fault {
    codes::P1003::word_does_not_fit_other_words().alarm(12110)
}

/// A call needs a block of its own.
pub(super) fn call_not_alone() -> Fault {
    codes::S2013::call_stands_beside_other_words()
}
