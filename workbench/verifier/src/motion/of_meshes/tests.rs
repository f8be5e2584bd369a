//! First contacts of meshes by hand, and answers of which one thing was changed.

use super::{FreeParts, MeshContactAnswer, MeshEncounter, MovingSurface, check_mesh_contact};
use crate::Verdict;
use crate::motion::answer::{FreeInterval, MovingDirection};
use crate::motion::path::{Motion, MotionPiece};

const X: MovingDirection = MovingDirection::Space([1.0, 0.0, 0.0]);
const STILL: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

/// The vertices and the triangles of a mesh.
struct Mesh {
    vertices: Vec<Vec<f64>>,
    triangles: Vec<Vec<usize>>,
}

/// A square of side 1 across the first axis, as two triangles.
fn square(x: f64) -> Mesh {
    let vertices = [[x, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0], [x, 1.0, 1.0]];
    Mesh { vertices: vertices.map(|v| v.to_vec()).to_vec(), triangles: vec![vec![0, 1, 2], vec![1, 2, 3]] }
}

fn triangle(corners: [[f64; 3]; 3]) -> Mesh {
    Mesh { vertices: corners.map(|corner| corner.to_vec()).to_vec(), triangles: vec![vec![0, 1, 2]] }
}

fn moved(translation: [f64; 3]) -> Motion {
    turned(STILL, translation)
}

fn turned(to: [f64; 4], translation: [f64; 3]) -> Motion {
    Motion::Pieces(vec![MotionPiece { until: 1.0, from: STILL, to, axis_point: [0.0; 3], translation }])
}

fn verdict(meshes: [&Mesh; 2], motions: [&Motion; 2], answer: &MeshContactAnswer) -> Verdict {
    let surface = |i: usize| {
        let Mesh { vertices, triangles } = meshes[i];
        MovingSurface { vertices, triangles, motion: motions[i] }
    };
    check_mesh_contact([surface(0), surface(1)], 1.0 / 1024.0, answer)
}

fn free(parts: [[usize; 2]; 2], [from, to]: [f64; 2], direction: MovingDirection) -> FreeParts {
    FreeParts { interval: FreeInterval { from, to, direction }, parts }
}

/// The answer about squares 4 apart that come nearer by 8: they meet half way, and until a time they are apart.
fn squares_that_meet(until: f64) -> MeshContactAnswer {
    let intervals = vec![
        free([[0, 1], [0, 2]], [0.0, until], X),
        free([[1, 2], [0, 2]], [0.0, 0.25], X),
        free([[1, 2], [0, 1]], [0.25, until], X),
        free([[1, 2], [1, 2]], [0.25, 0.5 - 1.0 / 4096.0], X),
    ];
    let encounter = MeshEncounter::Contact { time: [until, 0.5], triangles: [1, 1] };
    MeshContactAnswer { encounter, order: [vec![1, 0], vec![0, 1]], intervals }
}

const UNTIL: f64 = 0.5 - 1.0 / 1024.0;

fn of_squares(answer: &MeshContactAnswer) -> Verdict {
    verdict([&square(0.0), &square(4.0)], [&Motion::Rest, &moved([-8.0, 0.0, 0.0])], answer)
}

