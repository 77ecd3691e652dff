//! The whole picture: grid, part, path, marks and words, in the order in which they lie over each other.

use std::collections::BTreeSet;

use crate::geo::{Element, Point2, Vec2};
use crate::ir::Blank;
use crate::machine::Axis;
use crate::text::{FileId, Loc, Sources};

use super::canvas::{Anchor, Canvas, Class, Part, Widths, Words};
use super::dimensions::{BROAD, LETTER, Labels, Measured};
use super::layout::{Layout, NOTICE, Needs};
use super::rect::Rect;
use super::section::Section;
use super::strokes::{Pen, Run, Stroke, Strokes};
use super::svg::show;
use super::view::View;
use super::{Stop, blank, marks};

/// Stretches of a picture that say where they come from; more are put together.
const TITLES: usize = 4000;
/// Letters shown of a line of the program.
const SHOWN: usize = 100;
/// Colours in the legend.
const NAMED: usize = 16;
/// Letters of a title or a name.
const MOST_LETTERS: usize = 60;

/// What the picture shows.
#[derive(Debug)]
pub(super) struct Scene<'a> {
    pub title: &'a str,
    pub view: View,
    /// The axis that is labelled in diameters.
    pub diameter: Option<Axis>,
    pub dimensions: bool,
    pub strokes: &'a Strokes,
    /// The programmed contour beside which the tool travels.
    pub contour: &'a Strokes,
    pub section: Section,
    /// What is cut, in the picture.
    pub cut: Rect,
    /// The least and greatest coordinates of X, Y and Z that are cut.
    pub extents: [Option<(f64, f64)>; 3],
    pub tools: &'a [Option<u32>],
    /// Names that stand for tools, where programs are drawn.
    pub names: &'a [String],
    /// Start and end of the path.
    pub ends: Option<(Point2, Point2)>,
    /// What is known again behind an error.
    pub after: &'a Strokes,
    pub blank: Option<Blank>,
    /// Why the path is not whole.
    pub stop: Option<&'a Stop>,
    /// What is said of the picture.
    pub notes: Vec<String>,
    pub sources: Option<&'a Sources>,
}

/// An entry of the legend.
enum Sample {
    Line(Class),
    Pale(Class),
    Ring,
    Square,
    None,
}

