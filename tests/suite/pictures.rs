//! The pictures of the documentation are what partc draws. `INSTA_UPDATE=always` draws them anew.

use std::fs;
use std::path::Path;
use std::rc::Rc;

use partc::internals::diag::Diags;
use partc::internals::emit::plot::{self, Form, Options, Plot};
use partc::internals::geo::undercut::{Edge, Shape};
use partc::internals::geo::{Deg, Plane};
use partc::internals::ir::contour::{
    ArcChamfer, Blocks, Coords, Corner, CornerShape, Ctx, CtxRef, LargeCorner, Move, Path as Way, Sink,
};
use partc::internals::ir::undercut::{ThreadForm, Undercut, form_e, form_f, thread};
use partc::internals::ir::{Feed, Function, Origin, Pos, Side};
use partc::internals::lower::Lower;
use partc::internals::machine::{Settings, Undercuts};

use super::common::settings;

fn lathe() -> Settings {
    settings("[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n")
}

fn line(z: f64, x: f64, rapid: bool) -> Move {
    let mut end = Pos::UNKNOWN;
    end.set_in_plane(Plane::Zx, partc::internals::geo::Point2::new(z, x / 2.0));
    let path = if rapid { Way::Rapid } else { Way::Line(Feed::PerRevolution(0.1)) };
    Move { end, path, side: Side::None, coords: Coords::Frame }
}

/// Draws the corner at Z, X between points on its two lines, X as a diameter.
fn draw(title: &str, shape: Shape, from: (f64, f64), corner: (f64, f64), to: (f64, f64)) -> String {
    let settings = lathe();
    let diags = Diags::default();
    let mut out: Vec<u8> = Vec::new();
    let mut plot = Plot::new(&settings, title, Options::default());
    let ctx: CtxRef = Rc::new(Ctx { plane: Plane::Zx, ..Ctx::default() });
    let origin = Origin::default();
    let mut lower = Lower::new(&diags, &settings.machine, &mut plot);
    lower.function(&Function::ToolChange { number: 1 }, &ctx, &origin);
    // The tool comes along the first line, and leaves in the direction of the second.
    let along = if from.0 == corner.0 {
        (0.0, 1.5 * (from.1 - corner.1).signum())
    } else {
        (1.5 * (from.0 - corner.0).signum(), 0.0)
    };
    let away = if to.0 == corner.0 { (along.0, 2.0 * (to.1 - corner.1).signum()) } else { (1.5, 2.0) };
    lower.movement(&line(from.0 + along.0 + away.0, from.1 + along.1 + away.1, true), &ctx, &origin);
    lower.movement(&line(from.0 + along.0, from.1 + along.1, true), &ctx, &origin);
    lower.movement(&line(corner.0, corner.1, false), &ctx, &origin);
    let shape = CornerShape::Undercut(Undercut::new(shape));
    lower.corner(
        &Corner {
            shape,
            feed: None,
            early: false,
            modal: false,
            large: LargeCorner::Refuse,
            at_arc: ArcChamfer::Refuse,
            blocks: Blocks::PassedOver,
        },
        &ctx,
        &origin,
    );
    lower.movement(&line(to.0, to.1, false), &ctx, &origin);
    lower.movement(&line(to.0 + away.0, to.1 + away.1, true), &ctx, &origin);
    lower.finish();
    plot.finish(None, &mut out).expect("memory takes everything");
    assert!(!diags.has_errors(), "{title}");
    String::from_utf8(out).expect("text")
}

