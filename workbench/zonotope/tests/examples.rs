//! The examples run as tests: each is a module of this file, and its assertions are those of the test.

macro_rules! examples {
    ($($name:ident: $path:literal,)+) => {
        $(
            #[path = $path]
            mod $name;

            #[test]
            fn $name() {
                $name::main();
            }
        )+

        const NAMES: &[&str] = &[$(stringify!($name)),+];
    };
}

examples! {
    along_directions: "../examples/along_directions.rs",
    around_a_mesh: "../examples/around_a_mesh.rs",
    checked_certificate: "../examples/checked_certificate.rs",
    distance_of_bodies: "../examples/distance_of_bodies.rs",
    gauge_and_plane: "../examples/gauge_and_plane.rs",
    least_area: "../examples/least_area.rs",
    link_past_a_box: "../examples/link_past_a_box.rs",
    membership: "../examples/membership.rs",
    moving_boxes: "../examples/moving_boxes.rs",
    order_reduction: "../examples/order_reduction.rs",
    posed_bodies: "../examples/posed_bodies.rs",
    prepared_bodies: "../examples/prepared_bodies.rs",
    readme: "../examples/readme.rs",
    two_meshes: "../examples/two_meshes/main.rs",
    volume_of_a_turn: "../examples/volume_of_a_turn.rs",
}

/// An example that is not named above would never run.
#[test]
fn every_example_is_a_test() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let entries = std::fs::read_dir(folder).expect("the examples are there");
    let mut found: Vec<String> = entries
        .map(|entry| entry.expect("an entry can be read").path())
        .filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()))
        .collect();
    found.sort();
    assert_eq!(found, NAMES);
}

/// So that the README's code compiles and holds: the example, which runs above, has every line of it.
#[test]
fn the_readme_shows_what_the_example_runs() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = |path: &str| std::fs::read_to_string(folder.join(path)).expect("the file is there");
    let (readme, example) = (text("../../README.md"), text("examples/readme.rs"));
    let shown =
        readme.split("```rust\n").nth(1).and_then(|rest| rest.split("```").next()).expect("the README has code");
    let lines = |text: &str| -> Vec<String> {
        text.lines().map(str::trim).filter(|line| !line.is_empty()).map(str::to_owned).collect()
    };
    let example = lines(&example);
    let mut rest = example.iter();
    for line in lines(shown) {
        assert!(rest.any(|own| *own == line), "not in the example, or not in this order: {line}");
    }
}
