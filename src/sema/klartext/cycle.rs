//! CYCL DEF, CYCL CALL and the TRANS functions.
//!
//! A definition may go over several blocks (`7.0`, `7.1`, …) or lines; it acts when it is complete.
//! Source: reference sections 3, 4.4, 4.5.

use crate::diag::{Diagnostic, codes};
use crate::geo::Deg;
use crate::ir::{Function, Side};
use crate::lexer::klartext::{QKind, QRef, Value};
use crate::machine::{Axis, AxisSet, ShiftAxes};
use crate::parser::klartext::ast::{Addr, Block, CallKind, Stmt, Transform};
use crate::text::{Loc, Span};

use super::transform::Transformation;
use super::vars::Slot;
use super::words::Admits;
use super::{Here, Outcome, Reported, Run};

/// What is known of cycles: the definition under way and the one that calls run.
#[derive(Debug, Default)]
pub(super) struct Cycles {
    open: Option<Open>,
    defined: Option<Defined>,
    /// M89: every positioning block calls the cycle.
    modal: bool,
}

/// A definition that is being read.
#[derive(Debug)]
struct Open {
    number: u32,
    here: Here,
    /// Highest part read; `None` for a cycle with Q parameters.
    part: Option<u32>,
    axes: Vec<AxisValue>,
    /// Values without an axis, with the name in front of them in upper case.
    values: Vec<(String, f64)>,
    /// Q parameters by number.
    parameters: Vec<(u32, f64)>,
    table_row: bool,
    program: Option<String>,
    failed: bool,
}

#[derive(Debug, Clone, Copy)]
struct AxisValue {
    axis: Axis,
    incremental: bool,
    value: Option<f64>,
}

/// What CYCL CALL, M99 and M89 run.
#[derive(Debug, Clone)]
enum Defined {
    Program { name: String },
    Machining { number: u32, loc: Loc, refused: bool },
}

/// What a cycle is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Nature {
    DatumShift,
    Mirror,
    Dwell,
    Rotation,
    Scaling,
    ProgramCall,
    Orientation,
    Tilt,
    AxisScaling,
    Tolerance,
    Preset,
    /// Sets data that other cycles use.
    Data,
    /// Runs when called.
    Machining,
    /// Runs the machining cycle at once, at many places.
    Pattern,
    Unknown,
}

fn nature(number: u32) -> Nature {
    match number {
        7 => Nature::DatumShift,
        8 => Nature::Mirror,
        9 => Nature::Dwell,
        10 => Nature::Rotation,
        11 => Nature::Scaling,
        12 => Nature::ProgramCall,
        13 => Nature::Orientation,
        19 => Nature::Tilt,
        26 => Nature::AxisScaling,
        32 => Nature::Tolerance,
        247 => Nature::Preset,
        14 | 20 | 270 | 271 => Nature::Data,
        220 | 221 | 224 => Nature::Pattern,
        number if name(number).is_some() => Nature::Machining,
        _ => Nature::Unknown,
    }
}

