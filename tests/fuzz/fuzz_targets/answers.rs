//! The verifier: answers of which some bytes are changed are judged without a panic, whatever they have become.
#![no_main]

use batch::KINDS;
use batch::check;
use batch::json::{MAX_VALUES, read};
use libfuzzer_sys::fuzz_target;
use tests::dice::Dice;
use tests::judged::{answered, tree};
use tests::questions::{Population, question};

fuzz_target!(|bytes: &[u8]| {
    let [kind, seed, edits @ ..] = bytes else { return };
    let kind = &KINDS[usize::from(*kind) % KINDS.len()];
    let asked = question(&mut Dice::new(u64::from(*seed)), Population::Ordinary, kind.name, "fuzz");
    let mut answer = answered(&asked).to_string().into_bytes();
    // three bytes an edit: a place in the text, and what stands there now
    for edit in edits.chunks_exact(3) {
        let place = usize::from(u16::from_le_bytes([edit[0], edit[1]])) % answer.len();
        answer[place] = edit[2];
    }
    if let Ok(answer) = read(&answer, MAX_VALUES) {
        let _ = check(&tree(&asked), &answer);
    }
});
