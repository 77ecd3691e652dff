//! Feed: the words, their unit, M103, and what a block means where only rotary axes move.
//!
//! Source: K 1.8 and 2.14 (docs/sources.md).

use crate::diag::{Answer, Label, codes};
use crate::ir::compensation::FeedAt;
use crate::ir::{Feed, Pos, Side};
use crate::machine::{Axis, AxisSet, Unit};
use crate::parser::klartext::ast::{Addr, Block};
use crate::sema::common::feed::{FeedKind, ModalFeed};
use crate::sema::common::position::Position;
use crate::sema::run::Where;
use crate::text::{Loc, Span};

use super::active_tool::ToolState;
use super::words::{FeedWord, MWord, Words};
use super::{Core, Outcome, Reported};

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
#[derive(Debug, Clone)]
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
    /// A program that is left out and may have left another feed.
    left: Option<Box<FeedLeft>>,
    /// A contour is described: its feeds do not count.
    described: bool,
}

/// A call that is left out, where nothing says what feed it leaves.
#[derive(Debug, Clone)]
struct FeedLeft {
    name: String,
    /// The entry of `[programs]` that would say it.
    key: String,
    call: Loc,
    /// The feed that it leaves is another one, and not known.
    lost: bool,
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
            left: None,
            described: false,
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
    #[inline]
    pub fn counted(&self, value: f64, unit: Unit) -> Feed {
        if self.is_per_revolution() {
            return Feed::PerRevolution(value);
        }
        Feed::PerMinute(if unit == Unit::Inch { value * INCH_FEED } else { value })
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

    /// The program `name`, which `[programs]` knows as `key`, is left out at `call`: it may leave another feed, or leaves one that
    /// is not known.
    pub fn left_by_call(&mut self, name: &str, key: String, call: Loc, lost: bool) {
        if lost {
            self.modal = ModalFeed::new(None, Some(FeedKind::per_revolution(self.modal.is_per_revolution())));
            self.per_tooth = false;
            self.is_of_start = false;
        }
        self.of_before_call = true;
        self.left = Some(Box::new(FeedLeft { name: name.to_owned(), key, call, lost }));
    }

    /// Does such a program stand between F and here?
    #[inline]
    pub fn is_of_before_call(&self) -> bool {
        self.of_before_call
    }

    /// A contour is described from here on: its feeds do not count, and one that is missing is not worth a report.
    pub fn describe(&mut self) {
        self.modal.presume();
        self.plunge_share = None;
        self.described = true;
    }

    /// M136 and M137
    pub fn switch(&mut self, per_revolution: bool) {
        self.is_of_start &= !per_revolution && !self.modal.is_per_revolution();
        self.modal.switch(FeedKind::per_revolution(per_revolution));
    }
}

impl FeedState {
    /// F of a block in force from here on. Feeds in a contour that is described do not count.
    pub fn take(&mut self, core: &Core<'_>, tool: &ToolState, w: &Words) -> Outcome {
        let mm = core.mm();
        let (feed, written) = match w.feed {
            FeedWord::None | FeedWord::Max => return Ok(()),
            FeedWord::Value(f) => {
                self.warn_of_large(core, w.feed_span, f);
                (self.counted(f, core.unit()), f)
            }
            FeedWord::PerRevolution(f) => (Feed::PerRevolution(f), f / mm),
            FeedWord::PerTooth(f) => {
                let feed = tool.feed_of_teeth(core, f, w.feed_span)?;
                (feed, feed.value() / mm)
            }
            FeedWord::Auto => self.of_last_call(core, w.feed_span)?,
        };
        if feed.value() <= 0.0 {
            return core.feed_not_positive(w.feed_span, written);
        }
        self.program(feed, written);
        self.per_tooth = match w.feed {
            FeedWord::PerTooth(_) => true,
            FeedWord::Auto => self.of_tool.is_some_and(|feed| feed.per_tooth),
            _ => false,
        };
        Ok(())
    }

    /// F AUTO: the feed of the last TOOL CALL, which has to count as feeds do now.
    fn of_last_call(&self, core: &Core<'_>, span: Span) -> Outcome<(Feed, f64)> {
        let fault = match self.of_tool {
            Some(ToolFeed { feed: Feed::PerMinute(_), .. }) if self.is_per_revolution() => {
                codes::K2003::f_of_last_tool_call_counts()
            }
            Some(ToolFeed { feed: Feed::PerRevolution(_), by_word: false, .. }) if !self.is_per_revolution() => {
                codes::K2003::f_of_last_tool_call_counts_per()
            }
            Some(feed) => return Ok((feed.feed, feed.written)),
            None => codes::K2003::last_tool_call_has_no_f().answer(Answer::key("control", "feed")),
        };
        core.refuse(span, fault)
    }

    /// M136 makes a feed that was meant per minute count per revolution.
    pub fn warn_of_large(&self, core: &Core<'_>, span: Span, feed: f64) {
        if self.is_large(feed) {
            core.say(span, codes::K2013::under_m136_this_feed_is_mm_per(&feed));
        }
    }

