//! The L1 line fit: the kernel (`zonotope::line_fit`) against the crate `palb`, the published exact solver, on the same
//! points. A pass is the widest sum of all deviations from a line over the rows that the kernel gets.

use experiments::peers::LineFit;
use experiments::seed;
use families::source::RandomSource;
use palb::{Floating, PrimalPoint, l1line};
use std::hint::black_box;
use std::time::Instant;
use zonotope::line_fit;
use zonotope::zonotope::passes;

/// Slope and intercept of a line.
type Line = [f64; 2];

/// Fits a line to `n` points near a line, by both, `repetitions` times in turn.
///
/// # Errors
/// Points that one of the two cannot fit a line to.
pub fn compare(n: usize, repetitions: usize, seed: u64) -> anyhow::Result<LineFit> {
    let points = points(n, seed::seed_of(seed, &format!("line_fit/n={n}")));
    let weighted: Vec<[f64; 3]> = points.iter().map(|&[x, y]| [x, y, 1.0]).collect();
    let mut record = LineFit { n, palb_ns: Vec::new(), ours_ns: Vec::new(), pass_ns: Vec::new(), ..LineFit::default() };
    let (mut by_palb, mut by_kernel) = ([0.0; 2], [0.0; 2]);
    for _ in 0..repetitions {
        let mut copy: Vec<PrimalPoint> =
            points.iter().map(|p| PrimalPoint::new(Floating::from(p[0]), Floating::from(p[1]))).collect();
        let start = Instant::now();
        let line = l1line(&mut copy);
        record.palb_ns.push(start.elapsed().as_nanos() as f64);
        let line = line.ok_or_else(|| anyhow::anyhow!("palb fits no line to {n} points"))?;
        by_palb = [line.slope().into_inner(), line.intercept().into_inner()];

        let start = Instant::now();
        let fit = line_fit::fit(&weighted)?;
        record.ours_ns.push(start.elapsed().as_nanos() as f64);
        by_kernel = fit.rounded();

        let start = Instant::now();
        let [slope, intercept] = black_box(by_kernel);
        black_box(passes::absolute_sum(black_box(&weighted), &[slope, -1.0, intercept]));
        record.pass_ns.push(start.elapsed().as_nanos() as f64);
    }
    [record.palb_residual, record.ours_residual] = [by_palb, by_kernel].map(|line| residuals(&points, line));
    Ok(record)
}

/// Points (x, 3 x − 1 + noise), x uniform in [−1, 1), the noise a product of two normal numbers: heavier tails than
/// normal ones.
fn points(n: usize, seed: u64) -> Vec<[f64; 2]> {
    let mut source = RandomSource::new(seed);
    (0..n)
        .map(|_| {
            let x = source.signed_unit();
            let noise = source.normal_pair()[0] * source.normal_pair()[0];
            [x, 3.0 * x - 1.0 + noise]
        })
        .collect()
}

fn residuals(points: &[[f64; 2]], [slope, intercept]: Line) -> f64 {
    let mut sums = [0.0; 8];
    for block in points.chunks(8) {
        for (sum, [x, y]) in sums.iter_mut().zip(block) {
            *sum += (slope * x + intercept - y).abs();
        }
    }
    sums.iter().sum()
}
