//! A file that changes experiments: other families, sizes and methods, and a reader's own files as inputs.

mod taken;

use std::collections::BTreeMap;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use batch::did_you_mean;
use experiments::catalog::EXPERIMENTS;
use experiments::data::OwnInput;
use experiments::definition::{Experiment, FitPlan, PerProfile, Timing, Variant};
use experiments::runner;
use families::clouds::Cloud;
use serde::Deserialize;
use thiserror::Error;
use toml::Spanned;

use self::taken::{Sort, sort_of, takes};
use crate::commands::usage::{read_telling, tell};
use crate::digest::sha256;
use crate::input::{InputError, PointSource, Points, Wanted};

/// The largest size that an experiment may be asked for.
const LARGEST_SIZE: usize = 10_000_000;

/// The most instances, and repetitions.
const MOST_REPEATED: u32 = 1000;

/// Why a file does not change experiments.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ConfigError {
    /// The file cannot be read.
    #[error("{}: cannot be read", .file.display())]
    Unreadable {
        /// The file.
        file: PathBuf,
        /// The system's complaint.
        source: std::io::Error,
    },
    /// Something in the file is not TOML, is unknown, or makes no sense.
    #[error("{}: line {line}, column {column}: {problem}", .file.display())]
    Refused {
        /// The file.
        file: PathBuf,
        /// The line, from 1.
        line: usize,
        /// The column, from 1.
        column: usize,
        /// The fault there.
        problem: String,
    },
    /// A file of points cannot be read.
    #[error(transparent)]
    Input(#[from] InputError),
}

/// The experiments of a file.
#[derive(Debug)]
pub(super) struct Config {
    /// Those that the file names, as it wants them, in the order of the catalog.
    pub(super) experiments: Vec<&'static Experiment>,
    /// Files that are inputs.
    pub(super) inputs: Vec<OwnInput>,
    /// A name for the content of these files.
    pub(super) inputs_digest: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    experiment: BTreeMap<String, Spanned<Section>>,
}

/// The names of the fields of a file and of a section.
const FIELDS: [&str; 7] = ["experiment", "families", "inputs", "sizes", "instances", "repetitions", "variants"];

/// Fields that are given take the place of what the catalog has.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Section {
    families: Option<Vec<Spanned<String>>>,
    inputs: Option<Vec<Spanned<String>>>,
    sizes: Option<Vec<Spanned<usize>>>,
    instances: Option<Spanned<u32>>,
    repetitions: Option<Spanned<u32>>,
    variants: Option<Vec<Spanned<String>>>,
}

/// The text of the file, for complaints.
struct Source<'a> {
    file: &'a Path,
    text: &'a str,
}

impl Source<'_> {
    fn refused(&self, place: Range<usize>, problem: String) -> ConfigError {
        let before = &self.text[..place.start.min(self.text.len())];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line = before.matches('\n').count() + 1;
        ConfigError::Refused {
            file: self.file.to_path_buf(),
            line,
            column: before[line_start..].chars().count() + 1,
            problem,
        }
    }
}

