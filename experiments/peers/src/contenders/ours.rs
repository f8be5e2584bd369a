//! The pass, and the library's own methods.

use super::{Answer, Contender, Work};
use experiments::families::bodies::question::Question;
use std::hint::black_box;
use zonotope::collision::by_gjk::{self, GjkAnswer};
use zonotope::collision::{by_explicit_faces, by_lad, by_slope_selection};
use zonotope::zonotope::passes::absolute_sum;

/// One evaluation of the support function in doubles over the question's generators.
pub const PASS: Contender = Contender { id: "pass", largest: usize::MAX, prepare: pass };

fn pass(question: &Question) -> Option<Work<'_>> {
    let direction = question.to;
    Some(Box::new(move || {
        black_box(absolute_sum(black_box(&question.generators), black_box(&direction)));
        Answer::Nothing
    }))
}

/// Location with its proof, by the kernel.
pub const LOCATE: Contender = Contender {
    id: "by_lad",
    largest: usize::MAX,
    prepare: |question| {
        let displacement = question.displacement();
        Some(Box::new(move || Answer::Member(by_lad::locate(&displacement).is_member())))
    },
};

/// The exact gauge and location with its proof, by the kernel.
pub const GAUGE: Contender = Contender {
    id: "by_lad_gauge",
    largest: usize::MAX,
    prepare: |question| {
        let displacement = question.displacement();
        Some(Box::new(move || Answer::Member(by_lad::gauge(&displacement).location.is_member())))
    },
};

/// The paper's Theorem 5.2.
pub const SLOPE_SELECTION: Contender = Contender {
    id: "by_slope_selection",
    largest: 1 << 14,
    prepare: |question| {
        let displacement = question.displacement();
        Some(Box::new(move || Answer::Member(by_slope_selection::locate(&displacement, 1).is_member())))
    },
};

/// All facets, listed anew for each question: what it costs to have no implicit form.
pub const EXPLICIT_FACES: Contender = Contender {
    id: "by_explicit_faces",
    largest: 1 << 10,
    prepare: |question| {
        let displacement = question.displacement();
        Some(Box::new(move || match by_explicit_faces::locate(&displacement) {
            Ok(location) => Answer::Member(location.is_member()),
            Err(_) => Answer::Failed,
        }))
    },
};

/// GJK on the difference of the two bodies, as the library has it: in doubles, giving up openly.
pub const GJK: Contender = Contender {
    id: "by_gjk",
    largest: usize::MAX,
    prepare: |question| {
        let displacement = question.displacement();
        Some(Box::new(move || match by_gjk::locate(&displacement) {
            GjkAnswer::Intersecting => Answer::Member(true),
            GjkAnswer::Disjoint { .. } => Answer::Member(false),
            GjkAnswer::GaveUp => Answer::Failed,
        }))
    },
};
