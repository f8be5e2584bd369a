//! `collide`: motions from files and options, the summary, and what is refused.

use std::fs;

use crate::run;

const BAR: &str = "[[4,0,0],[0,0.125,0],[0,0,0.125]]";
const CUBE: &str = r#"{"center":[0,3,0],"generators":[[1,0,0],[0,1,0],[0,0,1]]}"#;
const PIECES: &str =
    r#"{"pieces":[{"until":1,"from":[1,0,0,0],"to":[1,0,0,1],"axis_point":[0,0,0],"translation":[0,0,0]}]}"#;

#[test]
fn a_bar_that_turns_beside_a_cube() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    for (name, content) in [("bar.json", BAR), ("cube.json", CUBE), ("quarter.json", PIECES)] {
        fs::write(folder.join(name), content).expect("written");
    }
    let collide = |options: &[&str]| {
        let outcome = run(folder, &[&["collide", "bar.json", "cube.json"], options].concat());
        assert_eq!(outcome.status, 0, "{options:?}: {}", outcome.stderr);
        outcome.stdout
    };
    let turned = ["--axis", "0,0,1", "--angle", "1.5707963267948966"];
    for options in [&["--motion", "quarter.json"][..], &turned] {
        let met = collide(options);
        assert!(met.contains("answer        a and b meet, and are disjoint before\n"), "{met}");
        assert!(met.contains("certificate   checked: contact; "), "{met}");
        assert!(met.contains("motion of b   none: it rests\n"), "{met}");
        let apart = collide(&[options, &["--move-b", "0,3,0"]].concat());
        assert!(apart.contains("answer        a and b are disjoint during the whole step\n"), "{apart}");
        assert!(apart.contains("certificate   checked: separate; "), "{apart}");
    }
    let at_start = collide(&["--translation", "0,0,1", "--move-b", "0,-3,0"]);
    assert!(at_start.contains("answer        a and b meet at the start\n"), "{at_start}");
    let both = collide(&[
        "--translation",
        "0,0,1",
        "--motion-b",
        "quarter.json",
        "--axis-point",
        "9,0,0",
        "--axis",
        "0,0,1",
        "--angle",
        "-0.5",
    ]);
    assert!(both.contains("-0.5 radians about the axis (0.0, 0.0, 1.0) through (9.0, 0.0, 0.0)"), "{both}");
    assert!(both.contains("motion of b   1 piece with quaternions that go linearly\n"), "{both}");

    for (options, complaint) in [
        (&["--axis", "0,0,0", "--angle", "1"][..], "motion, a, axis is zero: a rotation needs an axis"),
        (
            &["--motion", "bar.json"],
            "bar.json: a motion is an object of JSON with `axis` and `angle`, or with `pieces`",
        ),
        (&["--motion", "cube.json"], "extra field `center` in `motion, a`"),
        (&["--motion", "lost.json"], "lost.json: cannot be read"),
        (&["--translation", "1,0,0", "--resolution", "2"], "resolution is 2.0, not from "),
    ] {
        let refused = run(folder, &[&["collide", "bar.json", "cube.json"], options].concat());
        assert_eq!((refused.status, refused.stdout.as_str()), (1, ""), "{options:?}");
        assert!(refused.stderr.contains(complaint), "{options:?}: {}", refused.stderr);
    }
}
