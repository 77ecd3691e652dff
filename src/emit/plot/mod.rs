//! The resolved path as a picture, SVG or PNG.
//!
//! In: motion items. They become strokes of the view ([`strokes`]), made fewer where there are very many; when all are known,
//! the picture is laid out and drawn to a canvas. Coordinates of an SVG are true millimetres.

mod blank;
mod canvas;
mod dimensions;
mod glyphs;
mod layout;
mod marks;
#[cfg(feature = "png")]
mod png;
mod rect;
mod scene;
mod section;
mod strokes;
mod svg;
#[cfg(test)]
mod tests;
mod view;

use std::io;

use crate::geo::{Element, Plane, Point2, SAME_POINT, distance, turned};
use crate::ir::cycle::turning::Towards;
use crate::ir::motion::{Arc, Move, Path, Sink};
use crate::ir::{Blank, Function, Origin, Pos, Remark};
use crate::machine::{Axis, MachineKind, Settings};
use crate::text::Sources;

use super::Output;
use canvas::Widths;
use layout::Layout;
use rect::{Bend, Rect};
use scene::Scene;
use section::Parts;
use strokes::{Pen, Strokes};
use view::View;

pub use layout::PIXELS;
pub use strokes::ALL_DRAWN;
pub use svg::MARK;
pub use view::Side;

#[cfg(feature = "png")]
pub use png::MARK as PNG_MARK;

/// Chords of a turn that is seen from the side, and turns that are drawn: more lie on each other.
const CHORDS: f64 = 64.0;
const TURNS: f64 = 1024.0;

/// How a path is drawn.
#[derive(Debug, Clone, Copy, Default)]
pub struct Options {
    /// `None`: the working plane; on a lathe Z to the right and X up.
    pub view: Option<Side>,
    pub dimensions: bool,
    pub form: Form,
}

/// What the picture becomes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Form {
    #[default]
    Svg,
    #[cfg(feature = "png")]
    Png,
}

/// Where very many moves were made fewer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thinned {
    pub moves: u64,
    pub strokes: usize,
    /// How far the path is at most away from what is drawn, in mm.
    pub error: f64,
}

/// The first error of a refused program: what is drawn is not the whole path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stop {
    pub code: &'static str,
    /// The file that the error lies in, and whether that is another than the main program.
    pub file: String,
    pub called: bool,
    pub line: u32,
}

impl Stop {
    fn text(&self) -> String {
        let Stop { code, file, called, line } = self;
        let file = if *called { format!(" of {file}") } else { String::new() };
        format!("incomplete: stops at line {line}{file} ({code})")
    }
}

/// Draws moves.
#[derive(Debug)]
pub struct Plot {
    options: Options,
    title: String,
    lathe: bool,
    /// The axis that is labelled in diameters.
    diameter: Option<Axis>,
    /// Chosen by the first move.
    view: Option<View>,
    strokes: Strokes,
    /// The programmed contour beside which the tool travels.
    contour: Strokes,
    parts: Parts,
    at: Pos,
    /// Place of the tool, and the tools in order of appearance behind no tool.
    colour: usize,
    tools: Vec<Option<u32>>,
    /// Programs instead of tools have colours, from place 1 on.
    names: Vec<String>,
    cut: Rect,
    /// The least and greatest coordinates of X, Y and Z that are cut.
    extents: [Option<(f64, f64)>; 3],
    ends: Option<(Point2, Point2)>,
    in_machine: u64,
    unknown: u64,
    blank: Option<Blank>,
    /// A block was refused. What is known behind it is drawn, and counts for nothing.
    refused: bool,
    after: Strokes,
    stop: Option<Stop>,
}

impl Plot {
    /// A picture of the program `title`.
    pub fn new(settings: &Settings, title: &str, options: Options) -> Plot {
        let lathe = settings.machine.kind == MachineKind::Lathe;
        Plot {
            options,
            // The folder a program lies in is of no interest.
            title: title.rsplit(['/', '\\']).next().unwrap_or(title).to_owned(),
            lathe,
            diameter: settings.machine.shown_diameter(),
            view: None,
            strokes: Strokes::default(),
            contour: Strokes::default(),
            parts: Parts::default(),
            at: Pos::UNKNOWN,
            colour: 0,
            tools: vec![None],
            names: Vec::new(),
            cut: Rect::default(),
            extents: [None; 3],
            ends: None,
            in_machine: 0,
            unknown: 0,
            blank: None,
            refused: false,
            after: Strokes::default(),
            stop: None,
        }
    }

