#!/usr/bin/env bash
# Builds the wheel, installs it into a fresh environment and runs the tests of the package. Needs Rust and Python.
set -euo pipefail
cd "$(dirname "$0")"
work=${1:-$(mktemp -d)}
python3 -m venv "$work/environment"
pip=("$work/environment/bin/python" -m pip --disable-pip-version-check)
"${pip[@]}" install --quiet maturin
"$work/environment/bin/maturin" build --release --quiet --interpreter "$work/environment/bin/python" --out "$work/wheel"
ls -l "$work/wheel"
"${pip[@]}" install --quiet "$work"/wheel/zonotope-*.whl matplotlib mypy nbclient nbformat ipykernel pytest scipy
# The tests are run beside the installed package, not on its sources.
cp -r tests tour.ipynb pyproject.toml "$work"
cd "$work"
export MPLBACKEND=Agg GOLDENS=$OLDPWD/../../tests/goldens
environment/bin/python -m pytest --quiet tests
environment/bin/python -m pytest --quiet --doctest-modules --pyargs zonotope
environment/bin/python -m mypy --strict tests
