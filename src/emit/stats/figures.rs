//! The figures of a program, and what they are as JSON.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::machine::Axis;

/// What was counted; lengths in mm, times in seconds.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Figures {
    pub cutting: f64,
    pub rapid: f64,
    pub cutting_time: f64,
    pub rapid_time: f64,
    pub moves: u64,
}

impl Figures {
    fn add(&mut self, other: &Figures) {
        self.cutting += other.cutting;
        self.rapid += other.rapid;
        self.cutting_time += other.cutting_time;
        self.rapid_time += other.rapid_time;
        self.moves += other.moves;
    }
}

/// A tool in the order of its first change.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ToolFigures {
    pub number: Option<u32>,
    pub changes: u32,
    pub figures: Figures,
}

/// The figures of a program.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Stats {
    pub tools: Vec<ToolFigures>,
    /// Least and greatest coordinate of cuts, by axis, in the workpiece.
    pub extents: BTreeMap<Axis, (f64, f64)>,
    pub dwell: f64,
    pub changes: u32,
    pub change_time: f64,
    /// Moves whose start is not known: neither their way nor their time is in the figures.
    pub unknown_moves: u64,
    /// Moves whose speed is not known, such as a feed per turn without a speed: their way counts, their time does not.
    pub untimed_moves: u64,
}

impl Stats {
    pub fn total(&self) -> Figures {
        let mut all = Figures::default();
        self.tools.iter().for_each(|tool| all.add(&tool.figures));
        all
    }

    /// Seconds of everything.
    pub fn time(&self) -> f64 {
        let all = self.total();
        all.cutting_time + all.rapid_time + self.dwell + self.change_time
    }
}

/// To a thousandth: the rest is rounding of sums.
pub fn short(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0 + 0.0
}

impl Stats {
    /// The figures as an object; lengths in mm, times in seconds.
    pub fn object(&self) -> Value {
        let figures = |figures: &Figures| {
            json!({
                "cutting_mm": short(figures.cutting),
                "rapid_mm": short(figures.rapid),
                "cutting_s": short(figures.cutting_time),
                "rapid_s": short(figures.rapid_time),
                "moves": figures.moves,
            })
        };
        let tools: Vec<Value> = self
            .tools
            .iter()
            .map(|tool| {
                let mut object = figures(&tool.figures);
                object["tool"] = json!(tool.number);
                object["changes"] = json!(tool.changes);
                object
            })
            .collect();
        let extents: serde_json::Map<String, Value> = self
            .extents
            .iter()
            .map(|(axis, (low, high))| (axis.letter().to_string(), json!([short(*low), short(*high)])))
            .collect();
        let mut object = figures(&self.total());
        object["tools"] = json!(tools);
        object["extents"] = json!(extents);
        object["dwell_s"] = json!(short(self.dwell));
        object["tool_changes"] = json!(self.changes);
        object["tool_change_s"] = json!(short(self.change_time));
        object["time_s"] = json!(short(self.time()));
        object["unknown_moves"] = json!(self.unknown_moves);
        object["untimed_moves"] = json!(self.untimed_moves);
        object
    }
}
