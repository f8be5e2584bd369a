//! Fast motions at random and crafted ones: every proof that two bodies stay apart is given to the verifier, and each
//! answer is held to samples with a bound of how far the bodies move between them. Beside it are the collisions that
//! samples at equal steps and hulls of end poses miss on the same motions.
//!
//! `cargo run --release -p experiments --features studies --example soundness_of_motion -- 1000000 20000` asks about
//! so many random and crafted motions. A collision that is missed, or a proof that is refused, ends the program with
//! an error.

use std::process::ExitCode;
use std::time::Instant;

use experiments::moving::soundness::{RIVAL_STEPS, Tallied};
use families::motions::find;
use rayon::prelude::*;

fn main() -> ExitCode {
    let numbers = std::env::args().skip(1).map(|text| text.parse().expect("arguments are numbers of motions"));
    let counts: Vec<u64> = numbers.collect();
    let [fast, crafted] = counts[..] else { panic!("two numbers: of random motions and of crafted ones") };
    let mut is_sound = true;
    for (id, count) in [("crafted_motions", crafted), ("fast_boxes", fast)] {
        let family = find(id).expect("it is among the families");
        let start = Instant::now();
        let tallied = (0..count)
            .into_par_iter()
            .map(|seed| {
                let tallied = Tallied::of_motion(family, seed).expect("a motion of the family");
                if tallied.contradicted + tallied.refused > 0 {
                    println!("{id}, seed {seed}: {tallied:?}");
                }
                tallied
            })
            .reduce(Tallied::default, Tallied::plus);
        is_sound &= tallied.contradicted + tallied.refused == 0;
        println!("{id}, {:.0} s: {tallied:#?}", start.elapsed().as_secs_f64());
        println!("rivals: {RIVAL_STEPS} steps, and hulls of both ends of {RIVAL_STEPS} stretches");
    }
    if is_sound { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
