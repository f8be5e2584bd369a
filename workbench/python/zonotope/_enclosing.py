"""Zonotopes around points."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from ._answers import Answer, body_of, number
from ._arrays import listed
from ._arrays import number as number_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from ._body import Zonotope


class Enclosing(Answer):
    """A zonotope around points, with a lower bound that no such body can beat. It contains every point exactly.

    The proof that no area is less than the bound is the `hull` of the points with the corner that is `farthest` from
    each of its edges. That of a length are `forces`, vectors λ at points p with the sum zero: a zonotope around the
    points is at least as long as Σ λ · p over the distance of the farthest vertex of Σ [−1, 1] λ from the origin.

    >>> import zonotope
    >>> square = zonotope.min_length([[0, 0], [2, 0], [2, 2], [0, 2]], 1e-9)
    >>> len(square.body), square.ratio < 1.0000001, bool(square.verify())
    (2, True, True)
    """

    @property
    def body(self) -> Zonotope:
        """The zonotope."""
        return body_of(self.result)

    @property
    def value(self) -> float:
        """What is minimised: the area, or the sum of the half-lengths Σ |g_i|, which is half the length of all
        segments. With `objective="volume"` it stays the sum of half-lengths, and so do bound and ratio."""
        return number(self.result["area" if "area" in self.result else "length"])

    @property
    def lower_bound(self) -> float:
        """A proven lower bound of the value of every such body."""
        return number(self.result["lower_bound"])

    @property
    def ratio(self) -> float:
        """The value over the lower bound: 1 for an optimum."""
        return 1.0 if self.value == self.lower_bound else self.value / self.lower_bound

    def _repr_svg_(self) -> str | None:
        from ._plot import svg_around

        return svg_around(self.body, json.loads(self.question)["input"]["points"])

    def __repr__(self) -> str:
        return f"{type(self).__name__}(value={self.value!r}, ratio={self.ratio!r}, generators={len(self.body)})"


class Along(Answer):
    """The zonotope of least weighted length along given directions, or the proof that there is none.

    The proof that none is cheaper are `forces`, vectors λ at points p with the sum zero and Σ |λ · v| at most the
    weight of each direction v: their Σ λ · p is the bound.

    It is false where there is none.

    >>> import zonotope
    >>> flat = zonotope.along_directions([[0, 0], [1, 1]], [[1, 0]])
    >>> flat, bool(flat), bool(flat.verify())
    (Along('infeasible'), False, True)
    """

    @property
    def status(self) -> str:
        """`optimal`; `feasible` where no centre in doubles reaches the optimum; `infeasible`."""
        return str(self.result["status"])

    @property
    def coefficients(self) -> NDArray[np.float64]:
        """The half-length along each direction, in units of the direction."""
        import numpy as np

        return np.array([number(c) for c in self.result["coefficients"]])

    @property
    def body(self) -> Zonotope:
        """The zonotope with the directions times their coefficients as generators; those that are zero are left out."""
        import numpy as np

        from ._body import Zonotope

        asked = json.loads(self.question)["input"]["directions"]
        rows = np.array(asked, dtype=float) * self.coefficients[:, None]
        return Zonotope.from_generators(rows[self.coefficients != 0], [number(c) for c in self.result["center"]])

    @property
    def value(self) -> float:
        """The weighted sum of coefficients."""
        return number(self.result["value"])

    @property
    def lower_bound(self) -> float:
        """A proven lower bound of the value."""
        return number(self.result["lower_bound"])

    def __bool__(self) -> bool:
        return self.status != "infeasible"

    def _repr_svg_(self) -> str | None:
        from ._plot import svg_around

        return svg_around(self.body, json.loads(self.question)["input"]["points"]) if self else None

    def __repr__(self) -> str:
        return f"Along({self.status!r})"


def min_area(points: ArrayLike) -> Enclosing:
    """The zonogon of least area around points of the plane (Theorem 4.5).

    Parameters
    ----------
    points : array_like, shape (m, 2)

    Returns
    -------
    Enclosing

    Examples
    --------
    >>> import zonotope
    >>> least = zonotope.min_area([[0, 0], [6, 0], [0, 6]])
    >>> least.value, least.lower_bound, bool(least.verify())
    (36.0, 36.0, True)
    """
    return Enclosing("min_area", json.dumps({"points": listed(points, "points", axes=2)})).now()


def along_directions(points: ArrayLike, directions: ArrayLike, weights: ArrayLike | None = None) -> Along:
    """The zonotope of least weighted length along given directions around points (Theorem 4.6).

    Parameters
    ----------
    points : array_like, shape (m, d)
        In one to four dimensions.
    directions : array_like, shape (k, d)
    weights : array_like, shape (k,), optional
        What a unit of each coefficient costs; 1 where absent.

    Returns
    -------
    Along

    Examples
    --------
    >>> import zonotope
    >>> box = zonotope.along_directions([[0, 0], [2, 0], [0, 4]], [[1, 0], [0, 1]])
    >>> box.status, box.value, box.coefficients.tolist()
    ('optimal', 3.0, [1.0, 2.0])
    """
    along = listed(directions, "directions", axes=2)
    costs = [1.0] * len(along) if weights is None else listed(weights, "weights", axes=1)
    given = {"points": listed(points, "points", axes=2), "directions": along, "weights": costs}
    return Along("min_length_dirs", json.dumps(given)).now()


def min_length(
    points: ArrayLike,
    epsilon: float = 0.01,
    *,
    max_generators: int | None = None,
    objective: str = "length",
) -> Enclosing:
    """The zonotope of least total length Σ |g_i| around points, within 1 + epsilon (Theorem 4.7).

    Parameters
    ----------
    points : array_like, shape (m, d)
        In one to four dimensions.
    epsilon : float
        Between 0 and 1.
    max_generators : int, optional
        The most generators that the body may have; the ratio then says how far the best may be.
    objective : {'length', 'volume'}
        For points of space, 'volume' goes on from there to a local minimum of the volume; `value` stays the length.

    Returns
    -------
    Enclosing

    Examples
    --------
    >>> import zonotope
    >>> short = zonotope.min_length([[0, 0], [6, 0], [0, 6]], 1e-6)
    >>> short.ratio <= 1 + 1e-6
    True
    """
    given = {"points": listed(points, "points", axes=2), "epsilon": number_of(epsilon, "epsilon")}
    if max_generators is not None:
        given["max_generators"] = max_generators
    if objective != "length":
        given["objective"] = objective
    return Enclosing("min_length_all", json.dumps(given)).now()