    /// The program was refused: the picture says that it is not whole.
    pub fn incomplete(&mut self, stop: Stop) {
        self.stop = Some(stop);
    }

    /// What comes now belongs to another program, which has a colour of its own.
    pub fn program(&mut self, name: &str) {
        self.strokes.lift();
        self.at.clear();
        let name = name.rsplit(['/', '\\']).next().unwrap_or(name);
        self.tools.push(Some(self.names.len() as u32));
        self.names.push(name.to_owned());
        self.colour = self.names.len();
    }

    /// Writes the picture; what is pointed at in an SVG shows its line of `sources`.
    ///
    /// # Errors
    /// The first error of the output.
    pub fn finish(mut self, sources: Option<&Sources>, out: &mut dyn Output) -> io::Result<Option<Thinned>> {
        let thinned = self.thin();
        self.contour.finish();
        let view = self.view.unwrap_or(View::new(self.options.view, Plane::Xy, self.lathe));
        let section =
            if view.is_turning() { std::mem::take(&mut self.parts).section() } else { section::Section::default() };
        let scene = Scene {
            title: &self.title,
            view,
            diameter: self.diameter,
            dimensions: self.options.dimensions,
            notes: self.notes(thinned),
            after: &self.after,
            blank: self.blank,
            stop: self.stop.as_ref(),
            strokes: &self.strokes,
            contour: &self.contour,
            section,
            cut: self.cut,
            extents: self.extents,
            tools: &self.tools,
            names: &self.names,
            ends: self.ends.filter(|_| self.names.is_empty()),
            sources,
        };
        let (layout, widths) = scene.layout();
        self.write(&scene, &layout, widths, out)?;
        Ok(thinned)
    }

    /// Makes strokes fewer where there are very many.
    fn thin(&mut self) -> Option<Thinned> {
        let moves = self.strokes.taken + self.after.taken;
        let errors = [self.strokes.finish(), self.after.finish()];
        let error = errors.into_iter().flatten().reduce(f64::max)?;
        Some(Thinned { moves, strokes: self.strokes.len() + self.after.len(), error })
    }

    fn write(&self, scene: &Scene<'_>, layout: &Layout, widths: Widths, out: &mut dyn Output) -> io::Result<()> {
        match self.options.form {
            Form::Svg => {
                let mut used = svg::Used::default();
                scene.draw(&mut used, layout);
                let named = (self.title.as_str(), self.stop.as_ref());
                let mut svg = svg::Svg::new(out, layout, widths, &used, named);
                scene.draw(&mut svg, layout);
                svg.finish()
            }
            #[cfg(feature = "png")]
            Form::Png => {
                let mut png = png::Png::new(layout, widths)?;
                scene.draw(&mut png, layout);
                out.append(&png.finish()?)
            }
        }
    }

    fn notes(&self, thinned: Option<Thinned>) -> Vec<String> {
        let moves = |count: u64| if count == 1 { "1 move".to_owned() } else { format!("{count} moves") };
        let mut notes = Vec::new();
        if let Some(Thinned { moves: taken, strokes, error }) = thinned {
            let moves = moves(taken);
            notes.push(format!("{moves} drawn with {strokes} strokes, at most {} mm away", rounded_up(error)));
        }
        if self.in_machine > 0 {
            notes.push(format!("{} in machine coordinates not drawn", moves(self.in_machine)));
        }
        if self.unknown > 0 {
            notes.push(format!("{} from or to unknown coordinates not drawn", moves(self.unknown)));
        }
        notes
    }

