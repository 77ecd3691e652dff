//! G groups: their codes by name, number and internal index, and the code that is in force in each.
//!
//! Source: SINUMERIK, "Programming", list of G groups; the internal indices as `$P_GG` returns them.

use crate::ir::Side;
use crate::machine::{MachineKind, Settings, Unit};

/// A G group. The value is its number on the control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(u8)]
pub(super) enum Group {
    /// Modal kind of motion.
    Motion = 1,
    /// Motion and dwell of one block.
    Nonmodal = 2,
    /// Programmable frames, limits of the working area, poles.
    Frame = 3,
    /// Buffer of blocks.
    Buffer = 4,
    /// Working plane.
    Plane = 6,
    /// Side of the radius compensation.
    Compensation = 7,
    /// Settable work offset.
    WorkOffset = 8,
    /// Suppression of frames and tool offsets in one block.
    Suppression = 9,
    /// Exact stop or continuous path.
    ExactStop = 10,
    /// Exact stop of one block.
    ExactStopBlock = 11,
    ExactStopWindow = 12,
    /// Inch or metric.
    Unit = 13,
    /// Absolute or incremental.
    Dimension = 14,
    /// What F and S count.
    FeedType = 15,
    /// Feed on inner and outer curves under compensation.
    CurveFeed = 16,
    /// Approach and retraction under compensation.
    Approach = 17,
    /// Outer corners under compensation.
    Corner = 18,
    SplineStart = 19,
    SplineEnd = 20,
    Acceleration = 21,
    /// Dimension of the radius compensation.
    CompensationType = 22,
    /// Collision monitoring.
    Collision = 23,
    Feedforward = 24,
    OrientationReference = 25,
    RepositioningPoint = 26,
    /// Change of orientation at outer corners.
    OrientationCorner = 27,
    /// Working-area limits.
    WorkingArea = 28,
    /// Radius or diameter.
    Diameter = 29,
    Compression = 30,
    /// Codes of the machine builder.
    Builder1 = 31,
    Builder2 = 32,
    FineToolOffset = 33,
    OrientationSmoothing = 34,
    Punching = 35,
    PunchingDelay = 36,
    /// Course of the feed.
    FeedProfile = 37,
    PunchingOutput = 38,
    ContourAccuracy = 39,
    ConstantCompensation = 40,
    ThreadInterruption = 41,
    ToolCarrier = 42,
    /// Direction of soft approach.
    SoftApproach = 43,
    SoftApproachPath = 44,
    PathReference = 45,
    RetractionPlane = 46,
    /// SINUMERIK or ISO dialect.
    CodeMode = 47,
    /// Approach and retraction under collision.
    CompensationEnds = 48,
    PointToPoint = 49,
    OrientationAngles = 50,
    OrientationPath = 51,
    WorkpieceFrame = 52,
    ToolFrame = 53,
    OrientationVector = 54,
    RapidInterpolation = 55,
    ToolWear = 56,
    CornerDeceleration = 57,
    SoftwareLimit = 58,
    /// Mode of the path dynamics.
    Dynamics = 59,
    WorkingAreaChoice = 60,
    OrientationContinuity = 61,
    RepositioningPointBlock = 62,
}

impl Group {
    /// The group of a number.
    pub fn of(number: u8) -> Option<Group> {
        row_of_number(number).map(|row| row.group)
    }

    pub const fn number(self) -> u8 {
        self as u8
    }

    /// Its codes shape the block, which takes one of all of them.
    #[inline]
    pub fn shapes_block(self) -> bool {
        matches!(self, Group::Motion | Group::Nonmodal | Group::Frame | Group::Buffer)
    }

    /// May a program choose its code by index, `G[8]=2`?
    pub fn takes_index(self) -> bool {
        !matches!(self, Group::Nonmodal | Group::Frame | Group::Buffer)
    }

    /// Number of codes.
    pub fn size(self) -> u8 {
        match self {
            Group::WorkOffset => INDEX_OF_FIRST_LONG + (LAST_LONG - FIRST_LONG) as u8,
            _ => self.names().split(' ').count() as u8,
        }
    }

    fn names(self) -> &'static str {
        row_of_number(self.number()).map_or("", |row| row.names)
    }
}

/// A code of a G group.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct GCode {
    pub group: Group,
    /// From 1, in the order of the control.
    pub index: u8,
}