#[test]
fn an_answer_is_right_and_wrong_when_one_thing_is_changed() {
    let right = squares_that_meet(UNTIL);
    assert!(of_squares(&right).is_right(), "{:?}", of_squares(&right));
    let is_wrong = |what: &str, change: &dyn Fn(&mut MeshContactAnswer)| {
        let mut answer = right.clone();
        change(&mut answer);
        assert_ne!(answer, right, "{what}");
        let told = of_squares(&answer);
        assert!(told.is_wrong(), "{what}: {told:?}");
    };
    for k in 0..right.intervals.len() {
        is_wrong("an interval is left out", &|answer| {
            answer.intervals.remove(k);
        });
        is_wrong("a direction is turned round", &|answer| {
            answer.intervals[k].interval.direction = MovingDirection::Space([-1.0, 0.0, 0.0]);
        });
        is_wrong("a direction is zero", &|answer| {
            answer.intervals[k].interval.direction = MovingDirection::Space([0.0; 3]);
        });
        is_wrong("a direction is not finite", &|answer| {
            answer.intervals[k].interval.direction = MovingDirection::A([f64::NAN, 0.0, 0.0]);
        });
        is_wrong("an interval ends early", &|answer| answer.intervals[k].interval.to -= 1.0 / 512.0);
        is_wrong("an interval begins late", &|answer| answer.intervals[k].interval.from += 1e-9);
        is_wrong("an interval ends before it begins", &|answer| answer.intervals[k].interval.to = -1.0);
        is_wrong("an interval begins before the step", &|answer| answer.intervals[k].interval.from = -1.0);
        is_wrong("an interval ends after the contact", &|answer| answer.intervals[k].interval.to = 0.75);
        for i in 0..2 {
            is_wrong("a part is empty", &|answer| answer.intervals[k].parts[i][0] = answer.intervals[k].parts[i][1]);
            is_wrong("a part has more than the mesh", &|answer| answer.intervals[k].parts[i][1] = 3);
            is_wrong("a part begins beyond it", &|answer| answer.intervals[k].parts[i] = [2, 3]);
        }
    }
    is_wrong("a part is another triangle", &|answer| answer.intervals[0].parts[0] = [1, 2]);
    for order in [vec![], vec![0], vec![1, 1], vec![0, 2], vec![0, 1, 0]] {
        is_wrong("an order is no permutation", &|answer| answer.order[0] = order.clone());
        is_wrong("an order is no permutation", &|answer| answer.order[1] = order.clone());
    }
    for time in [[UNTIL, 0.5 - 1e-9], [UNTIL - 1e-9, 0.5], [UNTIL, 1.0], [0.5, UNTIL], [UNTIL, f64::NAN], [0.5, 0.5]] {
        is_wrong("the times are others", &|answer| {
            answer.encounter = MeshEncounter::Contact { time, triangles: [1, 1] };
        });
    }
    for triangles in [[2, 0], [0, 2]] {
        is_wrong("the triangles are not there", &|answer| {
            answer.encounter = MeshEncounter::Contact { time: [UNTIL, 0.5], triangles };
        });
    }
    is_wrong("they are said to be separate", &|answer| answer.encounter = MeshEncounter::Separate);
    is_wrong("a doubt is where an interval is", &|answer| {
        answer.encounter = MeshEncounter::Grazing { time: [UNTIL, 0.5], triangles: [0, 1] };
    });
}

#[test]
fn a_doubt_is_about_a_pair_that_no_interval_holds() {
    let mut answer = squares_that_meet(UNTIL);
    answer.encounter = MeshEncounter::Grazing { time: [UNTIL, 0.75], triangles: [1, 1] };
    assert!(of_squares(&answer).is_right());
    answer.encounter = MeshEncounter::Grazing { time: [0.5, 0.75], triangles: [1, 1] };
    assert!(of_squares(&answer).is_wrong());
}

#[test]
fn triangles_that_do_not_meet_at_the_time_are_no_contact() {
    // the second triangles of both squares are moved apart along the second axis
    let mut far = square(4.0);
    far.vertices.push(vec![4.0, 9.0, 9.0]);
    far.vertices.push(vec![4.0, 9.0, 8.0]);
    far.vertices.push(vec![4.0, 8.0, 9.0]);
    far.triangles.push(vec![4, 5, 6]);
    let motions = [&Motion::Rest, &moved([-8.0, 0.0, 0.0])];
    let told = |triangle: usize| {
        let encounter = MeshEncounter::Contact { time: [UNTIL, 0.5], triangles: [0, triangle] };
        let intervals = vec![free([[0, 2], [0, 3]], [0.0, UNTIL], X)];
        let order = [vec![0, 1], vec![2, 0, 1]];
        verdict([&square(0.0), &far], motions, &MeshContactAnswer { encounter, order, intervals })
    };
    assert!(told(0).is_right() && told(1).is_right(), "{:?}", told(0));
    assert!(told(2).is_wrong());
}

