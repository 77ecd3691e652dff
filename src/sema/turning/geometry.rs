//! The sections that describe shape: blank, finished part, auxiliary contours. Nothing moves here.
//!
//! Source: reference section 6.

use std::borrow::Cow;
use std::collections::BTreeSet;

use crate::diag::{Diagnostic, codes};
use crate::geo::{Deg, Point2};
use crate::machine::{Axis, RecessDepth, RecessWidth};
use crate::parser::turning::ast::Block;
use crate::text::decode::readable;

use super::chain::Coord;
use super::contour::{Builder, Flaw, Mark, Outline, ThreadData};
use super::coordinates::{Transition, transition_of};
use super::forms::{Along, Recess};
use super::undercuts::{self, LEAN_509, SLOPE_76, SLOPE_509, Undercut};
use super::words::{Fun, Letters, Words, letters};
use super::{Outcome, Reported, Run};

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
}

/// What a block of a contour may hold.
const ELEMENT: Letters = letters("XZABQRIK");

/// Depth of a metric ISO thread by its pitch, outside and inside. Source: reference section 6.3, G37.
const ISO_DEPTH: [f64; 2] = [0.613_43, 0.541_27];

/// Codes by which D of a cycle leaves forms out. A recess of G22 is a sealing ring or a guard ring, which its block does
/// not say, so both codes are needed. Source: reference section 6.3.
const CODES_OF_G22: u32 = 512 | 1024;
const CODE_OF_G23: u32 = 256;
const ALL_CODES: u32 = 256 | 512 | 1024 | 2048 | 0x001f_8000;

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

