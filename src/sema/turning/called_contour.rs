//! The contour that a cycle names, or that follows it.

use crate::diag::codes;

use super::geometry::Described;
use super::outline::{Edge, MOST_EDGES, Outline, Section};
use super::words::{Num, Words};
use super::{Outcome, Reported, Run};

impl Run<'_> {
    /// The contour of a cycle: the blocks behind it, or those of a geometry section that NS and NE name.
    pub(super) fn contour_of(&self, w: &Words, outline: Option<&Outline>, left_out: u32) -> Outcome<Section> {
        let section = match outline {
            Some(outline) => outline.all(),
            None => self.referenced(w, left_out)?,
        };
        if section.edges.len() > MOST_EDGES {
            return self
                .core
                .refuse(self.core.block_span(), codes::T3003::contour_of_cycle_has_more_than_elements(&MOST_EDGES));
        }
        Ok(section)
    }

    /// The same; V leaves out the chamfer or rounding at the first or last element, D recesses and undercuts.
    pub(super) fn contour_with_ends(&self, w: &Words, outline: Option<&Outline>) -> Outcome<Section> {
        let (begin, end) = match w.value(b'V').unwrap_or(0.0) as i32 {
            0 => (true, true),
            1 => (true, false),
            2 => (false, true),
            _ => (false, false),
        };
        let left_out = self.left_out(w)?;
        let mut section = self.contour_of(w, outline, left_out)?;
        let edges = &mut section.edges;
        let basic = |edge: &Edge| !edge.corner;
        if !begin && let Some(at) = edges.iter().position(basic) {
            edges.drain(..at);
        }
        if !end && let Some(at) = edges.iter().rposition(basic) {
            edges.truncate(at + 1);
        }
        Ok(section)
    }

    fn referenced(&self, w: &Words, left_out: u32) -> Outcome<Section> {
        let span = self.core.block_span();
        if let Some(name) = &self.named {
            return self.named_contour(name, w, left_out);
        }
        let Some(first) = w.long("NS") else {
            return self.core.refuse(span, codes::P1004::cycle_has_neither_ns_nor_contour());
        };
        let number = |value: f64| (value.fract() == 0.0 && (0.0..=99_999.0).contains(&value)).then_some(value as u32);
        let last = w.long("NE");
        let (Some(ns), Some(ne)) = (number(first.value), number(last.map_or(first.value, |num| num.value))) else {
            return self.core.refuse(first.span, codes::T1007::ns_and_ne_are_block_numbers());
        };
        let mut missing = ns;
        let mut found = Vec::new();
        for described in &self.geometry.contours {
            let outline = match described.outline_without(left_out) {
                Ok(outline) => outline,
                Err(flaw) => {
                    self.flaw(&flaw);
                    return Err(Reported);
                }
            };
            match outline.between(ns, last.map(|_| ne)) {
                Ok(section) => found.push(section),
                Err(number) if number != ns => missing = number,
                Err(_) => {}
            }
        }
        if found.len() > 1 {
            return self.core.refuse(first.span, codes::T2019::block_number_stands_in_two_contours(&ns));
        }
        if let Some(section) = found.pop() {
            return Ok(section);
        }
        if self.geometry.contours.iter().any(|described| described.broken) {
            return Err(Reported);
        }
        self.no_element(first, missing)
    }

    #[cold]
    fn no_element<T>(&self, first: Num, missing: u32) -> Outcome<T> {
        if self.geometry.starts.contains(&missing) {
            return self.core.refuse(first.span, codes::T2019::n_is_start_point_of_contour(&missing));
        }
        self.core.refuse(first.span, codes::T2019::no_element_of_contour_has_block_number(&missing))
    }

    /// The contour that ID names: all of it, or from NS to NE.
    fn named_contour(&self, name: &str, w: &Words, left_out: u32) -> Outcome<Section> {
        let span = self.core.block_span();
        let same =
            |described: &&Described| described.name.as_deref().is_some_and(|known| known.eq_ignore_ascii_case(name));
        let mut found = self.geometry.contours.iter().filter(same);
        let (Some(described), None) = (found.next(), found.next()) else {
            return self.core.refuse(span, codes::T2019::there_is_no_contour(&name));
        };
        if described.broken {
            return Err(Reported);
        }
        let outline = described.outline_without(left_out).map_err(|flaw| {
            self.flaw(&flaw);
            Reported
        })?;
        let number =
            |num: Num| (num.value.fract() == 0.0 && (0.0..=99_999.0).contains(&num.value)).then_some(num.value as u32);
        let section = match (w.long("NS").map(number), w.long("NE").map(number)) {
            (None, None) => Ok(outline.all()),
            (Some(Some(ns)), None) => outline.between(ns, None),
            (Some(Some(ns)), Some(Some(ne))) => outline.between(ns, Some(ne)),
            _ => return self.core.refuse(span, codes::T1007::ns_ne_are_block_numbers()),
        };
        section.or_else(|number| {
            if self.geometry.starts.contains(&number)
                && let Some(first) = w.long("NS")
            {
                return self.no_element(first, number);
            }
            self.core.refuse(span, codes::T2019::no_element_of_named_contour(&name, &number))
        })
    }
}
