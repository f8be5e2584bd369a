"""Answers that carry their proof, and its check."""

from __future__ import annotations

import json
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from . import _errors
from ._zonotope import solve, verify

if TYPE_CHECKING:
    from collections.abc import Mapping

    import numpy as np
    from numpy.typing import NDArray

    from ._body import Zonotope


Kind = TypeVar("Kind", bound="Answer")


class Verdict(NamedTuple):
    """What the verifier says of an answer. It is true where every statement of the answer was proved.

    >>> bool(Verdict("unchecked", "too many generators"))
    False
    """

    word: str
    """`right`, `wrong`, or `unchecked` where not everything could be proved and nothing was found wrong."""
    reason: str
    """What was proved, or what is wrong or open."""

    def __bool__(self) -> bool:
        return self.word == "right"


class Answer:
    """An answer to a question of the batch.

    Attributes
    ----------
    question, answer : str
        The lines of JSON that `zonobench solve` and `zonobench verify` read.
    result : dict
        All fields of the answer, as the manual of the batch has them.
    proof : dict
        The certificate: what has to be looked at to be sure of the answer.
    """

    def __init__(self, kind: str, given: str, method: str | None = None) -> None:
        asked = "" if method is None else f',"method":{json.dumps(method)}'
        self.question = f'{{"id":"python","kind":"{kind}","input":{given}{asked}}}'

    @cached_property
    def answer(self) -> str:
        return solve(self.question)

    @cached_property
    def result(self) -> dict[str, Any]:
        answer = json.loads(self.answer)
        if "error" in answer:
            raise _errors.of_code(answer["error"]["code"], answer["error"]["message"])
        result: dict[str, Any] = answer["result"]
        return result

    def now(self: Kind) -> Kind:
        """The answer itself, after its question has been answered or refused."""
        _ = self.result
        return self

    @property
    def proof(self) -> dict[str, Any]:
        certificate: dict[str, Any] = self.result.get("certificate", {})
        return certificate

    def verify(self) -> Verdict:
        """Checks the answer by the crate `verifier`, which shares nothing with the solvers, in exact integers.

        Returns
        -------
        Verdict
        """
        return Verdict(*verify(self.question, self.answer))

    def __reduce__(self) -> tuple[Any, ...]:
        return (_of_lines, (type(self), self.question, self.answer))


def _of_lines(kind: type[Answer], question: str, answer: str) -> Answer:
    made = kind.__new__(kind)
    made.question = question
    made.__dict__["answer"] = answer
    return made


def number(value: float | str) -> float:
    """A number of an answer; what is not finite is spelled there."""
    return float(value)


class Reduction(Answer):
    """A zonotope of fewer generators around another.

    >>> from zonotope import Zonotope
    >>> octagon = Zonotope([5, 0], [[1, 0, 1, 1], [0, 1, 1, -1]])
    >>> box = octagon.reduce(2, rule="girard")
    >>> box.body.generators.tolist(), box.lower <= 2**0.5 <= box.upper
    ([[3.0, 0.0], [0.0, 3.0]], True)
    """

    @property
    def body(self) -> Zonotope:
        """The reduced body, which contains the given one exactly."""
        return body_of(self.result)

    @property
    def lower(self) -> float:
        """A proven lower bound of the Hausdorff distance between the two."""
        return number(self.result["hausdorff"]["lower"])

    @property
    def upper(self) -> float:
        """A proven upper bound of the Hausdorff distance between the two."""
        return number(self.result["hausdorff"]["upper"])

    def __repr__(self) -> str:
        return f"Reduction({len(self.result['generators'])} generators, upper={self.upper!r})"


class Collision(Answer):
    """Whether two moving bodies meet during a step of time, and when first. It is false where they are proved to stay
    apart, and true otherwise.

    The times are fractions of the step, from 0 to 1. The `intervals` of the proof go from 0 to the end of the step or
    to the first time: in each of them the bodies are apart along a direction, which is fixed in space or in a body.

    >>> import zonotope
    >>> point = zonotope.Zonotope.from_generators([[0, 0, 0]])
    >>> missed = zonotope.first_contact(point, point + [0, 1, 0], zonotope.Motion(translation=[4, 0, 0]))
    >>> missed, bool(missed), bool(missed.verify())
    (Collision('separate', time=None), False, True)
    """

    @property
    def status(self) -> str:
        """`separate`, `contact`, or `grazing` where neither could be proved: the bodies come so near that two of their
        points are within `distance_at_most` at the second time, and may touch or not."""
        return str(self.result["status"])

    @property
    def time(self) -> tuple[float, float] | None:
        """Bounds of the first contact: free before the first, meeting at the second, or nearly so for a `grazing`; none
        if separate."""
        time = self.result.get("time")
        return None if time is None else (number(time[0]), number(time[1]))

    def __bool__(self) -> bool:
        return self.status != "separate"

    @property
    def distance_at_most(self) -> float | None:
        """An upper bound of the distance at the second time of a `grazing`; none for the others."""
        distance = self.result.get("distance_at_most")
        return None if distance is None else number(distance)

    def __repr__(self) -> str:
        return f"Collision({self.status!r}, time={self.time!r})"


def body_of(result: Mapping[str, Any]) -> Zonotope:
    """The body in an answer."""
    from ._body import Zonotope

    center = [number(c) for c in result["center"]]
    rows = [[number(c) for c in row] for row in result["generators"]]
    return Zonotope.from_generators(rows, center)
