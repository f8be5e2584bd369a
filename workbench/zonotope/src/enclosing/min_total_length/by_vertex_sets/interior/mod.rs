//! Newton steps towards the best multipliers for the sets seen so far: an interior point method that works on multipliers and generators at once.
//!
//! A step solves the linear equations of Σ_{T ∋ j} 2 g_T = p_j − p_0, of τ_T = 1, and of slack ∘ load = μ seen through their common [`Scaling`]; first for μ = 0, to see how much of
//! the way one can go, then for a μ chosen by that, with what the first step neglects (Mehrotra). Both have the matrix H = Σ_T a_T a_Tᵀ ⊗ W_T⁻², a_T = 2 for the points of T.
//!
//! H is put together from running sums: the row of a point is the sum Σ W_T⁻² a_T over all T that contain it, which is the difference of two running
//! sums for each run of them; neighbours in the order of the sets differ by few points.

mod cholesky;
pub(super) mod cone;
pub(super) mod scalar;

use super::vertex_sets::{Sides, sum_over};
use cholesky::{Cholesky, Factor};
use cone::{ConeVector, Scaling, jordan};
use scalar::{Scalar, dot, plus, values, zero};

/// A step ends before the boundary of the cone by this part of the way.
const SHORT_OF: f64 = 0.02;

/// How often generators are corrected by what they miss of the points.
const MOST_CORRECTIONS: usize = 4;

/// What they miss is nothing below this multiple of the gap that is wanted.
const CLOSELY: f64 = 0.01;

/// For corrections generators count as no shorter than this beside the longest.
const SHORT: f64 = 1e-6;

/// One step is never asked to bring μ down by more than this.
const FASTEST: f64 = 1e-4;

/// What is known after a step.
pub(super) struct Stepped<const D: usize> {
    /// Generators with Σ_{T ∋ j} 2 g_T = p_j − p_0 but for rounding.
    pub(super) generators: Vec<[f64; D]>,
    /// What they miss of any point along each axis.
    pub(super) missed: [f64; D],
    /// The average of slack · load.
    pub(super) mu: f64,
}

/// The equations of a step.
struct Equations<'a, R, const D: usize> {
    sides: &'a Sides<'a, R, D>,
    scalings: Vec<Scaling<R, D>>,
    factor: Factor<R>,
}

