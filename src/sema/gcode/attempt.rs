//! Would this text be taken as plain G-code?

use crate::diag::{Diags, Severity, Trail, codes};
use crate::machine::{Settings, Unit};
use crate::sema::Job;
use crate::sema::run::Nowhere;
use crate::text::files::NoFiles;
use crate::text::{FileId, Loc, Memory, Opened, Sources};

/// The first line of `text` that is refused for what stands in it; `None` where each is taken, or waits for no more than a
/// key of the configuration. The end of `text` need not be that of a program.
pub fn first_refused(text: &[u8], settings: &Settings) -> Option<Loc> {
    // A line that waits for the unit would hide what else is wrong with it.
    let mut settings = settings.clone();
    settings.control.unit = settings.control.unit.or(Some(Unit::Mm));
    let sources = Sources::default();
    let opened = Opened { name: String::new(), identity: String::new(), text: Box::new(Memory::new(text.to_vec())) };
    // The first file always fits.
    let _ = sources.add(opened);
    let (diags, trail) = (Diags::default(), Trail::default());
    let job =
        Job { sources: &sources, diags: &diags, trail: &trail, files: &NoFiles, settings: &settings, main: FileId(0) };
    super::run(&job, &mut Nowhere);
    let is_of_the_end = |code: &str| [codes::P0007.id, codes::P0008.id].contains(&code);
    let found = diags
        .into_sorted()
        .into_iter()
        .find(|found| found.severity == Severity::Error && found.answers.is_empty() && !is_of_the_end(found.code.id));
    found.map(|found| found.label.loc)
}
