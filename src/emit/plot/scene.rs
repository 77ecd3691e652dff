//! What surrounds the path: head with style and grid, foot with scale bar, axes and legend.

use std::fmt::Write as _;
use std::io::Write as _;

use crate::geo::{Point2, Vec2, distance};
use crate::ir::motion::Arc;

use super::view::View;

/// Colours of tools, in order of appearance: distinct on white and on black, also for the colour-blind.
pub(super) const COLOURS: [&str; 8] =
    ["#0b78c1", "#d9480f", "#2b8a3e", "#9c36b5", "#b8860b", "#0c8599", "#c2255c", "#6b7a2f"];

/// The same on a dark ground.
const ON_DARK: [&str; 8] = ["#5bb8ff", "#ff8f5e", "#69d17a", "#d9a3f0", "#ecc94b", "#4fd1e0", "#ff7fa8", "#b7cc6a"];

/// Height of the picture in font sizes, so that letters keep their size.
const FONTS: f64 = 42.0;
/// Most grid lines in one direction.
const GRID: f64 = 24.0;

/// The rectangle that holds the path.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Extents {
    all: Option<(Point2, Point2)>,
    pub(super) cut: Option<(Point2, Point2)>,
}

impl Extents {
    pub(super) fn is_empty(&self) -> bool {
        self.all.is_none()
    }

    pub(super) fn take(&mut self, p: Point2, rapid: bool) {
        grow(&mut self.all, p);
        if !rapid {
            grow(&mut self.cut, p);
        }
    }

    /// The bulge of an arc.
    pub(super) fn take_arc(&mut self, arc: &Arc) {
        let radius = distance(arc.from, arc.center);
        let from = libm::atan2(arc.from.y - arc.center.y, arc.from.x - arc.center.x);
        let quarter = core::f64::consts::FRAC_PI_2;
        for (i, side) in [Vec2::x(), Vec2::y(), -Vec2::x(), -Vec2::y()].into_iter().enumerate() {
            let way = i as f64 * quarter - from;
            let way = if arc.sweep > 0.0 { way } else { -way };
            let way = way - libm::floor(way / (4.0 * quarter)) * 4.0 * quarter;
            if way <= arc.sweep.abs() {
                self.take(arc.center + side * radius, false);
            }
        }
    }
}

fn grow(rect: &mut Option<(Point2, Point2)>, p: Point2) {
    let (low, high) = rect.get_or_insert((p, p));
    low.x = low.x.min(p.x);
    low.y = low.y.min(p.y);
    high.x = high.x.max(p.x);
    high.y = high.y.max(p.y);
}

/// What the head and the foot need to know.
#[derive(Debug)]
pub(super) struct Scene<'a> {
    pub(super) title: &'a str,
    pub(super) view: View,
    /// X is labelled in diameters.
    pub(super) diameter: bool,
    pub(super) extents: Extents,
    pub(super) tools: &'a [Option<u32>],
    /// Names that stand for tools, where programs are drawn.
    pub(super) names: &'a [String],
    pub(super) rapids: bool,
    pub(super) threads: bool,
    pub(super) contours: bool,
    pub(super) undrawn: u64,
}

/// Places and sizes in millimetres of the part.
#[derive(Debug, Clone, Copy)]
struct Layout {
    low: Point2,
    high: Point2,
    font: f64,
}

impl Layout {
    fn new(extents: &Extents, lathe: bool) -> Layout {
        let (mut low, mut high) = extents.all.unwrap_or((Point2::new(0.0, 0.0), Point2::new(1.0, 1.0)));
        if lathe {
            // The turning centre belongs to the picture unless the part is far away from it.
            let size = (high - low).amax();
            if low.y > 0.0 && low.y <= size {
                low.y = 0.0;
            }
        }
        let size = (high - low).amax().max(1e-3);
        let room = Vec2::new(0.04, 0.04) * size;
        low -= room;
        high += room;
        // A flat path still gets a picture one can look at.
        let least = 0.3 * size;
        if high.y - low.y < least {
            let more = (least - (high.y - low.y)) / 2.0;
            low.y -= more;
            high.y += more;
        }
        if high.x - low.x < least {
            let more = (least - (high.x - low.x)) / 2.0;
            low.x -= more;
            high.x += more;
        }
        Layout { low, high, font: (high - low).amax() / FONTS }
    }

    /// The view box: x, y downwards, width, height.
    fn frame(&self) -> (f64, f64, f64, f64) {
        let (left, right, top, bottom) = (5.0 * self.font, 2.0 * self.font, 3.6 * self.font, 7.2 * self.font);
        (
            self.low.x - left,
            -self.high.y - top,
            self.high.x - self.low.x + left + right,
            self.high.y - self.low.y + top + bottom,
        )
    }

