//! Small questions of all kinds: whole numbers, for ties and flat bodies, numbers with all their places, numbers an ulp
//! apart and numbers of any size.

use serde_json::{Value, json};

use crate::dice::Dice;

mod near_ties;

/// The population from which the numbers of a question come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Population {
    /// Numbers about 1, or of a few dozen orders of magnitude.
    Ordinary,
    /// Numbers over the whole range of doubles, the smallest and the largest among them.
    AnySize,
    /// Whole numbers, generators that are nearly parallel to others, and points near facets.
    NearTies,
}

/// The style of the numbers of one question.
#[derive(Debug, Clone, Copy)]
enum Style {
    /// Whole numbers about zero.
    Whole,
    /// Numbers with all their places.
    Real,
    /// Whole numbers of a grid that is large beside the number of vectors.
    Grid,
    /// Numbers with all their places and one exponent.
    OneExponent(i32),
    /// Neighbours of one number, of either sign.
    Cluster(f64),
    /// Numbers about 1, of which the last of a vector are by this power of two smaller: flat but for that.
    Thin(i32),
    /// Whole numbers and their neighbours.
    Ulps,
    /// Whole numbers, and others of sizes between 1e-12 and 1e12.
    Mixed,
    /// Whole numbers, and others of any size.
    Wide,
    /// Numbers of all their places, multiplied by one power of two.
    Scaled(i32),
    /// Few exponents, each number has one of them.
    Exponents([i32; 3]),
    /// Small multiples of the smallest double, now and then beside numbers about 1.
    Smallest,
    /// The largest doubles, and numbers about 1.
    Largest,
}

/// Exponents from that of the smallest double to that of the largest.
fn exponent(dice: &mut Dice) -> i32 {
    dice.below(2_097) as i32 - 1_074
}

impl Style {
    fn of(dice: &mut Dice, population: Population) -> Self {
        match population {
            Population::Ordinary => match dice.below(9) {
                0 | 1 => Self::Whole,
                2 => Self::Real,
                3 => Self::Ulps,
                4 => Self::Mixed,
                5 => Self::Grid,
                6 => Self::OneExponent(dice.below(80) as i32 - 40),
                7 => Self::Cluster(*dice.choose(&[1.0, 0.1, 1.0 / 3.0, 3.0])),
                _ => Self::Thin(10 + dice.below(30) as i32),
            },
            Population::AnySize => match dice.below(6) {
                0 => Self::Wide,
                1 => Self::Scaled(exponent(dice)),
                2 | 3 => Self::Exponents([exponent(dice), exponent(dice), 0]),
                4 => Self::Smallest,
                _ => Self::Largest,
            },
            Population::NearTies => Self::Whole,
        }
    }

    fn number(self, dice: &mut Dice) -> f64 {
        let whole = dice.below(7) as f64 - 3.0;
        match self {
            Self::Whole => whole,
            Self::Real => 2.0 * dice.unit(),
            Self::Ulps => *dice.choose(&[whole, whole, whole.next_up(), whole.next_down()]),
            Self::Grid => dice.below(121) as f64 - 60.0,
            Self::OneExponent(exponent) => {
                let factor = 1.5 + dice.unit() / 2.0;
                scaled(if dice.one_in(2) { factor } else { -factor }, exponent)
            }
            Self::Cluster(number) => {
                let near = (0..dice.below(4)).fold(number, |near, _| near.next_up());
                if dice.one_in(3) { -near } else { near }
            }
            Self::Thin(_) => dice.unit(),
            Self::Mixed if dice.one_in(3) => whole,
            Self::Wide if dice.one_in(2) => whole,
            Self::Wide => scaled(dice.unit(), exponent(dice)),
            Self::Mixed => dice.unit() * 10.0_f64.powi(dice.below(25) as i32 - 12),
            Self::Scaled(exponent) if dice.one_in(4) => scaled(whole / 4.0, exponent),
            Self::Scaled(exponent) => scaled(dice.unit(), exponent),
            Self::Exponents(exponents) => {
                let factor = if dice.one_in(3) { whole / 4.0 } else { dice.unit() };
                scaled(factor, *dice.choose(&exponents))
            }
            Self::Smallest if dice.one_in(6) => whole,
            Self::Smallest => f64::from_bits(dice.below(9) as u64) * if dice.one_in(2) { 1.0 } else { -1.0 },
            Self::Largest if dice.one_in(6) => whole,
            Self::Largest => {
                let size = *dice.choose(&[f64::MAX, f64::MAX.next_down(), f64::MAX / 2.0, f64::MAX * 0.3]);
                if dice.one_in(2) { size } else { -size }
            }
        }
    }
}

/// The factor times a power of two, rounded where it is denormal.
fn scaled(factor: f64, exponent: i32) -> f64 {
    // The first half is a normal number, so that only the second product is rounded.
    let half = exponent / 2;
    factor * 2.0_f64.powi(half) * 2.0_f64.powi(exponent - half)
}

