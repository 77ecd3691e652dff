//! The sections that describe shape: blank, finished part, auxiliary contours. Nothing moves here.
//!
//! Source: T 6 (docs/sources.md).

use std::borrow::Cow;
use std::collections::BTreeSet;

use crate::diag::codes;
use crate::geo::Point2;
use crate::machine::Axis;
use crate::parser::turning::ast::Block;
use crate::sema::run::Where;
use crate::sema::run::refusal::{Made, refused};
use crate::text::decode::readable;

use super::blank::Blank;
use super::chain::Coord;
use super::element_data::{Follows, Transition};
use super::geometry_forms::{ALL_CODES, CODES_OF_G22};
use super::outline::{Builder, Flaw, Mark, Outline};
use super::readings::Question;
use super::words::{Fun, Letters, Measure, Words, letters};
use super::{Core, Job, Outcome, Reported};

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

/// A block of a contour.
#[derive(Clone, Copy)]
pub(super) struct Line<'b> {
    pub w: &'b Words,
    pub block: &'b Block,
    pub measure: Measure,
}

impl Geometry {
    pub fn begin(&mut self, name: Option<String>) {
        self.contours.push(Described { name, builder: Builder::default(), outline: Outline::default(), broken: false });
        self.open = true;
    }

    /// The section ends: the contour is complete.
    pub fn finish(&mut self, core: &Core<'_>) {
        if !std::mem::take(&mut self.open) {
            return;
        }
        let Some(described) = self.contours.last_mut() else { return };
        let result = described.builder.settle().and_then(|()| described.builder.outline(0));
        note_adjusted(&core.job, &described.builder);
        match result {
            Ok(outline) => described.outline = outline,
            Err(_) if described.broken => {}
            Err(flaw) => {
                described.broken = true;
                core.flaw(&flaw);
            }
        }
    }

    /// A block of a geometry section. The blank that it describes.
    pub fn block(&mut self, line: Line<'_>, text: &[u8], core: &Core<'_>) -> Outcome<Option<Blank>> {
        let w = line.w;
        let Some(described) = self.contours.last_mut() else { return Err(Reported) };
        let alone = w.present() == 0 && w.g().is_empty() && w.m().is_empty() && w.longs().is_empty();
        if let (Some(span), true) = (w.text("ID"), alone)
            && described.name.is_none()
            && described.builder.is_empty()
        {
            described.name = Some(readable(span.of(text)).into_owned());
            return Ok(None);
        }
        let mut builder = std::mem::take(&mut described.builder);
        let result = self.shape_block(line, &mut builder, core);
        if let Some(described) = self.contours.last_mut() {
            described.builder = builder;
            described.broken |= result.is_err();
        }
        result
    }

    fn shape_block(&mut self, line: Line<'_>, builder: &mut Builder, core: &Core<'_>) -> Outcome<Option<Blank>> {
        let [fun] = *line.w.g() else {
            return core.refuse(line.block.span, codes::T1008::block_of_contour_holds_one_g_function());
        };
        match fun.number {
            20 | 21 => {
                let blank = core.made(self.new_blank(fun.number, line))?;
                self.blank = Some(blank);
                Ok(Some(blank))
            }
            // Exact stop on the contour: the path is the same without.
            7..=9 => core.made(line.w.only(0, &[])).map(|()| None),
            _ => self.element(line, fun, builder, core).map(|()| None),
        }
    }

    fn new_blank(&self, number: u16, line: Line<'_>) -> Made<Blank> {
        line.w.only(Blank::words(number), &[])?;
        if self.blank.is_some() {
            return refused(Where::Block, codes::T2070::blank_is_described_already());
        }
        let mm = line.measure.mm;
        if number == 20 { Blank::bar(line.w, mm) } else { Blank::casting(line.w, mm) }
    }

    /// An element or form of a contour, in a geometry section or behind a cycle.
    pub fn element(&mut self, line: Line<'_>, fun: Fun, builder: &mut Builder, core: &Core<'_>) -> Outcome {
        let mark = Mark {
            number: line.block.number,
            loc: core.here.origin.loc,
            transition: Transition::Open,
            far: false,
            arc_tolerance: core.arc_tolerance(),
        };
        let Line { w, measure, .. } = line;
        match fun.number {
            0 => {
                self.starts.extend(line.block.number);
                if self.in_blank {
                    core.depends_on(Question::BlankContour, Where::Block);
                }
                core.made(start(w, measure.mm, builder))
            }
            1 => core.element(w, None, measure, mark, builder),
            number @ (2 | 3 | 12 | 13) => {
                core.element(w, Some((matches!(number, 3 | 13), number > 10)), measure, mark, builder)
            }
            22 => core.standard_recess(w, measure.mm, mark, builder),
            23 => core.general_recess(w, measure.mm, mark, builder),
            25 => core.undercut(w, measure.mm, mark, builder),
            34 => core.thread_mark(w, measure.mm, builder),
            37 => core.general_thread_mark(w, measure.mm, builder),
            49 => core.made(w.only(letters("BPWRUEIJKFVAO"), &[])),
            10 | 38 | 39 | 52 | 95 | 149 => {
                core.refuse(fun.span, codes::P9011::attribute_g_of_contour_elements_is_not(&fun.number))
            }
            24 => core.refuse(fun.span, codes::P9011::g24_in_contour_is_not_supported()),
            number => core.refuse(fun.span, codes::P9011::g_is_no_element_of_contour(&number)),
        }
    }
}

