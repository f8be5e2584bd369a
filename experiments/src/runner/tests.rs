use super::*;
use crate::definition::{Case, Measurement, PerProfile, Profile, Tabulated, TimedWork, Timing, Variant, Verdict};
use crate::record::{CountOutcome, CountRow, TimeOutcome};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Sums coordinates; `wrong` says so, `panics` panics, `fails` returns an error, `drifts` times another answer.
static TOY: Experiment = Experiment {
    id: "toy",
    title: "Toy",
    question: "Nothing.",
    claims: &[],
    families: &["disc", "gaussian"],
    refuses: |_| None,
    only_full: &[],
    real_inputs: &["croatia"],
    sizes: PerProfile { quick: &[4, 8, 16], full: &[4, 8, 16, 32] },
    instances: PerProfile { quick: 2, full: 3 },
    variants: &[
        variant("right", 1000),
        variant("wrong", 8),
        variant("panics", 4),
        variant("fails", 4),
        variant("drifts", 4),
    ],
    measure,
    table: Tabulated::MedianAtLargest,
    timing: Some(Timing { sizes: PerProfile::both(&[4, 8]), repetitions: PerProfile { quick: 2, full: 3 }, prepare }),
    fits: &[],
};

const fn variant(id: &'static str, largest: usize) -> Variant {
    Variant { id, title: id, largest: PerProfile::both(largest) }
}

fn answer(case: &Case) -> Result<u64, String> {
    let points = case.points()?;
    Ok(crate::seed::Digest::default().word(case.seed).floats(points.as_flattened()).finish())
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let verdict = match case.variant {
        "wrong" => Verdict::Wrong("off by one".to_owned()),
        "panics" => panic!("toy panic at n = {}", case.n),
        "fails" => return Err("toy error".to_owned()),
        _ => Verdict::Correct("by definition".to_owned()),
    };
    Ok(Measurement {
        counts: BTreeMap::from([("steps".to_owned(), case.n as u64)]),
        values: BTreeMap::from([("third".to_owned(), 1.0 / 3.0)]),
        digest: answer(case)?,
        verdict,
    })
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    let digest = answer(case)? ^ u64::from(case.variant == "drifts");
    Ok(Box::new(move |stopwatch| Ok(stopwatch.lap("total", || digest))))
}

fn options(directory: Option<&Path>, threads: usize) -> RunOptions {
    RunOptions {
        profile: Profile::Quick,
        seed: 42,
        threads,
        directory: directory.map(Path::to_path_buf),
        times: true,
        own_inputs: String::new(),
        shard: None,
    }
}

/// Counts steps, to see what a resumed run does again.
#[derive(Default)]
struct Steps(AtomicUsize);

impl Progress for Steps {
    fn phase(&self, _: &str, _: usize, _: usize) {}
    fn step(&self, _: &str) {
        self.0.fetch_add(1, Ordering::Relaxed);
    }
}

fn text(directory: &Path, name: &str) -> String {
    fs::read_to_string(directory.join(name)).expect("the run wrote it")
}

#[test]
fn counts_are_the_same_bytes_whatever_the_threads() {
    let texts = [1, 2, 5].map(|threads| {
        let directory = tempfile::tempdir().expect("a temporary directory");
        run(&[&TOY], &options(Some(directory.path()), threads), &()).expect("room");
        text(directory.path(), "counts.jsonl")
    });
    assert_eq!(texts[0], texts[1]);
    assert_eq!(texts[0], texts[2]);
    // croatia: right; families: 3 sizes right, 2 wrong, 1 each of the others, times 2 instances, times 2 families.
    assert_eq!(texts[0].lines().count(), 1 + (3 + 2 + 3) * 2 * 2);
    let another = run(&[&TOY], &RunOptions { seed: 43, ..options(None, 1) }, &()).expect("no files");
    assert_ne!(journal::json_lines(&another.counts).expect("json"), texts[0]);
}

#[test]
fn failures_and_panics_become_rows() {
    let records = run(&[&TOY], &options(None, 2), &()).expect("no files");
    let fault = |id: &str| {
        let row = records.counts.iter().find(|row| row.key.case == id).expect("a row for every case");
        row.fault().map(str::to_owned)
    };
    assert_eq!(fault("toy/disc/right/n=4/0"), None);
    assert_eq!(fault("toy/disc/wrong/n=4/0").as_deref(), Some("off by one"));
    assert_eq!(fault("toy/disc/panics/n=4/1").as_deref(), Some("panicked: toy panic at n = 4"));
    assert_eq!(fault("toy/gaussian/fails/n=4/0").as_deref(), Some("toy error"));
}

