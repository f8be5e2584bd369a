//! Trackers beside fresh queries, frame by frame, on all families of bodies and motions that drift, slide, touch, jump
//! and spin; beside the twin where the bodies are small. The verifier checks the proofs of a share of the frames.

mod first_contact;
mod motions;

use dashu_ratio::RBig;
use families::bodies::BODY_FAMILIES;
use families::source::RandomSource;
use motions::{MOTIONS, Motion};
use tests::runner::cases;
use verifier::{Body, Displaced, Fraction, LocationAnswer, LocationCertificate, whole_direction};
use zonotope::Pose;
use zonotope::collision::distance::by_support_simplex::proximity;
use zonotope::collision::prepared::DirectionTree;
use zonotope::collision::tracking::{WalkingTracker, WarmTracker};
use zonotope::collision::{Location, Query, Separation, brute_force, by_lad};
use zonotope::interop::verifier::check_location;
use zonotope::numeric::dyadic::Dyadic;
use zonotope::zonotope::{PreparedBody, Zonotope};

/// The number of generators of the bodies.
const SIZES: [[usize; 2]; 8] = [[0, 3], [1, 2], [3, 4], [20, 0], [30, 25], [100, 60], [40, 300], [256, 256]];

/// Frames of a long run for each family, size and motion: 11 · 8 · 7 · 200, about 123,000.
const FRAMES: u32 = 200;

/// The twin answers for at most so many generators.
const TWIN_LIMIT: usize = 8;

/// Trees are asked in one of so many frames: some 30,000 times in a long run.
const TREE_SHARE: usize = 4;

/// One proof in so many frames is checked.
const PROOF_SHARE: usize = 8;

fn bodies(family: usize, [first, second]: [usize; 2], seed: u64) -> [Zonotope<3>; 2] {
    [(first, seed), (second, seed + 1)].map(|(count, seed)| {
        let generators = BODY_FAMILIES[family].generate(count, seed);
        Zonotope::new([0.0; 3], generators).expect("families are finite")
    })
}

/// Whether the verifier takes a location of posed bodies.
fn is_proved(query: &Query<'_, 3, Pose>, location: &Location<3>) -> bool {
    let (runs, zero) = (query.runs(), [0.0; 3]);
    let placed = query.parts().each_ref().map(|body| body.standing()).map(|pose| verifier::Pose {
        matrix: pose.matrix().iter().map(|row| row.to_vec()).collect(),
        translation: pose.translation().to_vec(),
    });
    let body = |i: usize| Body { center: &zero, generators: runs[i], pose: Some(&placed[i]) };
    let displaced = Displaced::between(&body(0), &body(1)).expect("finite bodies of space");
    let certificate = match location {
        Location::Inside(witness) | Location::Boundary(witness) => {
            LocationCertificate::Witness { coefficients: witness.coefficients.clone(), basis: witness.basis.clone() }
        }
        Location::Outside(Separation::Rounded(u)) => {
            let u: Option<Vec<Fraction>> = u.iter().map(|&c| Fraction::of_double(c)).collect();
            LocationCertificate::Separation(whole_direction(&u.expect("finite")))
        }
        Location::Outside(Separation::Exact(u)) => {
            let fraction = |c: &RBig| Fraction::new(c.numerator().clone(), c.denominator().clone());
            let u: Option<Vec<Fraction>> = u.iter().map(fraction).collect();
            LocationCertificate::Separation(whole_direction(&u.expect("denominators are positive")))
        }
    };
    let status = match location {
        Location::Inside(_) => verifier::Status::Inside,
        Location::Boundary(_) => verifier::Status::Boundary,
        Location::Outside(_) => verifier::Status::Outside,
    };
    verifier::check_location(&displaced, &LocationAnswer { status, certificate }).is_right()
}

fn are_parallel(a: &[Dyadic; 3], b: &[Dyadic; 3]) -> bool {
    (0..3).all(|k| &a[k] * &b[(k + 1) % 3] == &a[(k + 1) % 3] * &b[k])
}

