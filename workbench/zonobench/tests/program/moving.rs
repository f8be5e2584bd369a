//! `collide` and `sweep`: motions from files and options, the summary, and what is refused.

mod meshes;

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
    let in_degrees = ["--axis", "0,0,1", "--degrees", "90"];
    assert_eq!(collide(&turned), collide(&in_degrees), "one angle in two units");
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
    // no doubles hold the images of a body that is turned by thirty degrees
    let poses = ["--turn", "z,30", "--move", "0.1,0,0", "--turn-b", "z,10", "--move-b", "0,0.1,0"];
    let posed = collide(&[&poses[..], &in_degrees].concat());
    assert!(
        posed.contains("b, rounded    the body under the pose is taken in doubles, no point of it farther "),
        "{posed}"
    );
    assert!(posed.contains("certificate   checked: "), "{posed}");
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
            "bar.json: a motion is an object of JSON with `axis_point`, `axis`, `angle` and `translation`, or with \
             `pieces`",
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

#[test]
fn a_bar_that_sweeps() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let turn = r#"{"axis_point":[0,0,0],"axis":[0,0,-1],"angle":0.5,"translation":[0,0,2]}"#;
    let extra = turn.replace("{\"axis_point\"", "{\"center\":[9,9,9],\"axis_point\"");
    let lacking = turn.replace(",\"angle\":0.5", "");
    for (name, content) in [
        ("bar.json", BAR),
        ("quarter.json", PIECES),
        ("turn.json", turn),
        ("extra.json", &extra),
        ("lacking.json", &lacking),
    ] {
        fs::write(folder.join(name), content).expect("written");
    }
    let sweep = |options: &[&str]| run(folder, &[&["sweep", "bar.json"], options].concat());
    let moved = sweep(&["--translation", "0,0,2", "--json", "moved.json"]);
    assert_eq!(moved.status, 0, "{}", moved.stderr);
    assert!(moved.stdout.contains("certificate   checked: "), "{}", moved.stdout);
    let read = |name: &str| -> serde_json::Value {
        serde_json::from_str(&fs::read_to_string(folder.join(name)).expect("written")).expect("JSON")
    };
    assert_eq!(read("moved.json")["result"]["center"], serde_json::json!([0.0, 0.0, 1.0]), "half of the translation");

    let [in_radians, in_degrees] = [["--angle", "-1.5707963267948966"], ["--degrees", "-90"]]
        .map(|angle| sweep(&[&["--axis", "0,0,1"], &angle[..]].concat()));
    assert_eq!((in_radians.stdout, in_radians.status), (in_degrees.stdout, 0), "one angle in two units");
    // many turns in radians earn a hint, and in degrees they do not
    let turns =
        |angle: [&str; 2]| run(folder, &[&["collide", "bar.json", "bar.json", "--axis", "0,0,1"], &angle[..]].concat());
    assert!(turns(["--angle", "720"]).stderr.contains("in radians") && turns(["--degrees", "720"]).stderr.is_empty());

    // a negative angle, the opposite axis and the file are one motion
    let by_options = ["--axis", "0,0,1", "--angle", "-0.5", "--translation", "0,0,2", "--json", "options.json"];
    assert_eq!(sweep(&by_options).status, 0);
    let by_file = sweep(&["--motion", "turn.json", "--json", "file.json"]);
    assert_eq!(by_file.status, 0, "{}", by_file.stderr);
    assert_eq!(read("options.json")["result"], read("file.json")["result"]);
    assert!(by_file.stdout.contains("added         3 generators: "), "{}", by_file.stdout);
    let mesh = run(folder, &["inspect", "file.json", "--obj", "file.obj", "--ply", "file.ply", "--stl", "file.stl"]);
    assert_eq!(mesh.status, 0, "the answer is read as a body: {}", mesh.stderr);
    let direct = sweep(&["--motion", "turn.json", "--obj", "direct.obj", "--ply", "direct.ply", "--stl", "direct.stl"]);
    assert_eq!(direct.status, 0, "{}", direct.stderr);
    for format in ["obj", "ply", "stl"] {
        let [read, written] = ["file", "direct"].map(|name| fs::read(folder.join(format!("{name}.{format}"))));
        assert_eq!(read.expect("written"), written.expect("written"), "{format}");
    }
    let again = sweep(&["--motion", "turn.json", "--obj", "direct.obj"]);
    assert_eq!(again.status, 1, "a file that exists is kept");
    let volume = |line: &str| line.strip_prefix("volume").map(|line| line.trim().to_owned());
    let measured = by_file.stdout.lines().find_map(volume).expect("a volume");
    let inspected = mesh.stdout.lines().find_map(volume).expect("a volume");
    let [of_answer, factor] = [0, 1].map(|part| measured.split(", ").nth(part).expect("two numbers"));
    assert!(inspected.starts_with(of_answer) || inspected.contains(of_answer), "{inspected} and {measured}");
    let factor: f64 = factor.split(' ').next().and_then(|number| number.parse().ok()).expect("a factor");
    let own = 8.0 * 4.0 * 0.125 * 0.125;
    let of_answer: f64 = of_answer.parse().expect("a number");
    assert!((factor / (of_answer / own) - 1.0).abs() < 2e-5, "{measured}");

    // every method has an answer that holds, and is asked again from the record of the answer
    for method in ["by_farthest_vertex", "by_middle_placement", "by_least_rectangle", "by_least_zonogon", "by_shadow"] {
        let file = format!("{method}.json");
        let asked = sweep(&["--motion", "turn.json", "--method", method, "--json", &file]);
        assert!(asked.stdout.contains("certificate   checked: "), "{method}: {}", asked.stdout);
        assert!(asked.stdout.contains(&format!("method        {method}\n")), "{}", asked.stdout);
        let verified = run(folder, &["verify", "bar.json", &file]);
        assert_eq!(verified.status, 0, "{method}: {}{}", verified.stdout, verified.stderr);
    }
    let forged = fs::read_to_string(folder.join("file.json")).expect("written").replacen("0.5", "0.75", 1);
    fs::write(folder.join("forged.json"), forged).expect("written");
    let refused = run(folder, &["verify", "bar.json", "forged.json"]);
    assert_eq!(refused.status, 1, "the answer to a smaller angle: {}", refused.stdout);

    for (options, complaint) in [
        (&["--motion", "quarter.json"][..], "`pieces`, while `sweep` takes one axis and one angle"),
        (&["--motion", "extra.json"], "extra.json: extra field `center` in the motion"),
        (&["--motion", "lacking.json"], "lacking.json: the motion has no field `angle`"),
        (&["--axis", "0,0,0", "--angle", "1"], "axis of the rotation is zero"),
        (&["--translation", "1.7e308,0,0", "--axis", "0,0,1", "--angle", "3", "--axis-point", "-1.7e308,0,0"], "range"),
    ] {
        let refused = sweep(options);
        assert_eq!((refused.status, refused.stdout.as_str()), (1, ""), "{options:?}");
        assert!(refused.stderr.contains(complaint), "{options:?}: {}", refused.stderr);
    }
    let infinite = sweep(&["--axis", "0,0,1", "--angle", "inf"]);
    assert_eq!((infinite.status, infinite.stdout.as_str()), (2, ""));
    assert!(infinite.stderr.contains("a finite number is expected"), "{}", infinite.stderr);
}

