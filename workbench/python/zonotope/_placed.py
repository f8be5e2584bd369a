"""Bodies under poses, as questions have them."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, TypedDict

from . import _errors
from ._arrays import doubles
from ._zonotope import Body

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._body import Zonotope

    Pose = tuple[ArrayLike, ArrayLike] | dict[str, ArrayLike] | ArrayLike


class Placement(TypedDict):
    """The placement that takes x to matrix @ x + translation."""

    matrix: list[list[float]]
    translation: list[float]


def pose_of(pose: Pose) -> Placement:
    """The pose of (matrix, translation), of a dict with these names, or of a matrix of shape (4, 4) or (3, 4). A matrix
    may be a `Rotation` of SciPy."""
    if isinstance(pose, dict):
        unknown = set(pose) - {"matrix", "translation"}
        if unknown or not pose:
            raise _errors.BadInput(f"a pose has `matrix` and `translation`, not {sorted(unknown)}")
        matrix = pose.get("matrix", [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        translation = pose.get("translation", [0, 0, 0])
    elif isinstance(pose, tuple) and len(pose) == 2:
        matrix, translation = pose
    else:
        whole = doubles(pose, "pose")
        if whole.shape not in [(4, 4), (3, 4)]:
            kinds = "(matrix, translation), a dict, or a matrix of shape (4, 4) or (3, 4)"
            raise _errors.DimensionMismatch(f"a pose is {kinds}, not {whole.shape}")
        if whole[3:].tolist() not in [[[0, 0, 0, 1]], []]:
            raise _errors.BadInput("pose: the last row of the matrix is not 0, 0, 0, 1")
        matrix, translation = whole[:3, :3], whole[:3, 3]
    if hasattr(matrix, "as_matrix"):
        matrix = matrix.as_matrix()
    rows, by = doubles(matrix, "matrix"), doubles(translation, "translation")
    if (rows.shape, by.shape) != ((3, 3), (3,)):
        shapes = f"{rows.shape} and {by.shape}"
        raise _errors.DimensionMismatch(f"a pose has matrix and translation of shapes (3, 3) and (3,), not {shapes}")
    return {"matrix": rows.tolist(), "translation": by.tolist()}


def behind(other: object, name: str) -> Body:
    """The body behind an argument that has to be one."""
    body = getattr(other, "_body", None)
    if not isinstance(body, Body):
        raise _errors.BadInput(f"{name} is a {type(other).__name__}, not a Zonotope")
    return body


def flat(pose: Placement) -> list[float]:
    """The twelve numbers of a pose."""
    return [*(c for row in pose["matrix"] for c in row), *pose["translation"]]


def pair_of(a: Zonotope, b: Zonotope, pose_a: Placement | None = None, pose_b: Placement | None = None) -> str:
    """The input of a question about two bodies."""
    return f'{{"a":{_placed(a, pose_a)},"b":{_placed(b, pose_b)}}}'


def _placed(body: Zonotope, pose: Placement | None) -> str:
    text = body._body.json()
    return text if pose is None else f'{text[:-1]},"pose":{json.dumps(pose)}}}'
