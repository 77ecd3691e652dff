//! The words of the language, as tables: G groups, addresses, procedures, functions.
//!
//! Source: reference sections 1.3, 2.14, 3, 5 and 6; group numbers and internal indices as `$P_GG` returns
//! them.

use rustc_hash::FxHashMap;

use super::axis_names::NamedAxis;
use super::known_words::{KNOWN, Known};

/// A code of a G group: group number and index in it, both from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Code {
    pub group: u8,
    pub index: u8,
}

/// Highest group number and one more.
pub(super) const GROUPS: usize = 65;

struct Group {
    number: u8,
    /// Index that is active at the start; 0 for groups that count in their block only.
    default: u8,
    names: &'static str,
}

const fn group(number: u8, default: u8, names: &'static str) -> Group {
    Group { number, default, names }
}

const TABLE: &[Group] = &[
    group(
        1,
        2,
        "G0 G1 G2 G3 CIP ASPLINE BSPLINE CSPLINE POLY G33 G331 G332 OEMIPO1 OEMIPO2 CT G34 G35 INVCW INVCCW G335 G336",
    ),
    group(2, 0, "G4 G63 G74 G75 REPOSL REPOSQ REPOSH REPOSA REPOSQA REPOSHA G147 G247 G347 G148 G248 G348 G5 G7"),
    group(3, 0, "TRANS ROT SCALE MIRROR ATRANS AROT ASCALE AMIRROR - G25 G26 G110 G111 G112 G58 G59 ROTS AROTS"),
    group(4, 1, "STARTFIFO STOPFIFO FIFOCTRL"),
    group(6, 1, "G17 G18 G19"),
    group(7, 1, "G40 G41 G42"),
    group(8, 1, "G500 G54 G55 G56 G57"),
    group(9, 0, "G53 SUPA G153 SUPD"),
    group(10, 1, "G60 G64 G641 G642 G643 G644 G645"),
    group(11, 0, "G9"),
    group(12, 1, "G601 G602 G603"),
    group(13, 2, "G70 G71 G700 G710"),
    group(14, 1, "G90 G91"),
    group(15, 2, "G93 G94 G95 G96 G97 G931 G961 G971 G942 G952 G962 G972 G973"),
    group(16, 1, "CFC CFTCP CFIN"),
    group(17, 1, "NORM KONT KONTT KONTC"),
    group(18, 1, "G450 G451"),
    group(19, 1, "BNAT BTAN BAUTO"),
    group(20, 1, "ENAT ETAN EAUTO"),
    group(21, 1, "BRISK SOFT DRIVE"),
    group(22, 1, "CUT2D CUT2DF CUT3DC CUT3DF CUT3DFS CUT3DFF CUT3DCC CUT3DCCD CUT2DD CUT2DFD CUT3DCD CUT3DFD"),
    group(23, 1, "CDOF CDON CDOF2"),
    group(24, 1, "FFWOF FFWON"),
    group(25, 1, "ORIWKS ORIMKS"),
    group(26, 2, "RMB RMI RME RMN"),
    group(27, 1, "ORIC ORID"),
    group(28, 1, "WALIMON WALIMOF"),
    group(29, 1, "DIAMOF DIAMON DIAM90 DIAMCYCOF"),
    group(30, 1, "COMPOF COMPON COMPCURV COMPCAD COMPSURF"),
    group(31, 1, "G810 G811 G812 G813 G814 G815 G816 G817 G818 G819"),
    group(32, 1, "G820 G821 G822 G823 G824 G825 G826 G827 G828 G829"),
    group(33, 1, "FTOCOF FTOCON"),
    group(34, 1, "OSOF OSC OSS OSSE OSD OST"),
    group(35, 1, "SPOF SON PON SONS PONS"),
    group(36, 1, "PDELAYON PDELAYOF"),
    group(37, 1, "FNORM FLIN FCUB"),
    group(38, 1, "SPIF1 SPIF2"),
    group(39, 1, "CPRECOF CPRECON"),
    group(40, 1, "CUTCONOF CUTCONON"),
    group(41, 1, "LFOF LFON"),
    group(42, 1, "TCOABS TCOFR TCOFRZ TCOFRY TCOFRX"),
    group(43, 1, "G140 G141 G142 G143"),
    group(44, 1, "G340 G341"),
    group(45, 1, "SPATH UPATH"),
    group(46, 1, "LFTXT LFWP LFPOS"),
    group(47, 1, "G290 G291"),
    group(48, 1, "G460 G461 G462"),
    group(49, 1, "CP PTP PTPG0 PTPWOC"),
    group(50, 1, "ORIEULER ORIRPY ORIVIRT1 ORIVIRT2 ORIAXPOS ORIRPY2"),
    group(51, 1, "ORIVECT ORIAXES ORIPATH ORIPLANE ORICONCW ORICONCCW ORICONIO ORICONTO ORICURVE ORIPATHS"),
    group(52, 1, "PAROTOF PAROT"),
    group(53, 1, "TOROTOF TOROT TOROTZ TOROTY TOROTX TOFRAME TOFRAMEZ TOFRAMEY TOFRAMEX"),
    group(54, 1, "ORIROTA ORIROTR ORIROTT ORIROTC"),
    group(55, 1, "RTLION RTLIOF"),
    group(56, 1, "TOWSTD TOWMCS TOWWCS TOWBCS TOWTCS TOWKCS"),
    group(57, 1, "FENDNORM G62 G621"),
    group(58, 1, "RELIEVEON RELIEVEOF"),
    group(59, 1, "DYNNORM DYNPOS DYNROUGH DYNSEMIFIN DYNFINISH DYNPREC"),
    group(60, 1, "WALCS0 WALCS1 WALCS2 WALCS3 WALCS4 WALCS5 WALCS6 WALCS7 WALCS8 WALCS9 WALCS10"),
    group(61, 1, "ORISOF ORISON"),
    group(62, 0, "RMBBL RMIBL RMEBL RMNBL"),
];

