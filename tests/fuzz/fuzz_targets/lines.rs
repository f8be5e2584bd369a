//! The lines of a batch: any bytes are answered or refused with a code, and what is answered verifies.
#![no_main]

use batch::json::{MAX_VALUES, read};
use batch::{Line, Verdict, answer_line, check};
use libfuzzer_sys::{Corpus, fuzz_target};

fuzz_target!(|bytes: &[u8]| -> Corpus {
    let answer = answer_line(1, &Line::Content(bytes.to_vec()), 0).content;
    if let Some(error) = answer.get("error") {
        assert_ne!(error.get("code").and_then(|code| code.as_str()), Some("internal"), "{answer}");
        return Corpus::Keep;
    }
    let question = read(bytes, MAX_VALUES).expect("what is answered is JSON");
    let tree = read(answer.to_string().as_bytes(), MAX_VALUES).expect("answers are JSON");
    assert!(!matches!(check(&question, &tree), Verdict::Wrong(_)), "{answer}");
    Corpus::Keep
});
