"""Lines that are no answer to the question are never returned, whatever program writes them."""

import os
import sys
import tempfile

from zonobench import NoAnswer, Refused, Workbench, WrongAnswer

folder = tempfile.TemporaryDirectory()


def program(body):
    """A program that reads questions and runs `body` for each; it counts them in `number`, from 1."""
    handle, path = tempfile.mkstemp(dir=folder.name)
    lines = [f"#!{sys.executable}", "import json, sys, time", "for number, line in enumerate(sys.stdin, 1):"]
    lines += ["    asked = json.loads(line)", *(f"    {line}" for line in body.splitlines())]
    os.write(handle, "\n".join(lines).encode())
    os.close(handle)
    os.chmod(path, 0o700)
    return path


def answers(id):
    return f'print(json.dumps({{"id": {id}, "result": {{"number": number}}}}), flush=True)'


RIGHT = answers('asked["id"]')

# The next question begins another process, so that its first question is the right one again.
for name, error, body in [
    ("another id", WrongAnswer, answers('"another"')),
    ("the id as a number", WrongAnswer, answers('int(asked["id"])')),
    ("no id", WrongAnswer, answers("None")),
    ("no JSON", WrongAnswer, 'print("answered", flush=True)'),
    ("a list", WrongAnswer, "print([1], flush=True)"),
    ("two lines", WrongAnswer, RIGHT.replace("print(", "print(2 * (").replace(", flush", ' + "\\n"), end="", flush')),
    ("neither result nor error", WrongAnswer, 'print(json.dumps({"id": asked["id"]}), flush=True)'),
    ("a refusal of no question", Refused, 'print(\'{"id": null, "error": {"code": "too_large"}}\', flush=True)'),
    ("an end", NoAnswer, "sys.exit('out of memory')"),
    ("half a line", NoAnswer, "print('{\"id\"', end='', flush=True)\nsys.exit(3)"),
]:
    path = program(f"if asked['kind'] == 'right':\n    {RIGHT}\n    continue\n{body}")
    with Workbench(path) as workbench:
        assert workbench.ask("right") == {"number": 1}
        assert workbench.ask("right") == {"number": 2}
        process = workbench._process
        try:
            raise AssertionError(f"{name}: {workbench.ask('wrong')}")
        except error as found:
            assert type(found) is error, (name, found)
            if name == "an end":
                assert str(found) == "zonobench ended with status 1: out of memory", found
        assert process.popen.poll() is not None, f"{name}: the process has ended"
        assert workbench.ask("right") == {"number": 1}, name

# An answer that comes after the time limit answers nothing.
with Workbench(program(f"time.sleep(0 if asked['kind'] == 'right' else 60)\n{RIGHT}"), timeout=2) as workbench:
    assert workbench.ask("right") == {"number": 1}
    try:
        raise AssertionError(workbench.ask("slow"))
    except TimeoutError as late:
        assert str(late) == "there was no answer within 2 seconds"
    assert workbench.ask("right") == {"number": 1}

# A program that complains at length before it reads is not waited for by a client that writes at length.
loud = f"if number == 1: sys.stderr.write('x' * (4 << 20))\nassert len(line) > 1 << 20\n{RIGHT}"
with Workbench(program(loud)) as workbench:
    assert workbench.ask("long", text="y" * (4 << 20)) == {"number": 1}
