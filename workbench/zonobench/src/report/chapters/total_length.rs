//! Enclosing zonotopes of least total length.

use experiments::data::meshes;
use experiments::definition::Quantity;

use crate::report::chapter::{Chapter, ChapterTable};
use crate::report::measured::{Measured, Series, range};

pub(super) static CHAPTER: Chapter = Chapter {
    id: "total-length",
    title: "The shortest zonotope around points of any dimension",
    place: "Sections 4.2 and 4.3, Theorems 4.6 and 4.7; section 7",
    statement: "Given points in two, three, four or more dimensions, which zonotope around them has generators of \
        the least total length: along given directions, or along any?",
    lesson,
    pictures: &["mesh-in-zonohedra"],
    table: ChapterTable::Values("enclosing-quality"),
    method: &[
        "Along k given directions it is a linear program. The paper's has a coefficient for every direction and \
         every extreme point. The same zonotope has only normals that are orthogonal to d − 1 of the directions, so \
         k lengths and a centre are enough, with one inequality for each normal; and of those normals only a few \
         times k matter. They are found as they are needed: a point outside the present zonotope names the facet \
         that it is beyond.",
        "Floating point only proposes. Each answer is enlarged until every point is inside, exactly, and comes with \
         forces: vectors λ at some of the points that add up to zero and pull along no direction by more than its \
         weight. Whatever encloses the points costs at least Σ λ·p. So every answer tells, with a proof, how far \
         from the best it may be.",
        "Over all directions a net of them suffices for a ratio 1 + ε. The paper's net has of order 1/ε to the power \
         d − 1 directions; half that exponent is enough, since a generator is a sum of segments along the corners of \
         its cell of the net. Better than either is to add directions as they are needed: the forces span a zonotope \
         of their own; where one of its vertices leaves the unit ball a direction is missing, and the farthest \
         vertex says what the forces prove for all directions at once.",
    ],
    bound: "The paper: O(n k^(d−1) + k^O(d)) for k directions. Here: a few readings of the n points and programs of \
        a few times k rows; over all directions some ten such programs.",
    claims: &[
        "structure-from-directions",
        "extreme-points-suffice",
        "linear-program",
        "theorem-4.6",
        "direction-net",
        "containment-chain",
        "theorem-4.7",
        "summary-fixed-directions",
        "summary-approximate-length",
        "open-approximation-quality",
        "erratum-4.2-extreme-points",
        "erratum-4.3-containment",
        "erratum-4.3-objective",
    ],
    experiments: &[
        "directions-scaling",
        "points-scaling",
        "scan-race",
        "length-ratio",
        "net-scaling",
        "net-scaling-in-space",
        "net-points",
        "gap-curve",
        "few-generators",
        "enclosing-quality",
    ],
    commands: &[
        (
            "cargo run --release -- enclose experiments/data/teapot.obj --epsilon 0.001 --json teapot.answer.json",
            "finds a zonotope around a mesh with a proven ratio to the shortest one",
        ),
        (
            "cargo run --release -- enclose experiments/data/outline_italy.csv --objective length --directions axes",
            "solves it along given directions, here those of the axes",
        ),
        (
            "cargo run --release -- solve tests/goldens/questions.jsonl",
            "answers questions of every kind, min_length_dirs and min_length_all among them",
        ),
    ],
};

/// How near to the shortest zonotopes around meshes are proved to be, and how much smaller than boxes they are.
fn lesson(found: &Measured<'_>) -> Option<String> {
    let of = |value| {
        meshes().iter().filter_map(move |mesh| {
            let series = Series { experiment: "enclosing-quality", input: mesh.name, method: "within_1e-2" };
            Some(found.at_largest(series, Quantity::Value(value))?.1)
        })
    };
    let [_, ratio] = range(of("ratio"))?;
    let [least, greatest] = range(of("volume_ratio"))?;
    let [least_box, greatest_box] = range(of("box_volume_ratio"))?;
    Some(format!(
        "Around {} meshes the zonotopes are proved to be within {:.2} % of the least total length; they have \
         {least:.2} to {greatest:.2} times the volume of the convex hull, and boxes along the axes {least_box:.2} to \
         {greatest_box:.2} times.",
        of("ratio").count(),
        100.0 * (ratio - 1.0)
    ))
}