    /// Distance of grid lines: 1, 2 or 5 times a power of ten.
    fn step(&self) -> f64 {
        let rough = ((self.high - self.low).amax() / GRID).max(1e-9);
        let power = libm::pow(10.0, libm::floor(libm::log10(rough)));
        [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|step| *step >= rough).unwrap_or(rough)
    }
}

impl Scene<'_> {
    fn layout(&self) -> Layout {
        Layout::new(&self.extents, self.view.is_lathe())
    }

    /// Everything in front of the path.
    pub(super) fn head(&self) -> String {
        let layout = self.layout();
        let (x, y, w, h) = layout.frame();
        let mut s = String::new();
        let pixels = 1200.0;
        let scale = pixels / w.max(h);
        let _ = write!(
            s,
            "{}<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\">\n<title>{}</title>\n",
            super::MARK,
            show(w * scale),
            show(h * scale),
            show(x),
            show(y),
            show(w),
            show(h),
            escaped(self.title)
        );
        self.style(&mut s, layout.font);
        let _ = writeln!(
            s,
            "<rect class=\"back\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
            show(x),
            show(y),
            show(w),
            show(h)
        );
        self.grid(&mut s, &layout);
        s.push_str("<g transform=\"scale(1 -1)\" fill=\"none\">\n");
        s
    }

    fn style(&self, s: &mut String, font: f64) {
        let thin = show(font * 0.045);
        let line = show(font * 0.15);
        let centre = format!("{0} {1} {2} {1}", show(font * 1.6), show(font * 0.4), show(font * 0.3));
        let thread = format!("{0} {0}", show(font * 0.2));
        let dash = format!("{} {}", show(font * 0.5), show(font * 0.35));
        let _ = write!(
            s,
            "<style>\n.back{{fill:#fff}} text{{font:{f}px sans-serif;fill:#333}} .small{{font-size:{small}px}}\n\
             .grid{{stroke:#888;stroke-opacity:.3;stroke-width:{thin};fill:none}}\n\
             .axis{{stroke:#555;stroke-width:{axis};fill:none}} .centre{{stroke-dasharray:{centre}}}\n\
             .c{{stroke-width:{line};stroke-linejoin:round;stroke-linecap:round}}\n\
             .r{{stroke-width:{rapid};stroke-dasharray:{dash};stroke-opacity:.75}}\n\
             .d{{stroke-width:{dot};stroke-linecap:round}}\n\
             .h{{stroke-width:{line};stroke-dasharray:{thread}}}\n\
             {contour}",
            f = show(font),
            small = show(font * 0.8),
            axis = show(font * 0.08),
            rapid = show(font * 0.07),
            dot = show(font * 0.6),
            centre = centre,
            thread = thread,
            contour = if self.contours {
                ".p{stroke:#888;stroke-width:".to_owned() + &show(font * 0.07) + "}\n"
            } else {
                String::new()
            },
        );
        for (i, colour) in COLOURS.iter().enumerate() {
            let _ = write!(s, ".t{i}{{stroke:{colour}}} ");
        }
        s.push_str("\n@media (prefers-color-scheme:dark){.back{fill:#16181c} text{fill:#ddd} .axis{stroke:#aaa}");
        for (i, colour) in ON_DARK.iter().enumerate() {
            let _ = write!(s, " .t{i}{{stroke:{colour}}}");
        }
        s.push_str("}\n</style>\n");
    }

    fn grid(&self, s: &mut String, layout: &Layout) {
        let step = layout.step();
        let marks = |low: f64, high: f64| {
            let first = libm::ceil(low / step - 1e-9);
            let last = libm::floor(high / step + 1e-9);
            let count = (last - first).clamp(0.0, 4.0 * GRID) as u32;
            (0..=count).map(move |i| (first + f64::from(i)) * step)
        };
        let (low, high) = (layout.low, layout.high);
        s.push_str("<path class=\"grid\" d=\"");
        for x in marks(low.x, high.x) {
            let _ = write!(s, "M{} {}V{}", show(x), show(-low.y), show(-high.y));
        }
        for y in marks(low.y, high.y) {
            let _ = write!(s, "M{} {}H{}", show(low.x), show(-y), show(high.x));
        }
        s.push_str("\"/>\n");
        if low.y <= 0.0 && high.y >= 0.0 {
            let class = if self.view.is_lathe() { "axis centre" } else { "axis" };
            let _ = writeln!(s, "<path class=\"{class}\" d=\"M{} 0H{}\"/>", show(low.x), show(high.x));
        }
        if low.x <= 0.0 && high.x >= 0.0 {
            let _ = writeln!(s, "<path class=\"axis\" d=\"M0 {}V{}\"/>", show(-low.y), show(-high.y));
        }
        let font = layout.font;
        // Every other number if they would touch each other.
        let wide = 4.2 * font > step;
        let every = if wide { 2 } else { 1 };
        for x in marks(low.x, high.x).filter(|x| (libm::round(x / step) as i64) % every == 0) {
            let _ = writeln!(
                s,
                "<text class=\"small\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                show(x),
                show(-low.y + 1.1 * font),
                show(x)
            );
        }
        let scale = if self.diameter { 2.0 } else { 1.0 };
        for y in marks(low.y, high.y) {
            let _ = writeln!(
                s,
                "<text class=\"small\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>",
                show(low.x - 0.4 * font),
                show(-y + 0.3 * font),
                show(y * scale)
            );
        }
    }

    /// Everything behind the path.
    pub(super) fn foot(&self) -> String {
        let layout = self.layout();
        let (x, y, _, _) = layout.frame();
        let font = layout.font;
        let (right, up) = self.view.axes();
        let mut s = "</g>\n".to_owned();
        let mut text = |x: f64, y: f64, anchor: &str, t: &str| {
            let _ = writeln!(s, "<text x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\">{t}</text>", show(x), show(y));
        };
        text(x + 0.6 * font, y + 1.5 * font, "start", &escaped(self.title));
        let up_name = match (self.diameter, self.view.is_lathe()) {
            (true, _) => format!("{} diameter", up.letter()),
            (false, true) => format!("{} radius", up.letter()),
            (false, false) => up.letter().to_string(),
        };
        text(x + 0.6 * font, -layout.high.y - 0.6 * font, "start", &up_name);
        text(layout.high.x, -layout.low.y + 2.4 * font, "end", &right.letter().to_string());
        let base = -layout.low.y + 4.0 * font;
        if let Some((low, high)) = self.extents.cut.or(self.extents.all) {
            let scale = if self.diameter { 2.0 } else { 1.0 };
            let line = format!(
                "{} {} to {}, {up_name} {} to {}",
                right.letter(),
                show(low.x),
                show(high.x),
                show(low.y * scale),
                show(high.y * scale)
            );
            text(layout.low.x, base, "start", &line);
        }
        self.legend(&mut s, &layout, base + 1.7 * font);
        self.scale_bar(&mut s, &layout, base);
        s.push_str("</svg>\n");
        s
    }

    fn legend(&self, s: &mut String, layout: &Layout, y: f64) {
        let font = layout.font;
        let mut x = layout.low.x;
        let mut entry = |s: &mut String, class: &str, name: &str| {
            let _ = write!(
                s,
                "<path class=\"{class}\" fill=\"none\" d=\"M{} {}h{}\"/>",
                show(x),
                show(y - 0.3 * font),
                show(2.0 * font)
            );
            let _ = writeln!(s, "<text class=\"small\" x=\"{}\" y=\"{}\">{name}</text>", show(x + 2.4 * font), show(y));
            x += (3.4 + 0.5 * name.len() as f64) * font;
        };
        for (i, tool) in self.tools.iter().enumerate().take(COLOURS.len()) {
            let name = match self.names.get(i) {
                Some(name) => escaped(name),
                None => tool.map_or("path".to_owned(), |number| format!("T{number}")),
            };
            entry(s, &format!("c t{i}"), &name);
        }
        if self.tools.len() > COLOURS.len() {
            entry(s, "grid", &format!("{} more tools, colours repeat", self.tools.len() - COLOURS.len()));
        }
        if self.threads {
            entry(s, "h t0", "thread");
        }
        if self.contours {
            entry(s, "p", "contour");
        }
        if self.rapids {
            entry(s, "r t0", "rapid");
        }
        if self.undrawn > 0 {
            entry(s, "grid", &format!("{} moves in machine coordinates not drawn", self.undrawn));
        }
    }

    fn scale_bar(&self, s: &mut String, layout: &Layout, y: f64) {
        let font = layout.font;
        let length = layout.step() * 2.0;
        let (x, tick) = (layout.high.x - length, 0.3 * font);
        let _ = writeln!(
            s,
            "<path class=\"axis\" d=\"M{} {}v{tick}h{}v-{tick}\"/>",
            show(x),
            show(y - tick),
            show(length),
            tick = show(tick)
        );
        let _ = writeln!(
            s,
            "<text class=\"small\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{} mm</text>",
            show(x - 0.4 * font),
            show(y),
            show(length)
        );
    }
}

/// A number of the picture: four places, no trailing zeros, no `-0`.
pub(super) fn number(out: &mut Vec<u8>, value: f64) {
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

fn show(value: f64) -> String {
    let mut out = Vec::new();
    number(&mut out, value);
    String::from_utf8(out).unwrap_or_default()
}

fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars().take(120) {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}
