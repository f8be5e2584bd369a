//! The slowest locations, reductions, distances of bodies and enclosures of points, beside the usual ones: for each
//! kind of question and family of vectors the median time, and the questions that take longest.
//!
//! `cargo run --release -p experiments --features studies --example slowest_reductions -- 200 [kind] [family]` asks so
//! many questions of each kind and family, of one to six dimensions and up to a thousand vectors: generators, or
//! points. Times are those of the processor where they are long and the system tells them, else those of a clock.

use std::env;
use std::fs;
use std::time::Instant;

use families::source::RandomSource;
use zonotope::Zonotope;
use zonotope::collision::prepared::by_cutting::PreparedByCutting;
use zonotope::enclosing::fixed_directions::{FixedDirections, min_length_along};
use zonotope::enclosing::min_area;
use zonotope::enclosing::min_total_length::{Method as LengthMethod, few_generators};
use zonotope::reduction::by_patches::patches_within;
use zonotope::reduction::hausdorff::hausdorff;
use zonotope::reduction::{Method, Problem, contains};

const SIZES: [usize; 15] = [1, 2, 3, 4, 5, 6, 8, 12, 20, 30, 50, 100, 200, 400, 1000];
const PRECISIONS: [f64; 6] = [0.5, 0.2, 0.1, 0.01, 1e-3, 1e-6];
const KINDS: [&str; 13] = [
    "locate",
    "gauge",
    "intersection",
    "by_cutting",
    "hausdorff",
    "contains",
    "reduce",
    "approx",
    "min_length_all",
    "min_length_net",
    "min_length_few",
    "min_length_dirs",
    "min_area",
];
const FAMILIES: [&str; 11] = [
    "random",
    "sphere",
    "torus",
    "lattice",
    "flat",
    "needle",
    "parallel",
    "mixed_scales",
    "denormal",
    "pancake",
    "huge",
];

/// The bounds differ by at most this part of the lower one, where the search for them allows it.
const WIDTH: f64 = 0.01;

/// The most generators of both bodies that a location takes in five and in six dimensions, where every facet is looked
/// at: those that `solve` takes.
const LOCATED_IN_HIGH_DIMENSIONS: [usize; 2] = [18, 14];

/// Milliseconds up to which the clock tells the time.
const CLOCK_LIMIT: f64 = 20.0;

/// Questions listed of a kind and family.
const LISTED: usize = 3;

/// A question that was asked, with its time in milliseconds.
struct Asked {
    time: f64,
    text: String,
}

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let count =
        arguments.first().map_or(200, |text| text.parse().expect("the first argument is a number of questions"));
    let is_chosen = |at: usize, name: &str| arguments.get(at).is_none_or(|chosen| chosen == name);
    for kind in KINDS.into_iter().filter(|kind| is_chosen(1, kind)) {
        for family in FAMILIES.into_iter().filter(|family| is_chosen(2, family)) {
            let mut source = RandomSource::new(1);
            let mut asked: Vec<Asked> = (0..count).map(|_| ask(kind, family, &mut source)).collect();
            asked.sort_by(|a, b| a.time.total_cmp(&b.time));
            let (Some(middle), Some(last)) = (asked.get(asked.len() / 2), asked.last()) else { continue };
            let ratio = last.time / middle.time;
            println!(
                "{kind} {family}: median {:.3} ms, slowest {:.1} ms, {ratio:.0} times that",
                middle.time, last.time
            );
            for question in asked.iter().rev().take(LISTED) {
                println!("    {:.1} ms: {}", question.time, question.text);
            }
        }
    }
}

fn ask(kind: &str, family: &str, source: &mut RandomSource) -> Asked {
    let dimensions = match kind {
        "min_area" => 2..=2,
        "by_cutting" => 3..=3,
        _ if kind.starts_with("min_length") => 1..=4,
        _ => 1..=6,
    };
    match whole(source, *dimensions.start(), *dimensions.end()) {
        1 => ask_in::<1>(kind, family, source),
        2 => ask_in::<2>(kind, family, source),
        3 => ask_in::<3>(kind, family, source),
        4 => ask_in::<4>(kind, family, source),
        5 => ask_in::<5>(kind, family, source),
        _ => ask_in::<6>(kind, family, source),
    }
}

