//! Random questions of every kind and population, one line of JSON each: what a program that answers for hours is fed.
//!
//! `cargo run --release -p tests --example print_questions -- COUNT SEED` prints so many, the same ones for a seed.

use std::io::{self, BufWriter, Write};

use batch::KINDS;
use tests::dice::Dice;
use tests::questions::{Population, question};

fn main() -> io::Result<()> {
    let mut arguments = std::env::args().skip(1);
    let mut number = |name: &str| -> u64 {
        arguments.next().and_then(|text| text.parse().ok()).unwrap_or_else(|| panic!("{name} is a whole number"))
    };
    let (count, seed) = (number("COUNT"), number("SEED"));
    let mut dice = Dice::new(seed);
    let mut out = BufWriter::new(io::stdout().lock());
    for place in 0..count {
        let population =
            *dice.choose(&[Population::Ordinary, Population::Ordinary, Population::AnySize, Population::NearTies]);
        let kind = dice.choose(KINDS).name;
        writeln!(out, "{}", question(&mut dice, population, kind, &place.to_string()))?;
    }
    out.flush()
}
