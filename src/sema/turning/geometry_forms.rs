//! Blocks that put a form on an element of a contour: recesses, undercuts, threads.
//!
//! Source: T 6.3 (docs/sources.md).

use crate::diag::{Answer, Fault, Label, codes};
use crate::geo::Deg;
use crate::geo::undercut::{Edge, Shape};
use crate::machine::{Axis, RecessDepth, RecessWidth, Undercuts};
use crate::sema::run::Where;
use crate::sema::run::refusal::{Made, refused};
use crate::standard::{din13, din76, din509};
use crate::text::Loc;

use super::chain::{Coord, Solved};
use super::element_data::{Transition, transition_of};
use super::forms::{Along, Recess};
use super::outline::{Builder, BuiltElement, Mark, ThreadData};
use super::readings::Question;
use super::undercuts::{self, Thread, Undercut};
use super::words::{Words, letters};
use super::{Core, Outcome, Reported};

/// Codes by which D of a cycle leaves forms out. A recess of G22 is a sealing ring or a guard ring, which its block does
/// not say, so both codes are needed. Source: T 6.3.
pub(super) const CODES_OF_G22: u32 = 512 | 1024;
const CODE_OF_G23: u32 = 256;
pub(super) const ALL_CODES: u32 = 256 | 512 | 1024 | 2048 | 0x001f_8000;

fn code_of_undercut(form: f64) -> u32 {
    match form as i32 {
        4 => 32_768,
        0 | 5 => 65_536,
        6 => 131_072,
        7 => 262_144,
        8 => 524_288,
        _ => 1_048_576,
    }
}

impl Words {
    /// How far the flanks of a recess lean inwards for each mm of depth, as A says.
    fn lean(&self) -> Made<f64> {
        match self.get(b'A') {
            None => Ok(0.0),
            Some(num) if (0.0..180.0).contains(&num.value) => {
                let (sin, cos) = Deg(num.value / 2.0).sin_cos();
                Ok(sin / cos)
            }
            Some(num) => refused(num.span, codes::T1007::lies_between_0_and_180_degrees()),
        }
    }

    /// Depth of a recess in `line`, positive right of it.
    fn depth(&self, line: &Solved, mm: f64) -> Made<f64> {
        match (self.get(b'I'), self.get(b'U')) {
            (Some(i), None) if !i.incremental && i.value != 0.0 => Ok(i.value * mm),
            (None, Some(u)) if (line.to.y - line.from.y).abs() < 1e-9 => {
                // Right of the line lies towards the axis where it runs towards +Z.
                let down = line.from.y - u.value * mm * 0.5;
                Ok(if line.to.x > line.from.x { down } else { -down })
            }
            (None, Some(u)) => refused(u.span, codes::T3004::u_needs_line_parallel_to_z_before()),
            _ => refused(Where::Block, codes::P1004::recess_needs_either_its_depth_i()),
        }
    }

    /// G37: pitch F, type Q, depth P.
    fn thread(&self, mm: f64) -> Made<ThreadData> {
        // Flank angles and the width of the crest are the tool's.
        for letter in [b'K', b'D', b'E', b'V'] {
            if let Some(num) = self.get(letter).filter(|num| num.value != 0.0) {
                return refused(num.span, codes::T9007::of_g37_is_not_supported(&(letter as char)));
            }
        }
        if let Some(num) = self.get(b'H').filter(|num| num.value > 1.0) {
            return refused(num.span, codes::T9007::thread_with_several_starts_is_not_supported());
        }
        let kind = self.choice(b'Q', 12, 14)?;
        let pitch = self.needed_length(b'F', mm, "the pitch of the thread")?;
        let depth = match (self.get(b'P'), kind) {
            (Some(num), _) => [num.above_zero(mm, "the depth of the thread")?; 2],
            (None, 1 | 2 | 13 | 14) => din13::DEPTH.map(|d| d * pitch),
            (None, 9) => [0.640_33 * pitch; 2],
            (None, 11) => [0.640_327 * pitch; 2],
            _ => return refused(Where::Block, codes::P1004::p_is_missing(&kind)),
        };
        Ok(ThreadData { pitch, depth })
    }

    /// G25 of form 7, of which the table has what is missing.
    fn thread_undercut(&self, mm: f64) -> Made<Thread> {
        let given = |letter: u8, what: &str| self.get(letter).map(|num| num.above_zero(mm, what)).transpose();
        Ok(Thread {
            pitch: self.long("FP").map(|num| num.above_zero(mm, "the pitch of the thread")).transpose()?,
            depth: given(b'I', "the depth of the undercut")?,
            width: given(b'K', "the width of the undercut")?,
            radius: given(b'R', "the radius of the undercut")?,
            slope: self.value(b'W').unwrap_or(din76::ENTRY),
        })
    }

