use super::*;

/// Small integers in a fixed pseudo-random order.
struct Sequence(u64);

impl Sequence {
    fn below(&mut self, bound: u64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % bound) as f64
    }

    fn points(&mut self, count: usize) -> Vec<[f64; 2]> {
        (0..count).map(|_| [self.below(12), self.below(12)]).collect()
    }
}

/// The right triangle (0,0), (2,0), (0,2) in the square [0,2]², whose area 4 is twice the triangle's: the least
/// possible.
fn triangle() -> (Vec<[f64; 2]>, MinAreaAnswer) {
    let answer = MinAreaAnswer {
        area: 4.0,
        center: [1.0, 1.0],
        generators: vec![[1.0, 0.0], [0.0, 1.0]],
        lower_bound: 4.0,
        certificate: Certificate {
            // (0,0), (2,0), (0,2) counter-clockwise; only the edge from (2,0) to (0,2) has v_t ≠ 0 at the centre: −4.
            hull: vec![0, 1, 2],
            farthest: vec![2, 0, 1],
            coefficients: vec![0.0, -1.0, 0.0],
            basis: vec![0, 2],
        },
    };
    (vec![[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]], answer)
}

#[test]
fn the_triangle_is_proved_optimal() {
    let (points, answer) = triangle();
    let proof = check_min_area(&points, &answer).proof().expect("worked out by hand");
    assert_eq!(proof, MinAreaProof { area: 4.0, proven_bound: 4.0, gap: 0.0, points: 3 });
}

#[test]
fn every_false_statement_is_caught() {
    let caught = |change: fn(&mut MinAreaAnswer), expected: &str| {
        let (points, mut answer) = triangle();
        change(&mut answer);
        let complaint = check_min_area(&points, &answer).proof().expect_err(expected);
        assert!(complaint.contains(expected), "{complaint}");
    };
    caught(|answer| answer.center[0] += 2.0_f64.powi(-52), "point 1 lies outside");
    caught(|answer| answer.generators[1][1] = 1.0 - f64::EPSILON, "point 1 lies outside");
    caught(|answer| answer.area = 4.0 + 1e-11, "area is 4.00000000001");
    caught(|answer| answer.area = f64::INFINITY, "area is inf");
    caught(|answer| answer.area = f64::NAN, "area is NaN");
    caught(|answer| answer.lower_bound = 4.0 + 1e-15, "all that the certificate proves");
    caught(|answer| answer.lower_bound = 4.0 - 1e-11, "says less than");
    caught(|answer| answer.lower_bound = f64::NAN, "lower_bound is NaN");
    caught(|answer| answer.certificate.hull = vec![0, 2, 1], "not a convex polygon");
    caught(|answer| answer.certificate.hull = vec![0, 1, 3], "does not exist");
    caught(|answer| answer.certificate.hull = vec![0, 1], "outside the hull");
    caught(|answer| answer.certificate.farthest[1] = 2, "not the farthest");
    caught(|answer| answer.certificate.farthest = vec![2, 0], "2 entries for 3 edges");
    caught(|answer| answer.certificate.coefficients[1] = 1.0, "all that the certificate proves");
    caught(|answer| answer.certificate.coefficients[1] = -1.5, "outside [-1, 1]");
    caught(|answer| answer.certificate.coefficients[2] = 0.5, "is solved for");
    caught(|answer| answer.certificate.coefficients[0] = f64::NAN, "outside [-1, 1]");
    caught(|answer| answer.center[0] = f64::NAN, "not finite");
    caught(|answer| answer.generators[0][1] = f64::INFINITY, "not finite");
    caught(|answer| answer.certificate.basis = vec![0], "do not close");
    caught(|answer| answer.certificate.basis = vec![], "do not close");
    caught(|answer| answer.certificate.basis = vec![0, 0], "parallel");
    caught(|answer| answer.certificate.basis = vec![0, 2, 0], "at most two");
    caught(|answer| answer.certificate.basis = vec![0, 7], "does not exist");
    // the three vertices and edges are counted from 0
    caught(|answer| answer.certificate.farthest[1] = 3, "farthest names vertex 3, which does not exist");
    caught(|answer| answer.certificate.basis = vec![0, 3], "basis names edge 3, which does not exist");
}

#[test]
fn a_larger_zonogon_is_not_optimal() {
    let (points, mut answer) = triangle();
    answer.generators[0] = [2.0, 0.0];
    answer.area = 8.0;
    assert!(check_min_area(&points, &answer).is_wrong());
}

