//! The figures of a program as JSON.

use serde_json::{Value, json};

use super::{Figures, Stats};

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