impl<R: Scalar, const D: usize> Sides<'_, R, D> {
    /// One step towards the optimum for the sets as they are, not beyond a least μ; `None` where rounding ends the method.
    pub(super) fn step(&mut self, least_mu: f64) -> Option<Stepped<D>> {
        let scalings: Vec<Scaling<R, D>> =
            self.sides.iter().map(|side| Scaling::new(&side.slack, &side.load)).collect::<Option<_>>()?;
        let matrix = self.matrix(&scalings);
        let size = self.rank * (self.points.len() - 1);
        let vertices = 30.0 * self.points.len().saturating_pow(self.rank as u32 - 1) as f64;
        self.work += R::WORK * (size * size * size) as f64 / 6.0 + vertices;
        let equations = Equations { sides: self, scalings, factor: matrix.factor()? };
        let residual = self.residual(self.sides.iter().map(|side| side.load.rest));
        let count = self.sides.len() as f64;
        let mu = self.sides.iter().map(|side| side.slack.dot(&side.load).value()).sum::<f64>() / count;

        let aims: Vec<ConeVector<R, D>> = self.sides.iter().map(|side| ConeVector::zero().minus(&side.load)).collect();
        let first = equations.solve(&residual, &aims)?;
        let [of_slack, of_load] = self.reach(&first).map(R::from);
        let after: f64 = self
            .sides
            .iter()
            .zip(&first.moves)
            .map(|(side, (slack, load))| side.slack.plus(of_slack, slack).dot(&side.load.plus(of_load, load)).value())
            .sum::<f64>()
            / count;
        let ratio = (after / mu).clamp(0.0, 1.0);
        let wanted = (ratio * ratio * ratio).max(FASTEST).max((least_mu / mu).min(1.0)) * mu;

        let aims: Vec<ConeVector<R, D>> = equations
            .scalings
            .iter()
            .zip(&first.moves)
            .map(|(scaling, (slack, load))| {
                let neglected = jordan(&scaling.undo(slack), &scaling.apply(load));
                let square = jordan(&scaling.both, &scaling.both);
                let mut right = ConeVector::zero().minus(&square).minus(&neglected);
                right.head = right.head + R::from(wanted);
                scaling.undo(&scaling.divided(&right))
            })
            .collect();
        let second = equations.solve(&residual, &aims)?;
        let parts = self.reach(&second);
        let [of_slack, of_load] = parts.map(R::from);
        let loads: Vec<ConeVector<R, D>> =
            self.sides.iter().zip(&second.moves).map(|(side, (_, load))| side.load.plus(of_load, load)).collect();
        let left = self.residual(loads.iter().map(|load| load.rest));
        let generators = equations.corrected(&left, &loads)?;
        self.multipliers = self.turned(of_slack, &second.turned);
        for ((side, (slack, _)), load) in self.sides.iter_mut().zip(&second.moves).zip(loads) {
            let head = if parts[0] == 1.0 { R::from(1.0) } else { side.slack.head + of_slack * slack.head };
            side.slack = ConeVector { head, rest: sum_over(&side.set, &self.multipliers) };
            side.load = load;
        }
        let mu = self.sides.iter().map(|side| side.slack.dot(&side.load).value()).sum::<f64>() / count;
        self.mu = mu;
        let (generators, missed) = self.closed(generators, CLOSELY * least_mu * count);
        Some(Stepped { generators: generators.iter().map(values).collect(), missed, mu })
    }

    /// Which parts of the steps of all slacks and of all loads stay inside the cone, all of it at most.
    fn reach(&self, step: &Step<R, D>) -> [f64; 2] {
        let mut reach = [f64::INFINITY; 2];
        for (side, (slack, load)) in self.sides.iter().zip(&step.moves) {
            reach = [reach[0].min(side.slack.reach(slack)), reach[1].min(side.load.reach(load))];
        }
        reach.map(|reach| ((1.0 - SHORT_OF) * reach).min(1.0))
    }

    /// p_j − p_0 − Σ_{T ∋ j} 2 g_T, for loads that end in −g_T.
    fn residual(&self, loads: impl Iterator<Item = [R; D]>) -> Vec<[R; D]> {
        let mut left = self.points[1..].to_vec();
        for (side, load) in self.sides.iter().zip(loads) {
            for j in side.members() {
                left[j - 1] = plus(&left[j - 1], R::from(2.0), &load);
            }
        }
        left
    }

    /// Generators changed in proportion to their lengths where they miss more than nothing, and what they miss of any point along each axis. To first order it does not
    /// matter which generators make up for a residual r: as each points along its w_T, that changes their length by Σ λ_j · r_j.
    fn closed(&self, mut generators: Vec<[R; D]>, nothing: f64) -> (Vec<[R; D]>, [f64; D]) {
        let count = self.points.len() - 1;
        let mut factor = None;
        let mut best: Option<(f64, [f64; D], Vec<[R; D]>)> = None;
        for _ in 0..=MOST_CORRECTIONS {
            let left = self.residual(generators.iter().map(|g| g.map(|c| -c)));
            let missed = left
                .iter()
                .map(values)
                .fold([0.0; D], |most: [f64; D], v| std::array::from_fn(|c| most[c].max(v[c].abs())));
            let size: f64 = missed.iter().sum();
            if best.as_ref().is_some_and(|(least, ..)| size >= *least) {
                break;
            }
            best = Some((size, missed, generators.clone()));
            if size <= nothing {
                break;
            }
            let weights = || {
                let lengths = || generators.iter().map(|g| dot(g, g).sqrt().value());
                let longest = lengths().fold(0.0, f64::max);
                lengths().map(|length| length.max(SHORT * longest)).collect::<Vec<f64>>()
            };
            if factor.is_none() {
                let weights = weights();
                factor = self.weighted(&weights).factor().map(|factor| (factor, weights));
            }
            let Some((factor, weights)) = &factor else { break };
            let mut turned = vec![zero(); count];
            for axis in 0..self.rank {
                let right: Vec<R> = left.iter().map(|v| v[axis]).collect();
                for (turned, x) in turned.iter_mut().zip(factor.solve(&right)) {
                    turned[axis] = x;
                }
            }
            for ((side, generator), weight) in self.sides.iter().zip(&mut generators).zip(weights) {
                *generator = plus(generator, R::from(*weight), &sum_before(&side.set, &turned));
            }
        }
        let (_, missed, generators) = best.expect("there is a first one");
        (generators, missed)
    }

    /// Σ weight_T a_T a_Tᵀ.
    fn weighted(&self, weights: &[f64]) -> Cholesky<R> {
        let count = self.points.len() - 1;
        let mut sums = vec![R::from(0.0); count * count];
        for (side, weight) in self.sides.iter().zip(weights) {
            for j in side.members() {
                for k in side.members().take_while(|&k| k <= j) {
                    let entry = &mut sums[(j - 1) * count + k - 1];
                    *entry = *entry + R::from(4.0 * weight);
                }
            }
        }
        let mut matrix = Cholesky::zero(count);
        for (j, row) in sums.chunks_exact(count.max(1)).enumerate() {
            row[..=j].iter().enumerate().for_each(|(k, &entry)| matrix.set(j, k, entry));
        }
        matrix
    }

    /// H.
    fn matrix(&self, scalings: &[Scaling<R, D>]) -> Cholesky<R> {
        let (rank, count) = (self.rank, self.points.len() - 1);
        let entries: Vec<(usize, usize)> = (0..rank).flat_map(|a| (0..=a).map(move |b| (a, b))).collect();
        let width = entries.len() * count;
        let mut sums = vec![R::from(0.0); width];
        let mut rows = vec![R::from(0.0); width * count];
        let mut is_member = vec![R::from(0.0); count];
        let mut before: &[u64] = &vec![0; self.points.len().div_ceil(64)];
        let change = |rows: &mut [R], sums: &[R], j: usize, factor: f64| {
            let factor = R::from(factor);
            let row = &mut rows[width * j..][..width];
            for (row, sums) in row.chunks_exact_mut(count).zip(sums.chunks_exact(count)) {
                for (entry, sum) in row[..=j].iter_mut().zip(sums) {
                    *entry = *entry + factor * *sum;
                }
            }
        };
        for (side, scaling) in self.sides.iter().zip(scalings) {
            for (word, (a, b)) in before.iter().zip(&side.set).enumerate() {
                let mut changed = a ^ b;
                while changed != 0 {
                    let bit = changed.trailing_zeros() as usize;
                    changed &= changed - 1;
                    let (j, is_in) = (64 * word + bit - 1, b >> bit & 1 == 1);
                    is_member[j] = R::from(if is_in { 1.0 } else { 0.0 });
                    change(&mut rows, &sums, j, if is_in { -1.0 } else { 1.0 });
                }
            }
            before = &side.set;
            for (sums, &(a, b)) in sums.chunks_exact_mut(count).zip(&entries) {
                let entry = R::from(4.0) * scaling.entry(a, b);
                for (sum, is_member) in sums.iter_mut().zip(&is_member) {
                    *sum = *sum + entry * *is_member;
                }
            }
        }
        for j in super::vertex_sets::members(before) {
            change(&mut rows, &sums, j - 1, 1.0);
        }
        let mut matrix = Cholesky::zero(rank * count);
        for (j, row) in rows.chunks_exact(width).enumerate() {
            for (row, &(a, b)) in row.chunks_exact(count).zip(&entries) {
                for (k, &entry) in row[..=j].iter().enumerate() {
                    matrix.set(rank * j + a, rank * k + b, entry);
                    if a != b && k < j {
                        matrix.set(rank * j + b, rank * k + a, entry);
                    }
                }
            }
        }
        matrix
    }
}

