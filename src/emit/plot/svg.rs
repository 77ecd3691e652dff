//! A picture as SVG that needs nothing else.

use std::fmt::Write as _;
use std::io::{self, Write as _};

use crate::geo::{Point2, SAME_POINT, distance, turned};

use super::super::Output;
use super::Stop;
use super::canvas::{Anchor, COLOURS, Canvas, Class, Ink, LOUD, Look, ON_DARK, PALE, Part, Widths, Words, shade};
use super::layout::Layout;

/// How every picture begins.
pub const MARK: &str = "<!-- (partc plot) -->\n";
/// Bytes collected before the output gets them.
const CHUNK: usize = 64 * 1024;
/// Size of most words beside the title, in that of the title.
const SMALL: f64 = 0.8;

/// Writes a picture.
pub(super) struct Svg<'a> {
    out: &'a mut dyn Output,
    text: Vec<u8>,
    error: Option<io::Error>,
    font: f64,
    /// The group of paths, where y leads upwards, is open.
    in_paths: bool,
}

/// The classes that a picture uses, in the order of the style sheet.
#[derive(Debug, Default)]
pub(super) struct Used {
    classes: Vec<Class>,
    pale: bool,
    loud: bool,
}

impl Used {
    pub(super) fn note(&mut self, class: Class) {
        if !self.classes.contains(&class) {
            self.classes.push(class);
        }
    }
}

/// Notes which classes are used.
impl Canvas for Used {
    fn path(&mut self, class: Class, _: Option<&str>, _: &[Part]) {
        self.note(class);
    }

    fn words(&mut self, words: &Words<'_>) {
        self.loud |= words.loud;
    }

    fn pale(&mut self, is: bool) {
        self.pale |= is;
    }
}

impl<'a> Svg<'a> {
    pub(super) fn new(
        out: &'a mut dyn Output,
        layout: &Layout,
        widths: Widths,
        used: &Used,
        (title, stop): (&str, Option<&Stop>),
    ) -> Svg<'a> {
        let (x, y, w, h) = layout.frame();
        let mut s = String::new();
        let frame = [x, y, w, h].map(show);
        let _ = writeln!(
            s,
            "{MARK}<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"{}\"{}>\n<title>{}</title>",
            show(w / layout.pixel),
            show(h / layout.pixel),
            frame.join(" "),
            stop.map(incomplete).unwrap_or_default(),
            escaped(title)
        );
        style(&mut s, layout, widths, used);
        let [x, y, w, h] = frame;
        let _ = writeln!(s, "<rect class=\"back\" x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\"/>");
        Svg { out, text: s.into_bytes(), error: None, font: layout.font, in_paths: false }
    }

    /// # Errors
    /// The first error of the output.
    pub(super) fn finish(mut self) -> io::Result<()> {
        self.paths(false);
        self.text.extend_from_slice(b"</svg>\n");
        self.send();
        self.error.map_or(Ok(()), Err)
    }

    fn send(&mut self) {
        if self.error.is_none()
            && let Err(error) = self.out.append(&self.text)
        {
            self.error = Some(error);
        }
        self.text.clear();
    }

    fn paths(&mut self, open: bool) {
        if self.in_paths != open {
            self.text.extend_from_slice(if open {
                b"<g transform=\"scale(1 -1)\" fill=\"none\">\n"
            } else {
                b"</g>\n"
            });
            self.in_paths = open;
        }
    }

    fn point(&mut self, command: &[u8], p: Point2) {
        self.text.extend_from_slice(command);
        number(&mut self.text, p.x);
        self.text.push(b' ');
        number(&mut self.text, p.y);
    }

    fn arc(&mut self, from: Point2, center: Point2, sweep: f64, to: Point2) {
        let radius = distance(from, center);
        // An arc of SVG needs two different ends.
        let parts = if sweep.abs() > 3.0 { 2 } else { 1 };
        let mut at = from;
        for part in 1..=parts {
            let end = if part == parts {
                to
            } else {
                center + turned(from - center, sweep * f64::from(part) / f64::from(parts))
            };
            if distance(at, end) > SAME_POINT {
                self.text.push(b'A');
                number(&mut self.text, radius);
                self.text.push(b' ');
                number(&mut self.text, radius);
                self.point(if sweep > 0.0 { b" 0 0 1 " } else { b" 0 0 0 " }, end);
            }
            at = end;
        }
    }
}

impl Canvas for Svg<'_> {
    fn path(&mut self, class: Class, title: Option<&str>, parts: &[Part]) {
        self.paths(true);
        let _ = write!(self.text, "<path class=\"{}\" d=\"", names(class));
        let mut at = Point2::origin();
        for part in parts {
            match *part {
                Part::Move(p) => self.point(b"M", p),
                // A point is drawn as a line without length.
                Part::Line(p) if p == at => self.text.extend_from_slice(b"h0"),
                Part::Line(p) => self.point(b"L", p),
                Part::Arc { center, sweep, to } => self.arc(at, center, sweep, to),
                Part::Close => self.text.push(b'Z'),
            }
            at = match *part {
                Part::Move(p) | Part::Line(p) | Part::Arc { to: p, .. } => p,
                Part::Close => at,
            };
        }
        match title {
            Some(title) => {
                let _ = writeln!(self.text, "\"><title>{}</title></path>", escaped(title));
            }
            None => self.text.extend_from_slice(b"\"/>\n"),
        }
        if self.text.len() > CHUNK {
            self.send();
        }
    }

    fn pale(&mut self, is: bool) {
        self.paths(true);
        self.text.extend_from_slice(if is { b"<g class=\"after\">\n" } else { b"</g>\n" });
    }

    fn words(&mut self, words: &Words<'_>) {
        self.paths(false);
        let is = |size: f64| (words.font - size * self.font).abs() < 1e-9 * self.font;
        let size = match words.font {
            _ if words.loud => " class=\"loud\"".to_owned(),
            _ if is(1.0) => String::new(),
            _ if is(SMALL) => " class=\"small\"".to_owned(),
            font => format!(" style=\"font-size:{}px\"", show(font)),
        };
        let anchor = match words.anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let (x, y) = (show(words.at.x), show(-words.at.y));
        let turn = if words.upright { format!(" transform=\"rotate(-90 {x} {y})\"") } else { String::new() };
        let _ = writeln!(self.text, "<text{size} x=\"{x}\" y=\"{y}\"{anchor}{turn}>{}</text>", escaped(words.text));
    }
}

