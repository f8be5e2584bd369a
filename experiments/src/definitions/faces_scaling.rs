//! Size and time of the explicit face lattice against the number of generators.

use crate::definition::{
    Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, TimedWork, Timing, Variant, Verdict,
};
use crate::fit::GrowthModel;
use crate::seed::Digest;
use zonotope::tally::OperationCounts;
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{FaceLattice, Faces, Facet, faces};

const GENERAL: &[&str] = &["random_bodies", "polar_bodies", "heavy_tailed_bodies"];

const SIZES: PerProfile<&[usize]> =
    PerProfile { quick: &[8, 16, 32, 64, 128, 256, 512], full: &[8, 16, 32, 64, 128, 256, 512, 1024] };

/// Size and time of the explicit face lattice against the number of generators.
pub const EXPERIMENT: Experiment = Experiment {
    id: "faces-scaling",
    title: "Explicit faces: growth with the number of generators",
    question: "How many faces have bodies of n generators, and what does it cost to list them? Values: vertices, \
               edges, facets, and the sides of all facets. Euler's relation and that each edge borders two facets \
               are checked.",
    claims: &["complexity-bound", "explicit-size", "variable-complexity"],
    families: &[
        "random_bodies",
        "polar_bodies",
        "heavy_tailed_bodies",
        "lattice_bodies",
        "parallel_bodies",
        "flat_bodies",
    ],
    sizes: SIZES,
    instances: PerProfile::both(2),
    variants: &[Variant::at_all_sizes("by_sweep", "Sweep of great circles")],
    measure,
    timing: Some(Timing { sizes: SIZES, repetitions: PerProfile::both(3), prepare }),
    fits: &[
        FitPlan::of_operations("by_sweep", GENERAL)
            .of(Quantity::Value("facets"))
            .within(Bound::of_paper(GrowthModel::Quadratic, "section 5")),
        FitPlan::of_operations("by_sweep", GENERAL).of(Quantity::Time("total")),
    ],
    ..Experiment::COUNTED
};

fn body(case: &Case) -> Result<Zonotope<3>, String> {
    Zonotope::new([0.0; 3], case.body()?).map_err(|error| error.to_string())
}

fn lattice(body: &Zonotope<3>) -> Result<FaceLattice, String> {
    match faces(body, &mut ()).map_err(|error| error.to_string())? {
        Faces::Solid(lattice) | Faces::Flat(lattice) => Ok(lattice),
        Faces::Point(_) | Faces::Segment(_) => Err("no two generators span a plane".to_owned()),
    }
}

fn digest(lattice: &FaceLattice) -> u64 {
    let counts = [lattice.vertex_count(), lattice.edge_count(), lattice.facet_count()];
    let digest = counts.into_iter().fold(Digest::default(), |digest, count| digest.word(count as u64));
    digest.floats(lattice.points().as_flattened()).finish()
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let lattice = lattice(&body(case)?)?;
    let [vertices, edges, facets] = [lattice.vertex_count(), lattice.edge_count(), lattice.facet_count()];
    let sides: usize = (0..facets as u32).map(|facet| lattice.facet_edges(Facet(facet)).len()).sum();
    let relations = if vertices + facets != edges + 2 {
        Err(format!("{vertices} - {edges} + {facets} is not 2"))
    } else if sides != 2 * edges {
        Err(format!("{sides} sides of facets for {edges} edges"))
    } else {
        Ok(())
    };
    let verdict = Verdict::of_check("Euler's relation and sides of facets", relations);
    Ok(Measurement::new(&OperationCounts::default(), digest(&lattice), verdict)
        .with_value("vertices", vertices as f64)
        .with_value("edges", edges as f64)
        .with_value("facets", facets as f64)
        .with_value("sides", sides as f64))
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    let body = body(case)?;
    Ok(Box::new(move |stopwatch| {
        let lattice = stopwatch.lap("total", || lattice(&body))?;
        Ok(digest(&lattice))
    }))
}
