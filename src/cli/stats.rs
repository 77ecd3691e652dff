//! `partc stats`: ways, times, tools and extents of programs.

use std::fmt::Write as _;

use serde_json::{Value, json};

use crate::emit::stats::{Figures, Model, SMOOTH_DEG, Stats, short};
use crate::text::decode::{escaped_json, harmless_lines};

use super::args::{Stats as Args, StatsFormat};
use super::closure::Targets;
use super::inputs::inputs;
use super::listing::print;
use super::made::is_output;
use super::program::{Loaded, is_program, load};
use super::progress::Ticker;
use super::report::{Reporter, Stdout};
use super::{Exit, Trouble};

/// `partc stats`
pub(super) fn stats(args: &Args) -> Result<Exit, Trouble> {
    let model = args.timing.model();
    let found = inputs(&args.inputs, &args.many, &|path| is_program(path, &args.common) && !is_output(path))?;
    let mut reporter = Reporter::new(&args.common, &args.findings, Stdout::Taken, None);
    found.troubles.into_iter().for_each(|trouble| reporter.trouble(trouble));
    let look = reporter.look_at(found.list.len(), &args.common);
    let targets = Targets::new(reporter.files());
    let mut programs = Vec::new();
    for (done, input) in found.list.iter().enumerate() {
        reporter.progress(done, found.list.len());
        match load(&input.path, &args.common) {
            Ok(Loaded { session, dialect, settings, files, place }) => {
                let ticker = Ticker::start(found.list.len() == 1, &place);
                let stats = session.stats(dialect, &settings, &files, model);
                drop(ticker);
                targets.spare(&input.path, &args.common, &files)?;
                // Of a program with errors nobody knows what it does.
                if !look.fails(&session) {
                    programs.push((input.path.display().to_string(), stats));
                }
                reporter.session(session);
            }
            Err(trouble) => reporter.trouble(trouble),
        }
    }
    let text = match args.form {
        StatsFormat::Table => {
            programs.iter().map(|(name, stats)| table(name, stats, &model)).collect::<Vec<_>>().join("\n")
        }
        StatsFormat::Json => {
            let list: Vec<Value> = programs.iter().map(|(name, stats)| object(name, stats)).collect();
            let model = json!({
                "rapid_mm_min": model.rapid,
                "acceleration_m_s2": model.acceleration,
                "tool_change_s": model.tool_change,
                "smooth_deg": SMOOTH_DEG,
            });
            let all = json!({ "version": 1, "model": model, "programs": list });
            format!("{}\n", escaped_json(&all.to_string()))
        }
        StatsFormat::Csv => csv(&programs),
    };
    if !programs.is_empty() || args.form != StatsFormat::Table {
        print(text.as_bytes())?;
    }
    reporter.finish()
}

/// `1:02:03`, or `2:03.4` below an hour.
fn clock(seconds: f64) -> String {
    let tenths = (seconds * 10.0).round() as u64;
    let (hours, minutes, rest) = (tenths / 36_000, tenths / 600 % 60, tenths % 600);
    if hours > 0 {
        format!("{hours}:{minutes:02}:{:02}", rest / 10)
    } else {
        format!("{minutes}:{:02}.{}", rest / 10, rest % 10)
    }
}

fn row(name: &str, figures: &Figures) -> String {
    format!(
        "  {name:12} {:>12.1} {:>12.1} {:>10} {:>10} {:>9}\n",
        figures.cutting,
        figures.rapid,
        clock(figures.cutting_time),
        clock(figures.rapid_time),
        figures.moves
    )
}

fn table(name: &str, stats: &Stats, model: &Model) -> String {
    let mut text = format!("{}\n", harmless_lines(name));
    text += "               cutting mm     rapid mm    cutting      rapid     moves\n";
    for tool in &stats.tools {
        let name = tool.number.map_or("no tool".to_owned(), |number| format!("T{number}"));
        text += &row(&name, &tool.figures);
    }
    text += &row("all", &stats.total());
    for (axis, (low, high)) in &stats.extents {
        let _ = writeln!(text, "  {} {low:.4} to {high:.4}", axis.letter());
    }
    let _ = writeln!(
        text,
        "  time {}: dwell {}, {} tool changes {}",
        clock(stats.time()),
        clock(stats.dwell),
        stats.changes,
        clock(stats.change_time)
    );
    let _ = writeln!(
        text,
        "  as if rapid were {} mm/min, acceleration {} m/s², a tool change {} s; stops between moves that turn by more than {SMOOTH_DEG}°",
        model.rapid, model.acceleration, model.tool_change
    );
    if stats.unknown_moves > 0 {
        let begin =
            if stats.unknown_moves == 1 { "1 move begins" } else { &format!("{} moves begin", stats.unknown_moves) };
        let _ = writeln!(text, "  {begin} an unknown place: not in the figures");
    }
    if stats.untimed_moves > 0 {
        let _ = writeln!(text, "  {} moves have no speed that is known: their time is missing", stats.untimed_moves);
    }
    text
}

fn object(name: &str, stats: &Stats) -> Value {
    let mut object = stats.object();
    object["file"] = json!(name);
    object
}

/// A line for each tool of each program.
fn csv(programs: &[(String, Stats)]) -> String {
    let mut text = "file,tool,changes,moves,cutting_mm,rapid_mm,cutting_s,rapid_s\n".to_owned();
    for (name, stats) in programs {
        let name = format!("\"{}\"", name.replace('"', "\"\""));
        for tool in &stats.tools {
            let figures = &tool.figures;
            let number = tool.number.map_or(String::new(), |number| number.to_string());
            let _ = writeln!(
                text,
                "{name},{number},{},{},{},{},{},{}",
                tool.changes,
                figures.moves,
                short(figures.cutting),
                short(figures.rapid),
                short(figures.cutting_time),
                short(figures.rapid_time)
            );
        }
    }
    text
}
