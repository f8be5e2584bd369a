//! Runs and batches in parts, and the parts put together.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use crate::run;

const CONFIG: &str = "[experiment.hull-scaling]\nfamilies = [\"disc\", \"circle\"]\nsizes = [8, 16]\ninstances = 2\n\
                      repetitions = 1\n";

/// Does shard `index` of `count` of the run that [`CONFIG`] describes.
fn shard(folder: &Path, out: &str, index: usize, count: usize, more: &[&str]) -> crate::Outcome {
    let name = format!("{index}/{count}");
    run(folder, &[&["reproduce", "--config", "my.toml", "--out", out, "--shard", &name][..], more].concat())
}

/// The deterministic files of a run with their hashes.
fn deterministic(run: &Path) -> Vec<(String, String)> {
    let manifest = fs::read_to_string(run.join("manifest.json")).expect("a run that is complete");
    let manifest: serde_json::Value = serde_json::from_str(&manifest).expect("JSON");
    let files = manifest["outputs"].as_array().expect("files").iter().filter(|file| file["deterministic"] == true);
    files.map(|file| (file["path"].to_string(), file["sha256"].to_string())).collect()
}

#[test]
fn shards_of_a_run_make_the_bytes_of_one_run_whatever_is_killed_and_done_again() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("my.toml"), CONFIG).expect("written");
    let one = run(folder, &["reproduce", "--config", "my.toml", "--out", "one"]);
    assert_eq!(one.status, 0, "{}", one.stderr);

    for delay in [0, 3, 10, 30, 60] {
        let words = ["reproduce", "--config", "my.toml", "--out", "parts", "--shard", "1/3"];
        let mut killed = Command::new(env!("CARGO_BIN_EXE_zonobench"))
            .args(words)
            .current_dir(folder)
            .stderr(Stdio::null())
            .spawn()
            .expect("the program starts");
        sleep(Duration::from_millis(delay));
        killed.kill().and_then(|()| killed.wait()).expect("it ends");
        let left = fs::read_dir(folder.join("parts")).into_iter().flatten().map(|entry| entry.expect("listed").path());
        for file in left.filter(|file| file.extension().is_some_and(|extension| extension == "shard")) {
            let text = fs::read_to_string(&file).expect("readable");
            assert!(text.ends_with("}\n") && text.contains("\"count\""), "a shard that is there is whole");
        }
    }
    for index in 0..3 {
        let done = shard(folder, "parts", index, 3, &["--threads", "1"]);
        assert_eq!((done.status, done.stdout.as_str()), (0, ""), "{}", done.stderr);
    }
    let file = folder.join("parts/reproduce.1-of-3.shard");
    let text = fs::read_to_string(&file).expect("written");
    let again = shard(folder, "parts", 1, 3, &[]);
    assert!(again.status == 0 && again.stderr.contains("is there already"), "{}", again.stderr);
    assert_eq!(fs::read_to_string(&file).expect("written"), text);
    assert_eq!(fs::read_dir(folder.join("parts")).expect("listed").count(), 3, "shards and nothing else");

    let merged = run(folder, &["merge", "parts", "--out", "two"]);
    assert_eq!(merged.status, 0, "{}", merged.stderr);
    assert_eq!(merged.stdout.replace("two/", "one/"), one.stdout);
    let [first, second] = ["one", "two"].map(|run| deterministic(&folder.join(run)));
    assert!(first.len() >= 3 && first == second, "{first:?} {second:?}");
    let environment = fs::read_to_string(folder.join("two/records/environment.json")).expect("written");
    assert!(environment.contains("\"times\""), "{environment}");
    let refused = run(folder, &["merge", "parts", "--out", "two"]);
    assert!(refused.status == 1 && refused.stderr.contains("is not empty"), "{}", refused.stderr);
}

