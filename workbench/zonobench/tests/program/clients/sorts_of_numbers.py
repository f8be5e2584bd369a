"""Numbers of all sorts in questions: each becomes the nearest double, and what is no number is refused here."""

import array
import sys
from decimal import Decimal
from fractions import Fraction

from zonobench import Refused, Workbench, encoded

nan, infinity = float("nan"), float("inf")
assert encoded([1, 2.5, True, None, "x", (3,), range(2)]) == [1, 2.5, True, None, "x", [3], [0, 1]]
assert encoded({"a": nan, "b": (infinity, -infinity)}) == {"a": "NaN", "b": ["Infinity", "-Infinity"]}
assert encoded([Decimal("0.1"), Fraction(1, 3), Decimal("NaN"), Decimal("-Infinity"), 2**80]) == [
    0.1,
    1 / 3,
    "NaN",
    "-Infinity",
    2**80,
]
assert encoded(array.array("d", [0.1, nan])) == [0.1, "NaN"]
for wrong in [1j, {1, 2}, b"1", object(), [[1, object()]]]:
    try:
        raise AssertionError(encoded(wrong))
    except TypeError as error:
        assert "neither a number nor a list of numbers" in str(error), error

with Workbench() as workbench:

    def value(*coordinates):
        return workbench.ask("support", direction=[1, 1], center=coordinates, generators=[])["value"]

    assert value(Decimal("0.1"), Fraction(1, 4)) == 0.35
    assert value(2**53 + 1, 0) == 2**53
    assert value(sys.float_info.max, 0) == sys.float_info.max
    for wrong in [nan, infinity, -infinity, Decimal("sNaN"), Decimal("1e999"), 10**400]:
        try:
            raise AssertionError(value(0, wrong))
        except Refused as refused:
            assert refused.code == "non_finite", refused
        except ValueError as error:
            assert wrong.is_snan(), error
    try:
        raise AssertionError(value(0, object()))
    except TypeError:
        pass
    assert value(3, 4) == 7, "what was refused here has not been asked"

    try:
        import numpy
    except ImportError:
        print("numpy is not there")
        sys.exit(0)
    assert encoded(numpy.array([[1, 2], [3, 4]], dtype=numpy.uint8)) == [[1, 2], [3, 4]]
    scalars = [numpy.float16(0.5), numpy.float32(0.1), numpy.int64(7), numpy.bool_(True), numpy.longdouble(0.25)]
    assert encoded(scalars) == [0.5, float(numpy.float32(0.1)), 7, True, 0.25]
    assert encoded(numpy.array([0.5, nan], dtype=numpy.longdouble)) == [0.5, "NaN"]
    assert value(*numpy.array([3.0, 4.0])) == 7
