//! A misspelt name of any sort gets the nearest one.

use std::fs;
use std::path::Path;

use crate::{run, run_with_input};

#[test]
fn names_on_the_command_line() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("p.csv"), "length,Width,h\n0,0,1\n2,0,1\n0,2,1\n").expect("written");
    fs::write(folder.join("p.json"), r#"[{"east":0,"north":1},{"east":2,"north":3}]"#).expect("written");
    fs::write(folder.join("z.json"), "[[1,0],[0,1]]").expect("written");
    let cases: [(&[&str], &str); 18] = [
        (&["figure", "paper-figur-1", "--svg", "-"], "did you mean `paper-figure-1`?"),
        (&["figure", "hull-scalling", "--svg", "-"], "did you mean `hull-scaling`?"),
        (&["reproduce", "--only", "hull_scaling"], "did you mean `hull-scaling`?"),
        (&["reproduce", "--only", "theorem-4.5"], "it is a claim that rests on the experiments "),
        (&["reproduce", "--profile", "ful"], "'full'"),
        (&["list", "experiment"], "'experiments'"),
        (&["list", "methodes"], "'methods'"),
        (&["man", "enclse"], "did you mean `enclose`?"),
        (&["completions", "bahs"], "'bash'"),
        (&["inspct", "z.json"], "'inspect'"),
        (&["inspect", "z.json", "--vertises", "-"], "'--vertices'"),
        (&["reduce", "z.json", "--count", "2", "--rule", "clusters"], "'cluster'"),
        (&["enclose", "p.csv", "--objective", "lenght"], "'length'"),
        (&["enclose", "p.csv", "--format", "jsn"], "'json'"),
        (&["enclose", "p.csv", "--columns", "length,widht"], "did you mean `Width`?"),
        (&["enclose", "p.json", "--columns", "east,norht"], "did you mean `north`?"),
        (&["enclose", "p.csv", "--columns", "1,2", "--directions", "nett:2"], "did you mean `net:2`?"),
        (&["enclose", "p.csv", "--columns", "1,2", "--directions", "axis"], "did you mean `axes`?"),
    ];
    for (words, near) in cases {
        let outcome = run(folder, words);
        assert!(outcome.status > 0 && outcome.stdout.is_empty(), "{words:?}: {}", outcome.stdout);
        assert!(outcome.stderr.contains(near), "{words:?}: {}", outcome.stderr);
    }
    let far = run(folder, &["figure", "no-such-thing", "--svg", "-"]);
    assert!(!far.stderr.contains("did you mean"), "{}", far.stderr);
}

#[test]
fn names_in_questions() {
    let cases = [
        (r#""kind":"intersects","input":{}"#, "did you mean `intersect`?"),
        (r#""kind":"min_lenght_all","input":{}"#, "did you mean `min_length_all`?"),
        (r#""kind":"min-area","input":{}"#, "did you mean `min_area`?"),
        (
            r#""kind":"min_length_all","method":"by_colum_generation","input":{}"#,
            "did you mean `by_column_generation`?",
        ),
        (
            r#""kind":"support","input":{"direction":[1],"centr":[0],"generators":[]}"#,
            "missing field `center` in the input; did you misspell it `centr`?",
        ),
        (
            r#""kind":"min_length_all","input":{"points":[[0,0]],"epsilon":0.5,"max_generator":2}"#,
            "extra field `max_generator` in the input; did you mean `max_generators`?",
        ),
        (
            r#""kind":"min_length_all","input":{"points":[[0,0]],"epsilon":0.5,"objective":"volumes"}"#,
            "did you mean `volume`?",
        ),
        (
            r#""kind":"reduce","input":{"center":[0],"generators":[],"count":1,"rule":"gerard"}"#,
            "did you mean `girard`?",
        ),
    ];
    for (question, near) in cases {
        let line = format!("{{\"id\":\"q\",{question}}}\n");
        let outcome = run_with_input(Path::new("."), &["solve"], line.as_bytes());
        assert!(outcome.stdout.contains(near), "{question}: {}", outcome.stdout);
    }
}

#[test]
fn names_in_a_file_that_changes_experiments() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (text, near) in [
        ("[experiment.hull-scalling]\n", "did you mean `hull-scaling`?"),
        ("[experiments.hull-scaling]\n", "did you mean `experiment`?"),
        ("[experiment.hull-scaling]\nsizse = [8]\n", "did you mean `sizes`?"),
        ("[experiment.hull-scaling]\nfamilies = [\"elipse\"]\n", "did you mean `ellipse`?"),
        ("[experiment.hull-scaling]\nvariants = [\"bruteforce\"]\n", "did you mean `brute_force`?"),
    ] {
        fs::write(folder.path().join("my.toml"), text).expect("written");
        let outcome = run(folder.path(), &["reproduce", "--config", "my.toml"]);
        assert_eq!(outcome.status, 1, "{text}");
        assert!(outcome.stderr.contains(near), "{text}: {}", outcome.stderr);
    }
}

/// A folder that is given as a body, a name without a format and a format that holds no bodies are different mistakes.
#[test]
fn bodies_that_are_no_bodies() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::create_dir(folder.join("folder")).expect("made");
    for name in ["z", "z.xml", "z.obj"] {
        fs::write(folder.join(name), "[[1,0],[0,1]]").expect("written");
    }
    for (file, complaint) in [
        ("folder", "folder: is a folder, not a file"),
        ("lost", "lost: cannot be read: "),
        ("z", "z: the format cannot be told from the name; say csv, json or npy by --format"),
        ("z.xml", "z.xml: files that end in .xml are not read as zonotopes; if it holds one, say csv"),
        ("z.obj", "z.obj: the format obj holds no zonotopes; csv, json and npy do, and `zonobench enclose"),
    ] {
        for words in [&["inspect", file][..], &["intersect", file, file], &["reduce", file, "--count", "2"]] {
            let outcome = run(folder, words);
            assert_eq!((outcome.status, outcome.stdout.as_str()), (1, ""), "{words:?}");
            assert!(outcome.stderr.starts_with(&format!("zonobench: {complaint}")), "{words:?}: {}", outcome.stderr);
        }
    }
    assert_eq!(run(folder, &["inspect", "z.xml", "--format", "json"]).status, 0);
}

/// A folder that is given as a file, a misspelt net and a file that is not there are different mistakes.
#[test]
fn directions_that_are_no_directions() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("p.csv"), "0,0\n2,0\n0,2\n").expect("written");
    fs::write(folder.join("d.xml"), "1,0\n0,1\n").expect("written");
    fs::create_dir(folder.join("folder.csv")).expect("made");
    for (directions, status, complaint) in [
        ("net:x", 2, "a net has 1 to 1000 cells a side, as `net:2`"),
        ("nett:2", 2, "there is no such file; did you mean `net:2`?"),
        ("d.xml", 1, "d.xml: the name alone tells the format of directions; name the file .csv, .json or .npy"),
        ("lost.csv", 1, "lost.csv: cannot be read: No such file"),
        ("folder.csv", 1, "folder.csv: "),
    ] {
        let outcome = run(folder, &["enclose", "p.csv", "--directions", directions]);
        assert_eq!(outcome.status, status, "{directions}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(complaint), "{directions}: {}", outcome.stderr);
    }
}
