//! The arrangement of great circles, one a direction v: the unit vectors u with u · v = 0, seen from a pole that lies
//! on none of them.
//!
//! Every meridian from the north pole to the south pole meets each circle once, so along a meridian the circles have an
//! order, and going east from one meridian halfway around the sphere each pair changes places exactly once: where the
//! facets with both directions have their normals. Relative to the pole the circles are lines x s + y + o = 0 of the
//! plane with the meridians vertical. Floating-point numbers s and o guess orders; determinants of the directions
//! decide them.

use std::cmp::Ordering;

use crate::numeric::dyadic::Dyadic;
use crate::numeric::orientation::in_space::{Direction, determinant_sign, determinant_sign_counted};
use crate::tally::{Operation, Tally};

/// In a sequence of crossings: this one is not at the place of the one before.
pub(super) const NEW_PLACE: u32 = 1 << 31;

/// Circles in the order from north to south in which the first meridian meets them; their number is a circle's rank.
#[derive(Debug, Clone)]
pub(super) struct Circles {
    /// Turned to the hemisphere of the pole.
    pub(super) directions: Vec<Direction>,
    /// The class of parallel generators, and whether its representative was turned around.
    pub(super) classes: Vec<(u32, bool)>,
    slopes: Vec<f64>,
    offsets: Vec<f64>,
}

impl Circles {
    /// The circles of pairwise non-parallel nonzero vectors. O(n log n), apart from the rare search for a pole.
    pub(super) fn new(vectors: &[[f64; 3]]) -> Self {
        let vectors: Vec<Direction> = vectors.iter().map(|&v| Direction::new(v)).collect();
        let pole = pole_off_all_circles(&vectors);
        // the first meridian leaves the pole towards the y axis; meridians exactly there count as slightly further east
        let [p, q, r] = pole;
        let meridian = Direction::new([r, 0.0, -p]);
        let tie_breaker = Direction::new([0.0, -r, q]);
        let mut circles: Vec<(Direction, u32, bool)> = vectors
            .into_iter()
            .zip(0..)
            .map(|(v, class)| {
                let reversed = side_of(&pole, &v).is_lt();
                (if reversed { v.reversed() } else { v }, class, reversed)
            })
            .collect();
        circles.sort_by(|(a, ..), (b, ..)| {
            let further_north = determinant_sign(&meridian, a, b).reverse();
            further_north.then_with(|| determinant_sign(&tie_breaker, a, b))
        });
        let height = |v: [f64; 3]| v[0] * p + v[1] * q + v[2] * r;
        Self {
            slopes: circles.iter().map(|(v, ..)| v.scaled()[1] / height(v.scaled())).collect(),
            offsets: circles.iter().map(|(v, ..)| v.scaled()[0] / height(v.scaled())).collect(),
            classes: circles.iter().map(|&(_, class, reversed)| (class, reversed)).collect(),
            directions: circles.into_iter().map(|(v, ..)| v).collect(),
        }
    }

    /// How many circles there are.
    pub(super) fn len(&self) -> usize {
        self.directions.len()
    }

    /// The ranks of the circles that circle `rank` crosses in the half turn east of the first meridian, in this order;
    /// those that cross in one place in the order of their ranks, all but the first without [`NEW_PLACE`]. O(n log n).
    pub(super) fn crossings(&self, rank: usize, keys: &mut Vec<u64>, crossings: &mut Vec<u32>, tally: &mut impl Tally) {
        crossings.clear();
        self.guess_order(rank, keys);
        let low_bits = self.low_bits();
        crossings.extend(keys.iter().map(|key| (key & low_bits) as u32));
        let certain = crossings.windows(2).all(|pair| self.order(rank, pair[0], pair[1], tally).is_lt());
        if certain {
            crossings.iter_mut().for_each(|crossing| *crossing |= NEW_PLACE);
            return;
        }
        crossings.sort_by(|&a, &b| self.order(rank, a, b, tally).then(a.cmp(&b)));
        let mut previous = None;
        for crossing in crossings {
            let other = *crossing;
            if previous.is_none_or(|p| self.order(rank, p, other, tally).is_ne()) {
                *crossing |= NEW_PLACE;
            }
            previous = Some(other);
        }
    }

