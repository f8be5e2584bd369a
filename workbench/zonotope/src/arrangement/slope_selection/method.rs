//! The methods of slope selection by name.

use super::{ArrangementVertex, LineArrangement, SlopeSelectionError, brute_force, randomized, zero_based};
use crate::tables::methods;

methods! {
    /// A method that finds vertices by their ranks.
    pub enum Method;
    /// The cost of one rank among n lines.
    fn cost;

    /// [`randomized`], the default.
    Randomized => "randomized", "Random pivots", "O(n log n) expected";
    /// [`brute_force`].
    BruteForce => "brute_force", "All vertices, sorted in rationals", "O(n² log n) in rationals";
}

impl Method {
    /// The vertices with the given ranks, which count from 1. `seed` decides the time, never the abscissas.
    ///
    /// # Errors
    /// [`SlopeSelectionError::Rank`] if a rank is 0 or above the number of vertices.
    pub fn vertices(
        self,
        arrangement: &LineArrangement,
        ranks: &[u64],
        seed: u64,
    ) -> Result<Vec<ArrangementVertex>, SlopeSelectionError> {
        match self {
            Self::Randomized => randomized::kth_leftmost_vertices(arrangement, ranks, seed),
            Self::BruteForce => {
                let places = ranks.iter().map(|&rank| zero_based(arrangement, rank)).collect::<Result<Vec<_>, _>>()?;
                let vertices = brute_force::vertices(arrangement);
                Ok(places.into_iter().map(|place| vertices[place as usize].clone()).collect())
            }
        }
    }

    /// All vertices from left to right.
    pub fn all_vertices(self, arrangement: &LineArrangement, seed: u64) -> Vec<ArrangementVertex> {
        let ranks: Vec<u64> = (1..=arrangement.vertex_count()).collect();
        self.vertices(arrangement, &ranks, seed).expect("the ranks are those of the vertices that there are")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Rational;

    /// Three lines y = x, y = −x and y = 2 x − 3 cross at x = 0, 1 and 3.
    #[test]
    fn methods_agree_and_refuse_the_same_ranks() {
        let lines = [[1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [2.0, -1.0, -3.0]];
        let arrangement = LineArrangement::from_rows(&lines).expect("finite lines");
        for method in Method::ALL {
            let x = method.all_vertices(&arrangement, 7).iter().map(ArrangementVertex::exact_x).collect::<Vec<_>>();
            assert_eq!(x, [0, 1, 3].map(Rational::from), "{method:?}");
            for rank in [0, 4] {
                let refused = SlopeSelectionError::Rank { rank, vertices: 3 };
                assert_eq!(method.vertices(&arrangement, &[1, rank], 7).map(|_| ()), Err(refused), "{method:?}");
            }
            assert_eq!(Method::from_id(method.id()), Some(method));
        }
    }
}
