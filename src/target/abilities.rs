//! What a target can say, in short words: for `partc targets` and docs/targets.md.

use super::{
    Change, Dialog, DwellUnit, Form, Length, Limit, PathBound, ProgramName, RigidTap, Sequence, Target, Turns,
};

type Abilities = Vec<(&'static str, String)>;

impl Target {
    /// Each ability, and the words or the limit for it; `-` where the target has none.
    pub fn abilities(&self) -> Abilities {
        [self.in_its_text(), self.in_moves(), self.in_its_frame(), self.in_functions()].concat()
    }

    fn dialog(&self) -> Option<&'static Dialog> {
        match self.form {
            Form::Words => None,
            Form::Dialog(dialog) => Some(dialog),
        }
    }

    fn in_its_text(&self) -> Abilities {
        let digits = if self.line.digits == 0 { "any".to_owned() } else { self.line.digits.to_string() };
        let sequence = match self.line.sequence {
            Sequence::Address(address, most) => format!("{} to {most}", address as char),
            Sequence::Blocks => "always".to_owned(),
            Sequence::None => "-".to_owned(),
        };
        let name = match self.frame.name {
            ProgramName::None => "-".to_owned(),
            ProgramName::Number { letter, digits, .. } => format!("{}{:0digits$}", letter as char, 1),
            ProgramName::Text { front, most, .. } => {
                format!("{front}, {most} characters").trim_start_matches(", ").to_owned()
            }
        };
        vec![
            ("output file", format!(".{}", self.extension)),
            ("first and last line", text(self.dialog().map(|dialog| dialog.begin).or(self.frame.first))),
            ("name of a program", name),
            ("number of a block", sequence),
            ("longest line", self.line.length.to_string()),
            ("point in all numbers", if self.numbers.point { "yes" } else { "-" }.to_owned()),
            ("digits of a number", digits),
            ("inches", if self.frame.inch_head.is_some() { "yes" } else { "-" }.to_owned()),
            ("axes", self.axes.to_owned()),
        ]
    }

    fn in_moves(&self) -> Abilities {
        let turns = self.arcs.turns.map(|turns| match turns {
            Turns::All(address) => format!("{} turns in a block", address as char),
            Turns::More(word) => format!("{word} turns in a block"),
        });
        let most = |sweep: f64| format!("blocks of {} degrees", libm::round(sweep.to_degrees()));
        let tap = self.motion.rigid_tap.map(|tap| match tap {
            RigidTap::Return { word, .. } => word.to_owned(),
            RigidTap::Cycle(words) => {
                [words.ready, Some(words.right), words.left].into_iter().flatten().collect::<Vec<_>>().join(", ")
            }
            RigidTap::InAndOut { into, out, .. } => format!("{into}, {out}"),
            RigidTap::Dialog(words) => words.plain.split(' ').nth(2).unwrap_or_default().to_owned(),
        });
        let arcs = self.dialog().map(|dialog| format!("{}, {}", dialog.arc, dialog.helix.word)).or(turns);
        vec![
            ("rapid traverse", if self.motion.rapid_at_feed { "F by `rapid_feed`" } else { "yes" }.to_owned()),
            ("feed per minute", self.feed.per_minute.to_owned()),
            ("feed per revolution", text(self.feed.per_revolution)),
            ("feed by time", text(self.feed.inverse_time)),
            ("threads", text(self.motion.thread.map(|thread| thread.word))),
            ("rigid tapping", tap.unwrap_or_else(|| "-".to_owned())),
            ("arcs", arcs.unwrap_or_else(|| most(self.arcs.most_sweep))),
            ("machine coordinates", text(self.motion.machine)),
        ]
    }

    fn in_its_frame(&self) -> Abilities {
        let last = self.more_offsets.map_or(self.offsets.len() as u8, |more| more.most);
        let offsets = match (self.offset(1), self.offset(last)) {
            (Some(first), Some(last)) => format!("{first} to {last}"),
            _ => "-".to_owned(),
        };
        let diameter = match (self.frame.lathe, self.frame.lathe_diameter) {
            (_, None) => "-",
            (Some(_), Some(_)) => "yes",
            (None, Some(_)) => "always",
        };
        let bound = self.path.within.map(|PathBound { word, length }| format!("{word} {length}"));
        vec![
            ("work offsets", offsets),
            ("X as a diameter", diameter.to_owned()),
            ("exact stop or path", text(self.path.exact)),
            ("bound of corners", bound.unwrap_or_else(|| "-".to_owned())),
            ("corners without bound", text(self.path.unbounded)),
            ("radius compensation", text(self.compensation.as_ref().map(|words| words.left))),
        ]
    }

    fn in_functions(&self) -> Abilities {
        let tools = if self.tool.most == u32::MAX { "any".to_owned() } else { format!("to {}", self.tool.most) };
        let stop = if self.flow.optional_stop_is_idle { "read, does not stop" } else { self.flow.optional_stop };
        let change = self.tool.change.map(|change| match change {
            Change::Word(word) => word.to_owned(),
            Change::Turret { digits } => format!("{}{:0digits$}{:0digits$}", self.tool.address as char, 1, 1),
            Change::Call => self.dialog().map_or("-", |dialog| dialog.tool).to_owned(),
        });
        let length = match self.tool.length {
            Length::None => "-",
            Length::WithTool => "with the tool",
            Length::Words(words) => words.on,
        };
        let speed = self.spindle.cutting_speed.as_ref().map(|words| match words.limit {
            Limit::Word(limit) => format!("{}, {limit}", words.on),
            Limit::Block(limit) => format!("{}, {limit} S", words.on),
        });
        vec![
            ("tool numbers", tools),
            ("tool change", change.unwrap_or_else(|| "-".to_owned())),
            ("tool length", length.to_owned()),
            ("cutting speed", speed.unwrap_or_else(|| "-".to_owned())),
            ("spindle at an angle", text(self.spindle.orient.map(|(word, _)| word))),
            ("more spindles", text(self.spindle.other.map(|_| "yes"))),
            ("dwell", self.wait()),
            ("mist", text(self.coolant.mist)),
            ("optional stop", stop.to_owned()),
            ("spindle, coolant, stops", if self.m.listed { "as in pass_m" } else { "yes" }.to_owned()),
            ("other M functions", if self.m.open { "as in pass_m" } else { "-" }.to_owned()),
        ]
    }

    /// The words of a wait, and what its number counts.
    fn wait(&self) -> String {
        let unit = match self.dwell.unit {
            DwellUnit::Seconds => " s",
            DwellUnit::Milliseconds => " ms",
            DwellUnit::Setting => " by `dwell_unit`",
        };
        let address = (self.dwell.address as char).to_string();
        format!("{} {}{unit}", self.dwell.word, address.trim()).replace("  ", " ")
    }
}

/// A word, or that there is none.
fn text(word: Option<&str>) -> String {
    word.unwrap_or("-").to_owned()
}
