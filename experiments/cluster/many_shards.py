"""Made-up shards of the full profile, to see how long `merge` takes over many of them.

    cargo build --release
    cargo build --release -p experiments --example cases_of_a_run
    python3 experiments/cluster/many_shards.py target/release [SHARDS [EXPERIMENT]]

The experiment (`hull-scaling`, if none is named; `all`: every one) is run in the quick profile, and each case of the
full profile gets the record of a case of the same family and variant, or of any where there is none: what `merge`
writes is as long as after a real run, and says nothing. The work that the shards name is that of the program, which
begins one of them and is stopped.
"""

from __future__ import annotations

import hashlib
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

binaries = Path(sys.argv[1])
count = int(sys.argv[2]) if len(sys.argv) > 2 else 10_000
experiment = sys.argv[3] if len(sys.argv) > 3 else "hull-scaling"
zonobench = str(binaries / "zonobench")


def quick_lines(folder: Path) -> list[dict[str, dict[str, object]]]:
    """The lines of a quick run as the one shard of it."""
    only = [] if experiment == "all" else ["--only", experiment]
    subprocess.run([zonobench, "reproduce", *only, "--shard", "0/1", "--out", folder], check=True)
    (file,) = folder.glob("*.shard")
    return [json.loads(line) for line in file.read_text().splitlines()[1:]]


def heading(folder: Path) -> dict[str, object]:
    """The first line of a shard of the full profile, as the program begins it."""
    begun = subprocess.Popen([zonobench, "reproduce", "--profile", "full", "--shard", f"0/{count}", "--out", folder])
    while not (found := [*folder.rglob("work.json")]):
        time.sleep(0.01)
    begun.kill()
    begun.wait()
    return json.loads(found[0].read_text())


with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    first = heading(folder / "begun")
    outcomes: dict[object, dict[str, object]] = {}
    keys = {"case", "experiment", "family", "variant", "n", "instance", "instance_seed", "seed"}
    quick = quick_lines(folder / "quick")
    environment = next(line for line in quick if "environment" in line)
    a_time = next(line["time"] for line in quick if "time" in line)
    for row in (line["count"] for line in quick if "count" in line):
        outcome = {field: value for field, value in row.items() if field not in keys}
        outcomes[row["family"], row["variant"]] = outcomes[None] = outcome
    output = subprocess.run([binaries / "examples/cases_of_a_run", "full"], check=True, capture_output=True, text=True)
    lines: list[list[str]] = [[] for _ in range(count)]
    for at, case in enumerate(map(json.loads, output.stdout.splitlines())):
        repetitions = case.pop("repetitions")
        found = outcomes.get((case["family"], case["variant"]), outcomes[None])
        lines[at % count].append(json.dumps({"count": {**case, **found}}))
        for repetition in range(repetitions):
            time_of = {**a_time, **case, "repetition": repetition}
            lines[at % count].append(json.dumps({"time": time_of}))
    shards = folder / "shards"
    shards.mkdir()
    total = 0
    for index, own in enumerate(lines):
        text = "".join(line + "\n" for line in [json.dumps(environment), *own])
        digest = hashlib.sha256(text.encode()).hexdigest()
        top = {**first, "index": index, "count": count, "lines": len(own) + 1, "sha256": digest}
        (shards / f"reproduce.{index}-of-{count}.shard").write_text(json.dumps(top) + "\n" + text)
        total += len(own) + 1
    print(f"{count} shards with {total} lines", flush=True)
    began = time.monotonic()
    merged = subprocess.run([zonobench, "merge", shards, "--out", folder / "merged"])
    print(f"merged in {time.monotonic() - began:.1f} s, code {merged.returncode}")
