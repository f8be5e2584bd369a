"""Questions to Zonotope Workbench from Python: `zonobench solve` as a co-process.

A process is started once. A question is one line of JSON on its standard input, and the answer is the next line of its
standard output; so thousands of small questions a second are asked without starting a program for each.

A process that still owes an answer is never asked again: it is taken out of use before it gets a question, and comes
back into use once the answer to this very question has been read. Whatever comes in between, as a signal, a time limit
or an answer to another question, the process is ended, and the next question begins another one.
"""

import contextlib
import json
import math
import numbers
import os
import subprocess
import tempfile
import threading
import weakref


class Refused(Exception):
    """A question that was not answered; `code` is one of the manual's list of codes."""

    def __init__(self, code, message):
        super().__init__(f"{code}: {message}")
        self.code = code


class NoAnswer(EOFError):
    """The process ended before it answered; the message has what it said on its standard error."""


class WrongAnswer(NoAnswer):
    """A line that is no answer to the question that was asked. The process has been ended."""


def encoded(value):
    """The value as the manual wants it in a question: NaN and infinities are spelled, arrays are lists.

    Numbers of other sorts (`Decimal`, `Fraction`, NumPy's) become the nearest double, as all numbers of a question do.
    """
    if value is None or isinstance(value, (str, bool)) or type(value) is int:
        return value
    if isinstance(value, dict):
        return {name: encoded(entry) for name, entry in value.items()}
    if isinstance(value, (list, tuple, range)):
        return [encoded(entry) for entry in value]
    for conversion in ("to_numpy", "tolist"):
        if hasattr(value, conversion):
            converted = getattr(value, conversion)()
            if type(converted) is not type(value):
                return encoded(converted)
    if isinstance(value, numbers.Integral):
        return int(value)
    if isinstance(value, numbers.Real) or hasattr(value, "as_integer_ratio"):
        return spelled(float(value))
    raise TypeError(f"{value!r} is neither a number nor a list of numbers")


def spelled(number):
    """The float, or the word for it where it is not finite."""
    if math.isfinite(number):
        return number
    return "NaN" if math.isnan(number) else "Infinity" if number > 0 else "-Infinity"


class Process:
    """A running `zonobench solve`. Pipes have no buffers here, so that nothing is left in them that a fork would copy;
    standard error is a file, so that it is never full."""

    def __init__(self, program):
        self.owner = os.getpid()
        self.complaints = tempfile.TemporaryFile()
        try:
            self.popen = subprocess.Popen(
                [program, "solve"], bufsize=0, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.complaints
            )
        except FileNotFoundError as error:
            raise FileNotFoundError(
                f"there is no program {program!r}: set the environment variable ZONOBENCH to its path, or install it "
                "by `cargo install --path workbench/zonobench`"
            ) from error
        _PROCESSES.add(self)

    def is_alive(self):
        return self.popen.poll() is None

    def answer(self, question):
        """The line that answers a line; none if the process ends before."""
        rest = memoryview(question)
        try:
            while rest:
                rest = rest[os.write(self.popen.stdin.fileno(), rest) :]
        except BrokenPipeError:
            return None
        parts = []
        while not parts or not parts[-1].endswith(b"\n"):
            part = os.read(self.popen.stdout.fileno(), 1 << 16)
            if not part:
                return None
            parts.append(part)
        return b"".join(parts)

    def obituary(self):
        """The status of a process whose output has ended, and the last of what it said on standard error."""
        try:
            status = self.popen.wait(timeout=10)
        except subprocess.TimeoutExpired:
            status = "unknown: it still runs"
        self.complaints.seek(max(0, self.complaints.seek(0, os.SEEK_END) - 2000))
        said = self.complaints.read().decode("utf-8", "replace").strip()
        return f"zonobench ended with status {status}" + (f": {said}" if said else "")

    def close(self, patience=0):
        """Ends the process: at the end of its input, or by force after `patience` seconds. That of a parent goes on."""
        if self.owner != os.getpid():
            self.release()
            return
        try:
            self.popen.stdin.close()
            if patience:
                self.popen.wait(timeout=patience)
        except subprocess.TimeoutExpired:
            pass
        finally:
            self.popen.kill()
            # An interrupt inside a wait can leave the lock of `subprocess` taken; an endless wait would never end then.
            with contextlib.suppress(subprocess.TimeoutExpired):
                self.popen.wait(timeout=10)
            self.release()

    def release(self):
        """Closes this side of the pipes and leaves the process alone."""
        for file in (self.popen.stdin, self.popen.stdout, self.complaints):
            file.close()


