//! Hole patterns: positions in the plane, in the order of drilling.

use super::{Deg, Point2, Vec2};

/// Most holes of a pattern; more is a mistake in the program.
pub const MOST_HOLES: u32 = 100_000;

/// Holes on a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Reference point.
    pub reference: Point2,
    /// Direction of the row from the first axis.
    pub direction: Deg,
    /// From the reference point to the first hole.
    pub first: f64,
    /// From hole to hole.
    pub spacing: f64,
    pub count: u32,
}

/// Holes on a circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    pub center: Point2,
    pub radius: f64,
    /// Of the first hole, from the first axis.
    pub start: Deg,
    /// From hole to hole; 0 spreads them over the whole circle.
    pub step: Deg,
    pub count: u32,
}

/// Holes in rows and columns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// First hole, about which the grid is turned.
    pub reference: Point2,
    pub turn: Deg,
    /// Between columns, along the turned first axis.
    pub column_spacing: f64,
    /// Between rows, along the turned second axis.
    pub row_spacing: f64,
    pub columns: u32,
    pub rows: u32,
    /// Shear of the columns against the second axis, and of the rows against the first.
    pub shear: Shear,
    /// Only the outer holes.
    pub frame: bool,
}

/// By how much the sides of a grid lean out of the turned axes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Shear {
    pub rows: Deg,
    pub columns: Deg,
}

/// Why there is no pattern.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// No hole (alarm 61103, for grids 62105).
    None,
    /// More than [`MOST_HOLES`].
    TooMany,
    /// The holes go round the circle more than once (alarm 61106).
    Overlap,
    /// The radius is negative, or a value is not finite.
    Value,
}

impl Row {
    /// The positions. If the last hole lies nearer to the zero point of the plane than the first, the row is
    /// drilled backwards (standard cycle HOLES1, V06.02.09).
    ///
    /// # Errors
    /// `None`, `TooMany`, `Value`.
    pub fn positions(&self) -> Result<impl Iterator<Item = Point2> + use<>, Fault> {
        count(self.count)?;
        let Row { reference, direction, first, spacing, count } = *self;
        let along = direction.unit();
        let at = move |i: u32| reference + along * (first + f64::from(i) * spacing);
        let (near, far) = (at(0).coords.norm_squared(), at(count - 1).coords.norm_squared());
        if !(near.is_finite() && far.is_finite()) {
            return Err(Fault::Value);
        }
        let backwards = far < near;
        Ok((0..count).map(move |i| at(if backwards { count - 1 - i } else { i })))
    }
}

impl Circle {
    /// The positions, from the start angle on.
    ///
    /// # Errors
    /// `None`, `TooMany`, `Overlap`, `Value`.
    pub fn positions(&self) -> Result<impl Iterator<Item = Point2> + use<>, Fault> {
        count(self.count)?;
        let Circle { center, radius, start, step, count } = *self;
        let finite = [center.x, center.y, radius, start.0, step.0].iter().all(|v| v.is_finite());
        if !finite || radius < 0.0 {
            return Err(Fault::Value);
        }
        if step.0.abs() * f64::from(count - 1) >= 360.0 {
            return Err(Fault::Overlap);
        }
        // One division a hole keeps a third of a turn exact.
        let angle = move |i: u32| match step {
            Deg(0.0) => start.0 + f64::from(i) * 360.0 / f64::from(count),
            Deg(step) => start.0 + f64::from(i) * step,
        };
        Ok((0..count).map(move |i| center + Deg(angle(i)).unit() * radius))
    }
}

impl Grid {
    /// The positions: back and forth along the axis with the smaller spacing; a frame goes round from the
    /// first hole, along the columns first.
    ///
    /// # Errors
    /// `None`, `TooMany`, `Value`.
    pub fn positions(&self) -> Result<impl Iterator<Item = Point2> + use<>, Fault> {
        count(self.columns)?;
        count(self.rows)?;
        if u64::from(self.columns) * u64::from(self.rows) > u64::from(MOST_HOLES) {
            return Err(Fault::TooMany);
        }
        let grid = *self;
        let values = [grid.turn.0, grid.column_spacing, grid.row_spacing, grid.shear.rows.0, grid.shear.columns.0];
        let upright = |lean: Deg| lean.0.abs() < 90.0;
        if !values.iter().all(|v| v.is_finite()) || !upright(grid.shear.rows) || !upright(grid.shear.columns) {
            return Err(Fault::Value);
        }
        let order: Box<dyn Iterator<Item = (u32, u32)>> = if grid.frame { grid.around() } else { grid.meander() };
        Ok(order.map(move |(column, row)| grid.hole(column, row)))
    }

    fn hole(&self, column: u32, row: u32) -> Point2 {
        let along = Deg(self.turn.0 + self.shear.rows.0).unit() * self.column_spacing;
        let up = Deg(self.turn.0 + 90.0 - self.shear.columns.0).unit() * self.row_spacing;
        self.reference + Vec2::from(along) * f64::from(column) + up * f64::from(row)
    }

    fn meander(&self) -> Box<dyn Iterator<Item = (u32, u32)>> {
        let along_columns = self.column_spacing.abs() <= self.row_spacing.abs();
        let (inner, outer) = if along_columns { (self.columns, self.rows) } else { (self.rows, self.columns) };
        Box::new((0..outer).flat_map(move |o| {
            (0..inner).map(move |i| {
                let i = if o % 2 == 0 { i } else { inner - 1 - i };
                if along_columns { (i, o) } else { (o, i) }
            })
        }))
    }

