"""Zonotopes as bounding volumes: exact answers, with proofs that anyone can check.

A zonotope is a Minkowski sum of segments, { c + Σ δ_i g_i : |δ_i| ≤ 1 }, given by its centre c and its generators g_i.

>>> import zonotope
>>> cube = zonotope.Zonotope([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
>>> cube.contains([[0.5, 0.5, 0.5], [2, 0, 0]]).tolist()
[True, False]
>>> apart = cube.intersects(cube + [3, 0, 0])
>>> bool(apart), apart.proof
(False, {'separating_direction': [1.5, 0.0, 0.0]})
>>> apart.verify()
Verdict(word='right', reason='outside; the direction separates exactly')
"""

from ._answers import Answer, Collision, Reduction, Verdict
from ._body import Zonotope
from ._enclosing import Along, Enclosing, along_directions, min_area, min_length
from ._errors import (
    BadAngle,
    BadEpsilon,
    BadInput,
    DimensionMismatch,
    Empty,
    InternalError,
    LengthMismatch,
    NegativeWeight,
    NonFinite,
    TooLarge,
    UnknownMethod,
    ZeroAxis,
    ZonotopeError,
)
from ._motion import Motion, Tracker, first_contact, track
from ._prepared import Prepared
from ._relations import Distance, Hausdorff, Intersection, Location, Penetration

__version__ = "0.1.0"

__all__ = [
    "Along",
    "Answer",
    "BadAngle",
    "BadEpsilon",
    "BadInput",
    "Collision",
    "DimensionMismatch",
    "Distance",
    "Empty",
    "Enclosing",
    "Hausdorff",
    "InternalError",
    "Intersection",
    "LengthMismatch",
    "Location",
    "Motion",
    "NegativeWeight",
    "NonFinite",
    "Penetration",
    "Prepared",
    "Reduction",
    "TooLarge",
    "Tracker",
    "UnknownMethod",
    "Verdict",
    "ZeroAxis",
    "Zonotope",
    "ZonotopeError",
    "along_directions",
    "first_contact",
    "min_area",
    "min_length",
    "track",
]
