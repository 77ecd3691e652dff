//! What no available manual settles: the reading in use, and a word about it where a program depends on it.
//!
//! Each question has an option of `[control]`; whoever sets it has decided, and hears nothing. Source: reference
//! section 16.

use std::fmt::Display;

use crate::diag::fault::Asking;
use crate::diag::{Answer, Fault, codes};
use crate::machine::Settings;
use crate::sema::run::Where;

use super::Core;
use super::words::Words;

/// A question that the manuals leave open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Question {
    ThreadLeft,
    ThreadFace,
    SimpleThread,
    Infeed,
    LineAngle,
    ArcChoice,
    UndercutLimit,
    UndercutSide,
    ContourWords,
    RecessBlank,
    TurningDepth,
    OffsetOneWay,
    RecessDepth,
    RecessWidth,
    RecessOversize,
    BlankContour,
    FinishingSide,
    NosePath,
}

impl Question {
    /// The reading in use, and what settles it: a key of `[control]` where there is one. None where the configuration decided it.
    pub fn open(self, settings: &Settings) -> Option<Fault> {
        use Question::*;
        let set = &settings.control.turning;
        let (is_set, asking, key): (bool, fn() -> Asking, &str) = match self {
            ThreadLeft => (set.left_is_plus.is_some(), codes::T8001::left_is_ahead_of_cut, "thread_left"),
            ThreadFace => (set.rear_face.is_some(), codes::T8002::face_is_taken_from_edge, "thread_face"),
            SimpleThread => (set.refuse_simple_thread.is_some(), codes::T8003::words_of_g32_are_read, "simple_thread"),
            Infeed => (set.infeed.is_some(), codes::T8004::infeed_is_taken_as_radius, "infeed"),
            LineAngle => (set.angle_from_plus.is_some(), codes::T8005::angle_counts_from_minus_z, "line_angle"),
            ArcChoice => (set.arc_choice.is_some(), codes::T8006::q0_is_near_solution, "turning_arc_q"),
            UndercutLimit => {
                (set.undercut_upper.is_some(), codes::T8007::table_has_no_row_for_diameter, "undercut_limit")
            }
            UndercutSide => return Some(codes::T8008::side_is_taken_from_edge()),
            ContourWords => (set.refuse_contour_words.is_some(), codes::T8009::words_of_g80_are_read, "contour_words"),
            RecessBlank => (set.recess_blank.is_some(), codes::T8010::ri_counts_on_diameter, "recess_blank"),
            TurningDepth => (set.towards_floor.is_some(), codes::T8011::compensation_lifts_tool, "turning_depth"),
            OffsetOneWay => (set.offset_one_way.is_some(), codes::T8012::offset_width_has_no_effect, "offset_one_way"),
            RecessDepth => (set.recess_depth.is_some(), codes::T8013::incremental_i_counts_on_diameter, "recess_depth"),
            RecessWidth => (set.recess_width.is_some(), codes::T8014::k_is_width_of_opening, "recess_width"),
            RecessOversize => {
                (set.oversize_on_floor.is_some(), codes::T8015::oversize_is_left_on_floor_and_walls, "recess_oversize")
            }
            BlankContour => return Some(codes::T8016::blank_is_drawn_as_contour()),
            FinishingSide => return Some(codes::T8018::side_is_taken_from_tool()),
            NosePath => return Some(codes::T8019::ends_of_compensation_are_partcs()),
        };
        (!is_set).then(|| asking().answer(Answer::key("control", key)))
    }
}

impl Core<'_> {
    /// A word of the block that changes nothing here: worth a note, as no word goes in silence.
    pub(super) fn without_effect(&self, w: &Words, letters: &[u8], idle: fn(&dyn Display) -> Fault) {
        for letter in letters {
            if let Some(num) = w.get(*letter) {
                self.say(num.span, idle(&(*letter as char)));
            }
        }
    }

    /// The block depends on `question`: the first one of the program says so.
    pub(super) fn depends_on(&self, question: Question, place: impl Into<Where>) {
        if let Some(fault) = question.open(self.job.settings) {
            self.say_once(place, fault);
        }
    }
}
