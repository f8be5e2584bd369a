"""Bodies that are asked again and again."""

from __future__ import annotations

import operator
from typing import TYPE_CHECKING, Any

from . import _errors, _zonotope

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._body import Zonotope


class Prepared:
    """A body of space in the structure that suits the number of questions; made by `Zonotope.prepare`.

    The answers are those of the body itself.

    >>> from zonotope import Zonotope
    >>> cube = Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    >>> cube.prepare(expected=1_000_000).structure
    'facets'
    """

    def __init__(self, body: Zonotope, expected: int, bytes: int) -> None:
        for name, value in (("expected", expected), ("bytes", bytes)):
            if not 0 <= operator.index(value) < 1 << 64:
                raise _errors.BadInput(f"{name} is {value}; a number from 0 on is taken")
        self.body = body
        self._prepared = _zonotope.Prepared(body._body, expected, bytes)

    @property
    def structure(self) -> str:
        """Which structure was chosen: `rows`, `blocks`, `direction tree`, `cutting` or `facets`."""
        return self._prepared.structure()

    @property
    def bytes(self) -> int:
        """The bytes that the structure holds."""
        return self._prepared.bytes()

    def __repr__(self) -> str:
        return f"Prepared({self.structure!r}, generators={len(self.body)}, bytes={self.bytes})"

    def contains(self, points: ArrayLike) -> Any:
        """As `Zonotope.contains`.

        >>> from zonotope import Zonotope
        >>> Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]]).prepare().contains([1, 1, 1])
        True
        """
        return self._prepared.contains(points)

    def locate(self, points: ArrayLike) -> Any:
        """As `Zonotope.locate`.

        >>> from zonotope import Zonotope
        >>> Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]]).prepare().locate([1, 1, 1])
        0
        """
        return self._prepared.locate(points)

    def gauge(self, points: ArrayLike) -> Any:
        """As `Zonotope.gauge`, with the error that the structure allows: some units in the last place.

        >>> from zonotope import Zonotope
        >>> Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]]).prepare().gauge([0, 4, 0])
        4.0
        """
        return self._prepared.gauge(points)
