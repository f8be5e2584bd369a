//! Parts of `reproduce`, and figures drawn alone.

mod shards;

use std::fs;
use std::path::Path;

use crate::run;

#[test]
fn one_experiment_is_run_alone() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let outcome = run(folder.path(), &["reproduce", "--out", "r", "--only", "hull-scaling"]);
    assert_eq!(outcome.status, 0, "{}{}", outcome.stdout, outcome.stderr);
    let left_out = outcome.stdout.lines().find(|line| line.contains("claims: left out; they rest on other exp"));
    assert!(left_out.is_some(), "{}", outcome.stdout);
    let text = |name: &str| fs::read_to_string(folder.path().join("r").join(name)).expect("a file of the run");
    let counts = text("records/counts.jsonl");
    assert!(counts.lines().count() > 10 && counts.lines().all(|line| line.contains("\"hull-scaling\"")));
    let report = text("report.html");
    assert!(report.contains("id=\"experiment-hull-scaling\""));
    assert_eq!(report.matches("id=\"experiment-").count(), 1);
    assert!(report.contains("Only a part was run: hull-scaling."));
    assert!(text("manifest.json").contains("--only hull-scaling"));
    assert!(!folder.path().join("r/CLAIMS.md").exists(), "a part of the claims is no ledger");

    let exported = run(folder.path(), &["records", "export", "r", "--csv", "-"]);
    assert_eq!(exported.status, 0, "{}", exported.stderr);
    assert!(exported.stdout.starts_with("sort,experiment,input,method,n,instance,repetition,quantity,number,"));
    let of = |sort: &str| exported.stdout.lines().filter(|line| line.starts_with(sort)).count();
    assert!(of("count,hull-scaling,") >= counts.lines().count());
    assert_eq!(of("time,hull-scaling,"), text("records/times.jsonl").lines().count());
    let rows = |name: &str| text(name).lines().count() - 1;
    assert_eq!(rows("records/hull-scaling.counts.csv"), of("count,hull-scaling,") + of("value,hull-scaling,"));
    assert_eq!(rows("records/hull-scaling.times.csv"), of("time,hull-scaling,"));
    fs::write(folder.path().join("r/records/times.jsonl"), "\n").expect("written");
    let broken = run(folder.path(), &["records", "export", "r", "--csv", "r.csv"]);
    assert!(broken.stderr.starts_with("zonobench: r/records/times.jsonl: line 1: is no record: "), "{}", broken.stderr);
    assert_eq!((broken.status, folder.path().join("r.csv").exists()), (1, false));

    let again = run(folder.path(), &["reproduce", "--out", "r", "--only", "hull-scaling"]);
    assert_eq!((again.status, again.stderr.contains("is not empty")), (1, true));
}

#[test]
fn what_does_not_exist_is_not_run() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for words in [&["reproduce", "--only", "hull-scaling", "no-such-id"][..], &["figure", "no-such-id", "--svg", "-"]] {
        let outcome = run(folder.path(), words);
        assert!(outcome.stderr.starts_with("zonobench: 'no-such-id': there is no "), "{}", outcome.stderr);
        assert_eq!((outcome.status, outcome.stdout.as_str()), (2, ""));
    }
    assert_eq!(fs::read_dir(folder.path()).expect("listed").count(), 0);
}

#[test]
fn a_figure_is_drawn_alone() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let gallery = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../figures/gallery");
    for id in ["paper-figure-1", "country-outlines"] {
        let committed = fs::read_to_string(gallery.join(format!("{id}.svg"))).expect("a committed figure");
        let piped = run(folder.path(), &["figure", id, "--svg", "-"]);
        assert_eq!(piped.status, 0, "{}", piped.stderr);
        assert_eq!(piped.stdout, committed, "{id}");
        assert!(piped.stderr.lines().count() >= 2, "title and caption: {}", piped.stderr);
        let written = run(folder.path(), &["figure", id, "--svg", "figure.svg", "--force"]);
        assert_eq!((written.status, written.stdout), (0, piped.stderr));
        assert_eq!(fs::read_to_string(folder.path().join("figure.svg")).expect("written"), committed, "{id}");
    }
}

#[test]
fn the_shell_is_told_of_every_command() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let print = |words: &[&str]| {
        let outcome = run(folder.path(), words);
        assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""), "{words:?}");
        outcome.stdout
    };
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = print(&["completions", shell]);
        assert!(["enclose", "contains", "epsilon"].iter().all(|word| script.contains(word)), "{shell}");
    }
    let page = print(&["man"]);
    assert!(page.contains(".TH zonobench 1") && page.contains("reproduce"), "{page}");
    let page = print(&["man", "enclose"]);
    assert!(page.contains(".TH zonobench-enclose 1") && page.contains("\\-\\-epsilon"), "{page}");
    assert_eq!(run(folder.path(), &["man", "no-such-command"]).status, 2);
    assert_eq!(run(folder.path(), &["completions", "no-such-shell"]).status, 2);
}

