//! What tests, benches and fuzz targets of this repository look into, by folder.

pub mod compare {
    pub use crate::compare::{Difference, Step, Steps, play, steps_of_text};
}

pub mod diag {
    pub use crate::diag::{CallPath, Diagnostic, Diags, Severity, codes, render};
}

pub mod dialect {
    pub use crate::dialect::{ALL, Dialect, find, read_as};
}

pub mod driver {
    pub use crate::driver::Session;
}

pub mod emit {
    pub use crate::emit::{LineMap, Output, Printer, number, plot};
}

pub mod geo {
    pub use crate::geo::{Deg, Element, Plane, Point2, rotation, undercut};
}

pub mod ir {
    pub use crate::ir::{Feed, Function, Origin, Pos, Side, Tap, captured, contour, function, motion, undercut};
}

pub mod lower {
    pub use crate::lower::Lower;
}

pub mod machine {
    pub use crate::machine::{
        Axis, Compensation, Machine, MachineKind, OutputSettings, PathChoice, PathControl, Settings, Undercuts, Unit,
        axis, config, schema, settings, table, tools, tree,
    };
}

pub mod parser {
    pub use crate::parser::{klartext, mtc200, problem, sinumerik, symbols, turning};
}

pub mod read {
    pub use crate::read::{Act, Modes, Path, Reader, SCALE};
}

pub mod sema {
    pub use crate::sema::cycle;

    pub mod sinumerik {
        pub use crate::sema::sinumerik::all_words;
    }
}

pub mod target {
    pub use crate::target::{ALL, DwellUnit, NAMES, Target, find};
}

pub mod text {
    pub use crate::text::{
        FileError, FileId, Files, Loc, Memory, Opened, ReadAt, Request, Sources, Span, Within, files, sources,
    };
}

pub mod validate {
    pub use crate::validate::{Mismatch, Validator};
}