    /// Feed of a move that cuts; `None` for rapid traverse.
    #[inline]
    pub fn of_move(&mut self, core: &Core<'_>, w: &Words) -> Outcome<Option<Feed>> {
        if w.feed == FeedWord::Max && !self.described {
            return Ok(None);
        }
        self.in_force(core).map(Some)
    }

    /// Feed of an arc. Plain G-code has no arc at rapid traverse: FMAX needs a number.
    pub fn of_arc(&mut self, core: &Core<'_>, w: &Words) -> Outcome<Feed> {
        if let Some(feed) = self.of_move(core, w)? {
            return Ok(feed);
        }
        match core.job.settings.control.rapid_feed {
            Some(feed) => Ok(Feed::PerMinute(feed)),
            None => core.refuse(
                w.feed_span,
                codes::K9019::arc_at_fmax_has_no_counterpart().answer(Answer::key("control", "rapid_feed")),
            ),
        }
    }

    /// The feed that holds on, for a cut.
    #[inline]
    pub fn in_force(&mut self, core: &Core<'_>) -> Outcome<Feed> {
        match self.before(core) {
            Some(feed) => Ok(feed),
            None => self.missing(core),
        }
    }

    /// The same where a cut may need none.
    #[inline]
    pub fn before(&mut self, core: &Core<'_>) -> Option<Feed> {
        if self.of_before_call {
            self.says_feed_of_before(core);
        }
        self.word()
    }

    #[cold]
    pub fn missing<T>(&mut self, core: &Core<'_>) -> Outcome<T> {
        let usual = "program F in this block, in an earlier one, or in the TOOL CALL";
        let help = match self.is_of_start {
            true => Answer::key("control", "feed")
                .help(format!("{usual}; a contour by itself takes the feed at the start, `[control] feed`")),
            false => usual.into(),
        };
        if !self.is_lost_by_call(core) {
            core.say_here(codes::P2002::no_feed_rate_is_programmed_before().help(help));
        }
        // One report is enough.
        self.modal.presume();
        Err(Reported)
    }

    /// The first cut after a program that is left out takes the feed of before its call.
    #[cold]
    fn says_feed_of_before(&mut self, core: &Core<'_>) {
        if self.described {
            return;
        }
        let Some(left) = self.left.take_if(|left| !left.lost) else { return };
        self.of_before_call = false;
        let found = codes::K2414::this_cut_takes_feed_of_before(&left.name, &left.key);
        core.report_once(found.at(core.here.origin.loc).also(left.call, Label::Call));
    }

    /// Says of a cut without a feed that a program which is left out leaves one that is not known.
    fn is_lost_by_call(&mut self, core: &Core<'_>) -> bool {
        let Some(left) = self.left.take_if(|left| left.lost) else { return false };
        if self.of_before_call {
            let found = codes::P2002::leaves_feed_that_is_not_known(&left.name).at(core.here.origin.loc);
            core.report(found.also(left.call, Label::Call));
        }
        self.of_before_call
    }

    /// A block with a feed word was refused: that a feed is missing afterwards is not worth another error.
    #[cold]
    pub fn lose(&mut self, block: &Block) {
        let feeds = block.words.iter().any(|word| matches!(word.addr, Addr::Feed | Addr::FeedAuto | Addr::FeedPerRev));
        if feeds {
            self.modal.presume();
        }
    }

    /// M103: plunges run at a share of the feed. False where it switches off what is not on.
    pub fn share_plunges(&mut self, core: &Core<'_>, m: &MWord) -> Outcome<bool> {
        if let Some(share) = m.args.feed
            && !(share > 0.0 && share <= 100.0)
        {
            return core.refuse(m.span, codes::K2707::m103_f_is_no_share_of_feed(&share));
        }
        let acts = m.args.feed.is_some() || self.plunge_share.is_some();
        self.plunge_share = m.args.feed.map(|percent| percent / 100.0);
        Ok(acts)
    }

    /// Refuses M109 and M110 on an arc that the target compensates.
    pub fn check_edge(&self, core: &Core<'_>, side: Side) -> Outcome {
        if self.at == FeedAt::Centre || side == Side::None || core.computes_path() {
            return Ok(());
        }
        core.refuse(Where::Block, codes::K9008::m109_m110_change_feed_on_compensated_arcs())
    }

    /// Refuses M109 and M110 on the arc of APPR or DEP: it is no element of the contour.
    pub fn no_edge(&self, core: &Core<'_>, side: Side) -> Outcome {
        if self.at == FeedAt::Centre || side == Side::None {
            return Ok(());
        }
        core.refuse(Where::Block, codes::K9008::what_m109())
    }

    /// Where only rotary axes move, F counts degrees per minute, whatever the unit of the program.
    #[inline]
    pub fn of_rotary(&self, feed: Option<Feed>, end: &Pos, position: &Position, unit: Unit) -> Option<Feed> {
        let feed = feed?;
        if unit == Unit::Mm || end.known().without(AxisSet::MAIN).is_empty() {
            return Some(feed);
        }
        let linear = |axis: &Axis| !axis.is_rotary() && position.get(*axis) != end.get(*axis);
        Some(if end.known().iter().any(|axis| linear(&axis)) { feed } else { feed.with_value(self.written) })
    }
}
