//! `collide` about two meshes: the summary, the answer with its request, and what is refused.

use std::fs;

use super::{BAR, PIECES};
use crate::run;

const SQUARE: &str = "v 0 0 0\nv 0 1 0\nv 0 1 1\nv 0 0 1\nf 1 2 3 4\n";
const SPIKE: &str =
    "OFF\n4 4 0\n4 0.25 0.25\n5 0.25 0.5\n5 0.5 0.25\n5 0.25 0.25\n3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n";

#[test]
fn a_spike_that_moves_into_a_square() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    for (name, content) in [("square.obj", SQUARE), ("spike.off", SPIKE), ("bar.json", BAR), ("quarter.json", PIECES)] {
        fs::write(folder.join(name), content).expect("written");
    }
    let collide = |options: &[&str]| {
        let outcome = run(folder, &[&["collide", "spike.off", "square.obj"], options].concat());
        assert_eq!(outcome.status, 0, "{options:?}: {}", outcome.stderr);
        outcome.stdout
    };
    let met = collide(&["--translation", "-8,0,0", "--json", "met.json", "--question", "q.json"]);
    for line in [
        "a             4 triangles, 4 vertices in spike.off\n",
        "b             2 triangles, 4 vertices in square.obj\n",
        "motion of b   none: it rests\n",
        "answer        a and b meet, and are disjoint before\n",
        "of b meet at the later of these times\n",
        " with a direction that separates parts of the meshes at every time: ",
        "certificate   checked: contact; ",
        "verify        zonobench verify spike.off square.obj met.json\n",
    ] {
        assert!(met.contains(line), "{line}: {met}");
    }
    let apart = collide(&["--translation", "-8,0,0", "--move-b", "0,5,0", "--turn", "x,30", "--json", "apart.json"]);
    assert!(apart.contains("each vertex is taken in the doubles nearest to its image\n"), "{apart}");
    assert!(apart.contains("certificate   checked: separate; "), "{apart}");
    let turned = collide(&["--motion", "quarter.json"]);
    assert!(turned.contains("motion of a   1 piece with quaternions that go linearly\n"), "{turned}");

    for words in [
        ["spike.off", "square.obj", "met.json"].as_slice(),
        &["spike.off", "square.obj", "apart.json"],
        &["q.json", "met.json"],
    ] {
        let judged = run(folder, &[&["verify"], words].concat());
        assert!(judged.status == 0 && judged.stdout.contains("\tright\t"), "{words:?}: {}", judged.stdout);
    }
    // an answer about other files, and one that says something else
    let exchanged = run(folder, &["verify", "square.obj", "spike.off", "met.json"]);
    assert!(exchanged.status == 1 && exchanged.stdout.contains("\tunchecked\t"), "{}", exchanged.stdout);
    let changed = fs::read_to_string(folder.join("met.json")).expect("written").replace("\"contact\"", "\"separate\"");
    fs::write(folder.join("changed.json"), changed).expect("written");
    let wrong = run(folder, &["verify", "spike.off", "square.obj", "changed.json"]);
    assert!(wrong.status == 1 && wrong.stdout.contains("\tWRONG\t"), "{}", wrong.stdout);

    let both = "is none: both are zonotopes, or both are meshes";
    for (words, complaint) in [
        (&["spike.off", "bar.json", "--translation", "1,0,0"][..], both),
        (&["bar.json", "spike.off", "--translation", "1,0,0"], both),
        (
            &["spike.off", "square.obj", "--axis", "0,0,1", "--degrees", "90"],
            "motion, a turns at constant rate: motions of meshes have `pieces`",
        ),
        (&["spike.off", "square.obj", "--translation", "1,0,0", "--center-first"], "meshes have no generators"),
    ] {
        let refused = run(folder, &[&["collide"], words].concat());
        assert!(refused.status != 0 && refused.stdout.is_empty(), "{words:?}");
        assert!(refused.stderr.contains(complaint), "{words:?}: {}", refused.stderr);
    }
}
