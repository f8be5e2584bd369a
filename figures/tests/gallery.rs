//! The committed drawings are what the code draws, byte for byte. `ZONOTOPE_BLESS=1` writes them anew.
//!
//! An ordinary run leaves out the drawings of the counts that take longest; `ZONOTOPE_CASES=long` and
//! `ZONOTOPE_BLESS=1` draw all.

use experiments::catalog::find as find_experiment;
use experiments::definition::{Experiment, Profile};
use experiments::definitions::{collision_scaling, lad_scaling, least_volume, mesh_node_tests};
use experiments::runner::{self, Records, RunOptions};
use figures::catalog::FIGURES;
use figures::figure::{Figure, FigureError, FigureInput};
use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::sync::LazyLock;

/// The seed and the profile of `zonobench reproduce` when nothing else is said.
const SEED: u64 = 2003;
const PROFILE: Profile = Profile::Quick;

/// The experiments whose counts together take as long as those of all others.
const LONG: [&str; 4] = [
    lad_scaling::EXPERIMENT.id,
    mesh_node_tests::COUNTS.id,
    collision_scaling::EXPERIMENT.id,
    least_volume::EXPERIMENT.id,
];

fn gallery() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("gallery")
}

fn committed() -> impl Iterator<Item = &'static Figure> {
    FIGURES.iter().filter(|figure| figure.deterministic)
}

fn needs_records(figure: &Figure) -> bool {
    matches!(figure.draw(&FigureInput::default()), Err(FigureError::NoRecords(_)))
}

/// Whether a variable of the environment is set to a value.
fn is_set(variable: &str, value: &str) -> bool {
    std::env::var_os(variable).is_some_and(|set| set == value)
}

/// The figures that this run draws.
fn drawn() -> impl Iterator<Item = &'static Figure> {
    let all = is_set("ZONOTOPE_CASES", "long") || is_set("ZONOTOPE_BLESS", "1");
    let is_long = |figure: &Figure| figure.experiments.iter().any(|id| LONG.contains(id)) && needs_records(figure);
    committed().filter(move |figure| all || !is_long(figure))
}

/// The operation counts that they show.
fn counts() -> Records {
    let mut shown: Vec<&'static Experiment> = Vec::new();
    for id in drawn().filter(|figure| needs_records(figure)).flat_map(|figure| figure.experiments) {
        if shown.iter().all(|other| other.id != *id) {
            shown.push(find_experiment(id).expect("another test finds the experiments of all figures"));
        }
    }
    let options = RunOptions {
        profile: PROFILE,
        seed: SEED,
        threads: 0,
        directory: None,
        times: false,
        own_inputs: String::new(),
        shard: None,
    };
    runner::run(&shown, &options, &()).expect("counting without a folder touches no file")
}

/// The figures as the code draws them.
static DRAWN: LazyLock<Vec<(&str, String)>> = LazyLock::new(|| {
    let records = counts();
    let input = FigureInput { records: Some(&records) };
    let draw = |figure: &Figure| figure.draw(&input).unwrap_or_else(|error| panic!("{}: {error}", figure.id));
    drawn().map(|figure| (figure.id, draw(figure))).collect()
});

#[test]
fn drawings_are_those_of_the_gallery() {
    let bless = is_set("ZONOTOPE_BLESS", "1");
    if bless {
        fs::create_dir_all(gallery()).expect("the folder can be made");
    }
    let mut different = Vec::new();
    for (id, drawing) in &*DRAWN {
        let file = gallery().join(id).with_extension("svg");
        if bless {
            fs::write(&file, drawing).expect("the gallery can be written");
        } else if fs::read_to_string(&file).ok().as_ref() != Some(drawing) {
            different.push(id);
        }
    }
    assert!(different.is_empty(), "look at {different:?}, then run with ZONOTOPE_BLESS=1");
}

#[test]
fn the_gallery_holds_nothing_else() {
    let expected: BTreeSet<String> = committed().map(|figure| format!("{}.svg", figure.id)).collect();
    for entry in fs::read_dir(gallery()).expect("the gallery is part of the sources") {
        let name = entry.expect("it can be read").file_name().to_string_lossy().into_owned();
        assert!(expected.contains(&name), "{name} belongs to no figure");
    }
}

#[test]
fn figures_name_experiments_that_exist_and_are_named_apart() {
    let mut ids = BTreeSet::new();
    for figure in FIGURES {
        assert!(ids.insert(figure.id), "{} is there twice", figure.id);
        for id in figure.experiments {
            assert!(find_experiment(id).is_some(), "{}: there is no experiment {id}", figure.id);
        }
        assert!(figure.caption.ends_with('.') && !figure.title.ends_with('.'), "{}", figure.id);
    }
}

#[test]
fn figures_of_times_need_records() {
    for figure in FIGURES.iter().filter(|figure| !figure.deterministic) {
        assert!(needs_records(figure), "{}", figure.id);
    }
}

/// Every text of a committed drawing starts on its page; how far it reaches depends on the reader's fonts.
#[test]
fn text_is_on_the_page() {
    for (id, drawing) in &*DRAWN {
        let mut page = [0.0; 2];
        for event in svg::read(drawing).expect("the drawing is an SVG document") {
            let svg::parser::Event::Tag(name, _, attributes) = event else { continue };
            let number = |name: &str| attributes.get(name).and_then(|value| value.parse::<f64>().ok());
            if let ("svg", Some(view)) = (name, attributes.get("viewBox")) {
                let numbers: Vec<f64> = view.split(' ').filter_map(|number| number.parse().ok()).collect();
                page = [numbers[2], numbers[3]];
            } else if let ("text", Some(x), Some(y)) = (name, number("x"), number("y")) {
                let inside = (0.0..=page[0]).contains(&x) && (0.0..=page[1]).contains(&y);
                assert!(inside, "{id}: text at ({x}, {y})");
            }
        }
    }
}

/// A result in a caption would be held by nothing and stay when the records change; results are in the report's
/// findings.
#[test]
fn captions_say_what_is_drawn_and_state_no_result() {
    let results = [
        "falls like",
        "grows like",
        "half as much",
        "better than",
        "is wrong",
        "are wrong",
        "bounded number",
        "faster",
        "quicker",
        "reads less",
        "do not grow",
        "same optimum",
        "is bound by",
    ];
    for figure in FIGURES {
        let found = results.iter().find(|words| figure.caption.contains(**words));
        assert!(found.is_none(), "{}: “{}” states a result", figure.id, found.unwrap_or(&""));
    }
}
