"""Bodies that move during a step of time."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from . import _errors, _zonotope
from ._answers import Answer, Collision, body_of
from ._arrays import listed, vector_of_space
from ._arrays import number as number_of
from ._placed import behind, flat, pair_of, pose_of
from ._relations import Intersection

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from ._body import Zonotope
    from ._placed import Placement, Pose


class Motion:
    """A turn about an axis and a translation, both at constant rate during a step of time.

    `Motion.from_pieces` makes one of several pieces, with a quaternion at either end of each.

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
            "axis_point": vector_of_space(axis_point, "axis_point"),
            "axis": vector_of_space(axis, "axis"),
            "angle": number_of(angle, "angle"),
            "translation": vector_of_space(translation, "translation"),
        }
        if not any(self._given["axis"]):
            raise _errors.ZeroAxis("axis is zero and has no direction")

    @classmethod
    def from_pieces(
        cls,
        until: ArrayLike,
        start: ArrayLike,
        end: ArrayLike,
        *,
        axis_point: ArrayLike | None = None,
        translation: ArrayLike | None = None,
    ) -> Motion:
        """A motion of pieces, each applied after those before it.

        While a piece lasts, s goes from 0 to 1, and a point x to R((1 − s) start + s end)(x − axis_point) + axis_point
        + s · translation; R is the rotation of a quaternion.

        Parameters
        ----------
        until : array_like, shape (m,)
            The time at which each piece ends: upwards from above 0, the last one 1.
        start, end : array_like, shape (m, 4)
            Quaternions w, x, y, z of any length but 0, at most half a turn apart.
        axis_point, translation : array_like, shape (m, 3), optional
            0 where absent.

        Examples
        --------
        >>> import zonotope
        >>> there_and_back = zonotope.Motion.from_pieces(
        ...     [0.5, 1], [[1, 0, 0, 0]] * 2, [[1, 0, 0, 0]] * 2, translation=[[4, 0, 0], [-4, 0, 0]]
        ... )
        >>> cube = zonotope.Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        >>> contact = zonotope.first_contact(cube, cube + [4, 0, 0], there_and_back)
        >>> contact.time[0] <= 0.25 <= contact.time[1], bool(contact.verify())
        (True, True)
        """
        times = listed(until, "until", axes=1)
        rest = [[0.0] * 3] * len(times)
        parts = {
            "from": listed(start, "start", axes=2),
            "to": listed(end, "end", axes=2),
            "axis_point": rest if axis_point is None else listed(axis_point, "axis_point", axes=2),
            "translation": rest if translation is None else listed(translation, "translation", axes=2),
        }
        given = {"from": "start", "to": "end"}
        for part, rows in parts.items():
            name, wanted = given.get(part, part), 4 if part in given else 3
            if len(rows) != len(times):
                raise _errors.LengthMismatch(f"until has {len(times)} times and {name} {len(rows)} rows")
            if any(len(row) != wanted for row in rows):
                raise _errors.DimensionMismatch(f"{name} has shape ({len(rows)}, {len(rows[0])}), not (m, {wanted})")
        pieces = [
            {"until": time, **{name: rows[piece] for name, rows in parts.items()}} for piece, time in enumerate(times)
        ]
        made = cls.__new__(cls)
        made._given = {"pieces": pieces}
        return made

    def swept(self, body: Zonotope) -> Zonotope:
        """A zonotope that contains the body at every time of the step, and whatever the schedule of the turn and the
        translation (Theorem 6.1); for a turn at constant rate, not for pieces.

        Examples
        --------
        >>> import zonotope
        >>> bar = zonotope.Zonotope([0, 0, 0], [[1, 0, 0], [0, 0.5, 0], [0, 0, 0.5]])
        >>> bool(zonotope.Motion(translation=[4, 0, 0]).swept(bar).contains([5, 0.5, 0.5]))
        True
        """
        return body_of(self.space_time(body).result)

    def space_time(self, body: Zonotope) -> Answer:
        """The body of `swept` as an answer with its proof.

        Examples
        --------
        >>> import zonotope
        >>> cube = zonotope.Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        >>> swept = zonotope.Motion(angle=1.0, axis_point=[3, 0, 0]).space_time(cube)
        >>> sorted(swept.result)[0], swept.verify().word
        ('center', 'right')
        """
        given = f"{behind(body, 'body').json()[:-1]},{json.dumps(self._given)[1:]}"
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
    motions = {"a": motion_a, "b": motion_b}
    for side, given in motions.items():
        if not isinstance(given, Motion | None):
            raise _errors.BadInput(f"motion_{side} is a {type(given).__name__}, not a Motion")
    motion = {side: given._given for side, given in motions.items() if given is not None}
    asked = f'{{"a":{behind(a, "a").json()},"b":{behind(b, "b").json()},"motion":{json.dumps(motion)}'
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
    return behind(a, "a").track(behind(b, "b"), poses_a, poses_b)


class Tracker:
    """Two bodies of space that are followed from frame to frame, as `track` does where all frames are known before.

    What one frame finds out makes the next one quick, if the poses are near each other; each answer is that of a fresh
    question, and has its proof.

    Parameters
    ----------
    a, b : Zonotope

    Examples
    --------
    >>> import zonotope
    >>> cube = zonotope.Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    >>> tracker = zonotope.Tracker(cube, cube)
    >>> [tracker.frame(pose_b={"translation": [x, 0, 0]}).status for x in (1, 2, 3)]
    ['inside', 'boundary', 'outside']
    """

    def __init__(self, a: Zonotope, b: Zonotope) -> None:
        self._bodies = (a, b)
        self._tracker = _zonotope.Tracker(behind(a, "a"), behind(b, "b"))

    def frame(self, pose_a: Pose | None = None, pose_b: Pose | None = None) -> Intersection:
        """How the bodies meet in the next frame.

        Parameters
        ----------
        pose_a, pose_b : (matrix, translation), dict with these names, or array_like of shape (4, 4), optional
            A body without one stands as it was given.

        Returns
        -------
        Intersection

        Examples
        --------
        >>> import numpy as np, zonotope
        >>> cube = zonotope.Zonotope([0, 0, 0], np.eye(3))
        >>> meets = zonotope.Tracker(cube, cube).frame(np.eye(4), (2 * np.eye(3), [0, 0, 3]))
        >>> bool(meets), meets.status, bool(meets.verify())
        (True, 'boundary', True)
        """
        first, second = (_REST if pose is None else pose_of(pose) for pose in (pose_a, pose_b))
        place = self._tracker.frame(flat(first), flat(second))
        return Intersection(pair_of(*self._bodies, first, second), place)


_REST: Placement = {"matrix": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], "translation": [0.0, 0.0, 0.0]}
