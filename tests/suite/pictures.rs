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

/// The SVG of a program that is written here.
fn svg(text: &str, dialect: &str, config: &str, options: Options) -> String {
    let main = partc::internals::text::Opened {
        name: "P".into(),
        identity: "P".into(),
        text: Box::new(partc::internals::text::Memory::new(text.as_bytes().to_vec())),
    };
    let session = partc::internals::driver::Session::new(main);
    let mut out: Vec<u8> = Vec::new();
    let dialect = partc::internals::dialect::find(dialect).expect("a dialect");
    let files = partc::internals::text::files::NoFiles;
    session.plot(dialect, &settings(config), &files, options, &mut out).expect("a picture");
    assert!(!session.diags.has_errors());
    String::from_utf8(out).expect("text")
}

/// The words of a picture, each with where it begins and ends in letters of a broad font; all lie within the frame.
fn words(svg: &str) -> Vec<String> {
    let value = |text: &str, name: &str| -> f64 {
        let from = text.find(name).expect("an attribute") + name.len();
        text[from..].split(['"', 'p']).next().and_then(|v| v.parse().ok()).expect("a number")
    };
    let frame = svg.split_once("viewBox=\"").expect("a frame").1.split('"').next().expect("a frame");
    let frame: Vec<f64> = frame.split(' ').map(|v| v.parse().expect("a number")).collect();
    let font = value(svg, "text{font:");
    let mut all = Vec::new();
    for line in svg.lines().filter(|line| line.starts_with("<text")) {
        let (head, rest) = line.split_once('>').expect("words");
        let text = rest.trim_end_matches("</text>");
        let small = if head.contains("class=\"small\"") { 0.8 } else { 1.0 };
        let size = if head.contains("font-size:") { value(head, "font-size:") } else { font * small };
        let long = 0.64 * size * text.chars().count() as f64;
        let back = if head.contains("\"end\"") {
            1.0
        } else if head.contains("\"middle\"") {
            0.5
        } else {
            0.0
        };
        let from = value(head, " x=\"") - back * long;
        if !head.contains("rotate") {
            let right = frame[0] + frame[2];
            assert!(from >= frame[0] - 0.01 * font && from + long <= right + 0.01 * font, "cut off: {line} {frame:?}");
        }
        all.push(text.to_owned());
    }
    all
}

const LATHE: &str = "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[tools.1]\nradius = 0.4\norientation = 3\n";
const TURNED: &str =
    "G18 G90 G71 DIAMON\nT1 D1\nG97 S1000 M4\nG0 X70 Z2\nG1 X20 F0.2\nG1 Z-20\nG1 X30 Z-30\nG1 X60\nG0 X70 Z2\nM30\n";

/// Where the axis says diameters, all numbers along it are diameters.
#[test]
fn all_numbers_of_a_diameter_axis_are_diameters() {
    let sized = |view| Options { view: Some(view), dimensions: true, ..Options::default() };
    let seen = words(&svg(TURNED, "sinumerik", LATHE, sized(plot::Side::Xy)));
    let has = |text: &str| seen.iter().any(|word| word == text);
    assert!(has("X diameter in mm") && has("50") && has("20, 0") && !has("25") && !has("10, 0"), "{seen:?}");
    assert!(has("X diameter 20 to 70, Y 0 to 0") || has("X diameter 20 to 70, Z -30 to 2"), "{seen:?}");
    for view in [plot::Side::Yz, plot::Side::Xz, plot::Side::Iso] {
        let seen = words(&svg(TURNED, "sinumerik", LATHE, sized(view)));
        assert!(seen.iter().any(|word| word.contains("X diameter 20 to 70")), "{seen:?}");
    }
}

/// Half a number is a false one.
#[test]
fn no_words_are_cut_off() {
    let long = "0 BEGIN PGM N MM\n1 TOOL CALL 1 Z S2000\n2 L X+123.456 Y-1234.567 Z+5 R0 FMAX M3\n3 L Z-1 F200\n4 L Y+1234.567\n5 L Z+5 FMAX\n\
                9 END PGM N MM\n";
    let hole = "0 BEGIN PGM N MM\n1 TOOL CALL 1 Z S2000\n2 L X+0 Y+0 Z+5 R0 FMAX M3\n3 L Z-1 F200\n4 L Z+5 FMAX\n5 L X+1234.5678 Y+100.1234 FMAX\n\
                6 L Z-1 F200\n7 L X+1234.5678 Y+1234.5678\n8 L Z+5 FMAX M91\n9 END PGM N MM\n";
    for view in [None, Some(plot::Side::Xy), Some(plot::Side::Xz), Some(plot::Side::Yz), Some(plot::Side::Iso)] {
        for dimensions in [false, true] {
            let options = Options { view, dimensions, ..Options::default() };
            assert!(!words(&svg(TURNED, "sinumerik", LATHE, options)).is_empty());
            let seen = words(&svg(long, "klartext", "", options));
            assert!(seen.iter().any(|word| word.contains("-1234.567 to 1234.567")), "{seen:?}");
            assert!(!words(&svg(hole, "klartext", "", options)).is_empty());
        }
    }
}