/// First settable offset of the long series, and the index of G505.
const FIRST_LONG: u32 = 505;
const LAST_LONG: u32 = 599;
const INDEX_OF_FIRST_LONG: u8 = 6;

/// Groups with a default index, 0 elsewhere.
pub(super) fn defaults() -> [u8; GROUPS] {
    let mut list = [0; GROUPS];
    for group in TABLE {
        list[group.number as usize] = group.default;
    }
    list
}

/// Number of codes in a group; 0 for a group that does not exist.
pub(super) fn size(group: u8) -> u8 {
    match TABLE.iter().find(|entry| entry.number == group) {
        Some(_) if group == 8 => INDEX_OF_FIRST_LONG + (LAST_LONG - FIRST_LONG) as u8,
        Some(entry) => entry.names.split(' ').count() as u8,
        None => 0,
    }
}

/// The word of a code.
pub(super) fn word(code: Code) -> String {
    if code.group == 8 && code.index >= INDEX_OF_FIRST_LONG {
        return format!("G{}", FIRST_LONG + u32::from(code.index - INDEX_OF_FIRST_LONG));
    }
    let names = TABLE.iter().find(|entry| entry.number == code.group).map_or("", |entry| entry.names);
    names.split(' ').nth(usize::from(code.index).wrapping_sub(1)).unwrap_or("?").to_owned()
}

/// Codes that the compiler asks for by name.
macro_rules! code_names {
    ($($name:ident = $group:literal $index:literal)*) => {
        impl Code {
            $(pub const $name: Code = Code { group: $group, index: $index };)*
        }
    };
}

code_names! {
    G0 = 1 1  G1 = 1 2  G2 = 1 3  G3 = 1 4  CIP = 1 5  G33 = 1 10  CT = 1 15  G34 = 1 16  G35 = 1 17
    G331 = 1 11  G332 = 1 12
    G4 = 2 1  G63 = 2 2  G74 = 2 3  G75 = 2 4
    TRANS = 3 1  ROT = 3 2  SCALE = 3 3  MIRROR = 3 4  ATRANS = 3 5  AROT = 3 6  ASCALE = 3 7  AMIRROR = 3 8
    G25 = 3 10  G26 = 3 11  G110 = 3 12  G111 = 3 13  G112 = 3 14  G58 = 3 15  G59 = 3 16
    FIFOCTRL = 4 3
    G18 = 6 2
    G40 = 7 1
    SUPD = 9 4
    G93 = 15 1  G95 = 15 3
    G70 = 13 1
    G91 = 14 2
    DIAMOF = 29 1  DIAMON = 29 2  DIAMCYCOF = 29 4
}

