"""The notebook runs, and says what it is meant to say."""

from __future__ import annotations

from pathlib import Path

import nbformat
from nbclient import NotebookClient


def test_the_tour_runs() -> None:
    notebook = nbformat.read(Path(__file__).parents[1] / "tour.ipynb", as_version=4)  # type: ignore[no-untyped-call]
    NotebookClient(notebook, timeout=120).execute()
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    texts = [output.get("data", {}).get("text/plain", "") for output in outputs]
    assert "array([ 0,  1, -1], dtype=int8)" in texts
    assert sum("Verdict(word='right'" in text for text in texts) == 6