#[test]
fn points_on_a_line_need_no_certificate() {
    let points = [[0.0, 0.0], [2.0, 6.0], [1.0, 3.0]];
    let answer = MinAreaAnswer {
        area: 0.0,
        center: [1.0, 3.0],
        generators: vec![[1.0, 3.0]],
        lower_bound: 0.0,
        certificate: Certificate { hull: vec![0, 1], farthest: vec![], coefficients: vec![], basis: vec![] },
    };
    let proof = check_min_area(&points, &answer).proof().expect("the segment itself");
    assert_eq!(proof, MinAreaProof { area: 0.0, proven_bound: 0.0, gap: 0.0, points: 3 });
    let Certificate { hull, .. } = answer.certificate.clone();
    let none = Certificate { hull, farthest: vec![], coefficients: vec![], basis: vec![] };
    let superfluous = [
        Certificate { farthest: vec![0], ..none.clone() },
        Certificate { coefficients: vec![0.0], ..none.clone() },
        Certificate { basis: vec![0], ..none },
    ];
    for certificate in superfluous {
        let complaint = check_min_area(&points, &MinAreaAnswer { certificate, ..answer.clone() }).proof();
        assert!(complaint.is_err_and(|complaint| complaint.contains("points on a line have no edges")));
    }
}

/// The square [0, 2]² around its corners: either end of the side that is opposite to an edge is farthest from it.
#[test]
fn both_ends_of_a_parallel_side_are_farthest() {
    let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    for choice in 0..256_usize {
        let farthest: Vec<usize> = (0..4).map(|edge| choice >> (2 * edge) & 3).collect();
        let is_right = farthest.iter().enumerate().all(|(edge, &s)| s == (edge + 2) % 4 || s == (edge + 3) % 4);
        let answer = MinAreaAnswer {
            area: 4.0,
            center: [1.0, 1.0],
            generators: vec![[1.0, 0.0], [0.0, 1.0]],
            lower_bound: 4.0,
            certificate: Certificate { hull: vec![0, 1, 2, 3], farthest, coefficients: vec![0.5; 4], basis: vec![] },
        };
        assert_eq!(check_min_area(&points, &answer).is_right(), is_right, "{answer:?}");
    }
}

/// Coefficients that close the edges prove the same bound whatever the centre from which it is computed: multiples of
/// 1/8, all of them equal where at most one is solved for.
#[test]
fn the_bound_does_not_depend_on_the_centre() {
    let mut sequence = Sequence(5);
    let mut proved = [0; 3];
    for round in 0..600 {
        let count = 3 + sequence.below(5) as usize;
        let points: Vec<Point> =
            sequence.points(count).into_iter().map(|point| point.map(|c| IBig::from(c as i64))).collect();
        let vertices = ConvexPolygon::hull(points).vertices().to_vec();
        let count = vertices.len();
        if count < 3 {
            continue;
        }
        let farthest = (0..count).map(|t| {
            let edge = vector(&vertices[t], &vertices[(t + 1) % count]);
            (0..count).max_by_key(|&s| cross(&edge, &vertices[s])).expect("not empty")
        });
        let basis: Vec<usize> = (0..round % 3).map(|step| (round + step) % count).collect();
        let all = sequence.below(17) / 8.0 - 1.0;
        let coefficients = (0..count).map(|t| match basis.len() {
            _ if basis.contains(&t) => 0.0,
            2 => sequence.below(17) / 8.0 - 1.0,
            _ => all,
        });
        let certificate = Certificate {
            hull: (0..count).collect(),
            farthest: farthest.collect(),
            coefficients: coefficients.collect(),
            basis: basis.clone(),
        };
        let mut bound = || {
            let center = [IBig::from(sequence.below(30) as i64 - 9), IBig::from(sequence.below(30) as i64 - 9)];
            proven_bound(&vertices, &center, &certificate)
        };
        match (bound(), bound()) {
            (Ok(first), Ok(second)) => {
                assert_eq!(first.compare(&second), Ordering::Equal, "{vertices:?} {certificate:?}");
                proved[basis.len()] += 1;
            }
            // two coefficients that are solved for may leave [−1, 1], and their edges may be parallel
            (first, second) => assert!(basis.len() == 2 && first.is_err() && second.is_err(), "{certificate:?}"),
        }
    }
    assert!(proved.iter().all(|&count| count > 50), "{proved:?}");
}

