"""The body and what it is asked."""

from __future__ import annotations

import json
import math
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from . import _errors
from ._answers import Reduction
from ._arrays import doubles, listed
from ._placed import behind, flat, pair_of, pose_of
from ._prepared import Prepared
from ._relations import Distance, Hausdorff, Intersection, Location, Penetration
from ._zonotope import Body

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from ._placed import Pose


class Zonotope:
    """The set { c + G δ : |δ_i| ≤ 1 } in one to six dimensions.

    Parameters
    ----------
    c : array_like, shape (d,)
        The centre.
    G : array_like, shape (d, n)
        The generators, one a column, as CORA, LazySets, ZonoOpt and pypolycontain have them. Half-lengths: the segment
        of a generator g goes from −g to g.

    Raises
    ------
    DimensionMismatch
        If the shapes do not go together; the message says both.
    NonFinite
        If a number is NaN or infinite.

    Examples
    --------
    >>> from zonotope import Zonotope
    >>> hexagon = Zonotope([10, 0], [[1, 0, -1], [0, 1, 1]])
    >>> hexagon
    Zonotope(c=[10.0, 0.0], G=[[1.0, 0.0, -1.0], [0.0, 1.0, 1.0]])
    >>> hexagon.center.tolist(), hexagon.generators.tolist(), hexagon.dimension, len(hexagon)
    ([10.0, 0.0], [[1.0, 0.0], [0.0, 1.0], [-1.0, 1.0]], 2, 3)
    >>> (hexagon + [1, 2] == Zonotope([11, 2], hexagon.G), (2 * hexagon).volume, ([[0, 1]] @ hexagon).volume)
    (True, 48.0, 4.0)
    """

    __slots__ = ("_body",)
    _body: Body

    def __init__(self, c: ArrayLike, G: ArrayLike) -> None:
        matrix = doubles(G, "G")
        center = doubles(c, "c")
        if matrix.ndim != 2 or center.ndim != 1 or matrix.shape[0] != center.shape[0]:
            raise _errors.DimensionMismatch(
                f"c has shape {center.shape} and G {matrix.shape}; they are (d,) and (d, n), a generator a column "
                "(generators in rows are taken by Zonotope.from_generators)"
            )
        self._body = Body(center, matrix.T)

    @classmethod
    def from_generators(cls, rows: ArrayLike, center: ArrayLike = 0) -> Zonotope:
        """The body with generators in rows.

        Parameters
        ----------
        rows : array_like, shape (n, d)
        center : array_like, shape (d,), or 0 for the origin

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> Zonotope.from_generators([[1, 0, 0], [1, 1, 0]], [0, 0, 5]).dimension
        3
        """
        generators = doubles(rows, "rows")
        if generators.ndim != 2:
            raise _errors.DimensionMismatch(f"rows has shape {generators.shape}, not (n, d)")
        middle = doubles(center, "center")
        if middle.ndim == 0:
            if middle != 0:
                raise _errors.DimensionMismatch(f"center is {float(middle)}, neither 0 nor of shape (d,)")
            middle = doubles([0.0] * generators.shape[1], "center")
        return cls._of(Body(middle, generators))

    @classmethod
    def _of(cls, body: Body) -> Zonotope:
        made = cls.__new__(cls)
        made._body = body
        return made

    # The body's numbers

    @property
    def center(self) -> NDArray[np.float64]:
        """The centre, a new array of shape (d,); to change it does not change the body."""
        return self._body.center()

    @property
    def generators(self) -> NDArray[np.float64]:
        """The generators in rows, a new array of shape (n, d), which `Zonotope.from_generators` takes."""
        return self._body.rows()

    @property
    def G(self) -> NDArray[np.float64]:
        """The generators in columns, a new array of shape (d, n), which `Zonotope(c, G)` takes."""
        return self._body.rows().T

    @property
    def c(self) -> NDArray[np.float64]:
        """The centre, a new array of shape (d,)."""
        return self._body.center()

    @property
    def dimension(self) -> int:
        """The number d of coordinates."""
        return self._body.dimension()

    def __len__(self) -> int:
        return len(self._body)

    def __bool__(self) -> bool:
        return True

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Zonotope):
            return NotImplemented
        mine, others = (self.generators, other.generators)
        return mine.shape == others.shape and bool((mine == others).all() and (self.center == other.center).all())

    def __hash__(self) -> int:
        return hash((self.center.tobytes(), self.generators.tobytes()))

    def __repr__(self) -> str:
        if len(self) > 8:
            return f"Zonotope(c={self.center.tolist()}, G=<{self.dimension} by {len(self)}>)"
        return f"Zonotope(c={self.center.tolist()}, G={self.G.tolist()})"

    def __reduce__(self) -> tuple[Any, ...]:
        return (Zonotope.from_generators, (self.generators, self.center))

    # Sums and images

    def __add__(self, other: Zonotope | ArrayLike) -> Zonotope:
        """The Minkowski sum with a body, or the body moved by a vector. Encloses it; equal where no centre is rounded,
        and with up to d short generators more where one is, so that the body still contains all that it should."""
        if isinstance(other, Zonotope):
            return self._of(self._body.sum(other._body))
        return self._of(self._body.translated(other))

    __radd__ = __add__

    def __sub__(self, by: ArrayLike) -> Zonotope:
        """The body moved by minus a vector. A difference of two bodies has two meanings: write `Z + (-W)` for the
        Minkowski sum with the reflection; the erosion need not be a zonotope."""
        if isinstance(by, Zonotope):
            raise TypeError("Z - W has two meanings: write Z + (-W) for the Minkowski sum with the reflection")
        return self._of(self._body.translated(-doubles(by, "the translation")))

    def __neg__(self) -> Zonotope:
        """The reflection in the origin, exactly."""
        return self._of(self._body.reflected())

    def __rmatmul__(self, matrix: ArrayLike) -> Zonotope:
        """The image under a matrix of shape (e, d). Encloses it; equal where all products are doubles, and with up to e
        short generators more where they are not."""
        return self._of(self._body.image(matrix))

    def __matmul__(self, matrix: object) -> Zonotope:
        raise TypeError("the image of a body Z under a matrix A is written A @ Z")

    def __mul__(self, factor: float) -> Zonotope:
        """The body times a number. Encloses it; equal where all products are doubles."""
        import numpy as np

        if np.ndim(factor) != 0:
            raise TypeError("a body is multiplied by a number; the image of Z under a matrix A is A @ Z")
        return self._of(self._body.image(float(factor) * np.eye(self.dimension)))

    __rmul__ = __mul__

    # NumPy asks this before it would take the body for an array of objects, in `A @ Z` and `v + Z`.
    __array_ufunc__ = None

    # Points and directions

    def contains(self, points: ArrayLike) -> Any:
        """Whether points lie in the closed body, exactly.

        Parameters
        ----------
        points : array_like, shape (m, d) or (d,)

        Returns
        -------
        ndarray of bool, shape (m,), or bool for one point

        Raises
        ------
        DimensionMismatch, NonFinite

        Notes
        -----
        The lock of the interpreter is released. From 2**18 pairs of a point and a generator on, all processors work;
        RAYON_NUM_THREADS limits them. Points are copied before.

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> square = Zonotope([0, 0], [[1, 0], [0, 1]])
        >>> square.contains([[1, 1], [1, 1.0000000000000002]]).tolist()
        [True, False]
        """
        return self._body.contains(points)

    def locate(self, points: ArrayLike) -> Any:
        """Where points lie, exactly: −1 inside, 0 on the boundary, 1 outside.

        Parameters
        ----------
        points : array_like, shape (m, d) or (d,)

        Returns
        -------
        ndarray of int8, shape (m,), or int for one point

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> square = Zonotope([0, 0], [[1, 0], [0, 1]])
        >>> square.locate([[0, 0], [1, 0], [2, 0]]).tolist()
        [-1, 0, 1]
        """
        return self._body.locate(points)

    def location(self, point: ArrayLike, *, method: str | None = None) -> Location:
        """Where one point lies, with the proof.

        Parameters
        ----------
        point : array_like, shape (d,)
        method : {'by_lad', 'by_slope_selection', 'by_explicit_faces', 'by_linear_program'}, optional
            Another method than the default one; which there are depends on the dimension, and the message of an error
            lists them.

        Returns
        -------
        Location

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> Zonotope([0, 0], [[1, 0], [0, 1]]).location([3, 0]).proof
        {'separating_direction': [2.0, 0.0]}
        """
        at = json.dumps(listed(point, "point", axes=1))
        return Location("member", f'{{"point":{at},{self._body.json()[1:]}', method).now()

    def __contains__(self, point: ArrayLike) -> bool:
        """Whether one point lies in the closed body, exactly: `point in Z`."""
        return bool(self._body.contains(point))

    def gauge(self, points: ArrayLike) -> Any:
        """How many times the body must be taken, from its centre, to hold each point, within four units in the last
        place; infinite where no multiple does.

        Parameters
        ----------
        points : array_like, shape (m, d) or (d,)

        Returns
        -------
        ndarray of float64, shape (m,), or float for one point

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> Zonotope([0, 0], [[1, 0], [0, 1]]).gauge([[3, 0.5], [0, 0]]).tolist()
        [3.0, 0.0]
        """
        return self._body.gauge(points)

    def support(self, directions: ArrayLike) -> Any:
        """The support function: the maximum of u · x over the body.

        Parameters
        ----------
        directions : array_like, shape (m, d) or (d,)

        Returns
        -------
        ndarray of float64, shape (m,), or float for one direction

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> Zonotope([5, 5], [[1, 0], [0, 1]]).support([1, 2])
        18.0
        """
        return self._body.support(directions)

    def extreme_points(self, directions: ArrayLike) -> NDArray[np.float64]:
        """A point of the body that is farthest in each direction.

        Parameters
        ----------
        directions : array_like, shape (m, d) or (d,)

        Returns
        -------
        ndarray of float64, of the shape of the directions

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> Zonotope([5, 5], [[1, 0], [0, 1]]).extreme_points([1, 2]).tolist()
        [6.0, 6.0]
        """
        return self._body.extreme_points(directions)

    # Other bodies

    def intersects(self, other: Zonotope, pose: Pose | None = None) -> Intersection:
        """How two bodies meet, exactly; the answer is true where they have a point in common.

        Parameters
        ----------
        other : Zonotope
        pose : (matrix, translation), dict with these names, or array_like of shape (4, 4), optional
            The placement of the other body in space: x goes to matrix @ x + translation, shapes (3, 3) and (3,).

        Returns
        -------
        Intersection

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> cube = Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        >>> cube.intersects(cube, pose=([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [2, 0, 0]))
        Intersection('boundary')
        """
        placed = None if pose is None else pose_of(pose)
        place = self._body.meets(behind(other, "other"), placed and flat(placed))
        return Intersection(pair_of(self, other, None, placed), place)

    def distance(self, other: Zonotope, pose: Pose | None = None) -> Distance:
        """The Euclidean distance of two bodies of one to three dimensions, the other one under a pose as in
        `intersects`; `float()` of the answer is its value.

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> cube = Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        >>> float(cube.distance(cube + [5, 0, 0]))
        3.0
        """
        placed = None if pose is None else pose_of(pose)
        value = self._body.distance(behind(other, "other"), placed and flat(placed))
        return Distance(pair_of(self, other, None, placed), value)

    def penetration(self, other: Zonotope, pose: Pose | None = None) -> Penetration:
        """How deep two bodies of one to three dimensions lie in each other, the other one under a pose as in
        `intersects`: the least translation that makes them only touch, within 1 %.

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> cube = Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        >>> deep = cube.penetration(cube + [1.5, 0, 0])
        >>> deep.lower <= 0.5 <= deep.upper
        True
        """
        behind(other, "other")
        return Penetration("distance", pair_of(self, other, None, None if pose is None else pose_of(pose))).now()

    def hausdorff(self, other: Zonotope) -> Hausdorff:
        """The Hausdorff distance of two bodies, between two proven bounds. A body under a pose (R, t) is `R @ Z + t`,
        or one that encloses it.

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> segment = Zonotope([0], [[1]])
        >>> float(segment.hausdorff(3 * segment))
        2.0
        """
        behind(other, "other")
        return Hausdorff("hausdorff", pair_of(self, other)).now()

    def reduce(self, k: int, rule: str = "best") -> Reduction:
        """A body of at most k generators that contains this one exactly.

        Parameters
        ----------
        k : int
            At least d where the body has full dimension.
        rule : {'best', 'lemma_5_5', 'cluster', 'girard', 'combastel', 'pca', 'scott', 'adaptive'}

        Returns
        -------
        Reduction

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> len(Zonotope([0, 0], [[1, 0, 1, 2], [0, 1, 1, 1]]).reduce(3).body)
        3
        """
        given = f'{self._body.json()[:-1]},"count":{json.dumps(k)},"rule":{json.dumps(rule)}}}'
        return Reduction("reduce", given).now()

    def prepare(self, expected: int = 10_000, *, bytes: int = 1 << 30) -> Prepared:
        """The body of space in the structure that answers about so many questions in the least time.

        Parameters
        ----------
        expected : int
            About how many points will be asked about.
        bytes : int
            The most memory that the structure may take.

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> cube = Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        >>> cube.prepare(1_000_000).contains([[1, 0, 0], [2, 0, 0]]).tolist()
        [True, False]
        """
        return Prepared(self, expected, bytes)

    # Faces and measures

    @property
    def volume(self) -> float:
        """Length, area or volume, the nearest double; 0 where the body is flat, infinite beyond all doubles.

        >>> from zonotope import Zonotope
        >>> Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]]).volume
        8.0
        """
        try:
            return float(self.exact_volume)
        except OverflowError:
            return math.inf

    @property
    def exact_volume(self) -> Fraction:
        """Length, area or volume, exactly.

        >>> from zonotope import Zonotope
        >>> Zonotope([0], [[0.1]]).exact_volume
        Fraction(3602879701896397, 18014398509481984)
        """
        numerator, denominator = self._body.exact_volume()
        return Fraction(int(numerator), int(denominator))

    def bounding_box(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The least and the greatest coordinates, each of shape (d,): the smallest box of doubles around the body.

        >>> from zonotope import Zonotope
        >>> low, high = Zonotope([1, 0], [[1, 2], [0, 3]]).bounding_box()
        >>> low.tolist(), high.tolist()
        ([-2.0, -3.0], [4.0, 3.0])
        """
        low, high = self._body.bounding_box()
        return low, high

    def vertices(self) -> NDArray[np.float64]:
        """The vertices, rounded, of shape (m, d), in one to three dimensions; in the plane counter-clockwise.

        Raises
        ------
        TooLarge
            For bodies of space with more than 2**24 vertices, as 4,097 generators in general position have.

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> Zonotope([0, 0], [[1, 0], [0, 1]]).vertices().tolist()
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
        """
        return self._body.faces()[0]

    def faces(self) -> list[NDArray[np.uint32]]:
        """The facets as arrays of indices of vertices, in space counter-clockwise from outside; in one to three
        dimensions.

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> cube = Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        >>> sorted(len(face) for face in cube.faces())
        [4, 4, 4, 4, 4, 4]
        """
        _, corners, starts = self._body.faces()
        return [corners[start:end] for start, end in zip(starts[:-1], starts[1:], strict=True)]

    def to_mesh(self) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """Vertices of shape (m, 3) and triangles of shape (t, 3), counter-clockwise from outside, as trimesh, pyvista
        and matplotlib take them; for bodies of space.

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> points, triangles = Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]]).to_mesh()
        >>> points.shape, triangles.shape
        ((8, 3), (12, 3))
        """
        import numpy as np

        if self.dimension != 3:
            message = f"meshes are those of bodies of space, this one has {self.dimension} coordinates"
            raise _errors.DimensionMismatch(message)
        fans = [
            np.column_stack([np.full(len(face) - 2, face[0]), face[1:-1], face[2:]]).astype(np.int64)
            for face in self.faces()
        ]
        return self.vertices(), np.concatenate(fans) if fans else np.empty((0, 3), dtype=np.int64)

    # Pictures

    def plot(self, ax: Any = None, **options: Any) -> Any:
        """Draws a body of the plane or of space by matplotlib.

        Parameters
        ----------
        ax : matplotlib axes, optional
            A new one is made where none is given.
        options
            Handed to the polygon of the plane, or to the collection of faces in space.

        Returns
        -------
        The axes.

        Examples
        --------
        >>> from zonotope import Zonotope
        >>> len(Zonotope([0, 0], [[1, 0], [0, 1]]).plot(color="red").patches)
        1
        """
        from ._plot import plot

        return plot(self, ax, options)

    def _repr_svg_(self) -> str | None:
        from ._plot import svg

        return svg(self)
