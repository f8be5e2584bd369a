"""Questions against SciPy and against each other."""

from __future__ import annotations

import threading
import types
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from conftest import body, near_the_boundary
from scipy.optimize import linprog
from scipy.spatial import ConvexHull

import zonotope
from zonotope import Zonotope


@pytest.mark.parametrize("d", range(1, 7))
def test_answers_about_many_points_are_those_about_one(d: int, random: np.random.Generator) -> None:
    given = body(random, 7, d)
    points = np.concatenate([near_the_boundary(given, random, 20), random.normal(size=(20, d)) * 9])
    contains, locate, gauge = given.contains(points), given.locate(points), given.gauge(points)
    assert (contains.dtype, locate.dtype, gauge.dtype) == (np.bool_, np.int8, np.float64)
    for i, point in enumerate(points):
        assert given.contains(point) == contains[i] and given.contains(point.tolist()) == contains[i]
        assert given.locate(point) == locate[i] and given.gauge(point) == gauge[i]
        where = given.location(point)
        assert where.status == {-1: "inside", 0: "boundary", 1: "outside"}[locate[i]]
        assert bool(where) == contains[i] and where.verify()
    directions = random.normal(size=(10, d))
    support, extreme = given.support(directions), given.extreme_points(directions)
    assert np.allclose(np.einsum("ij,ij->i", directions, extreme), support, rtol=1e-12)
    assert support[3] == given.support(directions[3]) and (extreme[3] == given.extreme_points(directions[3])).all()


def test_memberships_agree_with_linprog(random: np.random.Generator) -> None:
    given = body(random, 20)
    points = random.normal(size=(60, 3)) * 12
    gauges = given.gauge(points)
    for point, member, gauge in zip(points, given.contains(points), gauges, strict=True):
        columns = np.hstack([given.G, (given.c - point)[:, None] * 0])
        least = linprog(
            [0] * 20 + [1],
            A_eq=columns,
            b_eq=point - given.c,
            A_ub=np.vstack([np.hstack([np.eye(20), -np.ones((20, 1))]), np.hstack([-np.eye(20), -np.ones((20, 1))])]),
            b_ub=np.zeros(40),
            bounds=[(None, None)] * 20 + [(0, None)],
            method="highs",
        )
        assert least.fun == pytest.approx(gauge, rel=1e-6) and member == (gauge <= 1)


@pytest.mark.parametrize("d", [2, 3])
def test_vertices_faces_and_volume_agree_with_qhull(d: int, random: np.random.Generator) -> None:
    given = body(random, 9, d)
    hull = ConvexHull(given.vertices())
    assert len(hull.vertices) == len(given.vertices()) == (18 if d == 2 else 9 * 8 + 2)
    assert hull.volume == pytest.approx(given.volume, rel=1e-9)
    assert isinstance(given.exact_volume, Fraction) and float(given.exact_volume) == given.volume
    assert len(given.faces()) == (18 if d == 2 else 72)


def test_a_mesh_encloses_the_volume(random: np.random.Generator) -> None:
    given = body(random, 12)
    points, triangles = given.to_mesh()
    a, b, c = (points[triangles[:, k]] - given.center for k in range(3))
    assert np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6 == pytest.approx(given.volume, rel=1e-9)
    assert points.dtype == np.float64 and triangles.dtype == np.int64
    with pytest.raises(zonotope.DimensionMismatch):
        Zonotope([0, 0], np.eye(2)).to_mesh()


def test_bodies_meet_under_poses(cube: Zonotope) -> None:
    turned = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    for x, status in [(1.5, "inside"), (2, "boundary"), (2.5, "outside")]:
        for pose in [(turned, [x, 0, 0]), {"translation": [x, 0, 0]}, {"matrix": turned, "translation": [x, 0, 0]}]:
            meets = cube.intersects(cube, pose=pose)  # type: ignore[arg-type]
            assert meets.status == status and bool(meets) == (status != "outside") and meets.verify()
        assert cube.intersects(cube + [x, 0, 0]).status == status
        assert float(cube.distance(cube + [x, 0, 0])) == max(0.0, x - 2)
    with pytest.raises(zonotope.DimensionMismatch, match=r"\(3, 3\)"):
        cube.intersects(cube, pose=([[1]], [0, 0, 0]))
    with pytest.raises(zonotope.BadInput, match="rotation"):
        cube.intersects(cube, pose={"rotation": turned})


def test_distances_depths_and_gaps_have_proofs(random: np.random.Generator) -> None:
    for gap in [0.0, 30.0]:
        a, b = body(random, 8), body(random, 8) + [gap, 0, 0]
        far = a.distance(b)
        assert far.verify(), far.verify()
        if float(far) > 0:
            p, q = far.nearest
            assert float(far) == pytest.approx(np.linalg.norm(p - q), rel=1e-12)
        depth = a.penetration(b)
        assert depth.verify() and bool(depth) == (float(far) == 0) and depth.lower <= depth.upper
        if depth:
            direction = depth.direction
            assert direction is not None and 0 < depth.lower and depth.upper <= 1.01 * depth.lower
            out = depth.translation
            assert np.linalg.norm(direction) == pytest.approx(1, abs=1e-15) and out is not None
            assert not a.intersects(b + 1.0001 * out) and a.intersects(b + 0.98 * out)
        else:
            assert depth.direction is None and depth.upper == 0
        between = a.hausdorff(b)
        assert between.lower <= float(between) <= between.upper and between.verify() and not between.contained


