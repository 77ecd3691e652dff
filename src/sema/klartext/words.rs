//! The words of a path block, evaluated once and sorted by what they mean.

use crate::diag::codes;
use crate::geo::Plane;
use crate::ir::{Pos, Side};
use crate::lexer::klartext::Value;
use crate::machine::AxisSet;
use crate::parser::klartext::ast::{Addr, Word};
use crate::sema::common::plane::plane_axes;
use crate::text::Span;

use super::m_table::Args;
use super::{Core, Outcome};

/// Which words a head admits.
#[derive(Debug, Clone, Copy)]
pub(super) struct Admits(u16);

impl Admits {
    pub const AXES: Admits = Admits(1);
    pub const POLAR: Admits = Admits(2);
    /// A radius word with a value.
    pub const RADIUS: Admits = Admits(4);
    pub const TURN: Admits = Admits(8);
    /// R0, RL, RR.
    pub const COMP: Admits = Admits(16);
    /// R+, R-.
    pub const PARAXIAL: Admits = Admits(32);
    pub const FEED: Admits = Admits(64);
    pub const M: Admits = Admits(128);
    /// A number without address.
    pub const NUMBER: Admits = Admits(256);
    pub const SPEED: Admits = Admits(512);

    /// A path block.
    pub const PATH: Admits = Admits::AXES.and(Admits::COMP).and(Admits::FEED).and(Admits::M).and(Admits::SPEED);

    pub const fn and(self, other: Admits) -> Admits {
        Admits(self.0 | other.0)
    }

    pub fn has(self, other: Admits) -> bool {
        self.0 & other.0 != 0
    }

    /// Does a block with these words take `word`?
    pub fn takes(self, word: &Word) -> bool {
        match word.addr {
            Addr::Axis { .. } => self.has(Admits::AXES),
            Addr::Feed | Addr::FeedMax | Addr::FeedAuto | Addr::FeedPerRev | Addr::FeedOther => self.has(Admits::FEED),
            Addr::M(_) => self.has(Admits::M),
            Addr::FeedEmpty | Addr::MEmpty | Addr::RadiusEmpty => true,
            Addr::PolarRadius { .. } | Addr::PolarAngle { .. } => self.has(Admits::POLAR),
            Addr::Radius { signed: false } if word.value == Value::Number(0.0) => {
                self.has(Admits::COMP) || self.has(Admits::RADIUS)
            }
            Addr::Radius { .. } => self.has(Admits::RADIUS),
            Addr::CompLeft | Addr::CompRight => self.has(Admits::COMP),
            Addr::ParaxialPlus | Addr::ParaxialMinus => self.has(Admits::PARAXIAL),
            Addr::TurnPlus | Addr::TurnMinus => self.has(Admits::TURN),
            Addr::Speed => self.has(Admits::SPEED),
            Addr::Value => self.has(Admits::NUMBER),
            _ => false,
        }
    }
}

/// What a block says about radius compensation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Comp {
    Side(Side),
    /// R+ (true) or R-.
    Paraxial(bool),
}

/// What a block says about the feed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) enum FeedWord {
    #[default]
    None,
    /// As written, in the unit of the control.
    Value(f64),
    Max,
    Auto,
    PerRevolution(f64),
    PerTooth(f64),
}

/// An M function with what it takes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct MWord {
    pub number: u32,
    pub span: Span,
    pub args: Args,
}

/// Most M functions of a block.
pub(super) const MOST_M: usize = 8;

/// The evaluated words; lengths in mm, angles in degrees. Kept in a box that goes from block to block.
#[derive(Debug, Clone, Default)]
pub(super) struct Words {
    /// Value of each axis word, absolute or incremental.
    pub axes: Pos,
    pub incremental: AxisSet,
    /// From the first axis word to the last.
    pub axes_span: Span,
    /// Value, incremental.
    pub polar_radius: Option<(f64, bool)>,
    pub polar_radius_span: Span,
    pub polar_angle: Option<(f64, bool)>,
    pub polar_angle_span: Span,
    pub radius: Option<f64>,
    pub radius_span: Span,
    /// Counter-clockwise.
    pub turn: Option<bool>,
    pub comp: Option<Comp>,
    pub comp_span: Span,
    pub feed: FeedWord,
    pub feed_span: Span,
    pub speed: Option<f64>,
    pub speed_span: Span,
    pub number: Option<f64>,
    pub m: Vec<MWord>,
}

impl Words {
    pub fn clear(&mut self) {
        self.axes.clear();
        self.incremental = AxisSet::EMPTY;
        self.axes_span = Span::default();
        self.polar_radius = None;
        self.polar_angle = None;
        self.radius = None;
        self.turn = None;
        self.comp = None;
        self.feed = FeedWord::None;
        self.speed = None;
        self.number = None;
        self.m.clear();
    }

    pub fn m(&self) -> &[MWord] {
        &self.m
    }

    pub fn has_m(&self, number: u32) -> bool {
        self.m().iter().any(|m| m.number == number)
    }

    /// The first of these M functions in the block.
    pub fn any_m(&self, numbers: &[u32]) -> Option<&MWord> {
        self.m().iter().find(|m| numbers.contains(&m.number))
    }

    /// Refuses M functions that say how or where a block moves, in a block that does not.
    pub fn forbid_m(&self, core: &Core<'_>, head: &str, numbers: &[u32]) -> Outcome {
        let Some(m) = self.any_m(numbers) else { return Ok(()) };
        core.refuse(m.span, codes::P1003::m_has_no_place_in_block(&m.number, &head))
    }

    /// Axes of the plane have no place beside a polar end.
    pub fn forbid_plane_axes(&self, core: &Core<'_>, plane: Plane, function: &str) -> Outcome {
        if self.axes.known().common(plane_axes(plane)).is_empty() {
            return Ok(());
        }
        core.refuse(self.axes_span, codes::P1003::takes_its_end_from_pr(&function))
    }

    /// CT and CTP are arcs of the plane: no other axis can move along.
    pub fn flat(&self, core: &Core<'_>, plane: Plane, function: &str) -> Outcome {
        if self.axes.known().without(plane_axes(plane)).is_empty() {
            return Ok(());
        }
        core.refuse(self.axes_span, codes::P1003::is_arc_in_plane(&function))
    }
}
