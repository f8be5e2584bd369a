//! Cells of directions: the directions through a square on a side of the cube [−1, 1]³, divided into four quarters
//! each.

/// The directions through a square on a side of the cube.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cell {
    /// The coordinate that is constant on the side, and its value, 1 or −1.
    axis: usize,
    side: f64,
    /// The least values of the two other coordinates, in cyclic order after the axis, multiples of the width.
    low: [f64; 2],
    width: f64,
}

impl Cell {
    /// The six sides of the cube: every direction is in one of them.
    pub(crate) fn sides() -> [Self; 6] {
        [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0), (2, 1.0), (2, -1.0)].map(|(axis, side)| Self {
            axis,
            side,
            low: [-1.0; 2],
            width: 2.0,
        })
    }

    fn at(&self, place: [f64; 2]) -> [f64; 3] {
        let mut direction = [self.side; 3];
        direction[(self.axis + 1) % 3] = place[0];
        direction[(self.axis + 2) % 3] = place[1];
        direction
    }

    /// The corners: each direction of the cell is a combination of them with factors that are not negative.
    pub(crate) fn corners(&self) -> [[f64; 3]; 4] {
        let [[a, b], w] = [self.low, [self.width; 2]];
        [[a, b], [a + w[0], b], [a, b + w[1]], [a + w[0], b + w[1]]].map(|place| self.at(place))
    }

    /// The direction in the middle.
    pub(crate) fn center(&self) -> [f64; 3] {
        self.at(self.low.map(|low| low + self.width / 2.0))
    }

    /// By how much the coordinates of the directions on the square differ from those of the centre: 0 along the axis.
    pub(crate) fn reach(&self) -> [f64; 3] {
        let mut reach = [self.width / 2.0; 3];
        reach[self.axis] = 0.0;
        reach
    }

    /// The directions with a given product of 1 with a side: the coordinate that is constant on the square, and its
    /// value.
    pub(crate) fn side(&self) -> (usize, f64) {
        (self.axis, self.side)
    }

    /// The four quarters; `None` where doubles do not hold their corners.
    pub(crate) fn quarters(&self) -> Option<[Self; 4]> {
        let half = self.width / 2.0;
        let middle = self.low.map(|low| low + half);
        let is_exact = (0..2).all(|k| middle[k] - self.low[k] == half && (middle[k] + half) - middle[k] == half);
        let quarter = |low| Self { low, width: half, ..*self };
        let [[a, b], [c, d]] = [self.low, middle];
        (is_exact && half > f64::MIN_POSITIVE).then(|| [[a, b], [c, b], [a, d], [c, d]].map(quarter))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarters_are_divided_as_far_as_doubles_go() {
        let [right, ..] = Cell::sides();
        assert_eq!(right.corners()[1], [1.0, 1.0, -1.0]);
        assert_eq!((right.center(), right.reach(), right.side()), ([1.0, 0.0, 0.0], [0.0, 1.0, 1.0], (0, 1.0)));
        let quarters = right.quarters().expect("half of 2");
        assert_eq!(quarters[3].corners()[0], [1.0, 0.0, 0.0]);
        assert_eq!(quarters[0].center(), [1.0, -0.5, -0.5]);
        let depth = |place: usize| {
            let mut cell = right;
            (0..).take_while(|_| cell.quarters().map(|quarters| cell = quarters[place]).is_some()).count()
        };
        // at a corner of the side the last place of 1 ends it
        assert_eq!(depth(0), 54);
        let mut cell = quarters[3];
        for _ in 0..900 {
            cell = cell.quarters().expect("near the middle of the side doubles are dense")[0];
        }
        assert_eq!(cell.corners()[0], [1.0, 0.0, 0.0]);
    }
}
