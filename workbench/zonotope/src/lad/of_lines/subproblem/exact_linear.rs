//! The exact linear term of a subproblem, summed up only when a decision asks for it.

use std::cell::OnceCell;
use std::rc::Rc;

use crate::lad::of_lines::input::LadProblem;
use crate::numeric::dyadic::Dyadic;

/// A linear term in parts: a known vector, plus the signed normals of the lines that the subproblem leaves out.
///
/// A search that prunes several times keeps a layer of signs for each time. The exact sum over a layer costs more
/// than a pass in floating point, and is made where a decision needs it.
#[derive(Debug, Clone)]
pub(crate) struct ExactLinear {
    known: [Dyadic; 2],
    layers: Vec<Rc<FixedSigns>>,
}

/// One sign for each line of a subproblem, 0 for those that stay in the objective.
#[derive(Debug)]
struct FixedSigns {
    /// The position in the problem of each line; the line itself when absent.
    members: Option<Rc<[u32]>>,
    signs: Vec<i8>,
    /// Their exact sum: several subproblems share a layer, and it is summed up for the first that asks.
    sum: OnceCell<[Dyadic; 2]>,
}

impl FixedSigns {
    fn sum(&self, problem: &LadProblem) -> &[Dyadic; 2] {
        self.sum.get_or_init(|| {
            let position = |i: usize| self.members.as_ref().map_or(i, |members| members[i] as usize);
            let signed = self.signs.iter().enumerate().filter(|(_, sign)| **sign != 0);
            problem.exact.signed_normal_sum(&mut signed.map(|(i, &sign)| (position(i), sign)))
        })
    }
}

impl ExactLinear {
    /// A known vector.
    pub(super) fn known(known: [Dyadic; 2]) -> Self {
        Self { known, layers: Vec::new() }
    }

    /// No linear term.
    pub(crate) fn zero() -> Self {
        Self::known([Dyadic::zero(), Dyadic::zero()])
    }

    /// The linear term with the signed normals of further lines, which are the given members of the problem.
    pub(super) fn with_fixed_signs(&self, members: Option<Rc<[u32]>>, signs: Vec<i8>) -> Self {
        let mut sum = self.clone();
        sum.layers.push(Rc::new(FixedSigns { members, signs, sum: OnceCell::new() }));
        sum
    }

    /// The signs of the layer that was added last.
    pub(super) fn last_signs(&self) -> &[i8] {
        self.layers.last().map_or(&[], |layer| &layer.signs)
    }

    /// Whether there is no vector beside the signed normals.
    pub(super) fn is_of_signs_alone(&self) -> bool {
        self.known.iter().all(Dyadic::is_zero)
    }

    /// Sets the sign of every line left out, at its position in the problem.
    pub(super) fn add_signs(&self, signs: &mut [i8]) {
        for layer in &self.layers {
            for (line, &sign) in layer.signs.iter().enumerate().filter(|(_, sign)| **sign != 0) {
                signs[layer.members.as_ref().map_or(line, |members| members[line] as usize)] = sign;
            }
        }
    }

    /// The exact sum.
    pub(super) fn value(&self, problem: &LadProblem) -> [Dyadic; 2] {
        let [mut x, mut y] = self.known.clone();
        for layer in &self.layers {
            let [dx, dy] = layer.sum(problem);
            (x, y) = (&x + dx, &y + dy);
        }
        [x, y]
    }
}