fn ask_in<const D: usize>(kind: &str, family: &str, source: &mut RandomSource) -> Asked {
    let size = (*one_of(&SIZES, source)).min(most_located::<D>(kind));
    let vectors: Vec<[f64; D]> = generators(family, size, source);
    if kind.starts_with("min_") {
        return ask_around(kind, family, &vectors, source);
    }
    let body = Zonotope::new([0.0; D], vectors).expect("the families are finite");
    match kind {
        "by_cutting" => {
            let generators =
                body.generators().iter().map(|g| std::array::from_fn(|c| g.get(c).copied().unwrap_or(0.0)));
            let space = (size * size.isqrt()) as u64;
            let body = Zonotope::new([0.0; 3], generators.collect()).expect("the families are finite");
            timed(format!("{size} generators"), || {
                let prepared = PreparedByCutting::new(body, space, 1, &mut ()).ok()?;
                prepared.contains([1.0; 3]).ok().map(f64::from)
            })
        }
        "locate" | "gauge" => {
            let point = body.generators().iter().fold([0.0; D], |sum, g| {
                let sign = if source.unit() < 0.9 { 1.0 } else { -1.0 };
                std::array::from_fn(|c| sum[c] + sign * g[c] / 2.0)
            });
            timed(format!("R^{D}, {size} generators"), || match kind {
                "locate" => body.locate(point).ok().map(|_| 0.0),
                _ => body.gauge(point).ok().map(|_| 0.0),
            })
        }
        "hausdorff" | "contains" | "intersection" => {
            let (other, text) = other_body(kind, family, &body, source);
            let text = format!("{text}, R^{D}, {size} and {} generators", other.generators().len());
            match kind {
                "intersection" => timed(text, || Some(f64::from(body.intersects(&other)))),
                "hausdorff" => timed(text, || Some(hausdorff(&body, &other, WIDTH).upper)),
                _ => timed(text, || contains(&other, &body).map(f64::from)),
            }
        }
        "reduce" => {
            let (method, count) = (*one_of(&Method::ALL, source), *one_of(&[D, D + 1, 2 * D, 3 * D], source));
            timed(format!("{}, {count} of {size} generators, R^{D}", method.id()), || {
                let problem = Problem::new(&body, count).expect("the count is at least the dimension");
                method.reduce(&problem).ok().map(|reduced| reduced.distance(&body, WIDTH).upper)
            })
        }
        _ => {
            let epsilon = *one_of(&PRECISIONS, source);
            timed(format!("{epsilon}, R^{D}, {size} generators"), || {
                patches_within(&body, epsilon, &mut ()).ok().map(|reduced| reduced.distance(&body, WIDTH).upper)
            })
        }
    }
}

/// The most generators of a body of a location.
fn most_located<const D: usize>(kind: &str) -> usize {
    let in_all = D.checked_sub(5).map_or(usize::MAX, |place| LOCATED_IN_HIGH_DIMENSIONS[place]);
    match kind {
        "locate" | "gauge" => in_all,
        "intersection" => in_all / 2,
        _ => usize::MAX,
    }
}

/// A question about an enclosure of points.
fn ask_around<const D: usize>(kind: &str, family: &str, points: &[[f64; D]], source: &mut RandomSource) -> Asked {
    let (epsilon, n) = (*one_of(&PRECISIONS, source), points.len());
    match kind {
        "min_area" => {
            let plane: Vec<[f64; 2]> = points.iter().map(|p| [p[0], p[D - 1]]).collect();
            timed(format!("{n} points"), || min_area(&plane).ok().map(|answer| answer.value))
        }
        "min_length_dirs" => {
            let directions: Vec<[f64; D]> = generators(family, whole(source, D as i32, 24) as usize, source);
            let weights = vec![1.0; directions.len()];
            timed(format!("{n} points, {} directions, R^{D}", directions.len()), || {
                let problem = FixedDirections::new(points, &directions, &weights).ok()?;
                min_length_along(&problem, &mut ()).ok()?.optimal().map(|answer| answer.value)
            })
        }
        "min_length_few" => {
            let count = D + whole(source, 0, 3) as usize;
            timed(format!("{epsilon}, {n} points, {count} generators, R^{D}"), || {
                let answer = LengthMethod::default().solve(points, epsilon, &mut ()).ok()?;
                few_generators::shortest_of_few(points, answer, epsilon, count).ok().map(|answer| answer.value)
            })
        }
        _ => {
            let method = if kind == "min_length_net" { LengthMethod::DirectionNet } else { LengthMethod::default() };
            timed(format!("{epsilon}, {n} points, R^{D}"), || {
                method.solve(points, epsilon, &mut ()).ok().map(|answer| answer.value)
            })
        }
    }
}

