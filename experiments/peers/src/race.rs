//! The measurement: every contender on the same questions, turn by turn.

use crate::contenders::{Answer, CONTENDERS, Contender, Work};
use experiments::peers::{Cell, Entry};
use experiments::question::{Placement, Question};
use experiments::seed;
use families::bodies::{self, BodyFamily};
use std::collections::BTreeSet;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// A sample repeats short work until it has lasted this long, and divides: the clock's own cost stays below a percent.
const SHORTEST_SAMPLE: Duration = Duration::from_micros(20);
/// Work that takes longer than this is timed once and not again.
const LONG: Duration = Duration::from_millis(50);
/// A contender that needs longer for one question is asked [`FEW_QUESTIONS`] of a cell.
const SLOW: Duration = Duration::from_millis(20);
/// The number of questions of a cell that are put to a slow contender: its times are far from all others.
const FEW_QUESTIONS: u32 = 2;
/// A contender that needs longer for one question sits out the larger sizes of the family.
const PATIENCE: Duration = Duration::from_secs(3);

/// The work that is run.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The seed of everything random.
    pub seed: u64,
    /// Families, sizes, placements and questions of each.
    pub parts: Vec<Part>,
    /// Samples of every contender on every question.
    pub repetitions: usize,
    /// Contenders that run beside the pass; all of them if none is named.
    pub methods: Vec<String>,
}

/// Sizes that share their placements and their number of questions.
#[derive(Clone, Debug)]
pub struct Part {
    /// The families.
    pub families: Vec<&'static str>,
    /// The number of generators.
    pub sizes: Vec<usize>,
    /// The placements' ids.
    pub placements: Vec<&'static str>,
    /// Questions of every family, size and placement.
    pub questions: u32,
}

impl Plan {
    fn includes(&self, method: &str) -> bool {
        method == "pass" || self.methods.is_empty() || self.methods.iter().any(|wanted| wanted == method)
    }
}

/// Runs the plan; `progress` hears of every cell that is done.
///
/// # Errors
/// An unknown family or placement.
pub fn run(plan: &Plan, mut progress: impl FnMut(&Cell)) -> anyhow::Result<Vec<Cell>> {
    let mut cells = Vec::new();
    let mut retired = BTreeSet::new();
    for part in &plan.parts {
        for id in &part.families {
            let family = bodies::find(id).ok_or_else(|| anyhow::anyhow!("no family of bodies is called {id}"))?;
            for &n in &part.sizes {
                for name in &part.placements {
                    let placement =
                        Placement::find(name).ok_or_else(|| anyhow::anyhow!("no placement is called {name}"))?;
                    let cell = measure(plan, part, family, placement, n, &mut retired);
                    progress(&cell);
                    cells.push(cell);
                }
            }
        }
    }
    Ok(cells)
}

fn measure(
    plan: &Plan,
    part: &Part,
    family: &'static BodyFamily<3>,
    placement: Placement,
    n: usize,
    retired: &mut BTreeSet<(&'static str, &'static str)>,
) -> Cell {
    let entrants: Vec<&Contender> = CONTENDERS
        .iter()
        .filter(|c| plan.includes(c.id))
        .filter(|c| n <= c.largest && !retired.contains(&(family.id, c.id)))
        .collect();
    let mut cell = Cell {
        family: family.id.to_owned(),
        placement: placement.id.to_owned(),
        n,
        questions: 0,
        entries: entrants.iter().map(|c| Entry::new(c.id)).collect(),
    };
    for instance in 0..part.questions {
        let seed = seed::seed_of(plan.seed, &format!("{}/n={n}/{instance}", family.id));
        let Some(question) = Question::about(family.generate(n, seed), placement, seed) else { continue };
        cell.questions += 1;
        let mut works: Vec<(&mut Entry, Work, usize)> = Vec::new();
        for (entry, contender) in cell.entries.iter_mut().zip(&entrants) {
            let is_slow = entry.samples_ns.iter().flatten().any(|&ns| ns > SLOW.as_nanos() as f64);
            let work = Some(()).filter(|()| !is_slow || entry.asked < FEW_QUESTIONS);
            let Some(mut work) = work.and_then(|()| (contender.prepare)(&question)) else {
                entry.samples_ns.push(Vec::new());
                continue;
            };
            entry.asked += 1;
            let start = Instant::now();
            let mut answer = work();
            let mut once = start.elapsed();
            if once <= LONG {
                let start = Instant::now();
                answer = work();
                once = start.elapsed();
            }
            match answer {
                Answer::Nothing => {}
                Answer::Failed => entry.failed += 1,
                Answer::Member(member) => entry.wrong += u32::from(member != question.is_member()),
            }
            if once > PATIENCE {
                retired.insert((family.id, contender.id));
            }
            let batch = (SHORTEST_SAMPLE.as_nanos() / once.as_nanos().max(1)) as usize + 1;
            let first = if once > LONG { vec![nanoseconds(once, 1)] } else { Vec::new() };
            entry.samples_ns.push(first);
            works.push((entry, work, batch));
        }
        for repetition in 0..plan.repetitions {
            let count = works.len();
            for turn in 0..count {
                let (entry, work, batch) = &mut works[(turn + repetition) % count];
                let samples = entry.samples_ns.last_mut().expect("every work that is run has its list");
                if samples.first().is_some_and(|&ns| ns > LONG.as_nanos() as f64) {
                    continue;
                }
                // what ran in between has taken the caches and the branch predictors
                black_box(work());
                let start = Instant::now();
                for _ in 0..*batch {
                    black_box(work());
                }
                samples.push(nanoseconds(start.elapsed(), *batch));
            }
        }
    }
    cell
}

/// Nanoseconds a call, in tenths.
fn nanoseconds(elapsed: Duration, calls: usize) -> f64 {
    (elapsed.as_nanos() as f64 / calls as f64 * 10.0).round() / 10.0
}
