"""The ends of processes: close, death between questions, forks."""

import os
import time

from zonobench import Workbench


def value(workbench, expected):
    return workbench.ask("support", direction=[1, 0], center=[expected, 0], generators=[])["value"]


workbench = Workbench()
process = workbench._process
assert value(workbench, 1) == 1

# A process that died in the meantime is replaced.
process.popen.kill()
process.popen.wait()
assert value(workbench, 2) == 2
assert workbench._process is not process

# A fork has a process of its own, and the parent's goes on, and ends, as if there were none.
process = workbench._process
ready, go = os.pipe()
child = os.fork()
if child == 0:
    status = 1
    try:
        os.close(go)
        found = [value(workbench, number) for number in range(50)]
        status = 0 if found == list(range(50)) and workbench._process is not process else 2
        os.read(ready, 1)
    finally:
        os._exit(status)
os.close(ready)
assert [value(workbench, 100 + number) for number in range(50)] == [100 + number for number in range(50)]
assert workbench._process is process
started = time.monotonic()
workbench.close()
assert time.monotonic() - started < 9, "the child holds no end of the pipe"
os.close(go)
assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0

for _ in range(2):
    try:
        raise AssertionError(value(workbench, 3))
    except ValueError as error:
        assert str(error) == "this workbench is closed"
    workbench.close()
assert process.popen.returncode == 0, "the end of its input ends it"
