//! The k-th leftmost vertex of a line arrangement, by counting the inversions between the orders along two vertical
//! lines and narrowing the strip between them with random vertices.
//!
//! # Source
//! Reference 5 of the paper for the problem; the randomised method is that of Dillencourt, Mount and Netanyahu, Int. J.
//! Comput. Geom. Appl. 2 (1992) 1, and Matousek, Inf. Proc. Letters 39 (1991) 183. Departures: the strip is open and
//! its ends are vertices, so that ties cannot stop the progress; a vertical line counts as n vertices that are never
//! listed one by one.
//!
//! # Method
//! 1. The strip is the whole plane: left of all vertices the lines are ordered by descending slope, right of them by
//!    ascending slope.
//! 2. While the strip holds more than `LISTED` · n vertices: pick n of them at random, by rank among the inversions, in
//!    one merge sort. Those that rank sqrt(n) below and above the wanted one bracket it, most likely.
//! 3. Cut the strip at each of the two: sort the lines along the vertical line there and count the inversions left of
//!    it. Keep the part with the wanted rank, or return when it falls on the cut. Counting decides, chance only
//!    shortens.
//! 4. List the vertices left in the strip, sort them, return the wanted one.
//!
//! # Complexity
//! n lines: expected O(n log n), as in the paper's reference: each round divides the number of vertices by about
//! sqrt(n), so two or three rounds lead from n² to n. Every round removes at least the vertices of a cut, so the method
//! ends on any input and for any seed. Space O(n).
//!
//! # Shapes
//! `arrangement`: n lines in any order, duplicates allowed; `rank`: from 1 to the number of vertices.
//!
//! # Numerics
//! Orders along vertical lines and the order of the listed vertices are exact: sorted by doubles, refined by pairs of
//! doubles with error bounds, then by exact dyadic fractions. The picked vertices are compared approximately only: they
//! are guesses.
//!
//! # Checked by
//! [`brute_force`](super::brute_force), for every rank.
//!
//! # Example
//! ```
//! use zonotope::arrangement::LineArrangement;
//! use zonotope::arrangement::slope_selection::randomized;
//! // y = 0, y = x and y = 2 x − 2 cross at x = 0, 1 and 2.
//! let rows = [[0.0, 1.0, 0.0], [1.0, -1.0, 0.0], [2.0, -1.0, -2.0]];
//! let arrangement = LineArrangement::from_rows(&rows).unwrap();
//! let middle = randomized::kth_leftmost_vertex(&arrangement, 2, 0, &mut ()).unwrap();
//! assert_eq!(middle.x(), 1.0);
//! ```

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::slab::{Slab, keyed};
use super::{ArrangementVertex, SlopeSelectionError, zero_based};
use crate::arrangement::exact_sort::sort_exactly;
use crate::arrangement::fraction::Fraction;
use crate::arrangement::lines::{Event, LineArrangement};
use crate::tally::{Operation, Tally};

/// At most this many vertices a line are listed and sorted.
const LISTED: u64 = 2;

/// The k-th leftmost vertex; `seed` decides the time, never the abscissa.
///
/// # Errors
/// When `rank` is 0 or above the number of vertices.
pub fn kth_leftmost_vertex(
    arrangement: &LineArrangement,
    rank: u64,
    seed: u64,
    tally: &mut impl Tally,
) -> Result<ArrangementVertex, SlopeSelectionError> {
    let rank = zero_based(arrangement, rank)?;
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let selected = select(arrangement, &Slab::whole(arrangement), rank, &mut random, tally);
    Ok(vertex_at(arrangement, selected))
}

/// The k-th leftmost vertices for many k, in the order of `ranks`; `seed` decides the time, never the abscissas. Once
/// the vertices between two answers are few they are listed, so n lines cost O(n log n) expected for each of the first
/// n ranks, and O(n² log n) for all.
///
/// # Errors
/// On the first rank that is 0 or above the number of vertices.
pub fn kth_leftmost_vertices(
    arrangement: &LineArrangement,
    ranks: &[u64],
    seed: u64,
) -> Result<Vec<ArrangementVertex>, SlopeSelectionError> {
    let zero_based = ranks.iter().map(|&rank| zero_based(arrangement, rank)).collect::<Result<Vec<_>, _>>()?;
    let mut order: Vec<usize> = (0..ranks.len()).collect();
    order.sort_by_key(|&position| zero_based[position]);
    let sorted: Vec<u64> = order.iter().map(|&position| zero_based[position]).collect();
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let mut events = Vec::with_capacity(ranks.len());
    select_all(arrangement, Slab::whole(arrangement), &sorted, &mut random, &mut events);
    let mut place = vec![0; ranks.len()];
    for (sorted, &position) in order.iter().enumerate() {
        place[position] = sorted;
    }
    let vertex = |sorted: usize| vertex_at(arrangement, events[sorted]);
    Ok(place.into_iter().map(vertex).collect())
}

