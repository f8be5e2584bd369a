"""Bodies as values: what they hold, sums and images, copies, errors."""

from __future__ import annotations

import copy
import math
import pickle
from collections.abc import Callable
from fractions import Fraction
from typing import Any, cast

import numpy as np
import pytest
from conftest import body
from numpy.typing import NDArray

import zonotope
from zonotope import Zonotope


def test_generators_are_columns_and_rows() -> None:
    columns = Zonotope([1, 2], [[1, 0, 3], [0, 1, 4]])
    rows = Zonotope.from_generators([[1, 0], [0, 1], [3, 4]], [1, 2])
    assert columns == rows and len(columns) == 3 and columns.dimension == 2
    assert columns.G.tolist() == [[1, 0, 3], [0, 1, 4]] and columns.generators.tolist() == [[1, 0], [0, 1], [3, 4]]
    assert columns.c.tolist() == columns.center.tolist() == [1, 2]
    assert Zonotope.from_generators(np.empty((0, 3))).dimension == 3
    assert bool(Zonotope([0], np.empty((1, 0))))


@pytest.mark.parametrize("dtype", [np.float16, np.float32, np.float64, np.int8, np.int64, np.uint16, bool, object])
def test_every_real_dtype_and_any_strides(dtype: type) -> None:
    matrix: NDArray[Any] = np.array([[1, 0, 1], [0, 1, 1]]).astype(dtype)
    expected = Zonotope([0, 0], [[1, 0, 1], [0, 1, 1]])
    assert Zonotope([0, 0], matrix) == Zonotope([0, 0], np.asfortranarray(matrix)) == expected
    wide: NDArray[Any] = np.zeros((4, 6), dtype=dtype)
    wide[::2, ::2] = matrix
    assert Zonotope([0, 0], wide[::2, ::2]) == expected
    assert Zonotope([0, 0], matrix[:, ::-1]).volume == expected.volume


def test_sums_and_images_are_those_of_sets() -> None:
    square = Zonotope([0, 0], np.eye(2))
    hexagon = square + Zonotope([5, 0], [[1], [1]])
    assert len(hexagon) == 3 and hexagon.center.tolist() == [5, 0]
    assert (square + [1, 2]).center.tolist() == ([1, 2] + square).center.tolist() == [1, 2]
    assert (np.array([1, 2]) + square).center.tolist() == [1, 2]
    assert (square - [1, 2]).center.tolist() == [-1, -2]
    assert (-hexagon).center.tolist() == [-5, 0]
    assert (2 * square).volume == (square * 2).volume == 16
    image = np.array([[1, 1], [0, 1], [2, 0]]) @ square
    assert image.dimension == 3 and image.volume == 0
    with pytest.raises(TypeError, match="two meanings"):
        square - square  # type: ignore[operator]


def test_an_image_that_is_rounded_encloses() -> None:
    third = (1 / 3) * Zonotope([1], [[3]])
    exact = [(Fraction(1 / 3) * x) for x in (-2, 4)]
    low, high = third.bounding_box()
    assert Fraction(low[0]) <= exact[0] and exact[1] <= Fraction(high[0])


def test_copies_and_pickles_are_equal(random: np.random.Generator) -> None:
    for d in range(1, 7):
        given = body(random, 4, d)
        assert given == copy.copy(given) == copy.deepcopy(given) == pickle.loads(pickle.dumps(given))
        assert hash(given) == hash(copy.copy(given)) and given != body(random, 4, d)
    where = body(random, 5).location([9, 9, 9])
    again = pickle.loads(pickle.dumps(where))
    assert again.status == where.status and again.proof == where.proof and again.verify()
    meets = pickle.loads(pickle.dumps(given.intersects(given)))
    assert meets.status == "boundary" and meets.verify()  # flat, as four generators in six dimensions are


def test_shapes_that_do_not_go_together_are_named() -> None:
    cube = Zonotope([0, 0, 0], np.eye(3))
    with pytest.raises(zonotope.DimensionMismatch, match=r"\(3,\).*\(2, 4\)"):
        Zonotope([0, 0, 0], np.ones((2, 4)))
    with pytest.raises(zonotope.DimensionMismatch, match=r"\(5, 2\).*\(m, 3\)"):
        cube.contains(np.ones((5, 2)))
    with pytest.raises(zonotope.DimensionMismatch, match="3 and 2 coordinates"):
        cube.intersects(Zonotope([0, 0], np.eye(2)))
    with pytest.raises(zonotope.DimensionMismatch, match="1 to 6"):
        Zonotope(np.zeros(7), np.eye(7))
    with pytest.raises(zonotope.DimensionMismatch, match="matrix"):
        np.ones((2, 2)) @ cube


