use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int32Type, Int64Type};
use arrow_array::{Array, RecordBatch};

use super::*;
use crate::diagnostics::Severity;
use crate::text::{Files, files::Folder};
use crate::{Program, Settings, trace_batches};

const CALLS: &str = "0 BEGIN PGM A MM\n1 TOOL CALL 3 Z S2000\n2 L X+0 Y+0 Z+10 R0 FMAX M3\n3 CALL PGM B\n\
                     4 CC X+0 Y+5\n5 C X+0 Y+0 DR+ F300\n6 L X+0 Y+0\n7 L X+10 F100\n8 M30\n9 END PGM A MM\n";
const CALLED: &str = "0 BEGIN PGM B MM\n1 L X+5 F200\n2 L X+0\n3 END PGM B MM\n";

fn batches(text: &str, files: &dyn Files, rows: usize) -> Vec<RecordBatch> {
    let mut all = Vec::new();
    let program = Program::new("A.H", text.as_bytes()).unwrap();
    let options = Options { rows, ..Options::default() };
    let mut take = |batch| {
        all.push(batch);
        true
    };
    let found = trace_batches(&program, &Settings::default(), files, options, &mut take);
    assert!(found.iter().all(|finding| finding.severity != Severity::Error), "{found:?}");
    all
}

fn folder() -> Folder {
    let mut folder = Folder::default();
    folder.add("B.H", CALLED.as_bytes());
    folder
}

/// One row as text, for comparisons.
fn rows(batches: &[RecordBatch]) -> Vec<String> {
    let mut rows = Vec::new();
    for batch in batches {
        for row in 0..batch.num_rows() {
            let cells = batch.columns().iter().map(|column| cell(column, row)).collect::<Vec<_>>();
            rows.push(cells.join("|"));
        }
    }
    rows
}

fn cell(column: &ArrayRef, row: usize) -> String {
    if column.is_null(row) {
        return String::new();
    }
    match column.data_type() {
        arrow_schema::DataType::Float64 => column.as_primitive::<Float64Type>().value(row).to_string(),
        arrow_schema::DataType::Int64 => column.as_primitive::<Int64Type>().value(row).to_string(),
        arrow_schema::DataType::Boolean => column.as_boolean().value(row).to_string(),
        arrow_schema::DataType::Utf8 => column.as_string::<i32>().value(row).to_owned(),
        _ => {
            let words = column.as_dictionary::<Int32Type>();
            words.values().as_string::<i32>().value(words.key(row).unwrap()).to_owned()
        }
    }
}

#[test]
fn the_time_stands_where_the_schema_says() {
    assert_eq!(schema().field(TIME).name(), "time");
    assert_eq!(schema().fields().len(), COLUMNS.len());
}

#[test]
fn a_row_for_each_move() {
    let rows = rows(&batches(CALLS, &folder(), 100));
    let of = |row: usize, name: &str| {
        let place = COLUMNS.iter().position(|column| column.name == name).unwrap();
        rows[row].split('|').nth(place).unwrap().to_owned()
    };
    assert_eq!(rows.len(), 5, "{rows:#?}");
    let row = |row: usize, names: &[&str]| names.iter().map(|name| of(row, name)).collect::<Vec<_>>().join(" ");
    let facts = ["kind", "start_x", "x", "feed", "feed_mode", "tool", "spindle", "spindle_direction", "block"];
    assert_eq!(row(0, &facts), "rapid  0   3 2000 cw 2");
    assert_eq!(row(1, &facts), "line 0 5 200 per_minute 3 2000 cw 1");
    assert_eq!(row(1, &["file", "line", "call_path", "length"]), "B.H 2 A.H:4 5");
    assert_eq!(row(3, &["kind", "i", "j", "k", "radius", "sweep", "plane"]), "arc 0 5  5 360 XY");
    assert_eq!(row(4, &["x", "length", "call_path"]), "10 10 ");
}