    /// Which of the circles `a` and `b` circle `rank` crosses first, exactly.
    #[inline]
    fn order(&self, rank: usize, a: u32, b: u32, tally: &mut impl Tally) -> Ordering {
        tally.add(Operation::Comparison, 1);
        // the circle further north passes below the other: the crossing lies at the cross product of the northern by
        // the southern one
        let swapped = (a as usize > rank) != (b as usize > rank);
        let [circle, a, b] = [rank, a as usize, b as usize].map(|rank| &self.directions[rank]);
        let sign = determinant_sign_counted(circle, a, b, tally);
        if swapped { sign } else { sign.reverse() }
    }

    /// The other circles sorted by the computed abscissa of the crossing: its bits, made to compare like the number,
    /// with the rank in the lowest ones.
    fn guess_order(&self, rank: usize, keys: &mut Vec<u64>) {
        let (slope, offset, low_bits) = (self.slopes[rank], self.offsets[rank], self.low_bits());
        let key = |(other, (s, o)): (u64, (&f64, &f64))| {
            let bits = ((o - offset) / (slope - s)).to_bits();
            let ordered = bits ^ (((bits as i64 >> 63) as u64) | 1 << 63);
            (ordered & !low_bits) | other
        };
        keys.clear();
        keys.extend((0..).zip(self.slopes.iter().zip(&self.offsets)).map(key));
        keys.swap_remove(rank);
        keys.sort_unstable();
    }

    fn low_bits(&self) -> u64 {
        (self.len() as u64).next_power_of_two() - 1
    }
}

/// A vector of positive coordinates with no zero dot product among `directions`.
fn pole_off_all_circles(directions: &[Direction]) -> [f64; 3] {
    let ordinary = [297.0, 471.0, 1024.0];
    // On the curve (k, k², k³) a direction vanishes at two k > 0 at most: one of 2 n + 1 values is good for all.
    let curve = (2..).map(f64::from).map(|k: f64| [k, k * k, k * k * k]);
    let good = |pole: &[f64; 3]| directions.iter().all(|v| side_of(pole, v).is_ne());
    std::iter::once(ordinary).chain(curve).find(good).expect("finitely many candidates are bad")
}

/// The sign of pole · v, exactly.
fn side_of(pole: &[f64; 3], v: &Direction) -> Ordering {
    let terms = v.original().map(Dyadic::from_f64);
    let dot = terms.iter().zip(pole).fold(Dyadic::zero(), |sum, (c, &p)| sum + c * &Dyadic::from_f64(p));
    dot.sign()
}

/// The crossings of all circles, one circle after the other.
pub(super) struct Crossings {
    /// As [`Circles::crossings`] gives them, n − 1 a circle.
    pub(super) sequences: Vec<u32>,
    /// Where the arcs of each circle begin among those of all circles, and their total: twice as many as places.
    pub(super) zone_starts: Vec<u32>,
    /// How many crossings there are in the half turn, and for how many pairs (crossing, circle through it).
    pub(super) facets: usize,
    pub(super) incidences: usize,
}

impl Crossings {
    pub(super) fn new(circles: &Circles, tally: &mut impl Tally) -> Self {
        let mut sequences = Vec::with_capacity(circles.len() * (circles.len() - 1));
        let mut zone_starts = vec![0];
        let (mut keys, mut crossings) = (Vec::new(), Vec::new());
        let (mut facets, mut incidences) = (0, 0);
        for rank in 0..circles.len() {
            circles.crossings(rank, &mut keys, &mut crossings, tally);
            let mut places = 0;
            for crossing in &crossings {
                places += crossing >> 31;
                // a crossing is counted by the northernmost of its circles: there the first other one lies south of it
                facets += usize::from(crossing & NEW_PLACE != 0 && crossing & !NEW_PLACE > rank as u32);
            }
            incidences += places as usize;
            zone_starts.push(zone_starts[rank] + 2 * places);
            sequences.extend_from_slice(&crossings);
        }
        Self { sequences, zone_starts, facets, incidences }
    }
}