    /// The undercut of G25; `listed` is the size of DIN 509 for this diameter.
    fn undercut(
        &self,
        form: f64,
        (diameter, listed): (f64, Option<din509::Size>),
        mm: f64,
        tables: &Undercuts,
    ) -> Made<Undercut> {
        let size = |letter: u8, default: f64| self.value(letter).map_or(default, |v| v * mm);
        let angle = |letter: u8, default: f64| self.value(letter).unwrap_or(default);
        let of_table = |letter: u8, value: fn(&din509::Size) -> f64| match (self.value(letter), listed) {
            (Some(v), _) => Ok(v * mm),
            (None, Some(size)) => Ok(value(&size)),
            (None, None) => refused(Where::Block, codes::P1004::size_of_undercut_is_missing(&diameter)),
        };
        Ok(match form as i32 {
            4 if form == 4.0 => {
                let groove = Shape::Groove {
                    depth: self.needed_length(b'I', mm, "the depth of the undercut")?,
                    width: self.needed_length(b'K', mm, "the width of the undercut")?,
                    radius: size(b'R', 0.0),
                    edge: Edge::Sharp,
                };
                Undercut { edge: Some(transition_of(size(b'P', 0.0))), ..groove.into() }
            }
            0 | 5 if form.fract() == 0.0 => {
                let (depth, width) = (of_table(b'I', |size| size.depth)?, of_table(b'K', |size| size.length)?);
                undercuts::square(depth, width, of_table(b'R', |size| size.radius)?, angle(b'W', din509::ENTRY)).into()
            }
            6 if form == 6.0 => {
                let radius = of_table(b'R', |size| size.radius)?;
                Undercut::from(Shape::Recessed {
                    length: of_table(b'K', |size| size.length)?,
                    depth: of_table(b'I', |size| size.depth)?,
                    entry: Deg(angle(b'W', din509::ENTRY)),
                    entry_radius: radius,
                    corner_radius: radius,
                    face_depth: of_table(b'P', |size| size.face_depth)?,
                    face_angle: Deg(angle(b'A', din509::FACE)),
                })
            }
            7 if form == 7.0 => self.thread_undercut(mm)?.sized(tables),
            8 | 9 if form.fract() == 0.0 => return refused(self.place(b'H'), codes::T9007::undercuts_h()),
            _ => return refused(self.place(b'H'), codes::T1007::h_is_no_form_of_undercut(&form)),
        })
    }
}

