"""The golden questions of the batch once more, through this module."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from zonotope import _zonotope

GOLDENS = Path(os.environ.get("GOLDENS", Path(__file__).resolve().parents[3] / "tests" / "goldens"))


@pytest.mark.skipif(not GOLDENS.exists(), reason="the package is tested away from the project")
def test_golden_questions_have_golden_answers() -> None:
    questions = (GOLDENS / "questions.jsonl").read_text().splitlines()
    answers = (GOLDENS / "answers.jsonl").read_text().splitlines()
    assert len(questions) == len(answers) > 50
    for question, golden in zip(questions, answers, strict=True):
        if not question.startswith("{") or '"bad_json"' in golden:
            continue
        answer = _zonotope.solve(question)
        assert json.loads(answer) == json.loads(golden)
        assert _zonotope.verify(question, answer)[0] in ("right", "unchecked")


README = Path(os.environ.get("README", Path(__file__).resolve().parents[3] / "README.md"))


@pytest.mark.skipif(not README.exists(), reason="the package is tested away from the project")
def test_the_script_of_the_readme_prints_what_it_says(capsys: pytest.CaptureFixture[str]) -> None:
    script = README.read_text().split("```python\n")[1].split("```")[0]
    said = [line.split("  # ")[1] for line in script.splitlines() if line.startswith("print(")]
    exec(script, {})
    assert capsys.readouterr().out.splitlines() == said and len(said) > 3
