//! The order of the triangles, the stretches of time, and what each status claims.

use super::cover::{Cell, left_out};
use super::{FreeParts, MeshContactAnswer, MeshEncounter, MovingSurface};
use crate::exact::grid::{Grid, check_finite};
use crate::meshes::triangles::{Triangle, meet};
use crate::motion::check::{check_interval, check_times, check_width};
use crate::motion::free::Moving;
use crate::motion::gap::Solid;
use crate::motion::meeting::stretches_at;
use crate::motion::path::{Motion, Path};
use crate::motion::quaternion::{Vector, multiple};
use crate::verdict::{Stop, Verdict};
use dashu_int::IBig;

/// The work on all stretches of an answer: a corner along a direction is one, and more where numbers are long.
const MOST_WORK: u64 = 100_000_000;

/// Proves when two moving meshes meet first, or that they do not, or says what fails. A contact is between two times
/// not farther apart than the resolution.
pub fn check_mesh_contact(surfaces: [MovingSurface<'_>; 2], resolution: f64, answer: &MeshContactAnswer) -> Verdict {
    proved(surfaces, resolution, answer).into()
}

/// A mesh in whole numbers.
struct Mesh {
    vertices: Vec<Vector>,
    triangles: Vec<[usize; 3]>,
}

impl Mesh {
    /// The hull of some triangles.
    fn part(&self, triangles: &[usize]) -> Solid {
        let mut corners: Vec<usize> = triangles.iter().flat_map(|&triangle| self.triangles[triangle]).collect();
        corners.sort_unstable();
        corners.dedup();
        let zero = || IBig::ZERO;
        Solid {
            center: [zero(), zero(), zero()],
            generators: Vec::new(),
            corners: corners.into_iter().map(|corner| self.vertices[corner].clone()).collect(),
            reach: zero(),
        }
    }
}

fn proved(surfaces: [MovingSurface<'_>; 2], resolution: f64, answer: &MeshContactAnswer) -> Result<String, Stop> {
    let (meshes, paths) = read(surfaces)?;
    let end = match answer.encounter {
        MeshEncounter::Separate => 1.0,
        MeshEncounter::Contact { time, triangles } | MeshEncounter::Grazing { time, triangles } => {
            check_times(time)?;
            if triangles.iter().zip(&meshes).any(|(&triangle, mesh)| triangle >= mesh.triangles.len()) {
                return Err(format!("there is no pair of triangles {triangles:?}").into());
            }
            time[0]
        }
    };
    for ((order, mesh), name) in answer.order.iter().zip(&meshes).zip(["a", "b"]) {
        check_permutation(order, mesh.triangles.len(), name)?;
    }
    let boxes = answer.intervals.iter().map(|free| cell(free, &meshes)).collect::<Result<Vec<_>, _>>()?;
    match answer.encounter {
        MeshEncounter::Separate => {}
        MeshEncounter::Contact { time, triangles } => {
            check_width(time, resolution)?;
            prove_contact(&meshes, &paths, triangles, time[1])?;
        }
        MeshEncounter::Grazing { triangles, .. } => check_doubt(answer, triangles, end)?,
    }
    let [rows, columns] = meshes.each_ref().map(|mesh| mesh.triangles.len() as f64);
    if let Some([i, j, time]) = left_out([[0.0, rows], [0.0, columns], [0.0, end]], boxes)? {
        let (i, j) = (answer.order[0][i as usize], answer.order[1][j as usize]);
        let reason = format!("certificate: no interval holds the triangles {i} of a and {j} of b from {time:?} on");
        return Err(reason.into());
    }
    let mut work = MOST_WORK;
    for FreeParts { interval, parts } in &answer.intervals {
        let solids = [0, 1].map(|i| meshes[i].part(&answer.order[i][parts[i][0]..parts[i][1]]));
        Moving { solids: solids.each_ref(), paths: &paths }.prove_free(interval, &mut work)?;
    }
    Ok(in_words(answer))
}

fn in_words(answer: &MeshContactAnswer) -> String {
    let count = answer.intervals.len();
    let intervals = match count {
        0 => "no interval".to_owned(),
        1 => "1 interval with a gap between all triangles at every time".to_owned(),
        _ => format!("{count} intervals with a gap between parts at every time, which hold all pairs of triangles"),
    };
    match answer.encounter {
        MeshEncounter::Separate => format!("separate; {intervals}"),
        MeshEncounter::Contact { time: [_, at], triangles: [i, j] } => {
            format!("contact; {intervals}, and a common point of the triangles {i} and {j} at the time {at:?}")
        }
        MeshEncounter::Grazing { time: [from, _], .. } => format!("grazing; {intervals} before {from:?}"),
    }
}

/// The meshes and their motions in whole numbers of one unit.
fn read(surfaces: [MovingSurface<'_>; 2]) -> Result<([Mesh; 2], [Path; 2]), String> {
    for MovingSurface { vertices, motion, .. } in surfaces {
        if vertices.iter().any(|vertex| vertex.len() != 3) {
            return Err("answered a question about meshes that are not of space".to_owned());
        }
        check_finite("a mesh", vertices.iter().flatten())?;
        motion.check_finite()?;
        match motion {
            Motion::Rest | Motion::Pieces(_) => {}
            Motion::ConstantRate { .. } => {
                return Err("answered a question about a mesh that turns at constant rate".to_owned());
            }
        }
    }
    let numbers = surfaces.iter().flat_map(|surface| {
        let own = surface.vertices.iter().flatten().copied();
        own.chain(surface.motion.lengths())
    });
    let lengths = Grid::of(numbers);
    let of = |surface: &MovingSurface<'_>| -> Result<(Mesh, Path), String> {
        let vertex = |v: &Vec<f64>| [0, 1, 2].map(|k| lengths.units(v[k]));
        let triangle = |corners: &Vec<usize>| {
            let corners = <[usize; 3]>::try_from(corners.as_slice()).ok();
            corners.filter(|corners| corners.iter().all(|&corner| corner < surface.vertices.len()))
        };
        let triangles = surface.triangles.iter().map(triangle).collect::<Option<Vec<_>>>();
        let triangles = triangles.filter(|triangles| !triangles.is_empty());
        let triangles = triangles.ok_or("answered a question about a mesh whose triangles are not there")?;
        let mesh = Mesh { vertices: surface.vertices.iter().map(vertex).collect(), triangles };
        Ok((mesh, Path::of(surface.motion, lengths)?))
    };
    let [(a, of_a), (b, of_b)] = [of(&surfaces[0])?, of(&surfaces[1])?];
    Ok(([a, b], [of_a, of_b]))
}

/// Refuses an order that has not each triangle once.
fn check_permutation(order: &[usize], count: usize, name: &str) -> Result<(), String> {
    let mut is_there = vec![false; count];
    let is_new =
        |&triangle: &usize| is_there.get_mut(triangle).is_some_and(|is_there| !std::mem::replace(is_there, true));
    match order.len() == count && order.iter().all(is_new) {
        true => Ok(()),
        false => Err(format!("certificate: the order of {name} has not each of the {count} triangles once")),
    }
}

/// The box of a stretch.
fn cell(FreeParts { interval, parts }: &FreeParts, meshes: &[Mesh; 2]) -> Result<Cell, String> {
    check_interval(interval)?;
    if interval.from < 0.0 || interval.to > 1.0 {
        return Err(format!("certificate: an interval goes from {:?} to {:?}", interval.from, interval.to));
    }
    for ([from, to], mesh) in parts.iter().zip(meshes) {
        if from >= to || *to > mesh.triangles.len() {
            return Err(format!("certificate: an interval is of the triangles from {from} to below {to} of an order"));
        }
    }
    let [a, b] = parts.map(|part| part.map(|position| position as f64));
    Ok([a, b, [interval.from, interval.to]])
}

/// Proves that two triangles meet at a time.
fn prove_contact(meshes: &[Mesh; 2], paths: &[Path; 2], triangles: [usize; 2], time: f64) -> Result<(), String> {
    let do_meet = stretches_at(paths, time).iter().any(|stretches| {
        let placed = |i: usize| -> Triangle {
            let other = stretches[1 - i].scale();
            let mesh = &meshes[i];
            mesh.triangles[triangles[i]].map(|corner| multiple(&other, &stretches[i].image(&mesh.vertices[corner])))
        };
        meet(&placed(0), &placed(1))
    });
    let [i, j] = triangles;
    if do_meet { Ok(()) } else { Err(format!("the triangles {i} of a and {j} of b do not meet at the time {time:?}")) }
}

/// Refuses triangles in doubt from a time on that some interval holds after it.
fn check_doubt(answer: &MeshContactAnswer, triangles: [usize; 2], time: f64) -> Result<(), String> {
    let places = [0, 1].map(|i| answer.order[i].iter().position(|&triangle| triangle == triangles[i]));
    let holds = |free: &FreeParts| {
        let is_within = |i: usize| places[i].is_some_and(|place| (free.parts[i][0]..free.parts[i][1]).contains(&place));
        free.interval.to > time && is_within(0) && is_within(1)
    };
    let [i, j] = triangles;
    if answer.intervals.iter().any(holds) {
        return Err(format!("the triangles {i} of a and {j} of b are in doubt, but an interval holds them later"));
    }
    Ok(())
}
