"""Pictures of bodies: by matplotlib where it is there, and as SVG for notebooks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _errors, _zonotope

if TYPE_CHECKING:
    from ._body import Zonotope

_FILL = "#4477aa"
_INK = "#222222"


def plot(body: Zonotope, ax: Any, options: dict[str, Any]) -> Any:
    """The body drawn into axes of matplotlib."""
    from matplotlib import pyplot

    if body.dimension == 2:
        if ax is None:
            _, ax = pyplot.subplots()
            ax.set_aspect("equal")
        ax.fill(*body.vertices().T, **{"facecolor": _FILL, "alpha": 0.4, "edgecolor": _INK, **options})
        return ax
    if body.dimension == 3:
        from mpl_toolkits.mplot3d.art3d import Poly3DCollection

        points = body.vertices()
        if ax is None:
            ax = pyplot.figure().add_subplot(projection="3d")
            low, high = points.min(axis=0), points.max(axis=0)
            middle, half = (low + high) / 2, float((high - low).max()) / 2 or 1.0
            ax.set(xlim=(middle[0] - half, middle[0] + half), ylim=(middle[1] - half, middle[1] + half))
            ax.set_zlim(middle[2] - half, middle[2] + half)
            ax.set_box_aspect((1, 1, 1))
        style = {"facecolor": _FILL, "alpha": 0.4, "edgecolor": _INK, "linewidths": 0.5, **options}
        ax.add_collection3d(Poly3DCollection([points[face] for face in body.faces()], **style))
        return ax
    message = f"bodies of the plane and of space are drawn, this one has {body.dimension} coordinates"
    raise _errors.DimensionMismatch(message)


def svg(body: Zonotope) -> str | None:
    """The picture of a body as notebooks show it; none where there is nothing to see, or too much."""
    return _zonotope.svg(body._body)


def svg_of_pair(given: dict[str, Any], status: str) -> str | None:
    """The picture of the two bodies of a question, each where its pose places it."""
    from ._answers import body_of
    from ._placed import flat

    sides = [given[side] for side in "ab"]
    poses = [flat(side["pose"]) if "pose" in side else None for side in sides]
    bodies = [body_of(side)._body for side in sides]
    note = {"inside": "their interiors meet", "boundary": "they only touch", "outside": "they are apart"}[status]
    return _zonotope.svg_pair(bodies, poses, "Two zonotopes", note)


def svg_around(body: Zonotope, points: list[list[float]]) -> str | None:
    """The picture of a body around points."""
    counted = f"{len(body)} generators around {len(points)} points"
    return _zonotope.svg_around(body._body, points, "A zonotope around points", counted)