fn vertex_at(arrangement: &LineArrangement, event: Event) -> ArrangementVertex {
    ArrangementVertex { lines: arrangement.lines_of(event), x: arrangement.abscissa(event) }
}

/// Appends an event for each of the ascending ranks, from 0, among the vertices of a slab.
fn select_all(
    arrangement: &LineArrangement,
    slab: Slab,
    ranks: &[u64],
    random: &mut Pcg64Mcg,
    events: &mut Vec<Event>,
) {
    let Some(&median) = ranks.get(ranks.len() / 2) else { return };
    if slab.event_count() <= LISTED * arrangement.place_count() as u64 {
        events.extend(select_by_listing(arrangement, &slab, ranks, &mut ()));
        return;
    }
    let selected = select(arrangement, &slab, median, random, &mut ());
    let cut = slab.cut(arrangement, &arrangement.abscissa(selected), &mut ());
    let (left, others) = ranks.split_at(ranks.partition_point(|&rank| rank < cut.left));
    let (at, right) = others.split_at(others.partition_point(|&rank| rank < cut.left + cut.at));
    let right: Vec<u64> = right.iter().map(|rank| rank - cut.left - cut.at).collect();
    select_all(arrangement, slab.left_of(arrangement, &cut), left, random, events);
    events.extend(at.iter().map(|_| selected));
    select_all(arrangement, slab.right_of(&cut), &right, random, events);
}

/// An event at the abscissa of the vertex with a rank, from 0, among the vertices of a slab.
pub(crate) fn select(
    arrangement: &LineArrangement,
    slab: &Slab,
    rank: u64,
    random: &mut Pcg64Mcg,
    tally: &mut impl Tally,
) -> Event {
    let mut slab = slab.clone();
    let mut rank = rank;
    while slab.event_count() > LISTED * arrangement.place_count() as u64 {
        let mut lower: Option<Fraction> = None;
        for guess in bracket(arrangement, &slab, rank, random, tally) {
            let x = arrangement.abscissa(guess);
            if lower.is_some_and(|lower| x <= lower) {
                break;
            }
            let cut = slab.cut(arrangement, &x, tally);
            if rank < cut.left {
                slab = slab.left_of(arrangement, &cut);
                break;
            }
            if rank < cut.left + cut.at {
                return guess;
            }
            rank -= cut.left + cut.at;
            slab = slab.right_of(&cut);
            lower = Some(x);
        }
    }
    select_by_listing(arrangement, &slab, &[rank], tally)[0]
}

/// Vertices of the slab that are likely just left and just right of the one with the given rank; one at least.
fn bracket(
    arrangement: &LineArrangement,
    slab: &Slab,
    rank: u64,
    random: &mut Pcg64Mcg,
    tally: &mut impl Tally,
) -> Vec<Event> {
    let (total, picked) = (slab.vertex_count(), arrangement.place_count() as u64);
    let stretch = total / picked;
    let rest = total % picked;
    let ranks: Vec<u64> = (0..picked)
        .map(|i| i * stretch + i.min(rest) + random.random_range(0..stretch + u64::from(i < rest)))
        .collect();
    let events = slab.pick(&ranks, tally);
    let mut guesses: Vec<((i64, f64), Event)> =
        events.into_iter().map(|event| (arrangement.rough_abscissa(event), event)).collect();
    let expected = (u128::from(rank) * u128::from(picked) / u128::from(total)) as u64;
    let margin = picked.isqrt().min(picked / 2);
    let mut comparisons = 0;
    let mut nth = |position: u64| {
        let order = |((a, rest), _): &((i64, f64), Event), ((b, other), _): &((i64, f64), Event)| {
            comparisons += 1;
            a.cmp(b).then(rest.total_cmp(other))
        };
        guesses.select_nth_unstable_by(position as usize, order).1.1
    };
    let lower = expected.checked_sub(margin).map(&mut nth);
    let upper = Some(expected + margin).filter(|&position| position < picked).map(&mut nth);
    tally.add(Operation::Comparison, comparisons);
    lower.into_iter().chain(upper).collect()
}

/// An event for each of the ascending ranks, from 0, among the vertices of a slab.
fn select_by_listing(arrangement: &LineArrangement, slab: &Slab, ranks: &[u64], tally: &mut impl Tally) -> Vec<Event> {
    let listed = slab.events(tally);
    let mut keyed = keyed(arrangement, &listed);
    sort_exactly(&mut keyed, |item| arrangement.abscissa(listed[item as usize]), tally);
    let mut sorted = keyed.iter().map(|keyed| listed[keyed.item as usize]);
    let (mut left, mut last) = (0, None);
    let mut event_with = |rank: u64| {
        while left <= rank {
            let event = sorted.next().expect("the rank is below the number of vertices of the slab");
            left += slab.multiplicity(event);
            last = Some(event);
        }
        last.expect("the first rank has moved past an event")
    };
    ranks.iter().map(|&rank| event_with(rank)).collect()
}
