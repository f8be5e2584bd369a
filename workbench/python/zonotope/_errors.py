"""The exceptions of the package: one family, with the codes of the batch."""

from __future__ import annotations


class ZonotopeError(ValueError):
    """A question that is refused. `code` is a word that programs can compare, the message names the place."""

    code = "refused"


class BadInput(ZonotopeError):
    """A value is missing, superfluous, or of the wrong type."""

    code = "bad_input"


class NonFinite(ZonotopeError):
    """A number is NaN or infinite."""

    code = "non_finite"


class DimensionMismatch(ZonotopeError):
    """Shapes do not go together; the message says both."""

    code = "dimension_mismatch"


class LengthMismatch(ZonotopeError):
    """Two lists that go together are not of one length."""

    code = "length_mismatch"


class Empty(ZonotopeError):
    """Nothing was given where something is needed."""

    code = "empty"


class NegativeWeight(ZonotopeError):
    """A weight is below zero."""

    code = "negative_weight"


class BadEpsilon(ZonotopeError):
    """A precision is not between 0 and 1."""

    code = "bad_epsilon"


class ZeroAxis(ZonotopeError):
    """A rotation has no axis."""

    code = "zero_axis"


class BadAngle(ZonotopeError):
    """A rotation is by an angle that is not taken."""

    code = "bad_angle"


class TooLarge(ZonotopeError):
    """More was given than is taken, or the work would pass its stated limit."""

    code = "too_large"


class UnknownMethod(ZonotopeError):
    """No method or rule has that name; the message lists those that exist."""

    code = "unknown_method"


class InternalError(ZonotopeError):
    """The library broke a promise of its own; please report the message. Nothing is left in a broken state."""

    code = "internal_error"


_OF_CODE = {error.code: error for error in ZonotopeError.__subclasses__()}


def of_code(code: str, message: str) -> ZonotopeError:
    """The exception for a code of the batch."""
    return _OF_CODE.get(code, ZonotopeError)(message)
