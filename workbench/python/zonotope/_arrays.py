"""Array-likes as contiguous doubles."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _errors

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


def doubles(given: ArrayLike, name: str) -> NDArray[np.float64]:
    """The numbers as a contiguous array of doubles, each the nearest one; complex numbers, texts and masked entries are
    refused."""
    import numpy as np

    if isinstance(given, np.ma.MaskedArray) and np.ma.is_masked(given):
        raise _errors.BadInput(f"{name} has masked entries; `compressed()` and `filled(…)` make arrays without them")
    try:
        array = np.asarray(given)
        if array.dtype.kind in "cSUMmV":
            raise TypeError(f"holds {array.dtype}, not real numbers")
        return np.ascontiguousarray(array, dtype=np.float64).reshape(array.shape)
    except (TypeError, ValueError, OverflowError) as error:
        raise _errors.BadInput(f"{name} is no array of real numbers: {error}") from None


def listed(given: ArrayLike, name: str, *, axes: int) -> list[Any]:
    """The numbers of an array with so many axes as nested lists for a question; each has to be finite."""
    import numpy as np

    array = doubles(given, name)
    if array.ndim != axes:
        wanted = "(m, d)" if axes == 2 else "(d,)"
        raise _errors.DimensionMismatch(f"{name} has shape {array.shape}, not {wanted}")
    if not np.isfinite(array).all():
        place = np.argwhere(~np.isfinite(array))[0].tolist()
        raise _errors.NonFinite(f"{name}{place} is {array[tuple(place)]}, not a finite number")
    values: list[Any] = array.tolist()
    return values


def vector_of_space(given: ArrayLike, name: str) -> list[float]:
    """The three coordinates of a vector of space."""
    values = listed(given, name, axes=1)
    if len(values) != 3:
        raise _errors.DimensionMismatch(f"{name} has shape ({len(values)},), not (3,)")
    return values


def number(given: Any, name: str) -> float:
    """A finite number for a question."""
    try:
        value = float(given)
    except (TypeError, ValueError, OverflowError) as error:
        raise _errors.BadInput(f"{name} is no number: {error}") from None
    if value - value != 0:
        raise _errors.NonFinite(f"{name} is {value}, not a finite number")
    return value