#[test]
fn undercuts_of_the_documentation() {
    let tables = Undercuts::default();
    let size = *tables.size(0.6, 0.3).expect("a size");
    let row = tables.thread(2.5).expect("a pitch");
    let dz = |form| thread(&tables, row, form, Deg(30.0)).0;
    let shaft = ((-24.0, 40.0), (-30.0, 40.0), (-30.0, 48.0));
    let groove = Shape::Groove { width: 3.0, depth: 1.0, edge: Edge::Round(0.3), radius: 0.4 };
    let slope = Shape::Slope { length: 3.0, entry: Deg(30.0), radius: 1.0 };
    let wedge = Shape::Wedge { depth: 1.0, radius: 0.4, opening: Deg(50.0), axis: Deg(45.0) };
    let thread_shaft = ((-16.0, 20.0), (-30.0, 20.0), (-30.0, 30.0));
    let core = 20.0 - 1.08253 * 2.5;
    let nut = ((-10.0, core), (-30.0, core), (-30.0, 10.0));
    let cases = [
        ("form-e", "form E 0.6 x 0.3, external, towards -Z", form_e(&size), shaft),
        ("form-f", "form F 0.6 x 0.3, external, towards -Z", form_f(&size), shaft),
        (
            "form-f-plus-z",
            "form F 0.6 x 0.3, external, towards +Z",
            form_f(&size),
            ((-36.0, 40.0), (-30.0, 40.0), (-30.0, 48.0)),
        ),
        (
            "form-f-internal",
            "form F 0.6 x 0.3, internal, towards -Z",
            form_f(&size),
            ((-24.0, 40.0), (-30.0, 40.0), (-30.0, 32.0)),
        ),
        (
            "form-f-internal-plus-z",
            "form F 0.6 x 0.3, internal, towards +Z",
            form_f(&size),
            ((-36.0, 40.0), (-30.0, 40.0), (-30.0, 32.0)),
        ),
        (
            "form-f-from-the-face",
            "form F 0.6 x 0.3, face first",
            form_f(&size),
            ((-30.0, 48.0), (-30.0, 40.0), (-24.0, 40.0)),
        ),
        ("thread-a", "DIN 76 A, M20 x 2.5", dz(ThreadForm::A), thread_shaft),
        ("thread-b", "DIN 76 B, M20 x 2.5", dz(ThreadForm::B), thread_shaft),
        ("thread-c", "DIN 76 C, M20 x 2.5", dz(ThreadForm::C), nut),
        ("thread-d", "DIN 76 D, M20 x 2.5", dz(ThreadForm::D), nut),
        ("form-u", "form U, 3 x 1, edge R0.3", groove, shaft),
        ("form-h", "form H, 3 long, 30 degrees", slope, shaft),
        ("form-k", "form K, 1 deep at 45 degrees", wedge, shaft),
    ];
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/undercuts");
    let update = std::env::var("INSTA_UPDATE").is_ok_and(|v| v == "always");
    for (name, title, shape, (from, corner, to)) in cases {
        let text = draw(title, shape, from, corner, to);
        let path = folder.join(format!("{name}.svg"));
        if update {
            fs::create_dir_all(&folder).expect("a folder");
            fs::write(&path, &text).expect("a picture");
        }
        let there = fs::read_to_string(&path).unwrap_or_default();
        assert!(there == text, "{}: draw it anew with INSTA_UPDATE=always", path.display());
    }
}

/// Draws a program of `tests/golden/plot`, with the configuration beside it where there is one.
fn picture(file: &str, dialect: &str, options: Options) -> Vec<u8> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/plot");
    let text = fs::read(folder.join(file)).expect("a program");
    let config = fs::read_to_string(folder.join(file).with_extension("toml")).unwrap_or_default();
    let main = partc::internals::text::Opened {
        name: format!("dir/{file}"),
        identity: file.to_owned(),
        text: Box::new(partc::internals::text::Memory::new(text)),
    };
    let session = partc::internals::driver::Session::new(main);
    let mut out: Vec<u8> = Vec::new();
    let dialect = partc::internals::dialect::find(dialect).expect("a dialect");
    let files = partc::internals::text::files::NoFiles;
    session.plot(dialect, &settings(&config), &files, options, &mut out).expect("a picture");
    assert!(!session.diags.has_errors(), "{file}");
    out
}

/// Each program from its own side, and from the sides that show something else.
#[test]
fn pictures_of_programs() {
    let plain = Options::default();
    let sized = Options { dimensions: true, ..plain };
    let from = |view| Options { view: Some(view), ..plain };
    let cases = [
        ("flange.H", "klartext", "flange", sized),
        ("flange.H", "klartext", "flange-front", from(plot::Side::Xz)),
        ("helix.H", "klartext", "helix", plain),
        ("helix.H", "klartext", "helix-iso", from(plot::Side::Iso)),
        ("helix.H", "klartext", "helix-right", from(plot::Side::Yz)),
        ("shaft.nc", "heidenhain-turning", "shaft", sized),
        ("shaft.nc", "heidenhain-turning", "shaft-iso", from(plot::Side::Iso)),
        ("bush.MPF", "sinumerik", "bush", sized),
    ];
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/plot");
    let update = std::env::var("INSTA_UPDATE").is_ok_and(|v| v == "always");
    for (file, dialect, name, options) in cases {
        let text = String::from_utf8(picture(file, dialect, options)).expect("text");
        let path = folder.join(format!("{name}.svg"));
        if update {
            fs::write(&path, &text).expect("a picture");
        }
        let there = fs::read_to_string(&path).unwrap_or_default();
        assert!(there == text, "{}: draw it anew with INSTA_UPDATE=always, and look at it", path.display());
    }
}

