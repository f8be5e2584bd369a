//! Contenders of the race of still meshes, and the hierarchies of this library among them.

use std::time::Instant;

use zonotope::Pose;
use zonotope::bvh::{BoundingVolume, Bvh, Mesh};

/// A hierarchy over a mesh with the poses of its copy, in whatever form its library takes them.
pub trait Contender {
    /// Whether the mesh meets its copy under the pose at an index.
    fn meets(&self, at: usize) -> anyhow::Result<bool>;

    /// The pairs of triangles that meet there, if the contender can tell.
    fn pairs(&self, at: usize) -> anyhow::Result<Option<usize>>;
}

/// A contender with its name and the milliseconds of its build.
pub struct Entry {
    pub name: String,
    pub is_ours: bool,
    pub build: f64,
    pub contender: Box<dyn Contender>,
}

/// The quickest of so many builds counts.
const BUILDS: usize = 5;

/// No build begins after one that took so many milliseconds.
const LONGEST_BUILD: f64 = 100.0;

impl Entry {
    /// The entry of a rival: `build` is timed, `contend` is not.
    pub fn of<T, C: Contender + 'static>(
        name: &str,
        build: impl Fn() -> anyhow::Result<T>,
        contend: impl FnOnce(T) -> C,
    ) -> anyhow::Result<Self> {
        let (mut built, mut least) = timed(&build)?;
        for _ in 1..BUILDS {
            if least > LONGEST_BUILD {
                break;
            }
            let (again, time) = timed(&build)?;
            (built, least) = (again, least.min(time));
        }
        Ok(Self { name: name.to_owned(), is_ours: false, build: least, contender: Box::new(contend(built)) })
    }

    /// The entry of this library's hierarchy of a volume.
    pub fn ours<V: BoundingVolume + 'static>(mesh: &Mesh, poses: &[Pose]) -> anyhow::Result<Self> {
        let contend = |hierarchy| Ours::<V> { hierarchy, poses: poses.to_vec() };
        let entry = Self::of(&V::NAME.replace(',', ""), || Ok(Bvh::<V>::build(mesh)), contend)?;
        Ok(Self { is_ours: true, ..entry })
    }
}

/// The contender that is built, and the milliseconds that it took.
fn timed<T>(build: &impl Fn() -> anyhow::Result<T>) -> anyhow::Result<(T, f64)> {
    let start = Instant::now();
    let built = build()?;
    Ok((built, 1e3 * start.elapsed().as_secs_f64()))
}

struct Ours<V> {
    hierarchy: Bvh<V>,
    poses: Vec<Pose>,
}

impl<V: BoundingVolume> Contender for Ours<V> {
    fn meets(&self, at: usize) -> anyhow::Result<bool> {
        let still = self.hierarchy.at(&Pose::IDENTITY);
        Ok(still.witness(self.hierarchy.at(&self.poses[at]), &mut ()).is_some())
    }

    fn pairs(&self, at: usize) -> anyhow::Result<Option<usize>> {
        Ok(Some(self.hierarchy.pairs(self.hierarchy.at(&self.poses[at])).len()))
    }
}
