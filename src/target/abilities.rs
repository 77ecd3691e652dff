//! What a target can say, in short words: for `partc targets` and docs/targets.md.

use super::Target;

impl Target {
    /// Each ability, and the words or the limit for it; `-` where the target has none.
    pub fn abilities(&self) -> Vec<(&'static str, String)> {
        let text = |word: Option<&str>| word.unwrap_or("-").to_owned();
        let offsets = [self.offsets.first(), self.offsets.last()].map(|word| word.copied().unwrap_or("-"));
        let turns = self.arcs.turns.map(|address| format!("{} turns in a block", address as char));
        let most = |sweep: f64| format!("blocks of {} degrees", libm::round(sweep.to_degrees()));
        let digits = if self.line.digits == 0 { "any".to_owned() } else { self.line.digits.to_string() };
        let tools = if self.tool.most == u32::MAX { "any".to_owned() } else { format!("to {}", self.tool.most) };
        let stop = if self.flow.optional_stop_is_idle { "read, does not stop" } else { self.flow.optional_stop };
        vec![
            ("output file", format!(".{}", self.extension)),
            ("first and last line", text(self.frame.first)),
            ("longest line", self.line.length.to_string()),
            ("digits of a number", digits),
            ("axes", self.axes.to_owned()),
            ("feed per minute", self.feed.per_minute.to_owned()),
            ("feed per revolution", text(self.feed.per_revolution)),
            ("feed by time", text(self.feed.inverse_time)),
            ("threads", text(self.motion.thread.map(|(word, _)| word))),
            ("arcs", turns.unwrap_or_else(|| most(self.arcs.most_sweep))),
            ("machine coordinates", self.motion.machine.to_owned()),
            ("work offsets", offsets.join(" to ")),
            ("X as a diameter", if self.frame.lathe_diameter.is_some() { "yes" } else { "-" }.to_owned()),
            ("radius compensation", text(self.compensation.as_ref().map(|words| words.left))),
            ("tool numbers", tools),
            ("tool change", text(self.tool.change)),
            ("tool length", text(self.tool.length.as_ref().map(|words| words.on))),
            ("cutting speed", text(self.spindle.cutting_speed.as_ref().map(|words| words.on))),
            ("spindle at an angle", text(self.spindle.orient.map(|(word, _)| word))),
            ("more spindles", text(self.spindle.other.map(|_| "yes"))),
            ("mist", text(self.coolant.mist)),
            ("optional stop", stop.to_owned()),
            ("other M functions", if self.m.open { "as in pass_m" } else { "-" }.to_owned()),
        ]
    }
}
