//! An undercut at a corner of a turned contour, with the sizes of the standards as shapes.

use core::fmt;

use crate::geo::Deg;
use crate::geo::undercut::Shape;
use crate::machine::undercut::{InternalDepth, ThreadLength, Undercuts};
use crate::standard::din13::{CORE, coarse_pitch, proposed_pitch};
use crate::standard::din76::{Lengths, Row};
use crate::standard::din509::Size;
use crate::standard::{din76, din509};

pub use crate::geo::undercut::{Allowance, Orientation};

/// How much a bore may be off the core of its thread, in mm: drills come in tenths.
const BORE: f64 = 0.25;

/// Side of a turned part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Surface {
    /// The outside: the contour rises from the corner, away from the turning centre.
    External,
    /// A bore: the contour falls towards the turning centre.
    Internal,
}

/// Relieves the corner between the element before and the next one. Both are straight lines of a turned
/// contour, one along the part and one across.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Undercut {
    /// What is cut where the contour rises from the corner, away from the turning centre.
    pub external: Shape,
    /// What is cut where it falls towards the turning centre.
    pub internal: Shape,
    /// The side the program says it machines; `None` where only the contour tells.
    pub surface: Option<Surface>,
    /// The slope lies on the face, not on the cylinder.
    pub on_face: bool,
    /// What the cylinder and the face still carry, mm, not below zero.
    pub allowance: Allowance,
}

impl Undercut {
    /// The same shape outside and inside.
    pub fn new(shape: Shape) -> Undercut {
        Undercut { external: shape, internal: shape, surface: None, on_face: false, allowance: Allowance::default() }
    }
}

/// Form E of a size: the cylinder is relieved.
pub fn form_e(size: &Size) -> Shape {
    Shape::Square {
        length: size.length,
        depth: size.depth,
        entry: Deg(din509::ENTRY),
        entry_radius: size.radius,
        corner_radius: size.radius,
    }
}

/// Form F of a size: cylinder and face are relieved.
pub fn form_f(size: &Size) -> Shape {
    Shape::Recessed {
        length: size.length,
        depth: size.depth,
        entry: Deg(din509::ENTRY),
        entry_radius: size.radius,
        corner_radius: size.radius,
        face_depth: size.face_depth,
        face_angle: Deg(din509::FACE),
    }
}

/// Forms of DIN 76.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ThreadForm {
    /// External, normal length.
    A,
    /// External, short.
    B,
    /// Internal, normal length.
    C,
    /// Internal, short.
    D,
}

impl ThreadForm {
    /// The form for a side of the part; controls propose the normal length.
    pub fn of(surface: Surface, short: bool) -> ThreadForm {
        match (surface, short) {
            (Surface::External, false) => ThreadForm::A,
            (Surface::External, true) => ThreadForm::B,
            (Surface::Internal, false) => ThreadForm::C,
            (Surface::Internal, true) => ThreadForm::D,
        }
    }

    /// The side of the part that the form is made for.
    pub fn surface(self) -> Surface {
        match self {
            ThreadForm::A | ThreadForm::B => Surface::External,
            ThreadForm::C | ThreadForm::D => Surface::Internal,
        }
    }
}

/// What a thread undercut rests on besides confirmed facts; for a word to the user.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Doubts {
    /// The lengths of the short forms have a single source.
    pub short_form: bool,
    /// The length for another entry angle than 30 degrees is extrapolated.
    pub entry: bool,
    /// From where the internal depth counts is not confirmed.
    pub internal: bool,
}

impl Doubts {
    /// Is there any doubt?
    pub fn any(self) -> bool {
        self != Doubts::default()
    }
}

impl fmt::Display for Doubts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let texts = [
            (self.short_form, "the lengths of the short form (`[undercut] din76`)"),
            (self.entry, "the length at this entry angle (`[undercut] thread_length`)"),
            (self.internal, "the depth of an internal undercut (`[undercut] internal_depth`)"),
        ];
        let mut first = true;
        for (_, text) in texts.iter().filter(|(holds, _)| *holds) {
            f.write_str(if first { "" } else { ", " })?;
            f.write_str(text)?;
            first = false;
        }
        Ok(())
    }
}