fn for_each_motion(motions: impl Fn(&Motion) -> bool, check: impl Fn(&str, &[Zonotope<3>; 2], &[[Pose; 2]])) {
    for (place, family) in BODY_FAMILIES.iter().enumerate() {
        for (row, sizes) in SIZES.into_iter().enumerate() {
            for (column, motion) in MOTIONS.iter().enumerate().filter(|(_, motion)| motions(motion)) {
                let seed = (100 * place + 10 * row + column) as u64;
                let bodies = bodies(place, sizes, seed);
                let frames = (motion.frames)(&bodies, &mut RandomSource::new(seed), cases(FRAMES) as usize);
                check(&format!("{} {sizes:?} {}", family.id, motion.id), &bodies, &frames);
            }
        }
    }
}

#[test]
fn the_warm_kernel_answers_as_a_fresh_query_does() {
    let frames = std::cell::Cell::new(0);
    for_each_motion(
        |_| true,
        |name, bodies, motion| {
            let [first, second] = bodies.each_ref().map(|body| PreparedBody::new(body.clone()));
            let mut tracker = WarmTracker::new(&first, &second);
            for (i, [from, to]) in motion.iter().enumerate() {
                let tracked = tracker.frame(from, to, &mut ());
                let query = Query::of_placed(bodies[0].at(from), bodies[1].at(to));
                assert_eq!(tracked.status(), by_lad::locate(&query, &mut ()).status(), "{name} frame {i}");
                if query.len() <= TWIN_LIMIT && i % 4 == 0 {
                    assert_eq!(tracked.status(), brute_force::status(&query), "{name} frame {i}");
                }
                if i % PROOF_SHARE == 0 {
                    let location = tracked.location();
                    assert_eq!(location.status(), tracked.status(), "{name} frame {i}");
                    assert!(is_proved(&query, &location), "{name} frame {i}: {location:?}");
                }
                frames.set(frames.get() + 1);
            }
        },
    );
    println!("{} frames", frames.get());
}

#[test]
fn trees_under_poses_answer_as_a_fresh_query_does() {
    for_each_motion(
        |_| true,
        |name, bodies, motion| {
            let trees = bodies.each_ref().map(DirectionTree::new);
            for (i, [from, to]) in motion.iter().enumerate().step_by(TREE_SHARE) {
                let query = Query::of_placed(bodies[0].at(from), bodies[1].at(to));
                let located = trees[0].at(from).intersection(&trees[1].at(to), &mut ());
                assert_eq!(located.status(), by_lad::locate(&query, &mut ()).status(), "{name} frame {i}");
                if i % PROOF_SHARE == 0 {
                    let location = located.expand();
                    assert_eq!(location.status(), located.status(), "{name} frame {i}");
                    assert!(is_proved(&query, &location), "{name} frame {i}: {location:?}");
                }
            }
        },
    );
}

#[test]
fn walks_end_at_the_closest_feature() {
    let frames = std::cell::Cell::new(0);
    for_each_motion(
        |motion| motion.only_translates,
        |name, bodies, motion| {
            let generators = [bodies[0].generators(), bodies[1].generators()].concat();
            let Ok(mut tracker) = WalkingTracker::new(&bodies[0], &bodies[1]) else { return };
            for (i, [from, to]) in motion.iter().enumerate() {
                let (from, to) = (from.translation(), to.translation());
                let query = Query::new(from, to, &generators).expect("finite");
                let walked = tracker.frame(from, to).expect("finite");
                let near = proximity(&query, &mut ());
                assert_eq!(walked.status(), near.status(), "{name} frame {i}");
                assert_eq!(walked.exact_squared_distance(), near.exact_squared_distance(), "{name} frame {i}");
                if let (Some(own), Some(gap)) = (walked.exact_direction(), near.gap()) {
                    assert!(are_parallel(own, gap.exact_direction()), "{name} frame {i}");
                }
                if i % PROOF_SHARE == 0 {
                    let location = walked.location();
                    assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()), "{name} frame {i}");
                }
                frames.set(frames.get() + 1);
            }
        },
    );
    println!("{} frames", frames.get());
}
