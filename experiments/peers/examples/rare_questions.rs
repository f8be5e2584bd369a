//! The worst of very many questions: for each family of bodies and each size, the median time of a location with its
//! proof on prepared bodies, the longest one, and the placement of that.
//!
//! ```sh
//! cargo run --release -p peers --features others --example rare_questions -- 100000
//! ```
//!
//! The number is that of all questions, 100,000 if none is given. Each question is asked several times and the shortest
//! time counts, so that what else the machine does is not taken for a rare question.

use experiments::families::bodies::BODY_FAMILIES;
use experiments::families::bodies::question::{PLACEMENTS, Question};
use experiments::seed::seed_of;
use std::hint::black_box;
use std::time::{Duration, Instant};
use zonotope::collision::{Query, by_lad};
use zonotope::zonotope::PreparedBody;

const SIZES: [usize; 6] = [6, 16, 64, 256, 1024, 4096];

/// How often a question is asked.
const TURNS: usize = 4;

/// A question that takes longer is asked once.
const LONG: Duration = Duration::from_millis(20);

fn main() -> anyhow::Result<()> {
    let total: usize = std::env::args().nth(1).map_or(Ok(100_000), |text| text.parse())?;
    let each = total.div_ceil(BODY_FAMILIES.len() * SIZES.len() * PLACEMENTS.len());
    println!("| family | generators | questions | median, µs | longest, µs | in medians | placement of the longest |");
    println!("|---|---|---|---|---|---|---|");
    let (mut asked, mut wrong) = (0, 0);
    for family in BODY_FAMILIES {
        for n in SIZES {
            let mut times: Vec<(f64, &str)> = Vec::new();
            for (placement, instance) in PLACEMENTS.iter().flat_map(|p| (0..each).map(move |instance| (p, instance))) {
                let seed = seed_of(7, &format!("{}/{}/n={n}/{instance}", family.id, placement.id));
                let Some(question) = Question::about(family.generate(n, seed), *placement, seed) else { continue };
                let [a, b] = question.bodies().map(PreparedBody::new);
                let query = Query::between_bodies(&a, &b);
                let mut shortest = Duration::MAX;
                for _ in 0..TURNS {
                    let start = Instant::now();
                    let location = black_box(by_lad::locate(black_box(&query)));
                    shortest = shortest.min(start.elapsed());
                    wrong += usize::from(location.is_member() != question.is_member());
                    if shortest > LONG {
                        break;
                    }
                }
                times.push((shortest.as_secs_f64() * 1e6, placement.id));
            }
            times.sort_by(|a, b| a.0.total_cmp(&b.0));
            let Some((longest, placement)) = times.last().copied() else { continue };
            let median = times[times.len() / 2].0;
            asked += times.len();
            let ratio = longest / median;
            println!(
                "| {} | {n} | {} | {median:.2} | {longest:.2} | {ratio:.1} | {placement} |",
                family.id,
                times.len()
            );
        }
    }
    println!("\n{asked} questions, {wrong} wrong answers.");
    Ok(())
}
