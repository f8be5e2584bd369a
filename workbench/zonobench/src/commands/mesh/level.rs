//! `zonobench mesh A --level N`: the bounding volumes of a level, as an answer and as meshes.

use std::fmt::Write as _;

use anyhow::Context;
use batch::Verdict;
use serde_json::{Value, json};
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{Faces, faces};

use super::options::Options;
use super::reading::Read;
use super::summary::{ending, of_mesh};
use crate::commands::Ending;
use crate::commands::asked::{Asked, floats};
use crate::commands::placing::put;
use crate::commands::table::{Table, counted};
use crate::commands::usage::{check_inputs, check_names, question_name};
use crate::input::OptionNames;
use crate::output::{Existing, Outputs, Results};

pub(super) fn run(options: &Options, level: u64) -> anyhow::Result<Ending> {
    let inputs = [options.a.as_path()];
    check_inputs(&inputs)?;
    let named = [("JSON", options.json.as_ref()), ("JSON", options.question.as_ref()), ("OBJ", options.obj.as_ref())];
    check_names(&named)?;
    let outputs = options.json.iter().chain(&options.question).chain(&options.obj);
    let outputs = Outputs::checked(outputs, &inputs, Existing::from_force(options.force))?;
    let pose = put(3, options.turn.as_ref(), options.shift.as_ref(), OptionNames::OF_FIRST)?;
    let mesh = Read::in_doubles(&options.a, options.format, pose.as_ref())?;
    let input = json!({"a": mesh.question, "level": level});
    let mut question = json!({"id": question_name(&options.a), "kind": "mesh_level", "input": input});
    if let Some(volume) = &options.volume {
        question["method"] = volume.as_str().into();
    }
    let asked = Asked::of(question)?;
    let verdict = asked.verdict();
    let nodes = asked.result()["nodes"].as_array().map_or(&[][..], Vec::as_slice);
    let [question, answer] = [&asked.question, &asked.answer].map(|content| format!("{content}\n").into_bytes());
    let mut results = Results::default();
    results.add(options.question.as_ref(), || Ok(question));
    results.add(options.json.as_ref(), || Ok(answer));
    results.add(options.obj.as_ref(), || Ok(to_obj(nodes)?.into_bytes()));
    let mut table = Table::default();
    table.row("mesh", of_mesh(&options.a, &mesh));
    let largest = nodes.iter().filter_map(|node| node["triangles"].as_array().map(Vec::len)).max().unwrap_or(0);
    let volumes = counted(nodes.len(), "volume", "volumes");
    let most = counted(largest, "triangle", "triangles");
    table.row("level", format!("{level}: {volumes}, with at most {most} each"));
    ending(&mut table, options, &asked, &verdict);
    outputs.finish(results, &table.text())?;
    Ok(if matches!(verdict, Verdict::Wrong(_)) { Ending::Bad } else { Ending::Good })
}

/// The volumes without their margins, an object each. One that is flat to a segment or a point is a line or a point.
fn to_obj(nodes: &[Value]) -> anyhow::Result<String> {
    let mut text = String::new();
    let mut before = 0;
    for (number, node) in (1..).zip(nodes) {
        let space = |v: &Value| <[f64; 3]>::try_from(floats(v)).expect("the answer is about space");
        let generators = node["generators"].as_array().map_or(&[][..], Vec::as_slice);
        let body = Zonotope::new(space(&node["center"]), generators.iter().map(space).collect())?;
        let name = || format!("the volume of node {number}");
        writeln!(text, "o node_{number}")?;
        let mut add_points = |points: &[[f64; 3]], element: char| -> anyhow::Result<()> {
            points.iter().try_for_each(|[x, y, z]| writeln!(text, "v {x:?} {y:?} {z:?}"))?;
            let places = (1..=points.len()).map(|at| format!(" {}", before + at));
            Ok(writeln!(text, "{element}{}", places.collect::<String>())?)
        };
        match faces(&body, &mut ()).with_context(name)? {
            Faces::Point(point) => {
                add_points(&[point], 'p')?;
                before += 1;
            }
            Faces::Segment(ends) => {
                add_points(&ends, 'l')?;
                before += ends.len();
            }
            Faces::Flat(lattice) | Faces::Solid(lattice) => {
                lattice.add_to_obj(&mut text, before);
                before += lattice.vertex_count();
            }
        }
    }
    Ok(text)
}
