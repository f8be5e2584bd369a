r"""The score of a library's tests: how many small faults, each put in alone, make one of them fail.

    python3 tests/mutants/run.py verifier
    python3 tests/mutants/run.py zonotope --only numeric --only collision/proof --tests numeric:: --tests collision:: \
        --sample 300

A library's tests are its own and those of TESTS_BESIDE. It needs Rust and a C compiler. All faults are built at once,
each behind a switch that is read when a test runs, so a library takes minutes to hours and not days. Each test is run
once without a fault and tells which switches it passes; a fault is then tried on those tests alone that pass its
switch, the quickest first, until one fails or does not end, as many faults at a time as there are cores. The list of
what no test noticed is target/mutants/LIBRARY/noticed_by_none; every line of it is a test that is missing, or says the
same as the right program. Those of the second kind stand in equivalent/LIBRARY-*.tsv, each with its reason, and do not
count: file, function, fault, the line from the fault on, reason. A run that is broken off goes on where it was; --anew
begins again.
"""

from __future__ import annotations

import argparse
import collections
import concurrent.futures
import json
import os
import random
import re
import shutil
import subprocess
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

SWITCHES = """
#[doc(hidden)]
pub mod mutants {
    use std::io::Write;
    use std::sync::OnceLock;
    use std::sync::atomic::{AtomicBool, Ordering};
    static ON: OnceLock<u32> = OnceLock::new();
    static PASSED: OnceLock<Option<String>> = OnceLock::new();
    static SEEN: [AtomicBool; 1 << 17] = [const { AtomicBool::new(false) }; 1 << 17];
    #[inline]
    pub fn on(number: u32) -> bool {
        let on = *ON.get_or_init(|| std::env::var("MUTANT").ok().and_then(|n| n.parse().ok()).unwrap_or(0));
        if on == 0 {
            if let Some(file) = PASSED.get_or_init(|| std::env::var("MUTANTS_PASSED").ok()) {
                if !SEEN[number as usize].swap(true, Ordering::Relaxed) {
                    let opened = std::fs::OpenOptions::new().append(true).create(true).open(file);
                    let _ = opened.and_then(|mut file| file.write_all(format!("{number}\\n").as_bytes()));
                }
            }
        }
        on == number
    }
}
"""

TESTS_BESIDE = {"verifier": ["planted_errors"]}
"""The programs of tests/tests that hold a library beside its own tests: they ask it about changed answers."""

LONGEST_TEST = 120.0
"""Seconds of a test that is used: one that takes longer is left out, and said so."""


