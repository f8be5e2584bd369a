//! The pass, and the library's own methods.

use super::{Answer, Contender, Work};
use experiments::question::Question;
use rivals::by_gjk::{self, GjkAnswer};
use std::hint::black_box;
use zonotope::collision::{Method, Query, by_lad};
use zonotope::zonotope::{PreparedBody, Zonotope};

/// One evaluation of the support function in doubles over the question's generators, which are laid out for it
/// beforehand.
pub const PASS: Contender = Contender { id: "pass", largest: usize::MAX, prepare: pass };

fn pass(question: &Question) -> Option<Work<'_>> {
    let body = Zonotope::new([0.0; 3], question.generators.clone()).expect("the bodies were valid");
    let (body, direction) = (PreparedBody::new(body), question.to);
    Some(Box::new(move || {
        black_box(black_box(&body).absolute_sum(black_box(&direction)));
        Answer::Nothing
    }))
}

/// The work of locating by a method of the library.
fn location(method: Method, question: &Question) -> Option<Work<'_>> {
    let displacement = question.displacement();
    Some(Box::new(move || match method.locate(&displacement, 1, &mut ()) {
        Ok(Some(location)) => Answer::Member(location.is_member()),
        Ok(None) | Err(_) => Answer::Failed,
    }))
}

/// Location with its proof, by the kernel.
pub const LOCATE: Contender =
    Contender { id: "by_lad", largest: usize::MAX, prepare: |question| location(Method::ByLad, question) };

/// The exact gauge and location with its proof, by the kernel.
pub const GAUGE: Contender = Contender {
    id: "by_lad_gauge",
    largest: usize::MAX,
    prepare: |question| {
        let displacement = question.displacement();
        Some(Box::new(move || match Method::ByLad.gauge(&displacement, &mut ()) {
            Ok(gauge) => Answer::Member(gauge.location.is_member()),
            Err(_) => Answer::Failed,
        }))
    },
};

/// The question to two bodies that were prepared beforehand.
fn between(bodies: &[PreparedBody; 2]) -> Query<'_, 3> {
    let [a, b] = bodies;
    Query::of_placed(a.placed(), b.placed())
}

/// Location with its proof, by the kernel on two bodies that were prepared beforehand.
pub const LOCATE_PREPARED: Contender = Contender {
    id: "by_lad_prepared",
    largest: usize::MAX,
    prepare: |question| {
        let bodies = question.bodies().map(PreparedBody::new);
        Some(Box::new(move || Answer::Member(by_lad::locate(&between(&bodies), &mut ()).is_member())))
    },
};

/// The public question about two bodies that were prepared beforehand, answered with a proof of constant size.
pub const INTERSECTION: Contender = Contender {
    id: "intersection",
    largest: usize::MAX,
    prepare: |question| {
        let bodies = question.bodies().map(PreparedBody::new);
        Some(Box::new(move || Answer::Member(black_box(bodies[0].intersection(&bodies[1])).is_member())))
    },
};

/// The same question, and a coefficient of each generator written as a verifier takes it.
pub const INTERSECTION_WRITTEN: Contender = Contender {
    id: "intersection_written",
    largest: usize::MAX,
    prepare: |question| {
        let bodies = question.bodies().map(PreparedBody::new);
        Some(Box::new(move || Answer::Member(black_box(bodies[0].intersection(&bodies[1]).expand()).is_member())))
    },
};

/// The exact gauge and location with its proof, by the kernel on two bodies that were prepared beforehand.
pub const GAUGE_PREPARED: Contender = Contender {
    id: "by_lad_gauge_prepared",
    largest: usize::MAX,
    prepare: |question| {
        let bodies = question.bodies().map(PreparedBody::new);
        Some(Box::new(move || Answer::Member(by_lad::gauge(&between(&bodies), &mut ()).location.is_member())))
    },
};

/// The paper's Theorem 5.2.
pub const SLOPE_SELECTION: Contender = Contender {
    id: "by_slope_selection",
    largest: 1 << 14,
    prepare: |question| location(Method::BySlopeSelection, question),
};

/// All facets, listed anew for each question: what it costs to have no implicit form.
pub const EXPLICIT_FACES: Contender = Contender {
    id: "by_explicit_faces",
    largest: 1 << 10,
    prepare: |question| location(Method::ByExplicitFaces, question),
};

/// GJK on the difference of the two bodies, in doubles, giving up openly.
pub const GJK: Contender = Contender {
    id: "by_gjk",
    largest: usize::MAX,
    prepare: |question| {
        let displacement = question.displacement();
        Some(Box::new(move || match by_gjk::locate(&displacement, &mut ()) {
            GjkAnswer::Intersecting => Answer::Member(true),
            GjkAnswer::Disjoint { .. } => Answer::Member(false),
            GjkAnswer::GaveUp => Answer::Failed,
        }))
    },
};
