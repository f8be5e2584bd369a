"""Four threads that ask one workbench: each gets the answers to its own questions."""

import threading

from zonobench import Refused, Workbench

wrong = []
asked = []


def ask(thread, workbench):
    for question in range(300):
        expected = 1000 * thread + question
        generators = [[0, 1]] * (1 + 50 * thread)
        found = workbench.ask("support", direction=[1, 0], center=[expected, 0], generators=generators)["value"]
        if found != expected:
            wrong.append((thread, question, found))
        try:
            workbench.ask(f"kind {thread}")
            wrong.append((thread, question, "answered"))
        except Refused as refused:
            if f"`kind {thread}`" not in str(refused):
                wrong.append((thread, question, str(refused)))
        asked.append(thread)


with Workbench() as workbench:
    process = workbench._process
    threads = [threading.Thread(target=ask, args=(thread, workbench)) for thread in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert workbench._process is process, "one process has answered all of them"
assert not wrong, wrong[:5]
assert sorted(set(asked)) == [0, 1, 2, 3] and len(asked) == 1200