class Workbench:
    """Asks a `zonobench solve`, which is found by its path, the environment variable ZONOBENCH, or the PATH.

    Any number of threads may ask: a question waits until the one before it is answered. `timeout` is the longest time
    in seconds that an answer may take; without it there is no limit. A fork of this process has a `zonobench` of its
    own.
    """

    def __init__(self, program=None, timeout=None):
        self._program = program or os.environ.get("ZONOBENCH") or "zonobench"
        self._timeout = timeout
        self._asked = 0
        self._is_closed = False
        self._lock = threading.RLock()
        # None while a question is under way: a process in this field owes no answer.
        self._process = Process(self._program)
        _WORKBENCHES.add(self)

    def ask(self, kind, method=None, **question):
        """The `result` of a question as a dictionary: the manual lists kinds, their fields and their results.

        Lists of lists and whatever has `tolist`, as NumPy's arrays do, are vectors and matrices. Raises `Refused`, or
        `NoAnswer` where the process ended, `WrongAnswer` where its line answers something else, `TimeoutError`.
        """
        line = {"kind": kind, "input": encoded(question)}
        if method is not None:
            line["method"] = method
        with self._lock:
            if self._is_closed:
                raise ValueError("this workbench is closed")
            self._asked += 1
            own = str(self._asked)
            text = json.dumps({"id": own, **line}, allow_nan=False).encode("ascii") + b"\n"
            process, self._process = self._process, None
            try:
                if process is not None and not process.is_alive():
                    process.release()
                    process = None
                if process is None:
                    process = Process(self._program)
                answer = self._answer(process, text)
                outcome = _checked(answer, own)
            except BaseException:
                if process is not None:
                    process.close()
                raise
            # A signal's handler that asked in the meantime has begun a process of its own.
            surplus, self._process = self._process, process
            if surplus is not None:
                surplus.close()
        if "error" in outcome:
            raise _refusal(outcome)
        return _decoded(outcome["result"])

    def _answer(self, process, text):
        """The line that answers a line, within the time limit."""
        is_late = threading.Event()
        timer = None
        if self._timeout is not None:

            def end():
                is_late.set()
                process.popen.kill()

            timer = threading.Timer(self._timeout, end)
            timer.daemon = True
            timer.start()
        try:
            answer = process.answer(text)
        finally:
            if timer is not None:
                timer.cancel()
                timer.join()
        if is_late.is_set():
            raise TimeoutError(f"there was no answer within {self._timeout} seconds")
        if answer is None:
            raise NoAnswer(process.obituary())
        return answer

    def close(self):
        """Ends the process, once the question under way is answered. Nothing can be asked afterwards."""
        with self._lock:
            self._is_closed = True
            process, self._process = self._process, None
            if process is not None:
                process.close(patience=10)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


def _checked(answer, own):
    """The answer as a dictionary, if it answers the question with this id."""
    try:
        read = json.loads(answer)
    except ValueError:
        raise WrongAnswer(f"not a line of JSON: {answer[:200]!r}") from None
    if not isinstance(read, dict) or not ("result" in read or isinstance(read.get("error"), dict)):
        raise WrongAnswer(f"neither an answer nor a refusal: {answer[:200]!r}")
    if read.get("id") is None and "error" in read:
        # A line so long that the program did not keep it is refused without its id.
        raise _refusal(read)
    if read.get("id") != own:
        raise WrongAnswer(f"the question was {own!r}, but this answers {read.get('id')!r}")
    return read


def _decoded(value):
    """The value with the strings for numbers that are not finite as floats."""
    if isinstance(value, dict):
        return {name: _decoded(part) for name, part in value.items()}
    if isinstance(value, list):
        return [_decoded(part) for part in value]
    if isinstance(value, str) and value in ("NaN", "Infinity", "-Infinity"):
        return float(value.replace("Infinity", "inf"))
    return value


def _refusal(answer):
    return Refused(answer["error"].get("code"), answer["error"].get("message"))


_WORKBENCHES = weakref.WeakSet()
_PROCESSES = weakref.WeakSet()


def _forked():
    """In a fork: the locks may be held by threads that are not here, and the processes are the parent's."""
    for process in list(_PROCESSES):
        process.release()
    for workbench in list(_WORKBENCHES):
        workbench._lock = threading.RLock()
        workbench._process = None


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forked)