    fn arc(&mut self, view: View, arc: &Arc, (from, to): (Point2, Point2), mv: &Move, origin: &Origin) {
        let Some(turn) = view.turn(arc.plane) else { return self.arc_from_the_side(view, arc, mv, origin) };
        let center = view.in_plane(arc.plane, arc.center);
        let whole = core::f64::consts::TAU;
        let pen = (Pen::Cut, self.colour);
        // What exceeds a turn lies on itself.
        if arc.sweep.abs() > whole {
            let around = Bend { center, sweep: whole * turn * arc.sweep.signum() };
            self.pen().arc(pen, from, from, around, origin.loc);
        }
        let sweep = turn * if arc.sweep.abs() > whole { arc.sweep % whole } else { arc.sweep };
        let bend = Bend { center, sweep };
        if sweep.abs() * distance(from, center) > SAME_POINT || arc.sweep.abs() <= whole {
            self.pen().arc(pen, from, to, bend, origin.loc);
        }
        if self.refused {
            return;
        }
        self.cut.take_arc(from, &bend);
        if arc.sweep.abs() > whole {
            self.cut.take_arc(from, &Bend { center, sweep: whole });
        }
    }

    /// An arc in another plane is a wave, an ellipse or a line here.
    fn arc_from_the_side(&mut self, view: View, arc: &Arc, mv: &Move, origin: &Origin) {
        let turns = arc.sweep.abs() / core::f64::consts::TAU;
        let count = libm::ceil(turns.min(TURNS) * CHORDS).max(4.0) as u32;
        // Of very many turns some are drawn; the last one ends where it shall.
        let left_out = libm::floor((turns - TURNS).max(0.0)) * core::f64::consts::TAU * arc.sweep.signum();
        let Some(mut from) = view.point(&self.at) else { return };
        for i in 1..=count {
            let t = f64::from(i) / f64::from(count);
            let mut pos = self.at;
            for (axis, end) in mv.end.iter() {
                let start = self.at.get(axis).unwrap_or(end);
                pos.set(axis, start + (end - start) * t);
            }
            if i < count {
                let angle = (arc.sweep - left_out) * t;
                pos.set_in_plane(arc.plane, arc.center + turned(arc.from - arc.center, angle));
            }
            if let Some(to) = view.point(&pos) {
                if !self.refused {
                    self.cut.take(to);
                }
                let colour = self.colour;
                self.pen().line(Pen::Cut, colour, from, to, origin.loc);
                from = to;
            }
        }
    }

    /// What the next stroke belongs to.
    fn pen(&mut self) -> &mut Strokes {
        if self.refused { &mut self.after } else { &mut self.strokes }
    }

    /// The next stroke begins anew.
    fn lift(&mut self) {
        self.pen().lift();
    }

    /// What a cut adds to the sizes that are told.
    fn measure(&mut self, mv: &Move, end: &Pos) {
        for pos in [&self.at, end] {
            for (axis, extent) in Axis::ALL.iter().zip(&mut self.extents) {
                pos.get(*axis).into_iter().for_each(|value| grow(extent, value));
            }
        }
        if let Path::Arc(arc, _) = &mv.path {
            let mut rect = Rect::default();
            let whole = core::f64::consts::TAU;
            rect.take_arc(arc.from, &Bend { center: arc.center, sweep: arc.sweep.clamp(-whole, whole) });
            let (first, second, _) = arc.plane.axes();
            if let Some((low, high)) = rect.0 {
                [low, high].into_iter().for_each(|p| {
                    grow(&mut self.extents[first], p.x);
                    grow(&mut self.extents[second], p.y);
                });
            }
        }
    }
}

fn grow(extent: &mut Option<(f64, f64)>, value: f64) {
    let (low, high) = extent.get_or_insert((value, value));
    (*low, *high) = (low.min(value), high.max(value));
}

