//! Kinds about a body and a displacement, and what they share: the choice of a method, proofs in the answer.

pub(super) mod distance;
pub(super) mod gauge;
pub(super) mod held;
pub(super) mod intersect;
pub(super) mod member;
pub(super) mod member_batch;
mod posed;
mod proof;

use serde_json::{Value, json};
use zonotope::collision::{Gauge, Location, Method, Query, Separation, by_lad};

use self::posed::{Posed, Prism, SPACE};
use crate::json::vector_to_json;
use crate::refusal::{Code, Refusal};

/// The demands of a kind on its methods.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Task {
    /// A location with its proof.
    Locate,
    /// The gauge as well.
    Gauge,
}

impl Task {
    /// The methods that do it, better ones first.
    fn methods(self) -> impl Iterator<Item = Method> {
        let does = move |method: &Method| self == Self::Locate || method.measures();
        Method::ALL.iter().copied().filter(does)
    }

    /// The names of the methods that do it.
    fn method_names(self) -> Vec<&'static str> {
        self.methods().map(Method::id).collect()
    }

    /// The method that was asked for, or the best one of the dimension.
    fn method<const D: usize>(self, asked: Option<&'static str>, generators: usize) -> Result<Method, Refusal> {
        let working = || self.methods().filter(|method| method.dimensions().contains(&D));
        let chosen = match asked {
            Some(name) => self.methods().find(|method| method.id() == name),
            None => working().next(),
        };
        let chosen = chosen.expect("brute force works in every dimension, and the kinds list these names");
        if !working().any(|method| method == chosen) {
            let others: Vec<_> = working().map(Method::id).collect();
            let message = format!("`{}` does not answer in {D} dimensions; {} would", chosen.id(), others.join(", "));
            return Err(Refusal::new(Code::UnknownMethod, message));
        }
        refuse_many::<D>(chosen, generators)?;
        Ok(chosen)
    }
}

/// The most generators that a method takes in a dimension, where its cost is no small power of their number.
fn generator_limit(method: Method, dimension: usize) -> Option<usize> {
    match method {
        Method::ByExplicitFaces => Some(2000),
        #[cfg(feature = "linear-programming")]
        Method::ByLinearProgram => Some(100_000),
        Method::BruteForce => Some([2000, 400, 60, 26, 18, 14][dimension - 1]),
        _ => None,
    }
}

fn refuse_many<const D: usize>(method: Method, generators: usize) -> Result<(), Refusal> {
    match generator_limit(method, D) {
        Some(limit) if generators > limit => {
            let name = method.id();
            let message = format!("{generators} generators, at most {limit} are taken by `{name}` in {D} dimensions");
            Err(Refusal::new(Code::TooLarge, message))
        }
        _ => Ok(()),
    }
}

/// The place of a displacement, with a proof that a verifier takes, and the method that proved it: what a linear
/// program leaves open is decided by the kernel, or by brute force in dimensions that the kernel does not reach.
fn locate<const D: usize>(
    method: Method,
    question: &Query<'_, D>,
    seed: u64,
) -> Result<(Method, Location<D>), Refusal> {
    let find = |method: Method| method.locate(question, seed, &mut ()).ok().flatten();
    if let Some(location) = find(method) {
        return Ok((method, location.with_nearest_basis(question)));
    }
    let reaches = Method::ByLad.dimensions().contains(&D);
    let other = if reaches { Method::ByLad } else { Method::BruteForce };
    refuse_many::<D>(other, question.len())?;
    let location = find(other).expect("the kernel locates up to four dimensions, brute force in any");
    Ok((other, location.with_nearest_basis(question)))
}

/// The gauge by a method that was chosen for it, with a proof that a verifier takes.
fn gauge<const D: usize>(method: Method, question: &Query<'_, D>) -> Gauge<D> {
    let gauge = method.nearest_gauge(question);
    gauge.expect("the dimension and the number of generators were checked when the method was chosen")
}

/// The place of the displacement of two posed bodies, with a proof that a verifier takes, and the method that proved
/// it.
fn locate_posed<const D: usize>(
    [first, second]: [&Posed<D>; 2],
    asked: Option<&'static str>,
    seed: u64,
) -> Result<(&'static str, Location<D>), Refusal> {
    if D > SPACE {
        let [a, b] = [first.image()?, second.image()?];
        let question = Query::between(&a, &b);
        let (method, location) = locate(Task::Locate.method::<D>(asked, question.len())?, &question, seed)?;
        return Ok((method.id(), location));
    }
    let method = posed_method(asked)?;
    let prism = Prism::over(first, second);
    let query = prism.query();
    let location = by_lad::locate(&query, &mut ()).with_nearest_basis(&query);
    Ok((method, prism.hidden().location(&location)))
}

/// The method of questions about bodies under poses, unless another one was asked for.
fn posed_method(asked: Option<&'static str>) -> Result<&'static str, Refusal> {
    let kernel = Method::ByLad.id();
    match asked.filter(|name| *name != kernel) {
        Some(other) => {
            let message = format!("`{other}` does not take bodies under a pose; `{kernel}` does");
            Err(Refusal::new(Code::UnknownMethod, message))
        }
        None => Ok(kernel),
    }
}

/// The proof of a location.
fn certificate<const D: usize>(location: &Location<D>) -> Value {
    match location {
        Location::Inside(witness) | Location::Boundary(witness) => {
            json!({"coefficients": vector_to_json(&witness.coefficients), "basis": witness.basis})
        }
        Location::Outside(Separation::Rounded(direction)) => {
            json!({"separating_direction": vector_to_json(direction)})
        }
        Location::Outside(Separation::Exact(direction)) => {
            let exact: Vec<String> = direction.iter().map(ToString::to_string).collect();
            json!({"separating_direction": exact})
        }
    }
}
