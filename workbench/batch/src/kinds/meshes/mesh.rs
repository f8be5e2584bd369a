//! `mesh`: whether two meshes of triangles meet, in which pairs of triangles, or how far apart they are.

use serde_json::{Value, json};
use verifier::{Body, MeshAnswer, Surface, Verdict, check_meshes};
use zonotope::bvh::{Encounter, MeshDistance, Method};

use crate::claimed::{Traced, boolean, float, indices, member, pose, vectors};
use crate::fields::Fields;
use crate::json::to_json;
use crate::kinds::{Kind, Solution};
use crate::meshes::{Placing, SPACE, placing};
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "mesh",
    summary: "whether two meshes of triangles meet, in which pairs, or how far apart they are",
    fields: &["a", "b"],
    optional: &["pairs"],
    methods: || Method::ALL.map(Method::id).to_vec(),
    solve,
    check,
};

/// The most pairs of triangles that are listed.
const PAIR_LIMIT: usize = 1_000_000;

fn solve(fields: &Fields<'_>, method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let named = |name| Method::from_id(name).expect("the kind lists the names of these methods");
    let method = method.map_or(Method::default(), named);
    let Placing { meshes, poses } = placing(fields)?;
    let wants_pairs = fields.flag("pairs")?;
    let placed = [meshes[0].at(&poses[0]), meshes[1].at(&poses[1])];
    let result = if wants_pairs {
        let too_many =
            || format!("more than {PAIR_LIMIT} pairs of triangles meet; ask without `pairs` for one of them");
        let pairs = method.pairs(placed, PAIR_LIMIT, &mut ());
        of_pairs(&pairs.ok_or_else(|| Refusal::new(Code::TooLarge, too_many()))?)
    } else {
        match method.encounter(placed, &mut ()) {
            Encounter::Meeting(witness) => json!({"intersects": true, "witness": witness}),
            Encounter::Apart(distance) => json!({"intersects": false, "distance": of_distance(&distance)}),
        }
    };
    Ok(Solution { method: method.id(), result })
}

fn of_pairs(pairs: &[[usize; 2]]) -> Value {
    match pairs.first() {
        Some(witness) => json!({"intersects": true, "witness": witness, "pairs": pairs}),
        None => json!({"intersects": false, "pairs": pairs}),
    }
}

fn of_distance(distance: &MeshDistance) -> Value {
    json!({"lower": to_json(distance.lower), "upper": to_json(distance.upper)})
}

/// A mesh of a question, read for the check.
pub(in crate::kinds) struct Read {
    pub(in crate::kinds) vertices: Vec<Vec<f64>>,
    pub(in crate::kinds) triangles: Vec<Vec<usize>>,
    pose: Option<verifier::Pose>,
}

impl Read {
    pub(in crate::kinds) fn of(input: Traced<'_>, name: &str) -> Result<Self, String> {
        let mesh = member(input, name)?;
        let rows = member(mesh, "triangles")?.elements().ok_or("`triangles` is not a list")?;
        Ok(Self {
            vertices: vectors(member(mesh, "vertices")?, "vertices")?,
            triangles: rows.map(|row| positions(row, "triangles")).collect::<Result<_, _>>()?,
            pose: mesh.field("pose").map(|tree| pose(tree, SPACE)).transpose()?,
        })
    }

    /// The mesh where its pose puts it, in doubles.
    pub(in crate::kinds) fn image(mut self) -> Result<Self, String> {
        if let Some(pose) = self.pose.take() {
            let none: &[Vec<f64>] = &[];
            let image = |vertex: &Vec<f64>| {
                let image = Body { center: vertex, generators: none, pose: Some(&pose) }.image();
                image.map(|(image, _)| image).ok_or("the pose gives the mesh an image that no doubles hold")
            };
            self.vertices = self.vertices.iter().map(image).collect::<Result<_, _>>()?;
        }
        Ok(self)
    }

    pub(in crate::kinds) fn surface(&self) -> Surface<'_> {
        Surface { vertices: &self.vertices, triangles: &self.triangles, pose: self.pose.as_ref() }
    }
}

fn positions(row: Traced<'_>, name: &str) -> Result<Vec<usize>, String> {
    let row = row.tree.list().ok_or_else(|| format!("`{name}` holds something else than lists"))?;
    let read = row.iter().map(crate::json::Tree::index).collect::<Option<_>>();
    read.ok_or_else(|| format!("`{name}` holds something else than whole numbers"))
}

pub(in crate::kinds) fn pair(positions: Vec<usize>, name: &str) -> Result<[usize; 2], String> {
    positions.try_into().map_err(|_| format!("`{name}` is not a pair"))
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<Verdict, String> {
    let [a, b] = [Read::of(input, "a")?, Read::of(input, "b")?];
    let wants_pairs = input.field("pairs").is_some() && boolean(input, "pairs")?;
    let pairs = || -> Result<Vec<[usize; 2]>, String> {
        let rows = member(result, "pairs")?.elements().ok_or("`pairs` is not a list")?;
        rows.map(|row| pair(positions(row, "pairs")?, "pairs")).collect()
    };
    let pairs = if wants_pairs { Some(pairs()?) } else { None };
    let answer = if boolean(result, "intersects")? {
        MeshAnswer::Meeting { witness: pair(indices(result, "witness")?, "witness")?, pairs }
    } else if let Some(pairs) = pairs {
        if !pairs.is_empty() {
            return Err("meshes that do not meet have pairs of triangles that do".to_owned());
        }
        MeshAnswer::Apart { distance: None }
    } else {
        let distance = member(result, "distance")?;
        MeshAnswer::Apart { distance: Some([float(distance, "lower")?, float(distance, "upper")?]) }
    };
    Ok(check_meshes(&a.surface(), &b.surface(), &answer).in_words())
}