/// Addresses of more than one letter and those of one letter that are no axes. The value is a bit number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Address {
    F,
    T,
    D,
    I,
    J,
    K,
    I1,
    J1,
    K1,
    Cr,
    Ar,
    Ap,
    Rp,
    Turn,
    Rnd,
    Rndm,
    Chf,
    Chr,
    Frc,
    Frcm,
    Ang,
    Fb,
    Sf,
    Lims,
    Rpl,
    Fp,
    Spos,
    Sposa,
    Disc,
    Offn,
    Disr,
    Discl,
    Disrp,
    Fad,
    Dl,
    Toff,
    Toffl,
    Toffr,
    Tcarr,
    /// Priority of an interrupt.
    Prio,
    /// Feed, acceleration and tolerance of the path or an axis: of no account for the path itself.
    Dynamics,
}

/// Number of addresses.
pub(super) const ADDRESSES: usize = Address::Dynamics as usize + 1;

/// What a name means as a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Meaning {
    Axis(NamedAxis),
    Code(Code),
    Address(Address),
    /// `X1`, `Z1`: machine axes, in G74 and G75 only.
    Procedure(Procedure),
    /// `POS[X]=`, `AX[…]=`, `FA[X]=` …
    Indexed(Indexed),
    /// Not compiled.
    Known(&'static Known),
    Unknown,
}

/// Addresses that always have an index.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Indexed {
    /// An axis by a variable.
    Ax,
    Pos,
    /// POSA, POSP: moves beside the path.
    Posa,
    /// Feed of a positioning axis.
    Fa,
    /// Factor on the feed of an axis.
    Override,
    /// Acceleration and tolerance of an axis.
    Dynamics,
    /// `DIAMONA[X]` and its kin.
    DiameterOn,
    Diameter90,
    DiameterOff,
    DiameterChannel,
    /// The axis to which G96 refers.
    CutAxis,
    /// `PO[X]=` of polynomials.
    Polynomial,
}

/// Words of the language that are written like a call.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Procedure {
    /// Steers the control only: worth one note.
    NoEffect,
    /// Path accuracy and dynamics: worth one note.
    Dynamics,
    /// GWPSON
    WheelSpeed,
    Message,
    SetAlarm,
    SetMaster,
    /// Axis-free part of a multi-channel program.
    Channel,
    /// Interrupts.
    Interrupt,
    /// Files of the control.
    FileAccess,
    CallPath,
    ExecString,
    Return,
    /// `TRAFOOF`, `CYCLE800()`: ends what the compiler never lets begin.
    TransformationOff,
    Swivel,
    GeoAxes,
    EndLabel,
    DiameterChannel,
    /// Refused by name: what it is.
    Refused(&'static str),
}

/// Names that are refused, by what they are.
const REFUSED: &[(&str, &str)] = &[
    ("five-axis transformation", "TRAORI TRAFOON ORIRESET"),
    ("transformation", "TRANSMIT TRACYL TRAANG TRACON TRACOOF TRAINT"),
    (
        "axis coupling",
        "TRAILON TRAILOF LEADON LEADOF COUPDEF COUPDEL COUPON COUPONC COUPOF COUPOFS COUPRES EGDEF EGON EGONSYN EGONSYNE EGOFS EGOFC EGDEL TANG TANGON TANGOF TANGDEL TLIFT MASLON MASLOF MASLOFS MASLDEF MASLDEL CPON CPOF CPDEF CPDEL CPLON CPLOF CPLDEF CPLDEL GANTRY CTABDEF CTABEND CTABDEL",
    ),
    ("measuring", "MEAS MEAW MEASA MEAWA MEAC CMEAS MEAFRAME"),
    ("change of the zero point", "PRESETON PRESETONS PRESETOF"),
    ("contour preparation", "CONTPRON CONTDCON EXECTAB EXECUTE INTERSEC CALCDAT ISPOINTP"),
    ("fine tool offset", "PUTFTOC PUTFTOCF FCTDEF"),
    ("oscillation", "OSCILL OSP1 OSP2 OST1 OST2 OSCTRL OSNSC OSE OSB"),
    (
        "tool management",
        "SETPIECE GETSELT GETEXET GETFREELOC SETMTH MVTOOL DELTC CREATETOOL DELTOOL POSM SETTA SETTIA RESETMON TCA TCI NEWMT NEWT DELT GETT GETACTT GETACTTD SETDNO GETDNO DZERO DELDL",
    ),
    ("retraction", "POLF POLFMASK POLFMLIN ALF LIFTFAST"),
    ("protection zone", "CPROTDEF NPROTDEF EXECUTE CPROT NPROT PROTA PROTS PROTD"),
    ("motion synchronous to the cycle of the control", "RDISABLE STOPREOF DELDTG SYNFCT FTOC"),
];