#[test]
fn two_runs_are_compared() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let config = "[experiment.hull-scaling]\nfamilies = [\"disc\"]\nsizes = [8, 16]\ninstances = 1\n";
    fs::write(folder.join("my.toml"), config).expect("written");
    for out in ["a", "b"] {
        let outcome = run(folder, &["reproduce", "--config", "my.toml", "--out", out]);
        assert_eq!(outcome.status, 0, "{}{}", outcome.stdout, outcome.stderr);
    }
    let same = run(folder, &["compare", "a", "b"]);
    assert_eq!((same.status, same.stderr.as_str()), (0, ""), "{}", same.stdout);
    assert!(
        same.stdout.contains("6 cases in both runs, 0 in the first alone, 0 in the second alone"),
        "{}",
        same.stdout
    );
    assert!(same.stdout.contains("the same, values and answers as well"), "{}", same.stdout);
    assert!(same.stdout.contains("  hull-scaling: ") && same.stdout.contains(" shorter, "), "{}", same.stdout);
    assert!(same.stdout.contains("no ratio is a verdict\n") && same.stdout.contains("machine  "), "{}", same.stdout);
    let every = run(folder, &["compare", "a", "b", "--all"]).stdout;
    assert!(every.contains("  hull-scaling: by_discarding, total: "), "{every}");
    assert!(every.contains("    hull-scaling/disc/by_discarding/n=8/0, total: "), "{every}");

    let counts = folder.join("b/records/counts.jsonl");
    let text = fs::read_to_string(&counts).expect("records");
    fs::write(&counts, text.replacen("\"turn\":", "\"turn\":1", 1)).expect("written");
    let other = run(folder, &["compare", "a", "b"]);
    assert_eq!(other.status, 1, "{}", other.stdout);
    assert!(other.stdout.contains("1 case differs"), "{}", other.stdout);
    let summed = "  hull-scaling: 5 cases alike, 1 not: 1 with more operations, 0 with fewer; the largest ratio is ";
    assert!(other.stdout.contains(summed), "{}", other.stdout);
    assert!(other.stdout.contains(", turn of by_discarding on disc, n = 8, instance 0\n"), "{}", other.stdout);
    let every = run(folder, &["compare", "a", "b", "--all"]);
    assert_eq!(every.status, 1);
    let case = "  hull-scaling: by_discarding on disc, n = 8, instance 0: turn ";
    assert!(every.stdout.contains(case), "{}", every.stdout);
    let reseeded = run(folder, &["reproduce", "--config", "my.toml", "--out", "seed7", "--seed", "7"]);
    assert_eq!(reseeded.status, 0, "{}{}", reseeded.stdout, reseeded.stderr);
    let seeds = run(folder, &["compare", "a", "seed7"]);
    assert!(seeds.stdout.contains("seeds         2003 and 7: random inputs are not the same\n"), "{}", seeds.stdout);
    assert!(seeds.stdout.contains("counts        not compared: all cases have other seeds\n"), "{}", seeds.stdout);
    assert!(seeds.status == 1 && !seeds.stdout.contains("profiles"), "{}", seeds.stdout);
    let manifest = folder.join("b/manifest.json");
    let text = fs::read_to_string(&manifest).expect("a manifest");
    fs::write(&manifest, text.replacen("\"quick\"", "\"full\"", 1)).expect("written");
    let profiles = run(folder, &["compare", "a", "b"]).stdout;
    assert!(profiles.contains("profiles      quick and full: sizes and numbers of instances"), "{profiles}");
    let missing = run(folder, &["compare", "a", "c"]);
    assert_eq!(missing.stderr, "zonobench: c: is no folder that `reproduce` wrote\n");
    assert_eq!(missing.status, 1);
}

#[test]
fn experiments_run_on_own_files() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("mine.csv"), "x,y\n0,0\n4,0\n0,4\n1,1\n").expect("written");
    let config = "[experiment.hull-scaling]\nfamilies = [\"circle\"]\nsizes = [8, 16, 32, 64]\n\
                  inputs = [\"mine.csv\"]\nvariants = [\"brute_force\"]\nrepetitions = 1\n";
    fs::write(folder.join("my.toml"), config).expect("written");
    let outcome = run(folder, &["reproduce", "--config", "my.toml", "--out", "r"]);
    assert_eq!(outcome.status, 0, "{}{}", outcome.stdout, outcome.stderr);
    let text = |name: &str| fs::read_to_string(folder.join("r").join(name)).expect("a file of the run");
    let counts = text("records/counts.jsonl");
    assert!(counts.lines().next().is_some_and(|line| line.contains("\"family\":\"mine.csv\",")), "{counts}");
    assert!(counts.contains("\"hull_vertices\":3.0"), "{counts}");
    let plot = text("figures/own-hull-scaling-turn.svg");
    assert!(plot.contains("mine.csv") && plot.contains("circle: exponent 2.12 (2.00 to 2.24)"), "{plot}");
    assert!(!plot.contains("joined") && plot.contains("Own files have large signs"), "the caption says what is drawn");
    let report = text("report.html");
    let [own, chapter] =
        ["id=\"figure-own-hull-scaling-turn\"", "id=\"min-area-zonogon\""].map(|anchor| report.find(anchor));
    assert!(own.is_some() && own < chapter, "own plots come first: {own:?}, {chapter:?}");
    for absent in ["More pictures", "italy", "id=\"ledger\"", "href=\"#ledger\""] {
        assert!(!report.contains(absent), "{absent}");
    }
    assert_eq!(outcome.stdout.matches(" claims: ").count(), 1, "{}", outcome.stdout);
    assert!(text("manifest.json").contains("--config my.toml"));
    fs::write(folder.join("my.toml"), config.replace("sizes", "sise")).expect("written");
    let refused = run(folder, &["reproduce", "--config", "my.toml", "--out", "s"]);
    assert!(
        refused.stderr.starts_with("zonobench: my.toml: line 3, column 1: unknown field `sise`"),
        "{}",
        refused.stderr
    );
    assert_eq!((refused.status, folder.join("s").exists()), (1, false));
}