/// Numbers that are rounded to each other tell nothing.
#[test]
fn small_parts_have_different_numbers_on_their_grid() {
    let tiny = "0 BEGIN PGM T MM\n1 TOOL CALL 1 Z S2000\n2 L X+0 Y+0 Z+0.002 R0 FMAX M3\n3 L Z+0 F100\n4 L X+0.001\n5 L Y+0.001\n6 L X+0 Y+0\n\
                9 END PGM T MM\n";
    let point = "0 BEGIN PGM P MM\n1 TOOL CALL 1 Z S2000\n2 L X+7 Y+3 Z+5 R0 FMAX M3\n3 L Z-2 F100\n9 END PGM P MM\n";
    let seen = words(&svg(tiny, "klartext", "", Options::default()));
    assert!(seen.iter().any(|word| word == "0.004 mm") && seen.iter().any(|word| word == "0.02"), "{seen:?}");
    let seen = words(&svg(point, "klartext", "", Options::default()));
    assert!(seen.iter().any(|word| word == "1 mm") && seen.iter().any(|word| word == "7"), "{seen:?}");
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

/// The blank lies where the program says, from each side; one that is described in another form, or in a shifted system, is not drawn.
#[test]
fn the_blank_is_drawn_where_it_is_known() {
    let sized = |view| Options { dimensions: true, view, ..Options::default() };
    let mill = |blank: &str| {
        format!(
            "0 BEGIN PGM B MM\n{blank}4 TOOL CALL 1 Z S1000\n5 L X+10 Y+10 Z+5 R0 FMAX\n6 L X+50 F100\n7 M30\n8 END PGM B MM\n"
        )
    };
    let corners = mill("1 BLK FORM 0.1 Z X-5 Y+0 Z-20\n2 BLK FORM 0.2 IX+100 IY+80 IZ+20.5\n");
    let above = svg(&corners, "klartext", "", sized(None));
    assert!(above.contains("class=\"b\" d=\"M-5 0L95 0L95 80L-5 80Z\""), "{above}");
    assert!(words(&above).contains(&"blank 100 x 80 x 20.5".to_owned()), "{above}");
    let front = svg(&corners, "klartext", "", sized(Some(plot::Side::Xz)));
    assert!(front.contains("class=\"b\" d=\"M-5 -20L95 -20L95 0.5L-5 0.5Z\""), "{front}");
    let iso = svg(&corners, "klartext", "", sized(Some(plot::Side::Iso)));
    let edges = iso.split("class=\"b\" d=\"").nth(1).and_then(|rest| rest.split('"').next()).expect("edges");
    assert_eq!(edges.matches('M').count(), 12, "{edges}");
    // Inches are millimetres in the picture.
    let inch = svg(&corners.replace(" MM\n", " INCH\n"), "klartext", "", sized(None));
    assert!(inch.contains("class=\"b\" d=\"M-127 0L2413 0L2413 2032L-127 2032Z\""), "{inch}");
    let turned = "%b.nc\n#UNIT METRIC\nBLANK\nN1 G20 X80 Z100 K2 I30\nMACHINING\nN2 T1 G95 F0.2 G97 S200 M4\nN3 G0 X84 Z4\nN4 G1 Z-10\nEND\n";
    let turned = svg(turned, "heidenhain-turning", "", sized(None));
    let bar = "class=\"b\" d=\"M-98 -40L2 -40L2 40L-98 40ZM-98 -15L2 -15L2 15L-98 15Z\"";
    assert!(turned.contains(bar) && words(&turned).contains(&"blank ⌀80 / ⌀30 x 100".to_owned()), "{turned}");
    let shifted = "1 CYCL DEF 7.0 DATUM SHIFT\n2 CYCL DEF 7.1 X+5\n2 BLK FORM 0.1 Z X-5 Y+0 Z-20\n3 BLK FORM 0.2 X+100 Y+80 Z+0\n";
    let others = ["", "1 BLK FORM CYLINDER Z R50 L105\n", "1 BLK FORM 0.1 Z X-5 Y+0 Z-20\n", shifted];
    for blank in others {
        let plain = svg(&mill(blank), "klartext", "", sized(None));
        assert!(!plain.contains("class=\"b\"") && !plain.contains("blank"), "{blank}: {plain}");
    }
}
