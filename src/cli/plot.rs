//! `partc plot`

use std::collections::BTreeSet;
use std::io;
use std::path::{Path, PathBuf};

use crate::emit::plot::{Form, Options, Side, Thinned, rounded_up};

use super::args::{PictureForm, Plot, View};
use super::closure::Targets;
use super::disk::file_name;
use super::inputs::Input;
use super::made::{Made, Replaces, is_foreign};
use super::output::{Destination, ignore_closed_pipe};
use super::paths::{real, same_file};
use super::program::{Loaded, load};
use super::progress::Ticker;
use super::report::{Reporter, Stdout};
use super::{Exit, Trouble, say};

/// Draws the path of one program. That of a program with errors says that it is not whole.
pub(super) fn plot(args: &Plot) -> Result<Exit, Trouble> {
    let target = target(args);
    let shown = target.display().to_string();
    let trouble = |error: io::Error| format!("{shown}: {error}");
    if same_file(&args.input, &target) {
        return Err(format!("{shown}: the picture would replace the program"));
    }
    if is_foreign(&target, Made::Picture) && !args.force {
        return Err(format!("{shown}: not drawn by partc; use --force to replace it, or another name"));
    }
    let options = Options {
        view: args.view.map(side),
        dimensions: args.dimensions,
        form: match args.form {
            Some(asked) => made(asked)?,
            None => form(&target).map_err(|error| format!("{error}, or say the form with --as"))?,
        },
    };
    let Loaded { session, dialect, settings, files, place } = load(&args.input, &args.common)?;
    let stdout = if target == Path::new("-") { Stdout::Taken } else { Stdout::Free };
    let mut reporter = Reporter::new(&args.common, &args.findings, stdout, None);
    reporter.spares(&[Input::named(&args.input)], &BTreeSet::from([real(&target)]))?;
    let targets = Targets::new([target.as_path()].into_iter().chain(reporter.files()));
    let mut out = Destination::open_for(&target, Replaces::by(Made::Picture, args.force)).map_err(trouble)?;
    let ticker = Ticker::start(true, &place);
    let result = session.plot(dialect, &settings, &files, options, &mut out);
    drop(ticker);
    targets.spare(&args.input, &args.common, &files)?;
    let thinned = result.map_err(trouble)?;
    out.commit().or_else(ignore_closed_pipe).map_err(trouble)?;
    if let Some(Thinned { moves, strokes, error }) = thinned.filter(|_| !args.common.report.quiet) {
        let error = rounded_up(error);
        say(&format!("partc: {moves} moves are drawn with {strokes} strokes, at most {error} mm away from them"));
    }
    let is_told = target != Path::new("-") && !args.common.report.quiet;
    let error = session.first_error().filter(|_| is_told);
    reporter.session(session);
    let exit = reporter.finish()?;
    if let Some(error) = error {
        say(&format!("partc: {shown} is incomplete: it stops at the first error ({})", error.code));
    }
    Ok(exit)
}

/// The form that the name of a picture asks for.
pub(super) fn form(path: &Path) -> Result<Form, Trouble> {
    let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
    match extension.as_deref() {
        None | Some("svg") => made(PictureForm::Svg),
        Some("png") => made(PictureForm::Png),
        Some(_) => Err(format!("{}: a picture is .svg or .png; name another file", path.display())),
    }
}

fn made(form: PictureForm) -> Result<Form, Trouble> {
    match form {
        PictureForm::Svg => Ok(Form::Svg),
        #[cfg(feature = "png")]
        PictureForm::Png => Ok(Form::Png),
        #[cfg(not(feature = "png"))]
        PictureForm::Png => Err("this partc was built without the feature `png`; take svg".to_owned()),
    }
}

fn side(view: View) -> Side {
    match view {
        View::Xy => Side::Xy,
        View::Xz => Side::Xz,
        View::Yz => Side::Yz,
        View::Iso => Side::Iso,
    }
}

fn target(args: &Plot) -> PathBuf {
    let extension = if args.form == Some(PictureForm::Png) { "png" } else { "svg" };
    match (&args.output, &args.common.stdin_filename) {
        (Some(output), _) => output.clone(),
        (None, Some(name)) if args.input == Path::new("-") => PathBuf::from(file_name(name)).with_extension(extension),
        (None, _) if args.input == Path::new("-") => PathBuf::from("-"),
        (None, _) => args.input.with_extension(extension),
    }
}