impl Config {
    /// Reads a file; paths in it begin at its folder.
    pub(super) fn read(file: &Path) -> Result<Self, ConfigError> {
        let unreadable = |source| ConfigError::Unreadable { file: file.to_path_buf(), source };
        let text = fs::read_to_string(file).map_err(unreadable)?;
        let source = Source { file, text: &text };
        let document: Document = toml::from_str(&text).map_err(|error| {
            let problem = error.message().lines().collect::<Vec<_>>().join(" ");
            let unknown = problem.strip_prefix("unknown field `").and_then(|rest| rest.split('`').next());
            let near = unknown.map_or_else(String::new, |name| did_you_mean(name, FIELDS));
            source.refused(error.span().unwrap_or(0..0), problem + &near)
        })?;
        let mut changed: BTreeMap<&str, &'static Experiment> = BTreeMap::new();
        let mut own: BTreeMap<String, OwnInput> = BTreeMap::new();
        for (id, section) in &document.experiment {
            let Some(base) = experiments::catalog::find(id) else {
                let near = did_you_mean(id, EXPERIMENTS.iter().map(|experiment| experiment.id));
                let problem =
                    format!("there is no experiment `{id}`; `zonobench list` names those that there are{near}");
                return Err(source.refused(section.span(), problem));
            };
            changed.insert(id, changed_experiment(base, section.get_ref(), &source, &mut own)?);
        }
        if changed.is_empty() {
            return Err(source.refused(0..0, "names no experiment, as `[experiment.hull-scaling]` does".to_owned()));
        }
        let experiments = EXPERIMENTS.iter().filter_map(|experiment| changed.get(experiment.id).copied()).collect();
        let inputs: Vec<OwnInput> = own.into_values().collect();
        let inputs_digest = if inputs.is_empty() { String::new() } else { sha256(format!("{inputs:?}").as_bytes()) };
        Ok(Self { experiments, inputs, inputs_digest })
    }
}

/// The experiment as a section wants it. It lives as long as the process, like those of the catalog.
fn changed_experiment(
    base: &'static Experiment,
    section: &Section,
    source: &Source<'_>,
    own: &mut BTreeMap<String, OwnInput>,
) -> Result<&'static Experiment, ConfigError> {
    let mut experiment = *base;
    let sorts: Vec<Sort> = base.families.iter().chain(base.real_inputs).filter_map(|name| sort_of(name)).collect();
    if let Some(names) = &section.families {
        experiment.families = leaked(names.iter().map(|name| family(base, &sorts, name, source)))?;
        // what is named is run in both profiles
        experiment.only_full = &[];
    }
    if let Some(names) = &section.inputs {
        experiment.real_inputs = leaked(names.iter().map(|name| input(base, &sorts, name, source, own)))?;
    }
    if let Some(sizes) = &section.sizes {
        let sizes: &[usize] = leaked(sizes.iter().map(|size| within(size, 1..=LARGEST_SIZE, source)))?;
        experiment.sizes = PerProfile::both(sizes);
        experiment.timing = experiment.timing.map(|timing| Timing { sizes: PerProfile::both(sizes), ..timing });
    }
    if let Some(instances) = &section.instances {
        experiment.instances = PerProfile::both(within(instances, 1..=MOST_REPEATED, source)?);
    }
    if let Some(repetitions) = &section.repetitions {
        let Some(timing) = &mut experiment.timing else {
            return Err(source.refused(repetitions.span(), format!("`{}` takes no times", base.id)));
        };
        timing.repetitions = PerProfile::both(within(repetitions, 1..=MOST_REPEATED, source)?);
    }
    if let Some(names) = &section.variants {
        experiment.variants = leaked(names.iter().map(|name| variant(base, name, source)))?;
    }
    let is_fitted = |plan: &&FitPlan| experiment.variants.iter().any(|variant| variant.id == plan.variant);
    let fits = base.fits.iter().filter(is_fitted).map(|plan| Ok(FitPlan { families: experiment.families, ..*plan }));
    experiment.fits = leaked(fits)?;
    Ok(Box::leak(Box::new(experiment)))
}

fn leaked<T>(items: impl Iterator<Item = Result<T, ConfigError>>) -> Result<&'static [T], ConfigError> {
    Ok(Box::leak(items.collect::<Result<Vec<T>, _>>()?.into_boxed_slice()))
}

fn family(
    base: &Experiment,
    sorts: &[Sort],
    name: &Spanned<String>,
    source: &Source<'_>,
) -> Result<&'static str, ConfigError> {
    let wanted = name.get_ref().as_str();
    let is_family = sort_of(wanted).is_some_and(|sort| takes(sorts, sort)) && runner::own_size(wanted).is_none();
    if is_family || base.families.contains(&wanted) {
        return Ok(wanted.to_owned().leak());
    }
    let known = taken::families(base, sorts);
    let near = did_you_mean(wanted, known.iter().copied());
    let problem = format!("`{wanted}` is no family that `{}` takes; those are {}{near}", base.id, known.join(", "));
    Err(source.refused(name.span(), problem))
}

