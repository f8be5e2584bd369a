//! Section 4.3, Theorem 4.7.

use experiments::fit::{GrowthModel, fit_growth};
use families::clouds;
use zonotope::enclosing::min_length;
use zonotope::enclosing::min_total_length::{Net, by_direction_net};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::growth::verdict;
use crate::proofs::lengths::check_shortest;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "theorem-4.7",
    place: Place { section: "4.3", label: "Theorem 4.7" },
    kind: ClaimKind::Theorem,
    statement: "An enclosing zonotope with total length within O(eps) of the least can be computed in O(n \
        eps^(-(d-1)^2) + eps^(-O(d^2))) time",
    remedy: Some(
        "eps^(-(d-1)/2) directions are enough; and directions found as they are needed reach any precision with a \
            proven ratio",
    ),
    code: &[
        "zonotope::enclosing::min_total_length::by_direction_net",
        "zonotope::enclosing::min_total_length::by_vertex_sets",
    ],
    figures: &["length-ratio", "directions-needed", "dual-zonotope", "gap-curve"],
    check: Check::Run(check),
    tried: Tried::On(&["points on spheres of R^2 and R^3"]),
};

/// Each answer's containment, length and lower bound are checked exactly; its ratio is at most 1 + eps; the nets' sizes
/// grow as they should.
fn check(context: &CheckContext) -> Verdict {
    let mut seen = Seen::default();
    let tried = (0..3)
        .try_for_each(|index| {
            keeps::<2>(context.seed + index, 9, &[0.5, 0.1, 0.02, 0.005], Some(Net::Paper), &mut seen)?;
            keeps::<2>(context.seed + index, 9, &[0.5, 0.1, 0.02, 0.005], Some(Net::Cells), &mut seen)?;
            keeps::<2>(context.seed + index, 9, &[1e-3, 1e-6, 1e-9], None, &mut seen)
        })
        .and_then(|()| keeps::<3>(context.seed, 6, &[0.9], Some(Net::Paper), &mut seen))
        .and_then(|()| keeps::<3>(context.seed, 6, &[0.9], Some(Net::Cells), &mut seen))
        .and_then(|()| keeps::<3>(context.seed, 6, &[0.01], None, &mut seen));
    let found = tried.map(|()| {
        format!(
            "{} answers for points in R^2 and R^3, by both nets and by directions as needed, hold every point, prove \
             their lower bound by forces whose farthest vertex was looked for among all, and have ratios of at most 1 \
             + eps; those of nets use at most {:.0} % of eps",
            seen.answers,
            100.0 * seen.largest_share
        )
    });
    verdict(context, &CLAIM, found, |_| sizes(), &["papers_program", "papers_net", "net_of_cells"])
}

#[derive(Default)]
struct Seen {
    answers: usize,
    largest_share: f64,
}

fn keeps<const D: usize>(
    seed: u64,
    count: usize,
    precisions: &[f64],
    net: Option<Net>,
    seen: &mut Seen,
) -> Result<(), String> {
    let points = clouds::on_sphere::<D>(count, seed);
    for &epsilon in precisions {
        let answer = match net {
            Some(net) => by_direction_net::min_length_by_net(&points, epsilon, net, &mut ()),
            None => min_length(&points, epsilon),
        };
        let answer = answer.map_err(|error| error.to_string())?;
        let name = || format!("{count} points in R^{D}, eps = {epsilon}, {net:?}");
        check_shortest(&points, &answer).map_err(|defect| format!("{}: {defect}", name()))?;
        if answer.ratio() > 1.0 + epsilon {
            return Err(format!("{}: ratio {}", name(), answer.ratio()));
        }
        seen.answers += 1;
        if net.is_some() {
            seen.largest_share = seen.largest_share.max((answer.ratio() - 1.0) / epsilon);
        }
    }
    Ok(())
}

/// The exponents of the nets' sizes against 1 / eps.
fn sizes() -> Result<String, String> {
    let laws = [
        (Net::Paper, 2, GrowthModel::Linear),
        (Net::Paper, 3, GrowthModel::Quadratic),
        (Net::Paper, 4, GrowthModel::Cubic),
        (Net::Cells, 2, GrowthModel::SquareRoot),
        (Net::Cells, 3, GrowthModel::Linear),
        (Net::Cells, 4, GrowthModel::ThreeHalves),
    ];
    let mut exponents = Vec::new();
    for (net, dimension, model) in laws {
        let samples: Vec<(f64, f64)> =
            (4..=12).map(|k| f64::from(1 << k)).map(|n| (n, net.size(dimension, 1.0 / n) as f64)).collect();
        let growth = fit_growth(&samples, &[model]).map_err(|error| error.to_string())?;
        if growth.model(model).and_then(|fit| fit.verdict.keeps_bound()) != Some(true) {
            return Err(format!("the sizes of {net:?} in R^{dimension} grow with exponent {}", growth.exponent.value));
        }
        exponents.push(format!("{:.2}", growth.exponent.value));
    }
    Ok(format!(
        "for eps = 2^-4 to 2^-12 in R^2, R^3, R^4 the paper's net grows like 1 / eps to the powers {}, the other one \
            to {}",
        exponents[..3].join(", "),
        exponents[3..].join(", ")
    ))
}
