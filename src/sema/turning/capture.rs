//! Cycles and the contours that follow them up to G80.
//!
//! Source: T 7 (docs/sources.md).

use crate::diag::codes;
use crate::parser::turning::ast::Block;
use crate::sema::run::refusal::{Made, refused};
use crate::sema::run::{Site, Where};
use crate::text::{Loc, Span};

use super::cycle_call::FollowingContour;
use super::cycles::Row;
use super::geometry::{Geometry, Line, note_adjusted};
use super::outline::{Builder, Outline};
use super::program_parts::Family;
use super::words::{Fun, Num, Words};
use super::{Core, Outcome, Reported, Run};

/// A cycle whose contour is being read.
#[derive(Debug)]
pub(super) struct Capture {
    cycle: &'static Row,
    words: Words,
    /// The block of the cycle.
    here: Site,
    builder: Builder,
    /// The block of the cycle, as its words count.
    function: Span,
    /// Something of the contour was refused.
    broken: bool,
    /// G41 or G42 in the block behind G89.
    side: Option<Fun>,
}

/// Oversizes of the blank in X and Z, in the form of a recess.
const BLANK_OF_FORM: [&str; 2] = ["RI", "RK"];

impl Capture {
    pub fn loc(&self) -> Loc {
        self.here.origin.loc
    }

    /// A block of the contour.
    fn take(&mut self, line: Line<'_>, geometry: &mut Geometry, core: &Core<'_>) -> Outcome {
        let w = line.w;
        let (number, what) = (self.cycle.number, &self.cycle.signature.what);
        let (side, functions) = match *w.g() {
            [side, ref rest @ ..] if number == 89 && matches!(side.number, 41 | 42) => (Some(side), rest),
            ref all => (None, all),
        };
        if let Some(side) = side {
            if !self.builder.is_empty() || self.builder.has_start() || self.side.is_some() {
                return core.refuse(side.span, codes::T2021::g_stands_inside_of_contour_of_g89(&side.number));
            }
            self.side = Some(side);
            if functions.is_empty() && w.present() == 0 {
                return Ok(());
            }
        }
        let [fun] = *functions else {
            return core.refuse(line.block.span, codes::T3003::contour_of_g_holds_block(&number, what));
        };
        let form = matches!(fun.number, 22 | 23 | 25 | 34 | 37);
        let path = matches!(fun.number, 0..=3 | 12 | 13);
        if !(path || form && line.measure.family == Family::DinPlus) {
            return core.refuse(fun.span, codes::T3003::g_cannot_stand_in_contour_of_g(&fun.number, &number, what));
        }
        geometry.element(line, fun, &mut self.builder, core)
    }

    /// The words of a contour in G80; RI and RK belong to the form of a recess. Source: T 12.
    fn known_words(&self, w: &Words) -> Made {
        if w.present() != 0 || !w.m().is_empty() || !w.texts().is_empty() {
            return refused(Where::Block, codes::P1003::g80_stands_alone_in_its_block());
        }
        let number = self.cycle.number;
        let known = super::g_functions::find(80).map_or(&[][..], |row| row.longs);
        for (addr, num) in w.longs() {
            let name = addr.to_string();
            if num.unknown {
                return refused(num.span, codes::P1003::takes_number(&name));
            }
            let form = number == 869 && BLANK_OF_FORM.contains(&name.as_str());
            if !form && !known.contains(&name.as_str()) {
                return refused(num.span, codes::P1003::g80_takes_no_behind_g(&name, &number));
            }
        }
        Ok(())
    }

    /// RI and RK of G80 say how far the blank stands proud, as they do in the block of G869.
    fn blank_of_form(&mut self, w: &Words) -> Made {
        if !self.builder.is_empty() || self.broken {
            return refused(Where::Block, codes::P1005::contour_stands_in_blocks());
        }
        for name in BLANK_OF_FORM {
            let Some(num) = w.long(name) else { continue };
            if self.words.long(name).is_some() {
                return refused(num.span, codes::P1005::stands_in_block_of_g869(&name));
            }
            if num.value < 0.0 {
                return refused(num.span, codes::T1007::oversize_of_blank_is_not_negative());
            }
            // What the cycle finds is shown at its own block.
            self.words.add_long(name, Num { span: self.function, ..num });
        }
        Ok(())
    }

    /// The contour that the blocks describe.
    fn outline(&mut self, core: &Core<'_>) -> Outcome<Outline> {
        let leaves_out = matches!(self.cycle.number, 810 | 820 | 890);
        let left_out = if leaves_out { core.made(self.words.left_out())? } else { 0 };
        let outline = self.builder.settle().and_then(|()| self.builder.outline(left_out));
        note_adjusted(&core.job, &self.builder);
        if self.broken {
            return Err(Reported);
        }
        let outline = core.flawless(outline)?;
        if self.builder.is_empty() {
            return core.refuse(Where::Block, codes::T3003::contour_has_no_element());
        }
        Ok(outline)
    }
}

impl Run<'_> {
    /// A cycle with its words; some wait for their contour.
    pub(super) fn begin_cycle(&mut self, cycle: &'static Row, w: &Words) -> Outcome {
        self.settle_chain()?;
        if !cycle.waits(w, self.named.is_some()) {
            return self.run_cycle(cycle, w, FollowingContour { outline: None, side: None });
        }
        if let Some(m) = w.m().iter().find(|m| !matches!(m.number, 3 | 4 | 8)) {
            return self.core.refuse(m.span, codes::P1005::m_stands_in_block_of_cycle_whose(&m.number));
        }
        self.capture = Some(Box::new(Capture {
            cycle,
            words: w.clone(),
            here: self.core.here,
            builder: Builder::default(),
            function: self.core.block_span(),
            broken: false,
            side: None,
        }));
        Ok(())
    }

    /// A block of the contour behind a cycle.
    pub(super) fn capture_block(&mut self, w: &Words, block: &Block) -> Outcome {
        let Some(mut capture) = self.capture.take() else { return Err(Reported) };
        if matches!(w.g(), [fun] if fun.number == 80) {
            return self.end_of_contour(*capture, w);
        }
        let line = Line { w, block, measure: self.measure() };
        // The cycle is refused as a whole at its end.
        capture.broken |= capture.take(line, &mut self.geometry, &self.core).is_err();
        self.capture = Some(capture);
        Ok(())
    }

    /// G80
    fn end_of_contour(&mut self, mut capture: Capture, w: &Words) -> Outcome {
        self.core.made(capture.known_words(w))?;
        let outline = match self.core.contour_words(w, capture.cycle.number, &self.st)? {
            Some(outline) => {
                self.core.made(capture.blank_of_form(w))?;
                outline
            }
            None => capture.outline(&self.core)?,
        };
        let here = std::mem::replace(&mut self.core.here, capture.here);
        let behind = FollowingContour { outline: Some(&outline), side: capture.side };
        let result = self.run_cycle(capture.cycle, &capture.words, behind);
        self.core.here = here;
        result
    }
}