/// The identity f(O) = constant + 1/2 Σ |v_t(O)|, from which the proof of the bound follows, on pairs of random
/// centres.
#[test]
fn the_area_differs_from_half_the_sum_of_offsets_by_a_constant() {
    let mut sequence = Sequence(11);
    for _ in 0..400 {
        let count = 3 + sequence.below(8) as usize;
        let points: Vec<Point> =
            sequence.points(count).into_iter().map(|point| point.map(|c| IBig::from(c as i64))).collect();
        let hull = ConvexPolygon::hull(points);
        let vertices = hull.vertices();
        let count = vertices.len();
        if count < 3 {
            continue;
        }
        let mut constants = (0..2).map(|_| {
            let center = [IBig::from(sequence.below(30) as i64 - 9), IBig::from(sequence.below(30) as i64 - 9)];
            let reflected = vertices.iter().map(|[x, y]| [&center[0] * 2 - x, &center[1] * 2 - y]);
            let symmetric = ConvexPolygon::hull(vertices.iter().cloned().chain(reflected).collect());
            let offsets: IBig = (0..count)
                .map(|t| {
                    let edge = vector(&vertices[t], &vertices[(t + 1) % count]);
                    let farthest = vertices.iter().max_by_key(|vertex| cross(&edge, vertex)).expect("not empty");
                    let doubled = [&center[0] * 2, &center[1] * 2];
                    cross(&edge, &vector(farthest, &vector(&vertices[t], &doubled))).abs()
                })
                .sum();
            symmetric.doubled_area() - offsets
        });
        assert_eq!(constants.next(), constants.next());
    }
}

#[test]
fn exact_optima() {
    let (points, MinAreaAnswer { certificate, .. }) = triangle();
    let number = |numerator: i32, denominator: i32| Fraction::new(numerator, denominator).expect("not over zero");
    let square = ExactMinArea {
        area: number(4, 1),
        center: [number(2, 2), number(1, 1)],
        generators: vec![[number(3, 3), number(0, 1)], [number(0, 7), number(1, 1)]],
    };
    let check = |change: &dyn Fn(&mut ExactMinArea)| {
        let mut exact = square.clone();
        change(&mut exact);
        check_exact_min_area(&points, &certificate, &exact).proof().map(|_| ())
    };
    assert_eq!(check(&|_| ()), Ok(()));
    let complaint = |text: &str| Err(format!("exact: {text}"));
    assert_eq!(check(&|exact| exact.center[0] = number(7, 6)), complaint("point 1 lies outside the zonogon"));
    assert_eq!(check(&|exact| exact.area = number(13, 3)), complaint("`area` is not that of the zonogon"));
    let larger = |exact: &mut ExactMinArea| {
        exact.generators[0][0] = number(4, 3);
        exact.area = number(16, 3);
    };
    assert_eq!(check(&larger), complaint("the certificate does not prove that the area is the least"));
}

/// The triangle at an eighth of its size: its coordinates are no whole numbers, and the area is 1/16.
#[test]
fn exact_optima_of_fractional_points() {
    let (points, MinAreaAnswer { certificate, .. }) = triangle();
    let points: Vec<[f64; 2]> = points.into_iter().map(|point| point.map(|c| c / 8.0)).collect();
    let number = |numerator: i32, denominator: i32| Fraction::new(numerator, denominator).expect("not over zero");
    let square = |side: i32| ExactMinArea {
        area: number(1, 16),
        center: [number(1, 8), number(1, 8)],
        generators: vec![[number(1, 8), number(0, 1)], [number(0, 1), number(side, 8)]],
    };
    assert!(check_exact_min_area(&points, &certificate, &square(1)).is_right());
    assert!(check_exact_min_area(&points, &certificate, &square(2)).is_wrong());
}

/// Two points of a horizontal line: a segment holds them, and nothing that is thicker by however little is the least.
#[test]
fn nothing_is_rounded_along_an_axis_on_which_points_agree() {
    let points = [[-6e10, 0.5], [-7e9, 0.5]];
    let segment = MinAreaAnswer {
        area: 0.0,
        center: [-3.35e10, 0.5],
        generators: vec![[2.65e10, 0.0]],
        lower_bound: 0.0,
        certificate: Certificate { hull: vec![0, 1], farthest: vec![], coefficients: vec![], basis: vec![] },
    };
    assert!(check_min_area(&points, &segment).is_right());
    let tiny = f64::from_bits(1);
    let thick = MinAreaAnswer { area: 4.0 * 2.65e10 * tiny, generators: vec![[2.65e10, 0.0], [0.0, tiny]], ..segment };
    let complaint = check_min_area(&points, &thick).proof().expect_err("it is thicker");
    assert!(complaint.contains("by more than rounding"), "{complaint}");
}