#[test]
fn rows_are_the_same_in_batches_of_any_length() {
    let whole = rows(&batches(CALLS, &folder(), 100));
    for length in 1..8 {
        let parts = batches(CALLS, &folder(), length);
        assert!(parts.iter().all(|part| part.num_rows() <= length));
        assert!(parts.iter().rev().skip(1).all(|part| part.num_rows() == length));
        assert_eq!(rows(&parts), whole, "batches of {length}");
    }
}

#[test]
fn times_and_lengths_are_those_of_the_figures() {
    let all = batches(CALLS, &folder(), 2);
    let sum = |name: &str| -> f64 {
        all.iter().flat_map(|batch| batch[name].as_primitive::<Float64Type>().iter().flatten()).sum()
    };
    let program = Program::new("A.H", CALLS.as_bytes()).unwrap();
    let dialect = crate::languages::find("klartext").unwrap();
    let text = Box::new(crate::files::Memory::new(CALLS.as_bytes()));
    let session = crate::Session::new(crate::files::Opened { name: "A.H".into(), identity: "A.H".into(), text });
    let stats = session.stats(dialect, &Settings::default(), &folder(), Model::default());
    let figures = stats.total();
    assert!((sum("time") - figures.cutting_time - figures.rapid_time).abs() < 1e-9, "{program:?}");
    assert!((sum("length") - figures.cutting - figures.rapid).abs() < 1e-9);
    assert!(sum("time") > 1.0);
}

#[test]
fn who_has_enough_gets_no_more() {
    let program = Program::new("A.H", CALLS.as_bytes()).unwrap();
    let mut taken = 0;
    let mut take = |_| {
        taken += 1;
        false
    };
    let options = Options { rows: 1, ..Options::default() };
    trace_batches(&program, &Settings::default(), &folder(), options, &mut take);
    assert_eq!(taken, 1);
}

/// The moves of so many passes; with a fault behind the last one.
fn passes(count: usize, fault: &str) -> String {
    let body: String = (0..count)
        .map(|n| format!("{} L X+{} Y+{}.{}\n{} CALL PGM B\n", 4 * n + 5, 10 + n % 50, n % 7, n % 10, 4 * n + 6))
        .collect();
    format!(
        "0 BEGIN PGM A MM\n1 TOOL CALL 3 Z S2000\n2 L X+0 Y+0 Z+10 R0 FMAX M3\n3 L Z+1 F100\n{body}{fault}9999 END PGM A MM\n"
    )
}

/// Rows and error codes of a program that may have errors.
fn run(text: &str, until: Until, most: usize) -> (Vec<String>, Vec<&'static str>) {
    let (mut all, program) = (Vec::new(), Program::new("A.H", text.as_bytes()).unwrap());
    let mut take = |batch| {
        all.push(batch);
        all.len() < most
    };
    let options = Options { rows: 100, until, ..Options::default() };
    let found = trace_batches(&program, &Settings::default(), &folder(), options, &mut take);
    let errors = found.iter().filter(|finding| finding.severity == Severity::Error).map(|finding| finding.code);
    (rows(&all), errors.collect())
}

#[test]
fn a_second_thread_makes_the_same_rows() {
    // Each pass has three moves: the first program is one chunk, the others are many.
    let short = rows(&batches(&passes(500, ""), &folder(), 100));
    assert!(short.len() < chunk::MOST, "{}", short.len());
    for count in [682, 683, 684, 1365, 4000] {
        let long = rows(&batches(&passes(count, ""), &folder(), 100));
        assert_eq!(long.len(), 3 * count + 2);
        // How the last move of the short one ends is told by the next one.
        assert_eq!(long[..short.len() - 1], short[..short.len() - 1], "{count}");
        assert_eq!(long, rows(&batches(&passes(count, ""), &folder(), 1 << 16)), "{count}");
    }
}

