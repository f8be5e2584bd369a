//! First contacts of meshes: their proofs against exact gaps and a count of all pairs, contacts against samples.

use super::super::brute_force::{Placement, gap_of_corners};
use super::super::tests::random_parts;
use super::{FreePair, MeshContact, NotRational, Part, first_contact, first_contact_counted};
use crate::bvh::{Aabb, BoundingVolume, Bvh, Dop18, Mesh, OrientedBox, Sphere, Zonotope6};
use crate::motion::{Motion, MotionPiece};
use crate::numeric::Rational;
use crate::numeric::exact_linear::rational;
use crate::property_cases;
use crate::tally::{Operation, OperationCounts};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// A surface of triangles about the origin, of a few rows and columns.
fn surface(rows: u32, columns: u32, radius: f64) -> Mesh {
    let point = |i: u32, j: u32| {
        let (a, b) = (f64::from(i) * 6.25 / f64::from(rows), f64::from(j) * 6.25 / f64::from(columns));
        let reach = radius + 0.4 * libm::cos(a);
        [reach * libm::cos(b), reach * libm::sin(b), 0.4 * libm::sin(a)]
    };
    let vertices = (0..rows).flat_map(|i| (0..columns).map(move |j| point(i, j))).collect();
    let at = |i: u32, j: u32| (i % rows) * columns + j % columns;
    let squares =
        (0..rows).flat_map(|i| (0..columns).map(move |j| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]));
    Mesh::new(vertices, squares.flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect()).expect("a surface")
}

fn triangles_of<V: BoundingVolume>(hierarchy: &Bvh<V>, part: Part) -> Vec<usize> {
    match part {
        Part::Triangle(triangle) => vec![triangle],
        Part::Node(node) => {
            let below = &hierarchy.topology().order()[hierarchy.topology().nodes()[node].range()];
            below.iter().map(|&triangle| triangle as usize).collect()
        }
    }
}

/// Holds the proof of each pair to exact gaps at some times of its stretch.
fn check_pair<V: BoundingVolume>(hierarchies: [&Bvh<V>; 2], parts: [&[MotionPiece]; 2], pair: &FreePair) {
    let stretch = &pair.stretch;
    let corners = [0, 1].map(|i| {
        let triangles = triangles_of(hierarchies[i], pair.parts[i]).into_iter();
        triangles.flat_map(|triangle| hierarchies[i].mesh().corners(triangle)).collect::<Vec<_>>()
    });
    let middle = stretch.from + (stretch.until - stretch.from) / 2.0;
    let part = |parts: &[MotionPiece]| parts.iter().position(|part| middle < part.until).expect("a part");
    for thirds in 0..4u8 {
        let share = Rational::from(thirds) / Rational::from(3u8);
        let time = rational(stretch.from) + share * (rational(stretch.until) - rational(stretch.from));
        let placements = parts.map(|parts| Placement::at(parts, part(parts), &time));
        let gap = gap_of_corners([&corners[0], &corners[1]], placements.each_ref(), &stretch.direction);
        assert!(gap.expect("there are corners") > Rational::ZERO, "{pair:?}");
    }
}

/// Counts that every pair of triangles is free until a time.
fn check_cover<V: BoundingVolume>(hierarchies: [&Bvh<V>; 2], free: &[FreePair], end: f64) {
    let [rows, columns] = hierarchies.map(|hierarchy| hierarchy.mesh().triangles().len());
    let mut stretches: Vec<Vec<[f64; 2]>> = vec![Vec::new(); rows * columns];
    for pair in free {
        let [first, second] = [0, 1].map(|i| triangles_of(hierarchies[i], pair.parts[i]));
        for i in first {
            for &j in &second {
                stretches[i * columns + j].push([pair.stretch.from, pair.stretch.until]);
            }
        }
    }
    for mut of_pair in stretches {
        of_pair.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let reached = of_pair
            .iter()
            .fold(0.0, |reached: f64, [from, until]| if *from <= reached { reached.max(*until) } else { reached });
        assert!(reached >= end, "{reached} of {end}");
    }
}