/// G0 of a contour.
fn start(w: &Words, mm: f64, builder: &mut Builder) -> Made {
    w.only(letters("XZ"), &[])?;
    if builder.has_start() {
        return refused(Where::Block, codes::T3003::contour_starts_once());
    }
    match (w.coord(Axis::X, mm), w.coord(Axis::Z, mm)) {
        (Coord::At(x), Coord::At(z)) => {
            builder.start(Point2::new(z, x));
            Ok(())
        }
        _ => refused(Where::Block, codes::P1004::start_of_contour_needs_absolute_x()),
    }
}

impl Words {
    /// D of a cycle: the sum of the codes of the forms that it leaves out.
    pub(super) fn left_out(&self) -> Made<u32> {
        let Some(num) = self.get(b'D') else { return Ok(0) };
        let whole = num.value.fract() == 0.0 && (0.0..=f64::from(ALL_CODES)).contains(&num.value);
        let codes = if whole { num.value as u32 } else { u32::MAX };
        if codes & !ALL_CODES != 0 {
            return refused(num.span, codes::T1007::d_is_no_sum_of_codes(&num.value));
        }
        if matches!(codes & CODES_OF_G22, 512 | 1024) {
            return refused(num.span, codes::T9007::d_names_one_kind_of_ring_groove());
        }
        Ok(codes)
    }

    /// Only these words may stand in a block of a contour.
    pub(super) fn only(&self, allowed: Letters, longs: &[&str]) -> Made {
        let stray = self.present() & !allowed;
        if stray != 0 {
            let letter = b'A' + stray.trailing_zeros() as u8;
            let shown = letter as char;
            let fault = match letter {
                b'E' => codes::P1003::feed_has_no_place_in_this_block_of_contour(&shown),
                _ => codes::P1003::has_no_place_in_this_block_of_contour(&shown),
            };
            return refused(self.place(letter), fault);
        }
        if let Some(m) = self.m().first() {
            return refused(m.span, codes::P1003::m_function_has_no_place_in_contour());
        }
        if let Some((addr, span)) = self.texts().first() {
            return refused(*span, codes::P1003::has_no_place_in_contour(&addr));
        }
        for (addr, num) in self.longs() {
            if num.unknown || !longs.contains(&addr.to_string().as_str()) {
                return refused(num.span, codes::P1003::is_not_supported_in_contour(&addr));
            }
        }
        for letter in b'A'..=b'Z' {
            let Some(num) = self.get(letter) else { continue };
            let relative = matches!(letter, b'X' | b'Z' | b'I' | b'K');
            if (num.incremental && !relative) || (num.unknown && !matches!(letter, b'X' | b'Z')) {
                return refused(num.span, codes::P1003::takes_plain_number_here_2(&(letter as char)));
            }
        }
        Ok(())
    }

    /// The words of a line or an arc of a contour.
    fn only_of_element(&self, is_arc: bool) -> Made {
        let allowed = if is_arc { ELEMENT & !letters("A") } else { ELEMENT & !letters("RIK") };
        self.only(allowed, if is_arc { &["BR"] } else { &["AN", "BR"] })?;
        match [self.get(b'I'), self.get(b'K')].into_iter().flatten().find(|num| num.incremental) {
            Some(num) => refused(num.span, codes::P1003::i_k_take_plain_numbers_here()),
            None => Ok(()),
        }
    }
}

impl Core<'_> {
    fn element(
        &self,
        w: &Words,
        arc: Option<(bool, bool)>,
        measure: Measure,
        mark: Mark,
        builder: &mut Builder,
    ) -> Outcome {
        self.made(w.only_of_element(arc.is_some()))?;
        if !builder.has_start() {
            return self.refuse(Where::Block, codes::T3003::contour_does_not_say_where_it_starts());
        }
        let (data, Follows { transition, far }) = self.element_of(w, arc, measure)?;
        self.flawless(builder.push(data, Mark { transition, far, ..mark }))
    }
}

/// Centres of arcs were moved to where both ends lie on the circle: worth a word.
pub(super) fn note_adjusted(job: &Job<'_>, builder: &Builder) {
    if let Some((shift, loc)) = builder.adjusted() {
        job.diags.push(codes::G3013::centre_of_this_arc_of_contour(&shift).at(loc));
    }
}
