//! Rooms: what the centre of the cutter reaches without leaving the floor, with all its rings and the one place where it goes down.

use crate::geo::tolerance;
use crate::geo::{Point2, distance, grid};

use super::loops::{Loop, Part, Peak};
use super::roomiest::roomiest;
use super::walls::Walls;

/// What hangs together between the walls.
#[derive(Debug)]
pub struct Room {
    pub outline: usize,
    /// From inside out.
    pub rings: Vec<Ring>,
    pub parts: Vec<Neighbours>,
    pub entry: Entry,
    /// Distance of its outermost rings from the walls.
    pub least: f64,
}

/// A ring of a room.
#[derive(Debug)]
pub struct Ring {
    pub path: Loop,
    /// Distance from the walls.
    pub away: f64,
    /// How many rings lie between it and the walls.
    pub depth: usize,
    pub part: usize,
}

/// What lies around a part, and in it.
#[derive(Debug, Default)]
pub struct Neighbours {
    pub holder: Option<usize>,
    pub inner: Vec<usize>,
}

/// Where the tool is inserted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry {
    pub at: Point2,
    /// Distance of the walls there.
    pub room: f64,
    /// From a start point that was asked for straight on to where there is most room.
    pub then: Option<Point2>,
    /// Where strokes to and fro end, which begin here.
    pub stroke: Option<Point2>,
    /// The part whose rings are cut first.
    pub part: usize,
}

impl Entry {
    /// Where the rings begin, if it is gone down straight.
    pub fn goes_on(&self) -> Point2 {
        self.then.unwrap_or(self.at)
    }
}

/// The point of a part that is farthest from the walls, and how far it is.
pub fn peak_of(part: &Part, walls: &Walls) -> Option<Peak> {
    let (low, high) = part.outer.extent();
    let room = |p| if part.holds(p) { walls.distance(p) } else { -part.outer.away(p) };
    roomiest(walls, low, high, room).map(|(at, room)| Peak { at, room })
}

/// Parts of a room, each after those around it.
#[derive(Debug, Default)]
pub struct Tree {
    nodes: Vec<Node>,
}

#[derive(Debug)]
struct Node {
    part: Part,
    /// The part around it, and how many there are.
    holder: Option<usize>,
    depth: usize,
    inner: Vec<usize>,
    /// Where it has most room: at first of parts with nothing deeper.
    peak: Option<Peak>,
}

impl Tree {
    pub fn new(root: Part) -> Tree {
        let root = Node { part: root, holder: None, depth: 0, inner: Vec::new(), peak: None };
        Tree { nodes: vec![root] }
    }

    /// The next ring inwards; `None` where a part lies in none of those around it.
    pub fn grow(&mut self, parts: Vec<Part>, depth: usize) -> Option<()> {
        let around = self.nodes.iter().position(|node| node.depth + 1 == depth).unwrap_or(self.nodes.len());
        let count = self.nodes.len();
        for part in parts {
            let at = part.outer.start();
            let holder = (around..count).find(|holder| self.nodes[*holder].part.holds(at))?;
            let next = self.nodes.len();
            self.nodes[holder].inner.push(next);
            self.nodes.push(Node { part, holder: Some(holder), depth, inner: Vec::new(), peak: None });
        }
        Some(())
    }

    /// Finds where the parts that have nothing deeper have most room, and the most of all; `None` where a ring is missing: with
    /// more room than `missing` says for a part there is one inside, or something would stay in the middle.
    pub fn look_for_peaks(&mut self, walls: &Walls, missing: impl Fn(&Part, f64) -> bool) -> Option<f64> {
        let mut most = f64::MIN;
        for node in self.nodes.iter_mut().filter(|node| node.inner.is_empty()) {
            let found = peak_of(&node.part, walls)?;
            if missing(&node.part, found.room) {
                return None;
            }
            node.peak = Some(found);
            most = most.max(found.room);
        }
        Some(most)
    }

    fn leaves(&self) -> impl Iterator<Item = (usize, &Node, Peak)> {
        let nodes = self.nodes.iter().enumerate().filter(|(_, node)| node.inner.is_empty());
        nodes.filter_map(|(at, node)| node.peak.map(|peak| (at, node, peak)))
    }

    /// The leaf with most room, of equal ones the one whose place has the smallest coordinates.
    fn roomiest(&self) -> Option<(usize, Peak)> {
        let first = |best: (usize, Peak), next: (usize, Peak)| {
            let equal = next.1.room >= best.1.room - tolerance::SAME && grid::before(next.1.at, best.1.at).is_lt();
            if next.1.room > best.1.room + tolerance::SAME || equal { next } else { best }
        };
        self.leaves().map(|(at, _, peak)| (at, peak)).reduce(first)
    }

