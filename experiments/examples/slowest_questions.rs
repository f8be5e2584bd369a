//! The slowest questions of collision, beside the usual ones: for each family and size of bodies, the median time of
//! the kernel over questions at every placement, and the questions that take longest, with the rungs that answered.
//!
//! `cargo run --release -p experiments --features studies --example slowest_questions -- 1050 [family]` asks so many
//! questions of each family and size, a tenth of a million in all. Each is asked three times, of which the least time
//! counts: what a busy machine adds is not the question's. An answer that contradicts the construction ends the
//! program.

use std::env;
use std::time::Instant;

use experiments::question::{PLACEMENTS, Question};
use families::bodies::{BODY_FAMILIES, BodyFamily};
use zonotope::collision::by_lad;
use zonotope::tally::{OperationCounts, Rung};

const SIZES: [usize; 9] = [6, 16, 64, 128, 256, 512, 1024, 2048, 4096];

/// The number of times that a question is asked.
const REPETITIONS: usize = 3;

/// Questions that take more than this, in terms of the median, are listed, at most [`LISTED`] of a family and size.
const SLOW: f64 = 25.0;
const LISTED: usize = 3;

/// A question that was asked, with its time in nanoseconds.
struct Asked {
    time: f64,
    text: String,
}

fn main() {
    let mut arguments = env::args().skip(1);
    let count =
        arguments.next().map_or(1050, |text| text.parse().expect("the first argument is a number of questions"));
    let family = arguments.next();
    for family in BODY_FAMILIES.iter().filter(|known| family.as_ref().is_none_or(|id| id == known.id)) {
        for size in SIZES {
            let mut asked = ask(family, size, count);
            asked.sort_by(|a, b| a.time.total_cmp(&b.time));
            let (Some(middle), Some(last)) = (asked.get(asked.len() / 2), asked.last()) else { continue };
            let (median, most) = (middle.time, last.time / middle.time);
            println!(
                "{} {size}: {} questions, median {median:.0} ns, slowest {most:.0} times that",
                family.id,
                asked.len()
            );
            for question in asked.iter().rev().take(LISTED).filter(|question| question.time > SLOW * median) {
                println!("    {:.0} us: {}", question.time / 1e3, question.text);
            }
        }
    }
}

/// Asks questions about bodies of a family, one at each placement about each body.
fn ask(family: &BodyFamily<3>, size: usize, count: usize) -> Vec<Asked> {
    let mut asked = Vec::with_capacity(count);
    for seed in 0..count.div_ceil(PLACEMENTS.len()) as u64 {
        let body = family.generate(size, seed);
        for placement in PLACEMENTS {
            let Some(question) = Question::about(body.clone(), placement, seed) else { continue };
            let text = format!("seed {seed}, {}, {}", placement.id, rungs(&question));
            asked.push(Asked { time: least_time(&question), text });
        }
    }
    asked
}

/// The least time that the location takes, in nanoseconds.
fn least_time(question: &Question) -> f64 {
    let query = question.displacement();
    (0..REPETITIONS).fold(f64::INFINITY, |least, _| {
        let start = Instant::now();
        let location = by_lad::locate(&query, &mut ());
        let time = start.elapsed().as_nanos() as f64;
        assert_eq!(location.status().name(), question.status, "the answer contradicts the construction");
        least.min(time)
    })
}

/// The rungs that answer a question.
fn rungs(question: &Question) -> String {
    let mut counts = OperationCounts::default();
    by_lad::locate(&question.displacement(), &mut counts);
    let answered = Rung::ALL.into_iter().filter(|rung| counts.answers_of(*rung) > 0);
    answered.map(Rung::name).collect::<Vec<_>>().join(" and ")
}
