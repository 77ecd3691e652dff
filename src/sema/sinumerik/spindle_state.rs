//! What the spindles were told: the master, and those that are not.

use std::collections::BTreeMap;

use crate::ir::function::Turn;
use crate::text::Span;

/// The spindle that the target turns when no number is said, and the master of the control at the start.
pub(super) const MAIN_SPINDLE: u8 = 1;

/// What a spindle was told.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Told {
    speed: Option<f64>,
    /// Sense of rotation, while it turns.
    turn: Option<Turn>,
    /// LIMS.
    limit: Option<f64>,
    /// G26 S.
    highest: Option<f64>,
    /// It was under G96, and got no speed since.
    kept: bool,
}

/// How the speed of the master counts.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
enum Counts {
    /// Turns per minute.
    #[default]
    Turns,
    /// G96: metres per minute.
    Cutting,
    /// G97 took over the speed that G96 had given, and no S has named one since.
    Kept,
}

/// The spindles of the channel.
#[derive(Debug, Clone)]
pub(super) struct Spindles {
    master: u8,
    now: Told,
    counts: Counts,
    /// Speed of the master that was printed, within its limits.
    turns: Option<f64>,
    /// Where the master was stopped by SPOS, degrees.
    angle: Option<f64>,
    /// G96 waits for its S.
    cut_speed_open: Option<Span>,
    others: BTreeMap<u8, Told>,
}

impl Default for Spindles {
    fn default() -> Spindles {
        Spindles {
            master: MAIN_SPINDLE,
            now: Told::default(),
            counts: Counts::Turns,
            turns: None,
            angle: None,
            cut_speed_open: None,
            others: BTreeMap::new(),
        }
    }
}

impl Spindles {
    #[inline]
    pub fn master(&self) -> u8 {
        self.master
    }

    /// Does a word of this spindle, or of none, go to the master?
    pub fn is_master(&self, spindle: Option<u8>) -> bool {
        spindle.is_none_or(|n| n == self.master)
    }

    /// S of the master: turns or metres per minute.
    pub fn speed(&self) -> Option<f64> {
        self.now.speed
    }

    /// The turns per minute of a spindle, if they are fixed.
    pub fn fixed_turns(&self, spindle: Option<u8>) -> Option<f64> {
        match spindle {
            Some(n) if n != self.master => self.others.get(&n).and_then(|told| told.speed),
            _ => self.turns.or(self.now.speed).filter(|_| !self.is_cutting()),
        }
    }

    /// The master turns.
    pub fn turn(&self) -> Option<Turn> {
        self.now.turn
    }

    pub fn turns(&self) -> Option<f64> {
        self.turns
    }

    pub fn angle(&self) -> Option<f64> {
        self.angle
    }

    /// The speed of the master is a cutting speed, or was one and is not named anew.
    #[inline]
    pub fn is_cutting(&self) -> bool {
        self.counts != Counts::Turns
    }

    /// The master keeps the speed that it had under G96.
    #[inline]
    pub fn keeps_speed(&self) -> bool {
        self.counts == Counts::Kept
    }

    /// It does so while it turns, at a speed that is not known.
    #[inline]
    pub fn turns_unknown(&self) -> bool {
        self.keeps_speed() && self.now.turn.is_some() && self.turns.is_none()
    }

    /// Did spindle `n` get no speed since G96?
    pub fn kept_by(&self, n: u8) -> bool {
        match self.others.get(&n) {
            Some(told) if n != self.master => told.kept,
            _ => n == self.master && self.keeps_speed(),
        }
    }

    /// The limit of the master's cutting speed.
    pub fn limit(&self) -> Option<f64> {
        [self.now.limit, self.now.highest].into_iter().flatten().reduce(f64::min)
    }

    /// The limit of the master's turns: LIMS counts under G97 only.
    pub fn limit_of_turns(&self, lims_counts: bool) -> Option<f64> {
        if lims_counts { self.limit() } else { self.now.highest }
    }

    // Words.

    pub fn set_cutting_speed(&mut self, speed: f64) {
        (self.now.speed, self.counts) = (Some(speed), Counts::Cutting);
    }

    /// S of the master in turns, and as it is printed.
    pub fn set_turns(&mut self, speed: f64, printed: f64) {
        (self.now.speed, self.counts, self.turns) = (Some(speed), Counts::Turns, Some(printed));
    }

    /// Another speed is printed for the same S.
    pub fn print_turns(&mut self, printed: f64) {
        self.turns = Some(printed);
    }

    /// S of a spindle that is not the master. Returns its highest speed.
    pub fn set_speed_of(&mut self, n: u8, speed: f64) -> Option<f64> {
        let told = self.others.entry(n).or_default();
        (told.speed, told.kept) = (Some(speed), false);
        told.highest
    }

