//! Numbers that the library's documentation states of what was measured: each is read from the text and held to runs of
//! the code, so that neither can change without the other.

use std::num::NonZeroU32;
use std::path::{Path, PathBuf};

use experiments::definition::{Case, Measurement};
use experiments::definitions::tree_queries;
use experiments::record::CountRow;
use families::{bodies, lines};
use zonotope::Zonotope;
use zonotope::arrangement::LineArrangement;
use zonotope::arrangement::cutting::cutting;
use zonotope::collision::hierarchy::Hierarchy;
use zonotope::collision::prepared::by_cutting::PreparedByCutting;

const CUTTING: &str = "arrangement/cutting/by_hierarchy.rs";
const TREE: &str = "collision/prepared/by_direction_tree/mod.rs";
const PREPARED_BY_CUTTING: &str = "collision/prepared/by_cutting/mod.rs";
const LEVELS: &str = "collision/hierarchy/levels.rs";

/// Files whose measured numbers the tests below hold.
const HELD: [&str; 5] = [CUTTING, TREE, PREPARED_BY_CUTTING, LEVELS, "arrangement/cutting/mod.rs"];

/// Files whose measured numbers are times, those of a cost model made from times among them: a test cannot hold them.
const OF_A_CLOCK: [&str; 5] = [
    "collision/hierarchy/descent.rs",
    "collision/prepared/choice/costs.rs",
    "collision/prepared/choice/mod.rs",
    "reduction/hausdorff/by_branch_and_bound.rs",
    "reduction/hausdorff/mod.rs",
];

fn library() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../workbench/zonotope/src")
}

/// The documentation of a file of the library, in one line.
fn documentation(file: &str) -> String {
    let text = std::fs::read_to_string(library().join(file)).expect("the file is there");
    let lines = text.lines().filter_map(|line| line.trim_start().strip_prefix("//!"));
    lines.map(str::trim).collect::<Vec<_>>().join(" ")
}

/// The numbers in the places of `{}` in a phrase of a file's documentation.
fn stated<const N: usize>(file: &str, phrase: &str) -> [f64; N] {
    let text = documentation(file);
    let pieces: Vec<&str> = phrase.split("{}").collect();
    let mut starts = text.match_indices(pieces[0]).map(|(at, piece)| at + piece.len());
    let read = |start: usize| -> Option<Vec<f64>> {
        let mut rest = &text[start..];
        let mut numbers = Vec::new();
        for piece in &pieces[1..] {
            let end = rest.find(|c: char| !c.is_ascii_digit() && !matches!(c, '.' | ','))?;
            let end = rest[..end].trim_end_matches([',', '.']).len();
            numbers.push(rest[..end].replace(',', "").parse().ok()?);
            rest = rest[end..].strip_prefix(piece)?;
        }
        Some(numbers)
    };
    let numbers = starts.find_map(read).unwrap_or_else(|| panic!("{file} does not say “{phrase}”"));
    numbers.try_into().expect("there is a number for each place")
}

/// The generators and nodes that a query reads, of each of three instances.
fn reads(family: &'static str, method: &'static str, n: usize) -> [f64; 3] {
    [0, 1, 2].map(|instance| {
        let case = Case::new(2003, tree_queries::EXPERIMENT.id, family, method, n, instance);
        let measured: Result<Measurement, String> = (tree_queries::EXPERIMENT.measure)(&case);
        CountRow::new(&case, measured).value("reads").expect("each case is answered")
    })
}

#[test]
fn a_query_to_a_tree_reads_what_its_documentation_says() {
    let [low, high] = stated(TREE, "reads {} to {} √n nodes");
    let [most] = stated(TREE, "up to {} times what the kernel reads without a tree");
    let mut worst = 0.0f64;
    for n in [1 << 10, 1 << 12, 1 << 13, 1 << 14] {
        let mut random = reads("random_bodies", "by_direction_tree", n);
        random.sort_by(f64::total_cmp);
        let roots = random[1] / (n as f64).sqrt();
        assert!((low..=high).contains(&roots), "{roots} √n for n = {n}");
        let [tree, kernel] = ["by_direction_tree", "by_lad"].map(|method| reads("near_plane_bodies", method, n));
        worst = tree.iter().zip(kernel).map(|(tree, kernel)| tree / kernel).fold(worst, f64::max);
    }
    assert!(worst <= most, "{worst} times the kernel's reads");
}

#[test]
fn cuttings_are_as_large_as_their_documentation_says() {
    let [squares] = stated(CUTTING, "at most {} r² trapezoids");
    let [lists] = stated(CUTTING, "lists of at most {} n r lines");
    for family in ["random_lines", "lattice_lines", "near_parallel_lines"] {
        let family = lines::find(family).expect("the family is there");
        for r in [4u32, 16, 64] {
            for n in [4 * r, 16 * r] {
                let rows: Vec<[f64; 3]> =
                    family.generate(n as usize, 2003).into_iter().map(|([a, b], c)| [a, b, c]).collect();
                let arrangement = LineArrangement::from_rows(&rows).expect("the rows are finite");
                let cut = cutting(&arrangement, NonZeroU32::new(r).expect("r is not zero"), 1, &mut ());
                let (count, crossings) = (cut.trapezoids().len() as f64, cut.total_crossings() as f64);
                let place = || format!("{}, n = {n}, r = {r}", family.id);
                assert!(count <= squares * f64::from(r * r), "{}: {count} trapezoids", place());
                assert!(crossings <= lists * f64::from(n) * f64::from(r), "{}: {crossings} lines", place());
            }
        }
    }
}

