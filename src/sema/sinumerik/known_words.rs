//! Words of the language that are not compiled: what they are, and what to do about them.
//!
//! A word that is built stands in `vocabulary`. Source: S 1.3, 2, 3, 5 and 6 (docs/sources.md).

use crate::diag::{Fault, codes};

/// Words of one kind.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Known {
    pub names: &'static str,
    /// What they do.
    pub what: &'static str,
    /// What to do instead.
    pub help: &'static str,
    /// Left out, the path would be another one.
    pub moves: bool,
}

impl Known {
    /// What is wrong with `word`, which is one of them.
    pub fn not_compiled(&self, word: &str) -> Fault {
        codes::S9132::is_not_compiled(&word, &self.what).help(self.help)
    }
}

const fn known(names: &'static str, what: &'static str, help: &'static str) -> Known {
    Known { names, what, help, moves: false }
}

const fn moving(names: &'static str, what: &'static str, help: &'static str) -> Known {
    Known { names, what, help, moves: true }
}

const PLAIN_AXES: &str = "have the CAM system put out lines and arcs in X, Y and Z";
const FROM_THE_MACHINE: &str = "leave it out, and set the target up for it where it matters";
const BY_ITSELF: &str = "compile the program without it; what it does has no word on the target";

pub(super) static KNOWN: &[Known] = &[
    // Feeds.
    known("FZ", "the feed per tooth", "program the feed per turn: F = FZ · number of teeth, under G95"),
    known(
        "FPR FPRAON",
        "the feed per turn of another axis or spindle",
        "program the feed by G94 or G95 of the master spindle",
    ),
    known("FDA FD", "the feed of the handwheel", "leave it out: the handwheel is the operator's"),
    known("FFD FGROUPS FPO", "the course of the feed as a polynomial", "program F in the blocks"),
    known(
        "SCC",
        "the axis to whose diameter G96 refers",
        "leave it out where it names the axis of `[machine] diameter_axis`",
    ),
    known(
        "SVC",
        "the cutting speed of a milling tool",
        "program S in turns per minute: S = 1000 · SVC / (3.1416 · diameter)",
    ),
    known("SPINU", "the number of a spindle", "write the number of the spindle itself: M2=3, S2=500"),
    known("PFAD FLIM", "a limit of the feed", BY_ITSELF),
    // Tools.
    moving("CUTMOD CUTMODK", "the turning of tool data with the plane", BY_ITSELF),
    moving(
        "TOFFON TOFFOF ISD",
        "an offset or insertion depth of the tool in its own direction",
        "put the length into the tool data",
    ),
    known(
        "TOOLENV DELTOOLENV GETTENV GETTCOR SETTCOR LENTOAX",
        "tool data read or kept as a whole",
        "read the single values: $TC_DP3[t,d]",
    ),
    known(
        "TML TMON TMOF TOOLGNT TOOLGT MULTITOOL",
        "tool monitoring and tool carriers",
        "leave it out: the target manages its tools",
    ),
    moving("ADAPTTRAFO TCARRS", "an orientable tool carrier", PLAIN_AXES),
    moving("GFRAME0 GFRAME", "a frame of the grinding wheel", BY_ITSELF),
    known(
        "PREWEAR WEARON WEAROF GWPS GWPSOFF",
        "wear and peripheral speed of a grinding wheel",
        "program S, and the wear in the tool data",
    ),
    // Axes beside the path.
    moving(
        "FXST FXSW FXS FOC FOCON FOCOF",
        "travel to a fixed stop with a force",
        "move the axis by an M function of the target",
    ),
    moving(
        "MOV OS OSCILL OSCTRL OSNSC OSP1 OSP2 OST1 OST2 OSE OSB",
        "an axis that moves beside the path",
        "program its moves as blocks of the program",
    ),
    moving("AXCTSWE AXCTSWED AXCTSWEC", "a change of containers of axes", BY_ITSELF),
    known("SETTIA SETTA", "a task of the tool management", BY_ITSELF),
    moving(
        "CPON CPOF CPDEF CPDEL CPLON CPLOF CPLDEF CPLDEL CPRES CPLNUM CPLDEN CPLPOS CPLSETVAL CPFPOS CPFRS CPMPRT CPMRESET CPMSTART CPSETTYPE",
        "a coupling of axes",
        "compile the program for uncoupled axes",
    ),
    moving(
        "CTAB CTABINV CTABSSV CTABSEV CTABLOCK CTABUNLOCK CTABID CTABEXISTS CTABNO CTABDEF CTABEND CTABDEL",
        "a curve table of coupled axes",
        "compile the program for uncoupled axes",
    ),
    moving(
        "CAC CIC CDC CACP CACN",
        "a place of an indexing table, whose angles are machine data",
        "program the angle itself: C=DC(90)",
    ),
    moving(
        "DILF POLF ALF IR JR KR",
        "a thread on an arc or with a lift-off",
        "program the thread by G33, and the retraction as a block after it",
    ),
    known("ESRR ESRS", "a stop and retraction when something fails", FROM_THE_MACHINE),
    moving("MEASA MEAWA MEAC MEASF", "measuring with a probe", BY_ITSELF),
    // Orientation and transformations.
    moving("STAT TU", "the position of joints for PTP travel", "program the positions of the axes"),
    moving(
        "LEAD TILT THETA NUT PSI PHI PHIX ORIANGLE XH YH ZH AN3 BN3 CN3 AN4 BN4 CN4 AN5 BN5 CN5 PLFX ORISOLH",
        "the orientation of the tool",
        PLAIN_AXES,
    ),
    moving("TRANSMITK TRAFOON TRAFILTER", "a transformation", PLAIN_AXES),
    moving("CROTS ROTFRAME", "a frame by solid angles", "use CROT with angles about the axes"),
    moving("CLGON CLGOF CLALIM", "centreless grinding", BY_ITSELF),
    // Splines, polynomials and their neighbours.
    moving("PL PW SD", "a word of splines and polynomials", PLAIN_AXES),
    moving("GP", "a point with attributes", "program the axis word itself"),
    // Punching.
    moving("SPN SPP PUNCHACC", "division of a line for punching", "program the positions of the strokes"),
    // Data of drives, channels and the control.
    known("DRVPRD DRVPWR", "data of a drive", FROM_THE_MACHINE),
    known("QFK CORROF CORRTRAFO CORRTC", "corrections of the machine", FROM_THE_MACHINE),
    known("PROTSOFF COLLPAIR CPROTON CADEL", "protection zones and collision monitoring", FROM_THE_MACHINE),
    moving(
        "SYNFCT SYNFCTOF",
        "a function of synchronized actions",
        "leave the action out, or replace it by blocks of the program",
    ),
    moving("AXRESET AXSTART", "a restart of axes", FROM_THE_MACHINE),
];
