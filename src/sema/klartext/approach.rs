//! APPR and DEP: the ways to a contour and from it, on lines and arcs.
//!
//! Source: K 2.10 (docs/sources.md). Lengths and radii count on the path of the tool centre. Where the compiler computes
//! it, these ways are sent as what they are, without compensation; the target that compensates gets the contour that
//! leads to them, with the radius R ± r. An approach is sent when the first contour element is known: its direction
//! decides where the approach begins.

mod arrival;
mod border;
mod departure;

use crate::diag::{Answer, Fault, codes};
use crate::parser::klartext::ast::{Addr, Block, Word};
use crate::sema::run::Where;
use crate::text::Span;

use super::block_text::block_name;
use super::reading::Reading;
use super::words::Admits;
use super::{Outcome, Run};

pub(super) use arrival::{Approach, Held, MOST_HELD};
use border::Shape;

/// M functions that have no place in an approach or departure.
const FORBIDDEN: [u32; 9] = [6, 89, 91, 92, 97, 98, 99, 140, 197];

impl Run<'_> {
    pub(super) fn approach_block(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let (name, span) = block_name(block, text, 2);
        let result = self.read_approach(&name.to_ascii_uppercase(), span, block, text);
        if result.is_err() {
            self.approach = None;
            self.st.lose_contour();
            self.st.lose_all(&mut self.core);
        }
        result
    }

    fn read_approach(&mut self, name: &str, span: Span, block: &Block, text: &[u8]) -> Outcome {
        let (function, kind) = name.split_once(' ').unwrap_or((name, ""));
        let departs = function == "DEP";
        let (polar, kind) = match kind.strip_prefix('P') {
            Some(rest) => (true, rest),
            None => (false, kind),
        };
        if !matches!(kind, "LT" | "LN" | "CT" | "LCT") || departs && polar && kind != "LCT" {
            return self.core.refuse(span, codes::K9003::is_not_supported(&name));
        }
        if kind == "LN" && !self.core.computes_path() {
            let fault = codes::K9003::is_not_supported_where_target_compensates(&name);
            return self
                .core
                .refuse(span, fault.answer(Answer::key("output", "compensation").one_of(&["\"resolve\""])));
        }
        let (rest, len, angle) = named_lengths(self.reading(), block, text, name)?;
        let w = self.gather_m(&rest, name, admits(departs, polar, kind), &FORBIDDEN)?;
        let shape = shape(kind, len, angle, w.radius, name);
        let shape = shape.or_else(|fault| self.core.refuse(Where::Block, fault))?;
        if departs {
            self.m_at_start(&w, true)?;
            self.depart(name, shape, polar, &w)?;
        } else {
            w.forbid_m(&self.core, name, &[2, 30])?;
            self.approach_later(name, span, shape, polar, &w)?;
        }
        self.m_at_end(w.m())?;
        self.words = Some(w);
        Ok(())
    }
}

/// Takes LEN and CCA out of the words of the block.
fn named_lengths(
    reading: Reading<'_, '_>,
    block: &Block,
    text: &[u8],
    name: &str,
) -> Outcome<(Block, Option<f64>, Option<f64>)> {
    let (mut len, mut angle) = (None, None);
    let mut rest = block.clone();
    rest.words.clear();
    let mut words = block.words.iter();
    while let Some(&word) = words.next() {
        let name_of_word = word.span.of(text).to_ascii_uppercase();
        let is_ours = word.addr == Addr::Name && matches!(name_of_word.as_slice(), b"LEN" | b"CCA");
        if !is_ours {
            // Others may belong to an M function.
            rest.words.push(word);
            continue;
        }
        let value = match words.next() {
            Some(value @ Word { addr: Addr::Value, .. }) => reading.number(value.value, value.span)?,
            _ => return reading.core.not_admitted(word, name),
        };
        let slot = if name_of_word == b"LEN" { &mut len } else { &mut angle };
        if slot.replace(value).is_some() {
            return reading.core.twice(word, block);
        }
    }
    Ok((rest, len.map(|len| len * reading.core.mm()), angle))
}

fn shape(kind: &str, len: Option<f64>, angle: Option<f64>, radius: Option<f64>, name: &str) -> Result<Shape, Fault> {
    Ok(match (kind, len, angle, radius) {
        ("LT", Some(length), None, None) if length > 0.0 => Shape::Line { length },
        ("LN", Some(length), None, None) if length > 0.0 => Shape::Normal { length },
        ("CT", None, Some(angle), Some(radius)) if angle > 0.0 && angle <= 360.0 && radius != 0.0 => {
            Shape::Arc { radius, angle }
        }
        ("LCT", None, None, Some(radius)) if radius > 0.0 => Shape::LineArc { radius },
        _ => {
            let form = match kind {
                "LT" | "LN" => "LEN above zero: `LEN15`",
                "CT" => "CCA up to 360 degrees and R: `CCA90 R+10`",
                _ => "R above zero: `R8`",
            };
            return Err(codes::P1004::takes_its_size_from_other_words(&name, &form));
        }
    })
}

/// The words of an approach or departure besides LEN and CCA.
fn admits(departs: bool, polar: bool, kind: &str) -> Admits {
    let admits = Admits::FEED.and(Admits::RADIUS).and(Admits::M);
    if departs && kind != "LCT" {
        return admits;
    }
    let admits = admits.and(Admits::AXES).and(Admits::COMP);
    if polar { admits.and(Admits::POLAR) } else { admits }
}
