"""Every public name is described, and shown in an example that is run."""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import matplotlib
import pytest

import zonotope

matplotlib.use("Agg")
PAGE = Path(__file__).resolve().parents[1] / "README.md"


def shown(name: str, of: Any) -> Iterator[tuple[str, Any]]:
    """A public name, and what a class has of its own that is called."""
    yield name, of
    if inspect.isclass(of) and not issubclass(of, Exception):
        for member, value in vars(of).items():
            if not member.startswith("_") and callable(getattr(of, member)):
                yield f"{name}.{member}", value


def test_everything_public_is_described_and_shown() -> None:
    names = [pair for name in zonotope.__all__ for pair in shown(name, getattr(zonotope, name))]
    described = {name: inspect.getdoc(of) or "" for name, of in names}
    assert len(described) > 50 and all(len(text) > 20 for text in described.values())
    of_errors = {name for name, of in names if inspect.isclass(of) and issubclass(of, Exception)}
    bases = {"Answer", "Answer.now", "Answer.verify"}
    unshown = {name for name, text in described.items() if ">>>" not in text} - of_errors - bases
    assert not unshown


@pytest.mark.parametrize("block", PAGE.read_text().split("```python\n")[1:])
def test_the_page_of_the_package_runs(block: str) -> None:
    names: dict[str, Any] = {}
    exec(block.split("```")[0], names)
    assert names["meets"].verify() and names["shell"].verify()
    assert names["shell"].body.contains(names["points"]).all() and names["shell"].ratio <= 1.01
