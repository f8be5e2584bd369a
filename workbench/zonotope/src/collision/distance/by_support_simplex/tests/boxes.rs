//! Box poses that were reported because collision libraries failed on them: sizes and poses as they were reported.

use super::*;
use crate::numeric::exact_linear::{dot, exact};

/// Full sides and a pose of a box: the rows of its matrix, each with a coordinate of its centre.
struct PosedBox {
    sides: [f64; 3],
    rows: [[f64; 4]; 3],
}

impl PosedBox {
    fn body(&self) -> Zonotope<3> {
        let axis = |k: usize| std::array::from_fn(|i| if i == k { self.sides[k] / 2.0 } else { 0.0 });
        Zonotope::new([0.0; 3], (0..3).map(axis).collect()).expect("finite")
    }

    fn pose(&self) -> Pose {
        Pose::new(self.rows.map(|[a, b, c, _]| [a, b, c]), self.rows.map(|[.., t]| t)).expect("finite")
    }

    const fn upright(sides: [f64; 3], [x, y, z]: [f64; 3]) -> Self {
        Self { sides, rows: [[1.0, 0.0, 0.0, x], [0.0, 1.0, 0.0, y], [0.0, 0.0, 1.0, z]] }
    }
}

/// Where a pair was reported, and the two boxes.
type Reported = (&'static str, PosedBox, PosedBox);

fn reported() -> Vec<Reported> {
    let fcl_493 = [
        [0.9619397662556435, 0.1540127991573736, 0.2257253725032892],
        [-0.19134171618254486, 0.9693649495128391, 0.1540127991573736],
        [-0.19509032201612822, -0.19134171618254486, 0.9619397662556435],
    ];
    let fcl_495 = [
        [0.9409606321741776, 0.292968400372895, 0.16959541586174812],
        [-0.2356983684129988, 0.9266152359584843, -0.29296840037289507],
        [-0.2429801799032639, 0.23569836841299885, 0.9409606321741776],
    ];
    let at = |matrix: [[f64; 3]; 3], t: [f64; 3]| [0, 1, 2].map(|k| [matrix[k][0], matrix[k][1], matrix[k][2], t[k]]);
    vec![
        (
            "FCL 388",
            PosedBox {
                sides: [0.03, 0.12, 0.1],
                rows: [
                    [-3.062793785257868e-08, -0.9999999999999989, -2.8893865161583314e-08, 0.6349997962735081],
                    [0.999999999999998, -3.0627939739957804e-08, 6.472992691852751e-08, -0.4850000221563644],
                    [-6.472992772296385e-08, -2.889386302944875e-08, 0.9999999999999971, 1.0778146458339641],
                ],
            },
            PosedBox {
                sides: [0.025, 0.35, 1.845],
                rows: [[0.0, -1.0, 0.0, 0.8], [1.0, 0.0, 0.0, -0.4575], [0.0, 0.0, 1.0, 1.0225]],
            },
        ),
        (
            "FCL 398",
            PosedBox::upright([0.614, 3.0, 0.037], [-0.675, 0.0, 0.9115]),
            PosedBox::upright([0.494, 0.552, 0.01], [-0.692, 0.0, 0.935]),
        ),
        (
            "FCL 398 in its regression test",
            PosedBox::upright([0.614, 3.0, 0.37], [-0.675, 0.0, 0.9115]),
            PosedBox::upright([0.494, 0.552, 0.01], [-0.692, 0.0, 0.935]),
        ),
        (
            "FCL 399",
            PosedBox {
                sides: [0.2376803755760193, 0.15702305734157562, 0.25],
                rows: [
                    [-0.09943238735307627, 0.9950443207944397, 0.0, 0.29526406526506555],
                    [-0.9950443207944397, -0.09943238735307627, 0.0, -0.013230856508016586],
                    [0.0, 0.0, 1.0, 0.0],
                ],
            },
            PosedBox {
                sides: [0.01, 0.7816570997238159, 0.25],
                rows: [
                    [0.9950659844209923, 0.09921535490175673, 0.0, 0.22759585694545215],
                    [-0.09921535490175673, 0.9950659844209923, 0.0, 0.14974093549228112],
                    [0.0, 0.0, 1.0, 0.0],
                ],
            },
        ),
        (
            "FCL 415",
            PosedBox::upright([0.02, 0.33, 0.02], [0.05399999999999994, -0.772, 0.405]),
            PosedBox::upright([0.452, 0.27, 0.42], [0.121, -0.6296050575043268, 0.3]),
        ),
        (
            "FCL 428",
            PosedBox::upright([0.2, 0.33, 0.1], [-0.07100000000000004, -0.772, 0.8]),
            PosedBox::upright([0.452, 0.27, 0.6], [0.121, -0.787696056927277, 0.5342204419612515]),
        ),
        (
            "FCL, its sixth regression of two boxes, in the series between 428 and 493",
            PosedBox {
                sides: [0.3165, 0.2276, 0.1768],
                rows: [
                    [0.44540578475530235, 0.895328814964934, -8.893740768563868e-09, 1.2652949075960072],
                    [-0.8953288149649338, 0.4454057847553019, -2.8948680226084145e-08, 1.4551012423210101],
                    [-2.1957263975186326e-08, 2.085673201665292e-08, 0.9999999999999996, 0.4948000623293294],
                ],
            },
            PosedBox {
                sides: [0.4943, 0.3546, 0.0752],
                rows: [
                    [0.4417112291348586, 0.8971572827861191, -1.6227645148654682e-09, 1.1304016226141906],
                    [-0.8971572827861191, 0.4417112291348586, -5.162105395230608e-09, 1.841080264528428],
                    [-3.914427141382999e-09, 3.736034921809435e-09, 1.0, 0.44400006232932493],
                ],
            },
        ),
        (
            "FCL 493",
            PosedBox {
                sides: [0.5; 3],
                rows: at(fcl_493, [2.077006399586799, 0.4846824747564195, 1.1543291419087276]),
            },
            PosedBox { sides: [0.5; 3], rows: at(fcl_493, [2.0, 0.0, 1.25]) },
        ),
        (
            "FCL 495",
            PosedBox {
                sides: [0.25; 3],
                rows: at(fcl_495, [0.07324210009322382, 0.23165380898962123, 1.3089245921032497]),
            },
            PosedBox { sides: [0.25; 3], rows: at(fcl_495, [0.0, 0.0, 1.25]) },
        ),
        ("FCL 508", PosedBox::upright([1.0; 3], [0.0, 4.0, 0.0]), PosedBox::upright([1.0; 3], [0.0; 3])),
        (
            "Drake 21673",
            PosedBox {
                sides: [0.05, 0.55, 0.3],
                rows: [
                    [0.0007963267107332644, -0.9999996829318354, 0.0, 0.7500000000000006],
                    [0.9999996829318354, 0.0007963267107332644, 0.0, -2.4083553715553103e-15],
                    [0.0, 0.0, 1.0, 0.15],
                ],
            },
            PosedBox {
                sides: [0.25, 0.2, 0.15],
                rows: [
                    [6.123233995736766e-17, 0.0, 1.0, 0.75],
                    [-1.0, 6.123233995736766e-17, 6.123233995736766e-17, 0.0],
                    [-6.123233995736766e-17, -1.0, 3.749399456654644e-33, 0.15],
                ],
            },
        ),
    ]
}

/// The exact lower bound of the distance that a direction proves: the square of (u · p − h(u)) / |u|.
fn proved_square(query: &Query<'_, 3, Pose>, direction: &[Dyadic; 3]) -> Rational {
    let generators =
        (0..query.len()).map(|i| crate::lad::of_generators::seam::generators::Generators::exact_generator(query, i));
    let reach = generators.fold(Dyadic::zero(), |sum, g| sum + dot(&g, direction).abs());
    let along = dot(&query.exact(), direction) - reach;
    assert!(along.sign().is_gt());
    (&along * &along).to_rational() / dot(direction, direction).to_rational()
}

#[test]
fn reported_poses_are_answered_with_proof() {
    let mut outcomes = Vec::new();
    for (name, first, second) in reported() {
        let (a, b) = (first.body(), second.body());
        let (pose, other) = (first.pose(), second.pose());
        let answer = a.at(&pose).proximity(b.at(&other));
        assert_eq!(answer.status(), a.at(&pose).intersection(b.at(&other)).status(), "{name}");
        if let Some(gap) = answer.gap() {
            let query = Query::of_placed(a.at(&pose), b.at(&other));
            assert_eq!(proved_square(&query, gap.exact_direction()), gap.exact_squared_distance(), "{name}");
            // the points are on the boxes and as far apart as the distance, but for rounding
            let [x, y] = gap.points;
            let apart = (0..3).map(|k| (y[k] - x[k]) * (y[k] - x[k])).sum::<f64>().sqrt();
            assert!((apart - gap.distance()).abs() < 1e-15, "{name}: {apart} {}", gap.distance());
            assert!(exact(x).iter().all(|c| c.to_f64().is_finite()));
        }
        outcomes.push((name, answer.status(), answer.distance()));
    }
    let of =
        |name: &str| outcomes.iter().find(|(own, ..)| *own == name).map(|(_, status, distance)| (*status, *distance));
    assert_eq!(of("FCL 508"), Some((Status::Outside, 3.0)));
    let statuses: Vec<(&str, Status)> = outcomes.iter().map(|(name, status, _)| (*name, *status)).collect();
    assert!(statuses.iter().any(|(_, status)| *status == Status::Inside), "{outcomes:?}");
}