def output(*words: str | Path, cwd: Path = ROOT, may_fail: bool = False) -> str:
    """What a program writes, both ways; it ends well, or this program ends."""
    done = subprocess.run(words, cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode and not may_fail:
        raise SystemExit(f"{' '.join(map(str, words))}\n{done.stdout}")
    return done.stdout


class Library:
    """A copy of a library whose sources have all faults."""

    def __init__(self, name: str, only: list[str], filters: list[str]) -> None:
        self.work = ROOT / "target" / "mutants" / name
        self.tree = self.work / "tree"
        self.folder = self.tree / "workbench" / name
        self.package = f"zonotope-{name}" if name == "verifier" else name
        self.only, self.filters = only, filters
        # A program of tests and the folder in which it runs.
        self.programs = {"lib": self.folder, **{beside: self.tree / "tests" for beside in TESTS_BESIDE.get(name, [])}}

    def files(self) -> list[str]:
        """The files that get faults: no tests, and not the root."""
        of_tests = re.compile(r"(^|/)tests(/|\.rs$)")
        declared = re.compile(r"#\[cfg\(test\)\]\s*(?:pub(?:\([a-z]+\))? )?mod (\w+);")
        paths = {str(path.relative_to(self.folder)) for path in self.folder.glob("src/**/*.rs")}
        for path in sorted(paths):
            for module in declared.findall((self.folder / path).read_text()):
                paths.discard(str(Path(path).parent / f"{module}.rs"))
        wanted = [path for path in paths if not of_tests.search(path) and path != "src/lib.rs"]
        return sorted(path for path in wanted if not self.only or any(path.startswith(f"src/{o}") for o in self.only))

    def build(self) -> None:
        """Puts the faults in, leaves those out that do not compile, and builds the tests."""
        shutil.rmtree(self.work, ignore_errors=True)
        self.work.mkdir(parents=True)
        output("git", "clone", "-q", "--no-hardlinks", ROOT, self.tree)
        output("cargo", "build", "--release", "--manifest-path", ROOT / "tests/mutants/Cargo.toml")
        rewrite = ROOT / "tests/mutants/target/release/mutants"
        root = self.folder / "src/lib.rs"
        root.write_text("#![allow(warnings)]\n#![allow(clippy::all)]\n" + root.read_text() + SWITCHES)
        files, skipped = self.files(), self.work / "skipped"
        while True:
            output("git", "checkout", "-q", "HEAD", "--", *files, cwd=self.folder)
            output(rewrite, skipped, self.work / "list", *files, cwd=self.folder)
            check = ("cargo", "check", "-p", self.package, "--message-format", "short")
            told = output(*check, cwd=self.tree, may_fail=True)
            places = re.findall(r"^(\S+\.rs):(\d+):\d+: error", told, re.MULTILINE)
            found = {number for file, line in places for number in self.near(file, int(line))}
            if not places:
                break
            if not found:
                raise SystemExit(told)
            skipped.write_text(" ".join([*(skipped.read_text().split() if skipped.exists() else []), *found]))
        for program in self.programs:
            which = ("-p", self.package, "--lib") if program == "lib" else ("-p", "tests", "--test", program)
            told = output("cargo", "test", *which, "--no-run", cwd=self.tree)
            shutil.copy(self.tree / re.findall(r"Executable .* \((.*)\)", told)[0], self.work / program)

    def near(self, file: str, line: int) -> list[str]:
        """The switches of a line that does not compile, or the last ones above it."""
        lines = (self.tree / file).read_text().splitlines()
        for text in reversed(lines[max(0, line - 9) : line]):
            if found := re.findall(r"mutants::on\((\d+)u32\)", text):
                return found
        return []

    def places(self, faults: list[list[str]]) -> dict[str, tuple[str, ...]]:
        """What a fault is called in a list of equivalent ones, by number: it does not name lines, which move."""
        texts: dict[str, list[str]] = {}
        found = {}
        for number, place, function, change in faults:
            path, line, column = place.split(":")
            if path not in texts:
                texts[path] = output("git", "show", f"HEAD:./{path}", cwd=self.folder).splitlines()
            # A guard has no place of its own.
            rest = "" if (line, column) == ("1", "1") else texts[path][int(line) - 1][int(column) - 1 :].rstrip()
            found[number] = (path.removeprefix("src/"), function, change, rest)
        return found

    def run(self, program: str, tests: list[str], seconds: float, **environment: str) -> bool | None:
        """Whether all the tests of a program pass; None if they do not end."""
        words = [self.work / program, "--exact", "--test-threads=1", *tests]
        variables = {**os.environ, "PROPTEST_RNG_SEED": "1", **environment}
        folder = self.programs[program]
        try:
            done = subprocess.run(words, cwd=folder, env=variables, capture_output=True, timeout=seconds)
        except subprocess.TimeoutExpired:
            return None
        return done.returncode == 0

    def passed(self) -> dict[str, dict[str, tuple[float, list[int]]]]:
        """By program, the seconds of every test and the switches that it passes."""
        kept = self.work / "passed.json"
        if kept.exists():
            return json.loads(kept.read_text())
        found: dict[str, dict[str, tuple[float, list[int]]]] = {program: {} for program in self.programs}
        for program, folder in self.programs.items():
            listed = output(self.work / program, "--list", *self.filters, cwd=folder).splitlines()
            for test in (line.removesuffix(": test") for line in listed if line.endswith(": test")):
                seen = self.work / "seen"
                seen.unlink(missing_ok=True)
                began = time.monotonic()
                if (well := self.run(program, [test], LONGEST_TEST, MUTANTS_PASSED=str(seen))) is not True:
                    print(f"left out, as it {'takes too long' if well is None else 'fails without a fault'}: {test}")
                    continue
                numbers = sorted(set(map(int, seen.read_text().split()))) if seen.exists() else []
                found[program][test] = (time.monotonic() - began, numbers)
        kept.write_text(json.dumps(found))
        return found


def verdict(library: Library, number: int, tests: dict[str, list[tuple[float, str]]]) -> str:
    """What the tests of each program that pass a fault's switch make of it."""
    if not any(tests.values()):
        return "not reached"
    for program, own in tests.items():
        own.sort()
        for begin in range(0, len(own), 4):
            group = own[begin : begin + 4]
            limit = 15 + 20 * sum(seconds for seconds, _ in group)
            well = library.run(program, [test for _, test in group], limit, MUTANT=str(number))
            if well is not True:
                return "no end" if well is None else "noticed"
    return "not noticed"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("name", choices=["verifier", "zonotope", "batch"], metavar="LIBRARY")
    parser.add_argument("--only", action="append", default=[], metavar="FOLDER", help="files below src/FOLDER alone")
    parser.add_argument("--tests", action="append", default=[], metavar="PART", help="tests with this in their names")
    parser.add_argument("--sample", type=int, metavar="N", help="so many faults, by chance, always the same ones")
    parser.add_argument("--anew", action="store_true", help="begin again")
    options = parser.parse_args()
    library = Library(options.name, options.only, options.tests)
    # Faults of other files, or verdicts of other tests, are another run.
    asked, now = library.work / "asked", json.dumps([options.only, options.tests])
    if options.anew or not asked.exists() or asked.read_text() != now:
        library.build()
        asked.write_text(now)
    passed = library.passed()
    tests: dict[int, dict[str, list[tuple[float, str]]]] = collections.defaultdict(dict)
    for program, own in passed.items():
        for test, (seconds, numbers) in own.items():
            for number in numbers:
                tests[number].setdefault(program, []).append((seconds, test))
    faults = [line.split("\t") for line in (library.work / "list").read_text().splitlines()]
    if options.sample is not None and options.sample < len(faults):
        faults = sorted(random.Random(2003).sample(faults, options.sample), key=lambda fault: int(fault[0]))
    kept = library.work / "verdicts"
    known = dict(line.split("\t") for line in kept.read_text().splitlines()) if kept.exists() else {}
    left = [fault[0] for fault in faults if fault[0] not in known]
    with kept.open("a") as record, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as cores:
        verdicts = cores.map(lambda number: verdict(library, int(number), tests[int(number)]), left)
        for number, told in zip(left, verdicts, strict=True):
            known[number] = told
            print(number, told, sep="\t", file=record, flush=True)
    listed = {
        tuple(line.split("\t")[:4])
        for path in sorted(Path(__file__).parent.glob(f"equivalent/{options.name}-*.tsv"))
        for line in path.read_text().splitlines()
    }
    places = library.places(faults)
    for number, place in places.items():
        if place in listed and known[number] in ("not noticed", "not reached"):
            known[number] = "equivalent"
        elif place in listed:
            print("listed as equivalent, and", known[number], "all the same:", *place)
    if options.sample is None and not options.only:
        for place in sorted(listed - set(places.values())):
            print("listed as equivalent, and no fault:", *place)
    table: dict[str, collections.Counter[str]] = collections.defaultdict(collections.Counter)
    for number, place, *_ in faults:
        folder = str(Path(place.split(":")[0]).parent).removeprefix("src")
        table[folder.lstrip("/") or "src"][known[number]] += 1
        table["all"][known[number]] += 1
    names = ("noticed", "no end", "not noticed", "not reached", "equivalent")
    print(f"| folder | faults | {' | '.join(names)} | score |\n|---|---|{'---|' * len(names)}---|")
    for folder, counts in sorted(table.items(), key=lambda row: (row[0] == "all", row[0])):
        columns = [counts[name] for name in names]
        score = 100 * (columns[0] + columns[1]) / max(sum(columns[:4]), 1)
        print(f"| {folder} | {sum(columns)} | {' | '.join(map(str, columns))} | {score:.0f} % |")
    missed = [fault for fault in faults if known[fault[0]] in ("not noticed", "not reached")]
    (library.work / "noticed_by_none").write_text("".join("\t".join(fault) + "\n" for fault in missed))


if __name__ == "__main__":
    main()
