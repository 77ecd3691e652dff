//! From the arguments of CYCLE940, CYCLE94 and CYCLE96 to the undercut cycle.
//!
//! In: arguments as written, X values as diameters. Out: the cycle with resolved sizes, and what it rests on besides
//! confirmed facts. Source: SINUMERIK NC programming 12/2019, 3.25; 840D sl turning 06/2019, p. 416.

use crate::geo::undercut::{Allowance, Orientation, Shape};
use crate::geo::{Deg, Point2};
use crate::ir::Feed;
use crate::ir::cycle::UndercutCycle;
use crate::ir::cycle::roughing::Nose;
use crate::ir::cycle::undercut::Leave;
use crate::ir::undercut::{Doubts, Surface, ThreadForm, form_e, form_f, thread, usual_pitch};
use crate::machine::Undercuts;
use crate::standard::din13::{CORE, coarse_pitch};
use crate::standard::din509;

use super::super::undercut_sizes::cycle_size;

/// Pitches in the order of the cycle's list, `_PITI` 0 to 23.
const PITCHES: [f64; 24] = [
    0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.6, 0.7, 0.75, 0.8, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0,
    5.5, 6.0,
];

/// The pitch that belongs to a diameter as a rule, and its index in the cycle's list.
pub(super) fn proposed_index(tables: &Undercuts, surface: Surface, diameter: f64) -> Option<(f64, usize)> {
    let pitch = usual_pitch(tables, surface, diameter)?;
    PITCHES.iter().position(|known| *known == pitch).map(|at| (pitch, at))
}

/// The size of DIN 509 that belongs to a diameter as a rule, and its index in the cycle's list.
pub(super) fn proposed_size(tables: &Undercuts, diameter: f64) -> Option<([f64; 2], u32)> {
    let (_, size) = tables.size_for(diameter, din509::NORMAL)?;
    let at = (0..PITCHES.len() as u32).find(|at| cycle_size(tables, *at).is_some_and(|(known, _)| known == size))?;
    Some(([size.radius, size.depth], at))
}

/// Arguments of CYCLE940; `None` for an empty one. `_PTAB`, `_PTABA` and `_DMODE` say nothing about the path.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Cycle940 {
    /// Corner: diameter and Z.
    pub spd: Option<f64>,
    pub spl: Option<f64>,
    /// Letter of the form.
    pub form: Option<u8>,
    pub lage: Option<f64>,
    pub sdis: Option<f64>,
    /// Feed per revolution.
    pub ffp: Option<f64>,
    pub vari: Option<f64>,
    pub epd: Option<f64>,
    pub epl: Option<f64>,
    pub r1: Option<f64>,
    pub r2: Option<f64>,
    pub sta: Option<f64>,
    pub vrt: Option<f64>,
    pub mid: Option<f64>,
    pub fal: Option<f64>,
    pub falx: Option<f64>,
    pub falz: Option<f64>,
    pub piti: Option<f64>,
    pub amode: Option<f64>,
}

/// Arguments of CYCLE94 (finished diameter) and CYCLE96 (nominal thread diameter), with the state the old cycles take.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Classic {
    pub diameter: f64,
    pub spl: f64,
    pub form: u8,
    /// `_VARI`, or the cutting edge position of the tool where it is 0 or missing: 1 to 4.
    pub position: u8,
    pub feed: Feed,
    /// Distance to the part at rapid; the old cycles have none of their own.
    pub clearance: f64,
}

/// What the cycle rests on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Rests {
    pub thread: Doubts,
    /// A size index other than 0.
    pub size_index: bool,
    /// The size for the diameter; DIN 509 names two.
    pub size_by_diameter: bool,
    /// Roughing: controls do not publish their cuts.
    pub roughing: bool,
    /// The corner geometry of the free form, or the position number of the old cycles.
    pub convention: bool,
    /// An allowance along X, as a radius.
    pub allowance_along_x: bool,
    /// The allowance that is not the one chosen by the thousands of `_AMODE`.
    pub other_allowance: bool,
}

