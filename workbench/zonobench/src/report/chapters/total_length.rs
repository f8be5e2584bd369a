//! Enclosing zonotopes of least total length.

use experiments::data::meshes;
use experiments::definition::Quantity;
use experiments::findings::words;

use crate::report::chapter::{Chapter, ChapterTable, Cost, Held};
use experiments::fit::GrowthModel;
use experiments::measured::{Measured, Series, range};

pub(super) static CHAPTER: Chapter = Chapter {
    id: "total-length",
    title: "The shortest zonotope around points of any dimension",
    place: "Sections 4.2 and 4.3, Theorems 4.6 and 4.7; section 7",
    statement: "Given points in two, three, four or more dimensions, which zonotope around them has generators of \
        the least total length: along given directions, or along any?",
    lesson,
    pictures: &["few-generators"],
    table: ChapterTable::Values("enclosing-quality"),
    method: &[
        "Along k given directions it is a linear program. The paper's has a coefficient for every direction and \
         every extreme point. The same zonotope has only normals that are orthogonal to d − 1 of the directions, so \
         k lengths and a centre are enough, with one inequality for each normal; and the normals \
         that matter are found as they are needed: a point outside the present zonotope names the facet \
         that it is beyond.",
        "Floating point only proposes. Each answer is enlarged until every point is inside, exactly, and comes with \
         forces: vectors λ at some of the points that add up to zero and pull along no direction by more than its \
         weight. Whatever encloses the points costs at least Σ λ·p. So every answer tells, with a proof, how far \
         from the best it may be.",
        "Over all directions a net of them suffices for a ratio 1 + ε. The paper moves each generator to a direction \
         of the net; a coarser net is enough when a generator is a sum of segments along the corners of its cell. \
         Another way is to add directions as they are needed: the forces span a zonotope \
         of their own; where one of its vertices leaves the unit ball a direction is missing, and the farthest \
         vertex says what the forces prove for all directions at once.",
    ],
    costs: &[
        Cost { text: "The paper: O(n k^(d−1) + k^O(d)) for k directions.", held: Held::Claim("theorem-4.6") },
        Cost { text: "The paper's net: O(1/ε^(d−1)) directions.", held: Held::Claim("direction-net") },
        Cost {
            text: "A net whose cells share out a generator: O(n^(3/2)) directions in four dimensions, for n = 1/ε.",
            held: Held::Fit { experiment: "length-ratio", method: "net_of_cells", law: GrowthModel::ThreeHalves },
        },
    ],
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
        "question-approximation-quality",
        "extreme-points-off-the-span",
        "sum-over-the-axes",
        "size-of-direction-net",
        "meaning-of-total-length",
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

/// The proven ratio of zonotopes to the shortest, and how much smaller than boxes they are, around meshes and
/// around everything.
fn lesson(found: &Measured<'_>) -> Option<String> {
    let of = |value| {
        meshes().iter().filter_map(move |mesh| {
            let series = Series { experiment: "enclosing-quality", input: mesh.name, method: "within_1e-2" };
            Some(found.at_largest(series, Quantity::Value(value))?.1)
        })
    };
    let [least, greatest] = range(of("volume_ratio"))?;
    let [least_box, greatest_box] = range(of("box_volume_ratio"))?;
    let overall = |value| found.extremes("enclosing-quality", "within_1e-2", Quantity::Value(value), words::plain);
    let ([_, ratio], [_, volume]) = (overall("ratio")?, overall("volume_ratio")?);
    Some(format!(
        "Around {} meshes the zonotopes have {least:.2} to {greatest:.2} times the volume of the convex hull, and \
         boxes along the axes {least_box:.2} to {greatest_box:.2} times; over all inputs the volume is at most {} \
         times that of the hull, and the total length is proved to be at most {} times the least.",
        of("ratio").count(),
        words::at(&volume),
        words::at(&ratio)
    ))
}
