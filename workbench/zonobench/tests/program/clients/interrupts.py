"""Interrupts between question and answer, at any moment: no later question gets an earlier one's answer."""

import random
import signal

from zonobench import Workbench


def interrupt(*_):
    raise KeyboardInterrupt


def value(workbench, expected, generators):
    zeros = [[0, 1]] * generators
    return workbench.ask("support", direction=[1, 0], center=[expected, 0], generators=zeros)["value"]


signal.signal(signal.SIGALRM, interrupt)
moments = random.Random(2003)
interrupted = answered = 0
with Workbench() as workbench:
    for attempt in range(150):
        try:
            signal.setitimer(signal.ITIMER_REAL, moments.uniform(1e-5, 2e-2))
            for question in range(1_000_000):
                expected = 1000 * attempt + question
                assert value(workbench, expected, moments.choice([1, 3000])) == expected
                answered += 1
        except KeyboardInterrupt:
            interrupted += 1
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
    assert (interrupted, answered > 0) == (150, True), (interrupted, answered)

    # A question that is never answered is given up with its process, and the next one goes to another.
    assert value(workbench, 3, 1) == 3
    process = workbench._process
    process.popen.send_signal(signal.SIGSTOP)
    signal.setitimer(signal.ITIMER_REAL, 0.2)
    try:
        raise AssertionError(value(workbench, 4, 1))
    except KeyboardInterrupt:
        pass
    assert process.popen.returncode is not None, "the process that owes an answer has ended"
    assert value(workbench, 5, 1) == 5
    assert workbench._process is not process

    # The handler of a signal may ask as well: it has a process of its own.
    asked_within = []
    signal.signal(signal.SIGALRM, lambda *_: asked_within.append(value(workbench, 7, 1)))
    signal.setitimer(signal.ITIMER_REAL, 0.05)
    while not asked_within:
        assert value(workbench, 9, 3000) == 9
    assert asked_within == [7.0]
    assert value(workbench, 11, 1) == 11
