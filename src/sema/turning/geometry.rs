//! The sections that describe shape: blank, finished part, auxiliary contours. Nothing moves here.
//!
//! Source: T 6 (docs/sources.md).

use std::borrow::Cow;
use std::collections::BTreeSet;

use crate::diag::codes;
use crate::geo::Point2;
use crate::ir::{self, Function, Remark};
use crate::machine::Axis;
use crate::parser::turning::ast::Block;
use crate::text::decode::readable;

use super::chain::Coord;
use super::element_data::{Follows, Transition};
use super::geometry_forms::{ALL_CODES, CODES_OF_G22};
use super::outline::{Builder, Flaw, Mark, Outline};
use super::readings::Question;
use super::words::{Fun, Letters, Words, letters};
use super::{Job, Outcome, Reported, Run};

/// Raw stock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Blank {
    /// G20: radius, length, Z of the right face, radius of the bore.
    Bar { radius: f64, length: f64, right: f64, bore: f64 },
    /// G21: oversize on the finished contour, with a bore or without.
    Casting { oversize: f64, bore: bool },
}

/// A described contour.
#[derive(Debug)]
pub(super) struct Described {
    /// ID of an auxiliary contour.
    pub name: Option<String>,
    builder: Builder,
    pub outline: Outline,
    /// Something of it was refused.
    pub broken: bool,
}

impl Described {
    /// The outline without the forms of these codes.
    pub fn outline_without(&self, left_out: u32) -> Result<Cow<'_, Outline>, Flaw> {
        if left_out == 0 || self.broken {
            return Ok(Cow::Borrowed(&self.outline));
        }
        self.builder.outline(left_out).map(Cow::Owned)
    }
}

/// All that the geometry sections describe.
#[derive(Debug, Default)]
pub(super) struct Geometry {
    pub blank: Option<Blank>,
    pub contours: Vec<Described>,
    /// Block numbers of the start points of contours, which name no element.
    pub starts: BTreeSet<u32>,
    open: bool,
    /// The section in hand describes the blank.
    pub in_blank: bool,
}

/// What a block of a contour may hold.
const ELEMENT: Letters = letters("XZABQRIK");

