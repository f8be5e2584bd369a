//! `draw`: a reader's own data in the pictures of the paper.

use std::fs;

use crate::run;

#[test]
fn own_data_are_drawn_as_the_paper_draws_its_examples() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("z.json"), "[[7,2,12],[4,6,5],[-3,8,0],[-8,5,2]]").expect("written");
    fs::write(folder.join("p.csv"), "id,x,y\n1,0,32\n2,8,10\n3,66,2\n4,86,40\n5,38,66\n").expect("written");
    let drawn = |words: &[&str]| {
        let outcome = run(folder, &[&["draw"], words, &["--svg", "-"]].concat());
        assert_eq!(outcome.status, 0, "{words:?}: {}", outcome.stderr);
        assert!(outcome.stdout.starts_with("<svg"), "{words:?}");
        outcome.stdout
    };
    for picture in ["tiling", "arrangement"] {
        let with_separator = drawn(&[picture, "z.json", "--separator", "3"]);
        assert!((1..=6).all(|number| with_separator.contains(&format!(">{number}</"))), "{picture}");
        assert_ne!(with_separator, drawn(&[picture, "z.json"]));
    }
    drawn(&["separators", "z.json"]);
    assert!(drawn(&["search", "z.json", "--point", "-1,2,3"]).contains("The tile of generators"));
    assert!(drawn(&["search", "p.csv", "--columns", "x,y"]).contains("the polygon in its zonogon of least area"));
    drawn(&["zonogon", "p.csv", "--columns", "2,3"]);
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("flat.json"), "[[1,0],[0,1]]").expect("written");
    fs::write(folder.join("star.json"), "[[1,0,0],[0,1,0],[1,1,0]]").expect("written");
    fs::write(folder.join("line.csv"), "0,0\n1,1\n2,2\n").expect("written");
    let cases: [(&[&str], i32, &str); 7] = [
        (&["tiling", "flat.json"], 1, "flat.json: has 2 coordinates"),
        (&["tiling", "star.json"], 1, "star.json: the lines of generators 1, 2 and 3 meet in one point"),
        (&["zonogon", "line.csv"], 1, "line.csv: the points lie on a line"),
        (&["zonogon", "line.csv", "--point", "1,2,3"], 2, "--point: only a search has a point"),
        (&["separators", "star.json", "--separator", "1"], 2, "--separator: only the tiling"),
        (&["tiling", "star.json", "--skip", "1"], 2, "--skip: "),
        (&["search", "star.json", "--point", "1,2"], 2, "three finite numbers"),
    ];
    for (words, status, complaint) in cases {
        let outcome = run(folder, &[&["draw"], words, &["--svg", "out.svg"]].concat());
        assert_eq!(outcome.status, status, "{words:?}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(complaint), "{words:?}: {}", outcome.stderr);
    }
    assert!(!folder.join("out.svg").exists());
}