/// How the multipliers turn, and how slacks and loads move.
struct Step<R, const D: usize> {
    turned: Vec<[R; D]>,
    moves: Vec<(ConeVector<R, D>, ConeVector<R, D>)>,
}

impl<R: Scalar, const D: usize> Equations<'_, R, D> {
    /// The step that closes a residual, brings every τ_T to 1, and moves loads by their aim less W⁻² times what slacks move.
    fn solve(&self, residual: &[[R; D]], aims: &[ConeVector<R, D>]) -> Option<Step<R, D>> {
        let aims: Vec<ConeVector<R, D>> = self
            .sides
            .sides
            .iter()
            .zip(aims)
            .zip(&self.scalings)
            .map(|((side, aim), scaling)| {
                let stretch = ConeVector { head: R::from(1.0) - side.slack.head, rest: zero() };
                aim.minus(&scaling.undo_twice(&stretch))
            })
            .collect();
        let mut right = residual.to_vec();
        self.pull(&mut right, aims.iter().map(|aim| aim.rest));
        let turned = self.turned(&right)?;
        let moves = self.sides.sides.iter().zip(&aims).zip(&self.scalings).map(|((side, aim), scaling)| {
            let rest = sum_before(&side.set, &turned);
            let slack = ConeVector { head: R::from(1.0) - side.slack.head, rest };
            (slack, aim.minus(&scaling.undo_twice(&headless(rest))))
        });
        let moves = moves.collect();
        Some(Step { turned, moves })
    }

    /// H⁻¹ x, refined once.
    fn turned(&self, right: &[[R; D]]) -> Option<Vec<[R; D]>> {
        let rank = self.sides.rank;
        let solved = |right: &[[R; D]]| -> Vec<[R; D]> {
            let flat: Vec<R> = right.iter().flat_map(|r| r[..rank].to_vec()).collect();
            let x = self.factor.solve(&flat);
            x.chunks_exact(rank).map(|x| std::array::from_fn(|c| x.get(c).copied().unwrap_or(R::from(0.0)))).collect()
        };
        let first = solved(right);
        let mut left = right.to_vec();
        let answered = self.sides.sides.iter().zip(&self.scalings).map(|(side, scaling)| {
            let rest = sum_before(&side.set, &first);
            scaling.undo_twice(&headless(rest)).rest.map(|c| -c)
        });
        self.pull(&mut left, answered);
        let second = solved(&left);
        let sum: Vec<[R; D]> = first.iter().zip(&second).map(|(a, b)| plus(a, R::from(1.0), b)).collect();
        sum.iter().flatten().all(|c| c.value().is_finite()).then_some(sum)
    }

    /// Adds 2 v_T to each point of T.
    fn pull(&self, sums: &mut [[R; D]], vectors: impl Iterator<Item = [R; D]>) {
        for (side, vector) in self.sides.sides.iter().zip(vectors) {
            for j in side.members() {
                sums[j - 1] = plus(&sums[j - 1], R::from(2.0), &vector);
            }
        }
    }

    /// The generators of loads, changed as little as the scaling allows so that they close a residual.
    fn corrected(&self, residual: &[[R; D]], loads: &[ConeVector<R, D>]) -> Option<Vec<[R; D]>> {
        let turned = self.turned(residual)?;
        let sides = self.sides.sides.iter().zip(&self.scalings).zip(loads);
        let generators = sides.map(|((side, scaling), load)| {
            let rest = sum_before(&side.set, &turned);
            plus(&scaling.undo_twice(&headless(rest)).rest, R::from(-1.0), &load.rest)
        });
        Some(generators.collect())
    }
}

/// 2 Σ over a set, of vectors without that of the first point.
fn sum_before<R: Scalar, const D: usize>(set: &[u64], vectors: &[[R; D]]) -> [R; D] {
    super::vertex_sets::members(set).fold(zero(), |sum, j| plus(&sum, R::from(2.0), &vectors[j - 1]))
}

fn headless<R: Scalar, const D: usize>(rest: [R; D]) -> ConeVector<R, D> {
    ConeVector { head: R::from(0.0), rest }
}