#[test]
fn shards_that_do_not_belong_together_are_refused_by_name() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("my.toml"), CONFIG).expect("written");
    let refused = |words: &[&str], complaint: &str| {
        let outcome = run(folder, words);
        assert!(outcome.status > 0 && outcome.stderr.contains(complaint), "{words:?}: {}", outcome.stderr);
    };
    refused(&["reproduce", "--shard", "3/3"], "there is no shard 3 of 3: they are numbered from 0 to 2");
    refused(&["reproduce", "--shard", "3"], "a shard is i/n");
    refused(&["merge", "lost"], "lost: cannot be read");
    fs::create_dir(folder.join("empty")).expect("a folder");
    refused(&["merge", "empty"], "empty: no shard is there");
    assert_eq!(shard(folder, "a", 0, 3, &[]).status, 0);
    refused(&["merge", "a", "--out", "r"], "2 shards are missing: 1/3, 2/3");
    assert_eq!(shard(folder, "a", 1, 3, &[]).status, 0);
    refused(&["merge", "a", "--out", "r"], "1 shard is missing: 2/3");

    for (out, count, more, difference) in [
        ("seed", 3, &["--seed", "7"][..], "its seed is 7, not 2003"),
        ("profile", 3, &["--profile", "full"], "its profile is \"full\", not \"quick\""),
        ("count", 4, &[], "its number of shards is 4, not 3"),
    ] {
        assert_eq!(shard(folder, out, 2, count, more).status, 0);
        let runs = format!("2 as a/reproduce.0-of-3.shard; 1 as {out}/reproduce.2-of-{count}.shard: {difference}");
        // whichever was found first, the larger group is told first
        for folders in [["a", out], [out, "a"]] {
            let words = [&["merge"][..], &folders, &["--out", "r"]].concat();
            refused(&words, &format!("the shards are of 2 runs: {runs}"));
        }
    }
    let interrupted = folder.join("left/reproduce.2-of-3.unfinished");
    fs::create_dir_all(&interrupted).expect("a folder");
    let of_seed_7 = fs::read_to_string(folder.join("seed/reproduce.2-of-3.shard")).expect("written");
    fs::write(interrupted.join("work.json"), of_seed_7.lines().next().expect("a heading")).expect("written");
    fs::write(interrupted.join("reproduce.unfinished"), "").expect("written");
    let kept = shard(folder, "left", 2, 3, &[]);
    let complaint =
        "left/reproduce.2-of-3.unfinished: belongs to another run than the one asked for: its seed is 7, not";
    assert!(kept.status == 1 && kept.stderr.contains(complaint), "{}", kept.stderr);
    assert_eq!(shard(folder, "left", 2, 3, &["--force"]).status, 0);

    let file = folder.join("a/reproduce.1-of-3.shard");
    let text = fs::read_to_string(&file).expect("written");
    fs::write(&file, text.replacen("\"version\":\"", "\"version\":\"9", 1)).expect("written");
    refused(&["merge", "a", "--out", "r"], "its version is 9");
    for torn in [&text[..text.len() - 1], text.split_inclusive('\n').next().expect("a heading"), "", "{}"] {
        fs::write(&file, torn).expect("written");
        refused(&["merge", "a", "--out", "r"], "a/reproduce.1-of-3.shard: is no shard");
        let again = shard(folder, "a", 1, 3, &[]);
        assert!(again.status == 1 && again.stderr.contains("is no shard"), "{}", again.stderr);
    }
    fs::write(&file, text.replacen("\"count\":{", "\"count\": {", 1)).expect("written");
    refused(&["merge", "a", "--out", "r"], "its lines are not those that were written");
    fs::write(&file, &text).expect("written");
    fs::create_dir(folder.join("b")).expect("a folder");
    fs::copy(&file, folder.join("b/reproduce.1-of-3.shard")).expect("copied");
    refused(&["merge", "a", "b", "--out", "r"], "b/reproduce.1-of-3.shard: are the same shard");

    fs::write(folder.join("my.toml"), CONFIG.replace("instances = 2", "instances = 1")).expect("written");
    let done = shard(folder, "a", 1, 3, &[]);
    assert!(done.status == 1 && done.stderr.contains("its content of the config is"), "{}", done.stderr);
    fs::remove_file(folder.join("b/reproduce.1-of-3.shard")).expect("removed");
    fs::write(folder.join("my.toml"), CONFIG).expect("written");
    assert_eq!(shard(folder, "a", 2, 3, &[]).status, 0);
    fs::write(folder.join("my.toml"), CONFIG.replace("instances = 2", "instances = 1")).expect("written");
    refused(&["merge", "a", "--out", "r"], "its content of the config is");
    assert!(!folder.join("r").exists());
}

#[test]
fn shards_of_a_batch_make_the_answers_of_one_run() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let question = |n: usize| format!(r#"{{"id":{n},"kind":"min_area","input":{{"points":[[0,0],[{n},0],[0,2]]}}}}"#);
    let questions: String = (1..=20).map(|n| question(n) + if n % 5 == 0 { "\n\nnonsense\n" } else { "\n" }).collect();
    fs::write(folder.join("q.jsonl"), &questions).expect("written");
    let one = run(folder, &["solve", "q.jsonl"]);
    for index in 0..4 {
        let name = format!("{index}/4");
        let done = run(folder, &["solve", "q.jsonl", "--shard", &name, "--out", "parts"]);
        assert_eq!((done.status, done.stdout.as_str()), (0, ""), "{}", done.stderr);
    }
    assert_eq!(one.stdout.lines().count(), 24);
    assert_eq!(run(folder, &["merge", "parts"]).stdout, one.stdout);
    assert_eq!(run(folder, &["merge", "parts", "--out", "a.jsonl"]).status, 0);
    assert_eq!(fs::read_to_string(folder.join("a.jsonl")).expect("written"), one.stdout);
    let kept = run(folder, &["merge", "parts", "--out", "a.jsonl"]);
    assert!(kept.status == 1 && kept.stderr.contains("exists already"), "{}", kept.stderr);

    fs::write(folder.join("q.jsonl"), questions.replace("[0,2]", "[0,3]")).expect("written");
    let other = run(folder, &["solve", "q.jsonl", "--shard", "0/4", "--out", "parts"]);
    assert!(other.status == 1 && other.stderr.contains("its questions is "), "{}", other.stderr);
    let piped = run(folder, &["solve", "-", "--shard", "0/4", "--out", "parts"]);
    assert_eq!(piped.status, 2, "{}", piped.stderr);
    assert_eq!(run(folder, &["solve", "--shard", "0/4"]).status, 2);
    let strict = run(folder, &["solve", "q.jsonl", "--shard", "0/1", "--out", "whole", "--strict"]);
    assert_eq!(strict.status, 1, "{}", strict.stderr);
}