#[test]
fn an_angle_that_may_be_in_degrees_earns_a_hint_in_every_command_of_motions() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let turn = r#"{"axis_point":[0,0,0],"axis":[0,0,1],"angle":90,"translation":[0,0,0]}"#;
    let far = CUBE.replace("[0,3,0]", "[0,30,0]");
    for (name, content) in [("bar.json", BAR), ("far.json", &far), ("turn.json", turn)] {
        fs::write(folder.join(name), content).expect("written");
    }
    let hint = "the angle 90.0 is in radians, 14.3239 full turns; 90.0 degrees are 1.5707963267948966 radians";
    let by_options = ["--axis", "0,0,1", "--angle", "90"];
    let drawn = ["draw", "motion", "bar.json", "--force", "--svg", "bar.svg"];
    for command in [&["sweep", "bar.json"][..], &["collide", "bar.json", "far.json"], &drawn] {
        for motion in [&by_options[..], &["--motion", "turn.json"]] {
            let told = run(folder, &[command, motion].concat());
            assert_eq!(told.status, 0, "{command:?}: {}", told.stderr);
            assert_eq!(told.stderr.matches(hint).count(), 1, "{command:?}: {}", told.stderr);
        }
        let in_degrees = run(folder, &[command, &["--axis", "0,0,1", "--degrees", "90"]].concat());
        assert!(!in_degrees.stderr.contains("in radians"), "{command:?}: {}", in_degrees.stderr);
        let refused = run(folder, &[command, &["--axis", "0,0,1", "--angle", "nan"]].concat());
        assert!(refused.stderr.contains("a finite number is expected"), "{command:?}: {}", refused.stderr);
    }
}

#[test]
fn a_search_that_ends_undecided_claims_no_nearness() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let near = CUBE.replace("[0,3,0]", "[1,0,0]");
    let far = CUBE.replace("[0,3,0]", "[5,0,0]");
    for (name, content) in [("near.json", &near), ("far.json", &far)] {
        fs::write(folder.join(name), content).expect("written");
    }
    let turned = run(folder, &["collide", "near.json", "far.json", "--axis", "0,0,1", "--angle", "1e6"]);
    let undecided = "a and b are disjoint before, and from then on neither a meeting nor that there is none is proved";
    assert!(turned.stdout.contains(undecided), "{}{}", turned.stdout, turned.stderr);
}

#[test]
fn a_gauge_without_a_multiple_is_infinity_in_the_column_and_infinite_in_words() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    for (name, content) in [
        ("segment.json", r#"{"center":[0,0],"generators":[[1,0]]}"#),
        ("point.csv", "0.5,1\n"),
        ("beside.json", r#"{"center":[0.5,1],"generators":[]}"#),
    ] {
        fs::write(folder.join(name), content).expect("written");
    }
    let column = run(folder, &["contains", "segment.json", "point.csv"]);
    assert_eq!(column.stdout, "1\toutside\tInfinity\n", "{}", column.stderr);
    let words = run(folder, &["intersect", "segment.json", "beside.json"]);
    assert!(words.stdout.contains("infinite: no growth about the centres makes them meet"), "{}", words.stdout);
}