fn check<V: BoundingVolume>(meshes: [&Mesh; 2], parts: [&[MotionPiece]; 2]) -> MeshContact {
    let hierarchies = meshes.map(Bvh::<V>::build);
    let hierarchies = hierarchies.each_ref();
    let motions = parts.map(|parts| Motion::from_pieces(parts).expect("the parts are a motion"));
    let found = first_contact(hierarchies, motions.each_ref()).expect("the motions are rational");
    found.free().iter().for_each(|pair| check_pair(hierarchies, parts, pair));
    let distance = |time: f64| {
        let [p, q] = motions.each_ref().map(|motion| motion.pose_at(time).expect("finite"));
        hierarchies[0].at(&p).distance(hierarchies[1].at(&q))
    };
    let end = match &found {
        MeshContact::Separate { .. } => 1.0,
        MeshContact::Contact { time, .. } => {
            assert!(time[1] - time[0] <= 2f64.powi(-30));
            assert!(distance(time[1]).lower < 1e-12, "{}", V::NAME);
            time[0]
        }
        MeshContact::Grazing { time, .. } => time[0],
    };
    check_cover(hierarchies, found.free(), end);
    for sample in 0..32 {
        let time = end * f64::from(sample) / 32.0;
        assert!(time >= end || distance(time).upper > 0.0, "{}: {time}", V::NAME);
    }
    found
}

#[test]
fn random_motions_are_proved_pair_by_pair() {
    let mut rng = Pcg64::seed_from_u64(5);
    let meshes = [surface(4, 6, 1.0), surface(3, 5, 0.8)];
    let mut cases = [0; 2];
    for count in 0..24 {
        let mut parts = [0, 1].map(|_| random_parts(&mut rng, 1 + count % 2));
        let away = [0, 1, 2].map(|_| rng.random_range(-4.0..4.0));
        // the second mesh begins elsewhere: a part that is over at once is none, so its axis is moved
        parts[1].iter_mut().for_each(|part| part.axis_point = away);
        let [a, b] = [&parts[0][..], &parts[1][..]];
        let found = check::<OrientedBox>(meshes.each_ref(), [a, b]);
        let other = check::<Zonotope6>(meshes.each_ref(), [a, b]);
        assert_eq!(found.name(), other.name());
        cases[usize::from(matches!(found, MeshContact::Contact { .. }))] += 1;
    }
    assert!(cases.iter().all(|count| *count > 0), "{cases:?}");
}

/// Neighbouring triangles share the edge or the corner that meets first: none of them may hide that the others meet.
#[test]
fn a_doubt_about_one_pair_does_not_hide_the_contact_of_another() {
    let meshes = [surface(8, 12, 1.0), surface(7, 10, 0.8)];
    let hierarchies = meshes.each_ref().map(Bvh::<OrientedBox>::build);
    let mut rng = Pcg64::seed_from_u64(7);
    let mut cases = [0; 3];
    for _ in 0..property_cases::config(60).cases {
        let mut parts = [0, 1].map(|_| random_parts(&mut rng, 1));
        let away = [0, 1, 2].map(|_| rng.random_range(-4.0..4.0));
        parts[1].iter_mut().for_each(|part| part.axis_point = away);
        let motions = parts.map(|parts| Motion::from_pieces(&parts).expect("the parts are a motion"));
        let found = first_contact(hierarchies.each_ref(), motions.each_ref()).expect("the motions are rational");
        cases[["separate", "contact", "grazing"].iter().position(|name| *name == found.name()).expect("a case")] += 1;
    }
    assert!(cases[1] > 0 && cases[2] == 0, "{cases:?}");
}

fn piece(to: [f64; 4], axis_point: [f64; 3], translation: [f64; 3]) -> MotionPiece {
    MotionPiece { until: 1.0, from: [1.0, 0.0, 0.0, 0.0], to, axis_point, translation }
}