fn vector(dice: &mut Dice, style: Style, dimension: usize) -> Vec<f64> {
    let mut numbers: Vec<f64> = (0..dimension).map(|_| style.number(dice)).collect();
    if let (Style::Thin(exponent), Some(last)) = (style, numbers.last_mut()) {
        *last = scaled(*last, -exponent);
    }
    numbers
}

/// Some vectors; now and then two are parallel, or all are flat.
fn vectors(dice: &mut Dice, style: Style, dimension: usize, count: usize) -> Vec<Vec<f64>> {
    let mut list: Vec<Vec<f64>> = (0..count).map(|_| vector(dice, style, dimension)).collect();
    if count > 1 && dice.one_in(4) {
        let factor = *dice.choose(&[-2.0, -1.0, 1.0, 0.5]);
        list[0] = list[1].iter().map(|x| x * factor).collect();
    }
    if count > 2 && dice.one_in(6) {
        // the neighbours of another one
        list[2] = list[1].iter().map(|x| if dice.one_in(2) { x.next_up() } else { *x }).collect();
        list[2].iter_mut().for_each(|x| *x = x.clamp(-f64::MAX, f64::MAX));
    }
    if dimension > 1 && dice.one_in(8) {
        list.iter_mut().for_each(|v| v[dimension - 1] = 0.0);
    }
    list
}

/// A question of the kind with the given id.
pub fn question(dice: &mut Dice, population: Population, kind: &str, id: &str) -> Value {
    let style = Style::of(dice, population);
    let dimension = *dice.choose(&[1, 2, 2, 3, 3, 3, 4]);
    let mut input = input(dice, kind, style, dimension);
    if population == Population::NearTies {
        near_ties::arrange(dice, &mut input);
    }
    json!({"id": id, "kind": kind, "input": input})
}

/// A zonotope with so many generators.
fn body(dice: &mut Dice, style: Style, dimension: usize, count: usize) -> Value {
    let center = vector(dice, style, dimension);
    json!({"center": center, "generators": vectors(dice, style, dimension, count)})
}

fn input(dice: &mut Dice, kind: &str, style: Style, dimension: usize) -> Value {
    let space = dimension.min(3);
    let count = if dice.one_in(6) { 5 + dice.below(3) } else { dice.below(5) };
    let some = count.max(1);
    match kind {
        "member" => {
            let point = json!(vector(dice, style, dimension));
            with(body(dice, style, dimension, count), "point", point)
        }
        "intersect" => {
            let a = body(dice, style, dimension, count);
            json!({"a": a, "b": body(dice, style, dimension, 4_usize.saturating_sub(count))})
        }
        "distance" => {
            json!({"a": body(dice, style, space, count), "b": body(dice, style, space, 5_usize.saturating_sub(count))})
        }
        "collide" => {
            let (a, b) = if dice.one_in(3) {
                (mesh_at_rest(dice, style, some.min(4)), mesh_at_rest(dice, style, 5 - some.min(4)))
            } else {
                (body(dice, style, 3, count), body(dice, style, 3, 4_usize.saturating_sub(count)))
            };
            let mut motion = json!({"a": pieces(dice)});
            if dice.one_in(2) {
                motion["b"] = pieces(dice);
            }
            json!({"a": a, "b": b, "motion": motion})
        }
        "mesh" => {
            let input = json!({"a": mesh(dice, style, some), "b": mesh(dice, style, 6 - some.min(5))});
            if dice.one_in(2) { with(input, "pairs", json!(true)) } else { input }
        }
        "mesh_level" => {
            json!({"a": mesh_at_rest(dice, style, some), "level": dice.below(4)})
        }
        "hausdorff" => {
            let (a, b) = (body(dice, style, space, count), body(dice, style, space, 4_usize.saturating_sub(count)));
            // Of some pairs the second body is the first one and more.
            if dice.one_in(4) {
                let lists = [&a, &b].map(|body| body["generators"].as_array().cloned().unwrap_or_default());
                return json!({"a": a, "b": {"center": a["center"], "generators": lists.concat()}});
            }
            json!({"a": a, "b": b})
        }
        "approx" => json!({
            "generators": vectors(dice, style, space, some), "epsilon": dice.choose(&[0.5, 0.25, 0.1])
        }),
        "reduce" => {
            let rules = ["cluster", "lemma_5_5", "girard", "combastel", "pca", "scott", "adaptive", "best"];
            let body = body(dice, style, space, some);
            with(with(body, "rule", json!(dice.choose(&rules))), "count", json!(space + dice.below(2)))
        }
        "gauge" => json!({
            "p": vector(dice, style, dimension), "q": vector(dice, style, dimension),
            "generators": vectors(dice, style, dimension, count)
        }),
        "member_batch" => {
            with(body(dice, style, dimension, count), "points", json!(vectors(dice, style, dimension, 3)))
        }
        "sweep" => {
            let mut input = body(dice, style, 3, count);
            for name in ["axis_point", "axis", "translation"] {
                input[name] = json!(vector(dice, style, 3));
            }
            let angle = if dice.one_in(4) { 0.0 } else { 7.0 * dice.unit().abs() };
            with(input, "angle", json!(angle))
        }
        "support" => with(body(dice, style, dimension, count), "direction", json!(vector(dice, style, dimension))),
        "combinatorics" => json!({"generators": vectors(dice, style, dimension, count)}),
        "slope_selection" => json!({"generators": vectors(dice, style, 3, some + 1), "k": [1]}),
        "separator" => json!({"generators": vectors(dice, style, 3, some + 1), "k": 1}),
        "walk" => json!({"generators": vectors(dice, style, 3, some + 2), "facet": [0, 1, 1]}),
        "upper_hull" => json!({"generators": vectors(dice, style, 3, some), "p0": vector(dice, style, 2)}),
        "min_area" => json!({"points": vectors(dice, style, 2, some)}),
        "min_length_dirs" => {
            let weights: Vec<f64> = (0..some).map(|_| dice.below(4) as f64).collect();
            json!({
                "points": vectors(dice, style, space, 1 + count), "directions": vectors(dice, style, space, some),
                "weights": weights
            })
        }
        "min_length_all" => {
            let input = json!({"points": vectors(dice, style, space, some), "epsilon": 0.25});
            if dice.one_in(4) { with(input, "max_generators", json!(space + 1)) } else { input }
        }
        other => panic!("no question is made of the kind `{other}`"),
    }
}

