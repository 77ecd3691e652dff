//! A stored contour while its blocks run: what they do is noted, to be held against the records behind them.

use crate::diag::codes;
use crate::geo::Point2;
use crate::ir::Pos;
use crate::ir::contour::{ArcShape, Corner, CornerShape, Path};
use crate::machine::AxisSet;
use crate::parser::sinumerik::records::Record;
use crate::sema::common::position::Position;
use crate::text::Loc;

use super::super::diameter::Diameter;
use super::super::tangent::Heading;
use super::super::{Core, Outcome, Reported, State};
use super::generate::MOST_RECORDS;
use super::made::{ContourBlock, CornerWord, Written};

/// Most blocks of a contour that are compared: an undercut is one record and four of them.
pub(super) const MOST_BLOCKS: usize = 4 * MOST_RECORDS;

/// A stored contour while its blocks run.
#[derive(Debug, Clone)]
pub(in super::super) struct Stored {
    pub(super) start: Option<Point2>,
    pub(super) blocks: Vec<ContourBlock>,
    /// Where each block stands.
    pub(super) places: Vec<Loc>,
    /// Centre of the arc that is on its way as it was programmed, before it is fitted to start and end.
    pub(super) centre: Option<Point2>,
    /// The first element that runs at rapid traverse.
    pub(super) rapid: Option<usize>,
    pub(super) records: Vec<Record>,
    /// Where each record stands.
    pub(super) record_places: Vec<Loc>,
    pub(super) begin: Loc,
    /// Lengths across the part are diameters, and in which unit they are: what holds in front of the block of the start
    /// point, which the editor wrote; words that were added there or behind it do not change what the records mean.
    pub(super) written: Written,
    /// A block of the contour said how lengths across the part count.
    pub(in super::super) diameter_said: bool,
}

impl Stored {
    /// Notes the centre of an arc that follows.
    pub(in super::super) fn note_centre(&mut self, center: Point2) {
        self.centre = Some(center);
    }

    /// Notes the corner at the end of the last block.
    pub(in super::super) fn note_corner(&mut self, corner: &Corner) {
        let Some(last) = self.blocks.last_mut() else { return };
        last.corner = match corner.shape {
            CornerShape::Rounding { radius } => Some(CornerWord::Radius(radius)),
            CornerShape::Chamfer { side } => Some(CornerWord::Chamfer(side)),
            _ => None,
        };
    }

    /// Something that cannot stand behind the records of a contour that has no end.
    pub(in super::super) fn must_be_done(
        open: &mut Option<Box<Stored>>,
        core: &Core<'_>,
        position: &mut Position,
    ) -> Outcome {
        open.take_if(|stored| stored.has_elements()).map_or(Ok(()), |stored| stored.has_no_end(core, position))
    }

    /// The last line never came: without blocks the elements would be left out.
    pub(super) fn has_no_end(&self, core: &Core<'_>, position: &mut Position) -> Outcome {
        if !self.has_elements() {
            return Ok(());
        }
        let what = "the contour definition has no line with its end (`;#End contour definition end`)";
        if !self.blocks.is_empty() {
            core.report(codes::S8027::records_of_this_contour_cannot_be_checked(&what).at(self.begin));
            return Ok(());
        }
        position.lose(AxisSet::MAIN);
        core.report(codes::S9019::contour_has_no_blocks_and_its_records(&what).at(self.begin));
        Err(Reported)
    }

    fn has_elements(&self) -> bool {
        self.records.iter().any(|record| matches!(record, Record::Line(..) | Record::Arc { .. } | Record::Unknown(_)))
    }
}

impl State {
    /// A block of a stored contour begins.
    pub(in super::super) fn stored_block_begins(&mut self, core: &Core<'_>) {
        let written = self.written_now(core);
        if let Some(stored) = self.stored.as_mut().filter(|stored| stored.start.is_none()) {
            stored.written = written;
        }
    }

    /// How the numbers of records count here: ordinates as those of blocks.
    pub(super) fn written_now(&self, core: &Core<'_>) -> Written {
        let [_, second, _] = self.roles();
        let diameter = core.is_diameter_axis(second) && self.diameter_mode() != Diameter::Off;
        Written { diameter, unit: self.length_unit() }
    }

    /// Notes a move of a stored contour.
    pub(in super::super) fn note_stored(&mut self, core: &Core<'_>, end: &Pos, path: &Path) {
        let plane = self.plane();
        let mut all = *self.position.at();
        all.update(end);
        // Blocks stand in front of the records.
        let _ = Stored::must_be_done(&mut self.stored, core, &mut self.position);
        let (arc, radius) = match path {
            Path::Arc(arc, _) => match (Heading::behind(arc, &self.position, &all), arc.shape) {
                (_, ArcShape::Center { center, ccw, .. }) => (Some((center, ccw)), None),
                (Heading::Arc { center, ccw, .. }, ArcShape::Radius { radius, .. }) => {
                    (Some((center, ccw)), Some(radius))
                }
                (Heading::Arc { center, ccw, .. }, _) => (Some((center, ccw)), None),
                _ => (None, None),
            },
            _ => (None, None),
        };
        let Some(stored) = self.stored.as_mut() else { return };
        let programmed = stored.centre.take();
        let arc = arc.map(|(center, ccw)| (programmed.unwrap_or(center), ccw));
        let Some(to) = all.in_plane(plane) else { return };
        if stored.start.is_none() {
            stored.start = Some(to);
            return;
        }
        if stored.blocks.len() > MOST_BLOCKS {
            return;
        }
        if matches!(path, Path::Rapid) && stored.rapid.is_none() {
            stored.rapid = Some(stored.blocks.len());
        }
        stored.blocks.push(ContourBlock { end: to, arc, radius, corner: None, record: 0, corner_record: 0 });
        stored.places.push(core.here.origin.loc);
    }
}