fn separate(parts: usize, direction: MovingDirection) -> MeshContactAnswer {
    let orders: Vec<usize> = (0..parts).collect();
    let intervals = vec![free([[0, parts]; 2], [0.0, 1.0], direction)];
    MeshContactAnswer { encounter: MeshEncounter::Separate, order: [orders.clone(), orders], intervals }
}

#[test]
fn meshes_that_pass_each_other_at_any_size() {
    for size in [1e-300, 1.0, 1e300] {
        let at = |x: f64| triangle([[x, 0.0, 0.0], [x, size, 0.0], [x, 0.0, size]]);
        let motions = [&moved([0.0, -4.0 * size, 0.0]), &moved([0.0, 4.0 * size, 0.0])];
        let [near, touching] = [at(size.next_up()), at(size)];
        let apart = separate(1, X);
        assert!(verdict([&at(size), &near], motions, &apart).is_right(), "{size}");
        assert!(verdict([&at(size), &touching], motions, &apart).is_wrong(), "{size}");
        assert!(verdict([&near, &at(size)], motions, &apart).is_wrong(), "{size}");
    }
}

#[test]
fn a_triangle_is_not_taken_for_what_its_corners_span_about_the_middle() {
    // the middle of the box around a triangle is outside of it; a triangle beyond one side is free of it
    let low = triangle([[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]]);
    let beyond = |off: f64| triangle([[4.0, off, -1.0], [off, 4.0, 1.0], [4.0, 4.0, 0.0]]);
    let diagonal = MovingDirection::Space([1.0, 1.0, 0.0]);
    let rest = [&Motion::Rest; 2];
    assert!(verdict([&low, &beyond(1e-9)], rest, &separate(1, diagonal)).is_right());
    assert!(verdict([&low, &beyond(0.0)], rest, &separate(1, diagonal)).is_wrong());
}

