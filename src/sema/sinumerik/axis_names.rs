//! Names of axes: letters, and the names that `[machine] axes` gives (MD 20080).
//!
//! A name stands for a printed axis, or is left out. Two names of one program never end on one printed axis: what
//! two axes of the machine do cannot be done by one.
//!
//! Source: S 1.3 (docs/sources.md).

use rustc_hash::FxHashSet;

use crate::diag::{Answer, codes};
use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisUse, LONGEST_AXIS_NAME, Settings};
use crate::text::Span;

use super::{Core, Outcome};

/// An axis by the name that the program gives it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct NamedAxis {
    /// The axis that is printed; `None` for one that is left out.
    pub axis: Option<Axis>,
    /// The name, filled with zeros.
    name: [u8; LONGEST_AXIS_NAME],
}

impl NamedAxis {
    fn new(name: &str, axis: Option<Axis>) -> NamedAxis {
        let mut bytes = [0; LONGEST_AXIS_NAME];
        for (place, byte) in bytes.iter_mut().zip(name.bytes()) {
            *place = byte;
        }
        NamedAxis { axis, name: bytes }
    }

    /// A printed axis by its own letter.
    pub fn letter(axis: Axis) -> NamedAxis {
        NamedAxis::new(axis.letter().encode_utf8(&mut [0; 4]), Some(axis))
    }

    pub fn bytes(&self) -> &[u8] {
        let len = self.name.iter().position(|b| *b == 0).unwrap_or(self.name.len());
        &self.name[..len]
    }

    pub fn text(&self) -> &str {
        std::str::from_utf8(self.bytes()).unwrap_or_default()
    }
}

/// What the names of axes stand for, and which of them the program has used.
#[derive(Debug, Default)]
pub(super) struct AxisNames {
    /// Letters, A first.
    letters: [Option<NamedAxis>; 26],
    /// Longer names.
    others: Vec<NamedAxis>,
    /// The configuration gives names; without it two letters are two axes.
    given: bool,
    used: [Option<NamedAxis>; AXES],
    noted: FxHashSet<NamedAxis>,
}

impl std::hash::Hash for NamedAxis {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.name.hash(state);
    }
}

impl AxisNames {
    pub fn new(settings: &Settings) -> AxisNames {
        let mut made = AxisNames { given: !settings.machine.axes.is_empty(), ..AxisNames::default() };
        for axis in Axis::ALL {
            made.set(NamedAxis::letter(axis));
        }
        for (name, stands_for) in &settings.machine.axes {
            let axis = match stands_for {
                AxisUse::Printed(axis) => Some(*axis),
                AxisUse::LeftOut => None,
            };
            made.set(NamedAxis::new(name, axis));
        }
        made
    }

    fn set(&mut self, named: NamedAxis) {
        match named.bytes() {
            [letter @ b'A'..=b'Z'] => self.letters[usize::from(letter - b'A')] = Some(named),
            _ => self.others.push(named),
        }
    }

    /// The configuration gives the names.
    pub fn are_given(&self) -> bool {
        self.given
    }

    /// The axis with a letter.
    #[inline]
    pub fn letter(&self, letter: u8) -> Option<NamedAxis> {
        self.letters.get(usize::from(letter.wrapping_sub(b'A'))).copied().flatten()
    }

    /// The axis with a name, in capitals.
    pub fn find(&self, name: &str) -> Option<NamedAxis> {
        match name.as_bytes() {
            [letter] => self.letter(*letter),
            bytes => self.others.iter().find(|named| named.bytes() == bytes).copied(),
        }
    }

    /// Is the name one that the configuration gives?
    pub fn is_given(&self, named: NamedAxis) -> bool {
        named.bytes().len() > 1 || named.axis.map(NamedAxis::letter) != Some(named)
    }

    /// The name by which the program calls a printed axis.
    pub fn of(&self, axis: Axis) -> NamedAxis {
        let other = || self.others.iter().find(|named| named.axis == Some(axis)).copied();
        self.used[axis.index()].or_else(other).unwrap_or_else(|| NamedAxis::letter(axis))
    }

    /// The printed axis that a name stands for; `None` for one that is left out, which is noted.
    #[inline]
    pub fn printed(&mut self, core: &Core<'_>, named: NamedAxis, span: Span) -> Outcome<Option<Axis>> {
        if self.given { self.given_axis(core, named, span) } else { Ok(named.axis) }
    }

    fn given_axis(&mut self, core: &Core<'_>, named: NamedAxis, span: Span) -> Outcome<Option<Axis>> {
        let Some(axis) = named.axis else {
            if self.noted.insert(named) {
                core.report(codes::S8130::axis_is_left_out(&named.text()).at(core.loc(span)));
            }
            return Ok(None);
        };
        let first = *self.used[axis.index()].get_or_insert(named);
        if first == named {
            return Ok(Some(axis));
        }
        core.refuse(
            span,
            codes::S2130::would_both_be_printed(&first.text(), &named.text(), &axis.letter()).answer(
                Answer::entry("machine", "axes", named.text()).one_of(&[
                    "\"leave-out\"",
                    "\"A\"",
                    "\"B\"",
                    "\"C\"",
                    "\"U\"",
                    "\"V\"",
                    "\"W\"",
                ]),
            ),
        )
    }
}
