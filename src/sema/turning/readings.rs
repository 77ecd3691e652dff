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
    /// The reading in use, and what settles it: a key of `[control]` where there is one.
    pub fn fault(self) -> Fault {
        let settled = |asking: Asking, key| asking.answer(Answer::key("control", key));
        match self {
            Question::ThreadLeft => settled(codes::T8001::left_is_ahead_of_cut(), "thread_left"),
            Question::ThreadFace => settled(codes::T8002::face_is_taken_from_edge(), "thread_face"),
            Question::SimpleThread => settled(codes::T8003::words_of_g32_are_read(), "simple_thread"),
            Question::Infeed => settled(codes::T8004::infeed_is_taken_as_radius(), "infeed"),
            Question::LineAngle => settled(codes::T8005::angle_counts_from_minus_z(), "line_angle"),
            Question::ArcChoice => settled(codes::T8006::q0_is_near_solution(), "turning_arc_q"),
            Question::UndercutLimit => settled(codes::T8007::table_has_no_row_for_diameter(), "undercut_limit"),
            Question::UndercutSide => codes::T8008::side_is_taken_from_edge(),
            Question::ContourWords => settled(codes::T8009::words_of_g80_are_read(), "contour_words"),
            Question::RecessBlank => settled(codes::T8010::ri_counts_on_diameter(), "recess_blank"),
            Question::TurningDepth => settled(codes::T8011::compensation_lifts_tool(), "turning_depth"),
            Question::OffsetOneWay => settled(codes::T8012::offset_width_has_no_effect(), "offset_one_way"),
            Question::RecessDepth => settled(codes::T8013::incremental_i_counts_on_diameter(), "recess_depth"),
            Question::RecessWidth => settled(codes::T8014::k_is_width_of_opening(), "recess_width"),
            Question::RecessOversize => settled(codes::T8015::oversize_is_left_on_floor_and_walls(), "recess_oversize"),
            Question::BlankContour => codes::T8016::blank_is_drawn_as_contour(),
            Question::NosePath => codes::T8019::ends_of_compensation_are_partcs(),
            Question::FinishingSide => codes::T8018::side_is_taken_from_tool(),
        }
    }

    /// Did the configuration decide it?
    pub fn is_settled(self, settings: &Settings) -> bool {
        let set = &settings.control.turning;
        match self {
            Question::ThreadLeft => set.left_is_plus.is_some(),
            Question::ThreadFace => set.rear_face.is_some(),
            Question::SimpleThread => set.refuse_simple_thread.is_some(),
            Question::Infeed => set.infeed.is_some(),
            Question::LineAngle => set.angle_from_plus.is_some(),
            Question::ArcChoice => set.arc_choice.is_some(),
            Question::UndercutLimit => set.undercut_upper.is_some(),
            Question::ContourWords => set.refuse_contour_words.is_some(),
            Question::RecessBlank => set.recess_blank.is_some(),
            Question::TurningDepth => set.towards_floor.is_some(),
            Question::OffsetOneWay => set.offset_one_way.is_some(),
            Question::RecessDepth => set.recess_depth.is_some(),
            Question::RecessWidth => set.recess_width.is_some(),
            Question::RecessOversize => set.oversize_on_floor.is_some(),
            Question::UndercutSide | Question::BlankContour | Question::FinishingSide | Question::NosePath => false,
        }
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
        if !question.is_settled(self.job.settings) {
            self.say_once(place, question.fault());
        }
    }
}
