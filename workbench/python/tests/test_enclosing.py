"""Bodies around points, and bodies that move."""

from __future__ import annotations

import math

import numpy as np
import pytest

import zonotope
from zonotope import Motion, Zonotope, first_contact


def test_enclosing_bodies_contain_their_points_and_have_proofs(random: np.random.Generator) -> None:
    plane, space = random.normal(size=(40, 2)), random.normal(size=(40, 3))
    for found, points in [
        (zonotope.min_area(plane), plane),
        (zonotope.min_length(plane, 1e-4), plane),
        (zonotope.min_length(space, 0.05), space),
        (zonotope.min_length(space, 0.05, max_generators=5), space),
    ]:
        assert found.body.contains(points).all() and found.lower_bound <= found.value and found.verify()
        assert found.ratio >= 1 and found.proof
    assert zonotope.min_area(plane).value == pytest.approx(zonotope.min_area(plane).body.volume, rel=1e-12)
    assert len(zonotope.min_length(space, 0.05, max_generators=5).body) <= 5


def test_bodies_along_directions_are_optimal_or_proved_impossible(random: np.random.Generator) -> None:
    points = random.normal(size=(30, 3))
    found = zonotope.along_directions(points, np.eye(3), [1, 2, 3])
    assert found and found.status in ("optimal", "feasible") and found.verify()
    assert found.coefficients == pytest.approx(np.ptp(points, axis=0) / 2, rel=1e-9)
    assert found.body.contains(points).all()
    flat = zonotope.along_directions(points, [[1, 0, 0], [0, 1, 0]])
    assert not flat and flat.status == "infeasible" and flat.verify()


def test_a_swept_body_contains_every_placement(cube: Zonotope, random: np.random.Generator) -> None:
    motion = Motion(axis=[0, 0, 1], angle=2.0, axis_point=[3, 0, 0], translation=[0, 0, 4])
    swept = motion.swept(cube)
    for phi, s in random.uniform(size=(200, 2)):
        sine, cosine = math.sin(2 * phi), math.cos(2 * phi)
        turn = np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
        placed = (cube.vertices() - [3, 0, 0]) @ turn.T + [3, 0, 0] + np.multiply(s, [0, 0, 4])
        assert (swept.gauge(placed) <= 1 + 1e-12).all()
    assert motion.space_time(cube).verify().word != "wrong"


def test_no_collision_of_turning_bodies_is_missed(cube: Zonotope) -> None:
    bar = Zonotope([0, 0, 0], np.diag([10, 0.1, 0.1]))
    post = 0.1 * cube + [0, 9, 0]
    for turns in [0.5, 3.0]:
        swing = Motion(axis=[0, 0, 1], angle=2 * math.pi * turns)
        found = first_contact(bar, post, swing)
        assert found.status == "contact" and found and found.verify()
        time = found.time
        assert time is not None and time[1] - time[0] <= 2**-30 and 0.2 < time[0] * turns < 0.26
    away = first_contact(bar, post + [0, 0, 5], Motion(axis=[0, 0, 1], angle=40.0))
    assert away.status == "separate" and not away and away.verify() and away.proof["intervals"]


def test_motions_of_pieces_are_followed(cube: Zonotope) -> None:
    half = math.sqrt(0.5)
    turn = Motion.from_pieces([0.5, 1], [[1, 0, 0, 0]] * 2, [[half, 0, 0, half]] * 2, axis_point=[[0, 0, 0]] * 2)
    bar = Zonotope([0, 0, 0], np.diag([10, 0.1, 0.1]))
    found = first_contact(bar, 0.1 * cube + [0, 9, 0], turn)
    time = found.time
    assert found.verify() and time is not None and 0.45 < time[0] < 0.5
    rest = [[1.0, 0, 0, 0]]
    with pytest.raises(zonotope.LengthMismatch, match="until has 1 times and end 2 rows"):
        Motion.from_pieces([1], rest, rest * 2)
    with pytest.raises(zonotope.NonFinite, match=r"end\[0, 0\] is inf"):
        Motion.from_pieces([1], rest, [[math.inf, 0, 0, 0]])
    with pytest.raises(zonotope.DimensionMismatch, match=r"end has shape \(1, 3\), not \(m, 4\)"):
        Motion.from_pieces([1], rest, [[1, 0, 0]])
    refused: list[tuple[type[zonotope.ZonotopeError], Motion]] = [
        (zonotope.ZeroAxis, Motion.from_pieces([1], rest, [[0, 0, 0, 0]])),
        (zonotope.BadAngle, Motion.from_pieces([1], rest, [[-1, 0, 0, 0]])),
        (zonotope.BadInput, Motion.from_pieces([0.5], rest, rest)),
    ]
    for error, motion in refused:
        with pytest.raises(error):
            first_contact(bar, cube, motion)