/// The bytes of a PNG are the same everywhere: here is their hash.
#[test]
fn the_pixels_are_the_same_on_every_system() {
    let hash = |bytes: &[u8]| {
        bytes.iter().fold(0xcbf2_9ce4_8422_2325u64, |h, b| (h ^ u64::from(*b)).wrapping_mul(0x100_0000_01b3))
    };
    let seen: Vec<String> = [
        ("flange.H", "klartext", None),
        ("helix.H", "klartext", Some(plot::Side::Iso)),
        ("shaft.nc", "heidenhain-turning", None),
    ]
    .into_iter()
    .map(|(file, dialect, view)| {
        let bytes = picture(file, dialect, Options { view, dimensions: true, form: Form::Png });
        assert!(bytes.starts_with(b"\x89PNG\r\n\x1a\n") && bytes.ends_with(b"IEND\xae\x42\x60\x82"));
        format!("{file} {} bytes {:016x}\n", bytes.len(), hash(&bytes))
    })
    .collect();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/plot/pixels.txt");
    let update = std::env::var("INSTA_UPDATE").is_ok_and(|v| v == "always");
    if update {
        fs::write(&path, seen.concat()).expect("a file");
    }
    assert_eq!(fs::read_to_string(&path).unwrap_or_default(), seen.concat());
}

/// A full circle, a helix, a drill and a move whose start is not known.
#[test]
fn what_a_picture_shows() {
    let text = "0 BEGIN PGM P MM\n1 TOOL CALL 3 Z S1000\n2 L X+10 Y+0 Z+5 R0 FMAX\n3 L Z-2 F100\n4 CC X+0 Y+0\n5 C X+10 Y+0 DR+\n\
                6 CP IPA-720 IZ-4 DR-\n7 TOOL CALL 4 Z S500\n8 L X+30 Y+5 FMAX\n9 L Z-9 F50\n10 L Z+50 FMAX M91\n11 END PGM P MM\n";
    let main = partc::internals::text::Opened {
        name: "dir/P.H".into(),
        identity: "P".into(),
        text: Box::new(partc::internals::text::Memory::new(text.as_bytes().to_vec())),
    };
    let session = partc::internals::driver::Session::new(main);
    let mut out: Vec<u8> = Vec::new();
    let dialect = partc::internals::dialect::find("klartext").expect("a dialect");
    let files = partc::internals::text::files::NoFiles;
    session.plot(dialect, &Settings::default(), &files, Options::default(), &mut out).expect("a picture");
    let svg = String::from_utf8(out).expect("text");
    assert!(svg.starts_with("<!-- (partc plot) -->\n<svg ") && svg.ends_with("</svg>\n"));
    assert!(svg.contains("<title>P.H</title>") && !svg.contains("dir/"), "the folder is nobody's business");
    // Both turns of the helix lie on the circle; each circle is two half ones.
    let halves = ["A10 10 0 0 1 -10 0", "A10 10 0 0 1 10 0", "A10 10 0 0 0 -10 0", "A10 10 0 0 0 10 0"];
    assert!(halves.iter().all(|half| svg.contains(half)), "{svg}");
    assert!(svg.contains("class=\"d t1\" d=\"M") && svg.contains(">T3<") && svg.contains(">T4<"));
    assert!(svg.contains("1 move in machine coordinates not drawn"));
    // What is pointed at tells its block.
    assert!(svg.contains("<title>6: 5 C X+10 Y+0 DR+</title>"), "{svg}");
    // The legend names what is drawn only.
    assert!(!svg.contains(">thread<") && !svg.contains(">contour<") && !svg.contains("cut open"), "{svg}");
    for (open, close) in [("<g ", "</g>"), ("<svg ", "</svg>"), ("<style>", "</style>")] {
        assert_eq!(svg.matches(open).count(), svg.matches(close).count());
    }
}
