"""Answers beside those of ZonoOpt, where its wheel is installed and where it answers.

Its answers are those of a solver with a tolerance, which it states: points and bodies within 1 % of touching are left
out.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from conftest import body

from zonotope import Zonotope

zonoopt = pytest.importorskip("zonoopt", reason="the wheel of ZonoOpt is not installed")
sparse = pytest.importorskip("scipy.sparse")


def theirs(given: Zonotope) -> Any:
    return zonoopt.Zono(sparse.csc_matrix(given.G), given.c)


@pytest.mark.parametrize(("d", "n"), [(2, 6), (3, 12), (4, 9)])
def test_points_directions_and_volumes_agree(d: int, n: int, random: np.random.Generator) -> None:
    given = body(random, n, d)
    other = theirs(given)
    points = given.c + random.normal(size=(60, d)) * 3
    gauges = given.gauge(points)
    clear = np.abs(gauges - 1) > 0.01
    assert clear.sum() > 50
    found = [other.contains_point(point) for point in points[clear]]
    assert found == given.contains(points[clear]).tolist() and len(set(found)) == 2
    for direction in random.normal(size=(10, d)):
        assert other.support(direction) == pytest.approx(given.support(direction), rel=1e-6, abs=1e-6)
    assert other.get_volume() == pytest.approx(given.volume, rel=1e-9)


def test_bodies_meet_where_theirs_do(random: np.random.Generator) -> None:
    seen = set()
    for gap in [2.0, 8.0, 14.0, 30.0]:
        a, b = body(random, 8), body(random, 8) + [gap, 0, 0]
        if float(a.distance(b)) > 0.01 or a.penetration(b).lower > 0.01:
            empty = zonoopt.intersection(theirs(a), theirs(b)).is_empty()
            assert bool(a.intersects(b)) == (not empty)
            seen.add(empty)
    assert seen == {True, False}


def test_their_reduction_is_around_the_body(random: np.random.Generator) -> None:
    given = body(random, 20)
    less = theirs(given).reduce_order(6)
    reduced = Zonotope(np.ravel(less.get_c()), less.get_G().toarray())
    assert len(reduced) <= 6 and given.hausdorff(reduced).upper > 0
    directions = random.normal(size=(50, 3))
    assert (reduced.support(directions) >= given.support(directions) * (1 - 1e-9) - 1e-9).all()