    /// From a start point: where the tool goes on to, and the leaf there.
    fn reached(&self, from: Point2, main: (usize, Peak), walls: &Walls) -> Option<(Option<Point2>, usize)> {
        if let Some((at, ..)) = self.leaves().find(|(_, node, _)| node.part.holds(from)) {
            return Some((None, at));
        }
        let least = self.nodes.first()?.part.away;
        let mut places = core::iter::once(main).chain(self.leaves().map(|(at, _, peak)| (at, peak)));
        let found = places.find(|(_, peak)| walls.is_free(from, peak.at, least));
        let found = found.map(|(leaf, peak)| (Some(peak.at), leaf));
        found.or_else(|| self.nearest_ring(from, walls, least))
    }

    /// From a start point that sees no place with most room: the nearest place of the innermost rings to which a straight way leads.
    fn nearest_ring(&self, from: Point2, walls: &Walls, least: f64) -> Option<(Option<Point2>, usize)> {
        let rings =
            self.leaves().flat_map(|(at, node, _)| node.part.loops().map(move |ring| (at, ring.nearest(from).1)));
        let free = rings.filter(|(_, place)| walls.is_free(from, *place, least));
        let nearer = |best: (usize, Point2), next: (usize, Point2)| {
            if distance(next.1, from) < distance(best.1, from) - tolerance::SAME { next } else { best }
        };
        free.reduce(nearer).map(|(leaf, place)| (Some(place), leaf))
    }

    /// Leaves out parts that the ring around them clears as well; not the one in which the tool goes down. Says which are left.
    ///
    /// A place of a part is as far from the ring around it as its distance from the walls exceeds that of the ring.
    fn without_slivers(&mut self, radius: f64, deepest: usize) -> Vec<bool> {
        let mut kept = vec![true; self.nodes.len()];
        for at in (1..self.nodes.len()).rev() {
            let node = &self.nodes[at];
            let (Some(holder), Some(peak)) = (node.holder, node.peak) else { continue };
            let is_inmost = at != deepest && node.inner.iter().all(|inner| !kept[*inner]);
            let around = &mut self.nodes[holder];
            kept[at] = !is_inmost || peak.room > around.part.away + super::clears(radius);
            if around.peak.is_none_or(|most| peak.room > most.room) {
                around.peak = Some(peak);
            }
        }
        kept
    }

    /// Places of parts, each after those in it.
    fn inside_out(&self) -> Vec<usize> {
        let (mut order, mut waiting) = (Vec::with_capacity(self.nodes.len()), vec![0]);
        while let Some(at) = waiting.pop() {
            order.push(at);
            waiting.extend(&self.nodes[at].inner);
        }
        order.reverse();
        order
    }
}

impl Room {
    /// With a start point it is entered there, if from there a straight way leads to where rings begin; that start point is taken then.
    /// `None` where nothing is known of its places.
    pub fn new(mut tree: Tree, start: &mut Option<Point2>, radius: f64, walls: &Walls) -> Option<Room> {
        let main = tree.roomiest()?;
        let mut entry = Entry { at: main.1.at, room: main.1.room, then: None, stroke: None, part: main.0 };
        if let Some(at) = *start
            && let Some((then, part)) = tree.reached(at, main, walls)
        {
            entry = Entry { at, room: walls.distance(at), then, stroke: None, part };
            *start = None;
        }
        let kept = tree.without_slivers(radius, entry.part);
        let order: Vec<usize> = tree.inside_out().into_iter().filter(|at| kept[*at]).collect();
        let root = &tree.nodes.first()?.part;
        let (outline, least) = (root.outline, root.away);
        let neighbours = |node: &Node| Neighbours {
            holder: node.holder,
            inner: node.inner.iter().copied().filter(|inner| kept[*inner]).collect(),
        };
        let parts = tree.nodes.iter().map(neighbours).collect();
        let mut rings: Vec<Vec<Ring>> = Vec::with_capacity(tree.nodes.len());
        for (part, node) in tree.nodes.into_iter().enumerate() {
            let (away, depth) = (node.part.away, node.depth);
            let loops = core::iter::once(node.part.outer).chain(node.part.holes);
            rings.push(loops.map(|path| Ring { path, away, depth, part }).collect());
        }
        let rings = order.into_iter().flat_map(|at| core::mem::take(&mut rings[at])).collect();
        Some(Room { outline, rings, parts, entry, least })
    }
}
