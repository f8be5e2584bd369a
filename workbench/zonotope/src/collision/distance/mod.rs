//! Problem: how far apart two bodies are, where they are nearest to each other, and how deep they overlap.
//!
//! The bodies A and B meet just when the displacement p of their centres lies in the zonotope Z of the generators of
//! both (Lemma 5.1). If p is outside, the distance of A and B is that of p from Z: a + Σ δ_i v_i in A and b − Σ ε_j w_j
//! in B differ by p − Σ δ_i v_i − Σ ε_j w_j. Membership is the same problem, where B has no generators.
//!
//! The answer is a [`Proximity`]: disjoint with a [`Gap`], touching, or overlapping; decided exactly. A gap comes with
//! coefficients that prove it, a point of each body, and the faces on which these points lie. Where bodies meet
//! instead, [`contact`] has a common point and the faces that touch.
//!
//! | method | dimensions | cost for n generators | what it is |
//! |---|---|---|---|
//! | [`by_support_simplex`] (default) | 1 to 3 | O(n) a step, few steps | extreme vertices in doubles, then the exact face |
//! | [`brute_force`] | any D | O(2^n n^D), exact rationals | the truth: every parallelotope of the body |
//!
//! [`Method`] names them. The default answers as a method of [`Zonotope`](crate::Zonotope) and, under poses, of
//! [`Placed`](crate::Placed): `proximity`. How deep bodies overlap is a problem of its own, [`penetration`].

mod answer;
pub mod brute_force;
pub mod by_support_simplex;
mod contact;
mod method;
mod nearest_simplex;
pub mod penetration;

pub use answer::{Feature, FeatureKind, Gap, Proximity};
pub use contact::{Contact, Touching, contact};
pub use method::Method;
pub use nearest_simplex::NearestSimplex;
pub use penetration::Penetration;
