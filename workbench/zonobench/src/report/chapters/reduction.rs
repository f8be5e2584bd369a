//! Bodies of few generators around bodies of many.

use crate::report::chapter::{Chapter, ChapterTable, Cost, Held};
use experiments::definition::Quantity;
use experiments::findings::words;
use experiments::measured::{Measured, range};

pub(super) static CHAPTER: Chapter = Chapter {
    id: "reduction",
    title: "Few generators instead of many",
    place: "Section 5.2, Lemma 5.5",
    statement: "A sum of two bodies has the generators of both, and the lists grow. Which zonotope of a few generators \
        contains a given one, and how far is it from it?",
    lesson,
    pictures: &["reductions"],
    table: ChapterTable::ValuesOn("reduction-error", "random_bodies"),
    method: &[
        "The paper cuts the sphere of directions into patches, adds up the generators of each patch, and makes up for \
         what is lost by a box (Lemma 5.5).",
        "Fitted sums of clusters add up the generators of each cluster; the \
         clusters are moved until the largest difference of the support functions falls no more. The sums grow by the \
         factor at which they contain the body, which is proved at every facet normal.",
        "Branch and bound over cones of directions bounds the Hausdorff distance from both sides.",
    ],
    costs: &[Cost {
        text: "The paper: O(1/ε²) generators for a distance of ε diameters, found in O(n) time.",
        held: Held::Claim("lemma-5.5"),
    }],
    claims: &[
        "convex-approximation",
        "ball-approximation",
        "zonoid-approximation",
        "lemma-5.5",
        "lemma-5.5-containment",
        "diameter-and-total-length",
        "width-of-patches",
    ],
    experiments: &["reduction-error", "patches-error", "patches-scaling"],
    commands: &[
        (
            "echo '{\"generators\":[[1,0,0],[0,1,0],[0,0,1],[1,1,1],[1,-1,1]]}' | \
             cargo run --release -- reduce - --count 4 --format json",
            "finds a body of few generators around one of your own, and says how far apart they are",
        ),
        (
            "cargo run --release -- solve tests/goldens/questions.jsonl",
            "answers questions of every kind, those of reduce and hausdorff among them",
        ),
    ],
};

/// The distances of three rules from the body with as many generators, on all kinds of bodies.
fn lesson(found: &Measured<'_>) -> Option<String> {
    let error = |method| {
        let errors = found.over_inputs("reduction-error", method, Quantity::Value("error"));
        let ends = range(errors.iter().map(|end| end.number))?;
        Some((errors.iter().map(|end| end.n).max()?, errors.len(), words::between(ends)))
    };
    let ((count, kinds, fitted), (_, _, patches), (_, _, girard)) =
        (error("cluster")?, error("lemma_5_5")?, error("girard")?);
    Some(format!(
        "With at most {count} generators around bodies of {}, of {kinds} kinds, fitted cluster sums come within \
         {fitted} diameters of them, the patches of Lemma 5.5 within {patches} and Girard's rule within {girard}; that \
         each contains the body is decided exactly.",
        experiments::definitions::reduction_error::GENERATORS
    ))
}