/// An argument that makes no undercut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum CallFault {
    /// The argument with this name is missing.
    Missing(&'static str),
    /// The argument with this name is out of range.
    Range(&'static str),
    /// No such form (alarm 61609).
    Form,
    /// No such position (alarm 61613).
    Position,
    /// The diameter is under 3 mm, or no metric thread has it (alarm 61601).
    Diameter,
    /// The size or pitch is not in the table.
    Size,
    /// No pitch is given; the index of the pitch that belongs to a diameter is [`proposed_index`].
    Pitch,
    /// No size of DIN 509 is given; the index of the one that belongs to a diameter is [`proposed_size`].
    SizeMissing,
    /// An allowance on all sides beside one along an axis: the control takes either.
    BothAllowances,
}

/// The undercut cycle of CYCLE940.
///
/// # Errors
/// See [`CallFault`].
pub(super) fn cycle940(call: &Cycle940, tables: &Undercuts) -> Result<(UndercutCycle, Rests), CallFault> {
    let need = |value: Option<f64>, name| value.ok_or(CallFault::Missing(name));
    let (spd, spl) = (need(call.spd, "_SPD")?, need(call.spl, "_SPL")?);
    let form = call.form.ok_or(CallFault::Missing("_FORM"))?.to_ascii_uppercase();
    let orientation = position940(need(call.lage, "_LAGE")?).ok_or(CallFault::Position)?;
    let clearance = call.sdis.filter(|v| *v > 0.0).ok_or(CallFault::Range("_SDIS"))?;
    let feed = call.ffp.filter(|v| *v > 0.0).ok_or(CallFault::Range("_FFP"))?;
    let mut rests = Rests::default();
    let mode = digits(call.amode.unwrap_or(0.0)).ok_or(CallFault::Range("_AMODE"))?;
    let incremental = |place: usize| mode.get(place) == Some(&1);
    let mut cycle = UndercutCycle {
        corner: Point2::new(spl, spd / 2.0),
        orientation,
        shape: shape940(call, form, orientation, [incremental(0), incremental(1)], tables, &mut rests)?,
        allowance: Allowance::default(),
        clearance,
        face_end: call.vrt.filter(|v| *v != 0.0).map(|v| v / 2.0),
        feed: Feed::PerRevolution(feed),
        step: None,
        leave: Leave::NOTHING,
        finishing: true,
        compensated: false,
        nose: Nose::default(),
    };
    match form {
        b'E' | b'F' => {
            // 0 is no allowance, also where the value is absolute.
            let given = |v: Option<f64>| v.filter(|v| *v != 0.0);
            if let Some(x) = given(call.epd) {
                cycle.allowance.reference = if incremental(0) { x.abs() } else { (x - spd).abs() / 2.0 };
            }
            if let (b'F', Some(z)) = (form, given(call.epl)) {
                cycle.allowance.other = if incremental(1) { z.abs() } else { (z - spl) * orientation.first };
                if cycle.allowance.other < 0.0 {
                    return Err(CallFault::Range("_EPL"));
                }
            }
        }
        _ => roughing(call, &mut cycle, &mut rests)?,
    }
    Ok((cycle, rests))
}

fn roughing(call: &Cycle940, cycle: &mut UndercutCycle, rests: &mut Rests) -> Result<(), CallFault> {
    let vari = digits(call.vari.unwrap_or(2.0)).ok_or(CallFault::Range("_VARI"))?;
    let (rough, finish) = match vari.first() {
        Some(1) => (true, false),
        Some(2) => (false, true),
        Some(3) => (true, true),
        _ => return Err(CallFault::Range("_VARI")),
    };
    cycle.finishing = finish;
    if rough {
        rests.roughing = true;
        cycle.step = Some(call.mid.filter(|v| *v > 0.0).ok_or(CallFault::Range("_MID"))?);
        cycle.leave = leave(call, rests)?;
    }
    Ok(())
}

/// What roughing leaves: on all sides, or along the axes.
fn leave(call: &Cycle940, rests: &mut Rests) -> Result<Leave, CallFault> {
    let (all, x, z) = (call.fal.unwrap_or(0.0), call.falx.unwrap_or(0.0), call.falz.unwrap_or(0.0));
    for (value, name) in [(all, "_FAL"), (x, "_FALX"), (z, "_FALZ")] {
        if value < 0.0 {
            return Err(CallFault::Range(name));
        }
    }
    let along = x != 0.0 || z != 0.0;
    if all != 0.0 && along {
        return Err(CallFault::BothAllowances);
    }
    // 1 in both stored calls, which have the one on all sides.
    let chosen = call.amode.and_then(digits).is_some_and(|mode| mode.get(3) == Some(&1));
    if chosen && along || !chosen && all != 0.0 {
        rests.other_allowance = true;
    }
    rests.allowance_along_x = x != 0.0;
    Ok(if along { Leave::Along { z, x } } else { Leave::Around(all) })
}

fn shape940(
    call: &Cycle940,
    form: u8,
    side: Orientation,
    [depth_incremental, width_incremental]: [bool; 2],
    tables: &Undercuts,
    rests: &mut Rests,
) -> Result<Shape, CallFault> {
    let index = || {
        let index = call.piti.unwrap_or(0.0);
        ((0.0..1000.0).contains(&index) && index == libm::floor(index)).then_some(index as usize)
    };
    match form {
        b'E' | b'F' => {
            if call.piti.is_none() {
                return Err(CallFault::SizeMissing);
            }
            let index = index().ok_or(CallFault::Range("_PITI"))?;
            let place = u32::try_from(index).ok().and_then(|index| cycle_size(tables, index));
            let (size, sure) = place.ok_or(CallFault::Size)?;
            rests.size_index = !sure;
            Ok(if form == b'E' { form_e(size) } else { form_f(size) })
        }
        b'A'..=b'D' => {
            let entry = entry(call.sta)?;
            if call.piti.is_none() {
                return Err(CallFault::Pitch);
            }
            let pitch = PITCHES.get(index().ok_or(CallFault::Range("_PITI"))?).ok_or(CallFault::Size)?;
            let row = tables.thread(*pitch).ok_or(CallFault::Size)?;
            let (shape, doubts) = thread(tables, row, thread_form(form)?, entry);
            rests.thread = doubts;
            Ok(shape)
        }
        b'T' => {
            rests.convention = true;
            let spd = call.spd.unwrap_or(0.0);
            let (Some(x), Some(z)) = (call.epd, call.epl) else { return Err(CallFault::Missing("_EPD and _EPL")) };
            // Absolute values lie in the material of the cylinder, and along it.
            let depth = if depth_incremental { x.abs() } else { (spd - x) * side.second / 2.0 };
            if depth <= 0.0 {
                return Err(CallFault::Range("_EPD"));
            }
            let length = if width_incremental { z.abs() } else { (z - call.spl.unwrap_or(0.0)) * side.first };
            if length <= 0.0 {
                return Err(CallFault::Range("_EPL"));
            }
            Ok(Shape::Square {
                length,
                depth,
                entry: entry(call.sta)?,
                entry_radius: call.r1.unwrap_or(0.0),
                corner_radius: call.r2.unwrap_or(0.0),
            })
        }
        _ => Err(CallFault::Form),
    }
}

/// Entry angle, 30 to 90 degrees.
fn entry(angle: Option<f64>) -> Result<Deg, CallFault> {
    match angle.ok_or(CallFault::Missing("_STA"))? {
        angle if (30.0..=90.0).contains(&angle) => Ok(Deg(angle)),
        _ => Err(CallFault::Range("_STA")),
    }
}

fn thread_form(letter: u8) -> Result<ThreadForm, CallFault> {
    match letter {
        b'A' => Ok(ThreadForm::A),
        b'B' => Ok(ThreadForm::B),
        b'C' => Ok(ThreadForm::C),
        b'D' => Ok(ThreadForm::D),
        _ => Err(CallFault::Form),
    }
}

/// `_LAGE`: 0 external +Z, 1 external -Z, 2 internal +Z, 3 internal -Z.
fn position940(lage: f64) -> Option<Orientation> {
    let (first, second) = match lage {
        0.0 => (-1.0, 1.0),
        1.0 => (1.0, 1.0),
        2.0 => (-1.0, -1.0),
        3.0 => (1.0, -1.0),
        _ => return None,
    };
    Some(Orientation { first, second, first_leads: true })
}

/// The numbers of the old cycles are those of the cutting edge: 3 external -Z, 4 external +Z, 2 internal -Z, 1
/// internal +Z.
fn position_classic(position: u8) -> Result<Orientation, CallFault> {
    let lage = match position {
        3 => 1.0,
        4 => 0.0,
        2 => 3.0,
        1 => 2.0,
        _ => return Err(CallFault::Position),
    };
    position940(lage).ok_or(CallFault::Position)
}

/// Decimal digits from the right; at least eight.
fn digits(value: f64) -> Option<[u8; 8]> {
    if !(0.0..1e8).contains(&value) || value != libm::floor(value) {
        return None;
    }
    let mut rest = value as u64;
    Some([0; 8].map(|_: u8| {
        let digit = (rest % 10) as u8;
        rest /= 10;
        digit
    }))
}

/// The undercut cycle of CYCLE94: form E or F, its size from the finished diameter.
///
/// # Errors
/// `Form`, `Position`, `Diameter`, `Size`.
pub(super) fn cycle94(call: &Classic, tables: &Undercuts) -> Result<(UndercutCycle, Rests), CallFault> {
    let form = call.form.to_ascii_uppercase();
    if !matches!(form, b'E' | b'F') {
        return Err(CallFault::Form);
    }
    if call.diameter.is_nan() || call.diameter < 3.0 {
        return Err(CallFault::Diameter);
    }
    let (_, size) = tables.size_for(call.diameter, din509::NORMAL).ok_or(CallFault::Size)?;
    let shape = if form == b'E' { form_e(size) } else { form_f(size) };
    let size_by_diameter = call.diameter > 10.0 && !tables.says_sizes_by_diameter();
    let rests = Rests { size_by_diameter, convention: true, ..Rests::default() };
    Ok((classic(call, call.diameter, shape)?, rests))
}

/// The undercut cycle of CYCLE96: forms A to D of a metric coarse thread from M3 to M68. The corner lies on the nominal
/// diameter outside, on the core diameter inside.
///
/// # Errors
/// `Form`, `Position`, `Diameter`, `Size`.
pub(super) fn cycle96(call: &Classic, tables: &Undercuts) -> Result<(UndercutCycle, Rests), CallFault> {
    let form = thread_form(call.form.to_ascii_uppercase())?;
    if !(3.0..=68.0).contains(&call.diameter) {
        return Err(CallFault::Diameter);
    }
    let pitch = coarse_pitch(call.diameter).ok_or(CallFault::Diameter)?;
    let row = tables.thread(pitch).ok_or(CallFault::Size)?;
    let (shape, thread) = thread(tables, row, form, Deg(30.0));
    let diameter = match form.surface() {
        Surface::External => call.diameter,
        Surface::Internal => call.diameter - CORE * pitch,
    };
    let cycle = classic(call, diameter, shape)?;
    let inside = cycle.orientation.second < 0.0;
    if inside != (form.surface() == Surface::Internal) {
        return Err(CallFault::Position);
    }
    Ok((cycle, Rests { thread, convention: true, ..Rests::default() }))
}

fn classic(call: &Classic, diameter: f64, shape: Shape) -> Result<UndercutCycle, CallFault> {
    Ok(UndercutCycle {
        corner: Point2::new(call.spl, diameter / 2.0),
        orientation: position_classic(call.position)?,
        shape,
        allowance: Allowance::default(),
        clearance: call.clearance,
        face_end: None,
        feed: call.feed,
        step: None,
        leave: Leave::NOTHING,
        finishing: true,
        compensated: false,
        nose: Nose::default(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn call(form: u8) -> Cycle940 {
        Cycle940 {
            spd: Some(24.0),
            spl: Some(-25.0),
            form: Some(form),
            lage: Some(1.0),
            sdis: Some(1.0),
            ffp: Some(0.1),
            piti: (form != b'T').then_some(0.0),
            sta: (form != b'T').then_some(30.0),
            ..Cycle940::default()
        }
    }

    fn made(call: Cycle940) -> (UndercutCycle, Rests) {
        cycle940(&call, &Undercuts::default()).expect("an undercut")
    }

    #[test]
    fn forms_of_cycle940() {
        let (cycle, rests) = made(Cycle940 { vrt: Some(30.0), ..call(b'E') });
        assert_eq!((cycle.corner, cycle.face_end), (Point2::new(-25.0, 12.0), Some(15.0)));
        assert!(matches!(cycle.shape, Shape::Square { depth: 0.3, .. }) && rests == Rests::default());
        // `_PITI` 17 with M24: pitch 3.
        let (cycle, rests) = made(Cycle940 { piti: Some(17.0), vari: Some(3.0), mid: Some(0.5), ..call(b'a') });
        assert!(matches!(cycle.shape, Shape::Square { depth: 2.2, corner_radius: 1.6, .. }), "{cycle:?}");
        assert!(rests.roughing && cycle.step == Some(0.5) && cycle.finishing);
        let free = Cycle940 {
            epd: Some(20.0),
            epl: Some(8.0),
            amode: Some(10.0),
            r1: Some(0.5),
            r2: Some(1.0),
            sta: Some(30.0),
            ..call(b'T')
        };
        let wanted = Shape::Square { length: 8.0, depth: 2.0, entry: Deg(30.0), entry_radius: 0.5, corner_radius: 1.0 };
        assert_eq!(made(free).0.shape, wanted);
        let raised = Cycle940 { epd: Some(24.2), ..call(b'F') };
        assert!((made(raised).0.allowance.reference - 0.1).abs() < 1e-12);
    }

    #[test]
    fn faults_of_cycle940() {
        let fault = |call: Cycle940| cycle940(&call, &Undercuts::default()).expect_err("refused");
        assert_eq!(fault(call(b'G')), CallFault::Form);
        assert_eq!(fault(Cycle940 { spd: None, ..call(b'E') }), CallFault::Missing("_SPD"));
        assert_eq!(fault(Cycle940 { lage: Some(4.0), ..call(b'E') }), CallFault::Position);
        assert_eq!(fault(Cycle940 { sdis: None, ..call(b'E') }), CallFault::Range("_SDIS"));
        assert_eq!(fault(Cycle940 { piti: None, ..call(b'A') }), CallFault::Pitch);
        assert_eq!(fault(Cycle940 { piti: Some(24.0), ..call(b'A') }), CallFault::Size);
        assert_eq!(fault(Cycle940 { piti: Some(0.5), ..call(b'E') }), CallFault::Range("_PITI"));
        assert_eq!(fault(Cycle940 { sta: Some(29.0), ..call(b'A') }), CallFault::Range("_STA"));
        assert_eq!(fault(Cycle940 { vari: Some(1.0), ..call(b'A') }), CallFault::Range("_MID"));
        assert_eq!(fault(Cycle940 { vari: Some(4.0), ..call(b'A') }), CallFault::Range("_VARI"));
        let both = Cycle940 { vari: Some(1.0), mid: Some(1.0), fal: Some(0.1), falz: Some(0.2), ..call(b'A') };
        assert_eq!(fault(both), CallFault::BothAllowances);
        let all = Cycle940 { vari: Some(1.0), mid: Some(1.0), fal: Some(0.1), ..call(b'A') };
        assert!(made(all).1.other_allowance && made(all).0.leave == Leave::Around(0.1));
        assert!(!made(Cycle940 { amode: Some(1000.0), ..all }).1.other_allowance);
        assert_eq!(fault(call(b'T')), CallFault::Missing("_EPD and _EPL"));
    }

    #[test]
    fn classic_cycles() {
        let tables = Undercuts::default();
        let call = Classic {
            diameter: 20.0,
            spl: -60.0,
            form: b'E',
            position: 3,
            feed: Feed::PerRevolution(0.1),
            clearance: 1.0,
        };
        let (cycle, _) = cycle94(&call, &tables).expect("an undercut");
        assert_eq!(
            (cycle.corner, cycle.orientation.first, cycle.orientation.second),
            (Point2::new(-60.0, 10.0), 1.0, 1.0)
        );
        assert_eq!(cycle94(&Classic { diameter: 2.9, ..call }, &tables), Err(CallFault::Diameter));
        assert_eq!(cycle94(&Classic { form: b'A', ..call }, &tables), Err(CallFault::Form));
        assert_eq!(cycle94(&Classic { position: 5, ..call }, &tables), Err(CallFault::Position));
        let (cycle, _) = cycle96(&Classic { form: b'C', position: 2, ..call }, &tables).expect("an undercut");
        assert!((2.0 * cycle.corner.y - 17.293675).abs() < 1e-9 && cycle.orientation.second < 0.0);
        assert_eq!(cycle96(&Classic { form: b'C', ..call }, &tables), Err(CallFault::Position));
        assert_eq!(cycle96(&Classic { form: b'A', diameter: 21.0, ..call }, &tables), Err(CallFault::Diameter));
        assert_eq!(cycle96(&Classic { form: b'E', ..call }, &tables), Err(CallFault::Form));
    }
}
