//! The arguments of a call, read by the names of their parameters.

use crate::sema::cycle::row::{Name, Parameter};
use crate::text::Span;

use super::super::value::{Val, to_text, whole};
use super::table::Cycle;

/// A parameter as the code names it. The lists of the manuals have most names with and without `_` in front; they are one
/// name here.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) struct Key(pub(super) &'static str);

macro_rules! keys {
    ($($name:ident)*) => {
        $(pub(super) const $name: Key = Key(stringify!($name));)*
        /// All of them.
        #[cfg(test)]
        pub(super) const ALL: &[Key] = &[$($name),*];
    };
}

keys! {
    AD AFSL AMODE ANG1 ANG2 AP1 AP2 APP AS1 AS2 AXN BL CDIAM CDIR CON CONR CPA CPO CRAD D DAM DBH DI DIAG DIAG1 DIAG2
    DIAGM DIATH DIS1 DIS2 DM1 DM2 DM3 DM4 DMODE DN DP DP1 DPR DR DT DTB DTD DTS DXY ENC EP EPD EPL ER EW F FAL FAL1
    FAL2 FALD FALX FALZ FDEP FDIS FDP FDP1 FDPR FF1 FF2 FF3 FFCP FFD FFP FFP1 FFP2 FFR FORM FPD FPL FR FRF FS FZ GDEP
    GMODE GST GUD H1 HIDE IANG IDEP IDEP1 IFLANK INDA KDIAM KNAME LAB1 LAB2 LAGE LENG LIM LP1 LP2 MDEP MID MIDA MIDF
    MPIT NID NPP NR NRC NSP NT NUM NUM1 NUM2 NUMT NUMTH PA PIT PIT1 PITA PITI PO PO1 PO2 PO3 PO4 POSS PP1 PP2 PP3 PRAD
    PTABA R1 R2 RAD RAD1 RC RCI1 RCI2 RCO1 RCO2 RF1 RF2 RF3 RFF RFP RL ROP RP RPA RPAP RPO RTP SC SDAC SDIR SDIS SDR
    SPCA SPCO SPD SPL SS2 SSF SST SST1 STA STA1 STA2 SV1 SV2 SWL S_FA S_FB S_FD S_XRS S_ZA S_ZD TDEP TECHNO TR TYPE
    TYPTH U U1 UX UXY UZ VARI VRT WID WIDG WIDG2 XA XB XD XS YA YS Z0 Z1 ZA ZB ZD ZPD ZPL
}

/// What a call gives, and the cycle whose parameters these are.
#[derive(Debug, Clone)]
pub(in super::super) struct Arguments {
    pub cycle: &'static Cycle,
    /// The call.
    pub span: Span,
    pub list: Vec<(Val, Span)>,
}

impl Cycle {
    /// The place of a parameter, counted from 1 as the manuals do.
    pub(super) fn place(&self, key: Key) -> Option<usize> {
        let at = self.signature.parameters.iter().position(|parameter| match parameter.name {
            Name::Word(name) => name.strip_prefix('_').unwrap_or(name) == key.0,
            Name::Q(_) | Name::Part(_) | Name::In(..) => false,
        });
        at.map(|at| at + 1)
    }

    pub(super) fn parameter(&self, key: Key) -> Option<&'static Parameter> {
        self.signature.parameters.get(self.place(key)? - 1)
    }
}

impl Arguments {
    pub fn name(&self) -> &'static str {
        self.cycle.signature.name
    }

    pub fn place(&self, key: Key) -> usize {
        self.cycle.place(key).unwrap_or(0)
    }

    /// The parameter as the list of the cycle writes it.
    pub fn written(&self, key: Key) -> String {
        self.cycle.parameter(key).map_or_else(String::new, |parameter| parameter.name.to_string())
    }

    /// What was given; `None` for an empty or missing argument, and for a parameter that the cycle does not have.
    pub fn value(&self, key: Key) -> Option<&(Val, Span)> {
        self.list.get(self.cycle.place(key)? - 1).filter(|(value, _)| *value != Val::Missing)
    }

    /// The call, where nothing was given.
    pub fn span_of(&self, key: Key) -> Span {
        self.value(key).map_or(self.span, |(_, span)| *span)
    }

    pub fn number(&self, key: Key) -> Option<f64> {
        self.value(key).and_then(|(value, _)| value.number())
    }

    pub fn or_zero(&self, key: Key) -> f64 {
        self.number(key).unwrap_or(0.0)
    }

    /// The first of them that was given below 0.
    pub fn below_zero(&self, keys: &[Key]) -> Option<Key> {
        keys.iter().copied().find(|key| self.or_zero(*key) < 0.0)
    }

    pub fn text(&self, key: Key) -> Option<String> {
        let (value, _) = self.value(key)?;
        let text = to_text(value)?;
        Some(String::from_utf8_lossy(&text).trim().to_ascii_uppercase())
    }

    /// A decimal digit of a coded number, from the right: 0 is the units.
    pub fn digit(&self, key: Key, position: u32) -> i32 {
        let value = self.number(key).and_then(whole).unwrap_or(0);
        value.unsigned_abs().checked_div(10u32.saturating_pow(position)).map_or(0, |v| (v % 10) as i32)
    }
}
