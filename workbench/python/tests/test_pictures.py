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


def test_matplotlib_draws_bodies(cube: Zonotope) -> None:
    assert len(Zonotope([0, 0], np.eye(2)).plot(color="red").patches) == 1
    axes = cube.plot()
    assert len(axes.collections) == 1 and cube.plot(axes) is axes
    with pytest.raises(zonotope.DimensionMismatch):
        Zonotope([0], [[1]]).plot()
