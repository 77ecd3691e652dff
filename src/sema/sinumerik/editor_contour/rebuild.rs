//! Contours of the contour editor of which only the records are left: their blocks are made anew.

use crate::diag::{Answer, Fault, Help, codes};
use crate::ir::contour::{Arc, ArcShape, Blocks, Corner, CornerShape, Path};
use crate::ir::undercut::Surface;
use crate::ir::{Feed, Pos};
use crate::machine::Axis;
use crate::parser::sinumerik::records::Record;
use crate::sema::run::Where;

use super::super::corners::modal_corner_feed;
use super::super::diameter::Diameter;
use super::super::g_groups::GCode;
use super::super::words::Words;
use super::super::{Channel, Core, Outcome, State};
use super::made::{Contour, ContourBlock, CornerWord};
use super::{Stored, TOLERANCE};

impl Channel<'_> {
    /// What holds where the blocks are missing must be what the editor would have written into them.
    pub(super) fn can_be_rebuilt(&mut self, stored: &Stored) -> Outcome {
        let here = self.core.here.origin;
        self.core.here.origin.loc = stored.begin;
        let result = self
            .pending_must_be_done(Where::Block)
            .and_then(|()| self.core.accept(Where::Block, diameters_are_told(&self.core, &self.st, stored)))
            .and_then(|()| self.core.accept(Where::Block, no_state_beside(&self.st, stored)));
        self.core.here.origin = here;
        result
    }

    /// The blocks of a contour of which only the records are left.
    pub(super) fn rebuild(&mut self, made: &Contour, stored: &Stored, unit: f64) -> Outcome {
        let plane = self.st.plane();
        self.core.say_once(Where::Block, codes::S8028::blocks_of_stored_contour_are_missing());
        if unit != 1.0 {
            let found = codes::S8160::records_of_this_contour_are_read().at(stored.begin);
            self.core.report(found.help("no contour of inches is known to us: compare its size with the drawing"));
        }
        // As in blocks: a contour without elements needs no feed.
        let feed = match made.blocks.is_empty() {
            true => None,
            false => Some(self.cutting_feed(&mut Words::new())?),
        };
        let modal_feed = if self.st.corners.rounding() > 0.0 || made.blocks.iter().any(|block| block.corner.is_some()) {
            modal_corner_feed(&self.core, &self.st)?
        } else {
            None
        };
        let here = self.core.here.origin;
        self.core.tell_of_records(made, stored);
        self.core.stand_at(stored, made.start_record);
        self.st.codes.activate(GCode::G0);
        self.tapping_ends();
        self.st.threads.end_chain();
        self.st.compensation.begins_no_more();
        self.st.corners.open.close();
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(plane, made.start);
        self.send(&end, Path::Rapid);
        if let Some(feed) = feed {
            for block in &made.blocks {
                self.rebuild_block(block, stored, unit, feed, modal_feed);
            }
        }
        self.core.here.origin = here;
        Ok(())
    }

    fn rebuild_block(
        &mut self,
        block: &ContourBlock,
        stored: &Stored,
        unit: f64,
        feed: Feed,
        modal_feed: Option<Feed>,
    ) {
        let plane = self.st.plane();
        self.core.stand_at(stored, block.record);
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(plane, block.end);
        // The code holds on behind the contour, as that of a block does.
        let (code, path) = match block.arc {
            Some((center, ccw)) => {
                let shape = ArcShape::Center { center, ccw, tol: 2.0 * TOLERANCE * unit };
                (if ccw { GCode::G3 } else { GCode::G2 }, Path::Arc(Arc { plane, shape, turns: 0 }, feed))
            }
            None => (GCode::G1, Path::Line(feed)),
        };
        self.st.codes.activate(code);
        self.st.corners.open.close();
        self.send(&end, path);
        let (shape, modal) = match block.corner {
            Some(CornerWord::Radius(radius)) if radius > 0.0 => (CornerShape::Rounding { radius }, false),
            Some(CornerWord::Chamfer(side)) if side > 0.0 => (CornerShape::Chamfer { side }, false),
            Some(CornerWord::Undercut(undercut)) => (CornerShape::Undercut(undercut), false),
            _ if self.st.corners.rounding() > 0.0 => {
                (CornerShape::Rounding { radius: self.st.corners.rounding() }, true)
            }
            _ => return,
        };
        if !modal {
            self.core.stand_at(stored, block.corner_record);
        }
        self.send_corner(Some(Corner {
            shape,
            feed: if matches!(shape, CornerShape::Undercut(_)) { None } else { modal_feed },
            early: true,
            modal,
            large: self.core.large_corner(),
            at_arc: self.core.arc_chamfer(),
            blocks: Blocks::PassedOver,
        }));
    }
}