impl GCode {
    pub const fn new(group: Group, index: u8) -> GCode {
        GCode { group, index }
    }

    /// The code as a program writes it.
    pub fn word(self) -> String {
        if self.group == Group::WorkOffset && self.index >= INDEX_OF_FIRST_LONG {
            return format!("G{}", FIRST_LONG + u32::from(self.index - INDEX_OF_FIRST_LONG));
        }
        self.group.names().split(' ').nth(usize::from(self.index).wrapping_sub(1)).unwrap_or("?").to_owned()
    }

    /// Tapping in step with the spindle.
    #[inline]
    pub fn is_tapping(self) -> bool {
        matches!(self, GCode::G331 | GCode::G332)
    }

    /// S counts as cutting speed.
    #[inline]
    pub fn holds_cutting_speed(self) -> bool {
        matches!(self, GCode::G96 | GCode::G961)
    }

    /// S counts in turns again, up to LIMS.
    pub fn ends_cutting_speed(self) -> bool {
        matches!(self, GCode::G97 | GCode::G971)
    }
}

/// The code in force of every group.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct ActiveCodes {
    /// Index by number of the group; 0 where nothing holds on.
    active: [u8; NUMBERS],
}

/// Highest group number and one more.
const NUMBERS: usize = 65;

impl ActiveCodes {
    /// The side of the radius compensation.
    pub fn side(&self) -> Side {
        match self.of(Group::Compensation) {
            GCode::G41 => Side::Left,
            GCode::G42 => Side::Right,
            _ => Side::None,
        }
    }

    /// What is in force before the first block.
    pub fn at_start(settings: &Settings) -> ActiveCodes {
        let mut codes = ActiveCodes { active: [0; NUMBERS] };
        for row in TABLE {
            codes.active[row.group as usize] = row.default;
        }
        let machine = &settings.machine;
        if machine.kind == MachineKind::Lathe {
            codes.activate(GCode::G18);
            if machine.power_on_diameter && machine.diameter_axis.is_some() {
                codes.activate(GCode::DIAMON);
            }
        }
        if settings.control.sinumerik.feed_per_revolution == Some(true) {
            codes.activate(GCode::G95);
        }
        if settings.control.unit == Some(Unit::Inch) {
            codes.activate(GCode::G70);
        }
        codes
    }

    /// The code in force.
    #[inline]
    pub fn of(&self, group: Group) -> GCode {
        GCode { group, index: self.active[group as usize] }
    }

    #[inline]
    pub fn is(&self, code: GCode) -> bool {
        self.active[code.group as usize] == code.index
    }

    #[inline]
    pub fn activate(&mut self, code: GCode) {
        self.active[code.group as usize] = code.index;
    }

    /// The index that `$P_GG` shows; `None` for a number that no control has.
    pub fn shown(&self, number: usize) -> Option<u8> {
        self.active.get(number).copied()
    }

    /// Millimetres in a programmed unit of length.
    #[inline]
    pub fn length_unit(&self) -> f64 {
        match self.of(Group::Unit) {
            GCode::G70 | GCode::G700 => Unit::Inch.mm(),
            _ => 1.0,
        }
    }

    /// Millimetres in the unit of length of F, where the control's basic unit is `basic`.
    pub fn feed_unit(&self, basic: Unit) -> f64 {
        match self.of(Group::Unit) {
            GCode::G700 => Unit::Inch.mm(),
            GCode::G710 => 1.0,
            _ => basic.mm(),
        }
    }

    /// Does F count per revolution?
    #[inline]
    pub fn per_revolution(&self) -> bool {
        matches!(self.of(Group::FeedType), GCode::G95 | GCode::G96 | GCode::G97)
    }
}

struct Row {
    group: Group,
    /// Index that is active at the start; 0 for groups that count in their block only.
    default: u8,
    names: &'static str,
}

const fn row(group: Group, default: u8, names: &'static str) -> Row {
    Row { group, default, names }
}

fn row_of_number(number: u8) -> Option<&'static Row> {
    TABLE.iter().find(|row| row.group.number() == number)
}