/// A mesh with so many triangles, now and then flat ones and repeated ones.
fn mesh_at_rest(dice: &mut Dice, style: Style, count: usize) -> Value {
    let vertices = 1 + dice.below(5);
    let triangles: Vec<[usize; 3]> = (0..count).map(|_| [(); 3].map(|()| dice.below(vertices))).collect();
    json!({"vertices": vectors(dice, style, 3, vertices), "triangles": triangles})
}

/// A mesh with so many triangles, and perhaps a pose.
fn mesh(dice: &mut Dice, style: Style, count: usize) -> Value {
    let mut mesh = mesh_at_rest(dice, style, count);
    if dice.one_in(3) {
        mesh["pose"] = json!({"translation": vector(dice, style, 3)});
    }
    if dice.one_in(3) {
        let whole = |dice: &mut Dice| dice.below(3) as f64 - 1.0;
        let matrix: Vec<Vec<f64>> = (0..3).map(|_| (0..3).map(|_| whole(dice)).collect()).collect();
        mesh["pose"] = json!({"matrix": matrix, "translation": vector(dice, style, 3)});
    }
    mesh
}

/// A motion of one or two pieces in small whole numbers, each of at most half a turn.
fn pieces(dice: &mut Dice) -> Value {
    let count = 1 + dice.below(2);
    let mut whole = |most: usize| dice.below(2 * most + 1) as f64 - most as f64;
    let list = (1..=count).map(|number| {
        let mut quaternion = || [1.0 + whole(2).abs(), whole(2), whole(2), whole(2)];
        let (from, to): ([f64; 4], [f64; 4]) = (quaternion(), quaternion());
        let is_opposite = from.iter().zip(to).map(|(p, q)| p * q).sum::<f64>() < 0.0;
        let to = if is_opposite { to.map(|c| -c) } else { to };
        json!({
            "until": number as f64 / count as f64, "from": from, "to": to,
            "axis_point": [whole(2), whole(2), whole(2)], "translation": [whole(6), whole(6), whole(6)],
        })
    });
    json!({"pieces": list.collect::<Vec<_>>()})
}

fn with(mut input: Value, field: &str, value: Value) -> Value {
    input[field] = value;
    input
}

/// The question with one number of its input changed: by an ulp, by a small part of it, in its sign, for another one.
pub fn neighbour(dice: &mut Dice, question: &Value) -> Value {
    let mut changed = question.clone();
    let mut numbers = 0;
    each_double(&mut changed["input"], &mut |_| numbers += 1);
    let (chosen, mut at) = (dice.below(numbers), 0);
    let part = 10.0_f64.powi(-(dice.below(16) as i32));
    let choice = dice.below(8);
    let other = dice.below(7) as f64 - 3.0;
    each_double(&mut changed["input"], &mut |x| {
        if at == chosen {
            *x = match choice {
                0 | 1 => x.next_up(),
                2 | 3 => x.next_down(),
                4 | 5 => *x * (1.0 + part),
                6 => -*x,
                _ => other,
            };
            *x = x.clamp(-f64::MAX, f64::MAX);
        }
        at += 1;
    });
    changed
}

/// Calls `change` on every number of a value that is a double and no count.
fn each_double(value: &mut Value, change: &mut impl FnMut(&mut f64)) {
    match value {
        Value::Number(number) if number.is_f64() => {
            let mut x = number.as_f64().unwrap_or_default();
            change(&mut x);
            *value = json!(x);
        }
        Value::Array(list) => list.iter_mut().for_each(|element| each_double(element, change)),
        Value::Object(fields) => fields.iter_mut().for_each(|(_, field)| each_double(field, change)),
        _ => {}
    }
}