def test_errors_are_one_family_with_the_codes_of_the_batch() -> None:
    cube = Zonotope([0, 0, 0], np.eye(3))
    refused: list[tuple[str, object]] = [
        ("non_finite", lambda: Zonotope([np.nan, 0], np.eye(2))),
        ("non_finite", lambda: cube.contains([[0.0, 0.0, 0.0], [0.0, math.inf, 0.0]])),
        ("non_finite", lambda: cube.location([0, np.inf, 0])),
        ("non_finite", lambda: cube.support([np.nan, 0, 0])),
        ("bad_input", lambda: Zonotope(["a", "b"], np.eye(2))),
        ("bad_input", lambda: Zonotope([1j, 0], np.eye(2))),
        ("bad_epsilon", lambda: zonotope.min_length([[0, 0]], 2)),
        ("empty", lambda: zonotope.min_area(np.empty((0, 2)))),
        ("zero_axis", lambda: zonotope.Motion(axis=[0, 0, 0], angle=1).swept(cube)),
        ("negative_weight", lambda: zonotope.along_directions([[0, 0]], [[1, 0]], [-1])),
        ("length_mismatch", lambda: zonotope.along_directions([[0, 0]], [[1, 0]], [1, 2])),
        ("unknown_method", lambda: cube.location([0, 0, 0], method="by_magic")),
    ]
    for code, ask in refused:
        with pytest.raises(zonotope.ZonotopeError) as caught:
            ask()  # type: ignore[operator]
        assert caught.value.code == code and isinstance(caught.value, ValueError)
    placed: list[tuple[Callable[[], object], str]] = [
        (lambda: cube.contains([[0.0, 0.0, 0.0], [0.0, math.inf, 0.0]]), r"points\[1, 1\] is inf"),
        (lambda: cube.gauge([0.0, 0.0, math.nan]), r"points\[2\] is NaN"),
        (lambda: cube.extreme_points([[1.0, -math.inf, 0.0]]), r"directions\[0, 1\] is -inf"),
        (lambda: zonotope.min_length([[0.0, 0.0], [0.0, math.nan]]), r"points\[1, 1\] is nan"),
        (lambda: zonotope.min_length([[0.0, 0.0]], math.nan), "epsilon is nan"),
        (lambda: zonotope.Motion(translation=[0, math.inf, 0]), r"translation\[1\] is inf"),
    ]
    for ask, place in placed:
        with pytest.raises(zonotope.NonFinite, match=place):
            ask()


def test_arguments_of_another_kind_are_refused_by_name() -> None:
    cube: Any = Zonotope([0, 0, 0], np.eye(3))
    motion = zonotope.Motion()
    refused: list[tuple[Callable[[], object], str]] = [
        (lambda: cube.intersects([0, 0, 0]), "other is a list, not a Zonotope"),
        (lambda: cube.distance(cube.G), "other is a ndarray, not a Zonotope"),
        (lambda: cube.penetration(None), "other is a NoneType, not a Zonotope"),
        (lambda: cube.hausdorff((1, 2)), "other is a tuple, not a Zonotope"),
        (lambda: zonotope.first_contact(cube, cast(Any, [0, 0, 0])), "b is a list, not a Zonotope"),
        (lambda: zonotope.first_contact(cube, cube, cast(Any, (np.eye(3), [0, 0, 0]))), "motion_a is a tuple, not a"),
        (lambda: zonotope.track(cube, cast(Any, 3), [], []), "b is a int, not a Zonotope"),
        (lambda: motion.swept(cast(Any, [1])), "body is a list, not a Zonotope"),
        (lambda: cube.prepare(-5), "expected is -5"),
        (lambda: cube.contains(np.ma.masked_array([0.0, 0.0, 0.0], [True, False, False])), "points has masked entries"),
    ]
    for ask, words in refused:
        with pytest.raises(zonotope.BadInput, match=words):
            ask()
    with pytest.raises(TypeError, match="A @ Z"):
        cube @ np.eye(3)
    with pytest.raises(TypeError, match="multiplied by a number"):
        np.eye(3) * cube
    with pytest.raises(zonotope.DimensionMismatch, match=r"translation has shape \(\), not \(3,\)"):
        cube + 1
    with pytest.raises(zonotope.DimensionMismatch, match=r"translation has shape \(2,\), not \(3,\)"):
        zonotope.Motion(translation=[1, 2])
    assert [0.5, 0, 1] in cube and [2, 0, 0] not in cube


def test_faces_beyond_the_memory_are_refused() -> None:
    many = Zonotope.from_generators(np.random.default_rng(1).normal(size=(4097, 3)))
    for ask in (many.vertices, many.faces, many.to_mesh):
        with pytest.raises(zonotope.TooLarge, match="of 4097 generators has more than 16777216 vertices"):
            ask()
    plane = np.column_stack([np.random.default_rng(2).normal(size=(5000, 2)), np.zeros(5000)])
    assert Zonotope.from_generators(plane).vertices().shape == (10_000, 3)
    assert Zonotope.from_generators(np.tile(np.eye(3), (3000, 1))).to_mesh()[0].shape == (8, 3)
    assert Zonotope([0, 0, 0], 1e308 * np.eye(3)).volume == math.inf


def test_a_panic_does_not_cross_the_border(capfd: pytest.CaptureFixture[str]) -> None:
    from zonotope import _zonotope

    with pytest.raises(zonotope.InternalError, match="provoked"):
        _zonotope.provoke_panic("provoked")
    assert Zonotope([0], [[1]]).contains([0.5])
    capfd.readouterr()