const STILL: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

fn rest() -> MotionPiece {
    piece(STILL, [0.0; 3], [0.0; 3])
}

fn triangle(corners: [[f64; 3]; 3]) -> Mesh {
    Mesh::new(corners.to_vec(), vec![[0, 1, 2]]).expect("a triangle")
}

#[test]
fn a_triangle_meets_another_half_way_and_passes_beside_it() {
    let at = |x: f64, z: f64| triangle([[x, 0.0, z], [x, 1.0, z], [x, 0.0, z + 1.0]]);
    let (from, to) = (at(0.0, 0.0), at(4.0, 0.25));
    let right = piece(STILL, [0.0; 3], [8.0, 0.0, 0.0]);
    let found = check::<Aabb>([&from, &to], [&[right], &[rest()]]);
    let MeshContact::Contact { time, triangles, .. } = found else { panic!("{found:?}") };
    assert!(time[0] < 0.5 && time[1] >= 0.5 && triangles == [0, 0], "{time:?}");
    for above in [1.0 + 1e-9, 7.0] {
        let found = check::<Sphere>([&from, &at(4.0, above)], [&[right], &[rest()]]);
        assert_eq!(found.name(), "separate");
    }
    // the same corner at one moment
    let found = check::<Dop18>([&from, &at(4.0, 1.0)], [&[right], &[rest()]]);
    let MeshContact::Contact { time, .. } = found else { panic!("{found:?}") };
    assert!(time[0] <= 0.5 && time[1] >= 0.5, "{time:?}");
}

/// A needle that makes a quarter turn about z, with a post of some width in its way.
fn needle_at_a_post(width: f64) -> MeshContact {
    let needle = triangle([[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 0.0, 1e-9]]);
    let post = triangle([[2.0, 2.0, -1.0], [2.0, 2.0, 1.0], [2.0 + width, 2.0, 1.0]]);
    check::<Zonotope6>([&needle, &post], [&[piece([1.0, 0.0, 0.0, 1.0], [0.0; 3], [0.0; 3])], &[rest()]])
}

/// The time at which the turn is by an angle: 1 + t k is by twice the angle of tangent t.
fn time_of_angle(angle: f64) -> f64 {
    libm::tan(0.5 * angle)
}

#[test]
fn a_needle_that_turns_hits_what_it_jumps_over() {
    let MeshContact::Contact { time, .. } = needle_at_a_post(0.25) else { panic!("they meet for a while") };
    // at the height of the needle the post is half as wide
    let expected = time_of_angle(libm::atan2(2.0, 2.125));
    assert!(time[0] - 1e-9 < expected && expected < time[1] + 1e-9, "{time:?}");
}

#[test]
fn triangles_that_meet_at_no_double_are_said_to_be_in_doubt_there() {
    // both triangles are upright: they meet when the needle points at the post, at the root of 2 less 1, and never else
    let MeshContact::Grazing { time, .. } = needle_at_a_post(0.0) else { panic!("no double is the time") };
    let expected = time_of_angle(std::f64::consts::FRAC_PI_4);
    assert!(time[0] < expected && expected < time[1], "{time:?}");
}

#[test]
fn meshes_that_meet_at_the_start_meet_then() {
    let mesh = surface(3, 5, 0.8);
    let moving = piece([2.0, 0.0, 1.0, 1.0], [0.0; 3], [9.0, 0.0, 0.0]);
    let found = check::<OrientedBox>([&mesh, &mesh], [&[moving], &[rest()]]);
    assert!(matches!(found, MeshContact::Contact { time: [0.0, 0.0], .. }), "{found:?}");
}