const NO_EFFECT: &str = "STOPRE SBLON SBLOF DISPLOF DISPLON ACTBLOCNO SAVE PREPRO ICYCON ICYCOF IPTRLOCK IPTRUNLOCK BLSYNC \
    GROUP_BEGIN GROUP_END GROUP_ADDEND WORKPIECE NEWCONF WAITS WAITP SPCON SPCOF DRFOF DELAYFSTON DELAYFSTOF GWPSOF \
    EXTCLOSE EXTOPEN PROTOCOL STARTFIFO MMC FPRAOF AUXFUDEL AUXFUDELG AUXFUSYNC AUXFUMSEQ WAITENC";

const CHANNEL: &str = "INIT START WAITM WAITMC WAITE SETM CLEARM GET GETD RELEASE AXTOCHAN CLEAR";
const INTERRUPT: &str = "SETINT DISABLE ENABLE CLRINT CANCEL LOCK UNLOCK RESET";
const FILES: &str = "WRITE READ DELETE CHECKSUM FILEDATE FILETIME FILESIZE FILESTAT FILEINFO";
const DYNAMICS: &str = "FGROUP SOFTA BRISKA DRIVEA JERKA CYCLE832 COMPPATH IPOBRKA ADISPOSA";

const ADDRESS_NAMES: &[(&str, Address)] = &[
    ("I1", Address::I1),
    ("J1", Address::J1),
    ("K1", Address::K1),
    ("CR", Address::Cr),
    ("AR", Address::Ar),
    ("AP", Address::Ap),
    ("RP", Address::Rp),
    ("TURN", Address::Turn),
    ("RND", Address::Rnd),
    ("RNDM", Address::Rndm),
    ("CHF", Address::Chf),
    ("CHR", Address::Chr),
    ("FRC", Address::Frc),
    ("FRCM", Address::Frcm),
    ("ANG", Address::Ang),
    ("FB", Address::Fb),
    ("SF", Address::Sf),
    ("LIMS", Address::Lims),
    ("RPL", Address::Rpl),
    ("FP", Address::Fp),
    ("SPOS", Address::Spos),
    ("SPOSA", Address::Sposa),
    ("DISC", Address::Disc),
    ("OFFN", Address::Offn),
    ("DISR", Address::Disr),
    ("DISCL", Address::Discl),
    ("DISRP", Address::Disrp),
    ("FAD", Address::Fad),
    ("DL", Address::Dl),
    ("TOFF", Address::Toff),
    ("TOFFL", Address::Toffl),
    ("TOFFR", Address::Toffr),
    ("TCARR", Address::Tcarr),
    ("PRIO", Address::Prio),
    ("ADIS", Address::Dynamics),
    ("ADISPOS", Address::Dynamics),
    ("OVR", Address::Dynamics),
    ("OVRRAP", Address::Dynamics),
    ("CTOL", Address::Dynamics),
    ("OTOL", Address::Dynamics),
    ("DITS", Address::Dynamics),
    ("DITE", Address::Dynamics),
    ("STOLF", Address::Dynamics),
];

const INDEXED_NAMES: &[(&str, Indexed)] = &[
    ("AX", Indexed::Ax),
    ("POS", Indexed::Pos),
    ("POSA", Indexed::Posa),
    ("POSP", Indexed::Posa),
    ("FA", Indexed::Fa),
    ("ACC", Indexed::Dynamics),
    ("OVRA", Indexed::Override),
    ("VELOLIM", Indexed::Dynamics),
    ("JERKLIM", Indexed::Dynamics),
    ("ATOL", Indexed::Dynamics),
    ("FGREF", Indexed::Dynamics),
    ("FL", Indexed::Dynamics),
    ("VELOLIMA", Indexed::Dynamics),
    ("JERKLIMA", Indexed::Dynamics),
    ("ACCLIM", Indexed::Dynamics),
    ("ACCLIMA", Indexed::Dynamics),
    ("COARSEA", Indexed::Dynamics),
    ("FINEA", Indexed::Dynamics),
    ("IPOENDA", Indexed::Dynamics),
    ("SCPARA", Indexed::Dynamics),
    ("SCC", Indexed::CutAxis),
    ("DIAMONA", Indexed::DiameterOn),
    ("DIAM90A", Indexed::Diameter90),
    ("DIAMOFA", Indexed::DiameterOff),
    ("DIACYCOFA", Indexed::Dynamics),
    ("DIAMCHANA", Indexed::DiameterChannel),
    ("PO", Indexed::Polynomial),
];

