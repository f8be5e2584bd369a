"""What the tests share."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import zonotope


@pytest.fixture
def cube() -> zonotope.Zonotope:
    return zonotope.Zonotope([0, 0, 0], np.eye(3))


@pytest.fixture
def random() -> np.random.Generator:
    return np.random.default_rng(2003)


def body(random: np.random.Generator, n: int, d: int = 3) -> zonotope.Zonotope:
    return zonotope.Zonotope.from_generators(random.normal(size=(n, d)), random.normal(size=d))


def near_the_boundary(body: zonotope.Zonotope, random: np.random.Generator, m: int) -> NDArray[np.float64]:
    """Points whose gauge is 1 but for a part in 10^9."""
    points = random.normal(size=(m, body.dimension)) + body.center
    gauges = body.gauge(points)
    factors = (1 + random.normal(size=m) * 1e-9) / gauges
    near: NDArray[np.float64] = body.center + (points - body.center) * factors[:, None]
    return near