/// Name of a cycle in the manuals.
fn name(number: u32) -> Option<&'static str> {
    Some(match number {
        1 => "PECKING",
        2 => "TAPPING",
        3 => "SLOT MILLING",
        4 => "POCKET MILLING",
        5 => "CIRCULAR POCKET",
        6 => "ROUGH-OUT",
        7 => "DATUM SHIFT",
        8 => "MIRROR IMAGE",
        9 => "DWELL TIME",
        10 => "ROTATION",
        11 => "SCALING",
        12 => "PGM CALL",
        13 => "ORIENTATION",
        14 => "CONTOUR GEOMETRY",
        15 => "PILOT DRILLING",
        16 => "CONTOUR MILLING",
        17 => "RIGID TAPPING",
        18 => "THREAD CUTTING",
        19 => "WORKING PLANE",
        20 => "CONTOUR DATA",
        21 => "PILOT DRILLING",
        22 => "ROUGH-OUT",
        23 => "FLOOR FINISHING",
        24 => "SIDE FINISHING",
        25 => "CONTOUR TRAIN",
        26 => "AXIS-SPECIFIC SCALING",
        27 => "CYLINDER SURFACE",
        28 => "CYLINDER SURFACE SLOT",
        29 => "CYLINDER SURFACE RIDGE",
        32 => "TOLERANCE",
        39 => "CYLINDER SURFACE CONTOUR",
        200 => "DRILLING",
        201 => "REAMING",
        202 => "BORING",
        203 => "UNIVERSAL DRILLING",
        204 => "BACK BORING",
        205 => "UNIVERSAL PECKING",
        206 => "TAPPING",
        207 => "RIGID TAPPING",
        208 => "BORE MILLING",
        209 => "TAPPING WITH CHIP BREAKING",
        210 => "SLOT RECIPROCATING",
        211 => "CIRCULAR SLOT",
        212 => "POCKET FINISHING",
        213 => "STUD FINISHING",
        214 => "CIRCULAR POCKET FINISHING",
        215 => "CIRCULAR STUD FINISHING",
        220 => "POLAR PATTERN",
        221 => "CARTESIAN PATTERN",
        224 => "DATA MATRIX PATTERN",
        225 => "ENGRAVING",
        230 => "MULTIPASS MILLING",
        231 => "RULED SURFACE",
        232 | 233 => "FACE MILLING",
        240 => "CENTERING",
        241 => "SINGLE-LIP DEEP-HOLE DRILLING",
        247 => "DATUM SETTING",
        251 => "RECTANGULAR POCKET",
        252 => "CIRCULAR POCKET",
        253 => "SLOT MILLING",
        254 => "CIRCULAR SLOT",
        256 => "RECTANGULAR STUD",
        257 => "CIRCULAR STUD",
        258 => "POLYGON STUD",
        262 => "THREAD MILLING",
        263 => "THREAD MILLING AND COUNTERSINKING",
        264 => "THREAD DRILLING AND MILLING",
        265 => "HELICAL THREAD DRILLING AND MILLING",
        267 => "OUTSIDE THREAD MILLING",
        270 => "CONTOUR TRAIN DATA",
        271 => "OCM CONTOUR DATA",
        272..=277 => "OCM cycle",
        285..=288 | 880 => "gear cycle",
        290..=292 => "interpolation turning",
        800..=879 | 882 | 883 | 892 => "turning cycle",
        1000..=1030 => "grinding cycle",
        1271..=1278 => "OCM figure",
        _ => return None,
    })
}

impl Cycles {
    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    pub fn modal(&self) -> bool {
        self.modal
    }

    pub fn set_modal(&mut self, on: bool) {
        self.modal = on;
    }
}

