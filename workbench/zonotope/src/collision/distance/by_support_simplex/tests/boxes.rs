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
        [0.961_939_766_255_643_5, 0.154_012_799_157_373_6, 0.225_725_372_503_289_2],
        [-0.191_341_716_182_544_86, 0.969_364_949_512_839_1, 0.154_012_799_157_373_6],
        [-0.195_090_322_016_128_22, -0.191_341_716_182_544_86, 0.961_939_766_255_643_5],
    ];
    let fcl_495 = [
        [0.940_960_632_174_177_6, 0.292_968_400_372_895, 0.169_595_415_861_748_12],
        [-0.235_698_368_412_998_8, 0.926_615_235_958_484_3, -0.292_968_400_372_895_07],
        [-0.242_980_179_903_263_9, 0.235_698_368_412_998_85, 0.940_960_632_174_177_6],
    ];
    let at = |matrix: [[f64; 3]; 3], t: [f64; 3]| [0, 1, 2].map(|k| [matrix[k][0], matrix[k][1], matrix[k][2], t[k]]);
    vec![
        (
            "FCL 388",
            PosedBox {
                sides: [0.03, 0.12, 0.1],
                rows: [
                    [-3.0627937852578682e-8, -0.999_999_999_999_998_9, -2.8893865161583314e-8, 0.634_999_796_273_508_1],
                    [0.999_999_999_999_998, -3.0627939739957804e-8, 6.472992692852751e-8, -0.485_000_022_156_364_4],
                    [-6.472992772296385e-8, -2.889386302944875e-8, 0.999_999_999_999_997_1, 1.077_814_645_833_964_1],
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
                sides: [0.237_680_375_576_019_29, 0.157_023_057_341_575_62, 0.25],
                rows: [
                    [-0.099_432_387_353_076_27, 0.995_044_320_794_439_7, 0.0, 0.295_264_065_265_065_55],
                    [-0.995_044_320_794_439_7, -0.099_432_387_353_076_27, 0.0, -0.013_230_856_508_016_586],
                    [0.0, 0.0, 1.0, 0.0],
                ],
            },
            PosedBox {
                sides: [0.01, 0.781_657_099_723_819_6, 0.25],
                rows: [
                    [0.995_065_984_422_092_3, 0.099_215_354_901_756_73, 0.0, 0.227_595_856_945_452_15],
                    [-0.099_215_354_901_756_73, 0.995_065_984_422_092_3, 0.0, 0.149_740_935_492_281_12],
                    [0.0, 0.0, 1.0, 0.0],
                ],
            },
        ),
        (
            "FCL 415",
            PosedBox::upright([0.02, 0.33, 0.02], [0.053_999_999_999_999_94, -0.772, 0.405_000_000_000_000_03]),
            PosedBox::upright([0.452, 0.27, 0.42], [0.120_999_999_999_999_99, -0.629_605_057_504_326_8, 0.3]),
        ),
        (
            "FCL 428",
            PosedBox::upright([0.2, 0.33, 0.1], [-0.071_000_000_000_000_04, -0.772, 0.8]),
            PosedBox::upright([0.452, 0.27, 0.6], [0.121, -0.787_696_056_927_277, 0.534_220_441_961_251_5]),
        ),
        (
            "FCL, its sixth regression of two boxes, in the series between 428 and 493",
            PosedBox {
                sides: [0.3165, 0.2276, 0.1768],
                rows: [
                    [0.445_405_784_755_302_35, 0.895_328_814_964_934, -8.893740768563868e-9, 1.265_294_907_596_007_2],
                    [
                        -0.895_328_814_964_933_8,
                        0.445_405_784_755_301_9,
                        -2.8948680226084145e-8,
                        1.455_101_242_321_010_1,
                    ],
                    [
                        -2.1957263975186326e-8,
                        2.085_673_201_665_292e-8,
                        0.999_999_999_999_999_6,
                        0.494_800_062_329_329_4,
                    ],
                ],
            },
            PosedBox {
                sides: [0.4943, 0.3546, 0.0752],
                rows: [
                    [0.441_711_229_134_858_6, 0.897_157_282_786_119_1, -1.622764514865468e-9, 1.130_401_622_614_190_6],
                    [-0.897_157_282_786_119_1, 0.441_711_229_134_858_6, -5.162105395230608e-9, 1.841_080_264_528_428],
                    [-3.914427141382999e-9, 3.736034921809435e-9, 1.0, 0.444_000_062_329_324_93],
                ],
            },
        ),
        (
            "FCL 493",
            PosedBox {
                sides: [0.5; 3],
                rows: at(fcl_493, [2.077_006_399_586_799, 0.484_682_474_756_419_5, 1.154_329_141_908_727_6]),
            },
            PosedBox { sides: [0.5; 3], rows: at(fcl_493, [2.0, 0.0, 1.25]) },
        ),
        (
            "FCL 495",
            PosedBox {
                sides: [0.25; 3],
                rows: at(fcl_495, [0.073_242_100_093_223_82, 0.231_653_808_989_621_24, 1.308_924_592_103_249_7]),
            },
            PosedBox { sides: [0.25; 3], rows: at(fcl_495, [0.0, 0.0, 1.25]) },
        ),
        ("FCL 508", PosedBox::upright([1.0; 3], [0.0, 4.0, 0.0]), PosedBox::upright([1.0; 3], [0.0; 3])),
        (
            "Drake 21673",
            PosedBox {
                sides: [0.05, 0.55, 0.3],
                rows: [
                    [0.000_796_326_710_733_264_4, -0.999_999_682_931_835_4, 0.0, 0.750_000_000_000_000_6],
                    [0.999_999_682_931_835_4, 0.000_796_326_710_733_264_4, 0.0, -2.4083553715553103e-15],
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
fn proved_square(query: &PosedQuery<'_>, direction: &[Dyadic; 3]) -> Rational {
    let posed = Posed::new(query);
    let generators =
        (0..query.len()).map(|i| crate::lad::of_generators::generators::Generators::exact_generator(&posed, i));
    let reach = generators.fold(Dyadic::zero(), |sum, g| sum + dot(&g, direction).abs());
    let along = dot(query.displacement(), direction) - reach;
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
            let query = PosedQuery::between((&a, &pose), (&b, &other));
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
