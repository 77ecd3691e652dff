//! Feed: the words, their unit, M103, and what a block means where only rotary axes move.
//!
//! Source: K 1.8 and 2.14 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::compensation::FeedAt;
use crate::ir::{Feed, Pos};
use crate::machine::{Axis, AxisSet, Unit};
use crate::parser::klartext::ast::{Addr, Block};
use crate::sema::common::feed::{FeedKind, ModalFeed};
use crate::text::{Loc, Span};

use super::words::{FeedWord, Words};
use super::{Outcome, Reported, Run};

/// Feed words in an INCH program count tenths of an inch.
const INCH_FEED: f64 = 25.4 / 10.0;

/// Feed per revolution in mm above which a feed per minute was meant.
const MOST_PER_REVOLUTION: f64 = 10.0;

/// The feed of a TOOL CALL.
#[derive(Debug, Clone, Copy)]
pub(super) struct ToolFeed {
    pub feed: Feed,
    /// The number as written.
    pub written: f64,
    /// FU or FZ, which count revolutions whatever M136 says.
    pub by_word: bool,
    /// FZ.
    pub per_tooth: bool,
}

impl ToolFeed {
    fn minutes(feed: f64) -> ToolFeed {
        ToolFeed { feed: Feed::PerMinute(feed), written: feed, by_word: false, per_tooth: false }
    }
}

/// What F and its M functions say.
#[derive(Debug, Clone, Copy)]
pub(super) struct FeedState {
    modal: ModalFeed,
    /// Number of the feed word in force, as written: what a move of rotary axes alone takes as degrees.
    written: f64,
    /// F of the last TOOL CALL.
    of_tool: Option<ToolFeed>,
    /// The feed in force is one of FZ, which counts the teeth of the tool in the spindle.
    per_tooth: bool,
    /// A program that is left out stands between F and here.
    of_before_call: bool,
    /// M103: highest share of the feed in the negative tool axis.
    plunge_share: Option<f64>,
    /// M116: feed of rotary axes at the surface.
    pub at_surface: bool,
    /// Where F counts on compensated arcs: M109, M110.
    pub at: FeedAt,
    /// The last positioning block went at rapid traverse.
    pub last_rapid: bool,
    /// What is in force, or missing, is the feed at the start.
    is_of_start: bool,
}

impl FeedState {
    pub fn new(feed: Option<f64>) -> FeedState {
        FeedState {
            modal: ModalFeed::new(feed, Some(FeedKind::PerMinute)),
            written: feed.unwrap_or_default(),
            of_tool: feed.map(ToolFeed::minutes),
            per_tooth: false,
            of_before_call: false,
            plunge_share: None,
            at_surface: false,
            at: FeedAt::Centre,
            last_rapid: false,
            is_of_start: true,
        }
    }

    #[inline]
    pub fn word(&self) -> Option<Feed> {
        self.modal.word()
    }

    pub fn is_per_revolution(&self) -> bool {
        self.modal.is_per_revolution()
    }

    /// A feed word as it counts now.
    pub fn counted(&self, value: f64, inch: bool) -> Feed {
        if self.is_per_revolution() {
            return Feed::PerRevolution(value);
        }
        Feed::PerMinute(if inch { value * INCH_FEED } else { value })
    }

    /// Was it meant per minute, and counts per revolution?
    pub fn is_large(&self, value: f64) -> bool {
        self.is_per_revolution() && value > MOST_PER_REVOLUTION
    }

    #[inline]
    pub fn plunge_share(&self) -> Option<f64> {
        self.plunge_share
    }

    /// F of the last TOOL CALL.
    pub fn of_tool(&self) -> Option<ToolFeed> {
        self.of_tool
    }

    /// F, with the number as written.
    pub fn program(&mut self, feed: Feed, written: f64) {
        self.modal.program(feed);
        self.written = written;
        self.per_tooth = false;
        self.of_before_call = false;
        self.is_of_start = false;
    }

    /// F of a TOOL CALL: it holds until another one is programmed, in a block or a TOOL CALL.
    pub fn program_of_tool(&mut self, feed: ToolFeed) {
        self.of_tool = Some(feed);
        self.program(feed.feed, feed.written);
        self.per_tooth = feed.per_tooth;
    }

    /// Another tool, with teeth of its own: a feed of FZ holds no longer.
    pub fn change_teeth(&mut self) {
        if self.per_tooth {
            self.modal = ModalFeed::new(None, Some(FeedKind::per_revolution(self.modal.is_per_revolution())));
            self.per_tooth = false;
        }
    }

    /// A TOOL CALL without F.
    pub fn reset_of_tool(&mut self, feed: Option<f64>) {
        self.of_tool = feed.map(ToolFeed::minutes);
    }