/// Every word of the language by name.
pub(super) fn words() -> FxHashMap<&'static str, Meaning> {
    let mut map = FxHashMap::default();
    for (what, names) in REFUSED {
        for name in names.split(' ') {
            map.insert(name, Meaning::Procedure(Procedure::Refused(what)));
        }
    }
    for cycle in super::cycles::rows() {
        map.insert(cycle.signature.name, Meaning::Procedure(Procedure::Refused("machining cycle")));
    }
    let simple = [
        (NO_EFFECT, Procedure::NoEffect),
        (CHANNEL, Procedure::Channel),
        (INTERRUPT, Procedure::Interrupt),
        (FILES, Procedure::FileAccess),
        (DYNAMICS, Procedure::Dynamics),
        ("GWPSON", Procedure::WheelSpeed),
        ("MSG", Procedure::Message),
        ("SETAL", Procedure::SetAlarm),
        ("SETMS", Procedure::SetMaster),
        ("CALLPATH", Procedure::CallPath),
        ("EXECSTRING", Procedure::ExecString),
        ("RET", Procedure::Return),
        ("TRAFOOF", Procedure::TransformationOff),
        ("CYCLE800", Procedure::Swivel),
        ("GEOAX", Procedure::GeoAxes),
        ("ENDLABEL", Procedure::EndLabel),
        ("DIAMCHAN", Procedure::DiameterChannel),
    ];
    for (names, procedure) in simple {
        for name in names.split_ascii_whitespace() {
            map.insert(name, Meaning::Procedure(procedure));
        }
    }
    for (name, address) in ADDRESS_NAMES {
        map.insert(*name, Meaning::Address(*address));
    }
    for (name, indexed) in INDEXED_NAMES {
        map.insert(*name, Meaning::Indexed(*indexed));
    }
    for group in TABLE {
        for (index, name) in group.names.split(' ').enumerate() {
            map.insert(name, Meaning::Code(Code { group: group.number, index: index as u8 + 1 }));
        }
    }
    for row in KNOWN {
        for name in row.names.split(' ') {
            map.entry(name).or_insert(Meaning::Known(row));
        }
    }
    map
}

/// Every word that the compiler knows, with its G group if it is a code of one; in order.
pub fn all_words() -> Vec<(String, Option<u8>)> {
    let mut list: Vec<(String, Option<u8>)> = words()
        .into_iter()
        .filter(|(name, _)| *name != "-")
        .map(|(name, meaning)| match meaning {
            Meaning::Code(code) => (name.to_owned(), Some(code.group)),
            _ => (name.to_owned(), None),
        })
        .collect();
    list.sort();
    list
}

/// Largest G number.
const MOST_G: usize = 1000;

/// The G codes by number.
#[derive(Debug)]
pub(super) struct GCodes {
    codes: Box<[Option<Code>]>,
}

impl GCodes {
    pub fn new() -> GCodes {
        let mut codes = vec![None; MOST_G].into_boxed_slice();
        for group in TABLE {
            for (index, name) in group.names.split(' ').enumerate() {
                if let Some(number) = name.strip_prefix('G').and_then(|digits| digits.parse::<usize>().ok()) {
                    codes[number] = Some(Code { group: group.number, index: index as u8 + 1 });
                }
            }
        }
        for number in FIRST_LONG..=LAST_LONG {
            let index = INDEX_OF_FIRST_LONG + (number - FIRST_LONG) as u8;
            codes[number as usize] = Some(Code { group: 8, index });
        }
        GCodes { codes }
    }

    #[inline]
    pub fn get(&self, number: f64) -> Option<Code> {
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
    fn groups_and_indices() {
        let codes = GCodes::new();
        assert_eq!(codes.get(0.0), Some(Code::G0));
        assert_eq!(codes.get(33.0), Some(Code::G33));
        assert_eq!(codes.get(505.0), Some(Code { group: 8, index: 6 }));
        assert_eq!(codes.get(599.0), Some(Code { group: 8, index: 100 }));
        assert_eq!(size(8), 100);
        assert_eq!(codes.get(997.0), None);
        assert_eq!(word(Code::CT), "CT");
        assert_eq!(word(Code { group: 8, index: 7 }), "G506");
        assert_eq!(words().get("DIAMON"), Some(&Meaning::Code(Code::DIAMON)));
    }
}