#[test]
fn an_error_ends_the_batches() {
    const FAULT: &str = "7000 L X+Q99\n7001 L X+1\n7002 L X+Q98\n";
    for count in [10, 700, 1400, 3000] {
        let whole = rows(&batches(&passes(count, ""), &folder(), 100));
        let (all, errors) = run(&passes(count, FAULT), Until::Taken, usize::MAX);
        assert_eq!(errors.len(), 2, "{errors:?}");
        let (first, error) = run(&passes(count, FAULT), Until::FirstError, usize::MAX);
        assert_eq!((error.len(), &first), (1, &all), "{error:?}");
        // Batches that were full and whose times were known.
        assert!(whole.len() - first.len() <= 101, "{} of {}", first.len(), whole.len());
        assert_eq!((&first[..], first.len() % 100), (&whole[..first.len()], 0));
    }
}

#[test]
fn findings_may_be_wanted_without_moves() {
    const FAULT: &str = "7000 L X+Q99\n";
    for count in [10, 3000] {
        let (rows, errors) = run(&passes(count, FAULT), Until::End, 1);
        assert_eq!((rows.len() <= 100, errors.len()), (true, 1), "{errors:?}");
        let (rows, errors) = run(&passes(count, FAULT), Until::Taken, 1);
        assert!(rows.len() <= 100 && errors.len() <= 1);
    }
}

/// 30 degrees about X: rows tell places of the workpiece, and where the tool points.
#[test]
fn rows_of_a_tilted_plane_tell_the_workpiece() {
    use crate::geo::rotation::spatial;
    use crate::ir::motion::Move;
    use crate::ir::tilt::{Solution, Tilt, Tilting};
    use crate::ir::{Function, Origin, Pos};
    use crate::machine::axis::AxisSet;

    let text = Box::new(crate::text::Memory::new(b"1 L X+1\n".to_vec()));
    let name = "A.H".to_owned();
    let session = crate::driver::Session::new(crate::text::Opened { identity: name.clone(), name, text });
    let known = Known { sources: &session.sources, trail: &session.trail, diags: &session.diags };
    let mut all = Vec::new();
    let mut take = |batch| {
        all.push(batch);
        true
    };
    batches_of(known, &mut take, &|sink| {
        let origin = Origin::default();
        let plane =
            Tilt { axes: spatial([30.0, 0.0, 0.0]), origin: [0.0, 0.0, 5.0].into(), solution: Solution::Control };
        sink.function(&Function::Tilt(Box::new(Tilting::Into(plane))), &origin);
        let end = Pos::of_main([1.0, 2.0, 0.0], AxisSet::MAIN);
        sink.movement(&Move { end, axes: AxisSet::MAIN, ..Move::default() }, &origin);
        sink.function(&Function::Tilt(Box::new(Tilting::Off)), &origin);
        let mut top = Pos::UNKNOWN;
        top.set(crate::machine::Axis::Z, 0.0);
        sink.movement(&Move { end: top, axes: top.known(), machine: true, ..Move::default() }, &origin);
        sink.movement(&Move { end, axes: AxisSet::MAIN, ..Move::default() }, &origin);
    });
    let of = |name: &str| {
        let place = COLUMNS.iter().position(|column| column.name == name).unwrap();
        let values = all[0].column(place).as_primitive::<Float64Type>().clone();
        values.iter().map(|value| value.map(|value| (value * 1000.0).round())).collect::<Vec<_>>()
    };
    // 2 cos 30 along Y, 2 sin 30 along Z from 5 on.
    assert_eq!([of("x")[0], of("y")[0], of("z")[0]], [Some(1000.0), Some(1732.0), Some(6000.0)]);
    assert_eq!(of("tx"), [Some(0.0), None, Some(0.0)]);
    assert_eq!(of("ty"), [Some(-500.0), None, Some(0.0)]);
    assert_eq!(of("tz"), [Some(866.0), None, Some(1000.0)]);
}

fn batches_of(known: Known<'_>, take: &mut Take<'_>, run: &dyn Fn(&mut dyn Sink)) {
    super::batches(known, Options::default(), take, |sink| run(sink));
}