impl Scene<'_> {
    /// The layout, and how broad the path is drawn in it.
    pub(super) fn layout(&self) -> (Layout, Widths) {
        let mut rect = self.strokes.rect;
        self.after.rect.0.into_iter().for_each(|(low, high)| [low, high].into_iter().for_each(|p| rect.take(p)));
        self.blank.iter().for_each(|blank| blank::take(blank, self.view, &mut rect));
        self.contour.rect.0.into_iter().for_each(|(low, high)| [low, high].into_iter().for_each(|p| rect.take(p)));
        self.section.edges.iter().for_each(|edge| rect.take(edge.from()));
        self.section.edges.iter().for_each(|edge| rect.take(edge.to()));
        self.section.hatch.iter().for_each(|(a, b)| [a, b].into_iter().for_each(|p| rect.take(*p)));
        if let (true, Some([(u, a), (v, b)])) = (self.view.is_iso(), self.floor_extents()) {
            let corners = [(a.0, b.0), (a.0, b.1), (a.1, b.0), (a.1, b.1)];
            corners.into_iter().for_each(|(s, t)| rect.take(Point2::from(u * s + v * t)));
        }
        let (turning, notice) = (self.view.is_turning(), self.stop.is_some());
        let needs = Needs { turning, dimensions: self.dimensions, notice, ..Needs::default() };
        let first = Layout::new(&rect, needs);
        let needs = Needs { left: self.left_of(&first), ..needs };
        let needs = Needs { broad: self.broad(&Layout::new(&rect, needs)), ..needs };
        let lines = self.below(&Layout::new(&rect, needs));
        let layout = Layout::new(&rect, Needs { lines, ..needs });
        let (mut area, (mut cut, mut rapid)) = (marks::covered(self.strokes), marks::lengths(self.strokes));
        if area == 0.0 {
            (area, (cut, rapid)) = (marks::covered(self.after), marks::lengths(self.after));
        }
        let pixel = layout.pixel;
        (layout, Widths::of(cut / pixel, rapid / pixel, area / pixel / pixel))
    }

    pub(super) fn draw(&self, canvas: &mut dyn Canvas, layout: &Layout) {
        self.grid(canvas, layout);
        self.part(canvas);
        if let Some(blank) = &self.blank {
            canvas.path(Class::Blank, None, &blank::edges(blank, self.view));
        }
        let per = self.strokes_per_title();
        if !self.after.is_empty() {
            canvas.pale(true);
            self.path(canvas, self.after, &[Pen::Rapid], per);
            self.path(canvas, self.after, &[Pen::Cut, Pen::Thread, Pen::Dot], per);
            canvas.pale(false);
        }
        self.path(canvas, self.strokes, &[Pen::Rapid], per);
        self.path(canvas, self.contour, &[Pen::Contour], usize::MAX);
        self.path(canvas, self.strokes, &[Pen::Cut, Pen::Thread, Pen::Dot], per);
        marks::arrows(canvas, self.strokes, layout.pixel);
        if let Some((start, end)) = self.ends {
            marks::ends(canvas, start, end, layout.pixel);
        }
        let mut labels = Labels::within(layout);
        if self.dimensions && self.view.axes().is_some() {
            let turning = self.view.is_turning();
            let (cut, strokes, section) = (&self.cut, self.strokes, &self.section);
            let (right, up) = self.view.axes().unwrap_or((Axis::X, Axis::Y));
            let factors = (self.factor(right), self.factor(up));
            Measured { layout, cut, strokes, section, turning, factors }.draw(canvas, &mut labels);
        }
        let legend = self.legend(layout);
        self.samples(canvas, layout, &legend);
        self.scale_bar(canvas, layout);
        self.words(canvas, layout, &legend, &labels);
    }

    fn part(&self, canvas: &mut dyn Canvas) {
        if !self.section.hatch.is_empty() {
            let parts: Vec<Part> =
                self.section.hatch.iter().flat_map(|(a, b)| [Part::Move(*a), Part::Line(*b)]).collect();
            canvas.path(Class::Hatch, None, &parts);
        }
        let mut parts: Vec<Part> = Vec::new();
        let mut at = None;
        for edge in &self.section.edges {
            if at != Some(edge.from()) {
                parts.push(Part::Move(edge.from()));
            }
            parts.push(match *edge {
                Element::Line { to, .. } => Part::Line(to),
                Element::Arc { center, sweep, to, .. } => Part::Arc { center, sweep, to },
            });
            at = Some(edge.to());
        }
        if !parts.is_empty() {
            canvas.path(Class::Edge, None, &parts);
        }
    }

    /// Blocks that one title stands for.
    fn strokes_per_title(&self) -> usize {
        let mut blocks = 0usize;
        for (_, of) in self.strokes.runs().chain(self.after.runs()) {
            blocks += 1 + of.windows(2).filter(|pair| !same_block(&pair[0], &pair[1])).count();
        }
        blocks.div_ceil(TITLES).max(1)
    }

    fn path(&self, canvas: &mut dyn Canvas, strokes: &Strokes, pens: &[Pen], per: usize) {
        let mut parts: Vec<Part> = Vec::new();
        for (run, of) in strokes.runs().filter(|(run, _)| pens.contains(&run.pen)) {
            let mut from = run.from;
            let mut rest = of;
            while let Some(first) = rest.first() {
                let count = blocks_end(rest, per);
                let (now, later) = rest.split_at(count);
                parts.clear();
                parts.push(Part::Move(from));
                for stroke in now {
                    parts.push(match strokes.bend(stroke) {
                        Some(bend) => Part::Arc { center: bend.center, sweep: bend.sweep, to: stroke.to },
                        None => Part::Line(stroke.to),
                    });
                    from = stroke.to;
                }
                let title = self.source(first.loc, now.last().unwrap_or(first).loc, run);
                canvas.path(class(run), title.as_deref(), &parts);
                rest = later;
            }
        }
    }

    /// The line of the program that a stretch comes from.
    fn source(&self, first: Loc, last: Loc, run: &Run) -> Option<String> {
        let sources = self.sources.filter(|_| first.line > 0 && run.pen != Pen::Contour)?;
        let line = sources.line(first);
        let text: String = line.text.trim().chars().take(SHOWN).collect();
        let file = if first.file == FileId(0) {
            String::new()
        } else {
            let name = sources.name(first.file);
            format!("{} ", name.rsplit(['/', '\\']).next().unwrap_or(&name))
        };
        Some(if last.line == first.line || last.file != first.file {
            format!("{file}{}: {text}", first.line)
        } else {
            format!("{file}{} to {}: {text} …", first.line, last.line)
        })
    }

    fn grid(&self, canvas: &mut dyn Canvas, layout: &Layout) {
        let (low, high) = (layout.low, layout.high);
        let mut parts: Vec<Part> = Vec::new();
        let mut line = |a: Point2, b: Point2| parts.extend([Part::Move(a), Part::Line(b)]);
        if self.view.is_iso() {
            self.floor(layout, &mut line);
        } else {
            layout.marks(low.x, high.x).for_each(|x| line(Point2::new(x, low.y), Point2::new(x, high.y)));
            layout.marks(low.y, high.y).for_each(|y| line(Point2::new(low.x, y), Point2::new(high.x, y)));
        }
        canvas.path(Class::Grid, None, &parts);
        if self.view.is_iso() {
            return self.axes(canvas, layout);
        }
        if low.y <= 0.0 && high.y >= 0.0 {
            let class = if self.view.is_turning() { Class::Centre } else { Class::Axis };
            canvas.path(class, None, &[Part::Move(Point2::new(low.x, 0.0)), Part::Line(Point2::new(high.x, 0.0))]);
        }
        if low.x <= 0.0 && high.x >= 0.0 {
            canvas.path(
                Class::Axis,
                None,
                &[Part::Move(Point2::new(0.0, low.y)), Part::Line(Point2::new(0.0, high.y))],
            );
        }
    }

    /// The plane through zero under the path, seen aslant: X and Y, on a lathe Z and X.
    fn floor(&self, layout: &Layout, line: &mut impl FnMut(Point2, Point2)) {
        let Some([(u, a), (v, b)]) = self.floor_extents() else { return };
        let corner = |s: f64, t: f64| Point2::from(u * s + v * t);
        line(corner(a.0, b.0), corner(a.1, b.0));
        line(corner(a.1, b.0), corner(a.1, b.1));
        line(corner(a.1, b.1), corner(a.0, b.1));
        line(corner(a.0, b.1), corner(a.0, b.0));
        layout.marks(a.0, a.1).for_each(|s| line(Point2::from(u * s + v * b.0), Point2::from(u * s + v * b.1)));
        layout.marks(b.0, b.1).for_each(|t| line(Point2::from(u * a.0 + v * t), Point2::from(u * a.1 + v * t)));
    }

    /// The directions of the floor and what of it is drawn.
    fn floor_extents(&self) -> Option<[(Vec2, (f64, f64)); 2]> {
        let (first, second) = self.floor_axes();
        let of = |axis: Axis| {
            let (low, high) = self.extents.get(axis.index()).copied().flatten()?;
            Some((self.view.way(axis), (low.min(0.0), high.max(0.0))))
        };
        Some([of(first)?, of(second)?])
    }

    fn floor_axes(&self) -> (Axis, Axis) {
        if self.diameter.is_some() || self.extents[1].is_none() { (Axis::Z, Axis::X) } else { (Axis::X, Axis::Y) }
    }

    /// Arrows along X, Y and Z from the zero.
    fn axes(&self, canvas: &mut dyn Canvas, layout: &Layout) {
        for (way, _) in self.axis_ends(layout) {
            canvas.path(Class::Axis, None, &[Part::Move(Point2::origin()), Part::Line(Point2::from(way))]);
            marks::arrow(
                canvas,
                Class::DimensionArrow,
                Point2::from(way),
                way / way.norm().max(1e-9),
                10.0 * layout.pixel,
            );
        }
    }

    fn axis_ends(&self, layout: &Layout) -> Vec<(Vec2, char)> {
        let long = 90.0 * layout.pixel;
        Axis::ALL.iter().take(3).map(|axis| (self.view.way(*axis) * long, axis.letter())).collect()
    }

    /// The numbers on the grid.
    fn numbers(&self, layout: &Layout, canvas: &mut dyn Canvas) {
        let (low, high, font, step) = (layout.low, layout.high, layout.font, layout.step());
        let small = 0.8 * font;
        let mut text = |x: f64, y: f64, anchor: Anchor, text: &str| {
            canvas.words(&Words { at: Point2::new(x, y), anchor, font: small, upright: false, loud: false, text });
        };
        let Some((right, up)) = self.view.axes() else {
            for (way, letter) in self.axis_ends(layout) {
                text(way.x * 1.15, way.y * 1.15 - 0.3 * small, Anchor::Middle, &letter.to_string());
            }
            return;
        };
        // Every other number if they would touch each other.
        let every = if 4.2 * font > step { 2 } else { 1 };
        for x in layout.marks(low.x, high.x).filter(|x| (libm::round(x / step) as i64) % every == 0) {
            text(x, low.y - 1.1 * font, Anchor::Middle, &show(x * self.factor(right)));
        }
        for y in layout.marks(low.y, high.y) {
            text(low.x - 0.4 * font, y - 0.3 * font, Anchor::End, &self.number_at(y, up));
        }
    }

    /// The number beside a line of the grid.
    fn number_at(&self, y: f64, up: Axis) -> String {
        let value = y * self.factor(up);
        // Below the centre of a turned part the same diameters stand.
        show(if self.view.is_turning() && !self.section.edges.is_empty() { value.abs() } else { value })
    }

    /// What is written for a millimetre of this axis.
    fn factor(&self, axis: Axis) -> f64 {
        if self.diameter == Some(axis) { 2.0 } else { 1.0 }
    }

    fn axis_name(&self, axis: Axis) -> String {
        match (self.diameter == Some(axis), self.view.is_turning() && axis == Axis::X) {
            (true, _) => format!("{} diameter", axis.letter()),
            (false, true) => format!("{} radius", axis.letter()),
            (false, false) => axis.letter().to_string(),
        }
    }

    fn words(
        &self,
        canvas: &mut dyn Canvas,
        layout: &Layout,
        legend: &[(usize, f64, Sample, String)],
        labels: &Labels,
    ) {
        self.numbers(layout, canvas);
        let (x, ..) = layout.frame();
        let font = layout.font;
        let mut text = |x: f64, y: f64, anchor: Anchor, font: f64, text: &str| {
            canvas.words(&Words { at: Point2::new(x, y), anchor, font, upright: false, loud: false, text });
        };
        text(x + 0.6 * font, self.title_line(layout), Anchor::Start, font, &shortened(self.title));
        self.notice(canvas, layout);
        let mut text = |x: f64, y: f64, anchor: Anchor, font: f64, text: &str| {
            canvas.words(&Words { at: Point2::new(x, y), anchor, font, upright: false, loud: false, text });
        };
        if let Some((right, up)) = self.view.axes() {
            text(x + 0.6 * font, layout.high.y + 0.6 * font, Anchor::Start, font, &self.axis_name(up));
            text(layout.high.x, layout.low.y - 2.4 * font, Anchor::End, font, &in_mm(&self.axis_name(right)));
        }
        let base = self.base(layout);
        for (line, sizes) in self.size_lines(layout).iter().enumerate() {
            text(layout.low.x, base - 1.7 * font * line as f64, Anchor::Start, font, sizes);
        }
        let bar = self.bar_end(layout) - layout.step() * 2.0 - 0.4 * font;
        text(bar, self.title_line(layout), Anchor::End, 0.8 * font, &bar_name(layout));
        for (line, x, sample, name) in legend {
            let after = if matches!(sample, Sample::None) { 0.0 } else { 2.4 * font };
            text(layout.low.x + x + after, self.legend_line(layout, *line), Anchor::Start, 0.8 * font, name);
        }
        labels.write(canvas);
    }

    /// Below the title, that the path is not whole.
    fn notice(&self, canvas: &mut dyn Canvas, layout: &Layout) {
        let Some(stop) = self.stop else { return };
        let (x, ..) = layout.frame();
        let (font, text) = (layout.font, stop.text());
        let at = Point2::new(x + 0.6 * font, self.title_line(layout) - NOTICE * font);
        canvas.words(&Words { at, anchor: Anchor::Start, font, upright: false, loud: true, text: &text });
    }

    /// From where to where is cut.
    fn sizes(&self) -> Vec<String> {
        let order = match self.view.axes() {
            Some((right, up)) => {
                let third = Axis::ALL.iter().take(3).copied().find(|axis| *axis != right && *axis != up);
                [Some(right), Some(up), third]
            }
            None => [Some(Axis::X), Some(Axis::Y), Some(Axis::Z)],
        };
        let size = |axis: Axis| {
            let (low, high) = self.extents.get(axis.index()).copied().flatten()?;
            let factor = self.factor(axis);
            Some(format!("{} {} to {}", self.axis_name(axis), show(low * factor), show(high * factor)))
        };
        // A turned part has no third axis to speak of.
        let is_told = |axis: &Axis| !(self.view.is_turning() && *axis == Axis::Y);
        order.into_iter().flatten().filter(is_told).filter_map(size).collect()
    }

    /// The same in lines that are not longer than the picture is broad.
    fn size_lines(&self, layout: &Layout) -> Vec<String> {
        let most = layout.broad() / (BROAD * layout.font);
        let mut lines: Vec<String> = Vec::new();
        for size in self.sizes() {
            match lines.last_mut() {
                Some(line) if (line.chars().count() + size.chars().count() + 2) as f64 <= most => {
                    line.push_str(", ");
                    line.push_str(&size);
                }
                _ => lines.push(size),
            }
        }
        lines
    }

    /// What the numbers at the left need, in font sizes.
    fn left_of(&self, layout: &Layout) -> f64 {
        let Some((_, up)) = self.view.axes() else { return 0.0 };
        let letters = |y: f64| self.number_at(y, up).chars().count();
        let most = layout.marks(layout.low.y, layout.high.y).map(letters).max().unwrap_or(0);
        0.6 + 0.8 * BROAD * most as f64
    }

    /// What the words that stand on a line of their own need, from the left of the picture, in font sizes.
    fn broad(&self, layout: &Layout) -> f64 {
        let letters = |text: &str| BROAD * text.chars().count() as f64;
        let sizes = self.sizes().iter().map(|size| letters(size)).fold(0.0, f64::max);
        let entries = self.legend(layout).iter().map(|(.., name)| 2.4 + 0.8 * letters(name)).fold(0.0, f64::max);
        let bar = (self.bar_end(layout) - layout.low.x) / layout.font;
        // Bold letters are broader.
        let notice = self.stop.map_or(0.0, |stop| 0.6 + 1.1 * letters(&stop.text()));
        sizes.max(entries).max(bar).max(notice)
    }

    /// Lines of the legend and of what stands above it.
    fn below(&self, layout: &Layout) -> usize {
        self.legend(layout)
            .iter()
            .map(|(line, ..)| line + 1)
            .max()
            .unwrap_or(0)
            .max(self.size_lines(layout).len())
            .max(1)
    }

    /// Where the scale bar ends: at the right of the picture, or so far from the title that they do not touch.
    fn bar_end(&self, layout: &Layout) -> f64 {
        let letters = |text: &str| BROAD * text.chars().count() as f64;
        let words = 0.6 + letters(&shortened(self.title)) + 1.0 + 0.8 * letters(&bar_name(layout)) + 0.4;
        let (left, ..) = layout.frame();
        layout.high.x.max(left + words * layout.font + 2.0 * layout.step())
    }

    /// The line of the title and of the scale bar.
    fn title_line(&self, layout: &Layout) -> f64 {
        let (_, y, _, _) = layout.frame();
        -(y + 1.5 * layout.font)
    }

    /// The line of the sizes.
    fn base(&self, layout: &Layout) -> f64 {
        layout.low.y - 4.0 * layout.font
    }

    fn legend_line(&self, layout: &Layout, line: usize) -> f64 {
        self.base(layout) - 1.7 * layout.font * (line + 1) as f64
    }

    /// What is drawn: line, place in it, sample, name.
    fn legend(&self, layout: &Layout) -> Vec<(usize, f64, Sample, String)> {
        let font = layout.font;
        let pens = |wanted: Pen| self.strokes.runs().any(|(run, _)| run.pen == wanted);
        let runs = self.strokes.runs().chain(self.after.runs());
        let drawn: BTreeSet<usize> = runs.map(|(run, _)| run.colour).collect();
        let mut entries: Vec<(Sample, String)> = Vec::new();
        for i in drawn.iter().take(NAMED) {
            let named = i.checked_sub(1).and_then(|i| self.names.get(i));
            let name = match (named, self.tools.get(*i)) {
                (Some(name), _) => shortened(name),
                (None, Some(Some(number))) => format!("T{number}"),
                (None, _) => "path".to_owned(),
            };
            entries.push((Sample::Line(Class::Key(*i)), name));
        }
        if drawn.len() > NAMED {
            entries.push((Sample::None, format!("{} more tools", drawn.len() - NAMED)));
        }
        let first = drawn.first().copied().unwrap_or(0);
        if pens(Pen::Thread) {
            entries.push((Sample::Line(Class::Thread(first)), "thread".to_owned()));
        }
        if !self.contour.is_empty() {
            entries.push((Sample::Line(Class::Contour), "contour".to_owned()));
        }
        if pens(Pen::Rapid) {
            entries.push((Sample::Line(Class::Rapid(first)), "rapid".to_owned()));
        }
        if !self.section.edges.is_empty() {
            entries.push((Sample::Line(Class::Edge), "finished part, cut open".to_owned()));
        }
        if let Some(blank) = &self.blank {
            entries.push((Sample::Line(Class::Blank), blank::name(blank, self.dimensions)));
        }
        if self.ends.is_some() {
            let end = if self.stop.is_some() { "last place before the error" } else { "end" };
            entries.extend([(Sample::Ring, "start".to_owned()), (Sample::Square, end.to_owned())]);
        }
        if !self.after.is_empty() {
            entries.push((Sample::Pale(Class::Key(first)), "after the error, where places are known again".to_owned()));
        }
        entries.extend(self.notes.iter().map(|note| (Sample::None, note.clone())));
        let wide = layout.broad();
        let (mut line, mut x) = (self.size_lines(layout).len().saturating_sub(1), 0.0);
        let mut placed = Vec::new();
        for (sample, name) in entries {
            let before = if matches!(sample, Sample::None) { 0.0 } else { 2.4 * font };
            let letters = font * name.chars().count() as f64;
            if x > 0.0 && x + before + 0.8 * BROAD * letters > wide {
                (line, x) = (line + 1, 0.0);
            }
            placed.push((line, x, sample, name));
            x += before + 0.8 * LETTER * letters + 1.6 * font;
        }
        placed
    }

    fn samples(&self, canvas: &mut dyn Canvas, layout: &Layout, legend: &[(usize, f64, Sample, String)]) {
        let font = layout.font;
        for (line, x, sample, _) in legend {
            let from = Point2::new(layout.low.x + x, self.legend_line(layout, *line) + 0.3 * font);
            let middle = from + Vec2::new(font, 0.0);
            match sample {
                Sample::Line(class) => {
                    canvas.path(*class, None, &[Part::Move(from), Part::Line(from + Vec2::new(2.0 * font, 0.0))]);
                }
                Sample::Pale(class) => {
                    canvas.pale(true);
                    canvas.path(*class, None, &[Part::Move(from), Part::Line(from + Vec2::new(2.0 * font, 0.0))]);
                    canvas.pale(false);
                }
                Sample::Ring => marks::ring(canvas, middle, 8.0 * layout.pixel),
                Sample::Square => marks::square(canvas, middle, 4.0 * layout.pixel),
                Sample::None => {}
            }
        }
    }

    fn scale_bar(&self, canvas: &mut dyn Canvas, layout: &Layout) {
        let (length, tick) = (layout.step() * 2.0, 0.3 * layout.font);
        let (x, y) = (self.bar_end(layout) - length, self.title_line(layout));
        let at = |x: f64, y: f64| Point2::new(x, y);
        let parts = [
            Part::Move(at(x, y + tick)),
            Part::Line(at(x, y)),
            Part::Line(at(x + length, y)),
            Part::Line(at(x + length, y + tick)),
        ];
        canvas.path(Class::Axis, None, &parts);
    }
}

