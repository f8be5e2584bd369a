//! Runs every contender and writes the record.

use anyhow::Context;
use clap::Parser;
use experiments::environment::Environment;
use experiments::peers::{Cell, PeersRecord, tables};
use experiments::question::PLACEMENTS;
use families::bodies::BODY_FAMILIES;
use peers::line_fit;
use peers::race::{self, Part, Plan};
use std::path::PathBuf;

/// The methods of other libraries beside ours, on the same questions.
#[derive(Parser)]
#[command(name = "peers")]
struct Arguments {
    /// The file of the record.
    #[arg(long, default_value = "peers.json")]
    out: PathBuf,
    /// The seed of the questions.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Sizes of at most this many generators and points.
    #[arg(long, default_value_t = 1 << 20)]
    largest: usize,
    /// Timed samples of every contender on every question.
    #[arg(long, default_value_t = 7)]
    repetitions: usize,
    /// Only these families of bodies; all of them if none is named.
    #[arg(long)]
    family: Vec<String>,
    /// Only these methods beside the pass; all of them if none is named.
    #[arg(long)]
    method: Vec<String>,
    /// Keep the cells of the record that is there and add those of this run, in place of ones on the same questions.
    #[arg(long)]
    add: bool,
    /// Sizes of at least this many generators.
    #[arg(long, default_value_t = 0)]
    smallest: usize,
}

fn main() -> anyhow::Result<()> {
    let arguments = Arguments::parse();
    let plan = plan(&arguments);
    let mut cells = race::run(&plan, |cell| eprintln!("{} {} n = {}", cell.family, cell.placement, cell.n))?;
    let mut record = PeersRecord {
        environment: Some(Environment { host: String::new(), ..Environment::current() }),
        seed: plan.seed,
        ..PeersRecord::default()
    };
    if arguments.add {
        let text = std::fs::read_to_string(&arguments.out)
            .with_context(|| format!("cannot read {}", arguments.out.display()))?;
        let PeersRecord { cells: kept, line_fits, .. } = serde_json::from_str(&text)?;
        (record.cells, record.line_fits) = (kept, line_fits);
        let again = |old: &Cell| cells.iter().any(|new| new.is_about_the_same(old));
        record.cells.retain(|old| !again(old));
    }
    record.cells.append(&mut cells);
    let sizes = [1_000, 10_000, 100_000, 1_000_000]
        .into_iter()
        .filter(|n| (arguments.smallest..=arguments.largest).contains(n));
    for n in sizes {
        let fit = line_fit::compare(n, arguments.repetitions, plan.seed)?;
        record.line_fits.retain(|old| old.n != n);
        record.line_fits.push(fit);
    }
    record.line_fits.sort_by_key(|fit| fit.n);
    let text = serde_json::to_string(&record)?.replace("},{\"family\"", "},\n{\"family\"") + "\n";
    std::fs::write(&arguments.out, text).with_context(|| format!("cannot write {}", arguments.out.display()))?;
    for table in tables(&record) {
        println!("{}", table.markdown());
    }
    Ok(())
}

/// Many questions on small bodies, where wrong answers show; few on large ones, where time does.
fn plan(arguments: &Arguments) -> Plan {
    let families: Vec<&'static str> = BODY_FAMILIES
        .iter()
        .map(|family| family.id)
        .filter(|id| arguments.family.is_empty() || arguments.family.iter().any(|wanted| wanted == id))
        .collect();
    let every: Vec<&'static str> = PLACEMENTS.iter().map(|placement| placement.id).collect();
    let few: Vec<&'static str> =
        every.iter().copied().filter(|id| !id.ends_with("e-6") && !id.ends_with("e-12")).collect();
    let part = |sizes: &[usize], placements: &[&'static str], questions| Part {
        families: families.clone(),
        sizes: sizes.iter().copied().filter(|n| (arguments.smallest..=arguments.largest).contains(n)).collect(),
        placements: placements.to_vec(),
        questions,
    };
    Plan {
        seed: arguments.seed,
        parts: vec![
            part(&[6, 16, 64], &every, 8),
            part(&[256, 1 << 10], &every, 8),
            part(&[1 << 12, 1 << 14, 1 << 16], &few, 5),
            part(&[1 << 18, 1 << 20], &few, 1),
        ],
        repetitions: arguments.repetitions,
        methods: arguments.method.clone(),
    }
}
