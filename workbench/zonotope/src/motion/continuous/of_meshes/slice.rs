//! A stretch of time with what the tests of all pairs of parts on it share.

use std::cell::{OnceCell, RefCell};
use std::rc::Rc;

use super::sizes::MeshScene;
use crate::bvh::BoundingVolume;
use crate::bvh::question::Question;
use crate::motion::constant_rate::Timing;
use crate::motion::continuous::gap::ArcPair;
use crate::numeric::linear::{dot, euclidean_norm};
use crate::zonotope::pose::Pose;

/// A stretch of time of a scene.
pub(super) struct Slice<'a, V: BoundingVolume> {
    scene: &'a MeshScene<'a, V>,
    pub(super) times: [f64; 2],
    /// The arcs of both motions, in doubles.
    pub(super) arcs: Rc<ArcPair<f64>>,
    poses: OnceCell<Option<[Pose; 2]>>,
    /// The hierarchies as they stand at the middle.
    question: OnceCell<Option<Question<'a, V>>>,
    change: OnceCell<Option<Change>>,
    halves: OnceCell<[Rc<Self>; 2]>,
    /// The slice from the same begin to the last limit that was asked for.
    cut: RefCell<Option<Rc<Self>>>,
}

/// The change of the second mesh's placement, as the first mesh sees it, from the begin of a stretch to its end.
struct Change {
    rotation: [[f64; 3]; 3],
    translation: [f64; 3],
    /// The root of the sum of the squares of the entries of `rotation`.
    norm: f64,
}

impl<'a, V: BoundingVolume> Slice<'a, V> {
    pub(super) fn new(scene: &'a MeshScene<'a, V>, times: [f64; 2]) -> Rc<Self> {
        let arcs = scene.motions().map(|motion| motion.rounded_arc(times, Timing::Timed));
        Rc::new(Self {
            scene,
            times,
            arcs: Rc::new(ArcPair::new(arcs)),
            poses: OnceCell::new(),
            question: OnceCell::new(),
            change: OnceCell::new(),
            halves: OnceCell::new(),
            cut: RefCell::new(None),
        })
    }

    pub(super) fn width(&self) -> f64 {
        self.times[1] - self.times[0]
    }

    pub(super) fn middle(&self) -> f64 {
        self.times[0] + self.width() / 2.0
    }

    /// The slices before and after a time; those of the middle are made once.
    pub(super) fn cut_at(&self, time: f64) -> [Rc<Self>; 2] {
        let [from, until] = self.times;
        let cut = || [[from, time], [time, until]].map(|times| Self::new(self.scene, times));
        if time == self.middle() { self.halves.get_or_init(cut).clone() } else { cut() }
    }

    /// The slice from the same begin to a limit.
    pub(super) fn until(&self, limit: f64) -> Rc<Self> {
        let mut cut = self.cut.borrow_mut();
        match &*cut {
            Some(known) if known.times[1] == limit => known.clone(),
            _ => cut.insert(Self::new(self.scene, [self.times[0], limit])).clone(),
        }
    }

    /// The poses at the middle, rounded; `None` where they leave the range of doubles.
    pub(super) fn poses(&self) -> Option<[&Pose; 2]> {
        let poses = self.poses.get_or_init(|| self.scene.poses_at(self.middle()));
        poses.as_ref().map(|poses| poses.each_ref())
    }

    /// Whether the volumes of two nodes are apart at the middle, as their test finds them; `None` where it cannot be
    /// asked.
    pub(super) fn are_apart(&self, nodes: [usize; 2]) -> Option<bool> {
        let question = self.question.get_or_init(|| {
            let [p, q] = self.scene.given_poses_at(self.middle())?;
            let [a, b] = self.scene.hierarchies;
            Some(Question::new(a.at(&p), b.at(&q)))
        });
        question.as_ref().map(|question| question.are_apart(question.ordered(nodes)))
    }

    /// About how far a ball of the second mesh goes during the stretch as the first mesh sees it; `None` where that
    /// leaves the range of doubles.
    pub(super) fn way_of(&self, center: &[f64; 3], radius: f64) -> Option<f64> {
        let change = self.change.get_or_init(|| {
            let ((from, begin), (to, end)) = (self.scene.seen_at(self.times[0])?, self.scene.seen_at(self.times[1])?);
            let rotation: [[f64; 3]; 3] = [0, 1, 2].map(|i| [0, 1, 2].map(|j| to[i][j] - from[i][j]));
            let norm = euclidean_norm(&rotation.each_ref().map(euclidean_norm));
            Some(Change { rotation, translation: [0, 1, 2].map(|k| end[k] - begin[k]), norm })
        });
        let Change { rotation, translation, norm } = change.as_ref()?;
        let way = [0, 1, 2].map(|k| dot(&rotation[k], center) + translation[k]);
        Some(euclidean_norm(&way) + norm * radius).filter(|way| way.is_finite())
    }
}
