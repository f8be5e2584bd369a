//! The pass, and the library's own methods.

use super::{Answer, Contender, Work};
use experiments::question::Question;
use rivals::by_gjk::{self, GjkAnswer};
use std::hint::black_box;
use zonotope::collision::Method;
use zonotope::zonotope::{Placed, PreparedBody, Zonotope};

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

/// The same question about bodies that were not prepared: their generators are rows, as they come.
pub const INTERSECTION_OF_ROWS: Contender = Contender {
    id: "intersection_of_rows",
    largest: usize::MAX,
    prepare: |question| {
        let [a, b] = question.bodies();
        Some(Box::new(move || Answer::Member(black_box(a.intersection(&b)).is_member())))
    },
};

/// The same question about prepared bodies that stand under poses.
pub const INTERSECTION_POSED: Contender = Contender {
    id: "intersection_posed",
    largest: usize::MAX,
    prepare: |question| {
        let [a, b] = question.turned().map(|(body, pose)| (PreparedBody::new(body), pose));
        Some(Box::new(move || {
            let [a, b] = [&a, &b].map(|(body, pose)| body.placed().at(pose));
            Answer::Member(black_box(a.intersection(b)).is_member())
        }))
    },
};

/// The public exact gauge with its proof, of a body that was prepared beforehand.
pub const GAUGE_PREPARED: Contender = Contender {
    id: "gauge",
    largest: usize::MAX,
    prepare: |question| {
        let body = Zonotope::new(question.from, question.generators.clone()).expect("the body was valid");
        let (body, point) = (PreparedBody::new(body), question.to);
        Some(Box::new(move || match black_box(&body).gauge(black_box(point)) {
            Ok(gauge) => Answer::Member(black_box(gauge).location.is_member()),
            Err(_) => Answer::Failed,
        }))
    },
};

/// A question to two prepared bodies where they stand, that says whether they have a point, or inner points, in common.
fn measure(question: &Question, meet: fn(Placed<'_>, Placed<'_>) -> bool) -> Work<'static> {
    let bodies = question.bodies().map(PreparedBody::new);
    Box::new(move || {
        let [a, b] = bodies.each_ref().map(PreparedBody::placed);
        Answer::Member(meet(a, b))
    })
}

/// The public distance of two disjoint bodies that were prepared beforehand, within two units in the last place.
pub const DISTANCE: Contender = Contender {
    id: "distance",
    largest: usize::MAX,
    prepare: |question| question.are_disjoint().then(|| measure(question, |a, b| black_box(a.distance(b)) == 0.0)),
};

/// The same distance with the points, faces and coefficients that prove it.
pub const PROXIMITY: Contender = Contender {
    id: "proximity",
    largest: usize::MAX,
    prepare: |question| {
        question.are_disjoint().then(|| measure(question, |a, b| black_box(a.proximity(b)).distance() == 0.0))
    },
};

/// The public penetration depth of two overlapping bodies that were prepared beforehand, proved within a hundredth.
pub const PENETRATION: Contender = Contender {
    id: "penetration",
    largest: usize::MAX,
    prepare: |question| question.overlap().then(|| measure(question, |a, b| black_box(a.penetration(b)).lower > 0.0)),
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
