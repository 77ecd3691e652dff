//! A chamfer or rounding whose second element is still to come.

use crate::text::Loc;

/// The corner that waits, and how many blocks without a move passed since: controls look ahead over a few only.
#[derive(Debug, Clone, Copy, Default)]
pub struct OpenCorner {
    waits: Option<(Loc, u32)>,
}

impl OpenCorner {
    /// A corner was programmed at `site`.
    pub fn open(&mut self, site: Loc) {
        self.waits = Some((site, 0));
    }

    #[inline]
    pub fn close(&mut self) {
        self.waits = None;
    }

    #[inline]
    pub fn is_open(&self) -> bool {
        self.waits.is_some()
    }

    /// Where the corner that waits was programmed.
    pub fn site(&self) -> Option<Loc> {
        self.waits.map(|(site, _)| site)
    }

    /// A block without a move passes. The corner that has waited for more than `most` of them is given up.
    #[inline]
    pub fn wait(&mut self, most: u32) -> Option<Loc> {
        let (site, blocks) = self.waits.as_mut()?;
        *blocks += 1;
        let (site, gives_up) = (*site, *blocks > most);
        if gives_up {
            self.waits = None;
        }
        gives_up.then_some(site)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_corner_waits_for_as_many_blocks_as_the_control_looks_ahead() {
        let mut corner = OpenCorner::default();
        assert_eq!(corner.wait(1), None);
        corner.open(Loc { line: 7, ..Loc::default() });
        assert_eq!(corner.wait(1), None);
        assert_eq!(corner.wait(1).map(|site| site.line), Some(7));
        assert!(!corner.is_open());
    }

    #[test]
    fn another_corner_waits_anew() {
        let mut corner = OpenCorner::default();
        corner.open(Loc::default());
        assert_eq!(corner.wait(1), None);
        corner.open(Loc { line: 8, ..Loc::default() });
        assert_eq!((corner.wait(1), corner.site().map(|site| site.line)), (None, Some(8)));
        corner.close();
        assert_eq!(corner.site(), None);
    }
}