#[test]
fn a_prepared_cutting_takes_the_bytes_that_its_documentation_says() {
    let [usual] = stated(PREPARED_BY_CUTTING, "at most {} bytes a unit of m");
    let [whole, cone, uneven] = stated(
        PREPARED_BY_CUTTING,
        "bytes a unit of m; {} where generators are short whole numbers, {} where they lie on a cone, {} where",
    );
    for family in bodies::BODY_FAMILIES {
        let most = match family.id {
            "random_bodies" => usual,
            _ => [usual, whole, cone, uneven].into_iter().fold(0.0, f64::max),
        };
        let body = Zonotope::new([0.0; 3], family.generate(256, 2003)).expect("the family is finite");
        for space in [256u64, 4096, 65536] {
            let held = PreparedByCutting::new(body.clone(), space, 1, &mut ()).expect("the space is enough").bytes();
            let a_unit = held as f64 / space as f64;
            assert!(a_unit <= most, "{}: {a_unit} bytes a unit of m = {space}", family.id);
        }
    }
}

/// The counts are exact, and the distances as far as other random generators bear them: to half as much again.
#[test]
fn levels_are_as_near_to_the_body_as_their_documentation_says() {
    let counts: [f64; 6] = stated(LEVELS, "levels of {}, {}, {}, {}, {} and {} generators reach farther");
    let parts: [f64; 6] = stated(LEVELS, "than the body by {} %, {} %, {} %, {} %, {} % and {} %");
    let family = bodies::find("random_bodies").expect("the family is there");
    let hierarchy = Hierarchy::new(Zonotope::new([0.0; 3], family.generate(100_000, 2003)).expect("it is finite"));
    let directions = family.generate(200, 71);
    for (count, part) in counts.into_iter().zip(parts) {
        let mut levels = (0..hierarchy.level_count()).map(|level| hierarchy.outer(level).body());
        let outer = levels.find(|outer| outer.generators().len() as f64 == count);
        let outer = outer.unwrap_or_else(|| panic!("no level has {count} generators"));
        let reach = |body: &Zonotope<3>, u: [f64; 3]| {
            let along = |v: &[f64; 3]| (0..3).map(|k| v[k] * u[k]).sum::<f64>();
            body.generators().iter().map(|v| along(v).abs()).sum::<f64>()
        };
        let beyond = directions.iter().map(|&u| reach(outer, u) / reach(hierarchy.body(), u) - 1.0);
        let most = 100.0 * beyond.fold(0.0, f64::max);
        assert!((part / 1.5..=part * 1.5).contains(&most), "{count} generators: {most} %, not {part} %");
    }
}

/// The files of the library with their places, by their order in folders.
fn library_files() -> Vec<(String, String)> {
    let mut folders = vec![library()];
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("the folder can be read") {
            let path = entry.expect("the entry can be read").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let place = path.strip_prefix(library()).expect("it is within the library");
                let text = std::fs::read_to_string(&path).expect("it is text");
                found.push((place.to_string_lossy().replace('\\', "/"), text));
            }
        }
    }
    found.sort();
    found
}

/// A number that is said to be measured somewhere else would be held by nothing.
#[test]
fn measured_statements_of_the_library_are_held_or_of_a_clock() {
    const RESULTS: [&str; 6] =
        ["Measured ", " measured on", " measured;", " measured and", "were measured", ", measured."];
    let is_held = |file: &str| HELD.contains(&file) || OF_A_CLOCK.contains(&file);
    let found: Vec<String> = library_files()
        .into_iter()
        .map(|(file, _)| file)
        .filter(|file| !is_held(file) && RESULTS.iter().any(|words| documentation(file).contains(words)))
        .collect();
    assert!(found.is_empty(), "no test holds what is measured in {found:?}");
}

/// A comment anywhere in the library that compares costs by a number, or gives a time, says what a clock said once.
#[test]
fn comments_of_the_library_state_no_times() {
    const TIMES: [&str; 9] = [
        "nanosecond",
        "microsecond",
        "millisecond",
        "of a second",
        "half the time",
        "times as much",
        "times faster",
        "times slower",
        "times quicker",
    ];
    let mut found = Vec::new();
    let is_of_a_clock = |file: &str| file.ends_with("tests.rs") || OF_A_CLOCK.contains(&file);
    for (file, text) in library_files().iter().filter(|(file, _)| !is_of_a_clock(file)) {
        let comments = text.lines().enumerate().filter(|(_, line)| line.trim_start().starts_with("//"));
        let timed = comments.filter(|(_, line)| TIMES.iter().any(|words| line.contains(words)));
        found.extend(timed.map(|(index, _)| format!("{file}:{}", index + 1)));
    }
    assert!(found.is_empty(), "no test holds the times in {found:#?}");
}
