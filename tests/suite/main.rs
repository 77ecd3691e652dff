//! The test suite: golden programs, the independent interpreter, hostile input, the command line.

#![allow(clippy::disallowed_methods, reason = "tests need not give the same bits on every platform")]

mod book;
mod boundaries;
mod captured;
mod cli;
mod cli_ci;
mod cli_config;
mod cli_diff;
mod cli_files;
mod cli_findings;
mod cli_init;
mod cli_lint;
mod cli_output;
mod cli_reports;
mod cli_run;
mod cli_schema;
mod common;
mod compensation_entry;
mod compensation_props;
mod corners;
mod cycle_cases;
mod cycle_digits;
mod cycle_parameters;
mod damage;
mod diagnostics;
mod documents;
mod endless;
mod explained;
mod facade;
mod fast_path;
mod first_round;
mod fuzz;
mod gcode;
mod golden;
mod grbl_reader;
mod hostile;
mod hostile_fk;
mod hostile_turning;
mod idle;
mod klartext_bounds;
mod klartext_cycles;
mod klartext_words;
mod layering;
mod line_ends;
mod listing;
mod long_blocks;
mod matrix;
mod meant;
mod modal;
mod mtc200;
mod mtc200_words;
mod oracle;
mod peer;
mod pictures;
mod props;
#[allow(dead_code, reason = "the measurement of a release uses more of it")]
#[path = "../quality/mod.rs"]
mod quality;
mod quality_bar;
mod reader;
mod receivers;
mod rewritten;
mod rs274;
mod same_part;
mod sinumerik;
mod sinumerik_alarms;
mod skip_marks;
mod start;
mod stock;
mod supply;
mod sweep;
mod tamper;
#[path = "../../fuzz/src/targets.rs"]
mod targets;
#[allow(dead_code, reason = "the closing line of a run uses more of it")]
mod tools;
mod transformations;
mod turning_forms;
mod turning_parameters;
mod turning_words;
mod undercut;
mod undercut_conditions;
mod undercut_tables;
mod vocabulary;
mod worked_examples;
