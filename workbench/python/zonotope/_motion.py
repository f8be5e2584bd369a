"""Bodies that move during a step of time."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from ._answers import Answer, Collision, body_of
from ._arrays import listed
from ._arrays import number as number_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from ._body import Zonotope


class Motion:
    """A turn about an axis and a translation, both at constant rate during a step of time.

    At time t from 0 to 1 a point x goes to R(t · angle)(x − axis_point) + axis_point + t · translation.

    Parameters
    ----------
    axis : array_like, shape (3,)
        The axis of the turn, of any length but 0.
    angle : float
        Radians, any number of turns.
    axis_point : array_like, shape (3,)
        A point of the axis.
    translation : array_like, shape (3,)

    Examples
    --------
    >>> import math, zonotope
    >>> quarter = zonotope.Motion(axis=[0, 0, 1], angle=math.pi / 2)
    >>> cube = zonotope.Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    >>> swept = quarter.swept(cube)
    >>> bool(swept.contains([0, 1.4142135623730951, 0]))
    True
    """

    def __init__(
        self,
        *,
        axis: ArrayLike = (0, 0, 1),
        angle: float = 0.0,
        axis_point: ArrayLike = (0, 0, 0),
        translation: ArrayLike = (0, 0, 0),
    ) -> None:
        self._given: dict[str, Any] = {
            "axis_point": listed(axis_point, "axis_point", axes=1),
            "axis": listed(axis, "axis", axes=1),
            "angle": number_of(angle, "angle"),
            "translation": listed(translation, "translation", axes=1),
        }

    def swept(self, body: Zonotope) -> Zonotope:
        """A zonotope that contains the body at every time of the step, and whatever the schedule of the turn and the
        translation (Theorem 6.1)."""
        return body_of(self.space_time(body).result)

    def space_time(self, body: Zonotope) -> Answer:
        """The same as an answer with its proof."""
        given = f"{body._body.json()[:-1]},{json.dumps(self._given)[1:]}"
        return Answer("sweep", given).now()

    def __repr__(self) -> str:
        return f"Motion({', '.join(f'{name}={value}' for name, value in self._given.items())})"


def first_contact(
    a: Zonotope,
    b: Zonotope,
    motion_a: Motion | None = None,
    motion_b: Motion | None = None,
    *,
    resolution: float | None = None,
) -> Collision:
    """Whether two moving bodies of space meet during a step of time, and when first: no collision is missed.

    Parameters
    ----------
    a, b : Zonotope
    motion_a, motion_b : Motion, optional
        A body without one rests.
    resolution : float, optional
        The width of the bracket of time around the first contact; 2**-30 where absent.

    Returns
    -------
    Collision

    Examples
    --------
    >>> import zonotope
    >>> cube = zonotope.Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    >>> contact = zonotope.first_contact(cube, cube + [4, 0, 0], zonotope.Motion(translation=[4, 0, 0]))
    >>> contact.status, contact.time[0] <= 0.5 <= contact.time[1], bool(contact.verify())
    ('contact', True, True)
    """
    motion = {side: given._given for side, given in (("a", motion_a), ("b", motion_b)) if given is not None}
    asked = f'{{"a":{a._body.json()},"b":{b._body.json()},"motion":{json.dumps(motion)}'
    if resolution is not None:
        asked += f',"resolution":{json.dumps(number_of(resolution, "resolution"))}'
    return Collision("collide", asked + "}").now()


def track(a: Zonotope, b: Zonotope, poses_a: ArrayLike, poses_b: ArrayLike) -> NDArray[np.int8]:
    """How two bodies of space meet in each frame of a sequence, exactly: −1 inside, 0 touching, 1 apart.

    What one frame finds out makes the next one quick, if the poses are near each other; each answer is that of a fresh
    question.

    Parameters
    ----------
    a, b : Zonotope
    poses_a, poses_b : array_like, shape (m, 4, 4)
        Matrices of homogeneous coordinates with the last row 0, 0, 0, 1.

    Returns
    -------
    ndarray of int8, shape (m,)

    Examples
    --------
    >>> import numpy as np, zonotope
    >>> cube = zonotope.Zonotope([0, 0, 0], np.eye(3))
    >>> rest = np.tile(np.eye(4), (3, 1, 1))
    >>> moved = rest.copy()
    >>> moved[:, 0, 3] = [1, 2, 3]
    >>> zonotope.track(cube, cube, rest, moved).tolist()
    [-1, 0, 1]
    """
    return a._body.track(b._body, poses_a, poses_b)