    /// A cycle that is left out leaves a feed that is not known.
    pub fn forget(&mut self) {
        self.modal = ModalFeed::new(None, Some(FeedKind::per_revolution(self.modal.is_per_revolution())));
        self.per_tooth = false;
        self.of_before_call = false;
        self.is_of_start = false;
    }

    /// A program is left out that may leave another feed.
    pub fn left_by_call(&mut self) {
        self.of_before_call = true;
    }

    /// That the feed is one of before such a call was said.
    pub fn took_left(&mut self) {
        self.of_before_call = false;
    }

    /// Does such a program stand between F and here?
    #[inline]
    pub fn is_of_before_call(&self) -> bool {
        self.of_before_call
    }

    /// Feeds do not count: one that is missing is not worth a report.
    pub fn presume(&mut self) {
        self.modal.presume();
    }

    /// M136 and M137
    pub fn switch(&mut self, per_revolution: bool) {
        self.is_of_start &= !per_revolution && !self.modal.is_per_revolution();
        self.modal.switch(FeedKind::per_revolution(per_revolution));
    }

    /// M103
    pub fn share_plunges(&mut self, share: Option<f64>) {
        self.plunge_share = share;
    }
}

impl Run<'_> {
    pub(super) fn set_feed(&mut self, w: &Words) -> Outcome {
        if self.is_capturing() {
            self.feed_in_contour(w);
            return Ok(());
        }
        let mm = self.core.level().frame.unit.mm();
        let (feed, written) = match w.feed {
            FeedWord::None | FeedWord::Max => return Ok(()),
            FeedWord::Value(f) => {
                self.large_per_revolution(self.core.loc(w.feed_span), f);
                (self.feed_of(f), f)
            }
            FeedWord::PerRevolution(f) => (Feed::PerRevolution(f), f / mm),
            FeedWord::PerTooth(f) => {
                let feed = self.feed_of_teeth(f, w.feed_span)?;
                (feed, feed.value() / mm)
            }
            FeedWord::Auto => match self.st.feed.of_tool {
                Some(ToolFeed { feed: Feed::PerMinute(_), .. }) if self.st.feed.is_per_revolution() => {
                    return self.core.refuse(w.feed_span, codes::K2003::f_of_last_tool_call_counts());
                }
                Some(ToolFeed { feed: Feed::PerRevolution(_), by_word: false, .. })
                    if !self.st.feed.is_per_revolution() =>
                {
                    return self.core.refuse(w.feed_span, codes::K2003::f_of_last_tool_call_counts_per());
                }
                Some(feed) => (feed.feed, feed.written),
                None => {
                    return self.core.refuse(
                        w.feed_span,
                        codes::K2003::last_tool_call_has_no_f().answer(Answer::key("control", "feed")),
                    );
                }
            },
        };
        if feed.value() <= 0.0 {
            return self.feed_not_positive(w.feed_span, written);
        }
        self.st.feed.program(feed, written);
        self.st.feed.per_tooth = match w.feed {
            FeedWord::PerTooth(_) => true,
            FeedWord::Auto => self.st.feed.of_tool.is_some_and(|feed| feed.per_tooth),
            _ => false,
        };
        Ok(())
    }

    /// FZ: `feed` mm for each tooth of the tool in the spindle.
    pub(super) fn feed_of_teeth(&mut self, feed: f64, span: Span) -> Outcome<Feed> {
        let Some(tool) = self.st.tool.active() else {
            return self.core.refuse(span, codes::K9013::fz_is_feed_per_tooth_and_no());
        };
        if let Some(teeth) = tool.teeth {
            return Ok(Feed::PerRevolution(feed * f64::from(teeth)));
        }
        let called = &tool.called;
        self.core.refuse(span, codes::K9013::fz_is_feed_per_tooth(&called).answer(Answer::tool(called, "teeth")))
    }

    /// M136 makes a feed that was meant per minute count per revolution.
    pub(super) fn large_per_revolution(&self, loc: Loc, feed: f64) {
        if self.st.feed.is_large(feed) {
            self.core.report(codes::K2013::under_m136_this_feed_is_mm_per(&feed).at(loc));
        }
    }

    #[cold]
    pub(super) fn feed_not_positive<T>(&mut self, span: Span, value: f64) -> Outcome<T> {
        let text = self.word_text(span);
        let what = if text.contains(['Q', 'q']) { format!("`{text}` is {value}") } else { format!("`{text}`") };
        self.core.refuse(span, codes::O1001::feed_has_to_be_above_zero(&what))
    }

    /// A feed word in the unit and mode in force.
    pub(super) fn feed_of(&mut self, value: f64) -> Feed {
        let inch = self.core.level().frame.unit == Unit::Inch;
        self.st.feed.counted(value, inch)
    }

    /// Feed of a move that cuts; `None` for rapid traverse.
    #[inline]
    pub(super) fn move_feed(&mut self, w: &Words) -> Outcome<Option<Feed>> {
        if w.feed == FeedWord::Max && !self.is_capturing() {
            return Ok(None);
        }
        self.feed_in_force().map(Some)
    }

    /// The feed that holds on, for a cut.
    #[inline]
    pub(super) fn feed_in_force(&mut self) -> Outcome<Feed> {
        match self.feed_before() {
            Some(feed) => Ok(feed),
            None => self.feed_missing(),
        }
    }

    /// The same where a cut may need none.
    #[inline]
    pub(super) fn feed_before(&mut self) -> Option<Feed> {
        if self.st.feed.is_of_before_call() {
            self.says_feed_of_before();
        }
        self.st.feed.word()
    }

    #[cold]
    pub(super) fn feed_missing<T>(&mut self) -> Outcome<T> {
        let usual = "program F in this block, in an earlier one, or in the TOOL CALL";
        let help = match self.st.feed.is_of_start {
            true => Answer::key("control", "feed")
                .help(format!("{usual}; a contour by itself takes the feed at the start, `[control] feed`")),
            false => usual.into(),
        };
        if !self.feed_is_lost_by_call() {
            self.core
                .report(codes::P2002::no_feed_rate_is_programmed_before().at(self.core.here.origin.loc).help(help));
        }
        // One report is enough.
        self.st.feed.modal.presume();
        Err(Reported)
    }

    /// A block with a feed word was refused: that a feed is missing afterwards is not worth another error.
    #[cold]
    pub(super) fn lose_feed(&mut self, block: &Block) {
        let feeds = block.words.iter().any(|word| matches!(word.addr, Addr::Feed | Addr::FeedAuto | Addr::FeedPerRev));
        if feeds {
            self.st.feed.modal.presume();
        }
    }

    /// M103: the feed component into the workpiece is limited.
    ///
    /// `in_plane` is the length of an arc; without it the way is straight.
    #[inline]
    pub(super) fn plunge_feed(
        &mut self,
        w: &Words,
        feed: Option<Feed>,
        end: &Pos,
        in_plane: Option<f64>,
    ) -> Option<Feed> {
        feed.map(|feed| self.plunged(w, feed, end, in_plane))
    }

    /// The same for a move that cuts.
    #[inline]
    pub(super) fn plunged(&mut self, w: &Words, feed: Feed, end: &Pos, in_plane: Option<f64>) -> Feed {
        match self.st.feed.plunge_share() {
            Some(share) => self.shared_feed(w, feed, share, end, in_plane),
            None => feed,
        }
    }

    #[cold]
    fn shared_feed(&mut self, w: &Words, feed: Feed, share: f64, end: &Pos, in_plane: Option<f64>) -> Feed {
        let tool_axis = self.st.axis();
        if end.get(tool_axis).is_none() {
            return feed;
        }
        let mut step = nalgebra::Vector3::zeros();
        let mut open = AxisSet::EMPTY;
        for axis in AxisSet::MAIN.iter() {
            match (end.get(axis), self.st.position.get(axis)) {
                (Some(to), Some(from)) => step[axis.index()] = to - from,
                (Some(_), None) => open.insert(axis),
                (None, _) => {}
            }
        }
        // Which way is down, and how long the way is, counts on the workpiece.
        let linear = *self.st.ctx.frame.linear();
        let real = linear * step;
        let down = real[tool_axis.index()];
        if open.contains(tool_axis) || (down < 0.0 && !open.is_empty()) {
            self.core
                .report(codes::K2709::start_of_this_move_is_not_known(&(share * 100.0)).at(self.core.loc(w.axes_span)));
            return feed.with_value(feed.value() * share);
        }
        if down >= 0.0 {
            return feed;
        }
        let way = match in_plane {
            Some(length) => {
                let (first, ..) = self.st.plane().axes();
                libm::hypot(length * linear.column(first).norm(), down)
            }
            None => real.norm(),
        };
        feed.with_value((feed.value() * share * way / -down).min(feed.value()))
    }

    /// Where only rotary axes move, F counts degrees per minute, whatever the unit of the program.
    #[inline]
    pub(super) fn rotary_only_feed(&mut self, feed: Option<Feed>, end: &Pos) -> Option<Feed> {
        let feed = feed?;
        if self.core.level().frame.unit == Unit::Mm || end.known().without(AxisSet::MAIN).is_empty() {
            return Some(feed);
        }
        let linear = |axis: &Axis| !axis.is_rotary() && self.st.position.get(*axis) != end.get(*axis);
        Some(if end.known().iter().any(|axis| linear(&axis)) { feed } else { feed.with_value(self.st.feed.written) })
    }
}