    fn around(&self) -> Box<dyn Iterator<Item = (u32, u32)>> {
        let (c, r) = (self.columns, self.rows);
        if c == 1 || r == 1 {
            return self.meander();
        }
        let bottom = (0..c).map(|i| (i, 0));
        let right = (1..r).map(move |i| (c - 1, i));
        let top = (0..c - 1).rev().map(move |i| (i, r - 1));
        let left = (1..r - 1).rev().map(|i| (0, i));
        Box::new(bottom.chain(right).chain(top).chain(left))
    }
}

fn count(n: u32) -> Result<(), Fault> {
    match n {
        0 => Err(Fault::None),
        n if n > MOST_HOLES => Err(Fault::TooMany),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(found: impl Iterator<Item = Point2>, wanted: &[(f64, f64)]) {
        let found: Vec<_> = found.collect();
        assert_eq!(found.len(), wanted.len(), "{found:?}");
        for (p, (x, y)) in found.iter().zip(wanted) {
            assert!((p.x - x).abs() < 5.1e-4 && (p.y - y).abs() < 5.1e-4, "{p:?} {x} {y}");
        }
    }

    #[test]
    fn circle_as_computed_by_hand() {
        let circle =
            Circle { center: Point2::new(20.0, 10.0), radius: 25.0, start: Deg(30.0), step: Deg(0.0), count: 5 };
        let wanted = [(41.6506, 22.5), (14.8022, 34.4537), (-4.863, 12.6132), (9.8316, -12.8386), (38.5786, -6.7283)];
        near(circle.positions().unwrap(), &wanted);
        let stepped = Circle { step: Deg(90.0), ..circle };
        assert_eq!(stepped.positions().err(), Some(Fault::Overlap));
        assert_eq!(Circle { step: Deg(-72.0), ..circle }.positions().map(Iterator::count), Ok(5));
        assert_eq!(Circle { count: 0, ..circle }.positions().err(), Some(Fault::None));
        assert_eq!(Circle { radius: -1.0, ..circle }.positions().err(), Some(Fault::Value));
    }

    #[test]
    fn row_of_the_reference_is_drilled_backwards() {
        let row =
            Row { reference: Point2::new(100.0, 40.0), direction: Deg(200.0), first: 10.0, spacing: 15.0, count: 4 };
        let wanted = [(48.317, 21.189), (62.412, 26.319), (76.508, 31.449), (90.603, 36.580)];
        near(row.positions().unwrap(), &wanted);
        let forwards = Row { direction: Deg(20.0), ..row };
        assert!(forwards.positions().unwrap().next().unwrap().x < 110.0);
    }

    #[test]
    fn grids_and_frames() {
        let grid = Grid {
            reference: Point2::new(10.0, 20.0),
            turn: Deg(0.0),
            column_spacing: 5.0,
            row_spacing: 8.0,
            columns: 3,
            rows: 3,
            shear: Shear::default(),
            frame: false,
        };
        let meander = [
            (10., 20.),
            (15., 20.),
            (20., 20.),
            (20., 28.),
            (15., 28.),
            (10., 28.),
            (10., 36.),
            (15., 36.),
            (20., 36.),
        ];
        near(grid.positions().unwrap(), &meander);
        let upright = Grid { column_spacing: 9.0, ..grid };
        near(upright.positions().unwrap().take(4), &[(10., 20.), (10., 28.), (10., 36.), (19., 36.)]);
        let frame = [(10., 20.), (15., 20.), (20., 20.), (20., 28.), (20., 36.), (15., 36.), (10., 36.), (10., 28.)];
        near(Grid { frame: true, ..grid }.positions().unwrap(), &frame);
        near(Grid { frame: true, rows: 1, ..grid }.positions().unwrap(), &frame[..3]);
        near(Grid { turn: Deg(90.0), ..grid }.positions().unwrap().take(2), &[(10., 20.), (10., 25.)]);
        // Columns that lean by 30 degrees lean towards the next one: (8 sin 30, 8 cos 30); rows rise with theirs.
        let leaning = Shear { columns: Deg(30.0), ..Shear::default() };
        let lean = Grid { columns: 1, rows: 2, shear: leaning, ..grid };
        near(lean.positions().unwrap(), &[(10., 20.), (14., 26.9282)]);
        let rising = Shear { rows: Deg(30.0), ..Shear::default() };
        near(Grid { columns: 2, rows: 1, shear: rising, ..grid }.positions().unwrap(), &[(10., 20.), (14.3301, 22.5)]);
        assert_eq!(Grid { rows: 0, ..grid }.positions().err(), Some(Fault::None));
        assert_eq!(Grid { rows: 1000, columns: 1000, ..grid }.positions().err(), Some(Fault::TooMany));
    }

    #[test]
    fn a_row_with_one_end_out_of_reach_is_none() {
        let row = Row { reference: Point2::origin(), direction: Deg(0.0), first: 1e200, spacing: -1e200, count: 2 };
        assert_eq!(row.positions().err(), Some(Fault::Value));
        let back = Row { first: 0.0, spacing: 1e200, ..row };
        assert_eq!(back.positions().err(), Some(Fault::Value));
    }
}