impl Run<'_> {
    /// D of a cycle: the sum of the codes of the forms that it leaves out.
    pub(super) fn left_out(&self, w: &Words) -> Outcome<u32> {
        let Some(num) = w.get(b'D') else { return Ok(0) };
        let whole = num.value.fract() == 0.0 && (0.0..=f64::from(ALL_CODES)).contains(&num.value);
        let codes = if whole { num.value as u32 } else { u32::MAX };
        if codes & !ALL_CODES != 0 {
            return self.core.refuse(num.span, codes::T1007::d_is_no_sum_of_codes(&num.value));
        }
        if matches!(codes & CODES_OF_G22, 512 | 1024) {
            return self.core.refuse(num.span, codes::T9007::d_names_one_kind_of_ring_groove());
        }
        Ok(codes)
    }

    pub(super) fn begin_contour(&mut self, name: Option<String>) {
        self.geometry.contours.push(Described {
            name,
            builder: Builder::default(),
            outline: Outline::default(),
            broken: false,
        });
        self.geometry.open = true;
    }

    /// The section ends: the contour is complete.
    pub(super) fn finish_contour(&mut self) {
        if !std::mem::take(&mut self.geometry.open) {
            return;
        }
        let Some(described) = self.geometry.contours.last_mut() else { return };
        let result = described.builder.settle().and_then(|()| described.builder.outline(0));
        note_adjusted(&self.core.job, &described.builder);
        match result {
            Ok(outline) => described.outline = outline,
            Err(_) if described.broken => {}
            Err(flaw) => {
                described.broken = true;
                self.flaw(&flaw);
            }
        }
    }

    pub(super) fn flaw(&self, flaw: &Flaw) {
        self.core.report(flaw.fault.clone().at(flaw.loc));
    }

    /// A block of a geometry section.
    pub(super) fn geometry_block(&mut self, w: &Words, block: &Block, text: &[u8]) -> Outcome {
        let alone = w.present() == 0 && w.g().is_empty() && w.m().is_empty() && w.longs().is_empty();
        if let (Some(span), true) = (w.text("ID"), alone)
            && let Some(described) = self.geometry.contours.last_mut()
            && described.name.is_none()
            && described.builder.is_empty()
        {
            described.name = Some(readable(span.of(text)).into_owned());
            return Ok(());
        }
        let mut builder = match self.geometry.contours.last_mut() {
            Some(described) => std::mem::take(&mut described.builder),
            None => return Err(Reported),
        };
        let result = self.shape_block(w, block, &mut builder);
        if let Some(described) = self.geometry.contours.last_mut() {
            described.builder = builder;
            described.broken |= result.is_err();
        }
        result
    }

    fn shape_block(&mut self, w: &Words, block: &Block, builder: &mut Builder) -> Outcome {
        let [fun] = *w.g() else {
            return self.core.refuse(block.span, codes::T1008::block_of_contour_holds_one_g_function());
        };
        match fun.number {
            20 => self.bar(w),
            21 => self.casting(w),
            // Exact stop on the contour: the path is the same without.
            7..=9 => self.only(w, 0, &[]),
            _ => self.contour_element(w, block, fun, builder),
        }
    }

    /// An element or form of a contour, in a geometry section or behind a cycle.
    pub(super) fn contour_element(&mut self, w: &Words, block: &Block, fun: Fun, builder: &mut Builder) -> Outcome {
        let mark = Mark {
            number: block.number,
            loc: self.core.here.origin.loc,
            transition: Transition::Open,
            far: false,
            arc_tolerance: self.arc_tolerance(),
        };
        match fun.number {
            0 => {
                self.geometry.starts.extend(block.number);
                self.contour_start(w, builder)
            }
            1 => self.element(w, None, mark, builder),
            2 => self.element(w, Some((false, false)), mark, builder),
            3 => self.element(w, Some((true, false)), mark, builder),
            12 => self.element(w, Some((false, true)), mark, builder),
            13 => self.element(w, Some((true, true)), mark, builder),
            22 => self.standard_recess(w, mark, builder),
            23 => self.general_recess(w, mark, builder),
            25 => self.undercut(w, mark, builder),
            34 => self.thread_mark(w, builder),
            37 => self.general_thread_mark(w, builder),
            49 => self.only(w, letters("BPWRUEIJKFVAO"), &[]),
            10 | 38 | 39 | 52 | 95 | 149 => {
                self.core.refuse(fun.span, codes::P9011::attribute_g_of_contour_elements_is_not(&fun.number))
            }
            24 => self.core.refuse(fun.span, codes::P9011::g24_in_contour_is_not_supported()),
            number => self.core.refuse(fun.span, codes::P9011::g_is_no_element_of_contour(&number)),
        }
    }

    /// Only these words may stand in the block.
    pub(super) fn only(&self, w: &Words, allowed: Letters, longs: &[&str]) -> Outcome {
        let stray = w.present() & !allowed;
        if stray != 0 {
            let letter = b'A' + stray.trailing_zeros() as u8;
            let span = w.span(letter, self.core.block_span());
            let shown = letter as char;
            return self.core.refuse(
                span,
                match letter {
                    b'E' => codes::P1003::feed_has_no_place_in_this_block_of_contour(&shown),
                    _ => codes::P1003::has_no_place_in_this_block_of_contour(&shown),
                },
            );
        }
        if let Some(m) = w.m().first() {
            return self.core.refuse(m.span, codes::P1003::m_function_has_no_place_in_contour());
        }
        if let Some((addr, span)) = w.texts().first() {
            return self.core.refuse(*span, codes::P1003::has_no_place_in_contour(&addr));
        }
        for (addr, num) in w.longs() {
            if num.unknown || !longs.contains(&addr.to_string().as_str()) {
                return self.core.refuse(num.span, codes::P1003::is_not_supported_in_contour(&addr));
            }
        }
        for letter in b'A'..=b'Z' {
            let Some(num) = w.get(letter) else { continue };
            let relative = matches!(letter, b'X' | b'Z' | b'I' | b'K');
            if (num.incremental && !relative) || (num.unknown && !matches!(letter, b'X' | b'Z')) {
                return self.core.refuse(num.span, codes::P1003::takes_plain_number_here_2(&(letter as char)));
            }
        }
        Ok(())
    }

    fn contour_start(&mut self, w: &Words, builder: &mut Builder) -> Outcome {
        if self.geometry.in_blank {
            self.depends_on(Question::BlankContour, self.core.block_span());
        }
        self.only(w, letters("XZ"), &[])?;
        if builder.has_start() {
            return self.core.refuse(self.core.block_span(), codes::T3003::contour_starts_once());
        }
        match (self.coord(w.get(b'X'), Axis::X), self.coord(w.get(b'Z'), Axis::Z)) {
            (Coord::At(x), Coord::At(z)) => {
                builder.start(Point2::new(z, x));
                Ok(())
            }
            _ => self.core.refuse(self.core.block_span(), codes::P1004::start_of_contour_needs_absolute_x()),
        }
    }

    fn element(&mut self, w: &Words, arc: Option<(bool, bool)>, mark: Mark, builder: &mut Builder) -> Outcome {
        let allowed = if arc.is_some() { ELEMENT & !letters("A") } else { ELEMENT & !letters("RIK") };
        self.only(w, allowed, if arc.is_some() { &["BR"] } else { &["AN", "BR"] })?;
        if let Some(num) = [w.get(b'I'), w.get(b'K')].into_iter().flatten().find(|num| num.incremental) {
            return self.core.refuse(num.span, codes::P1003::i_k_take_plain_numbers_here());
        }
        if !builder.has_start() {
            return self.core.refuse(self.core.block_span(), codes::T3003::contour_does_not_say_where_it_starts());
        }
        let (data, Follows { transition, far }) = self.element_of(w, arc)?;
        let pushed = builder.push(data, Mark { transition, far, ..mark });
        self.checked(pushed)
    }

    pub(super) fn checked(&self, result: Result<(), Flaw>) -> Outcome {
        result.map_err(|flaw| {
            self.flaw(&flaw);
            Reported
        })
    }

    // Blanks.

    fn one_blank(&self) -> Outcome {
        if self.geometry.blank.is_none() {
            return Ok(());
        }
        self.core.refuse(self.core.block_span(), codes::T2070::blank_is_described_already())
    }

    fn bar(&mut self, w: &Words) -> Outcome {
        self.only(w, letters("XZKI"), &[])?;
        self.one_blank()?;
        let span = self.core.block_span();
        let mm = self.st.mm();
        let diameter = self.needed(w, b'X', "the diameter of the bar", span)?;
        let diameter = self.above_zero(diameter, "the diameter of the bar")?;
        let length = self.needed(w, b'Z', "the length of the bar", span)?;
        let length = self.above_zero(length, "the length of the bar")?;
        let bore = w.value(b'I').unwrap_or(0.0) * mm;
        if bore < 0.0 || bore >= diameter {
            return self.core.refuse(w.span(b'I', span), codes::T1007::bore_of_tube_is_smaller_than_tube());
        }
        let right = w.value(b'K').unwrap_or(0.0) * mm;
        let (radius, bore) = (diameter / 2.0, bore / 2.0);
        self.geometry.blank = Some(Blank::Bar { radius, length, right, bore });
        let shown = ir::Blank::Round { axis: Axis::Z, radius, bore, low: right - length, high: right };
        self.function(Function::Remark(Remark::Blank(shown)));
        Ok(())
    }

    fn casting(&mut self, w: &Words) -> Outcome {
        self.only(w, letters("PQ"), &[])?;
        self.one_blank()?;
        let num = self.needed(w, b'P', "the oversize of the casting", self.core.block_span())?;
        let oversize = self.above_zero(num, "the oversize of the casting")?;
        let bore = self.choice(w, b'Q', 0, 1)? == 1;
        self.geometry.blank = Some(Blank::Casting { oversize, bore });
        Ok(())
    }
}

/// Centres of arcs were moved to where both ends lie on the circle: worth a word.
pub(super) fn note_adjusted(job: &Job<'_>, builder: &Builder) {
    if let Some((shift, loc)) = builder.adjusted() {
        job.diags.push(codes::G3013::centre_of_this_arc_of_contour(&shift).at(loc));
    }
}
