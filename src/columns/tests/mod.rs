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