/// The plane block of the editor says DIAM90 for turning and DIAMOF for milling, and the header which it was.
fn diameters_are_told(core: &Core<'_>, st: &State, stored: &Stored) -> Result<(), Fault> {
    let [first, second, _] = st.roles();
    let on = st.diameter_mode() != Diameter::Off;
    let turned = stored.records.iter().find_map(|record| match record {
        Record::Header { turned, .. } => *turned,
        _ => None,
    });
    if on && core.is_diameter_axis(first) {
        let what = format!("{} counts in diameters, which its records never do", first.letter());
        return Err(not_rebuilt(&what, "program DIAMOF before the contour"));
    }
    let across = second == Axis::X || core.is_diameter_axis(second);
    let wanted = across && turned.unwrap_or_else(|| core.is_diameter_axis(second));
    let taken = on && core.is_diameter_axis(second);
    if stored.diameter_said || wanted == taken {
        return Ok(());
    }
    let (what, help): (&str, Help) = if wanted && core.job.settings.machine.diameter_axis.is_none() {
        (
            "the editor writes turned contours in diameters (DIAM90), and no diameter axis is configured",
            Answer::key("machine", "diameter_axis").help("set `[machine] diameter_axis = \"X\"`"),
        )
    } else if wanted {
        (
            "the editor writes turned contours in diameters (DIAM90), and DIAMOF is in force",
            "program DIAM90 before the contour; where its values are radii, DIAMOF inside of it".into(),
        )
    } else {
        (
            "the editor writes milled contours with DIAMOF, and diameters are in force",
            "program DIAMOF before the contour".into(),
        )
    };
    Err(not_rebuilt(what, help))
}

/// What would act on each block of the contour, and is not made for records.
fn no_state_beside(st: &State, stored: &Stored) -> Result<(), Fault> {
    if st.modal_call.is_on() {
        return Err(not_rebuilt("a modal call is active", "end it by MCALL before the contour"));
    }
    let off = st.tool.is_without_offset();
    if off && !st.describes {
        return Err(not_rebuilt("under D0 its points count without the tool", "select D1 before the contour"));
    }
    if st.offsets.in_machine() {
        return Err(not_rebuilt("G500 is in force", "select a work offset before the contour"));
    }
    let undercut = stored.records.iter().any(|record| matches!(record, Record::Undercut(_)));
    if undercut && st.corners.rounding() != 0.0 {
        return Err(not_rebuilt(
            "RNDM is in force and would round the edges of its undercut",
            "program RNDM=0 before the contour",
        ));
    }
    if undercut && st.corners.feed().is_some() {
        return Err(not_rebuilt(
            "FRCM is in force and is the feed of the roundings of its undercut alone",
            "program FRCM=0 before the contour",
        ));
    }
    Ok(())
}

impl Core<'_> {
    /// What follows comes from a record.
    fn stand_at(&mut self, stored: &Stored, record: usize) {
        if let Some(place) = stored.place_of_record(record) {
            self.here.origin.loc = place;
        }
    }

    /// What of the contour is a choice of ours or rests on facts that are not confirmed.
    fn tell_of_records(&mut self, made: &Contour, stored: &Stored) {
        for record in &made.chosen {
            self.stand_at(stored, *record);
            let found = codes::S8030::this_record_leaves_two_solutions().at(self.here.origin.loc);
            self.report(found.help("compare the element with the drawing"));
        }
        if let Some(record) = made.start_undercut {
            self.stand_at(stored, record);
            let found = codes::S8161::contour_starts_with_undercut().at(self.here.origin.loc);
            self.report(found.help("compare the start of the contour with the drawing"));
        }
        let doubted = |record: usize| made.doubts.iter().find(|(at, _)| *at == record).map(|(_, doubts)| doubts);
        for (record, surface) in &made.assumed {
            self.stand_at(stored, *record);
            let side = match surface {
                Surface::External => "outside on the part",
                Surface::Internal => "in a bore",
            };
            // A second note at this place would not be seen.
            let facts = doubted(*record).map(|doubts| format!("; not confirmed is {doubts}")).unwrap_or_default();
            self.report(codes::S8022::contour_does_not_tell_side_of_material(&side, &facts).at(self.here.origin.loc));
        }
        for (record, doubts) in made.doubts.iter().filter(|(at, _)| !made.assumed.iter().any(|(told, _)| told == at)) {
            self.stand_at(stored, *record);
            self.say_once(Where::Block, codes::S8022::undercut_rests_on_facts_that_are_not(&doubts));
        }
    }
}

/// Why the blocks of a contour are not made from its records.
fn not_rebuilt(what: &str, help: impl Into<Help>) -> Fault {
    codes::S9019::contour_has_no_blocks_and_they_are_not(&what).help(help)
}
