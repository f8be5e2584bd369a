use super::*;
use crate::catalog::EXPERIMENTS;
use crate::definition::{Case, Measurement, Quantity, Verdict};
use crate::environment::Environment;
use crate::record::CountRow;
use crate::runner::Records;
use std::collections::BTreeSet;
use std::path::Path;
use zonotope::tally::OperationCounts;

/// Words of a sentence that states how something grows or compares, and so what was found.
const RESULT_WORDS: [&str; 34] = [
    "grow",
    "grows",
    "grew",
    "fall",
    "falls",
    "rise",
    "rises",
    "faster",
    "slower",
    "quicker",
    "ahead",
    "behind",
    "never",
    "always",
    "hardly",
    "nearly",
    "far",
    "twice",
    "half",
    "dozen",
    "bounded",
    "within",
    "below",
    "above",
    "quadratic",
    "linear",
    "constant",
    "most",
    "least",
    "best",
    "worst",
    "wrong",
    "agree",
    "agrees",
];

/// Sentences of a question that define, though they have such a word: what is defined, and the word.
fn is_definition(sentence: &str, word: &str) -> bool {
    match word {
        "linear" => sentence.contains("linear program"),
        "least" | "within" => sentence.contains("least total length") || sentence.contains("is the first round"),
        "best" | "far" => sentence.contains("zonotope so far"),
        "wrong" => sentence.contains("fail openly instead"),
        _ => false,
    }
}

/// The sentences of a text; a dot within a number ends none.
fn sentences(text: &str) -> impl Iterator<Item = &str> {
    let is_end = |&(at, mark): &(usize, &str)| text[at + mark.len()..].chars().next().is_none_or(char::is_whitespace);
    let ends = text.match_indices(['.', '?']).filter(is_end).map(|(at, mark)| at + mark.len());
    let mut begin = 0;
    ends.map(move |end| text[std::mem::replace(&mut begin, end)..end].trim())
}

/// The text without what stands between backticks, which are names.
fn without_code(text: &str) -> String {
    text.split('`').step_by(2).collect::<Vec<_>>().join(" ")
}

/// A result that stands in a static text is held by nothing, and stays when the records change.
#[test]
fn texts_of_experiments_ask_and_define_and_state_no_result() {
    for experiment in EXPERIMENTS {
        let first = sentences(experiment.question).next().unwrap_or_default();
        assert!(first.ends_with('?'), "{}: the text does not begin with its question: {first}", experiment.id);
        let text = without_code(experiment.question);
        for sentence in sentences(&text).filter(|sentence| !sentence.ends_with('?')) {
            assert!(!sentence.contains("O("), "{}: a law: {sentence}", experiment.id);
            for word in sentence.split(|c: char| !c.is_alphabetic()) {
                let is_result = RESULT_WORDS.contains(&word) && !is_definition(sentence, word);
                assert!(!is_result, "{}: “{word}” states a result: {sentence}", experiment.id);
            }
        }
    }
}

/// A number of a text, such as the size of the bodies, is the one that the definition works with.
#[test]
fn numbers_in_texts_of_experiments_are_those_of_their_definitions() {
    let sources = crate_sources();
    for experiment in EXPERIMENTS {
        let quoted = format!("id: \"{}\"", experiment.id);
        let source = sources.iter().find(|source| source.contains(&quoted)).expect("each experiment has a file");
        let (before, after) = source.split_once("    question: \"").expect("it has a question");
        let (_, after) = after.split_once("\",\n").expect("the question ends");
        let shared = sources.iter().filter(|source| source.contains("pub static PLACEMENTS")).cloned();
        let rest = [before.to_owned(), after.to_owned()].into_iter().chain(shared).collect::<String>();
        let known: BTreeSet<String> = rest.split(|c: char| !is_of_number(c)).filter_map(plain_number).collect();
        let text = without_code(experiment.question);
        for number in text.split(|c: char| !is_of_number(c)).filter_map(plain_number) {
            let is_small = number.parse().is_ok_and(|value: f64| value < 4.0 && value.fract() == 0.0);
            let of_claim = |claim: &&str| claim.rsplit('-').next() == Some(number.as_str());
            let is_of_formula = number == "2.0" || is_small || experiment.claims.iter().any(of_claim);
            assert!(is_of_formula || known.contains(&number), "{}: {number} is not its definition's", experiment.id);
        }
    }
}

