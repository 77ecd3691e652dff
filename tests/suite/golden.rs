//! Golden books: each book under `tests/golden` is a snapshot of itself, and has a test of its own: what people wrote is taken out
//! of it, compiled, and written anew with what partc made.
//!
//! Numbers are checked against the manual or a derivation before a listing is accepted (see the comments in the cases).

use std::collections::BTreeSet;
use std::fs;

use super::book;
use super::listing;

/// A test for each book, in a module for each folder.
macro_rules! books {
    ($($module:ident = $folder:literal: $($book:ident)+;)+) => {
        const BOOKS: &[&str] = &[$($(concat!($folder, "/", stringify!($book)),)+)+];
        $(
            #[allow(non_snake_case, reason = "books of codes bear the names of codes")]
            mod $module {
                $(#[test] fn $book() { super::check(concat!($folder, "/", stringify!($book))); })+
            }
        )+
    };
}

books! {
    errors_gcode = "errors/gcode":
        P0206 P100 P200 R R1004 R1005 R4;
    errors_heidenhain_turning = "errors/heidenhain-turning":
        G L P001 P100 P101 P200 P201 P202 P901 T1 T200 T201 T202 T203 T207 T3 T8 T9;
    errors_klartext = "errors/klartext":
        G G305 G32 K0 K100 K101 K18 K20 K2014 K21 K22 K23 K24 K2412 K2414 K2415 K25 K26 K27 K2710 K28 K2851 K2854 K2855 K2856 K29 K294 K295 K30 K8 K8026 K8027 K81 K814 K900 K901 K903 K904 L1 L2 O P P001 P100 P101 P200 P201 P202 P203 P204 P209 P810 P901;
    errors_mtc200 = "errors/mtc200":
        G L M0 M100 M101 M200 M201 M21 M22 M23 M24 M27 M8 M9 O P001 P0205 P0206 P100 P101 P200 P201 P202 P203 P204 P300 P810 P901;
    errors_sinumerik = "errors/sinumerik":
        G G330 G332 L1 L2 O O4006 P P000 P001 P0107 P0205 P0206 P100 P101 P200 P201 P202 P203 P204 P209 P300 P810 P901 S0 S1 S200 S201 S202 S203 S204 S2046 S2047 S205 S206 S207 S208 S209 S21 S228 S3 S4 S800 S801 S802 S803 S804 S805 S81 S8164 S8165 S8166 S8167 S8168 S8169 S817 S8171 S8172 S821 S822 S823 S824 S825 S900 S901 S902 S9022 S9023 S9024 S91 S9133;
    gcode = "gcode":
        heads lines modes path_control percents rigid_taps speeds tap_reasons;
    heidenhain_turning = "heidenhain-turning":
        angles arcs calls compensation contours corners cycle_words drilling exact_stop finishing flow modal moves noses oversizes program recess
        recess_turning roughing shifts threads tools undercut variables;
    heidenhain_turning_finishing = "heidenhain-turning/finishing":
        ends;
    heidenhain_turning_noses = "heidenhain-turning/noses":
        centre;
    heidenhain_turning_recess_turning = "heidenhain-turning/recess_turning":
        blanks words;
    heidenhain_turning_threads = "heidenhain-turning/threads":
        examples simple;
    heidenhain_turning_variables = "heidenhain-turning/variables":
        divisors;
    heidenhain_turning_words = "heidenhain-turning/words":
        refused;
    klartext = "klartext":
        approach arcs call_functions corners cycles drilling edges2 flow frames functions manual output parameters path path_control planes polar
        text tools units;
    klartext_arcs = "klartext/arcs":
        centres radius tangential;
    klartext_compensation = "klartext/compensation":
        approach contours m_functions;
    klartext_corners = "klartext/corners":
        chamfers;
    klartext_edges = "klartext/edges":
        calls definitions feed_at_start feeds free_contours levels named planes probing system_data tools;
    klartext_fk = "klartext/fk":
        contours elements manual;
    klartext_flow = "klartext/flow":
        cycle_12 jumps programs repeats;
    klartext_frames = "klartext/frames":
        datum_shifts datum_tables mirrors rotations scaling;
    klartext_functions = "klartext/functions":
        m116_to_m140 m91;
    klartext_machining = "klartext/machining":
        bores contours contours_refused faces finishing holes islands middle_line old_pockets patterns pockets rest slots studs threads ties tilts;
    klartext_parameters = "klartext/parameters":
        divisors functions system_data texts;
    klartext_path = "klartext/path":
        m_functions paraxial rotary;
    klartext_polar = "klartext/polar":
        arcs helices increments missing_words;
    klartext_text = "klartext/text":
        bytes continuation misprints numbers;
    klartext_tools = "klartext/tools":
        builders_cycles builders_programs change_by_m compensation left_places m6 oversizes places;
    mtc200 = "mtc200":
        arcs compensation corners corrections flow functions manual offsets path path_control programs text tools units variables;
    mtc200_variables = "mtc200/variables":
        divisors;
    mtc200_words = "mtc200/words":
        arguments entries left_side refused;
    same_part = "same_part":
        lathe mill;
    sinumerik = "sinumerik":
        angles axes calls circles contour_cycles contours corners diameter drilling edges examples feeds flow frames functions lexical machine_coordinates offsets output path_control patterns polar rigid_taps rotary settings swivel tap_functions tapping threads tools transformations undercut_corners undercut_cycles units variables;
    sinumerik_approach = "sinumerik/approach":
        lines;
    sinumerik_beside = "sinumerik/beside":
        actions couplings tables_of_numbered_axes;
    sinumerik_calls = "sinumerik/calls":
        change_by_m external left_behind left_out left_places left_technology numbered own_cycles parameters passes reserved save search_path;
    sinumerik_circles = "sinumerik/circles":
        axis_order cip_and_ct helices;
    sinumerik_compensation = "sinumerik/compensation":
        border corners nose search soft tools;
    sinumerik_contour_cycles = "sinumerik/contour_cycles":
        cycle95 cycle952 other_cycles refused;
    sinumerik_contour_lines = "sinumerik/contour_lines":
        g17 g18 g19;
    sinumerik_contours = "sinumerik/contours":
        ang read_only records records_arcs records_lines records_undercuts records_units;
    sinumerik_corners = "sinumerik/corners":
        chamfers rounding;
    sinumerik_drilling = "sinumerik/drilling":
        boring cycle81 cycle82 cycle83 cycle84 cycle840 cycle840_pitches cycle840_techno lathe planes zone_signs zones;
    sinumerik_examples = "sinumerik/examples":
        arcs corners faults frames language;
    sinumerik_feeds = "sinumerik/feeds":
        g96;
    sinumerik_flow = "sinumerik/flow":
        jumps repeats;
    sinumerik_frames = "sinumerik/frames":
        mirror_and_scale rotation;
    sinumerik_lexical = "sinumerik/lexical":
        skip words;
    sinumerik_machining = "sinumerik/machining":
        contour_pockets contour_starts contour_ties cycle92 cycle93 cycle930 cycle95 cycle951 cycle952 cycle_modes described groove_rims grooves_refused milling milling_alarms milling_parameters normal_offset paths pocket_alarms pockets removal_readings rests slots thread_milling;
    sinumerik_measuring = "sinumerik/measuring":
        blocks contact cycles;
    sinumerik_offsets = "sinumerik/offsets":
        g500 g53;
    sinumerik_patterns = "sinumerik/patterns":
        cycle801 cycle802 holes1 holes2 mcall;
    sinumerik_thread_cycles = "sinumerik/thread_cycles":
        cycle97 cycle98 cycle99;
    sinumerik_tool_data = "sinumerik/tool_data":
        questions;
    sinumerik_undercut_corners = "sinumerik/undercut_corners":
        form_e form_f threads;
    sinumerik_undercut_cycles = "sinumerik/undercut_cycles":
        cycle94 cycle940 cycle940_a cycle940_b cycle940_c cycle940_d cycle940_e cycle940_f cycle940_t cycle96 noses written_edges;
    sinumerik_variables = "sinumerik/variables":
        arrays divisors kept;
    targets_klartext = "targets/klartext":
        compensation feeds rigid_taps tilted_planes;
    targets_sinumerik = "targets/sinumerik":
        compensation path_control rigid_taps spindle spindle_angles tap_blocks tap_steps;
}

fn check(book: &str) {
    let inputs = book::inputs(book);
    let listing = listing::of(book, &inputs);
    let read_again = book::read::inputs(&listing);
    let changed = inputs.trim_end().lines().zip(read_again.lines()).find(|(before, now)| before != now);
    assert_eq!(changed, None, "{book}: what people wrote stays as it is");
    assert_eq!(inputs.trim_end().len(), read_again.trim_end().len(), "{book}: what people wrote stays as it is");
    let (folder, name) = book.rsplit_once('/').expect("a folder");
    let snapshot = book::root().join(format!("{book}.snap"));
    // The difference that is shown does not reach up to the headings.
    for heading in different(&fs::read_to_string(&snapshot).unwrap_or_default(), &listing) {
        println!("{book}: {heading}");
    }
    let mut settings = insta::Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_snapshot_path(book::root().join(folder));
    settings.bind(|| insta::assert_snapshot!(name, listing));
}

/// Chapters and headings of the cases that are not listed alike.
fn different(before: &str, now: &str) -> Vec<String> {
    fn listed(text: &str) -> BTreeSet<(&str, &str)> {
        let cases = text.split("=== ").skip(1).flat_map(|chapter| {
            let title = chapter.lines().next().unwrap_or_default();
            chapter.split("\n== ").skip(1).map(move |case| (title, case.trim_end()))
        });
        cases.collect()
    }
    let (before, now) = (listed(before), listed(now));
    let heading = |(chapter, case): &(&str, &str)| format!("{chapter}: {}", case.lines().next().unwrap_or_default());
    let mut headings: Vec<String> = before.symmetric_difference(&now).map(heading).collect();
    headings.dedup();
    headings
}

#[test]
fn every_book_has_its_test() {
    let books = book::names();
    let only = |here: &[String], there: &[String]| -> Vec<String> {
        here.iter().filter(|book| !there.contains(book)).cloned().collect()
    };
    let tests: Vec<String> = BOOKS.iter().map(|book| (*book).to_owned()).collect();
    assert_eq!(only(&books, &tests), [""; 0], "books that are missing in the list above");
    assert_eq!(only(&tests, &books), [""; 0], "tests without a book");
    // Those of pictures stand beside their programs.
    let configs: Vec<String> =
        book::files("toml").iter().filter_map(|path| path.strip_prefix("configs/").map(str::to_owned)).collect();
    let text: String = books.iter().map(|book| book::inputs(book)).collect();
    let unused = configs.iter().filter(|name| !text.contains(&format!("-- config {name}\n")));
    assert_eq!(unused.collect::<Vec<_>>(), [""; 0], "configurations that no case names");
}

#[test]
fn every_case_has_a_name_of_its_own() {
    let mut names = BTreeSet::new();
    for case in book::cases("") {
        assert!(names.insert(&case.name), "{} stands in two places", case.name);
        // A case of a book of codes stands where its code is looked for.
        if case.name.starts_with("errors/") {
            let code = case.stem().split('_').next().unwrap_or_default();
            let fitting = BOOKS.iter().filter(|book| {
                book.rsplit_once('/')
                    .is_some_and(|(folder, prefix)| case.book.starts_with(folder) && code.starts_with(prefix))
            });
            assert_eq!(fitting.max_by_key(|book| book.len()), Some(&&case.book[..]), "{}", case.name);
        }
    }
    println!("{} cases in {} books", names.len(), BOOKS.len());
}

#[test]
fn output_is_the_same_on_every_run() {
    for case in book::cases("klartext").into_iter().step_by(7) {
        assert_eq!(case.compile().attempt, case.compile().attempt, "{}", case.name);
    }
}

/// The head of every output, once.
#[test]
fn head_and_frame() {
    insta::assert_snapshot!(book::find("klartext/path/line").expect("the case").compile().output);
}