const TABLE: &[Row] = &[
    row(
        Group::Motion,
        2,
        "G0 G1 G2 G3 CIP ASPLINE BSPLINE CSPLINE POLY G33 G331 G332 OEMIPO1 OEMIPO2 CT G34 G35 INVCW INVCCW G335 G336",
    ),
    row(
        Group::Nonmodal,
        0,
        "G4 G63 G74 G75 REPOSL REPOSQ REPOSH REPOSA REPOSQA REPOSHA G147 G247 G347 G148 G248 G348 G5 G7",
    ),
    row(
        Group::Frame,
        0,
        "TRANS ROT SCALE MIRROR ATRANS AROT ASCALE AMIRROR - G25 G26 G110 G111 G112 G58 G59 ROTS AROTS",
    ),
    row(Group::Buffer, 1, "STARTFIFO STOPFIFO FIFOCTRL"),
    row(Group::Plane, 1, "G17 G18 G19"),
    row(Group::Compensation, 1, "G40 G41 G42"),
    row(Group::WorkOffset, 1, "G500 G54 G55 G56 G57"),
    row(Group::Suppression, 0, "G53 SUPA G153 SUPD"),
    row(Group::ExactStop, 1, "G60 G64 G641 G642 G643 G644 G645"),
    row(Group::ExactStopBlock, 0, "G9"),
    row(Group::ExactStopWindow, 1, "G601 G602 G603"),
    row(Group::Unit, 2, "G70 G71 G700 G710"),
    row(Group::Dimension, 1, "G90 G91"),
    row(Group::FeedType, 2, "G93 G94 G95 G96 G97 G931 G961 G971 G942 G952 G962 G972 G973"),
    row(Group::CurveFeed, 1, "CFC CFTCP CFIN"),
    row(Group::Approach, 1, "NORM KONT KONTT KONTC"),
    row(Group::Corner, 1, "G450 G451"),
    row(Group::SplineStart, 1, "BNAT BTAN BAUTO"),
    row(Group::SplineEnd, 1, "ENAT ETAN EAUTO"),
    row(Group::Acceleration, 1, "BRISK SOFT DRIVE"),
    row(
        Group::CompensationType,
        1,
        "CUT2D CUT2DF CUT3DC CUT3DF CUT3DFS CUT3DFF CUT3DCC CUT3DCCD CUT2DD CUT2DFD CUT3DCD CUT3DFD",
    ),
    row(Group::Collision, 1, "CDOF CDON CDOF2"),
    row(Group::Feedforward, 1, "FFWOF FFWON"),
    row(Group::OrientationReference, 1, "ORIWKS ORIMKS"),
    row(Group::RepositioningPoint, 2, "RMB RMI RME RMN"),
    row(Group::OrientationCorner, 1, "ORIC ORID"),
    row(Group::WorkingArea, 1, "WALIMON WALIMOF"),
    row(Group::Diameter, 1, "DIAMOF DIAMON DIAM90 DIAMCYCOF"),
    row(Group::Compression, 1, "COMPOF COMPON COMPCURV COMPCAD COMPSURF"),
    row(Group::Builder1, 1, "G810 G811 G812 G813 G814 G815 G816 G817 G818 G819"),
    row(Group::Builder2, 1, "G820 G821 G822 G823 G824 G825 G826 G827 G828 G829"),
    row(Group::FineToolOffset, 1, "FTOCOF FTOCON"),
    row(Group::OrientationSmoothing, 1, "OSOF OSC OSS OSSE OSD OST"),
    row(Group::Punching, 1, "SPOF SON PON SONS PONS"),
    row(Group::PunchingDelay, 1, "PDELAYON PDELAYOF"),
    row(Group::FeedProfile, 1, "FNORM FLIN FCUB"),
    row(Group::PunchingOutput, 1, "SPIF1 SPIF2"),
    row(Group::ContourAccuracy, 1, "CPRECOF CPRECON"),
    row(Group::ConstantCompensation, 1, "CUTCONOF CUTCONON"),
    row(Group::ThreadInterruption, 1, "LFOF LFON"),
    row(Group::ToolCarrier, 1, "TCOABS TCOFR TCOFRZ TCOFRY TCOFRX"),
    row(Group::SoftApproach, 1, "G140 G141 G142 G143"),
    row(Group::SoftApproachPath, 1, "G340 G341"),
    row(Group::PathReference, 1, "SPATH UPATH"),
    row(Group::RetractionPlane, 1, "LFTXT LFWP LFPOS"),
    row(Group::CodeMode, 1, "G290 G291"),
    row(Group::CompensationEnds, 1, "G460 G461 G462"),
    row(Group::PointToPoint, 1, "CP PTP PTPG0 PTPWOC"),
    row(Group::OrientationAngles, 1, "ORIEULER ORIRPY ORIVIRT1 ORIVIRT2 ORIAXPOS ORIRPY2"),
    row(
        Group::OrientationPath,
        1,
        "ORIVECT ORIAXES ORIPATH ORIPLANE ORICONCW ORICONCCW ORICONIO ORICONTO ORICURVE ORIPATHS",
    ),
    row(Group::WorkpieceFrame, 1, "PAROTOF PAROT"),
    row(Group::ToolFrame, 1, "TOROTOF TOROT TOROTZ TOROTY TOROTX TOFRAME TOFRAMEZ TOFRAMEY TOFRAMEX"),
    row(Group::OrientationVector, 1, "ORIROTA ORIROTR ORIROTT ORIROTC"),
    row(Group::RapidInterpolation, 1, "RTLION RTLIOF"),
    row(Group::ToolWear, 1, "TOWSTD TOWMCS TOWWCS TOWBCS TOWTCS TOWKCS"),
    row(Group::CornerDeceleration, 1, "FENDNORM G62 G621"),
    row(Group::SoftwareLimit, 1, "RELIEVEON RELIEVEOF"),
    row(Group::Dynamics, 1, "DYNNORM DYNPOS DYNROUGH DYNSEMIFIN DYNFINISH DYNPREC"),
    row(Group::WorkingAreaChoice, 1, "WALCS0 WALCS1 WALCS2 WALCS3 WALCS4 WALCS5 WALCS6 WALCS7 WALCS8 WALCS9 WALCS10"),
    row(Group::OrientationContinuity, 1, "ORISOF ORISON"),
    row(Group::RepositioningPointBlock, 0, "RMBBL RMIBL RMEBL RMNBL"),
];

