//! The chapters, one file each.

mod duality;
mod faces;
mod intersection;
mod kernel;
mod min_area_zonogon;
mod reduction;
mod repeated_tests;
mod total_length;

use super::chapter::Chapter;

/// Every chapter, in the order of the report.
pub static CHAPTERS: &[&Chapter] = &[
    &faces::CHAPTER,
    &duality::CHAPTER,
    &reduction::CHAPTER,
    &min_area_zonogon::CHAPTER,
    &kernel::CHAPTER,
    &total_length::CHAPTER,
    &intersection::CHAPTER,
    &repeated_tests::CHAPTER,
];

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn claims_resolve_and_belong_to_one_chapter() {
        let mut seen = BTreeSet::new();
        for chapter in CHAPTERS {
            for claim in chapter.claims {
                assert!(paper_checks::catalog::find(claim).is_some(), "{}: {claim}", chapter.id);
                assert!(seen.insert(claim), "{claim} is in two chapters");
            }
        }
    }

    #[test]
    fn experiments_resolve_and_belong_to_one_chapter() {
        let mut seen = BTreeSet::new();
        for chapter in CHAPTERS {
            for experiment in chapter.experiments {
                assert!(experiments::catalog::find(experiment).is_some(), "{}: {experiment}", chapter.id);
                assert!(seen.insert(experiment), "{experiment} is in two chapters");
            }
        }
    }

    #[test]
    fn commands_are_understood() {
        use clap::Parser;
        for (command, _) in CHAPTERS.iter().flat_map(|chapter| chapter.commands) {
            let (_, arguments) =
                command.split_once("cargo run --release -- ").expect("the way to run it in a checkout");
            let words: Vec<&str> = arguments.split_whitespace().collect();
            assert!(crate::cli::Cli::try_parse_from(["zonobench"].iter().chain(&words)).is_ok(), "{command}");
            let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
            let mut files = words.iter().filter(|word| word.contains('/'));
            assert!(files.all(|file| root.join(file).is_file()), "{command}");
        }
    }
}