/// What tells a tool that the path is not whole: the code of the first error, its file and line.
fn incomplete(stop: &Stop) -> String {
    let Stop { code, file, line, .. } = stop;
    format!(" class=\"incomplete\" data-code=\"{code}\" data-file=\"{}\" data-line=\"{line}\"", escaped(file))
}

/// Names of a class in the style sheet.
fn names(class: Class) -> String {
    let (name, tool) = match class {
        Class::Grid => ("grid", None),
        Class::Axis => ("axis", None),
        Class::Centre => ("centre", None),
        Class::Cut(i) => ("c", Some(i)),
        Class::Key(i) => ("k", Some(i)),
        Class::Rapid(i) => ("r", Some(i)),
        Class::Thread(i) => ("h", Some(i)),
        Class::Dot(i) => ("d", Some(i)),
        Class::Contour => ("p", None),
        Class::Edge => ("e", None),
        Class::Hatch => ("s", None),
        Class::Blank => ("b", None),
        Class::Arrow(i) => ("a", Some(i)),
        Class::Start => ("start", None),
        Class::End => ("end", None),
        Class::Dimension => ("g", None),
        Class::DimensionArrow => ("ga", None),
    };
    tool.map_or(name.to_owned(), |i| format!("{name} t{}", shade(i)))
}

fn style(s: &mut String, layout: &Layout, widths: Widths, used: &Used) {
    let (font, small) = (show(layout.font), show(layout.font * SMALL));
    let _ = write!(
        s,
        "<style>\n.back{{fill:#fff}} text{{font:{font}px sans-serif;fill:#333}} .small{{font-size:{small}px}}\n\
         path{{vector-effect:non-scaling-stroke}}\n"
    );
    let mut written: Vec<String> = Vec::new();
    let mut dark = String::new();
    let mut tools: Vec<usize> = Vec::new();
    if used.pale {
        let _ = writeln!(s, ".after{{opacity:{}}}", show(PALE));
    }
    if used.loud {
        let _ = writeln!(s, ".loud{{fill:#{:06x};font-weight:bold}}", LOUD.0);
        let _ = write!(dark, " .loud{{fill:#{:06x}}}", LOUD.1);
    }
    for class in &used.classes {
        let names = names(*class);
        let name = names.split(' ').next().unwrap_or_default().to_owned();
        let look = class.look(widths);
        if let Ink::Tool(i) = look.ink
            && !tools.contains(&i)
        {
            tools.push(i);
        }
        if !written.contains(&name) {
            let _ = writeln!(s, ".{name}{{{}}}", rules(&look));
            if let Ink::Fixed(light, on_dark) = look.ink
                && light != on_dark
            {
                let what = if look.filled { "fill" } else { "stroke" };
                let _ = write!(dark, " .{name}{{{what}:#{on_dark:06x}}}");
            }
            written.push(name);
        }
    }
    tools.sort_unstable();
    for i in &tools {
        let _ = write!(s, ".t{i}{{color:#{:06x}}} ", COLOURS.get(*i).copied().unwrap_or_default());
    }
    s.push_str("\n.c:hover,.r:hover,.h:hover{stroke-width:4px;stroke-opacity:1}\n");
    s.push_str("@media (prefers-color-scheme:dark){.back{fill:#16181c} text{fill:#ddd}");
    s.push_str(&dark);
    for i in tools {
        let _ = write!(s, " .t{i}{{color:#{:06x}}}", ON_DARK.get(i).copied().unwrap_or_default());
    }
    s.push_str("}\n</style>\n");
}

fn rules(look: &Look) -> String {
    let ink = match look.ink {
        Ink::Tool(_) => "currentColor".to_owned(),
        Ink::Fixed(light, _) => format!("#{light:06x}"),
    };
    if look.filled {
        return format!("fill:{ink}");
    }
    let mut s = format!("stroke:{ink};stroke-width:{}px", show(look.width));
    if !look.dash.is_empty() {
        let dash: Vec<String> = look.dash.iter().map(|length| show(*length)).collect();
        let _ = write!(s, ";stroke-dasharray:{}", dash.join(" "));
    }
    if look.opacity < 1.0 {
        let _ = write!(s, ";stroke-opacity:{}", show(look.opacity));
    }
    if look.round {
        s.push_str(";stroke-linejoin:round;stroke-linecap:round");
    }
    s
}

/// A number of the picture: four places, no trailing zeros, no `-0`.
fn number(out: &mut Vec<u8>, value: f64) {
    let start = out.len();
    let _ = write!(out, "{value:.4}");
    while out.last() == Some(&b'0') {
        out.pop();
    }
    if out.last() == Some(&b'.') {
        out.pop();
    }
    if out.get(start..) == Some(b"-0") {
        out.truncate(start);
        out.push(b'0');
    }
}

pub(super) fn show(value: f64) -> String {
    let mut out = Vec::new();
    number(&mut out, value);
    String::from_utf8(out).unwrap_or_default()
}

fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars().take(200) {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            // No characters of XML.
            '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}
