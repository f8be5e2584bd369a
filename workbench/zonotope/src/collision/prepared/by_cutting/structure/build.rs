//! Building the structure: which generators cross the part of a step, in their order along its cuts, and the sums of
//! the others with their signs.

use std::num::NonZeroU32;

use super::boundary::Boundary;
use super::crossing_lists::crossing_lists;
use super::inner_direction::Frame;
use super::sums::Sums;
use super::tree::{Condition, Cut, Place, SUM_STEP, Step, Trapezoid, Tree};
use super::turning_order::turning_order;
use crate::arrangement::cutting::{self, Cutting, Part, SearchStep};
use crate::arrangement::dual::DualArrangement;
use crate::collision::prepared::by_cutting::filtered::{Filtered, sign_of_product};
use crate::numeric::double_double::DoubleDoubleDirection;
use crate::numeric::exact_linear::{ExactVector, exact, sum};
use crate::numeric::signed_sum::signed_sum;
use crate::tally::Tally;

/// What is known of a part before its cuts are made.
struct Waiting {
    frame: Frame,
    /// The sum of the generators whose lines do not cross it, with their signs in it.
    others: ExactVector,
}

impl Tree {
    /// The structure over a (1/r)-cutting of the lines of generators.
    pub(crate) fn new(
        dual: &DualArrangement,
        generators: &[[f64; 3]],
        r: NonZeroU32,
        seed: u64,
        tally: &mut impl Tally,
    ) -> Self {
        let cutting = cutting::cutting(dual.lines(), r, seed, tally);
        let lists = crossing_lists(dual.lines(), &cutting);
        let boundaries = boundaries_of_parts(&cutting);
        let mut builder = Builder {
            generators,
            cuts: Vec::new(),
            trapezoids: vec![None; cutting.trapezoids().len()],
            places: Vec::new(),
            sums: Sums::new(),
        };
        let has_direction = |index: &u32| generators[*index as usize] != [0.0; 3];
        let all: Vec<u32> = (0..generators.len() as u32).filter(has_direction).collect();
        builder.cuts_of(&[Boundary::Horizon], &all, exact([0.0; 3]), tally);
        let has_no_line = |v: &&[f64; 3]| v[0] == 0.0 && v[1] == 0.0;
        let up = |v: &[f64; 3]| (*v, if v[2] < 0.0 { -1 } else { 1 });
        let poles = signed_sum(generators.iter().filter(has_no_line).map(up));
        let mut waiting: Vec<Option<Waiting>> = (0..cutting.part_count()).map(|_| None).collect();
        waiting[0] = Some(Waiting { frame: Frame::default(), others: poles });
        let mut first_cuts = Vec::with_capacity(boundaries.len());
        for (number, own) in boundaries.iter().enumerate() {
            let Waiting { frame, others } = waiting[number].take().expect("a part comes behind what it is a part of");
            let crossing = &lists[number];
            first_cuts.push(builder.cuts.len() as u32);
            match cutting.part(number as u32) {
                Part::Trapezoid(trapezoid) => builder.trapezoid(trapezoid.0, crossing, others),
                Part::Cut(boundary, parts) => {
                    for (frame, part) in frame.cut(Boundary::of_cut(boundary), generators).into_iter().zip(parts) {
                        let others = builder.others(&others, crossing, &lists[part as usize], &frame);
                        waiting[part as usize] = Some(Waiting { frame, others });
                    }
                    builder.cuts_of(own, crossing, others, tally);
                }
            }
        }
        let steps = (0..cutting.step_count()).map(|step| match cutting.step(step) {
            SearchStep::Found(trapezoid) => {
                let own = builder.trapezoids[trapezoid.0 as usize];
                Step::Trapezoid(own.expect("each trapezoid is a part"))
            }
            SearchStep::Test { part, conditions, within, outside } => {
                let mut own = [None; 4];
                for (place, (boundary, is_beyond)) in own.iter_mut().zip(conditions) {
                    let boundary = Boundary::of_cut(boundary);
                    let position = boundaries[part as usize].iter().position(|other| *other == boundary);
                    let position = position.expect("the boundaries of a part are those of its tests") as u32;
                    *place = Some(Condition { cut: first_cuts[part as usize] + position, is_beyond });
                }
                Step::Test { conditions: own, within, outside }
            }
        });
        let steps = steps.collect();
        let Builder { mut cuts, mut places, mut sums, .. } = builder;
        cuts.shrink_to_fit();
        places.shrink_to_fit();
        sums.shrink_to_fit();
        Self { cuts, steps, places, sums }
    }
}

