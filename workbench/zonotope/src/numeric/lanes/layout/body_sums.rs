//! Sums over vectors of space that every question about a body needs, whatever its direction.

use fearless_simd::{Simd, dispatch};

use super::octet::{self, LANES, total};
use super::octets::blocks_of;
use super::rows::{BodySums, LaidOut, Rows};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::{Number, Units, size};

/// Lays rows out for passes. Three passes, and one that writes the blocks.
pub(crate) fn laid_out(list: &[[f64; 3]]) -> LaidOut {
    let blocks = dispatch!(level(), simd => blocks_of(simd, list));
    let runs = [Rows::with_blocks(list, &blocks), Rows::NONE];
    let sums =
        BodySums { squares: squares::<false>(runs), weighted_squares: squares::<true>(runs), sizes: sizes(runs) };
    LaidOut { blocks, sums }
}

/// The sums of two runs, if both are known.
#[inline(always)]
fn known([first, second]: [Rows<'_>; 2]) -> Option<(&BodySums, Option<&BodySums>)> {
    let own = first.sums()?;
    if second.is_empty() { Some((own, None)) } else { Some((own, Some(second.sums()?))) }
}

/// Whether the sums of two runs are known without a pass.
pub(crate) fn are_known(runs: [Rows<'_>; 2]) -> bool {
    known(runs).is_some()
}

/// The longest length, and the sum of all.
pub(crate) fn sizes(runs: [Rows<'_>; 2]) -> [f64; 2] {
    match known(runs) {
        Some((own, None)) => own.sizes,
        Some((own, Some(other))) => [own.sizes[0].max(other.sizes[0]), own.sizes[1] + other.sizes[1]],
        None => dispatch!(level(), simd => sizes_at(simd, runs)),
    }
}

/// Σ v vᵀ / |v| with their own lengths, else Σ v vᵀ.
pub(crate) fn squares<const OWN: bool>(runs: [Rows<'_>; 2]) -> [f64; 6] {
    dispatch!(level(), simd => squares_at::<_, OWN>(simd, runs))
}

/// The same within a pass.
#[inline(always)]
pub(crate) fn squares_at<S: Simd, const OWN: bool>(simd: S, runs: [Rows<'_>; 2]) -> [f64; 6] {
    let of = |sums: &BodySums| if OWN { sums.weighted_squares } else { sums.squares };
    match known(runs) {
        Some((own, None)) => of(own),
        Some((own, Some(other))) => {
            let (own, other) = (of(own), of(other));
            [0, 1, 2, 3, 4, 5].map(|k| own[k] + other[k])
        }
        None => summed_squares::<S, OWN>(simd, runs),
    }
}

#[inline(always)]
fn sizes_at<S: Simd>(simd: S, runs: [Rows<'_>; 2]) -> [f64; 2] {
    let units = Units::wide(simd);
    let (mut longest, mut sum) = (units.zero, units.zero);
    for run in runs {
        let octets = run.octets();
        for k in 0..octets.len() {
            let size = size(&octets.load(simd, k), &units);
            longest = longest.larger(size);
            sum += size;
        }
    }
    [octet::largest(longest), total(sum)]
}

#[inline(always)]
fn summed_squares<S: Simd, const OWN: bool>(simd: S, runs: [Rows<'_>; 2]) -> [f64; 6] {
    let units = Units::wide(simd);
    let (mut sums, mut few) = ([units.zero; 6], [0.0; 6]);
    for run in runs {
        let (octets, rest) = run.octets().whole_and_rest();
        for k in 0..octets.len() {
            let v = octets.load(simd, k);
            add_square(&mut sums, &weighted::<_, OWN>(&v, &units), &v);
        }
        for v in rest {
            add_square(&mut few, &weighted::<_, OWN>(v, &Units::SINGLE), v);
        }
    }
    if runs[0].len() + runs[1].len() >= LANES {
        for k in 0..6 {
            few[k] += total(sums[k]);
        }
    }
    few
}

/// v / |v| where lengths are their own, else v.
#[inline(always)]
pub(crate) fn weighted<T: Number, const OWN: bool>(v: &[T; 3], units: &Units<T>) -> [T; 3] {
    if !OWN {
        return *v;
    }
    let weight = units.one / size(v, units);
    [weight * v[0], weight * v[1], weight * v[2]]
}

/// Adds w vᵀ, for w a multiple of v.
#[inline(always)]
pub(crate) fn add_square<T: Number>(sums: &mut [T; 6], [x, y, z]: &[T; 3], v: &[T; 3]) {
    sums[0] += *x * v[0];
    sums[1] += *x * v[1];
    sums[2] += *x * v[2];
    sums[3] += *y * v[1];
    sums[4] += *y * v[2];
    sums[5] += *z * v[2];
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::lanes::rows::count_of;

    #[test]
    fn sums_worked_out_by_hand() {
        let list = [[1.0, 2.0, 4.0], [-3.0, 0.0, 1.0]];
        let runs = [Rows::new(&list), Rows::NONE];
        assert_eq!(squares::<false>(runs), [10.0, 2.0, 1.0, 4.0, 8.0, 17.0]);
        assert_eq!(squares::<true>(runs)[..3], [0.25 + 3.0, 0.5, 1.0 - 1.0]);
        assert_eq!(sizes(runs), [4.0, 7.0]);
    }

    #[test]
    fn known_sums_are_those_of_a_pass() {
        let list: Vec<[f64; 3]> = (0..21).map(|i| [f64::from(i), 5.0 - f64::from(i), 0.5]).collect();
        let known = laid_out(&list);
        let (plain, prepared) = (Rows::new(&list), Rows::laid_out(&list, &known));
        for (plain, prepared) in [([plain, Rows::NONE], [prepared, Rows::NONE]), ([plain; 2], [prepared; 2])] {
            assert_eq!(squares::<false>(plain), squares::<false>(prepared));
            assert_eq!(sizes(plain), sizes(prepared));
            let [own, other] = [squares::<true>(plain), squares::<true>(prepared)];
            assert!(own.iter().zip(other).all(|(a, b)| (a - b).abs() <= 1e-14 * a.abs()));
        }
    }

    /// Eight rows (2, −3, 8) fill an octet: with a row (1, 4, 2), both kinds of sums take part.
    #[test]
    fn sums_over_a_whole_octet_worked_out_by_hand() {
        let mut list = vec![[2.0, -3.0, 8.0]; 8];
        let of = |list: &[[f64; 3]]| {
            let runs = [Rows::new(list), Rows::NONE];
            (squares::<false>(runs), squares::<true>(runs), sizes(runs))
        };
        let octet = ([32.0, -48.0, 128.0, 72.0, -192.0, 512.0], [4.0, -6.0, 16.0, 9.0, -24.0, 64.0], [8.0, 64.0]);
        assert_eq!(of(&list), octet);
        list.push([1.0, 4.0, 2.0]);
        let all = ([33.0, -44.0, 130.0, 88.0, -184.0, 516.0], [4.25, -5.0, 16.5, 13.0, -22.0, 65.0], [8.0, 68.0]);
        assert_eq!(of(&list), all);
    }

    #[test]
    fn sums_are_known_where_all_runs_were_laid_out() {
        let list = [[1.0, 2.0, 3.0]; 9];
        let laid_out = laid_out(&list);
        let (plain, prepared) = (Rows::new(&list), Rows::laid_out(&list, &laid_out));
        assert!([[prepared, Rows::NONE], [prepared; 2]].into_iter().all(are_known));
        assert!(![[plain, Rows::NONE], [prepared, plain], [plain, prepared]].into_iter().any(are_known));
        assert!(laid_out.sums.magnitude() == 81.0 && count_of([plain, Rows::new(&list[..2])]) == 11);
    }
}
