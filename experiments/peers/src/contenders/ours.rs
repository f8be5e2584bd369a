//! The pass, and the library's own methods.

use super::{Answer, Contender, Work};
use experiments::families::bodies::question::Question;
use std::hint::black_box;
use zonotope::collision::by_lad;
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