/// The coarse pitch to propose for a thread on a turned diameter: outside that of the nominal diameter, inside that of
/// the thread whose core the bore is.
pub fn usual_pitch(tables: &Undercuts, surface: Surface, diameter: f64) -> Option<f64> {
    if surface == Surface::External {
        return proposed_pitch(diameter);
    }
    let nominal = |pitch: f64| libm::round(2.0 * (diameter + CORE * pitch)) / 2.0;
    let off = |pitch: f64| (diameter + CORE * pitch - nominal(pitch)).abs();
    let fits = |pitch: &f64| coarse_pitch(nominal(*pitch)) == Some(*pitch) && off(*pitch) <= BORE;
    tables.threads().iter().map(|row| row.pitch).filter(fits).min_by(|a, b| off(*a).total_cmp(&off(*b)))
}

/// Depth in mm of an internal thread undercut below the bore.
pub fn internal_depth(rule: InternalDepth, row: &Row) -> f64 {
    match rule {
        InternalDepth::Core => (CORE * row.pitch + row.internal) / 2.0,
        InternalDepth::Bore => row.internal / 2.0,
    }
}

/// Thread undercut of a pitch; where the user says nothing of its length and depth, as a control was seen to make
/// it. `entry` lies between 30 and 90 degrees on controls.
pub fn thread(tables: &Undercuts, row: &Row, form: ThreadForm, entry: Deg) -> (Shape, Doubts) {
    let lengths = match form {
        ThreadForm::A => row.a,
        ThreadForm::B => row.b,
        ThreadForm::C => row.c,
        ThreadForm::D => row.d,
    };
    let depth = match form.surface() {
        Surface::External => row.external / 2.0,
        Surface::Internal => internal_depth(tables.internal_depth.unwrap_or(InternalDepth::Core), row),
    };
    let shape = Shape::Square {
        length: thread_length(tables.thread_length.unwrap_or(ThreadLength::Middle), lengths, depth, entry),
        depth,
        entry,
        entry_radius: row.radius,
        corner_radius: row.radius,
    };
    // What the user set in `[undercut]` is no doubt any more.
    let doubts = Doubts {
        short_form: match form {
            ThreadForm::A | ThreadForm::C => false,
            ThreadForm::B => !tables.says_short_form(row.pitch, 'b'),
            ThreadForm::D => !tables.says_short_form(row.pitch, 'd'),
        },
        entry: entry != Deg(din76::ENTRY) && tables.thread_length.is_none(),
        internal: form.surface() == Surface::Internal && tables.internal_depth.is_none(),
    };
    (shape, doubts)
}

/// Length in mm of a thread undercut from the corner to the start of its slope; `depth` in mm, `entry` over 0 degrees.
pub fn thread_length(rule: ThreadLength, lengths: Lengths, depth: f64, entry: Deg) -> f64 {
    let (sin, cos) = entry.sin_cos();
    let slope = depth * cos / sin;
    match rule {
        ThreadLength::Middle => (lengths.g1 + slope + lengths.g2) / 2.0,
        ThreadLength::Shortest => lengths.g1 + slope,
        ThreadLength::Longest => lengths.g2,
    }
}

