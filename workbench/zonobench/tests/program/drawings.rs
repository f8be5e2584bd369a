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
fn bodies_in_motion_are_drawn_with_the_proof() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("bar.json"), "[[4,0,0],[0,0.125,0],[0,0,0.125]]").expect("written");
    fs::write(folder.join("cube.json"), "[[1,0,0],[0,1,0],[0,0,1]]").expect("written");
    let drawn = |words: &[&str]| {
        let outcome = run(folder, &[&["draw", "motion"], words, &["--svg", "-"]].concat());
        assert_eq!(outcome.status, 0, "{words:?}: {}", outcome.stderr);
        outcome.stdout
    };
    let turn = ["--axis", "0,0,1", "--angle", "3"];
    let apart = drawn(&[&["bar.json", "cube.json", "--move-b", "0,6,0"][..], &turn].concat());
    assert!(
        apart.contains("bar.json and cube.json in motion") && apart.contains("Disjoint during the whole step"),
        "{apart}"
    );
    let met = drawn(&[&["bar.json", "cube.json", "--move-b", "0,3,0"][..], &turn].concat());
    assert!(met.contains("The bodies meet at the time") && met.contains(">contact<"), "{met}");
    let alone = drawn(&[&["bar.json"][..], &turn].concat());
    assert!(alone.contains("A volume around bar.json in motion") && alone.contains("volume around every placement"));
    assert_ne!(alone, drawn(&["bar.json", "--translation", "0,0,2"]));
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("flat.json"), "[[1,0],[0,1]]").expect("written");
    fs::write(folder.join("star.json"), "[[1,0,0],[0,1,0],[1,1,0]]").expect("written");
    fs::write(folder.join("line.csv"), "0,0\n1,1\n2,2\n").expect("written");
    let cases: [(&[&str], i32, &str); 15] = [
        (&["tiling", "flat.json"], 1, "flat.json: has 2 coordinates"),
        (&["tiling", "star.json"], 1, "star.json: the lines of generators 1, 2 and 3 meet in one point"),
        (&["zonogon", "line.csv"], 1, "line.csv: the points lie on a line"),
        (&["zonogon", "line.csv", "--point", "1,2,3"], 2, "--point: only a search has a point"),
        (&["separators", "star.json", "--separator", "1"], 2, "--separator: only the tiling"),
        (&["tiling", "star.json", "--skip", "1"], 2, "--skip: "),
        (&["search", "star.json", "--point", "1,2"], 2, "three finite numbers"),
        (&["motion", "star.json"], 2, "--motion: no motion of either body is given"),
        (&["motion", "star.json", "--motion-b", "star.json"], 2, "--motion-b: there is no second zonotope"),
        (&["motion", "star.json", "--translation", "1,0,0", "--move-b", "1,0,0"], 2, "--move-b: there is no second"),
        (&["tiling", "star.json", "--translation", "1,0,0"], 2, "--motion: it is for `draw motion`"),
        (&["tiling", "star.json", "star.json"], 2, "a second file: it is for `draw motion`"),
        (&["motion", "flat.json", "--translation", "1,0,0"], 1, "flat.json: has 2 coordinates; motions are those of"),
        (&["motion", "star.json", "--translation", "1e200,0,0"], 1, "which is not drawn"),
        (&["motion", "star.json", "--axis", "0,0,0", "--angle", "1"], 1, "axis is zero"),
    ];
    for (words, status, complaint) in cases {
        let outcome = run(folder, &[&["draw"], words, &["--svg", "out.svg"]].concat());
        assert_eq!(outcome.status, status, "{words:?}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(complaint), "{words:?}: {}", outcome.stderr);
    }
    assert!(!folder.join("out.svg").exists());
}