/// The boundaries that the steps within each part ask for, each once.
fn boundaries_of_parts(cutting: &Cutting) -> Vec<Vec<Boundary>> {
    let mut boundaries = vec![Vec::new(); cutting.part_count() as usize];
    for step in 0..cutting.step_count() {
        if let SearchStep::Test { part, conditions, .. } = cutting.step(step) {
            let own: &mut Vec<Boundary> = &mut boundaries[part as usize];
            for (boundary, _) in conditions {
                let boundary = Boundary::of_cut(boundary);
                if !own.contains(&boundary) {
                    own.push(boundary);
                }
            }
        }
    }
    boundaries
}

struct Builder<'a> {
    generators: &'a [[f64; 3]],
    cuts: Vec<Cut>,
    trapezoids: Vec<Option<Trapezoid>>,
    places: Vec<Place>,
    sums: Sums,
}

impl Builder<'_> {
    /// The sum for a part of a part: with the generators whose lines cross the whole and not this part.
    fn others(&self, others: &ExactVector, whole: &[u32], part: &[u32], frame: &Frame) -> ExactVector {
        let direction = frame.inner_direction(self.generators);
        let rounded = DoubleDoubleDirection::of(&direction);
        let direction = Filtered::new(direction);
        let mut kept = part.iter().peekable();
        let left_over = whole.iter().filter(|index| kept.next_if_eq(index).is_none());
        let signed = left_over.map(|&index| {
            let v = self.generators[index as usize];
            let decided = || sign_of_product(&Filtered::new(v), &direction) as i8;
            (v, rounded.certain_sign(&v).unwrap_or_else(decided))
        });
        sum(others, &signed_sum(signed))
    }

    fn trapezoid(&mut self, number: u32, crossing: &[u32], others: ExactVector) {
        let first_generator = self.places.len();
        let trapezoid = Trapezoid { first_generator, crossing: crossing.len() as u32, others: self.sums.len() };
        self.trapezoids[number as usize] = Some(trapezoid);
        self.places.extend(crossing.iter().map(|&index| Place::new(index, false)));
        self.sums.push(others);
    }

    /// The cuts of a part along boundaries.
    fn cuts_of(&mut self, boundaries: &[Boundary], crossing: &[u32], others: ExactVector, tally: &mut impl Tally) {
        let others_place = self.sums.len();
        if !boundaries.is_empty() {
            self.sums.push(others.clone());
        }
        for &boundary in boundaries {
            let [turning, along] = turning_order(boundary, self.generators, crossing, tally);
            self.cuts.push(Cut {
                boundary,
                first_generator: self.places.len(),
                turning: turning.len() as u32,
                along: along.len() as u32,
                others: others_place,
                first_gradient: self.sums.len(),
            });
            let vectors = |places: &[Place], sign: i8| {
                signed_sum(places.iter().map(|place| (place.vector(self.generators), sign)))
            };
            // at the start of the upper half all are negative; each adds twice itself where it turns
            let mut gradient = sum(&others, &vectors(&turning, -1));
            let steps = turning.chunks_exact(SUM_STEP).map(|places| vectors(places, 1).map(|c| c.scaled(1)));
            let steps: Vec<ExactVector> = steps.collect();
            self.sums.push(gradient.clone());
            for step in steps {
                gradient = sum(&gradient, &step);
                self.sums.push(gradient.clone());
            }
            self.places.extend(turning);
            self.places.extend(along);
        }
    }
}
