//! `zonobench inspect`: what kind of body a zonotope is.

mod drawing;
mod measures;
mod options;
mod summary;
mod vertices;

pub use self::options::Options;

use self::measures::Measures;
use self::vertices::{VertexFormat, VerticesError};
use super::Ending;
use super::asked::{About, Asked, check_taken, record};
use super::usage::question_name;
use super::usage::{check_inputs, check_names, tell};
use crate::input::{OptionNames, RoundedBody};
use crate::output::{Existing, Outputs, Results};
use batch::MAX_DIMENSION;
use batch::Verdict;

/// Reads, counts, measures, checks, and prints a summary.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let inputs = options.placing.inputs(&options.file);
    check_inputs(&inputs)?;
    check_names(&[
        ("SVG", options.svg.as_ref()),
        ("JSON", options.json.as_ref()),
        ("JSON", options.question.as_ref()),
    ])?;
    check_names(&options.meshes.named())?;
    let outputs = [&options.svg, &options.json, &options.question, &options.vertices];
    let outputs = outputs.into_iter().flatten().chain(options.meshes.files());
    let outputs = Outputs::checked(outputs, &inputs, Existing::from_force(options.force))?;
    let corners = options.vertices.as_ref().map(|file| Ok::<_, VerticesError>((file, VertexFormat::of(file)?)));
    let corners = corners.transpose()?;
    let file = options.placing.read(&options.file, options.format, options.start.told(), OptionNames::OF_FIRST)?;
    let request = record(About::Inspect, &[&file], None, None);
    let placed = file.placed;
    check_taken(&options.file, &placed, 1..=MAX_DIMENSION)?;
    let RoundedBody { body, off } = placed.rounded(&options.file)?;
    let measures = match body.center.len() {
        1 => Measures::of::<1>(&placed, &body),
        2 => Measures::of::<2>(&placed, &body),
        3 => Measures::of::<3>(&placed, &body),
        4 => Measures::of::<4>(&placed, &body),
        5 => Measures::of::<5>(&placed, &body),
        _ => Measures::of::<6>(&placed, &body),
    };

    let name = question_name(&options.file);
    let asked = Asked::even_if_refused(About::Inspect.question(&name, &[placed.question()], None, None));
    let [question, answer] = asked.lines(request);
    let mut results = Results::default();
    results.add(options.svg.as_ref(), || Ok(drawing::draw(&name, &body).into_bytes()));
    results.add(corners.map(|(file, _)| file), || {
        let format = corners.map_or(VertexFormat::Csv, |(_, format)| format);
        Ok(format.text(&name, &body, tell)?.into_bytes())
    });
    options.meshes.add_to(&mut results, &name, &body);
    results.add(options.question.as_ref(), || Ok(question));
    results.add(options.json.as_ref(), || Ok(answer));
    let verdict = asked.verdict();
    outputs.finish(results, &summary::summary(options, (&placed, off), &measures, &asked.answer, &verdict))?;
    Ok(if matches!(verdict, Verdict::Wrong(_)) { Ending::Bad } else { Ending::Good })
}