#[test]
fn the_answer_is_the_same_at_every_size() {
    for size in [1e-310, 1e-300, 1e-30, 1.0, 1e30, 1e300] {
        // a tilted triangle, of which the corner on the axis is met first
        let tilted = |x: f64, tilt: f64| triangle([[x, 0.0, 0.0], [x + tilt, size, 0.0], [x + tilt, 0.0, size]]);
        let meshes = [tilted(0.0, 0.0), tilted(4.0 * size, size)];
        let hierarchies = meshes.each_ref().map(Bvh::<Zonotope6>::build);
        let turned = |x: f64| {
            let end = piece([3.0, 1.0, 0.0, 0.0], [0.0; 3], [x, 0.0, 0.0]);
            Motion::from_pieces(&[end]).expect("the parts are a motion")
        };
        let near = first_contact(hierarchies.each_ref(), [&turned(3.0 * size), &Motion::rest()]).expect("rational");
        assert_eq!(near.name(), "separate", "{size}");
        let over = first_contact(hierarchies.each_ref(), [&turned(5.0 * size), &Motion::rest()]).expect("rational");
        let MeshContact::Contact { time, .. } = over else { panic!("{size}: {over:?}") };
        assert!(time[0] < 0.8 + 1e-9 && time[1] > 0.8 - 1e-9, "{size}: {time:?}");
    }
}

fn mesh(vertices: &[[f64; 3]], triangles: &[[u32; 3]]) -> Mesh {
    Mesh::new(vertices.to_vec(), triangles.to_vec()).expect("a mesh")
}

fn turned(from: [f64; 4], to: [f64; 4], axis_point: [f64; 3], translation: [f64; 3]) -> MotionPiece {
    MotionPiece { from, ..piece(to, axis_point, translation) }
}

/// Holds meshes that stay apart to a proof from at most so many pairs with stretches.
fn check_work(meshes: [Mesh; 2], parts: [&[MotionPiece]; 2], limit: u64) {
    let hierarchies = meshes.each_ref().map(Bvh::<OrientedBox>::build);
    let hierarchies = hierarchies.each_ref();
    let motions = parts.map(|parts| Motion::from_pieces(parts).expect("the parts are a motion"));
    let mut counts = OperationCounts::default();
    let found = first_contact_counted(hierarchies, motions.each_ref(), 2f64.powi(-30), &mut counts);
    let found = found.expect("the motions are rational");
    assert!(matches!(found, MeshContact::Separate { .. }), "{found:?}");
    found.free().iter().for_each(|pair| check_pair(hierarchies, parts, pair));
    check_cover(hierarchies, found.free(), 1.0);
    let looked_at = counts.get(Operation::NodeTest) + counts.get(Operation::TriangleTest);
    assert!(looked_at < limit, "{looked_at}");
}

/// Placements outside of the range of doubles do not tell how far a node goes: a fuzzer found that the whole time was
/// halved to a millionth then.
#[test]
fn numbers_of_very_different_sizes_take_few_stretches() {
    check_work(
        [
            mesh(&[[1.0, 4.6e28, 3.0], [-7.4e-80, -3.0, -3.0]], &[[1, 1, 1], [1, 1, 0]]),
            mesh(&[[2.8e76, -7e71, -2.0], [4.7e57, -3.0, 3.7e307]], &[[1, 1, 1], [0, 0, 1], [1, 0, 0]]),
        ],
        [&[turned([3.0, 2.0, -1.0, -1.0], [3.0, -1.0, 1.0, -2.0], [-1.0, 2.0, 0.0], [1.0, 0.0, 1.0])], &[rest()]],
        100,
    );
    check_work(
        [
            mesh(
                &[[-3.0, 0.0, 0.0], [3.0, -3.0, 2.6e-51], [-1.0, -3.0, 0.0], [7e-242, -7.3e130, -3.5e-93]],
                &[[1, 0, 0], [3, 2, 1], [2, 3, 1]],
            ),
            mesh(&[[-3.1e-70, -1.5e227, 2.0], [1.0, -8.4e-276, 3.3e196]], &[[1, 1, 0]]),
        ],
        [&[turned([2.0, 1.0, 1.0, 2.0], [3.0, 1.0, -2.0, 0.0], [0.0, 1.0, 1.0], [-1.0, 5.0, 0.0])], &[rest()]],
        100,
    );
}

