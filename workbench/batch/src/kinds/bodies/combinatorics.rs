//! `combinatorics`: how many faces a zonotope has, and its volume.

use serde_json::{Map, Value, json};
use zonotope::zonotope::{Zonotope, combinatorics};

use crate::claimed::{Placed, Traced, index, member, text};
use crate::dimension::in_dimension;
use crate::fields::{Fields, image_not_held};
use crate::kinds::{Kind, Solution};
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "combinatorics",
    summary: "how many vertices, edges and facets a zonotope has, and its exact volume",
    fields: &["generators"],
    optional: &["pose"],
    methods: || vec![BY_COUNTING],
    solve,
    check,
};

const BY_COUNTING: &str = "by_counting";

/// The most generators that are taken in 1, 2, … dimensions.
const GENERATOR_LIMITS: [usize; 6] = [2_000_000, 2_000_000, 4000, 40, 16, 12];

fn solve(fields: &Fields<'_>, _method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    // No generators are a point, in any space.
    let dimension = fields.dimension_of_first("generators")?.unwrap_or(3);
    let result = in_dimension!(dimension, "generator 1", in_space(fields))?;
    Ok(Solution { method: BY_COUNTING, result })
}

fn in_space<const D: usize>(fields: &Fields<'_>) -> Result<Value, Refusal> {
    let generators = fields.vectors::<D>("generators")?;
    let most = GENERATOR_LIMITS[D - 1];
    if generators.len() > most {
        let message = format!("{} generators, at most {most} are taken in {D} dimensions", generators.len());
        return Err(Refusal::new(Code::TooLarge, message));
    }
    let body = Zonotope::new([0.0; D], generators).expect("the numbers of a question are finite");
    let placement = fields.placement(D)?;
    let stretch = placement.exact().determinant().abs();
    // A regular matrix keeps all faces and stretches the volume; a body that it flattens is counted as its image.
    let body = if stretch.is_zero() {
        placement.image(&body).ok_or_else(|| image_not_held(&fields.place_of("pose"), D))?
    } else {
        body
    };
    let counts = combinatorics(&body);
    let measure = if stretch.is_zero() { counts.measure } else { counts.measure * stretch.to_rational() };
    let sizes: Map<String, Value> =
        counts.facet_sizes.iter().map(|(size, count)| (size.to_string(), (*count).into())).collect();
    Ok(json!({
        "affine_dim": counts.affine_dimension,
        "vertices": counts.vertices,
        "edges": counts.edges,
        "facets": counts.facets,
        "facet_sizes": sizes,
        "measure": measure.to_string(),
    }))
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let body = Placed::around_origin(input)?;
    let sizes = member(result, "facet_sizes")?.fields().ok_or("`facet_sizes` is not an object")?;
    // A size has one spelling, so that none comes twice.
    let size = |name: &str| name.parse::<usize>().ok().filter(|size| size.to_string() == name);
    let sizes = sizes.map(|(name, count)| Some((size(name)?, count.tree.index()? as u64)));
    let count = |name| index(result, name).map(|count| count as u64);
    let answer = verifier::CombinatoricsAnswer {
        affine_dim: index(result, "affine_dim")?,
        vertices: count("vertices")?,
        edges: count("edges")?,
        facets: count("facets")?,
        facet_sizes: sizes.collect::<Option<_>>().ok_or("`facet_sizes` holds something else than counts")?,
        measure: verifier::Fraction::parse(text(result, "measure")?).ok_or("`measure` is not an exact number")?,
    };
    Ok(verifier::check_combinatorics(&body.body(), &answer).in_words())
}