def test_bodies_under_poses_are_those_that_were_turned_before(random: np.random.Generator) -> None:
    quarter = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    for shift in ([0.5, 0, 0], [9.0, 1, 2], [30.0, 0, 0]):
        a, b = body(random, 8), body(random, 8)
        turned = quarter @ b + shift
        whole = np.block([[quarter, np.array(shift)[:, None]]])
        rotation = types.SimpleNamespace(as_matrix=lambda: quarter)
        poses: list[Any] = [(quarter, shift), whole, {"matrix": quarter, "translation": shift}, (rotation, shift)]
        for pose in poses:
            distance, depth = a.distance(b, pose=pose), a.penetration(b, pose=pose)
            assert float(distance) == pytest.approx(float(a.distance(turned)), rel=1e-14, abs=1e-14)
            assert distance.verify() and depth.verify() and bool(depth) == bool(a.intersects(b, pose=pose))
            assert float(depth) == pytest.approx(a.penetration(turned).upper, rel=0.02)
    with pytest.raises(zonotope.DimensionMismatch, match="bodies of space"):
        Zonotope([0, 0], np.eye(2)).distance(Zonotope([5, 0], np.eye(2)), pose=np.eye(4))


def test_bodies_that_only_touch_are_left_without_a_way() -> None:
    for d in (1, 2, 3):
        point, box = Zonotope(np.zeros(d), np.zeros((d, 0))), Zonotope(np.zeros(d), np.eye(d))
        for a, b in [(point, point), (box, box + 2 * np.eye(d)[0]), (point, box + np.ones(d))]:
            depth = a.penetration(b)
            assert depth.upper == 0 and depth.verify()
            assert depth.translation is None or not depth.translation.any()


def test_reductions_contain_the_body(random: np.random.Generator) -> None:
    given = body(random, 40)
    for rule in ["best", "girard", "combastel", "pca", "scott", "adaptive", "cluster", "lemma_5_5"]:
        less = given.reduce(12, rule=rule)
        assert len(less.body) <= 12 and less.lower <= less.upper and less.verify()
        assert given.hausdorff(less.body).contained


def test_prepared_bodies_answer_as_the_body(random: np.random.Generator) -> None:
    chosen = set()
    for n, expected in [(4, 10), (4, 100_000), (300, 5_000), (5000, 100_000)]:
        given = body(random, n)
        prepared = given.prepare(expected)
        points = near_the_boundary(given, random, 200)
        chosen.add(prepared.structure)
        assert (prepared.locate(points) == given.locate(points)).all() and prepared.bytes > 0
        assert (prepared.contains(points) == given.contains(points)).all()
        assert np.allclose(prepared.gauge(points), given.gauge(points), rtol=1e-12)
    assert {"facets", "blocks", "direction tree"} <= chosen
    with pytest.raises(zonotope.DimensionMismatch):
        Zonotope([0, 0], np.eye(2)).prepare()


def test_many_threads_of_python_get_the_same_answers(random: np.random.Generator) -> None:
    given = body(random, 64)
    points = near_the_boundary(given, random, 20_000)
    expected = given.locate(points)
    found: list[bool] = []

    def ask() -> None:
        found.append(bool((given.locate(points) == expected).all()))

    threads = [threading.Thread(target=ask) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [True] * 4


def test_frames_are_answered_as_fresh_questions(random: np.random.Generator) -> None:
    a, b = body(random, 10), body(random, 10)
    angles = np.linspace(0, 6, 400)
    poses = np.tile(np.eye(4), (400, 1, 1))
    poses[:, 0, 0] = poses[:, 1, 1] = np.cos(angles)
    poses[:, 1, 0], poses[:, 0, 1] = np.sin(angles), -np.sin(angles)
    moved = np.tile(np.eye(4), (400, 1, 1))
    moved[:, 0, 3] = np.linspace(9, 25, 400)
    tracked = zonotope.track(a, b, poses, moved)
    back = np.linalg.inv(poses) @ moved
    assert tracked.dtype == np.int8 and {-1, 1} == set(tracked)
    fresh = [a.intersects(b, pose=(pose[:3, :3], pose[:3, 3])) for pose in back]
    assert np.mean([bool(meets) == (place <= 0) for meets, place in zip(fresh, tracked, strict=True)]) > 0.99
    tracker = zonotope.Tracker(a, b)
    frames = [tracker.frame(*pair) for pair in zip(poses, moved, strict=True)]
    assert [{"inside": -1, "boundary": 0, "outside": 1}[meets.status] for meets in frames] == tracked.tolist()
    assert all(meets.verify() for meets in frames[::40])
    with pytest.raises(zonotope.BadInput, match="last row"):
        tracker.frame(np.ones((4, 4)))
    with pytest.raises(zonotope.DimensionMismatch, match="4, 4"):
        zonotope.track(a, b, np.eye(3), moved)
    with pytest.raises(zonotope.BadInput, match="last row"):
        zonotope.track(a, b, np.ones((1, 4, 4)), moved[:1])
    with pytest.raises(zonotope.LengthMismatch):
        zonotope.track(a, b, poses, moved[:3])
