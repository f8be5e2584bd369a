"""Answers about a point and a body, and about two bodies."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from ._answers import Answer, number

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class Location(Answer):
    """Where a point lies. It is true where the point belongs to the closed body.

    The proof of a point outside is a `separating_direction` u: u · (x − c) exceeds the sum of all |u · g_i|. That of a
    member is one of the `coefficients` δ_i in [−1, 1] with c + Σ δ_i g_i = x; the generators of the list `basis` absorb
    what rounding the others leaves, so that the equation holds exactly.

    >>> from zonotope import Zonotope
    >>> square = Zonotope([0, 0], [[1, 0], [0, 1]])
    >>> where = square.location([1, 0.5])
    >>> where.status, bool(where), where.proof
    ('boundary', True, {'coefficients': [1.0, 0.5], 'basis': [1]})
    """

    @property
    def status(self) -> str:
        """`inside`, `boundary` or `outside`."""
        return str(self.result["status"])

    def __bool__(self) -> bool:
        return bool(self.result["member"])

    def __repr__(self) -> str:
        return f"Location({self.status!r})"


class Intersection(Answer):
    """How two bodies meet. It is true where they have a point in common; bodies that touch do.

    The proof is made when it is first asked for. It is that of a `Location`, of the difference of the centres in the
    body of all generators, those of the first body first.

    >>> from zonotope import Zonotope
    >>> square = Zonotope([0, 0], [[1, 0], [0, 1]])
    >>> square.intersects(square + [2, 0]).status
    'boundary'
    """

    _STATUSES = {-1: "inside", 0: "boundary", 1: "outside"}

    def __init__(self, given: str, place: int) -> None:
        super().__init__("intersect", given)
        self._place = place

    @property
    def status(self) -> str:
        """`inside` where interiors meet, `boundary` where the bodies only touch, `outside` where they are apart."""
        return self._STATUSES[self._place]

    def __bool__(self) -> bool:
        return self._place <= 0

    def __reduce__(self) -> tuple[Any, ...]:
        kind, lines = super().__reduce__()
        return (kind, lines, {"_place": self._place})

    def _repr_svg_(self) -> str | None:
        from ._plot import svg_of_pair

        return svg_of_pair(json.loads(self.question)["input"], self.status)

    def __repr__(self) -> str:
        return f"Intersection({self.status!r})"


class Distance(Answer):
    """The distance of two bodies; `float()` of it is the value.

    Nearest points and proof are made when they are first asked for.

    >>> from zonotope import Zonotope
    >>> square = Zonotope([0, 0], [[1, 0], [0, 1]])
    >>> far = square.distance(square + [4, 5])
    >>> float(far), [end.tolist() for end in far.nearest]
    (3.605551275463989, [[1.0, 1.0], [3.0, 4.0]])
    """

    def __init__(self, given: str, value: float) -> None:
        super().__init__("distance", given)
        self._value = value

    @property
    def value(self) -> float:
        """The Euclidean distance, within four units in the last place; 0 where the bodies meet."""
        return self._value

    @property
    def nearest(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The points of the two bodies that are nearest to each other, each of shape (d,)."""
        import numpy as np

        a, b = (np.array([number(c) for c in self.result["nearest"][side]]) for side in "ab")
        return a, b

    def __float__(self) -> float:
        return self._value

    def __reduce__(self) -> tuple[Any, ...]:
        kind, lines = super().__reduce__()
        return (kind, lines, {"_value": self._value})

    def __repr__(self) -> str:
        return f"Distance({self._value!r})"


class Penetration(Answer):
    """How deep two bodies lie in each other: bounds of the least translation that makes them only touch, within 1 %.

    It is false where the bodies are apart; both bounds are 0 then, and where they only touch. `float()` of it is
    `upper`.

    >>> from zonotope import Zonotope
    >>> square = Zonotope([0, 0], [[1, 0], [0, 1]])
    >>> deep = square.penetration(square + [1.5, 0.5])
    >>> deep.lower <= 0.5 <= deep.upper, deep.direction.tolist(), bool(deep.verify())
    (True, [1.0, 0.0], True)
    >>> diamond = Zonotope([0, 0], [[1, 1], [1, -1]])
    >>> deep = diamond.penetration(diamond + [2, 1])
    >>> bool(diamond.intersects(diamond + [2, 1] + 0.999 * deep.translation))
    True
    >>> bool(diamond.intersects(diamond + [2, 1] + 1.001 * deep.translation))
    False
    >>> bool(square.penetration(square + [3, 0]))
    False
    """

    @property
    def lower(self) -> float:
        """A proven lower bound of the length of the translation."""
        return self._depth("lower")

    @property
    def upper(self) -> float:
        """A proven upper bound of the length of the translation."""
        return self._depth("upper")

    @property
    def direction(self) -> NDArray[np.float64] | None:
        """The unit vector, rounded, along which a translation of length `upper` takes the second body out of the first,
        of shape (d,); zero where two points are one, none where the bodies are apart."""
        import numpy as np

        depth = self.result.get("penetration")
        if depth is None:
            return None
        given = np.array([number(c) for c in depth["direction"]])
        if not given.any():
            return given
        scaled: NDArray[np.float64] = given / np.abs(given).max()
        unit: NDArray[np.float64] = scaled / np.sqrt((scaled * scaled).sum())
        return unit

    @property
    def translation(self) -> NDArray[np.float64] | None:
        """The translation `upper * direction`, rounded, that takes the second body out of the first."""
        return None if self.direction is None else self.upper * self.direction

    def _depth(self, name: str) -> float:
        depth = self.result.get("penetration")
        return 0.0 if depth is None else number(depth[name])

    def __bool__(self) -> bool:
        return "penetration" in self.result

    def __float__(self) -> float:
        return self.upper

    def __repr__(self) -> str:
        return f"Penetration(lower={self.lower!r}, upper={self.upper!r})"


class Hausdorff(Answer):
    """The Hausdorff distance of two bodies between two proven bounds; `float()` of it is the value.

    >>> from zonotope import Zonotope
    >>> square = Zonotope([0, 0], [[1, 0], [0, 1]])
    >>> gap = square.hausdorff(2 * square)
    >>> float(gap), gap.contained
    (1.4142135623730951, True)
    """

    @property
    def value(self) -> float:
        return number(self.result["value"])

    @property
    def lower(self) -> float:
        return number(self.result["lower"])

    @property
    def upper(self) -> float:
        return number(self.result["upper"])

    @property
    def contained(self) -> bool:
        """Whether the first body lies in the second, exactly."""
        return bool(self.result["a_subset_b"])

    def __float__(self) -> float:
        return self.value

    def __repr__(self) -> str:
        return f"Hausdorff({self.value!r}, lower={self.lower!r}, upper={self.upper!r})"