/// A real input by its name, or a file.
fn input(
    base: &Experiment,
    sorts: &[Sort],
    name: &Spanned<String>,
    source: &Source<'_>,
    own: &mut BTreeMap<String, OwnInput>,
) -> Result<&'static str, ConfigError> {
    let wanted = name.get_ref();
    let refused = |problem: String| source.refused(name.span(), problem);
    let sort = if runner::own_size(wanted).is_some() {
        sort_of(wanted)
    } else {
        let file = source.file.parent().unwrap_or(Path::new("")).join(wanted);
        if !file.exists() {
            let known = taken::inputs(sorts);
            let near = did_you_mean(wanted, known.iter().copied());
            let known = known.join(", ");
            return Err(refused(format!(
                "`{wanted}` is neither a real input nor a file; `{}` takes the real inputs {known}{near}",
                base.id
            )));
        }
        if !takes(sorts, Sort::Points) {
            return Err(refused(format!("`{}` takes generated families only, and no files of points", base.id)));
        }
        let reading = read_telling(&PointSource::of_file(file), Wanted::Any)?;
        if let Some(remarks) = reading.remarks() {
            tell(&format!("{wanted}: {remarks}"));
        }
        let (points, sort) = match reading.points {
            Points::Plane(points) => (Cloud::Plane(points), Sort::Points),
            Points::Space(points) => (Cloud::Space(points), Sort::Clouds),
            Points::Four(points) => (Cloud::Four(points), Sort::Clouds),
            Points::Line(_) => return Err(refused(format!("`{wanted}` has one coordinate; inputs have two to four"))),
        };
        if let Some(reason) = (base.refuses)(&points) {
            return Err(refused(format!("`{}` does not take `{wanted}`: {reason}", base.id)));
        }
        own.insert(wanted.clone(), OwnInput { name: wanted.clone(), points });
        Some(sort)
    };
    if !sort.is_some_and(|sort| takes(sorts, sort)) {
        return Err(refused(format!("`{}` takes no inputs like `{wanted}`", base.id)));
    }
    Ok(wanted.clone().leak())
}

fn variant(base: &Experiment, name: &Spanned<String>, source: &Source<'_>) -> Result<Variant, ConfigError> {
    let wanted = name.get_ref();
    base.variants.iter().find(|variant| variant.id == wanted).copied().ok_or_else(|| {
        let known: Vec<&str> = base.variants.iter().map(|variant| variant.id).collect();
        let near = did_you_mean(wanted, known.iter().copied());
        let problem = format!("`{}` has no variant `{wanted}`; they are {}{near}", base.id, known.join(", "));
        source.refused(name.span(), problem)
    })
}

