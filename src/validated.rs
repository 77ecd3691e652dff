//! A printer whose text is read back item by item, before it is written.

use std::io;

use crate::diag::Diags;
use crate::emit::Printer;
use crate::emit::winding::{self, Winding};
use crate::ir::motion::{Move, Path, Place, Sink};
use crate::ir::{Function, Origin, Pos, Tap};
use crate::validate::{Mismatch, Validator};

/// Hands items to the printer, and what it makes of them to the validator.
#[derive(Debug)]
pub(crate) struct Validated<'a> {
    printer: Printer<'a>,
    validator: Validator,
    diags: &'a Diags,
}

impl<'a> Validated<'a> {
    /// `printer` has printed the head only.
    pub fn new(mut printer: Printer<'a>, mut validator: Validator, diags: &'a Diags) -> Validated<'a> {
        printer.hold();
        if diags.has_errors() {
            validator.give_up();
        } else {
            let (bytes, end) = printer.held();
            validator.head(bytes, end);
        }
        printer.release();
        Validated { printer, validator, diags }
    }

    /// With an error the output is of no use, and need not be what was meant.
    #[inline]
    fn look(&mut self) {
        if self.diags.has_errors() {
            self.validator.give_up();
        }
    }

    /// Prints and reads back an arc of very many turns; what is over the limit of lines is not made at all.
    #[cold]
    fn pieces(&mut self, winding: &Winding, origin: &Origin) {
        winding.pieces().for_each(|piece| {
            if !self.printer.full() {
                self.movement(&piece, origin);
            }
        });
    }

    /// Ends the output; the first difference, unless errors were reported.
    ///
    /// # Errors
    /// What the output reports.
    pub fn finish(mut self, hash: u64) -> io::Result<Option<Box<Mismatch>>> {
        self.printer.close();
        self.look();
        let (bytes, end) = self.printer.held();
        self.validator.finish(bytes, end);
        self.printer.finish(hash)?;
        Ok(self.validator.into_mismatch().filter(|_| !self.diags.has_errors()))
    }
}

impl Sink for Validated<'_> {
    fn movement(&mut self, mv: &Move, origin: &Origin) {
        if matches!(&mv.path, Path::Arc(arc, _) if arc.sweep.abs() >= winding::LEAST)
            && let Some(winding) = self.printer.winding(mv)
        {
            return self.pieces(&winding, origin);
        }
        self.printer.movement(mv, origin);
        self.look();
        let (bytes, end) = self.printer.held();
        self.validator.movement(mv, origin, bytes, end);
        self.printer.release();
    }

    fn tap(&mut self, tap: &Tap, place: &Place, origin: &Origin) {
        self.printer.tap(tap, place, origin);
        self.look();
        let (bytes, end) = self.printer.held();
        self.validator.tap(tap, place, origin, bytes, end);
        self.printer.release();
    }

    fn function(&mut self, function: &Function, origin: &Origin) {
        self.printer.function(function, origin);
        self.look();
        let (bytes, end) = self.printer.held();
        self.validator.function(function, origin, bytes, end);
        self.printer.release();
    }

    fn lost(&mut self, origin: &Origin) {
        self.printer.lost(origin);
        self.validator.lost();
    }

    fn programmed(&mut self, mv: &Move, start: &Pos) {
        self.printer.programmed(mv, start);
    }

    fn begins_at(&mut self, at: &Pos) {
        self.printer.begins_at(at);
        self.validator.begins_at(at);
    }

    fn full(&self) -> bool {
        self.printer.full()
    }
}
