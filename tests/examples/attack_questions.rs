//! An attack by random questions: fresh ones of every kind and population are asked until the time is over, every
//! answer is given to the verifier, and each kind's slowest question stands beside its median.
//!
//! `cargo run --release -p tests --example attack_questions -- SECONDS SEED [KIND]` asks for so many seconds in all,
//! the questions of a seed in a fixed order. An answer that the verifier does not accept, and a panic, is printed with
//! its question, and the program ends with 1 after all kinds have been asked. Every find becomes a test.

use std::env;
use std::panic::{self, AssertUnwindSafe};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use batch::KINDS;
use serde_json::Value;
use tests::dice::Dice;
use tests::judged::{Judged, judge};
use tests::questions::{Population, neighbour, question};

/// The findings of a kind and population.
#[derive(Default)]
struct Found {
    /// Milliseconds and text of each question that was asked, its answer and the check together.
    asked: Vec<(f64, String)>,
    refused: usize,
    faults: Vec<String>,
}

impl Found {
    fn ask(&mut self, question: &Value) {
        let start = Instant::now();
        let judged = panic::catch_unwind(AssertUnwindSafe(|| judge(question)));
        let time = start.elapsed().as_secs_f64() * 1e3;
        match judged {
            Ok(Ok(Judged::Verified)) => {}
            Ok(Ok(Judged::Refused)) => self.refused += 1,
            Ok(Err(fault)) => self.faults.push(fault),
            Err(_) => self.faults.push(format!("a panic: {question}")),
        }
        self.asked.push((time, question.to_string()));
    }

    /// Prints a line of counts, the slowest question and the faults.
    fn print(&mut self, title: &str) {
        self.asked.sort_by(|a, b| a.0.total_cmp(&b.0));
        let count = self.asked.len();
        let Some((slowest, text)) = self.asked.last() else { return };
        let median = self.asked[count / 2].0;
        println!(
            "{title}: {count} asked, {} refused, {} faults, median {median:.3} ms, slowest {slowest:.1} ms",
            self.refused,
            self.faults.len()
        );
        println!("    slowest: {text}");
        for fault in &self.faults {
            println!("    FAULT {fault}");
        }
    }
}

fn main() -> ExitCode {
    let mut arguments = env::args().skip(1);
    let mut number = |name: &str| -> u64 {
        arguments.next().and_then(|text| text.parse().ok()).unwrap_or_else(|| panic!("{name} is a whole number"))
    };
    let (seconds, seed) = (number("SECONDS"), number("SEED"));
    let chosen = arguments.next();
    let kinds: Vec<_> = KINDS.iter().filter(|kind| chosen.as_ref().is_none_or(|name| name == kind.name)).collect();
    let populations = [
        (Population::Ordinary, "ordinary numbers"),
        (Population::AnySize, "numbers of any size"),
        (Population::NearTies, "near ties"),
    ];
    let share = Duration::from_secs(seconds) / (kinds.len() * populations.len()).max(1) as u32;
    let (mut asked, mut faults) = (0, 0);
    for (place, kind) in (0_u64..).zip(kinds) {
        for (population, name) in populations {
            let (mut dice, start) = (Dice::new((seed << 32) + place), Instant::now());
            let mut found = Found::default();
            while start.elapsed() < share {
                let id = format!("{} {}", kind.name, found.asked.len());
                let question = question(&mut dice, population, kind.name, &id);
                found.ask(&question);
                found.ask(&neighbour(&mut dice, &question));
            }
            found.print(&format!("{}, {name}", kind.name));
            asked += found.asked.len();
            faults += found.faults.len();
        }
    }
    println!("{asked} questions, {faults} faults");
    if faults == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