impl Core<'_> {
    /// The last element, complete; forms belong to it.
    fn reference<'b>(&self, builder: &'b mut Builder, what: &str) -> Outcome<&'b mut BuiltElement> {
        self.flawless(builder.settle())?;
        let missing = || codes::T3004::stands_behind_element_of_contour(&what);
        self.accept(Where::Block, builder.pieces.last_mut().ok_or_else(missing))
    }

    /// G22: a recess in a line parallel to an axis.
    pub(super) fn standard_recess(&self, w: &Words, mm: f64, mark: Mark, builder: &mut Builder) -> Outcome {
        self.made(w.only(letters("XZIKBR"), &[]))?;
        let (in_face, start) = match (w.coord(Axis::X, mm), w.coord(Axis::Z, mm)) {
            (Coord::Stay, Coord::At(z)) => (false, z),
            (Coord::At(x), Coord::Stay) => (true, x),
            _ => return self.refuse(Where::Block, codes::P1004::recess_names_either_x_or_z()),
        };
        let i = self.made(w.needed(b'I', "the floor of the recess, or its end in a face"))?;
        let k = self.made(w.needed(b'K', "the end of the recess, or its floor in a face"))?;
        let piece = self.reference(builder, "a recess")?;
        let line = piece.solved;
        // An incremental I is the difference of two diameters, as far as any manual says.
        if i.incremental {
            self.depends_on(Question::RecessDepth, i.span);
        }
        let radius = self.job.settings.control.turning.recess_depth == Some(RecessDepth::Radius);
        let step = i.value * mm * if radius { 1.0 } else { 0.5 };
        let x = |base: f64| if i.incremental { base + step } else { i.value * mm * 0.5 };
        let z = |base: f64| if k.incremental { base + k.value * mm } else { k.value * mm };
        let top = self.made(w.transition(mm))?;
        let base = w.value(b'R').unwrap_or(0.0) * mm;
        let recess = if in_face {
            Recess::Face { first: start, second: x(start), floor: z(line.from.x), top, base }
        } else {
            Recess::Cylinder { first: start, second: z(start), floor: x(line.from.y), top, base }
        };
        piece.recesses.push((recess, mark));
        piece.codes.0.push(CODES_OF_G22);
        Ok(())
    }

    /// G23: a symmetric recess in any line.
    pub(super) fn general_recess(&self, w: &Words, mm: f64, mark: Mark, builder: &mut Builder) -> Outcome {
        self.made(w.only(letters("HXZIKUABPR"), &[]))?;
        if let Some(num) = w.get(b'H').filter(|num| num.value != 0.0) {
            return self.refuse(num.span, codes::T9007::relief_turn());
        }
        let lean = self.made(w.lean())?;
        let at = match (w.coord(Axis::X, mm), w.coord(Axis::Z, mm)) {
            (Coord::At(x), Coord::Stay) => Along::X(x),
            (Coord::Stay, Coord::At(z)) => Along::Z(z),
            _ => return self.refuse(Where::Block, codes::P1004::middle_of_recess_is_missing()),
        };
        let width = self.made(w.needed_length(b'K', mm, "the width of the recess"))?;
        let piece = self.reference(builder, "a recess")?;
        let depth = self.made(w.depth(&piece.solved, mm))?;
        let edge = |letter: u8| w.value(letter).map_or(Transition::Sharp, |b| transition_of(b * mm));
        let (near, far) = (edge(b'B'), edge(b'P'));
        let base = w.value(b'R').unwrap_or(0.0) * mm;
        // K counts at the reference element, as far as any text says; a picture may show the floor.
        if lean > 0.0 {
            self.depends_on(Question::RecessWidth, w.place(b'K'));
        }
        let floor = self.job.settings.control.turning.recess_width == Some(RecessWidth::Floor);
        let width = if floor { width + 2.0 * lean * depth.abs() } else { width };
        piece.recesses.push((Recess::Centered { at, width, lean, depth, near, far, base }, mark));
        piece.codes.0.push(CODE_OF_G23);
        Ok(())
    }

    /// G25: an undercut in the corner between the element before and the next one.
    pub(super) fn undercut(&self, w: &Words, mm: f64, mark: Mark, builder: &mut Builder) -> Outcome {
        self.made(w.only(letters("HIKRPWA"), &["FP"]))?;
        let form = self.made(w.needed(b'H', "the form of the undercut"))?.value;
        let piece = self.reference(builder, "an undercut")?;
        // The table goes by the diameter of the cylinder.
        let diameter = 2.0 * piece.solved.to.y;
        let tables = &self.job.settings.undercut;
        let row = tables.size_for(diameter, din509::HEIDENHAIN);
        if let (0 | 5 | 6, Some((range, size)), None) = (form as i32, row, w.get(b'R')) {
            self.disputed_row(range, size);
        }
        let undercut = self.made(w.undercut(form, (diameter, row.map(|(_, size)| *size)), mm, tables))?;
        if let Some((_, first)) = &piece.undercut {
            return self.said_twice(codes::T2070::corner_has_undercut(), first.loc);
        }
        piece.undercut = Some((undercut, mark));
        piece.codes.1 = code_of_undercut(form);
        Ok(())
    }

    /// A word about the size of an undercut of which sources say different things.
    fn disputed_row(&self, range: &din509::Range, size: &din509::Size) {
        let Some(otherwise) = range.otherwise else { return };
        let (r, t, source) = (size.radius, size.depth, range.source.0);
        let asking = codes::T8007::size_of_this_undercut_is_x(&r, &t, &source, &otherwise);
        self.say_once(Where::Block, asking.answer(Answer::key("undercut", "din509_by_diameter")));
    }

    /// G34: the element before is a metric ISO thread.
    pub(super) fn thread_mark(&self, w: &Words, mm: f64, builder: &mut Builder) -> Outcome {
        self.made(w.only(letters("F"), &[]))?;
        let pitch = self.made(w.needed_length(b'F', mm, "the pitch of the thread"))?;
        self.put_thread(ThreadData { pitch, depth: din13::DEPTH.map(|d| d * pitch) }, builder)
    }

    /// G37: the element before is a thread of any type.
    pub(super) fn general_thread_mark(&self, w: &Words, mm: f64, builder: &mut Builder) -> Outcome {
        self.made(w.only(letters("QFPAWRKDHEV"), &[]))?;
        let thread = self.made(w.thread(mm))?;
        self.put_thread(thread, builder)
    }

    fn put_thread(&self, thread: ThreadData, builder: &mut Builder) -> Outcome {
        let piece = self.reference(builder, "a thread")?;
        if piece.thread.is_some() {
            return self.said_twice(codes::T2070::element_is_thread(), piece.mark.loc);
        }
        piece.thread = Some(thread);
        Ok(())
    }

    /// Only one of the two can be meant.
    fn said_twice(&self, fault: Fault, first: Loc) -> Outcome {
        self.report(fault.at(self.here.origin.loc).also(first, Label::SaidFor));
        Err(Reported)
    }
}