/// Pictures are in millimetres, whatever the program counts in.
fn in_mm(axis: &str) -> String {
    format!("{axis} in mm")
}

fn bar_name(layout: &Layout) -> String {
    format!("{} mm", show(2.0 * layout.step()))
}

fn shortened(name: &str) -> String {
    if name.chars().count() <= MOST_LETTERS {
        return name.to_owned();
    }
    let front: String = name.chars().take(MOST_LETTERS - 3).collect();
    format!("{front}...")
}

fn class(run: &Run) -> Class {
    match run.pen {
        Pen::Rapid => Class::Rapid(run.colour),
        Pen::Cut => Class::Cut(run.colour),
        Pen::Thread => Class::Thread(run.colour),
        Pen::Dot => Class::Dot(run.colour),
        Pen::Contour => Class::Contour,
    }
}

fn same_block(a: &Stroke, b: &Stroke) -> bool {
    a.loc.file == b.loc.file && a.loc.line == b.loc.line
}

/// How many strokes the next `per` blocks make.
fn blocks_end(strokes: &[Stroke], per: usize) -> usize {
    let mut left = per;
    for (i, pair) in strokes.windows(2).enumerate() {
        if !same_block(&pair[0], &pair[1]) {
            left -= 1;
            if left == 0 {
                return i + 1;
            }
        }
    }
    strokes.len()
}
