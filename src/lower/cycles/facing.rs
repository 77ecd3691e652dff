//! Face milling: path beside path, level by level; between the paths outside of the face, or over what is cut.

use crate::diag::{Fault, codes};
use crate::ir::Feed;
use crate::ir::cycle::facing::{Kind, Links};
use crate::ir::cycle::{Facing, Family};

use super::cutter::Cutter;
use super::{CycleItem, Expand, Start};

impl Expand for Facing {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        self.check().map_err(|fault| codes::G3331::face_makes_no_path(&fault))?;
        let paths = self.paths();
        let Some([first, _]) = paths.first() else { return Ok(()) };
        let feed = self.mill.feeds.plane;
        let mut cutter = Cutter::new(&self.mill, self.corner, start, out);
        cutter.approach(*first);
        if let Links::At(link) | Links::Inside(link) = self.links {
            self.levels_at(link, &mut cutter);
            cutter.retract();
            return Ok(());
        }
        let mut above = self.mill.heights.safe();
        for level in self.levels() {
            for (at, [from, to]) in paths.iter().enumerate() {
                match self.kind {
                    // Outside of the face, or along a wall, to the path beside.
                    Kind::Rough if self.goes_back() && at > 0 => cutter.line(*from, feed),
                    Kind::Rough => {
                        cutter.lift(above);
                        cutter.rapid(*from);
                    }
                    // Back over the path that is cut, then beside the face.
                    Kind::Finish { lift } if at > 0 => {
                        cutter.lift(level + lift * self.mill.heights.outward());
                        if !self.goes_back() {
                            cutter.rapid(paths[at - 1][0]);
                        }
                        cutter.rapid(*from);
                    }
                    Kind::Finish { .. } => {}
                }
                cutter.lift(level);
                cutter.line(*to, feed);
            }
            if let Some(wall) = self.along_wall() {
                let [from, to] = wall.path;
                if !cutter.stands_at(from) {
                    let heights = &self.mill.heights;
                    cutter.lift(if wall.from_outside { heights.safe() } else { heights.above_cleared(level) });
                    cutter.rapid(from);
                    // Outside of the face, or on the last path.
                    if wall.from_outside { cutter.lift(level) } else { cutter.plunge(level) }
                }
                cutter.line(to, feed);
            }
            // What is cut down to this level is free above it.
            above = self.mill.heights.above(level);
        }
        cutter.retract();
        Ok(())
    }
}

impl Facing {
    /// Levels whose paths are reached at a feed of their own.
    fn levels_at(&self, link: Option<Feed>, cutter: &mut Cutter<'_>) {
        let heights = &self.mill.heights;
        let levels = self.levels();
        for (number, level) in levels.iter().copied().enumerate() {
            let last = self.last.filter(|_| number + 1 == levels.len());
            let feed = last.unwrap_or(self.mill.feeds.plane);
            let sideways = if matches!(self.links, Links::Inside(_)) { Some(feed) } else { link };
            for (at, [from, to]) in self.paths_of(number).iter().enumerate() {
                match (self.goes_back(), at, number) {
                    (true, 0, _) => cutter.go(*from, link),
                    (true, ..) => cutter.go(*from, sideways),
                    (false, 0, 0) => {}
                    (false, ..) => {
                        // The way back leads over the next path, which stands as the level before left it.
                        let ground = if number > 0 { levels[number - 1] } else { heights.reference };
                        cutter.lift(heights.above_cleared(ground));
                        cutter.go(*from, link);
                    }
                }
                cutter.go_down(level, link.map(|_| self.mill.feeds.depth));
                cutter.line(*to, feed);
            }
        }
    }
}
