//! The words of the language, as tables: G groups, addresses, procedures, functions.
//!
//! Source: S 1.3, 2.14, 3, 5 and 6; group numbers and internal indices as `$P_GG` returns
//! them.

use crate::diag::{self};

use super::axis_names::NamedAxis;
use super::g_groups::GCode;
use super::known_words::Known;

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
    Code(GCode),
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
    /// CANCEL and its kin: synchronized actions.
    Actions,
    /// Files of the control.
    FileAccess,
    CallPath,
    ExecString,
    Return,
    /// `TRANSMIT`, `TRACYL`
    Transformation(OnSurface),
    TransformationOff,
    Swivel,
    GeoAxes,
    EndLabel,
    DiameterChannel,
    /// Refused by name: what it is.
    Refused(Refusal),
}

/// What a transformation works on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum OnSurface {
    Face,
    Mantle,
}

impl OnSurface {
    pub fn word(self) -> &'static str {
        match self {
            OnSurface::Face => "TRANSMIT",
            OnSurface::Mantle => "TRACYL",
        }
    }
}

/// Why a name is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Refusal {
    /// What it is.
    pub what: &'static str,
    pub code: &'static diag::Code,
    /// Left out, the path would be another one.
    pub moves: bool,
}

/// Names of transformations, by what they are.
pub(super) const TRANSFORMATIONS: &[(&str, &str)] =
    &[("five-axis transformation", "TRAORI TRAFOON ORIRESET"), ("transformation", "TRAANG TRACON TRACOOF TRAINT")];

/// Names that are refused, by what they are.
pub(super) const REFUSED: &[(&str, &str)] = &[
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

/// What of these moves nothing and places nothing.
pub(super) const WITHOUT_MOVES: &[&str] = &["tool management", "retraction", "protection zone"];

pub(super) const NO_EFFECT: &str = "STOPRE SBLON SBLOF DISPLOF DISPLON ACTBLOCNO SAVE PREPRO ICYCON ICYCOF IPTRLOCK IPTRUNLOCK BLSYNC \
    GROUP_BEGIN GROUP_END GROUP_ADDEND WORKPIECE NEWCONF WAITS WAITP SPCON SPCOF DRFOF DELAYFSTON DELAYFSTOF GWPSOF \
    EXTCLOSE EXTOPEN PROTOCOL STARTFIFO MMC FPRAOF AUXFUDEL AUXFUDELG AUXFUSYNC AUXFUMSEQ WAITENC";

pub(super) const CHANNEL: &str = "INIT START WAITM WAITMC WAITE SETM CLEARM GET GETD RELEASE AXTOCHAN CLEAR";
pub(super) const INTERRUPT: &str = "SETINT DISABLE ENABLE CLRINT";
pub(super) const ACTIONS: &str = "CANCEL LOCK UNLOCK RESET";
pub(super) const FILES: &str = "WRITE READ DELETE CHECKSUM FILEDATE FILETIME FILESIZE FILESTAT FILEINFO";
pub(super) const DYNAMICS: &str = "FGROUP SOFTA BRISKA DRIVEA JERKA CYCLE832 COMPPATH IPOBRKA ADISPOSA";

pub(super) const ADDRESS_NAMES: &[(&str, Address)] = &[
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

pub(super) const INDEXED_NAMES: &[(&str, Indexed)] = &[
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
