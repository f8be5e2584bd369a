"""Questions to Zonotope Workbench from Python: `zonobench solve` as a co-process.

The process is started once. A question is one line of JSON on its standard input, and the answer is the next line of
its standard output; so thousands of small questions a second are asked without starting a program for each.
"""

import json
import math
import os
import subprocess


class Refused(Exception):
    """A question that was not answered; `code` is one of the manual's list of codes."""

    def __init__(self, code, message):
        super().__init__(f"{code}: {message}")
        self.code = code


def encoded(value):
    """The value as the manual wants it in a question: NaN and infinities are spelled, arrays are lists."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, float) and not math.isfinite(value):
        return "NaN" if math.isnan(value) else "Infinity" if value > 0 else "-Infinity"
    if isinstance(value, (list, tuple)):
        return [encoded(entry) for entry in value]
    if isinstance(value, dict):
        return {name: encoded(entry) for name, entry in value.items()}
    return value


class Workbench:
    """A running `zonobench solve`. It is found by its path, the environment variable ZONOBENCH, or the PATH."""

    def __init__(self, program=None):
        program = program or os.environ.get("ZONOBENCH", "zonobench")
        pipe = subprocess.PIPE
        try:
            self._process = subprocess.Popen([program, "solve"], stdin=pipe, stdout=pipe, encoding="utf-8")
        except FileNotFoundError as error:
            raise FileNotFoundError(
                f"there is no program {program!r}: set the environment variable ZONOBENCH to its path, or install it by "
                "`cargo install --path workbench/zonobench`"
            ) from error
        self._asked = 0

    def ask(self, kind, method=None, **question):
        """The `result` of a question as a dictionary: the manual lists kinds, their fields and their results.

        Lists of lists and whatever has `tolist`, as NumPy's arrays do, are vectors and matrices. Raises `Refused`.
        """
        self._asked += 1
        line = {"id": str(self._asked), "kind": kind, "input": encoded(question)}
        if method is not None:
            line["method"] = method
        self._process.stdin.write(json.dumps(line, allow_nan=False) + "\n")
        self._process.stdin.flush()
        answer = self._process.stdout.readline()
        if not answer:
            raise EOFError(f"zonobench ended with status {self._process.wait()}")
        answer = json.loads(answer)
        if "error" in answer:
            raise Refused(answer["error"]["code"], answer["error"]["message"])
        return answer["result"]

    def close(self):
        """Ends the process."""
        self._process.stdin.close()
        self._process.stdout.close()
        self._process.wait()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
