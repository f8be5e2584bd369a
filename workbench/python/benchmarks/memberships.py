"""Memberships of a million points: this package beside the library without Python, SciPy's linprog and ZonoOpt.

    cargo build --release -p experiments --example memberships
    python benchmarks/memberships.py target/release/examples/memberships [POINTS]

Every process has one body and the same points; the library's has them in a file. Times are those of the processor but
for the speed of two threads, which wants two processors that do nothing else. What is not installed has no row.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from typing import Any

import numpy as np

import zonotope

SIZES = (64, 4096)
"""Generators of the bodies."""

SINGLE = 20_000
"""Points that are asked about one by one."""


def instance(n: int, m: int) -> tuple[zonotope.Zonotope, np.ndarray[Any, Any]]:
    """A body of n generators, and m points, of which about half are inside."""
    random = np.random.default_rng(2003)
    body = zonotope.Zonotope.from_generators(random.normal(size=(n, 3)))
    directions = random.normal(size=(m, 3))
    return body, directions / body.gauge(directions)[:, None] * random.uniform(0.5, 1.5, size=(m, 1))


def of_the_package(n: int, m: int) -> dict[str, float]:
    """Nanoseconds a point: all at once by the processor and by the clock, one by one by the processor."""
    body, points = instance(n, m)
    body.contains(points[:1000])
    clock, processor = time.perf_counter(), time.process_time()
    body.contains(points)
    whole = (time.perf_counter() - clock, time.process_time() - processor)
    few = [points[i] for i in range(min(SINGLE, m))]
    processor = time.process_time()
    for point in few:
        body.contains(point)
    return {
        "clock": whole[0] / m * 1e9,
        "processor": whole[1] / m * 1e9,
        "single": (time.process_time() - processor) / len(few) * 1e9,
    }


def of_the_library(program: str, n: int, m: int) -> float:
    """Nanoseconds a point of the library's own loop, in one thread."""
    body, points = instance(n, m)
    with tempfile.NamedTemporaryFile() as file:
        file.write(np.concatenate([[n, m], body.generators.ravel(), points.ravel()]).astype("<f8").tobytes())
        file.flush()
        return float(subprocess.run([program, file.name], check=True, capture_output=True, text=True).stdout)


def of_linprog(n: int, m: int) -> float | None:
    """Nanoseconds a point of SciPy's linear program, on a few."""
    try:
        from scipy.optimize import linprog
    except ImportError:
        return None
    body, points = instance(n, m)
    began = time.process_time()
    for point in points[:20]:
        linprog(np.zeros(n), A_eq=body.G, b_eq=point - body.c, bounds=(-1, 1), method="highs")
    return (time.process_time() - began) / 20 * 1e9


def of_zonoopt(n: int, m: int) -> float | None:
    """Nanoseconds a point of ZonoOpt, on a few."""
    try:
        import zonoopt
        from scipy.sparse import csc_matrix
    except ImportError:
        return None
    body, points = instance(n, m)
    other = zonoopt.Zono(csc_matrix(body.G), body.c)
    began = time.process_time()
    for point in points[:20]:
        other.contains_point(point)
    return (time.process_time() - began) / 20 * 1e9


def in_a_process(threads: int, n: int, m: int) -> dict[str, float]:
    """The package's times in a process of its own with so many threads."""
    environment = {**os.environ, "RAYON_NUM_THREADS": str(threads)}
    words = [sys.executable, __file__, "--child", str(n), str(m)]
    output = subprocess.run(words, env=environment, check=True, capture_output=True, text=True).stdout
    found: dict[str, float] = json.loads(output)
    return found


def main(program: str, m: int) -> None:
    print(f"{m} points; nanoseconds a point")
    print("| generators | library, 1 thread | package, 1 thread | ratio | 2 threads, clock | speedup | one question more |"
          " linprog | ZonoOpt |")
    print("|---|---|---|---|---|---|---|---|---|")
    for n in SIZES:
        library = of_the_library(program, n, m)
        one, two = in_a_process(1, n, m), in_a_process(2, n, m)
        others = [of_linprog(n, m), of_zonoopt(n, m)]
        row = [
            str(n),
            f"{library:.0f}",
            f"{one['processor']:.0f}",
            f"{one['processor'] / library:.2f}",
            f"{two['clock']:.0f}",
            f"{one['clock'] / two['clock']:.2f}",
            f"{one['single'] - library:.0f}",
            *("–" if other is None else f"{other:.0f}" for other in others),
        ]
        print(f"| {' | '.join(row)} |", flush=True)


if __name__ == "__main__":
    if sys.argv[1] == "--child":
        print(json.dumps(of_the_package(int(sys.argv[2]), int(sys.argv[3]))))
    else:
        main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000)