    /// What S says counts as turns from here on.
    pub fn end_cutting_speed(&mut self) {
        self.counts = Counts::Turns;
    }

    /// G97 without S: the spindle goes on as it turns.
    pub fn keep_speed(&mut self) {
        self.counts = Counts::Kept;
    }

    /// The speed that goes on is not known.
    pub fn forget_turns(&mut self) {
        self.turns = None;
    }

    pub fn set_turn(&mut self, turn: Option<Turn>) {
        self.now.turn = turn;
    }

    pub fn set_turn_of(&mut self, n: u8, turn: Option<Turn>) {
        self.others.entry(n).or_default().turn = turn;
    }

    /// SPOS: the master stands at an angle.
    pub fn stop_at(&mut self, angle: f64) {
        (self.angle, self.now.turn) = (Some(angle), None);
    }

    pub fn forget_angle(&mut self) {
        self.angle = None;
    }

    /// LIMS
    pub fn set_limit(&mut self, n: Option<u8>, limit: f64) {
        self.told(n).limit = Some(limit);
    }

    /// G26 S
    pub fn set_highest(&mut self, n: Option<u8>, highest: f64) {
        self.told(n).highest = Some(highest);
    }

    fn told(&mut self, n: Option<u8>) -> &mut Told {
        match n {
            Some(n) if n != self.master => self.others.entry(n).or_default(),
            _ => &mut self.now,
        }
    }

    /// SETMS: words without a number go to spindle `n`.
    pub fn select_master(&mut self, n: u8) {
        let cutting = self.is_cutting();
        let old = Told { speed: self.now.speed.filter(|_| !cutting), kept: cutting, ..self.now };
        self.others.insert(self.master, old);
        self.now = self.others.remove(&n).unwrap_or_default();
        self.counts = if std::mem::take(&mut self.now.kept) { Counts::Kept } else { Counts::Turns };
        self.master = n;
        (self.angle, self.turns) = (None, None);
    }

    /// G96 came without S.
    pub fn open_cut_speed(&mut self, span: Span) {
        self.cut_speed_open.get_or_insert(span);
    }

    pub fn waits_for_cut_speed(&self) -> bool {
        self.cut_speed_open.is_some()
    }

    /// True once, where G96 still waits for its S.
    pub fn close_cut_speed(&mut self) -> bool {
        self.cut_speed_open.take().is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_master_brings_what_it_was_told() {
        let mut spindles = Spindles::default();
        spindles.set_turns(1000.0, 800.0);
        spindles.set_turn(Some(Turn::Clockwise));
        assert_eq!(spindles.set_speed_of(2, 500.0), None);
        spindles.select_master(2);
        assert_eq!((spindles.master(), spindles.speed(), spindles.turn()), (2, Some(500.0), None));
        assert_eq!(spindles.turns(), None);
        assert_eq!(spindles.fixed_turns(Some(1)), Some(1000.0));
        spindles.select_master(1);
        assert_eq!((spindles.speed(), spindles.turn()), (Some(1000.0), Some(Turn::Clockwise)));
    }

    #[test]
    fn a_cutting_speed_is_no_speed_of_a_spindle_that_is_not_the_master() {
        let mut spindles = Spindles::default();
        spindles.set_cutting_speed(200.0);
        assert_eq!((spindles.is_cutting(), spindles.fixed_turns(None)), (true, None));
        spindles.select_master(2);
        assert!(spindles.kept_by(1) && !spindles.is_cutting());
        spindles.select_master(1);
        assert_eq!((spindles.speed(), spindles.keeps_speed()), (None, true));
    }

    #[test]
    fn the_limit_of_turns_counts_lims_only_where_it_counts() {
        let mut spindles = Spindles::default();
        spindles.set_limit(None, 2000.0);
        assert_eq!((spindles.limit_of_turns(true), spindles.limit_of_turns(false)), (Some(2000.0), None));
        spindles.set_highest(Some(1), 1500.0);
        assert_eq!((spindles.limit(), spindles.limit_of_turns(false)), (Some(1500.0), Some(1500.0)));
        spindles.set_highest(Some(2), 900.0);
        assert_eq!((spindles.limit(), spindles.set_speed_of(2, 1.0)), (Some(1500.0), Some(900.0)));
    }

    #[test]
    fn g96_waits_for_its_speed_once() {
        let mut spindles = Spindles::default();
        spindles.open_cut_speed(Span::default());
        assert!(spindles.close_cut_speed());
        assert!(!spindles.close_cut_speed());
    }
}
