//! Bodies and meshes in motion, made of the numbers that the bytes spell: the certificates verify.
#![no_main]

use libfuzzer_sys::fuzz_target;
use tests::dice::Dice;
use tests::judged::judge;
use tests::questions::{Population, question};

fuzz_target!(|bytes: &[u8]| {
    let [chosen, numbers @ ..] = bytes else { return };
    let kind = ["collide", "collide", "sweep"][usize::from(chosen % 3)];
    let population = [Population::Ordinary, Population::AnySize, Population::NearTies][usize::from(chosen / 3 % 3)];
    let asked = question(&mut Dice::of_bytes(numbers), population, kind, "fuzz");
    if let Err(fault) = judge(&asked) {
        panic!("{fault}");
    }
});
