//! Split trees: a page divided into rows and columns recursively, with straight or slanted dividers.

use super::polygon::Point;
use serde::{Deserialize, Serialize};

/// The four corners of a cell: top left, top right, bottom right, bottom left.
pub type Quad = [Point; 4];

/// The whole page in unit coordinates.
pub const PAGE: Quad =
    [Point::new(0.0, 0.0), Point::new(1.0, 0.0), Point::new(1.0, 1.0), Point::new(0.0, 1.0)];

/// Which way a split runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub enum Axis {
    /// Children are stacked from top to bottom; dividers are horizontal.
    Rows,
    /// Children are side by side; dividers are vertical.
    Columns,
}

/// A cell of the page: one panel, or split further.
#[derive(Debug, Clone, PartialEq)]
pub enum Node {
    /// One panel.
    Panel,
    /// Several cells.
    Split(Split),
}

/// A cell that is cut into several.
#[derive(Debug, Clone, PartialEq)]
pub struct Split {
    /// The way the children are laid out.
    pub axis: Axis,
    /// The share of each child, above 0; only their ratios count. As many as children.
    pub shares: Vec<f64>,
    /// The slant of each cut, as a fraction of the cell: the cut at fraction `f` joins `f - slant / 2` on the
    /// left (or top) side with `f + slant / 2` on the right (or bottom) side. One fewer than children.
    pub slants: Vec<f64>,
    /// Two or more cells, left to right or top to bottom.
    pub children: Vec<Node>,
}

impl Split {
    /// Positions of each divider on the two sides of the cell: fractions on the left (or top) side and on the
    /// right (or bottom) side. One fewer than children.
    #[must_use]
    pub fn cuts(&self) -> Vec<(f64, f64)> {
        let total: f64 = self.shares.iter().sum();
        let mut reached = 0.0;
        let cut = |(share, slant): (&f64, &f64)| {
            reached += share / total;
            (reached - slant / 2.0, reached + slant / 2.0)
        };
        self.shares.iter().zip(&self.slants).map(cut).collect()
    }

    /// The cells of the children inside the cell `outer`.
    #[must_use]
    pub fn cells(&self, outer: &Quad) -> Vec<Quad> {
        let [top_left, top_right, bottom_right, bottom_left] = *outer;
        let mut cells = Vec::with_capacity(self.children.len());
        let mut from = (0.0, 0.0);
        for to in self.cuts().into_iter().chain([(1.0, 1.0)]) {
            cells.push(match self.axis {
                Axis::Rows => [
                    top_left.toward(bottom_left, from.0),
                    top_right.toward(bottom_right, from.1),
                    top_right.toward(bottom_right, to.1),
                    top_left.toward(bottom_left, to.0),
                ],
                Axis::Columns => [
                    top_left.toward(top_right, from.0),
                    top_left.toward(top_right, to.0),
                    bottom_left.toward(bottom_right, to.1),
                    bottom_left.toward(bottom_right, from.1),
                ],
            });
            from = to;
        }
        cells
    }
}

impl Node {
    /// The number of panels.
    #[must_use]
    pub fn count(&self) -> usize {
        match self {
            Self::Panel => 1,
            Self::Split(split) => split.children.iter().map(Self::count).sum(),
        }
    }

    /// Eight hexadecimal digits that are equal for equal cells (FNV-1a over their corners), to name a tree by.
    pub(super) fn fingerprint(&self) -> String {
        let mut hash = 0xcbf2_9ce4_8422_2325u64;
        for corner in self.cells(&PAGE).iter().flatten() {
            for value in [corner.x, corner.y] {
                hash = (hash ^ (value * 4096.0).round() as u64).wrapping_mul(0x0100_0000_01b3);
            }
        }
        format!("{:08x}", (hash ^ (hash >> 32)) as u32)
    }

    /// The cells of all panels inside `outer`, in the order of the tree. All are convex, since a cut joins
    /// opposite sides of a convex cell.
    #[must_use]
    pub fn cells(&self, outer: &Quad) -> Vec<Quad> {
        match self {
            Self::Panel => vec![*outer],
            Self::Split(split) => {
                let cells = split.cells(outer);
                split.children.iter().zip(&cells).flat_map(|(child, cell)| child.cells(cell)).collect()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::polygon::area;

    fn split(axis: Axis, shares: &[f64], slants: &[f64], children: Vec<Node>) -> Node {
        Node::Split(Split { axis, shares: shares.to_vec(), slants: slants.to_vec(), children })
    }

    #[test]
    fn cells_follow_the_shares_and_the_slants() {
        let columns = split(Axis::Columns, &[1.0, 1.0], &[0.2], vec![Node::Panel, Node::Panel]);
        let tree = split(Axis::Rows, &[3.0, 1.0], &[-0.1], vec![Node::Panel, columns]);
        assert_eq!(tree.count(), 3);
        let cells = tree.cells(&PAGE);
        assert!((cells[0][3].y - 0.8).abs() < 1e-12 && (cells[0][2].y - 0.7).abs() < 1e-12);
        let total: f64 = cells.iter().map(|cell| area(cell)).sum();
        assert!((total - 1.0).abs() < 1e-12);
        // The upper end of the slanted divider is on the slanted divider above it.
        assert!((cells[1][1].x - 0.4).abs() < 1e-12 && (cells[1][1].y - 0.76).abs() < 1e-12);
    }
}
