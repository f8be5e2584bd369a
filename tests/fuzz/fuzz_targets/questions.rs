//! Questions of every kind, made of the numbers that the bytes spell: the answer verifies, or a code refuses it.
#![no_main]

use batch::KINDS;
use libfuzzer_sys::fuzz_target;
use tests::dice::Dice;
use tests::judged::judge;
use tests::questions::{Population, question};

fuzz_target!(|bytes: &[u8]| {
    let [kind, population, numbers @ ..] = bytes else { return };
    let kind = &KINDS[usize::from(*kind) % KINDS.len()];
    let population = [Population::Ordinary, Population::AnySize, Population::NearTies][usize::from(*population) % 3];
    let asked = question(&mut Dice::of_bytes(numbers), population, kind.name, "fuzz");
    if let Err(fault) = judge(&asked) {
        panic!("{fault}");
    }
});
