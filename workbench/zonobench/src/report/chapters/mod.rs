//! The chapters, one file each.

mod bounding_volumes;
mod duality;
mod faces;
mod intersection;
mod kernel;
mod min_area_zonogon;
mod motion;
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
    &motion::CHAPTER,
    &bounding_volumes::CHAPTER,
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::chapter::{ChapterTable, Held};
    use std::collections::BTreeSet;

    /// A law as letters and digits: `n log² n` and `n log^2 n` are one.
    fn plain(law: &str) -> String {
        let spelled = law.replace('ε', "eps").replace('²', "2").replace('³', "3").replace('−', "-");
        spelled.chars().filter(|c| !c.is_whitespace() && *c != '^').collect()
    }

    /// The text between the brackets of each O( … ).
    fn laws(text: &str) -> Vec<String> {
        let text = plain(text);
        let starts = text.match_indices("O(").map(|(at, _)| at + 2);
        let law = |start: usize| {
            let mut depth = 1;
            text[start..]
                .chars()
                .take_while(|c| {
                    depth += i32::from(*c == '(') - i32::from(*c == ')');
                    depth > 0
                })
                .collect()
        };
        starts.map(law).collect()
    }

    #[test]
    fn costs_are_the_laws_that_claims_state_and_experiments_fit() {
        for chapter in CHAPTERS {
            assert!(!chapter.costs.is_empty(), "{}", chapter.id);
            for cost in chapter.costs {
                let stated = laws(cost.text);
                assert!(!stated.is_empty(), "{}: {} states no law", chapter.id, cost.text);
                match cost.held {
                    Held::Claim(id) => {
                        let claim = paper_checks::catalog::find(id).unwrap_or_else(|| panic!("there is no claim {id}"));
                        let original = laws(claim.statement);
                        for law in stated {
                            assert!(original.contains(&law), "{}: {id} states {original:?}, not {law}", cost.text);
                        }
                    }
                    Held::Fit { experiment, method, law } => {
                        let found = experiments::catalog::find(experiment);
                        let plans = found.unwrap_or_else(|| panic!("there is no experiment {experiment}")).fits;
                        let is_judged = |plan: &&experiments::definition::FitPlan| {
                            plan.variant == method && plan.bound.is_some_and(|bound| bound.model == law)
                        };
                        assert!(plans.iter().any(|plan| is_judged(&plan)), "{}: no fit says so", cost.text);
                        assert_eq!(stated, [plain(&law.to_string())], "{}", cost.text);
                    }
                }
            }
        }
    }

    /// Laws stand among the costs, and what was measured in the lesson and the findings, which are made from records.
    #[test]
    fn other_texts_of_chapters_state_no_law_and_no_measured_number() {
        for chapter in CHAPTERS {
            let words: Vec<&str> = match chapter.table {
                ChapterTable::Words { rows, .. } => rows.iter().flat_map(|row| row.iter().copied()).collect(),
                _ => Vec::new(),
            };
            for text in chapter.method.iter().copied().chain([chapter.statement, chapter.title]).chain(words) {
                let has_number = text.split(|c: char| !c.is_ascii_digit()).any(|digits| digits.len() > 1);
                let is_compared =
                    ["O(", "√", "measured", "times as", "a few times", "on average", "per cent", "million"];
                let found = is_compared.iter().find(|words| text.contains(**words));
                assert!(found.is_none() && !has_number, "{}: {found:?} in {text}", chapter.id);
            }
        }
    }

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
