//! Bodies in motion.

use experiments::definition::Quantity;
use experiments::findings::words;
use experiments::measured::{Extreme, Measured, range};

use crate::report::chapter::{Chapter, ChapterTable, Cost, Held};

pub(super) static CHAPTER: Chapter = Chapter {
    id: "motion",
    title: "Bodies in motion",
    place: "Section 6, Theorem 6.1",
    statement: "Two bodies turn and translate during a step of time. Do they meet, and when first, so that no \
        collision between two looks at them is missed?",
    lesson,
    pictures: &["motion-time-bar"],
    table: ChapterTable::Growth,
    method: &[
        "The paper's volume: the ways of all vertices of a turning body lie in a circle through the farthest one's \
         end. A square around it and the translation are three generators more, and a body of them holds all \
         placements; half of the translation is enough, as generators are half-lengths. Where the volumes of two \
         bodies meet, the step is cut in two.",
        "Control points: along a direction the gap between the bodies, times a positive polynomial of the time, has \
         Bernstein coefficients that support values bound. If all are positive, one direction proves a whole stretch \
         of time, in space-time and not only in space.",
    ],
    costs: &[Cost { text: "The paper: O(n log n) for the three generators.", held: Held::Claim("theorem-6.1") }],
    claims: &[
        "summary-space-time",
        "collisions-between-steps",
        "disjoint-space-time-volumes",
        "interval-bisection",
        "pure-translation",
        "placements-by-vertices",
        "figure-3",
        "arcs-in-circle",
        "farthest-vertex-from-axis",
        "theorem-6.1",
        "any-schedule",
        "half-of-translation",
        "radius-of-rotation",
        "projected-vertices",
    ],
    experiments: &["motion-strength", "motion-clearance", "motion-misses", "swept-excess", "space-time-scaling"],
    commands: &[(
        "cargo run --release -- solve tests/goldens/questions.jsonl",
        "answers questions of every kind, those of collide and sweep among them",
    )],
};

/// The stretches of one motion by the paper's volumes and by control points, and what sampling misses.
fn lesson(found: &Measured<'_>) -> Option<String> {
    let medians = |method| found.over_inputs("motion-strength", method, Quantity::Value("intervals"));
    let numbers = |ends: &[Extreme]| range(ends.iter().map(|end| end.number)).map(words::between);
    let (own, papers) = (medians("by_control_points"), medians("by_space_time_volumes"));
    let shares = own.iter().filter_map(|end| {
        let other = papers.iter().find(|other| other.input == end.input)?;
        // medians of whole numbers, so that further digits of their ratio say nothing
        Some((other.number / end.number).round())
    });
    let factor = words::between(range(shares)?);
    let missed = |method, value| found.total("motion-misses", method, value);
    let share = |method| Some(words::percent(missed(method, "missed")? / missed(method, "collisions")?));
    Some(format!(
        "At a clearance of one thousandth the median motion of motion-strength is proved free by {} stretches of time \
         with one direction each, family by family, where the volumes of Theorem 6.1 take {}: some {factor} times as \
         many. Of the collisions of fast and crafted motions sampling misses {}, hulls of end poses miss {}, and \
         samples contradict {} of the answers by control points.",
        numbers(&own)?,
        numbers(&papers)?,
        share("by_sampling")?,
        share("by_hull_of_end_poses")?,
        words::number(missed("by_control_points", "missed")?),
    ))
}
