"""Pictures."""

from __future__ import annotations

import matplotlib
import numpy as np
import pytest

import zonotope
from zonotope import Zonotope

matplotlib.use("Agg")


def test_notebooks_show_bodies(cube: Zonotope) -> None:
    square = Zonotope([0, 0], np.eye(2))
    for body in [square, cube, 1e300 * cube, Zonotope.from_generators([[1, 0, 0], [0, 1, 0]])]:
        svg = body._repr_svg_()
        assert svg is not None and svg.startswith("<svg") and "generators" in svg
    assert Zonotope([0], [[1]])._repr_svg_() is None


def test_notebooks_show_enclosings_and_intersections(cube: Zonotope, random: np.random.Generator) -> None:
    for d in (2, 3):
        points = random.normal(size=(3000, d))
        around = zonotope.min_length(points, 0.1), zonotope.along_directions(points, np.eye(d))
        for svg in (around[0]._repr_svg_(), around[1]._repr_svg_()):
            assert svg is not None and "around 3000 points" in svg and svg.count("<circle") == 1500
    turned = ([[0, -1, 0], [1, 0, 0], [0, 0, 1]], [2, 0, 0])
    square = Zonotope([0, 0], np.eye(2))
    for meets, words in [
        (cube.intersects(cube, pose=turned), "only touch"),
        (cube.intersects(cube + [3, 0, 0]), "apart"),
        (square.intersects(2 * square), "interiors meet"),
        (zonotope.Tracker(cube, cube).frame(turned, turned), "interiors meet"),
    ]:
        svg = meets._repr_svg_()
        assert svg is not None and words in svg
    segment = Zonotope([0], [[1]])
    assert segment.intersects(segment)._repr_svg_() is None
    assert zonotope.along_directions([[0, 0], [1, 1]], [[1, 0]])._repr_svg_() is None


def test_matplotlib_draws_bodies(cube: Zonotope) -> None:
    assert len(Zonotope([0, 0], np.eye(2)).plot(color="red").patches) == 1
    axes = cube.plot()
    assert len(axes.collections) == 1 and cube.plot(axes) is axes
    with pytest.raises(zonotope.DimensionMismatch):
        Zonotope([0], [[1]]).plot()
