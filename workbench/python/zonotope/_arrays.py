"""Array-likes as contiguous doubles."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _errors

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


def doubles(given: ArrayLike, name: str) -> NDArray[np.float64]:
    """The numbers as a contiguous array of doubles, each the nearest one; complex numbers and texts are refused."""
    import numpy as np

    try:
        array = np.asarray(given)
        if array.dtype.kind in "cSUMmV":
            raise TypeError(f"holds {array.dtype}, not real numbers")
        return np.ascontiguousarray(array, dtype=np.float64).reshape(array.shape)
    except (TypeError, ValueError, OverflowError) as error:
        raise _errors.BadInput(f"{name} is no array of real numbers: {error}") from None


def spelled(values: Any) -> Any:
    """Nested lists of doubles as the batch reads them: what is not finite is spelled."""
    if isinstance(values, list):
        return [spelled(value) for value in values]
    if values - values == 0:
        return values
    return "NaN" if values != values else "Infinity" if values > 0 else "-Infinity"


def listed(given: ArrayLike, name: str, *, axes: int) -> list[Any]:
    """The numbers of an array with so many axes as nested lists for a question."""
    import numpy as np

    array = doubles(given, name)
    if array.ndim != axes:
        wanted = "(m, d)" if axes == 2 else "(d,)"
        raise _errors.DimensionMismatch(f"{name} has shape {array.shape}, not {wanted}")
    values: list[Any] = array.tolist()
    return values if np.isfinite(array).all() else list(spelled(values))


def number(given: Any, name: str) -> Any:
    """A number for a question; a float that is not finite is spelled."""
    try:
        return spelled(float(given))
    except (TypeError, ValueError, OverflowError) as error:
        raise _errors.BadInput(f"{name} is no number: {error}") from None
