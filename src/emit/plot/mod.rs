//! The resolved path as a picture: one SVG that needs nothing else.
//!
//! The moves are written as they come; the head with grid and scale, which needs the extents, is written last
//! into a place kept free for it. Coordinates in the picture are the true millimetres.

mod scene;
mod view;

use std::io::Write as _;

use crate::geo::{Point2, SAME_POINT, distance};
use crate::ir::motion::{Arc, Move, Path, Sink};
use crate::ir::{Function, Origin, Pos};
use crate::machine::{MachineKind, Settings};

use super::Output;
use scene::{COLOURS, Extents};
use view::View;

/// How every picture begins.
pub const MARK: &str = "<!-- (partc plot) -->\n";

/// Bytes kept free for the head.
const HEAD: usize = 12 * 1024;
/// Bytes collected before the output gets them.
const CHUNK: usize = 64 * 1024;
/// Elements of one SVG path; longer ones are slow in viewers.
const MOST_IN_PATH: u32 = 2000;
/// Chords of an arc that is seen from the side.
const CHORDS: u32 = 24;

/// How a stretch of the path is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Pen {
    Rapid,
    Cut,
    Thread,
    /// Points.
    Dot,
}

/// Draws moves.
pub struct Plot<'a> {
    out: &'a mut dyn Output,
    title: String,
    lathe: bool,
    diameter: bool,
    /// Chosen by the first move.
    view: Option<View>,
    text: Vec<u8>,
    at: Pos,
    /// Index of the tool's colour and the tools in order of appearance.
    colour: usize,
    tools: Vec<Option<u32>>,
    /// Programs instead of tools have colours.
    names: Vec<String>,
    open: Option<(Pen, usize)>,
    in_path: u32,
    /// The programmed contour beside which the tool travels, not yet drawn, and where it ends.
    contour: Vec<u8>,
    contour_at: Option<Point2>,
    contours: bool,
    extents: Extents,
    undrawn: u64,
    rapids: bool,
    threads: bool,
    error: Option<std::io::Error>,
}

impl std::fmt::Debug for Plot<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Plot").field("view", &self.view).finish_non_exhaustive()
    }
}