/// Volumes of points, and volumes in units of a vertex that is far away, are never near beside their own sizes: a
/// fuzzer found that the whole time was halved to a millionth for each pair of triangles then.
#[test]
fn points_beside_vertices_far_away_take_few_stretches() {
    check_work(
        [mesh(&[[3.0, 1.0, 2.0]], &[[0; 3]; 4]), mesh(&[[-5.6e-228, 5.5e-176, 0.0], [8e-16, -3.0, 8.7e70]], &[[0; 3]])],
        [&[turned([3.0, 1.0, 2.0, -1.0], [2.0, -1.0, 0.0, 0.0], [0.0, 2.0, -1.0], [-1.0, 3.0, 4.0])], &[rest()]],
        1000,
    );
    check_work(
        [
            mesh(&[[2.6e-168, -2.1e-168, 6.6e219]], &[[0; 3]; 4]),
            mesh(&[[0.0, 0.5, 0.0], [0.0, 0.2, 0.0]], &[[1, 1, 0]]),
        ],
        [
            &[
                MotionPiece {
                    until: 0.5,
                    ..turned([2.0, 2.0, 0.0, 2.0], [3.0, -1.0, 1.0, -2.0], [1.0, -2.0, -2.0], [3.0, 1.0, 5.0])
                },
                turned([3.0, 1.0, -1.0, -2.0], [3.0, 1.0, 1.0, 1.0], [2.0, 0.0, 0.0], [1.0, -1.0, -1.0]),
            ],
            &[piece([3.0, -2.0, -1.0, 1.0], [1.0, 0.0, -2.0], [-5.0, 6.0, -5.0])],
        ],
        1000,
    );
    check_work(
        [
            mesh(&[[0.0; 3], [9.7e153, 1.0, 0.0]], &[[0; 3]]),
            mesh(&[[2.0, -6.0, 0.0], [-1.0, 3.0, 0.0]], &[[1, 1, 1], [0, 0, 1], [1, 0, 1], [0, 1, 1]]),
        ],
        [
            &[turned([2.0, 0.0, -1.0, 2.0], [2.0, 0.0, -2.0, -2.0], [-2.0, 2.0, 0.0], [-4.0, -4.0, 4.0])],
            &[turned([3.0, 2.0, 1.0, -2.0], [3.0, -2.0, 0.0, 2.0], [1.0, -1.0, -1.0], [6.0, -2.0, -5.0])],
        ],
        1000,
    );
    check_work(
        [
            mesh(&[[0.75, 1.4e275, 4.5e-44], [6.7e-44, -7.7e-44, 0.25]], &[[1, 0, 1], [1, 1, 1], [1, 0, 0], [0, 1, 1]]),
            mesh(&[[-3.6e-44, -1e275, -0.25], [-0.5, -9e-44, 3.6e-45]], &[[1; 3]]),
        ],
        [
            &[turned([1.0, -1.0, 0.0, 1.0], [1.0, -2.0, -2.0, 2.0], [-2.0, -2.0, 0.0], [-2.0, 5.0, 1.0])],
            &[turned([1.0, 1.0, -1.0, -1.0], [-1.0, 0.0, -1.0, -1.0], [0.0, 0.0, -1.0], [6.0, 6.0, 2.0])],
        ],
        1000,
    );
}

#[test]
fn rotations_at_constant_rate_are_refused() {
    let mesh = surface(3, 5, 0.8);
    let hierarchy = Bvh::<Aabb>::build(&mesh);
    let turn = Motion::constant_rate([0.0; 3], [0.0, 0.0, 1.0], 1.0, [0.0; 3]).expect("an axis");
    assert_eq!(first_contact([&hierarchy; 2], [&Motion::rest(), &turn]), Err(NotRational { body: 1 }));
}
