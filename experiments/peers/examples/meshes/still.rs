//! Two copies of a mesh that stand still: whether they meet, by every contender on the same poses.

use std::hint::black_box;
use std::time::Instant;

use anyhow::{Error, ensure};
use experiments::hierarchies::{Asked, MESHES, Scene, scene};
use obvhs::BvhBuildParams;
use zonotope::Pose;
use zonotope::bvh::{Aabb, OrientedBox, Zonotope3, Zonotope4, Zonotope5, Zonotope6};

use super::contender::{Contender, Entry};
use super::obb::Turn;
use super::parry;
use super::trees::{Paired, Tree};

/// The least of so many rounds is the time of a question.
const ROUNDS: usize = 5;

/// No round begins when a question about a pose has taken so many seconds.
const LONGEST: f64 = 0.1;

/// Poses of each placing of the scene: those apart, and the overlapping one.
const PLACES: usize = 5;

/// The measurements of a contender in a case.
struct Measured {
    microseconds: f64,
    /// Poses of which it is told wrongly whether the copies meet.
    wrong: usize,
    /// The pairs at each pose, if they are asked for.
    pairs: Vec<usize>,
}

/// Prints the race over all meshes.
pub fn race(count: usize) -> anyhow::Result<()> {
    println!("still meshes: {count} poses a mesh, seed 1; mean over poses of the least of {ROUNDS} rounds");
    println!("mesh,triangles,case,contender,build_ms,microseconds,of_best_ours,wrong,other_pairs");
    for name in MESHES {
        let scene = scene(name, count, 1).map_err(Error::msg)?;
        let placed = scene.placed.iter();
        let poses: Vec<Pose> = placed.flat_map(|p| p.apart.into_iter().chain([p.overlapping])).collect();
        let entries = entries(&scene, &poses)?;
        for asked in Asked::all() {
            let lines = entries.iter().map(|entry| measured(asked, entry.contender.as_ref(), count));
            let lines = lines.collect::<anyhow::Result<Vec<_>>>()?;
            print(name, &scene, asked, &entries, &lines);
        }
    }
    Ok(())
}

fn entries(scene: &Scene, poses: &[Pose]) -> anyhow::Result<Vec<Entry>> {
    let mesh = &scene.mesh;
    let preset = BvhBuildParams::very_slow_build();
    // pairs of triangles cost more than the pairs of rays and triangles that the preset is made for
    let small_leaves = BvhBuildParams { collapse_traversal_cost: 1.0, ..preset };
    let isometries = || poses.iter().map(parry::isometry).collect();
    let turns = || poses.iter().map(Turn::of).collect();
    Ok(vec![
        Entry::ours::<Aabb>(mesh, poses)?,
        Entry::ours::<OrientedBox>(mesh, poses)?,
        Entry::ours::<Zonotope3>(mesh, poses)?,
        Entry::ours::<Zonotope4>(mesh, poses)?,
        Entry::ours::<Zonotope5>(mesh, poses)?,
        Entry::ours::<Zonotope6>(mesh, poses)?,
        Entry::of("parry3d-f64", || parry::mesh(mesh), |mesh| parry::Doubles { mesh, poses: isometries() })?,
        Entry::of("parry3d", || parry::single_mesh(mesh), |mesh| parry::Singles::new(mesh, poses))?,
        Entry::of("parry3d-f64 leaf_pairs", || parry::mesh(mesh), |mesh| parry::LeafPairs { mesh, turns: turns() })?,
        // tests of 3, 6 and 15 axes were tried: these are the quickest for each tree
        Entry::of("obvhs very slow", || Ok(Tree::of_obvhs(mesh, preset)), |tree| Paired::<15>::new(tree, poses))?,
        Entry::of(
            "obvhs small leaves",
            || Ok(Tree::of_obvhs(mesh, small_leaves)),
            |tree| Paired::<15>::new(tree, poses),
        )?,
        Entry::of("bvh", || Ok(Tree::of_bvh(mesh)), |tree| Paired::<6>::new(tree, poses))?,
    ])
}

fn measured(asked: Asked, contender: &dyn Contender, count: usize) -> anyhow::Result<Option<Measured>> {
    let place = if let Asked::Apart(at) = asked { at } else { PLACES - 1 };
    let is_overlapping = place == PLACES - 1;
    let mut measured = Measured { microseconds: 0.0, wrong: 0, pairs: Vec::new() };
    for at in (0..count).map(|i| PLACES * i + place) {
        let (mut least, mut spent, mut found) = (f64::INFINITY, 0.0, None);
        for _ in 0..ROUNDS {
            let start = Instant::now();
            let again = match asked {
                Asked::AllPairs => black_box(contender.pairs(black_box(at))?),
                _ => black_box(Some(usize::from(contender.meets(black_box(at))?))),
            };
            let time = start.elapsed().as_secs_f64();
            ensure!(found.is_none() || found == again, "an answer is not the same a second time");
            (found, least, spent) = (again, time.min(least), spent + time);
            if spent > LONGEST {
                break;
            }
        }
        let Some(pairs) = found else { return Ok(None) };
        measured.microseconds += 1e6 * least / count as f64;
        measured.wrong += usize::from((pairs > 0) != is_overlapping);
        measured.pairs.push(pairs);
    }
    Ok(Some(measured))
}

fn print(name: &str, scene: &Scene, asked: Asked, entries: &[Entry], lines: &[Option<Measured>]) {
    let ours = || entries.iter().zip(lines).filter(|(entry, _)| entry.is_ours).filter_map(|(_, line)| line.as_ref());
    let best = ours().map(|line| line.microseconds).fold(f64::INFINITY, f64::min);
    let exact = ours().next().map_or(&[][..], |line| &line.pairs);
    for (entry, line) in entries.iter().zip(lines) {
        let Some(Measured { microseconds, wrong, pairs }) = line else { continue };
        println!(
            "{name},{},{},{},{:.2},{microseconds:.2},{:.2},{wrong},{}",
            scene.mesh.triangles().len(),
            asked.name(),
            entry.name,
            entry.build,
            microseconds / best,
            pairs.iter().zip(exact).filter(|(told, exact)| told != exact).count(),
        );
    }
}
