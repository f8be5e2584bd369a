//! Sections 4 and 4.1: the enclosing zonogon of least area.

pub(crate) mod area_formula;
pub(crate) mod candidates;
pub(crate) mod combinatorial_description;
pub(crate) mod corollary_4_4;
pub(crate) mod deciding_side;
pub(crate) mod edge_criterion;
pub(crate) mod edges_along_a_line;
pub(crate) mod evaluation;
pub(crate) mod figure_2;
pub(crate) mod fixed_center;
pub(crate) mod halving;
pub(crate) mod hull_suffices;
pub(crate) mod lemma_4_1;
pub(crate) mod lemma_4_2;
pub(crate) mod lemma_4_3;
pub(crate) mod linear_coefficient;
pub(crate) mod minimum_at_vertex;
pub(crate) mod theorem_4_5;
pub(crate) mod volume_formula;
pub(crate) mod zonoids;