fn is_of_number(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '.' | ',' | '_' | '-')
}

/// A number as it is written in a text or in code, without separators; none for other words.
fn plain_number(word: &str) -> Option<String> {
    let word = word.trim_matches(|c: char| !c.is_alphanumeric());
    let starts = word.rsplit('_').next().filter(|last| last.contains("e-")).unwrap_or(word);
    let digits: String = starts.chars().filter(|c| !matches!(c, ',' | '_')).collect();
    digits.parse::<f64>().ok().map(|_| digits.trim_end_matches(".0").to_owned())
}

/// The files of experiments and of what they ask.
fn crate_sources() -> Vec<String> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let folders = [source.join("definitions"), source.join("question")];
    let files = folders.iter().flat_map(|folder| std::fs::read_dir(folder).expect("the folder is there"));
    files.map(|file| std::fs::read_to_string(file.expect("it can be read").path()).expect("it is text")).collect()
}

#[test]
fn sentences_belong_to_experiments() {
    let mut seen = BTreeSet::new();
    for findings in FINDINGS.iter().copied().flatten() {
        let experiment = crate::catalog::find(findings.experiment);
        assert!(experiment.is_some() && seen.insert(findings.experiment), "{}", findings.experiment);
        assert!(findings.timed.is_empty() || experiment.is_some_and(|found| found.timing.is_some()));
    }
}

fn row(family: &'static str, method: &'static str, n: usize, reads: f64) -> CountRow {
    let case = Case::new(1, "direction-tree-queries", family, method, n, 0);
    let right = Verdict::Correct("checked".to_owned());
    CountRow::new(&case, Ok(Measurement::new(&OperationCounts::default(), 0, right).with_value("reads", reads)))
}

/// The sentence on √n says what the records say of it, on each family: about 20 √n here, and more than the kernel reads
/// there.
#[test]
fn sentences_say_what_the_records_say() {
    let counts = vec![
        row("random_bodies", "by_direction_tree", 1024, 640.0),
        row("random_bodies", "by_direction_tree", 4096, 1280.0),
        row("random_bodies", "by_lad", 4096, 5120.0),
        row("near_plane_bodies", "by_direction_tree", 4096, 12288.0),
        row("near_plane_bodies", "by_lad", 4096, 4096.0),
    ];
    let records = Records { counts, times: Vec::new(), environment: Environment::current(), elsewhere: Vec::new() };
    let said = counted("direction-tree-queries", &Measured::of(&records));
    assert_eq!(
        said,
        [
            "The number of reads of a query over √n is 20 at n = 1\u{202f}024 and 20 at n = 4\u{202f}096 on random \
             bodies; 192 at n = 4\u{202f}096 on near plane bodies.",
            "Reads of “Tree over directions” over those of “Kernel without a tree”: 0.250 at n = 4\u{202f}096 on \
             random bodies; 3 at n = 4\u{202f}096 on near plane bodies.",
        ]
    );
    assert!(counted("hull-scaling", &Measured::of(&records)).is_empty());
    assert_eq!(words::title("wrong-answers", "by_gjk"), "Our GJK in floating point");
    let wrong = words::span(&Measured::of(&records), "x", ["hull-scaling", "a"], Quantity::AllCounts, words::plain);
    assert_eq!(wrong, None);
}

/// Such a sentence goes on with "is": its subject is a noun in the singular with its article.
#[test]
fn sentences_about_one_quantity_begin_with_its_noun() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/findings");
    let mut seen = 0;
    for file in ["collision.rs", "lengths.rs", "plane.rs", "repeated.rs"] {
        let source = std::fs::read_to_string(folder.join(file)).expect("the file is there");
        for form in ["span(found, ", "course(found, "] {
            for (at, _) in source.match_indices(form) {
                let what = &source[at + form.len()..];
                assert!(what.starts_with("\"The ") || what.starts_with("&what"), "{file}: {}", &what[..20]);
                seen += 1;
            }
        }
    }
    assert!(seen > 20, "{seen} sentences are a part of them");
}