/// First settable offset of the long series, and the index of G505.
const FIRST_LONG: u32 = 505;
const LAST_LONG: u32 = 599;
const INDEX_OF_FIRST_LONG: u8 = 6;

/// Every code that has a name, with it.
pub(super) fn named_codes() -> impl Iterator<Item = (&'static str, GCode)> {
    TABLE.iter().flat_map(|row| row.names.split(' ').zip(1..).map(|(name, index)| (name, GCode::new(row.group, index))))
}

/// Codes that the compiler asks for by name.
macro_rules! code_names {
    ($($name:ident = $group:ident $index:literal)*) => {
        impl GCode {
            $(pub const $name: GCode = GCode { group: Group::$group, index: $index };)*
        }
    };
}

code_names! {
    G0 = Motion 1  G1 = Motion 2  G2 = Motion 3  G3 = Motion 4  CIP = Motion 5
    G33 = Motion 10  CT = Motion 15  G34 = Motion 16  G35 = Motion 17
    G331 = Motion 11  G332 = Motion 12
    ASPLINE = Motion 6  BSPLINE = Motion 7  CSPLINE = Motion 8  POLY = Motion 9
    INVCW = Motion 18  INVCCW = Motion 19  G335 = Motion 20  G336 = Motion 21
    G4 = Nonmodal 1  G63 = Nonmodal 2  G147 = Nonmodal 11  G247 = Nonmodal 12  G347 = Nonmodal 13  G148 = Nonmodal 14  G248 = Nonmodal 15  G348 = Nonmodal 16
    G340 = SoftApproachPath 1   G74 = Nonmodal 3  G75 = Nonmodal 4
    TRANS = Frame 1  ROT = Frame 2  SCALE = Frame 3  MIRROR = Frame 4
    ATRANS = Frame 5  AROT = Frame 6  ASCALE = Frame 7  AMIRROR = Frame 8
    G25 = Frame 10  G26 = Frame 11  G110 = Frame 12  G111 = Frame 13  G112 = Frame 14  G58 = Frame 15  G59 = Frame 16
    FIFOCTRL = Buffer 3
    G18 = Plane 2  G19 = Plane 3
    NORM = Approach 1  KONT = Approach 2  CDON = Collision 2
    G40 = Compensation 1  G41 = Compensation 2  G42 = Compensation 3
    SUPD = Suppression 4
    G60 = ExactStop 1  G64 = ExactStop 2  G641 = ExactStop 3  G642 = ExactStop 4  G643 = ExactStop 5  G645 = ExactStop 7
    G93 = FeedType 1  G94 = FeedType 2  G95 = FeedType 3  G96 = FeedType 4  G97 = FeedType 5
    G961 = FeedType 7  G971 = FeedType 8
    G70 = Unit 1  G700 = Unit 3  G710 = Unit 4
    G91 = Dimension 2
    DIAMOF = Diameter 1  DIAMON = Diameter 2  DIAM90 = Diameter 3  DIAMCYCOF = Diameter 4
    CFC = CurveFeed 1  FNORM = FeedProfile 1  RTLION = RapidInterpolation 1
    FTOCON = FineToolOffset 2  G291 = CodeMode 2  PAROT = WorkpieceFrame 2  CUTCONON = ConstantCompensation 2
}