impl Run<'_> {
    /// Does the block go on with the definition that is open?
    pub(super) fn continues_cycle(&self, block: &Block) -> bool {
        let Some(open) = &self.cycles.open else { return false };
        match block.stmt {
            Stmt::Cycle { number, part: Some(part) } => number == open.number && part > 0 && open.part.is_some(),
            // A line of parameters without a continuation mark in front of it.
            Stmt::Assign(q) => block.number.is_none() && open.part.is_none() && is_parameter_of(open.number, q),
            _ => false,
        }
    }

    /// A formula block turned out to be a line of the open definition.
    pub(super) fn note_cycle_parameter(&mut self, q: QRef, value: f64, _span: Span) {
        if let Some(open) = &mut self.cycles.open
            && open.part.is_none()
            && is_parameter_of(open.number, q)
        {
            open.parameters.push((q.number, value));
        }
    }

    pub(super) fn cycle_block(&mut self, number: u32, part: Option<u32>, block: &Block, text: &[u8]) -> Outcome {
        match part {
            None | Some(0) => {
                self.cycles.open = Some(Open {
                    number,
                    here: self.here,
                    part,
                    axes: Vec::new(),
                    values: Vec::new(),
                    parameters: Vec::new(),
                    table_row: false,
                    program: None,
                    failed: false,
                });
            }
            Some(part) => match &mut self.cycles.open {
                Some(open) if open.number == number && open.part.is_some_and(|last| last < part) => {
                    open.part = Some(part);
                    // The effect belongs to the last block of the definition.
                    open.here = self.here;
                }
                _ => {
                    return self.fail_help(
                        codes::K2402,
                        block.span,
                        format!("part {number}.{part} does not follow its cycle"),
                        &format!("the definition begins with `CYCL DEF {number}.0`"),
                    );
                }
            },
        }
        let result = self.cycle_words(block, text);
        if let (Err(_), Some(open)) = (&result, &mut self.cycles.open) {
            open.failed = true;
        }
        result
    }

    /// Names in cycles are decoration in any language; values and axes count.
    fn cycle_words(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let mm = self.level().unit.mm();
        let mut label = String::new();
        let mut hash = false;
        for &word in &block.words {
            match word.addr {
                Addr::Axis { axis, incremental } => {
                    let value = self.number_if(word.value, word.span)?;
                    self.open_cycle().axes.push(AxisValue { axis, incremental, value });
                }
                Addr::Name => label = String::from_utf8_lossy(word.span.of(text)).to_ascii_uppercase(),
                Addr::Hash => hash = true,
                Addr::Value => {
                    let value = self.number(word.value, word.span)?;
                    let open = self.open_cycle();
                    open.table_row |= hash;
                    open.values.push((std::mem::take(&mut label), value));
                }
                Addr::Assign(q) => {
                    let value = match word.value {
                        // FMAX, FAUTO, PREDEF: of use to machining cycles only.
                        Value::None | Value::FeedMax | Value::FeedAuto => continue,
                        value => self.number(value, word.span)?,
                    };
                    self.set(q, Slot::Number(value), word.span)?;
                    if q.kind == QKind::Q {
                        self.open_cycle().parameters.push((q.number, value));
                    }
                }
                Addr::Text => {
                    let name = self.program_name(strip_pgm(word.span.of(text)))?;
                    self.open_cycle().program = Some(name);
                }
                // F, DR, R, S, T of old machining cycles; cycle 19 has F and DIST.
                _ => {}
            }
        }
        let _ = mm;
        Ok(())
    }

    fn open_cycle(&mut self) -> &mut Open {
        self.cycles.open.as_mut().expect("called while a definition is open")
    }

    /// The definition that was open is complete: it acts.
    pub(super) fn finish_cycle(&mut self) {
        let Some(open) = self.cycles.open.take() else { return };
        let here = std::mem::replace(&mut self.here, open.here);
        if open.failed {
            self.st.lose(AxisSet::MAIN);
        } else if self.apply_cycle(&open).is_err() && nature(open.number) != Nature::Machining {
            self.st.lose(AxisSet::MAIN);
        }
        self.here = here;
    }

    fn apply_cycle(&mut self, open: &Open) -> Outcome {
        let nature = nature(open.number);
        let dotted = !matches!(nature, Nature::Preset | Nature::Pattern | Nature::Data | Nature::Unknown)
            && !(nature == Nature::Machining && open.number >= 20);
        if dotted && open.part.unwrap_or(0) == 0 {
            self.error(codes::K2402, format!("cycle {} lacks its part {}.1", open.number, open.number));
            return Err(Reported);
        }
        match nature {
            Nature::DatumShift => self.shift_cycle(open),
            Nature::Mirror => {
                let axes = open.axes.iter().map(|axis| axis.axis).collect();
                self.mirror(axes)
            }
            Nature::Dwell => {
                let seconds = self.single_value(open)?;
                if !(0.0..=3600.0).contains(&seconds) {
                    self.error(codes::K2403, format!("a dwell of {seconds} s is out of range"));
                    return Err(Reported);
                }
                self.function(Function::Dwell(seconds));
                Ok(())
            }
            Nature::Rotation => {
                let angle = self.single_value(open)?;
                let incremental = open.values.iter().any(|(label, _)| label == "IROT");
                self.rotate(angle, incremental)
            }
            Nature::Scaling => {
                let factor = self.single_value(open)?;
                self.scale(factor)
            }
            Nature::AxisScaling => self.scale_axes(open),
            Nature::ProgramCall => match open.program.clone() {
                Some(name) => {
                    self.cycles.defined = Some(Defined::Program { name });
                    Ok(())
                }
                None => {
                    self.error(codes::K2402, "cycle 12 names no program");
                    Err(Reported)
                }
            },
            Nature::Orientation => {
                self.st.orientation = Some(self.single_value(open)?);
                Ok(())
            }
            Nature::Tilt => self.tilt(open),
            Nature::Tolerance => {
                self.job.diags.push_once(Diagnostic::new(
                    codes::K2703,
                    self.here.origin.loc,
                    "the path tolerance of cycle 32 has no word in the output",
                ));
                Ok(())
            }
            Nature::Preset => self.preset(open),
            Nature::Data => Ok(()),
            Nature::Machining => {
                let loc = self.here.origin.loc;
                self.cycles.defined = Some(Defined::Machining { number: open.number, loc, refused: false });
                self.cycles.modal = false;
                Ok(())
            }
            Nature::Pattern => {
                let what = name(open.number).unwrap_or_default();
                if self.cycles.defined.is_none() {
                    self.error(codes::K2401, format!("cycle {} {what} runs a machining cycle, and none is defined", open.number));
                } else {
                    self.error(codes::K9001, format!("cycle {} {what} is not supported yet", open.number));
                }
                Err(Reported)
            }
            Nature::Unknown => {
                self.error(codes::K9001, format!("cycle {} is not known", open.number));
                Err(Reported)
            }
        }
    }

    fn single_value(&mut self, open: &Open) -> Outcome<f64> {
        match open.values.as_slice() {
            [(_, value)] => Ok(*value),
            [] => {
                self.error(codes::K2402, format!("cycle {} lacks its value", open.number));
                Err(Reported)
            }
            _ => {
                self.error(codes::K2402, format!("cycle {} has more than one value", open.number));
                Err(Reported)
            }
        }
    }

    // Transformations.

    /// Puts a new transformation in force; the tool stays where it is.
    pub(super) fn set_transformation(&mut self, transform: Transformation) -> Outcome {
        self.st.transform = transform;
        let span = self.block_span();
        self.update_frame(span)
    }

    /// Makes the frame follow the transformation and the length oversize.
    pub(super) fn update_frame(&mut self, span: Span) -> Outcome {
        use crate::ir::contour::Ctx;
        let lift = self.st.tool.as_ref().map_or(0.0, |tool| tool.call_deltas[0]);
        let axis = self.st.axis();
        let Some(frame) = self.st.transform.frame(axis, lift) else {
            return self.fail(codes::K2403, span, "the transformations together have no result");
        };
        let plane = self.st.plane();
        if frame == self.st.ctx.frame && plane == self.st.ctx.plane {
            return Ok(());
        }
        if lift != 0.0 {
            self.job.diags.push_once(Diagnostic::new(
                codes::K2011,
                self.here.origin.loc,
                format!("the length oversize DL {lift} mm is added to {}", axis.letter()),
            ));
        }
        if frame != self.st.ctx.frame {
            let at = self.st.ctx.frame.apply(&self.st.pos);
            self.st.pos = frame.unapply(&at);
            self.st.polar = None;
            self.st.system += 1;
        }
        self.st.ctx = std::rc::Rc::new(Ctx { plane, frame });
        Ok(())
    }

    fn shift_cycle(&mut self, open: &Open) -> Outcome {
        if open.table_row {
            self.error(codes::K9012, "a datum shift from a table needs the table of the control");
            return Err(Reported);
        }
        if open.axes.is_empty() {
            self.error(codes::K2402, "cycle 7 names no axis");
            return Err(Reported);
        }
        self.shift(&open.axes)
    }

    /// Datum shift: axes that are not named keep theirs.
    fn shift(&mut self, axes: &[AxisValue]) -> Outcome {
        let mm = self.level().unit.mm();
        let mut next = self.st.transform.clone();
        for axis in axes {
            let Some(value) = axis.value else {
                self.error(codes::K2402, format!("the shift of {} lacks its value", axis.axis.letter()));
                return Err(Reported);
            };
            let value = if axis.axis.is_rotary() { value } else { value * mm };
            let shift = &mut next.shift[axis.axis.index()];
            *shift = if axis.incremental { *shift + value } else { value };
        }
        let now = &self.st.transform;
        let changes = AxisSet::MAIN.iter().any(|axis| now.shift[axis.index()] != next.shift[axis.index()]);
        let clears = AxisSet::MAIN.iter().all(|axis| next.shift[axis.index()] == 0.0);
        if changes && !clears && !now.is_shift_only() {
            match self.job.settings.control.shift_axes {
                ShiftAxes::Original => self.report(
                    Diagnostic::new(
                        codes::K2501,
                        self.here.origin.loc,
                        "the datum shift is measured along the original axes, although they are turned, mirrored or scaled",
                    )
                    .help("reset the other transformations first, or set `[control] shift_axes`"),
                ),
                ShiftAxes::Transformed => turn_shift(&mut next),
            }
        }
        self.set_transformation(next)
    }

    fn mirror(&mut self, axes: AxisSet) -> Outcome {
        if !axes.without(AxisSet::MAIN).is_empty() {
            self.error(codes::K2403, "only X, Y and Z can be mirrored");
            return Err(Reported);
        }
        if axes.contains(self.st.axis()) {
            let axis = self.st.axis().letter();
            self.report(
                Diagnostic::new(codes::K2503, self.here.origin.loc, format!("the tool axis {axis} is mirrored"))
                    .help("check that this is meant"),
            );
        }
        let mut next = self.st.transform.clone();
        next.mirror = axes;
        self.set_transformation(next)
    }

    fn rotate(&mut self, angle: f64, incremental: bool) -> Outcome {
        if self.st.side != Side::None {
            self.report(
                Diagnostic::new(codes::K2603, self.here.origin.loc, "the rotation ends the radius compensation")
                    .help("program a block with R0 first"),
            );
            self.st.side = Side::None;
        }
        let mut next = self.st.transform.clone();
        next.angle = Deg(if incremental { next.angle.0 + angle } else { angle });
        if next.angle.normal().0 == 0.0 {
            next.angle = Deg(0.0);
        }
        next.plane = self.st.plane();
        self.set_transformation(next)
    }

    fn check_factor(&mut self, factor: f64) -> Outcome {
        if (0.000_001..=99.999_999).contains(&factor) {
            return Ok(());
        }
        self.error(codes::K2403, format!("a scaling factor of {factor} is out of range (0.000001 to 99.999999)"));
        Err(Reported)
    }

    fn scale(&mut self, factor: f64) -> Outcome {
        self.check_factor(factor)?;
        let in_plane = self.job.settings.control.scaling_in_plane;
        if factor != 1.0 && !in_plane {
            self.job.diags.push_once(
                Diagnostic::new(codes::K2507, self.here.origin.loc, "the scaling acts on the tool axis, too")
                    .help("if MP 7410 limits it to the plane, set `[control] scaling = \"plane\"`"),
            );
        }
        let mut next = self.st.transform.clone();
        next.scale = factor;
        next.unscaled = in_plane.then_some(self.st.axis());
        self.set_transformation(next)
    }

    /// Cycle 26.
    fn scale_axes(&mut self, open: &Open) -> Outcome {
        let mm = self.level().unit.mm();
        let mut next = self.st.transform.clone();
        for axis in &open.axes {
            let (true, Some(factor)) = (axis.axis.is_main(), axis.value) else {
                self.error(codes::K2403, format!("{} cannot be scaled", axis.axis.letter()));
                return Err(Reported);
            };
            self.check_factor(factor)?;
            next.axis_scale[axis.axis.index()] = factor;
        }
        next.scale_center = [0.0; 3];
        for (label, value) in &open.values {
            let axis = match label.as_str() {
                "CCX" => 0,
                "CCY" => 1,
                "CCZ" => 2,
                _ => {
                    self.error(codes::K2402, format!("`{label}` is no word of cycle 26"));
                    return Err(Reported);
                }
            };
            next.scale_center[axis] = value * mm;
        }
        self.set_transformation(next)
    }

    /// Cycle 19: only its reset can be compiled.
    fn tilt(&mut self, open: &Open) -> Outcome {
        if open.axes.iter().all(|axis| axis.value.unwrap_or(0.0) == 0.0) {
            for number in 120..=122 {
                self.set_control_parameter(number, 0.0);
            }
            return Ok(());
        }
        self.error(codes::K9004, "cycle 19 tilts the working plane, which cannot be compiled for three axes");
        Err(Reported)
    }

    /// Cycle 247: a row of the preset table becomes a work offset.
    fn preset(&mut self, open: &Open) -> Outcome {
        let Some(&(_, number)) = open.parameters.iter().find(|(q, _)| *q == 339) else {
            self.error(codes::K2402, "cycle 247 lacks the preset number Q339");
            return Err(Reported);
        };
        let row = (number >= 0.0 && number.fract() == 0.0).then_some(number as u32);
        let configured = row.and_then(|row| self.job.settings.datums.presets.get(&row).copied());
        let offset = configured.or(row.filter(|row| (1..=9).contains(row)).map(|row| row as u8));
        let Some(offset) = offset else {
            self.report(
                Diagnostic::new(codes::K2505, self.here.origin.loc, format!("preset {number} has no work offset"))
                    .help(format!("name one in partc.toml: `[datums]` with `preset.{number} = \"G54\"`")),
            );
            return Err(Reported);
        };
        if configured.is_none() {
            self.report(Diagnostic::new(
                codes::K2504,
                self.here.origin.loc,
                format!("preset {number} is printed as work offset {offset} ({})", offset_word(offset)),
            ));
        }
        self.function(Function::WorkOffset(offset));
        self.set_transformation(Transformation::default())?;
        // In the new system no axis has a known position.
        self.st.pos = crate::ir::Pos::UNKNOWN;
        self.st.lost = AxisSet::EMPTY;
        self.st.polar = None;
        self.st.system += 1;
        Ok(())
    }

    /// TRANS DATUM, TRANS MIRROR, TRANS ROTATION, TRANS SCALE.
    pub(super) fn transform_block(&mut self, kind: Transform, block: &Block, text: &[u8]) -> Outcome {
        let mut axes = Vec::new();
        let mut value = None;
        let mut incremental = false;
        let mut label = Vec::new();
        for &word in &block.words {
            match word.addr {
                Addr::Name => {
                    let name = word.span.of(text).to_ascii_uppercase();
                    match name.as_slice() {
                        b"RESET" => return self.reset_transform(kind),
                        b"TABLE" | b"TABLINE" => {
                            return self.fail(codes::K9012, word.span, "datum tables are not supported");
                        }
                        _ => label = name,
                    }
                }
                Addr::Axis { axis, incremental } => {
                    let value = self.number_if(word.value, word.span)?;
                    axes.push(AxisValue { axis, incremental, value });
                }
                Addr::Value => {
                    incremental = label == b"IROT";
                    value = Some(self.number(word.value, word.span)?);
                }
                _ => return self.not_admitted(word, "TRANS"),
            }
        }
        match (kind, value) {
            (Transform::Datum, None) if !axes.is_empty() => self.shift(&axes),
            (Transform::Mirror, None) if !axes.is_empty() => self.mirror(axes.iter().map(|axis| axis.axis).collect()),
            (Transform::Rotation, Some(angle)) => self.rotate(angle, incremental),
            (Transform::Scale, Some(factor)) => self.scale(factor),
            _ => self.fail(codes::K2402, block.span, "this TRANS block lacks its values"),
        }
    }

    fn reset_transform(&mut self, kind: Transform) -> Outcome {
        let mut next = self.st.transform.clone();
        let none = Transformation::default();
        match kind {
            Transform::Datum => next.shift = none.shift,
            Transform::Mirror => next.mirror = none.mirror,
            Transform::Rotation => next.angle = none.angle,
            Transform::Scale => {
                next.scale = none.scale;
                next.unscaled = none.unscaled;
            }
        }
        self.set_transformation(next)
    }

    // Calls.

    pub(super) fn cycle_call(&mut self, kind: CallKind, block: &Block, text: &[u8]) -> Outcome {
        let first = block.words.first().filter(|word| word.addr == Addr::Name);
        let kind = match first.map(|word| word.span.of(text).to_ascii_uppercase()).as_deref() {
            Some(b"POS") => CallKind::At,
            Some(b"PAT") => CallKind::Pattern,
            _ => kind,
        };
        match kind {
            CallKind::Here => {
                let w = self.gather(block, "CYCL CALL", Admits::M.and(Admits::FEED))?;
                self.check_m(&w)?;
                self.m_at_start(&w, false)?;
                self.call_cycle()?;
                self.m_at_end(&w)
            }
            CallKind::At => self.call_cycle(),
            CallKind::Pattern => {
                self.error(codes::K9010, "CYCL CALL PAT is not supported yet");
                Err(Reported)
            }
        }
    }

    /// Runs the cycle defined last.
    pub(super) fn call_cycle(&mut self) -> Outcome {
        let here = self.here.origin.loc;
        match &mut self.cycles.defined {
            None => {
                self.error(codes::K2401, "no cycle is defined");
                Err(Reported)
            }
            Some(Defined::Program { name, .. }) => {
                let name = name.clone();
                self.call_program_named(&name)
            }
            Some(Defined::Machining { number, loc, refused }) => {
                let (number, loc, again) = (*number, *loc, std::mem::replace(refused, true));
                if !again {
                    let what = name(number).unwrap_or_default();
                    self.report(
                        Diagnostic::new(codes::K9001, here, format!("cycle {number} {what} is not supported yet"))
                            .here("called here")
                            .also(loc, "defined here"),
                    );
                }
                let axis = self.st.axis();
                self.st.lose(AxisSet::of(axis));
                self.lost();
                Err(Reported)
            }
        }
    }
}

/// A shift measured along the turned and mirrored axes.
fn turn_shift(next: &mut Transformation) {
    let unscaled = Transformation { scale: 1.0, axis_scale: [1.0; 3], ..next.clone() };
    let v = unscaled.linear() * nalgebra::Vector3::new(next.shift[0], next.shift[1], next.shift[2]);
    next.shift[..3].copy_from_slice(v.as_slice());
}

/// Is `q` a parameter that a definition of this cycle may set?
fn is_parameter_of(cycle: u32, q: QRef) -> bool {
    q.kind == QKind::Q && (matches!(q.number, 200..=1199) || (matches!(cycle, 20..=29) && q.number <= 21))
}

/// `PGM LOT31` without its keyword.
fn strip_pgm(text: &[u8]) -> &[u8] {
    match text.get(..3) {
        Some(head) if head.eq_ignore_ascii_case(b"PGM") => text[3..].trim_ascii(),
        _ => text,
    }
}

fn offset_word(offset: u8) -> &'static str {
    ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"].get(offset as usize - 1).unwrap_or(&"G54")
}