/// Two digits that are not less than the number.
pub fn rounded_up(value: f64) -> String {
    if value <= 0.0 {
        return "0".to_owned();
    }
    let value = value.max(1e-6);
    let unit = libm::pow(10.0, libm::floor(libm::log10(value)) - 1.0);
    let digits = (1.0 - libm::floor(libm::log10(value))).clamp(0.0, 7.0) as usize;
    let text = format!("{:.digits$}", libm::ceil(value / unit - 1e-9) * unit);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

fn pen(path: &Path) -> Pen {
    match path {
        Path::Rapid => Pen::Rapid,
        Path::Line(_) | Path::Arc(..) | Path::Carried { .. } => Pen::Cut,
        Path::Thread { .. } => Pen::Thread,
    }
}

impl Sink for Plot {
    fn movement(&mut self, mv: &Move, origin: &Origin) {
        let view = *self.view.get_or_insert(View::new(self.options.view, mv.plane, self.lathe));
        let mut end = self.at;
        end.update(&mv.end);
        match (view.point(&self.at), view.point(&end)) {
            (Some(from), Some(to)) if !mv.machine => {
                let (pen, colour) = (pen(&mv.path), self.colour);
                if pen != Pen::Rapid && !self.refused {
                    self.cut.take(from);
                    self.cut.take(to);
                    self.measure(mv, &end);
                }
                match &mv.path {
                    Path::Arc(arc, _) => self.arc(view, arc, (from, to), mv, origin),
                    // Seen along its own direction a cut is a point: where a drill goes in.
                    Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. }
                        if distance(from, to) <= SAME_POINT =>
                    {
                        if pen != Pen::Rapid {
                            self.pen().line(Pen::Dot, colour, from, from, origin.loc);
                        }
                    }
                    Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. } => {
                        self.pen().line(pen, colour, from, to, origin.loc);
                    }
                }
                if !self.refused {
                    self.ends = Some((self.ends.map_or(from, |(start, _)| start), to));
                }
            }
            _ if self.refused => self.lift(),
            (from, to) => {
                self.lift();
                self.in_machine += u64::from(mv.machine);
                // How the tool comes to the part at first is of no interest.
                let matters = pen(&mv.path) != Pen::Rapid && (from.is_none() || to.is_none());
                self.unknown += u64::from(!mv.machine && matters);
            }
        }
        self.at = end;
        if mv.machine {
            for axis in mv.axes.iter() {
                self.at.forget(axis);
            }
        }
    }

    fn programmed(&mut self, mv: &Move, start: &Pos) {
        let view = *self.view.get_or_insert(View::new(self.options.view, mv.plane, self.lathe));
        let (Some(from), Some(to), false) = (view.point(start), view.point(&mv.end), self.refused) else { return };
        let loc = crate::text::Loc::default();
        let whole = core::f64::consts::TAU;
        let bend = match &mv.path {
            Path::Arc(arc, _) => view.turn(arc.plane).map(|turn| Bend {
                center: view.in_plane(arc.plane, arc.center),
                sweep: turn * arc.sweep.clamp(-whole, whole),
            }),
            Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. } => None,
        };
        match bend {
            Some(bend) => self.contour.arc((Pen::Contour, 0), from, to, bend, loc),
            None => self.contour.line(Pen::Contour, 0, from, to, loc),
        }
        if self.lathe && mv.path != Path::Rapid {
            let element = match bend {
                Some(bend) => Element::Arc { from, to, center: bend.center, sweep: bend.sweep },
                None => Element::Line { from, to },
            };
            self.parts.beside(element, mv.side);
        }
    }

    fn finished(&mut self, contour: &[Element], into: Towards) {
        if self.lathe && !self.refused {
            self.parts.finished(contour.to_vec(), into);
        }
    }

    fn function(&mut self, function: &Function, _: &Origin) {
        if let (Function::ToolChange { number }, []) = (function, self.names.as_slice()) {
            let tool = Some(*number);
            self.colour = match self.tools.iter().position(|known| *known == tool) {
                Some(index) => index,
                None => {
                    self.tools.push(tool);
                    self.tools.len() - 1
                }
            };
        } else if let Function::WorkOffset(_) | Function::Tilt(_) = function {
            self.lift();
            self.at.clear();
        } else if let Function::Remark(remark) = function {
            match remark {
                Remark::Refused => self.refused = true,
                Remark::Blank(blank) => self.blank = Some(*blank),
            }
        }
    }

    fn lost(&mut self, _: &Origin) {
        self.lift();
        self.at.clear();
    }
}