#[test]
fn directions_turn_with_either_mesh() {
    // a quarter turn about the third axis of the first mesh, with the second one beside it
    let needle = triangle([[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [3.0, 0.0, 0.0]]);
    let post = |x: f64| triangle([[x, -1.0, -9.0], [x, -1.0, 9.0], [x, -2.0, 0.0]]);
    let quarter = turned([1.0, 0.0, 0.0, 1.0], [0.0; 3]);
    let down = [0.0, -1.0, 0.0];
    for direction in [MovingDirection::Space(down), MovingDirection::B(down)] {
        let answer = separate(1, direction);
        assert!(verdict([&needle, &post(2.0)], [&quarter, &Motion::Rest], &answer).is_right(), "{direction:?}");
        assert!(verdict([&post(2.0), &needle], [&Motion::Rest, &quarter], &answer).is_wrong(), "{direction:?}");
    }
    // seen by the needle the post turns to its other side
    assert!(
        verdict([&needle, &post(2.0)], [&quarter, &Motion::Rest], &separate(1, MovingDirection::A(down))).is_right()
    );
    let both = [&quarter; 2];
    for direction in [MovingDirection::A(down), MovingDirection::B(down)] {
        assert!(verdict([&needle, &post(2.0)], both, &separate(1, direction)).is_right(), "{direction:?}");
    }
    assert!(verdict([&needle, &post(2.0)], both, &separate(1, MovingDirection::Space(down))).is_wrong());
    let edges = MovingDirection::Edges([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0]]);
    assert!(verdict([&needle, &post(2.0)], both, &separate(1, edges)).is_wrong());
    let edges = MovingDirection::Edges([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
    assert!(verdict([&needle, &post(2.0)], both, &separate(1, edges)).is_right());
}

#[test]
fn what_is_no_mesh_or_no_motion_of_pieces_has_no_answer() {
    let constant_rate =
        Motion::ConstantRate { axis_point: [0.0; 3], axis: [0.0, 0.0, 1.0], angle: 1.0, translation: [0.0; 3] };
    let answer = separate(2, X);
    assert!(verdict([&square(0.0), &square(4.0)], [&Motion::Rest; 2], &answer).is_right());
    assert!(verdict([&square(0.0), &square(4.0)], [&constant_rate, &Motion::Rest], &answer).is_wrong());
    let broken = [
        Mesh { triangles: vec![vec![0, 1, 2], vec![1, 2, 4]], ..square(4.0) },
        Mesh { triangles: vec![vec![0, 1, 2], vec![1, 2]], ..square(4.0) },
        Mesh { triangles: Vec::new(), ..square(4.0) },
        square(f64::INFINITY),
        Mesh { vertices: vec![vec![4.0, 0.0]; 4], ..square(4.0) },
    ];
    for broken in broken {
        let told = verdict([&square(0.0), &broken], [&Motion::Rest; 2], &answer);
        assert!(told.is_wrong(), "{told:?}");
    }
}

#[test]
fn proofs_tell_how_many_intervals_there_are() {
    let [near, far] = [0.0, 4.0].map(|x| triangle([[x, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]]));
    let told = |answer: &MeshContactAnswer, meshes: [&Mesh; 2]| verdict(meshes, [&Motion::Rest; 2], answer);
    let right = |text: &str| Verdict::Right(text.to_owned());
    let mut answer = separate(1, X);
    assert_eq!(
        told(&answer, [&near, &far]),
        right("separate; 1 interval with a gap between all triangles at every time")
    );
    answer.intervals = [[0.0, 0.5], [0.5, 1.0]].map(|times| free([[0, 1]; 2], times, X)).to_vec();
    assert_eq!(
        told(&answer, [&near, &far]),
        right("separate; 2 intervals with a gap between parts at every time, which hold all pairs of triangles")
    );
    answer.intervals = Vec::new();
    answer.encounter = MeshEncounter::Contact { time: [0.0, 0.0], triangles: [0, 0] };
    assert_eq!(
        told(&answer, [&near, &near]),
        right("contact; no interval, and a common point of the triangles 0 and 0 at the time 0.0")
    );
}

#[test]
fn an_interval_that_is_not_needed_is_of_some_triangles_and_in_the_time_of_the_motion() {
    let told = |parts: [[usize; 2]; 2], times: [f64; 2]| {
        let mut answer = separate(2, X);
        answer.intervals.push(free(parts, times, X));
        verdict([&square(1.0), &square(4.0)], [&Motion::Rest; 2], &answer)
    };
    assert!(told([[0, 1], [1, 2]], [0.25, 0.5]).is_right());
    let wrong = |text: &str| Verdict::Wrong(format!("certificate: an interval {text}"));
    assert_eq!(told([[0, 1], [1, 2]], [-1.0, 0.5]), wrong("goes from -1.0 to 0.5"));
    assert_eq!(told([[0, 1], [1, 2]], [0.5, 1.5]), wrong("goes from 0.5 to 1.5"));
    let mut empty = separate(2, X);
    empty.intervals.push(free([[0, 1], [1, 1]], [0.25, 0.5], X));
    // The corners of no triangles would be taken for a point at the origin.
    let behind = verdict([&square(-4.0), &square(-1.0)], [&Motion::Rest; 2], &empty);
    assert_eq!(behind, wrong("is of the triangles from 1 to below 1 of an order"));
}

#[test]
fn triangles_in_doubt_may_be_held_by_several_intervals_before() {
    let [near, far] = [0.0, 4.0].map(|x| triangle([[x, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]]));
    let told = |times: &[[f64; 2]], from: f64| {
        let intervals = times.iter().map(|&times| free([[0, 1]; 2], times, X)).collect();
        let encounter = MeshEncounter::Grazing { time: [from, 0.75], triangles: [0, 0] };
        let answer = MeshContactAnswer { encounter, order: [vec![0], vec![0]], intervals };
        verdict([&near, &far], [&Motion::Rest, &moved([-8.0, 0.0, 0.0])], &answer)
    };
    assert!(told(&[[0.0, 0.25], [0.25, 0.375]], 0.375).is_right());
    assert!(told(&[[0.0, 0.4375]], 0.375).is_wrong(), "they are held a little later");
}
