//! The ratio to which nets and column generation come to the least total length, and with how many directions.

use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Variant, Verdict};
use crate::fit::GrowthModel;
use crate::seed::Digest;
use families::clouds::{self, Cloud};
use zonotope::enclosing::min_total_length::{Method, MinLengthZonotope, Net};
use zonotope::tally::OperationCounts;

/// Points of each instance.
const POINTS: usize = 24;

/// Nets of more directions are counted but not solved.
const SOLVED_NET: usize = 420;

/// The ratio to which nets and column generation come to the least total length.
pub const EXPERIMENT: Experiment = Experiment {
    id: "length-ratio",
    title: "Least total length over all directions: ratio and number of directions",
    question: "How near to the least total length do nets and directions as they are needed come, and with how many \
               directions? n is 1 / epsilon; there are 24 points in two, three and four dimensions. `net_size` is \
               the number of directions that guarantee the ratio 1 + epsilon, `directions` that of the linear \
               programs that were solved, 0 where an answer was found without one, `generators` the number of the \
               answer. `excess` is its length over the lower bound that it proves, minus 1. Nets of more than 420 \
               directions are counted, not solved.",
    claims: &["theorem-4.7", "direction-net", "size-of-direction-net", "summary-approximate-length"],
    families: &["sphere_2", "sphere_3", "sphere_4"],
    sizes: PerProfile::both(&[2, 4, 8, 16, 32, 64, 128, 256, 512, 1024]),
    instances: PerProfile { quick: 1, full: 2 },
    variants: &[
        Variant::at_all_sizes("papers_net", "The paper's net"),
        Variant::at_all_sizes("net_of_cells", "Corners of cells"),
        Variant {
            id: "by_column_generation",
            title: "Directions as they are needed",
            largest: PerProfile { quick: 128, full: 512 },
        },
    ],
    measure,
    fits: &[
        papers_net(&["sphere_2"], GrowthModel::Linear),
        papers_net(&["sphere_3"], GrowthModel::Quadratic),
        papers_net(&["sphere_4"], GrowthModel::Cubic),
        net_of_cells(&["sphere_2"], GrowthModel::SquareRoot),
        net_of_cells(&["sphere_3"], GrowthModel::Linear),
        net_of_cells(&["sphere_4"], GrowthModel::ThreeHalves),
    ],
    ..Experiment::COUNTED
};

const fn papers_net(families: &'static [&'static str], model: GrowthModel) -> FitPlan {
    net_size("papers_net", families, Bound::of_paper(model, "section 4.3"))
}

const fn net_of_cells(families: &'static [&'static str], model: GrowthModel) -> FitPlan {
    net_size("net_of_cells", families, Bound::own(model))
}

const fn net_size(variant: &'static str, families: &'static [&'static str], bound: Bound) -> FitPlan {
    FitPlan::new(Quantity::Value("net_size"), variant, families, GrowthModel::POWERS).within(bound)
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let family = clouds::find(case.family).ok_or_else(|| format!("no points are called {}", case.family))?;
    match (family.generate)(POINTS, case.instance_seed) {
        Cloud::Plane(points) => measure_in(case, &points),
        Cloud::Space(points) => measure_in(case, &points),
        Cloud::Four(points) => measure_in(case, &points),
    }
}

fn measure_in<const D: usize>(case: &Case, points: &[[f64; D]]) -> Result<Measurement, String> {
    let epsilon = 1.0 / case.n as f64;
    let mut counts = OperationCounts::default();
    let (method, net) = match case.variant {
        "papers_net" => (Method::PapersNet, Some(Net::Paper)),
        "net_of_cells" => (Method::DirectionNet, Some(Net::Cells)),
        _ => (Method::VertexSets, None),
    };
    let size = net.map(|net| net.size(D, epsilon));
    let is_solved = size.is_none_or(|size| size <= SOLVED_NET);
    let answer = is_solved.then(|| method.solve(points, epsilon, &mut counts));
    let measurement = match answer.transpose().map_err(|error| error.to_string())? {
        Some(answer) => Measurement::new(&counts, digest(&answer), verdict(&answer, epsilon))
            .with_value("excess", answer.value / answer.lower_bound - 1.0)
            .with_value("generators", answer.body.generators().len() as f64)
            .with_value("directions", answer.effort.rows as f64),
        None => {
            let reason = format!("a net of more than {SOLVED_NET} directions is counted, not solved");
            Measurement::new(&counts, 0, Verdict::Unchecked(reason))
        }
    };
    Ok(match size {
        Some(size) => measurement.with_value("net_size", size as f64),
        None => measurement,
    })
}

pub(super) fn verdict<const D: usize>(answer: &MinLengthZonotope<D>, epsilon: f64) -> Verdict {
    let is_kept = if answer.ratio() <= 1.0 + epsilon {
        Ok(())
    } else {
        Err(format!("the ratio {} is above 1 + {epsilon}", answer.ratio()))
    };
    Verdict::of_check("the proven ratio", is_kept)
}

pub(super) fn digest<const D: usize>(answer: &MinLengthZonotope<D>) -> u64 {
    let digest = Digest::default().floats(&answer.body.center());
    digest.floats(answer.body.generators().as_flattened()).floats(&[answer.value, answer.lower_bound]).finish()
}
