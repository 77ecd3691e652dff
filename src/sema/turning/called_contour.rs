//! The contour that a cycle names, or that follows it.

use crate::diag::{Fault, codes};
use crate::sema::run::Where;

use super::cycles::Contour;
use super::geometry::{Described, Geometry};
use super::outline::{Edge, MOST_EDGES, Outline, Section};
use super::words::{Num, Words};
use super::{Core, Outcome, Reported};

/// Which contour a cycle works along.
#[derive(Clone, Copy)]
pub(super) struct Wanted<'w> {
    pub w: &'w Words,
    /// The contour that ID names.
    pub named: Option<&'w str>,
    /// The contour in the blocks behind it.
    pub behind: Option<&'w Outline>,
}

impl Geometry {
    /// The contour that a cycle takes, as its row says.
    pub fn contour_for(&self, contour: Contour, wanted: Wanted<'_>, core: &Core<'_>) -> Outcome<Option<Section>> {
        match contour {
            Contour::None => Ok(None),
            Contour::LineOrReferenced if wanted.w.has(b'X') || wanted.w.has(b'Z') => Ok(None),
            Contour::Follows | Contour::LineOrReferenced => self.contour_of(wanted, 0, core).map(Some),
            Contour::Referenced => {
                let left_out = core.made(wanted.w.left_out())?;
                let mut section = self.contour_of(wanted, left_out, core)?;
                section.leave_out_ends(wanted.w.value(b'V').unwrap_or(0.0) as i32);
                Ok(Some(section))
            }
        }
    }

    /// The blocks behind the cycle, or those of a geometry section that ID, NS and NE name.
    fn contour_of(&self, wanted: Wanted<'_>, left_out: u32, core: &Core<'_>) -> Outcome<Section> {
        let section = match (wanted.behind, wanted.named) {
            (Some(outline), _) => outline.all(),
            (None, Some(name)) => self.named_contour(name, wanted.w, left_out, core)?,
            (None, None) => self.numbered_contour(wanted.w, left_out, core)?,
        };
        if section.edges.len() > MOST_EDGES {
            return core.refuse(Where::Block, codes::T3003::contour_of_cycle_has_more_than_elements(&MOST_EDGES));
        }
        Ok(section)
    }

    /// The elements from NS to NE, in whatever contour they stand.
    fn numbered_contour(&self, w: &Words, left_out: u32, core: &Core<'_>) -> Outcome<Section> {
        let Some(first) = w.long("NS") else {
            return core.refuse(Where::Block, codes::P1004::cycle_has_neither_ns_nor_contour());
        };
        let last = w.long("NE");
        let (Some(ns), Some(ne)) = (first.block_number(), last.unwrap_or(first).block_number()) else {
            return core.refuse(first.span, codes::T1007::ns_and_ne_are_block_numbers());
        };
        let mut missing = ns;
        let mut found = Vec::new();
        for described in &self.contours {
            let outline = core.flawless(described.outline_without(left_out))?;
            match outline.between(ns, last.map(|_| ne)) {
                Ok(section) => found.push(section),
                Err(number) if number != ns => missing = number,
                Err(_) => {}
            }
        }
        if found.len() > 1 {
            return core.refuse(first.span, codes::T2019::block_number_stands_in_two_contours(&ns));
        }
        if let Some(section) = found.pop() {
            return Ok(section);
        }
        if self.contours.iter().any(|described| described.broken) {
            return Err(Reported);
        }
        let no_element = || codes::T2019::no_element_of_contour_has_block_number(&missing);
        core.refuse(first.span, self.is_start(missing).unwrap_or_else(no_element))
    }

    /// What is wrong with the number of a start point, which is no element.
    fn is_start(&self, number: u32) -> Option<Fault> {
        self.starts.contains(&number).then(|| codes::T2019::n_is_start_point_of_contour(&number))
    }

    /// The contour that ID names: all of it, or from NS to NE.
    fn named_contour(&self, name: &str, w: &Words, left_out: u32, core: &Core<'_>) -> Outcome<Section> {
        let same =
            |described: &&Described| described.name.as_deref().is_some_and(|known| known.eq_ignore_ascii_case(name));
        let mut found = self.contours.iter().filter(same);
        let (Some(described), None) = (found.next(), found.next()) else {
            return core.refuse(Where::Block, codes::T2019::there_is_no_contour(&name));
        };
        if described.broken {
            return Err(Reported);
        }
        let outline = core.flawless(described.outline_without(left_out))?;
        let section = match (w.long("NS").map(Num::block_number), w.long("NE").map(Num::block_number)) {
            (None, None) => Ok(outline.all()),
            (Some(Some(ns)), None) => outline.between(ns, None),
            (Some(Some(ns)), Some(Some(ne))) => outline.between(ns, Some(ne)),
            _ => return core.refuse(Where::Block, codes::T1007::ns_ne_are_block_numbers()),
        };
        section.or_else(|number| match (self.is_start(number), w.long("NS")) {
            (Some(fault), Some(first)) => core.refuse(first.span, fault),
            _ => core.refuse(Where::Block, codes::T2019::no_element_of_named_contour(&name, &number)),
        })
    }
}

impl Section {
    /// V leaves out the chamfer or rounding at the first or last element.
    fn leave_out_ends(&mut self, v: i32) {
        let edges = &mut self.edges;
        let basic = |edge: &Edge| !edge.corner;
        if !matches!(v, 0 | 1)
            && let Some(at) = edges.iter().position(basic)
        {
            edges.drain(..at);
        }
        if !matches!(v, 0 | 2)
            && let Some(at) = edges.iter().rposition(basic)
        {
            edges.truncate(at + 1);
        }
    }
}