/// Largest G number.
const MOST_G: usize = 1000;

/// The G codes by number.
#[derive(Debug)]
pub(super) struct GCodes {
    codes: Box<[Option<GCode>]>,
}

impl GCodes {
    pub fn new() -> GCodes {
        let mut codes = vec![None; MOST_G].into_boxed_slice();
        for row in TABLE {
            for (index, name) in row.names.split(' ').enumerate() {
                if let Some(number) = name.strip_prefix('G').and_then(|digits| digits.parse::<usize>().ok()) {
                    codes[number] = Some(GCode::new(row.group, index as u8 + 1));
                }
            }
        }
        for number in FIRST_LONG..=LAST_LONG {
            let index = INDEX_OF_FIRST_LONG + (number - FIRST_LONG) as u8;
            codes[number as usize] = Some(GCode::new(Group::WorkOffset, index));
        }
        GCodes { codes }
    }

    #[inline]
    pub fn get(&self, number: f64) -> Option<GCode> {
        if number.fract() != 0.0 || number < 0.0 {
            return None;
        }
        self.codes.get(number as usize).copied().flatten()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_by_number() {
        let codes = GCodes::new();
        assert_eq!(codes.get(0.0), Some(GCode::G0));
        assert_eq!(codes.get(33.0), Some(GCode::G33));
        assert_eq!(codes.get(505.0), Some(GCode::new(Group::WorkOffset, 6)));
        assert_eq!(codes.get(599.0), Some(GCode::new(Group::WorkOffset, 100)));
        assert_eq!(codes.get(997.0), None);
        assert_eq!(codes.get(1.5), None);
    }

    #[test]
    fn named_constants_are_the_codes_of_the_table() {
        let named = |name: &str| named_codes().find(|(known, _)| *known == name).map(|(_, code)| code);
        let constants = [
            (GCode::G0, "G0"),
            (GCode::G336, "G336"),
            (GCode::CT, "CT"),
            (GCode::INVCCW, "INVCCW"),
            (GCode::G59, "G59"),
            (GCode::G42, "G42"),
            (GCode::G971, "G971"),
            (GCode::G710, "G710"),
            (GCode::DIAMCYCOF, "DIAMCYCOF"),
            (GCode::RTLION, "RTLION"),
            (GCode::FTOCON, "FTOCON"),
            (GCode::G291, "G291"),
            (GCode::PAROT, "PAROT"),
            (GCode::CUTCONON, "CUTCONON"),
        ];
        for (code, name) in constants {
            assert_eq!(named(name), Some(code), "{name}");
            assert_eq!(code.word(), name);
        }
    }

    #[test]
    fn groups_by_number() {
        assert_eq!(Group::of(8), Some(Group::WorkOffset));
        assert_eq!((Group::of(5), Group::of(64)), (None, None));
        assert_eq!(Group::WorkOffset.size(), 100);
        assert_eq!(GCode::new(Group::WorkOffset, 7).word(), "G506");
        for row in TABLE {
            assert_eq!(Group::of(row.group.number()), Some(row.group));
        }
    }

    #[test]
    fn a_code_takes_the_place_of_its_group() {
        let mut codes = ActiveCodes::at_start(&Settings::default());
        assert!(codes.is(GCode::G94) && !codes.per_revolution());
        codes.activate(GCode::G96);
        assert_eq!(codes.of(Group::FeedType), GCode::G96);
        assert!(codes.per_revolution() && codes.of(Group::FeedType).holds_cutting_speed());
        codes.activate(GCode::G700);
        assert_eq!((codes.length_unit(), codes.feed_unit(Unit::Mm)), (25.4, 25.4));
        assert_eq!((codes.shown(15), codes.shown(5), codes.shown(65)), (Some(4), Some(0), None));
    }
}