impl<'a> Plot<'a> {
    /// A picture of the program `title`.
    pub fn new(settings: &Settings, title: &str, out: &'a mut dyn Output) -> Plot<'a> {
        let lathe = settings.machine.kind == MachineKind::Lathe;
        // The folder a program lies in is of no interest.
        let title = title.rsplit(['/', '\\']).next().unwrap_or(title);
        let mut plot = Plot {
            out,
            title: title.to_owned(),
            lathe,
            diameter: lathe && settings.machine.diameter_axis.is_some(),
            view: None,
            text: vec![b' '; HEAD],
            at: Pos::UNKNOWN,
            colour: 0,
            tools: vec![None],
            names: Vec::new(),
            open: None,
            in_path: 0,
            contour: Vec::new(),
            contour_at: None,
            contours: false,
            extents: Extents::default(),
            undrawn: 0,
            rapids: false,
            threads: false,
            error: None,
        };
        plot.send();
        plot
    }

    /// What comes now belongs to another program, which has a colour of its own.
    pub fn program(&mut self, name: &str) {
        self.close();
        self.at.clear();
        if self.names.is_empty() {
            self.tools.clear();
        }
        let name = name.rsplit(['/', '\\']).next().unwrap_or(name);
        self.tools.push(Some(self.names.len() as u32));
        self.colour = self.names.len();
        self.names.push(name.to_owned());
    }

    /// Ends the picture.
    ///
    /// # Errors
    /// The first error of the output.
    pub fn finish(mut self) -> std::io::Result<()> {
        self.draw_contour();
        let scene = scene::Scene {
            title: &self.title,
            view: self.view.unwrap_or(View::new(Default::default(), self.lathe)),
            diameter: self.diameter,
            extents: self.extents,
            tools: &self.tools,
            names: &self.names,
            rapids: self.rapids,
            threads: self.threads,
            contours: self.contours,
            undrawn: self.undrawn,
        };
        let head = scene.head();
        self.text.extend_from_slice(scene.foot().as_bytes());
        self.send();
        let mut head = head.into_bytes();
        if head.len() > HEAD {
            return Err(std::io::Error::other("the head of the picture is too long"));
        }
        head.resize(HEAD - 1, b' ');
        head.push(b'\n');
        self.patch(&head);
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

    fn patch(&mut self, head: &[u8]) {
        if self.error.is_none()
            && let Err(error) = self.out.patch(0, head)
        {
            self.error = Some(error);
        }
    }

    fn close(&mut self) {
        if self.open.take().is_some() {
            self.text.extend_from_slice(b"\"/>\n");
        }
        if self.text.len() > CHUNK {
            self.send();
        }
    }

    /// Draws the programmed contour so far.
    fn draw_contour(&mut self) {
        self.close();
        if !self.contour.is_empty() {
            self.text.extend_from_slice(b"<path class=\"p\" d=\"");
            self.text.append(&mut self.contour);
            self.text.extend_from_slice(b"\"/>\n");
            self.contour_at = None;
        }
    }

    /// Starts or continues a stretch at `from`.
    fn pen(&mut self, pen: Pen, from: Point2) {
        if self.open != Some((pen, self.colour)) || self.in_path >= MOST_IN_PATH {
            self.close();
            let class = match pen {
                Pen::Rapid => "r",
                Pen::Cut => "c",
                Pen::Thread => "h",
                Pen::Dot => "d",
            };
            let _ = write!(self.text, "<path class=\"{class} t{}\" d=\"M", self.colour % COLOURS.len());
            self.point(from);
            self.open = Some((pen, self.colour));
            self.in_path = 0;
        }
        self.in_path += 1;
        self.extents.take(from, pen == Pen::Rapid);
    }

    fn point(&mut self, p: Point2) {
        scene::number(&mut self.text, p.x);
        self.text.push(b' ');
        scene::number(&mut self.text, p.y);
    }

    fn dot(&mut self, at: Point2) {
        self.pen(Pen::Dot, at);
        self.text.push(b'M');
        self.point(at);
        self.text.extend_from_slice(b"h0");
    }

    fn line(&mut self, to: Point2, pen: Pen) {
        self.text.push(b'L');
        self.point(to);
        self.extents.take(to, pen == Pen::Rapid);
    }

    fn arc(&mut self, view: View, arc: &Arc, from: Point2, to: Point2, mv: &Move) {
        if !view.shows(arc.plane) {
            return self.arc_from_the_side(view, arc, to, mv);
        }
        let radius = distance(arc.from, arc.center);
        self.extents.take_arc(arc);
        // What exceeds a turn lies on itself; an arc of SVG needs two different ends.
        let turn = core::f64::consts::TAU;
        let sweep = arc.sweep.clamp(-turn, turn);
        let parts = if sweep.abs() > 3.0 { 2 } else { 1 };
        let mut start = from;
        for part in 1..=parts {
            let end = if part == parts && arc.sweep.abs() <= turn {
                to
            } else {
                let angle = sweep * f64::from(part) / f64::from(parts);
                arc.center + crate::geo::turned(arc.from - arc.center, angle)
            };
            if distance(start, end) > SAME_POINT {
                self.text.push(b'A');
                scene::number(&mut self.text, radius);
                self.text.push(b' ');
                scene::number(&mut self.text, radius);
                self.text.extend_from_slice(if sweep > 0.0 { b" 0 0 1 " } else { b" 0 0 0 " });
                self.point(end);
            }
            start = end;
        }
        if distance(start, to) > SAME_POINT {
            self.line(to, Pen::Cut);
        }
    }

    /// An arc in another plane is a wave or a line here.
    fn arc_from_the_side(&mut self, view: View, arc: &Arc, to: Point2, mv: &Move) {
        for i in 1..CHORDS {
            let t = f64::from(i) / f64::from(CHORDS);
            let mut pos = self.at;
            for (axis, end) in mv.end.iter() {
                let start = self.at.get(axis).unwrap_or(end);
                pos.set(axis, start + (end - start) * t);
            }
            pos.set_in_plane(arc.plane, arc.center + crate::geo::turned(arc.from - arc.center, arc.sweep * t));
            if let Some(p) = view.point(&pos) {
                self.line(p, Pen::Cut);
            }
        }
        self.line(to, Pen::Cut);
    }
}

impl Sink for Plot<'_> {
    fn movement(&mut self, mv: &Move, _: &Origin) {
        let view = *self.view.get_or_insert(View::new(mv.plane, self.lathe));
        let from = view.point(&self.at);
        let mut end = self.at;
        end.update(&mv.end);
        let to = view.point(&end);
        match (from, to) {
            (Some(from), Some(to)) if !mv.machine => {
                let pen = match mv.path {
                    Path::Rapid => Pen::Rapid,
                    Path::Line(_) | Path::Arc(..) | Path::Carried { .. } => Pen::Cut,
                    Path::Thread { .. } => Pen::Thread,
                };
                self.rapids |= pen == Pen::Rapid;
                self.threads |= pen == Pen::Thread;
                match &mv.path {
                    Path::Arc(arc, _) => {
                        self.pen(pen, from);
                        self.arc(view, arc, from, to, mv);
                    }
                    // Seen along its own direction a cut is a point: where a drill goes in.
                    Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. }
                        if distance(from, to) <= SAME_POINT =>
                    {
                        if pen != Pen::Rapid {
                            self.dot(to);
                        }
                    }
                    Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. } => {
                        self.pen(pen, from);
                        self.line(to, pen);
                    }
                }
            }
            _ => {
                self.close();
                self.undrawn += u64::from(mv.machine);
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
        let view = *self.view.get_or_insert(View::new(mv.plane, self.lathe));
        let (Some(from), Some(to)) = (view.point(start), view.point(&mv.end)) else { return };
        // Only the path counts as cut.
        let cut = self.extents.cut;
        std::mem::swap(&mut self.text, &mut self.contour);
        if self.contour_at.is_none_or(|at| distance(at, from) > SAME_POINT) {
            self.text.push(b'M');
            self.point(from);
            self.extents.take(from, true);
        }
        match &mv.path {
            Path::Arc(arc, _) if view.shows(arc.plane) => self.arc(view, arc, from, to, mv),
            Path::Arc(..) | Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. } => {
                self.line(to, Pen::Rapid)
            }
        }
        std::mem::swap(&mut self.text, &mut self.contour);
        self.extents.cut = cut;
        self.contour_at = Some(to);
        self.contours = true;
        if self.contour.len() > CHUNK {
            self.draw_contour();
        }
    }

    fn function(&mut self, function: &Function, _: &Origin) {
        if let (Function::ToolChange { number }, []) = (function, self.names.as_slice()) {
            let tool = Some(*number);
            self.colour = match self.tools.iter().position(|known| *known == tool) {
                Some(index) => index,
                None => {
                    // The place of the unknown first tool is free if nothing was drawn with it.
                    if self.tools == [None] && self.extents.is_empty() {
                        self.tools.clear();
                    }
                    self.tools.push(tool);
                    self.tools.len() - 1
                }
            };
        } else if let Function::WorkOffset(_) = function {
            self.close();
            self.at.clear();
        }
    }

    fn lost(&mut self, _: &Origin) {
        self.close();
        self.at.clear();
    }
}