fn timed(text: String, work: impl FnOnce() -> Option<f64>) -> Asked {
    let (clock, start) = (Instant::now(), processor_time());
    let answer = work();
    let elapsed = clock.elapsed().as_secs_f64() * 1e3;
    let of_processor = start.zip(processor_time()).map(|(start, end)| end - start);
    // the system may tell the processor's time in steps of some milliseconds
    let time = of_processor.filter(|_| elapsed > CLOCK_LIMIT).unwrap_or(elapsed);
    Asked { time, text: format!("{text}{}", if answer.is_none() { ", refused" } else { "" }) }
}

/// The milliseconds that the processor has spent on this thread, where the system tells them.
fn processor_time() -> Option<f64> {
    let told = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    told.split_whitespace().next()?.parse::<f64>().ok().map(|nanoseconds| nanoseconds / 1e6)
}

/// A body to compare with: another of the family, one that is off by rounding, moved, or a part.
fn other_body<const D: usize>(
    kind: &str,
    family: &str,
    body: &Zonotope<D>,
    source: &mut RandomSource,
) -> (Zonotope<D>, &'static str) {
    let mut center = [0.0; D];
    let (list, text) = match whole(source, 0, 4) {
        0 => (generators(family, (*one_of(&SIZES, source)).min(most_located::<D>(kind)), source), "another body"),
        1 => (body.generators().iter().map(|g| g.map(f64::next_up)).collect(), "an ulp apart"),
        2 => (body.generators().iter().map(|g| g.map(|c| c * 1.0f64.next_down())).collect(), "scaled by an ulp"),
        3 => (body.generators()[..body.generators().len().min(5)].to_vec(), "a few of the generators"),
        _ => {
            center = normal(source);
            (body.generators().to_vec(), "moved")
        }
    };
    (Zonotope::new(center, list).expect("the families are finite"), text)
}

fn generators<const D: usize>(family: &str, size: usize, source: &mut RandomSource) -> Vec<[f64; D]> {
    let axis: [f64; D] = normal(source);
    let basis: [[f64; D]; 2] = [lattice(source), lattice(source)];
    let thickness = 10f64.powi(-whole(source, 2, 9));
    let generator = |source: &mut RandomSource| -> [f64; D] {
        match family {
            "random" => normal(source),
            "sphere" => {
                let g = normal::<D>(source);
                let length = g.iter().map(|c| c * c).sum::<f64>().sqrt();
                g.map(|c| c / length)
            }
            "torus" => {
                let turn = |part: f64| libm::sincos(std::f64::consts::TAU * part);
                let [(sin, cos), (across, along)] = [source.unit(), source.unit()].map(turn);
                let of_torus = [(5.0 + cos) * along, (5.0 + cos) * across, sin];
                std::array::from_fn(|k| of_torus.get(k).copied().unwrap_or(0.0))
            }
            "lattice" => lattice(source),
            "flat" => {
                let [s, t] = [f64::from(whole(source, -3, 3)), f64::from(whole(source, -3, 3))];
                std::array::from_fn(|k| s * basis[0][k] + t * basis[1][k])
            }
            "needle" => {
                let [length, off]: [[f64; D]; 2] = [normal(source), normal(source)];
                std::array::from_fn(|k| length[0] * axis[k] + thickness * off[k])
            }
            "parallel" => {
                let factor =
                    if whole(source, 0, 1) == 0 { f64::from(whole(source, -4, 4)) } else { normal::<1>(source)[0] };
                one_of(&basis, source).map(|c| factor * c)
            }
            "mixed_scales" => normal::<D>(source).map(|c| c * 10f64.powi(whole(source, -8, 8))),
            "denormal" => std::array::from_fn(|_| f64::from(whole(source, -60, 60)) * f64::from_bits(1)),
            "pancake" => {
                let g = normal::<D>(source);
                std::array::from_fn(|k| if k + 1 == D { 1e-7 * g[k] } else { g[k] })
            }
            "huge" => normal::<D>(source).map(|c| c * 1e300),
            other => panic!("no family is called {other}"),
        }
    };
    (0..size).map(|_| generator(source)).collect()
}

fn normal<const D: usize>(source: &mut RandomSource) -> [f64; D] {
    std::array::from_fn(|_| source.normal_pair()[0])
}

fn lattice<const D: usize>(source: &mut RandomSource) -> [f64; D] {
    std::array::from_fn(|_| f64::from(whole(source, -3, 3)))
}

/// A whole number of a range, its ends included.
fn whole(source: &mut RandomSource, low: i32, high: i32) -> i32 {
    let part = source.unit() * f64::from(high - low + 1);
    (low + part as i32).min(high)
}

fn one_of<'a, T>(list: &'a [T], source: &mut RandomSource) -> &'a T {
    &list[whole(source, 0, list.len() as i32 - 1) as usize]
}