#[test]
fn wrong_and_drifting_answers_void_their_times() {
    let records = run(&[&TOY], &options(None, 1), &()).expect("no files");
    // Timed: croatia and n = 4, 8, instance 0 only, two repetitions.
    assert_eq!(records.times.len(), (1 + 2 * (2 + 2 + 3)) * 2);
    for row in &records.times {
        match row.key.variant.as_str() {
            "right" => assert!(row.lap_ns("total").is_some()),
            "wrong" => {
                assert!(matches!(&row.outcome, TimeOutcome::Void { reason, .. } if reason == "off by one"));
            }
            "drifts" => {
                assert!(matches!(&row.outcome, TimeOutcome::Void { reason, .. } if reason.contains("counted run")));
            }
            _ => assert!(matches!(&row.outcome, TimeOutcome::Void { .. })),
        }
    }
}

#[test]
fn a_killed_run_continues_where_it_was_torn() {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let options = options(Some(directory.path()), 1);
    run(&[&TOY], &options, &()).expect("room");
    let (whole, times) = (text(directory.path(), "counts.jsonl"), text(directory.path(), "times.jsonl"));
    assert!(!directory.path().join("counts.jsonl.partial").exists());

    // As a kill in the middle of the eleventh row leaves it: ten rows in any order, a torn one, no final file.
    let header = header(&[&TOY], &options, &Environment::current());
    let rows: Vec<&str> = whole.lines().collect();
    let ten: Vec<&str> = rows[5..15].iter().rev().copied().collect();
    let torn = format!("{header}\n{}\n{}", ten.join("\n"), &rows[20][..rows[20].len() / 2]);
    fs::write(directory.path().join("counts.jsonl.partial"), torn).expect("room");
    fs::remove_file(directory.path().join("counts.jsonl")).expect("it exists");

    let steps = Steps::default();
    run(&[&TOY], &options, &steps).expect("room");
    assert_eq!(text(directory.path(), "counts.jsonl"), whole);
    let timed_groups = 5;
    assert_eq!(steps.0.load(Ordering::Relaxed), rows.len() - 10 + timed_groups);

    // Times of the first group are kept to the nanosecond, a torn group is measured again.
    let rows: Vec<&str> = times.lines().collect();
    let torn = format!("{header}\n{}\n{}\n", rows[0..2].join("\n"), rows[2]);
    fs::write(directory.path().join("times.jsonl.partial"), torn).expect("room");
    fs::write(directory.path().join("counts.jsonl.partial"), format!("{header}\n{whole}")).expect("room");
    let steps = Steps::default();
    run(&[&TOY], &options, &steps).expect("room");
    assert_eq!(steps.0.load(Ordering::Relaxed), timed_groups - 1);
    let resumed = text(directory.path(), "times.jsonl");
    assert_eq!(resumed.lines().take(2).collect::<Vec<_>>(), rows[0..2]);
    assert_eq!(resumed.lines().count(), rows.len());
}

#[test]
fn rows_of_another_seed_are_not_kept() {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let options = options(Some(directory.path()), 1);
    let stale = header(&[&TOY], &RunOptions { seed: 1, ..options.clone() }, &Environment::current());
    fs::write(directory.path().join("counts.jsonl.partial"), format!("{stale}\n")).expect("room");
    let records = run(&[&TOY], &options, &()).expect("room");
    assert_eq!(
        records,
        Records {
            times: records.times.clone(),
            ..run(&[&TOY], &RunOptions { directory: None, ..options }, &()).expect("no files")
        }
    );
}

#[test]
fn rows_survive_a_round_trip_through_their_file() {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let records = run(&[&TOY], &options(Some(directory.path()), 1), &()).expect("room");
    let read: Vec<CountRow> =
        text(directory.path(), "counts.jsonl").lines().map(|line| serde_json::from_str(line).expect("a row")).collect();
    assert_eq!(read, records.counts);
    assert!(matches!(&read[0].outcome, CountOutcome::Measured { values, .. } if values["third"] == 1.0 / 3.0));
}

#[test]
fn shards_have_each_case_once_and_make_the_whole_run() {
    let folder = tempfile::tempdir().expect("a temporary directory");
    let whole = run(&[&TOY], &options(Some(&folder.path().join("whole")), 2), &()).expect("room");
    for count in [1, 3, 16, 40] {
        let shards: Vec<Records> = (0..count)
            .map(|index| {
                let shard = Some(crate::sharing::Shard::new(index, count).expect("a shard"));
                run(&[&TOY], &RunOptions { shard, ..options(None, 1) }, &()).expect("room")
            })
            .collect();
        assert_eq!(shards.iter().map(|shard| shard.counts.len()).sum::<usize>(), whole.counts.len());
        let together = folder.path().join(count.to_string());
        let merged = put_together(&[&TOY], &options(Some(&together), 1), shards.clone()).expect("room");
        assert_eq!((&merged.counts, merged.times.len()), (&whole.counts, whole.times.len()));
        let read = |folder: &Path| fs::read_to_string(folder.join("counts.jsonl")).expect("written");
        assert_eq!(read(&together), read(&folder.path().join("whole")));
        if count == 3 {
            let refused = put_together(&[&TOY], &options(None, 1), shards[1..].to_vec()).expect_err("one is missing");
            assert!(matches!(refused, RunError::Missing { .. }), "{refused}");
        }
    }
}