/// A thread undercut whose form follows from the contour: A or B outside, C or D inside.
pub fn thread_by_contour(tables: &Undercuts, row: &Row, short: bool, entry: Deg) -> Undercut {
    let shape = |surface| thread(tables, row, ThreadForm::of(surface, short), entry).0;
    Undercut {
        external: shape(Surface::External),
        internal: shape(Surface::Internal),
        ..Undercut::new(shape(Surface::External))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geo::undercut::{Corner, Reference, place};
    use crate::geo::{Element, Point2};

    fn square(shape: Shape) -> (f64, f64, f64) {
        match shape {
            Shape::Square { length, depth, corner_radius, .. } => (length, depth, corner_radius),
            other => panic!("{other:?}"),
        }
    }

    /// Pitch 3, 30 degrees: a control printed Z-14.495 and Z-18.305 X19.6 for the corner Z-25 X24.
    #[test]
    fn pitch_3_is_what_a_control_made() {
        let tables = Undercuts::default();
        let row = tables.thread(3.0).expect("a pitch of the table");
        let (shape, doubts) = thread(&tables, row, ThreadForm::A, Deg(30.0));
        let (length, depth, radius) = square(shape);
        assert!((-25.0 + length + 14.495).abs() < 5e-4 && !doubts.any());
        assert_eq!((24.0 - 2.0 * depth, radius), (19.6, 1.6));
        let floor = length - depth / libm::tan(30f64.to_radians());
        assert!((-25.0 + floor + 18.305).abs() < 5.1e-4, "{floor}");
    }

    #[test]
    fn worked_values_of_m20() {
        let tables = Undercuts::default();
        let row = tables.thread(2.5).expect("a pitch of the table");
        let near = |form, entry, length: f64, depth: f64| {
            let found = square(thread(&tables, row, form, Deg(entry)).0);
            assert!((found.0 - length).abs() < 5.1e-5 && (found.1 - depth).abs() < 5.1e-5, "{form:?} {found:?}");
        };
        near(ThreadForm::A, 30.0, 8.7088, 1.8);
        near(ThreadForm::A, 60.0, 7.6696, 1.8);
        near(ThreadForm::A, 90.0, 7.15, 1.8);
        near(ThreadForm::B, 30.0, 6.3088, 1.8);
        near(ThreadForm::C, 30.0, 12.8884, 1.6032);
        near(ThreadForm::D, 30.0, 9.1884, 1.6032);
        let doubts = thread(&tables, row, ThreadForm::D, Deg(45.0)).1;
        assert!(doubts.short_form && doubts.entry && doubts.internal);
        assert_eq!(doubts.to_string().matches('`').count(), 6);
    }

    #[test]
    fn pitches_are_proposed_from_the_diameter() {
        let tables = Undercuts::default();
        let usual = |surface, diameter| usual_pitch(&tables, surface, diameter);
        assert_eq!(usual(Surface::External, 20.0), Some(2.5));
        assert_eq!(usual(Surface::External, 200.0), None);
        // Cores of M20, M10 and M6, as turned and as drilled.
        for (bore, pitch) in [(17.294, 2.5), (8.376, 1.5), (4.917, 1.0), (17.5, 2.5), (8.5, 1.5), (5.0, 1.0)] {
            assert_eq!(usual(Surface::Internal, bore), Some(pitch), "{bore}");
        }
        assert_eq!(usual(Surface::Internal, 100.0), None);
    }

    /// Every size and pitch fits its own standard at every allowed entry angle.
    #[test]
    fn every_row_fits_in_all_four_orientations() {
        let tables = Undercuts::default();
        let mut shapes = Vec::new();
        for size in tables.sizes() {
            shapes.extend([form_e(size), form_f(size)]);
        }
        for row in tables.threads() {
            for form in [ThreadForm::A, ThreadForm::B, ThreadForm::C, ThreadForm::D] {
                // Entry angles at which the radii do not fit a short form are refused with their own finding.
                shapes.push(thread(&tables, row, form, Deg(30.0)).0);
            }
        }
        for shape in shapes {
            for (a, b) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
                let at = Point2::new(-30.0, 50.0);
                let corner = Corner {
                    from: at + crate::geo::Vec2::new(40.0 * a, 0.0),
                    at,
                    to: at + crate::geo::Vec2::new(0.0, 30.0 * b),
                };
                let placed = place(&shape, &corner, Reference::First, Allowance::default());
                assert!(placed.is_ok(), "{shape:?} {placed:?}");
            }
        }
    }

    /// What the standard prints as g of form F follows from the others, rounded to 0.1.
    #[test]
    fn g_of_form_f_is_what_din_509_prints() {
        let g = [0.8, 0.9, 1.1, 1.4, 2.1, 2.3, 1.8, 3.2, 2.0, 3.4, 3.1, 4.8, 6.4];
        for (size, g) in din509::SIZES.iter().zip(g) {
            let corner = Corner { from: Point2::new(20.0, 0.0), at: Point2::origin(), to: Point2::new(0.0, 20.0) };
            let placed = place(&form_f(size), &corner, Reference::First, Allowance::default()).expect("it fits");
            assert!((placed.join.y + size.depth - g).abs() < 0.05, "{size:?} {placed:?}");
        }
    }

    #[test]
    fn the_length_grows_with_the_pitch() {
        let tables = Undercuts::default();
        let path = |row: &Row, form| {
            let corner = Corner { from: Point2::new(60.0, 0.0), at: Point2::origin(), to: Point2::new(0.0, 40.0) };
            let shape = thread(&tables, row, form, Deg(30.0)).0;
            let placed = place(&shape, &corner, Reference::First, Allowance::default()).expect("it fits");
            (placed.elements.iter().map(Element::length).sum::<f64>(), placed.leave.x)
        };
        for form in [ThreadForm::A, ThreadForm::B, ThreadForm::C, ThreadForm::D] {
            for pair in tables.threads().windows(2) {
                let (less, more) = (path(&pair[0], form), path(&pair[1], form));
                assert!(less.0 < more.0 && less.1 < more.1, "{form:?} {} {less:?} {more:?}", pair[1].pitch);
            }
        }
    }
}