fn within<T: Copy + PartialOrd + std::fmt::Display>(
    number: &Spanned<T>,
    range: std::ops::RangeInclusive<T>,
    source: &Source<'_>,
) -> Result<T, ConfigError> {
    if range.contains(number.get_ref()) {
        return Ok(*number.get_ref());
    }
    let problem = format!("{} is not between {} and {}", number.get_ref(), range.start(), range.end());
    Err(source.refused(number.span(), problem))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Config, String> {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let file = folder.path().join("my.toml");
        fs::write(&file, text).expect("written");
        fs::write(folder.path().join("mine.csv"), "x,y\n0,0\n1,0\n0,1\n").expect("written");
        fs::write(folder.path().join("mine.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n")
            .expect("written");
        fs::write(folder.path().join("flat.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").expect("written");
        let place = format!("{}: ", file.display());
        Config::read(&file).map_err(|error| error.to_string().replacen(&place, "", 1))
    }

    #[test]
    fn what_is_given_takes_the_place_of_the_catalog() {
        let text = "[experiment.hull-scaling]\nfamilies = [\"disc\"]\nsizes = [8, 16]\ninstances = 1\n\
                    variants = [\"brute_force\"]\ninputs = [\"mine.csv\", \"italy\"]\nrepetitions = 2\n\
                    [experiment.enclosing-quality]\nfamilies = []\ninputs = [\"mine.obj\"]\n";
        let config = read(text).expect("all of it is known");
        let [hull, quality] = config.experiments[..] else { panic!("two experiments") };
        assert_eq!(
            (hull.id, hull.families, hull.real_inputs),
            ("hull-scaling", &["disc"][..], &["mine.csv", "italy"][..])
        );
        assert_eq!((hull.sizes.full, hull.instances.quick, hull.variants.len()), (&[8, 16][..], 1, 1));
        assert!(hull.fits.iter().all(|plan| plan.variant == "brute_force" && plan.families == ["disc"]));
        assert_eq!(hull.timing.map(|timing| (timing.repetitions.quick, timing.sizes.quick)), Some((2, &[8, 16][..])));
        assert_eq!((quality.real_inputs, quality.variants.len() > 1), (&["mine.obj"][..], true));
        let names: Vec<&str> = config.inputs.iter().map(|input| input.name.as_str()).collect();
        assert_eq!((names, config.inputs_digest.len()), (vec!["mine.csv", "mine.obj"], 64));
    }

    #[test]
    fn complaints_name_the_place() {
        let hull = |line: &str| format!("[experiment.hull-scaling]\n{line}\n");
        for (line, near) in [
            ("families = [\"Disc\"]", ", disc, "),
            ("families = [\"disk\"]", "did you mean `disc`?"),
            ("inputs = [\"itali\"]", "did you mean `italy`?"),
        ] {
            let found = read(&hull(line)).expect_err(line);
            assert!(found.contains(near), "{found}");
        }
        for (text, complaint) in [
            (hull("sise = [8]"), "line 2, column 1: unknown field `sise`"),
            ("[experiments.x]\n".to_owned(), "line 1, column 2: unknown field `experiments`"),
            ("[experiment.no-such]\n".to_owned(), "line 1, column 1: there is no experiment `no-such`"),
            (hull("sizes = [8, 0]"), "line 2, column 13: 0 is not between 1 and 10000000"),
            (hull("families = [\"disc\", \"box_sums\"]"), "line 2, column 21: `box_sums` is no family that"),
            (hull("families = [\"italy\"]"), "line 2, column 13: `italy` is no family that"),
            (hull("variants = [\"magic\"]"), "line 2, column 13: `hull-scaling` has no variant `magic`; they are by_"),
            (hull("inputs = [\"lost.csv\"]"), "line 2, column 11: `lost.csv` is neither a real input nor a file"),
            (hull("inputs = [\"mine.obj\"]"), "line 2, column 11: `hull-scaling` takes no inputs like `mine.obj`"),
            (
                "[experiment.enclosing-quality]\ninputs = [\"mine.csv\"]".to_owned(),
                "line 2, column 11: `enclosing-quality` does not take `mine.csv`: it compares volumes, and",
            ),
            (
                "[experiment.enclosing-quality]\ninputs = [\"flat.obj\"]".to_owned(),
                "line 2, column 11: `enclosing-quality` does not take `flat.obj`: it compares volumes, and",
            ),
            (
                "[experiment.collision-scaling]\ninputs = [\"mine.csv\"]".to_owned(),
                "line 2, column 11: `collision-scaling` takes generated families only",
            ),
            (hull("sizes = 8"), "line 2, column 9: invalid type: integer `8`, expected a sequence"),
            (
                "[experiment.gauge-passes]\nrepetitions = 2\n".to_owned(),
                "line 2, column 15: `gauge-passes` takes no ti",
            ),
            ("[".to_owned(), "line 1, column "),
            ("[experiment]\n".to_owned(), "line 1, column 1: names no experiment"),
        ] {
            let found = read(&text).expect_err("nothing sensible is asked for");
            assert!(found.starts_with(complaint), "{found}");
        }
    }
}