impl Run<'_> {
    /// D of a cycle: the sum of the codes of the forms that it leaves out.
    pub(super) fn left_out(&self, w: &Words) -> Outcome<u32> {
        let Some(num) = w.get(b'D') else { return Ok(0) };
        let whole = num.value.fract() == 0.0 && (0.0..=f64::from(ALL_CODES)).contains(&num.value);
        let codes = if whole { num.value as u32 } else { u32::MAX };
        if codes & !ALL_CODES != 0 {
            return self.fail_help(
                codes::T1007,
                num.span,
                format!("D{} is no sum of codes of recesses and undercuts", num.value),
                "add 256 for G23, 1536 for G22, 32768 for U, 65536 for E, 131072 for F, 262144 for DIN 76",
            );
        }
        if matches!(codes & CODES_OF_G22, 512 | 1024) {
            return self.fail_help(
                codes::T9007,
                num.span,
                "D names one kind of ring groove, and a recess of G22 does not say which kind it is",
                "program 1536 for all recesses of G22",
            );
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
        let found = Diagnostic::new(flaw.code, flaw.loc, flaw.message.clone());
        self.report(found.help("check this block and the blocks beside it"));
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
            return self.fail_help(
                codes::T1008,
                block.span,
                "a block of a contour holds one G function",
                "write one element in each block: G1 X50 Z-20",
            );
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
        let mark = Mark { number: block.number, loc: self.here.origin.loc, transition: Transition::Open };
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
            10 | 38 | 39 | 52 | 95 | 149 => self.fail_help(
                codes::T9001,
                fun.span,
                format!("the attribute G{} of contour elements is not supported", fun.number),
                "remove it, and put feeds and oversizes into the cycle",
            ),
            24 => self.fail_help(
                codes::T9001,
                fun.span,
                "G24 in a contour is not supported",
                "describe the thread with G34 and the undercut with G25",
            ),
            number => self.fail(codes::T9001, fun.span, format!("G{number} is no element of a contour")),
        }
    }

    /// Only these words may stand in the block.
    fn only(&self, w: &Words, allowed: Letters, longs: &[&str]) -> Outcome {
        let stray = w.present() & !allowed;
        if stray != 0 {
            let letter = b'A' + stray.trailing_zeros() as u8;
            let span = w.span(letter, self.block_span());
            let why = if letter == b'E' { "the feed of a corner is set in the cycle" } else { "remove the word" };
            let message = format!("{} has no place in this block of a contour", letter as char);
            return self.fail_help(codes::T1003, span, message, why);
        }
        if let Some(m) = w.m().first() {
            return self.fail(codes::T1003, m.span, "an M function has no place in a contour");
        }
        if let Some((addr, span)) = w.texts().first() {
            return self.fail(codes::T1003, *span, format!("{addr} has no place in a contour"));
        }
        for (addr, num) in w.longs() {
            if num.unknown || !longs.contains(&addr.to_string().as_str()) {
                return self.fail(codes::T1003, num.span, format!("{addr} is not supported in a contour"));
            }
        }
        for letter in b'A'..=b'Z' {
            let Some(num) = w.get(letter) else { continue };
            let relative = matches!(letter, b'X' | b'Z' | b'I' | b'K');
            if (num.incremental && !relative) || (num.unknown && !matches!(letter, b'X' | b'Z')) {
                return self.fail(codes::T1003, num.span, format!("{} takes a plain number here", letter as char));
            }
        }
        Ok(())
    }

    fn contour_start(&mut self, w: &Words, builder: &mut Builder) -> Outcome {
        self.only(w, letters("XZ"), &[])?;
        if builder.has_start() {
            return self.fail(codes::T3003, self.block_span(), "a contour starts once, with G0");
        }
        match (self.coord(w.get(b'X'), Axis::X), self.coord(w.get(b'Z'), Axis::Z)) {
            (Coord::At(x), Coord::At(z)) => {
                builder.start(Point2::new(z, x));
                Ok(())
            }
            _ => self.fail(codes::T1005, self.block_span(), "the start of a contour needs absolute X and Z"),
        }
    }

    fn element(&mut self, w: &Words, arc: Option<(bool, bool)>, mark: Mark, builder: &mut Builder) -> Outcome {
        let allowed = if arc.is_some() { ELEMENT & !letters("A") } else { ELEMENT & !letters("RIK") };
        self.only(w, allowed, if arc.is_some() { &["BR"] } else { &["AN", "BR"] })?;
        if let Some(num) = [w.get(b'I'), w.get(b'K')].into_iter().flatten().find(|num| num.incremental) {
            return self.fail(codes::T1003, num.span, "I and K take plain numbers here");
        }
        if !builder.has_start() {
            return self.fail_help(
                codes::T3003,
                self.block_span(),
                "the contour does not say where it starts",
                "program `G0 X… Z…` as the first element",
            );
        }
        let (partial, transition) = self.partial(w, arc)?;
        let pushed = builder.push(partial, Mark { transition, ..mark });
        self.checked(pushed)
    }

    fn checked(&self, result: Result<(), Flaw>) -> Outcome {
        result.map_err(|flaw| {
            self.flaw(&flaw);
            Reported
        })
    }

    // Blanks.

    fn bar(&mut self, w: &Words) -> Outcome {
        self.only(w, letters("XZKI"), &[])?;
        let span = self.block_span();
        let mm = self.st.mm();
        let diameter = self.needed(w, b'X', "the diameter of the bar", span)?;
        let diameter = self.above_zero(diameter, "the diameter of the bar")?;
        let length = self.needed(w, b'Z', "the length of the bar", span)?;
        let length = self.above_zero(length, "the length of the bar")?;
        let bore = w.value(b'I').unwrap_or(0.0) * mm;
        if bore < 0.0 || bore >= diameter {
            return self.fail(codes::T1007, w.span(b'I', span), "the bore of a tube is smaller than the tube");
        }
        let right = w.value(b'K').unwrap_or(0.0) * mm;
        self.geometry.blank = Some(Blank::Bar { radius: diameter / 2.0, length, right, bore: bore / 2.0 });
        Ok(())
    }

    fn casting(&mut self, w: &Words) -> Outcome {
        self.only(w, letters("PQ"), &[])?;
        let num = self.needed(w, b'P', "the oversize of the casting", self.block_span())?;
        let oversize = self.above_zero(num, "the oversize of the casting")?;
        let bore = self.choice(w, b'Q', 0, 1)? == 1;
        self.geometry.blank = Some(Blank::Casting { oversize, bore });
        Ok(())
    }

    // Forms.

    /// The last element, complete; forms belong to it.
    fn reference<'b>(&self, builder: &'b mut Builder, what: &str) -> Outcome<&'b mut super::contour::Piece> {
        let settled = builder.settle();
        self.checked(settled)?;
        match builder.pieces.last_mut() {
            Some(piece) => Ok(piece),
            None => {
                self.fail(codes::T3004, self.block_span(), format!("{what} stands behind an element of the contour"))
            }
        }
    }

    /// G22: a recess in a line parallel to an axis.
    fn standard_recess(&mut self, w: &Words, mark: Mark, builder: &mut Builder) -> Outcome {
        self.only(w, letters("XZIKBR"), &[])?;
        let span = self.block_span();
        let (in_face, start) = match (self.coord(w.get(b'X'), Axis::X), self.coord(w.get(b'Z'), Axis::Z)) {
            (Coord::Missing, Coord::At(z)) => (false, z),
            (Coord::At(x), Coord::Missing) => (true, x),
            _ => {
                return self.fail_help(
                    codes::T1005,
                    span,
                    "a recess names either X or Z, as an absolute value",
                    "program Z for a recess in a cylinder, X for one in a face",
                );
            }
        };
        let i = self.needed(w, b'I', "the floor of the recess, or its end in a face", span)?;
        let k = self.needed(w, b'K', "the end of the recess, or its floor in a face", span)?;
        let piece = self.reference(builder, "a recess")?;
        let line = piece.solved;
        let mm = self.st.mm();
        // An incremental I is the difference of two diameters, as far as any manual says.
        let radius = self.job.settings.control.turning.recess_depth == RecessDepth::Radius;
        let step = i.value * mm * if radius { 1.0 } else { 0.5 };
        let x = |base: f64| if i.incremental { base + step } else { i.value * mm * 0.5 };
        let z = |base: f64| if k.incremental { base + k.value * mm } else { k.value * mm };
        let top = self.transition(w)?;
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
    fn general_recess(&mut self, w: &Words, mark: Mark, builder: &mut Builder) -> Outcome {
        self.only(w, letters("HXZIKUABPR"), &[])?;
        let span = self.block_span();
        if let Some(num) = w.get(b'H').filter(|num| num.value != 0.0) {
            return self.fail_help(
                codes::T9007,
                num.span,
                "a relief turn: how it is measured is shown in a picture only",
                "describe the relief turn with G1 blocks",
            );
        }
        let lean = match w.get(b'A') {
            None => 0.0,
            Some(num) if (0.0..180.0).contains(&num.value) => {
                let (sin, cos) = Deg(num.value / 2.0).sin_cos();
                sin / cos
            }
            Some(num) => return self.fail(codes::T1007, num.span, "A lies between 0 and 180 degrees"),
        };
        let at = match (self.coord(w.get(b'X'), Axis::X), self.coord(w.get(b'Z'), Axis::Z)) {
            (Coord::At(x), Coord::Missing) => Along::X(x),
            (Coord::Missing, Coord::At(z)) => Along::Z(z),
            _ => {
                return self.fail(
                    codes::T1005,
                    span,
                    "the middle of the recess is missing: X in a face, Z in a cylinder",
                );
            }
        };
        let mm = self.st.mm();
        let width = self.needed(w, b'K', "the width of the recess", span)?;
        let width = self.above_zero(width, "the width of the recess")?;
        let piece = self.reference(builder, "a recess")?;
        let line = piece.solved;
        let depth = match (w.get(b'I'), w.get(b'U')) {
            (Some(i), None) if !i.incremental && i.value != 0.0 => i.value * mm,
            (None, Some(u)) if (line.to.y - line.from.y).abs() < 1e-9 => {
                // Right of the line lies towards the axis where it runs towards +Z.
                let down = line.from.y - u.value * mm * 0.5;
                if line.to.x > line.from.x { down } else { -down }
            }
            (None, Some(u)) => {
                return self.fail(codes::T3004, u.span, "U needs a line parallel to Z before the recess");
            }
            _ => return self.fail(codes::T1005, span, "the recess needs either its depth I or its floor U"),
        };
        let edge = |letter: u8| w.value(letter).map_or(Transition::Sharp, |b| transition_of(b * mm));
        let (near, far) = (edge(b'B'), edge(b'P'));
        let base = w.value(b'R').unwrap_or(0.0) * mm;
        // K counts at the reference element, as far as any text says; a picture may show the floor.
        let floor = self.job.settings.control.turning.recess_width == RecessWidth::Floor;
        let width = if floor { width + 2.0 * lean * depth.abs() } else { width };
        piece.recesses.push((Recess::Centered { at, width, lean, depth, near, far, base }, mark));
        piece.codes.0.push(CODE_OF_G23);
        Ok(())
    }

    /// G25: an undercut in the corner between the element before and the next one.
    fn undercut(&mut self, w: &Words, mark: Mark, builder: &mut Builder) -> Outcome {
        self.only(w, letters("HIKRPWA"), &["FP"])?;
        let span = self.block_span();
        let form = self.needed(w, b'H', "the form of the undercut", span)?;
        let piece = self.reference(builder, "an undercut")?;
        // The table goes by the diameter of the cylinder.
        let diameter = 2.0 * piece.solved.to.y;
        let undercut = self.undercut_of(w, form.value, diameter)?;
        piece.undercut = Some((undercut, mark));
        piece.codes.1 = code_of_undercut(form.value);
        Ok(())
    }

    fn undercut_of(&self, w: &Words, form: f64, diameter: f64) -> Outcome<Undercut> {
        let span = self.block_span();
        let mm = self.st.mm();
        let size = |letter: u8, default: f64| w.value(letter).map_or(default, |v| v * mm);
        let angle = |letter: u8, default: f64| w.value(letter).unwrap_or(default);
        let needed =
            |letter: u8, what: &str| self.needed(w, letter, what, span).and_then(|num| self.above_zero(num, what));
        let [depth, width, radius, face] = undercuts::din_509(diameter, false);
        Ok(match form as i32 {
            4 if form == 4.0 => Undercut::U {
                depth: needed(b'I', "the depth of the undercut")?,
                width: needed(b'K', "the width of the undercut")?,
                base: size(b'R', 0.0),
                edge: transition_of(size(b'P', 0.0)),
            },
            0 | 5 if form.fract() == 0.0 => Undercut::E {
                depth: size(b'I', depth),
                width: size(b'K', width),
                radius: size(b'R', radius),
                slope: angle(b'W', SLOPE_509),
            },
            6 if form == 6.0 => Undercut::F {
                depth: size(b'I', depth),
                width: size(b'K', width),
                radius: size(b'R', radius),
                slope: angle(b'W', SLOPE_509),
                face: size(b'P', face),
                lean: angle(b'A', LEAN_509),
            },
            7 if form == 7.0 => {
                let table = w.long("FP").and_then(|pitch| undercuts::din_76_external(pitch.value * mm));
                let value = |letter: u8, at: usize, what: &str| match (w.get(letter), table) {
                    (Some(num), _) => self.above_zero(num, what),
                    (None, Some(row)) => Ok(row[at]),
                    (None, None) => self.fail_help(
                        codes::T1005,
                        span,
                        format!("{} is missing: {what}", letter as char),
                        "give it, or the pitch FP of an external thread that is in the table of DIN 76",
                    ),
                };
                Undercut::E {
                    depth: value(b'I', 0, "the depth of the undercut")?,
                    width: value(b'K', 1, "the width of the undercut")?,
                    radius: value(b'R', 2, "the radius of the undercut")?,
                    slope: angle(b'W', SLOPE_76),
                }
            }
            8 | 9 if form.fract() == 0.0 => {
                return self.fail_help(
                    codes::T9007,
                    w.span(b'H', span),
                    "the undercuts H and K are shown in pictures only",
                    "describe the undercut with G1 and G2 blocks",
                );
            }
            _ => return self.fail(codes::T1007, w.span(b'H', span), format!("H{form} is no form of an undercut")),
        })
    }

    /// G34: the element before is a metric ISO thread.
    fn thread_mark(&mut self, w: &Words, builder: &mut Builder) -> Outcome {
        self.only(w, letters("F"), &[])?;
        let num = self.needed(w, b'F', "the pitch of the thread", self.block_span())?;
        let pitch = self.above_zero(num, "the pitch of the thread")?;
        self.reference(builder, "a thread")?.thread = Some(ThreadData { pitch, depth: ISO_DEPTH.map(|d| d * pitch) });
        Ok(())
    }

    /// G37: the element before is a thread of type Q with the pitch F; P is its depth.
    fn general_thread_mark(&mut self, w: &Words, builder: &mut Builder) -> Outcome {
        self.only(w, letters("QFPAWRKDHEV"), &[])?;
        let span = self.block_span();
        // Flank angles and the width of the crest are the tool's.
        for letter in [b'K', b'D', b'E', b'V'] {
            if let Some(num) = w.get(letter).filter(|num| num.value != 0.0) {
                let message = format!("{} of G37 is not supported", letter as char);
                return self.fail_help(codes::T9007, num.span, message, "program the thread with B, P, C and Q of G31");
            }
        }
        if let Some(num) = w.get(b'H').filter(|num| num.value > 1.0) {
            let message = "a thread with several starts is not supported";
            return self.fail_help(codes::T9007, num.span, message, "program G31 once for each start, with C");
        }
        let kind = self.choice(w, b'Q', 12, 14)?;
        let num = self.needed(w, b'F', "the pitch of the thread", span)?;
        let pitch = self.above_zero(num, "the pitch of the thread")?;
        let depth = match (w.get(b'P'), kind) {
            (Some(num), _) => [self.above_zero(num, "the depth of the thread")?; 2],
            (None, 1 | 2 | 13 | 14) => ISO_DEPTH.map(|d| d * pitch),
            (None, 9) => [0.640_33 * pitch; 2],
            (None, 11) => [0.640_327 * pitch; 2],
            _ => {
                return self.fail_help(
                    codes::T1005,
                    span,
                    format!("P is missing: the depth of a thread of type Q{kind}"),
                    "program P with the depth on the radius",
                );
            }
        };
        self.reference(builder, "a thread")?.thread = Some(ThreadData { pitch, depth });
        Ok(())
    }
}
